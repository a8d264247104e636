/* The GPU's half of photons.c: a point for each photon, which are added up by blending. */
#ifdef VERTEX
#include "light/tracing.glsl"
uniform vec3 disc_up, disc_across; /* from the sun's middle to its edge */
uniform int squares;               /* along a side of the surface; each sends `count` photons */
uniform int count, number;         /* which of them are sent now */
uniform int seed;
uniform int side, margin;          /* texels, of the map and around it */
uniform float width;               /* texels, of a photon */
uniform vec3 scale;                /* from a photon's flux to light on a texel */
flat out vec3 light;
flat out vec2 middle; /* in the target */

vec3 find_sun(vec2 numbers)
{
    float turn = 6.28318530718 * numbers.y;
    vec2 place = sqrt(numbers.x) * vec2(cos(turn), sin(turn));
    vec3 across = place.x * disc_up + place.y * disc_across;
    return sqrt(1.0 - dot(across, across)) * sun + across;
}

void main()
{
    int column = gl_VertexID % squares * count + number, row = gl_VertexID / squares;
    vec4 numbers = unit(mix_bits(uvec4(uint(column), uint(row), uint(seed), 0u)));
    water_point point = find_water(numbers.xy);
    ray_end ray = trace_ray(point.water, find_sun(numbers.zw));
    vec2 place = (point.place + point.shift + ray.moved) * texels_a_meter + flat_offset.xy;
    if (surface_periodic != 0)
        place -= floor(place / float(side)) * float(side);
    middle = place + float(margin);
    light = ray.flux * max(point.area, 0.0) * scale * optics_transmittance(absorption, ray.longer) * channels;
    gl_PointSize = width;
    vec2 corner = width < 2.0 ? floor(middle) + 0.5 : floor(middle + 0.5); /* of the texels that the photon lights */
    gl_Position = vec4(ray.flux > 0.0 ? corner / float(side + 2 * margin) * 2.0 - 1.0 : vec2(2.0), 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
uniform float width;
flat in vec3 light;
flat in vec2 middle;
out vec4 color;

void main()
{
    vec2 shares = width < 2.0 ? vec2(1.0) : max(1.0 - abs(gl_FragCoord.xy - middle), 0.0);
    color = vec4(light * shares.x * shares.y, 0.0);
}
#endif
