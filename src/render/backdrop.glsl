/* Behind the water's surface: what is seen straight, and the sky or the open water behind that. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/view.glsl"
#include "render/sky.glsl"
#include "render/volume.glsl"
#include "render/shafts_read.glsl"
uniform sampler2D direct_color, direct_depth;
out vec4 color;

void main()
{
    vec3 ray = view_ray(target);
    vec4 solid = texture(direct_color, target);
    float depth = texture(direct_depth, target).r, way = depth < 1.0 ? view_way(depth, ray) : planes.y;
    if (side > 0.0) {
        color = vec4(solid.rgb + (1.0 - solid.a) * (sky_radiance(ray, 0.0) + sky_sun(ray, 0.0)), 1.0);
        return;
    }
    vec3 kept = exp(-extinction * way);
    color = vec4(solid.rgb * kept + volume_glow(eye, ray, way) + shafts_read(target, way), 1.0);
}
#endif
