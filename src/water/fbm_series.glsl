/* Height and slopes of the Fourier series of fbm.c; `series` is (A in turns, S in turns/m², F, N). */
#define TURN 6.28318530718

vec3 fbm(vec4 series, vec2 xz)
{
    float phase = series.x, scale = series.y, amplitude = series.z;
    int terms = int(series.w);
    float sines = 0.0, cosines = 0.0, power = 1.0;
    for (int j = 1; j <= terms; j++) {
        power *= 2.0;
        float angle = TURN * fract(phase + power * scale * xz.x * xz.y);
        sines += sin(angle);
        cosines += cos(angle) / power;
    }
    float r = length(xz);
    float along = amplitude * TURN * scale * r * sines;
    float outwards = r > 0.0 ? amplitude * cosines / r : 0.0;
    return vec3(-amplitude * r * cosines, along * xz.yx - outwards * xz);
}
