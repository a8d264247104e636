/* Behind the water's surface: what is seen straight or through a pane, and the sky or the open water behind that. */
#define SCREEN_DEPTH 0.9999998 /* behind all that is drawn, where depth is tested */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/view.glsl"
#include "render/waves.glsl"
#include "render/line.glsl"
#include "optics/refraction.glsl"
#include "render/sky.glsl"
#include "render/shafts_read.glsl"
uniform sampler2D direct_color, direct_depth, through_color, through_depth;
uniform float tile_floor; /* m, y of the floor */
uniform int beside;       /* 1: what others have drawn stays but behind the pane */
out vec4 color;

vec3 sky_behind(vec4 solid, vec3 ray)
{
    return solid.rgb + (1.0 - solid.a) * (sky_radiance(ray, 0.0) + sky_sun(ray, 0.0));
}

/* True where a sight meets the pane of the tank before anything else. */
bool meets_pane(vec3 ray, float way, out vec3 there)
{
    float to_pane = view_plane(ray);
    there = eye + ray * to_pane;
    vec2 aside = abs(there.xz - plane.xz * dot(there.xz, plane.xz));
    bool between = there.y > tile_floor && there.y < waves_height(there.xz, 0.0) - 0.003;
    return to_pane < way && max(aside.x, aside.y) < waves_extent && between;
}

/* The tank through its pane, and through the one on its other side what is behind that. */
vec3 behind_pane(vec3 ray, vec3 there, vec3 behind)
{
    vec3 bent = view_bent(ray), back = reflect(ray, plane.xyz);
    vec4 found = texture(through_color, target);
    float depth = texture(through_depth, target).r, to_other_side = 2.0 * waves_extent / -dot(plane.xyz, bent);
    float way = depth < 1.0 ? max(view_way(depth, ray) - length(there - eye), 0.0) : to_other_side;
    float share = optics_fresnel_reflectance(-dot(plane.xyz, ray), ior); /* the same at both panes */
    vec3 inside = found.rgb + (1.0 - found.a) * (1.0 - share) * ior * ior * behind;
    inside = shafts_sight(inside, there, bent, way, target);
    return share * sky_radiance(back, 0.0) + (1.0 - share) / (ior * ior) * inside;
}

void main()
{
    if (line_side(target) != side && pane == 0)
        discard;
    vec3 ray = view_ray(target), there;
    vec4 solid = texture(direct_color, target);
    float depth = texture(direct_depth, target).r, way = depth < 1.0 ? view_way(depth, ray) : planes.y;
    vec3 behind = min(sky_behind(solid, ray), vec3(SKY_MOST));
    bool meets = pane != 0 && meets_pane(ray, way, there);
    if (beside != 0 && !meets)
        discard;
    if (meets)
        color = vec4(behind_pane(ray, there, behind), 1.0);
    else if (side > 0.0 || pane != 0)
        color = vec4(behind, 1.0);
    else
        color = vec4(shafts_sight(solid.rgb, eye, ray, way, target), 1.0);
}
#endif
