/* Collard & Mundi 2022, section 3.5, as their program clamps it: sand, brightened by caustics, dimmed by depth,
 * tinted by the water. */
uniform float size, depth; /* m */

#ifdef VERTEX
uniform mat4 view_projection;
out vec2 place; /* 0 to 1 across the tile, along x and z */

void main()
{
    const vec2 corners[6] = vec2[6](vec2(0, 0), vec2(0, 1), vec2(1, 0), vec2(1, 0), vec2(0, 1), vec2(1, 1));
    place = corners[gl_VertexID];
    vec2 xz = (place - 0.5) * size;
    gl_Position = view_projection * vec4(xz.x, -depth, xz.y, 1.0);
}
#endif

#ifdef FRAGMENT
#include "light/map.glsl"
uniform sampler2D sand;
uniform float sand_share, attenuation, brightest, floor_tint;
uniform vec3 water_color;
in vec2 place;
out vec4 color;

void main()
{
    vec3 base = texture(sand, place).rgb;
    vec3 lit = min(base * (sand_share + light_at(place)) * attenuation, base * brightest);
    color = vec4(clamp(lit + floor_tint * water_color, 0.0, 1.0), 1.0);
}
#endif
