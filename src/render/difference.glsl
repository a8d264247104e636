/* The receiver alone, coloured by the difference of two caustic maps, mean of their channels. */
#ifdef VERTEX
uniform mat4 view_projection;
uniform float size, height; /* m, of the receiver */
out vec2 place;             /* 0 to 1 across the tile, along x and z */

void main()
{
    const vec2 corners[6] = vec2[6](vec2(0, 0), vec2(0, 1), vec2(1, 0), vec2(1, 0), vec2(0, 1), vec2(1, 1));
    place = corners[gl_VertexID];
    vec2 xz = (place - 0.5) * size;
    gl_Position = view_projection * vec4(xz.x, height, xz.y, 1.0);
}
#endif

#ifdef FRAGMENT
#include "light/map.glsl"
uniform sampler2DArray other_texels;
uniform int other_channels; /* 1 or 3 */
uniform sampler2D colors;   /* from -1 to 1 */
uniform float gain, range;
in vec2 place;
out vec4 color;

void main()
{
    vec2 there = (place - light_window.xy) / light_window.z;
    vec3 other = texture(other_texels, vec3(there, 0.0), -0.7).rgb; /* as light_at() */
    if (other_channels == 1)
        other = other.rrr;
    float difference = clamp(dot(light_at(place) * gain - other, vec3(1.0 / 3.0)) / range, -1.0, 1.0);
    float count = float(textureSize(colors, 0).x);
    color = vec4(texture(colors, vec2((0.5 + 0.5 * difference) * (1.0 - 1.0 / count) + 0.5 / count, 0.5)).rgb, 1.0);
}
#endif
