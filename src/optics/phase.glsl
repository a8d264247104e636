/* The GPU's twin of phase.c, for red, green and blue. */

vec3 optics_phase(float cosine, vec3 anisotropy)
{
    vec3 g = anisotropy;
    vec3 square = max((1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 - cosine), 1e-8);
    return (1.0 - g * g) / (12.566370614 * square * sqrt(square));
}
