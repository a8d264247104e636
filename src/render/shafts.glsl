/* Light shafts: how much more or less than under flat water the sun's light is along each sight, scattered to the
 * eye. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/view.glsl"
#include "render/shadow.glsl"
uniform sampler2DArray light_texels; /* as in light/map.glsl */
uniform int light_channels;
uniform vec3 light_window, light_step;
uniform float tile_size, tile_depth; /* m */
uniform sampler2D direct_depth, through_depth;
uniform vec3 to_sun;
uniform sampler2D noise; /* blue */
uniform int steps;
uniform vec2 shafts_corner; /* texels, of this picture in the whole */
uniform float pixel;     /* m that a texel of this picture is wide, for each m of way */
out vec4 color;

/* Share of what is scattered that goes too far aside to keep a shaft a shaft: 7° and more, where anisotropy is
 * 0.924. */
const float BLUR = 0.5;

/* The sun's light at a point in units of flat water's, by the nearest layer along its way; `width` m around. */
vec3 light_here(vec3 point, float width, float random)
{
    float count = float(textureSize(light_texels, 0).z), height = (1.0 + point.y / tile_depth) * count;
    float layer = max(floor(height + random), 0.0);
    if (layer >= count)
        return vec3(1.0); /* above the last layer, the more the nearer the surface is */
    vec2 slant = sun_way.xz / -sun_way.y * tile_depth / tile_size;
    vec2 place = point.xz / tile_size + 0.5 + slant * (height - layer) / count;
    place = (place - light_window.xy - layer * light_step.xy) / light_window.z;
    float texels = width * float(textureSize(light_texels, 0).x) / (light_window.z * tile_size);
    vec3 light = textureLod(light_texels, vec3(place, layer), max(log2(texels), 0.0)).rgb;
    return light_channels == 1 ? light.rrr : light;
}

bool solid_before_sun(vec3 point)
{
    vec2 place = (shadow_crossing(point, to_sun) - shadow_square.xy) / shadow_square.zw;
    bool inside = shadow_span.y > 0.0 && all(greaterThan(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
    return inside && shadow_height(place) > point.y;
}

void main()
{
    vec3 ray = view_ray(target), start = eye;
    float depth = textureLod(direct_depth, target, 0.0).r, end = depth < 1.0 ? view_way(depth, ray) : planes.y;
    if (pane != 0) {
        float to_pane = view_plane(ray);
        depth = textureLod(through_depth, target, 0.0).r;
        end = depth < 1.0 ? max(view_way(depth, ray) - to_pane, 0.0) : tile_size;
        start = eye + ray * to_pane;
        ray = view_bent(ray);
    }
    if (ray.y > 0.0)
        end = min(end, max(-start.y, 0.0) / ray.y);
    /* Where the water has taken all but a thousandth there is nothing to see. */
    vec3 fades = absorption + 0.05 * scattering;
    float reach = min(end, 7.0 / max(min(min(fades.r, fades.g), fades.b), 1e-3));
    vec2 random = texelFetch(noise, ivec2(gl_FragCoord.xy + shafts_corner) & 63, 0).rg;
    float cosine = dot(sun_way, -ray);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; i++) {
        /* steps as short near the eye as the texels are small there: way = reach x² */
        float x = (float(i) + random.x) / float(steps), way = reach * x * x, step_way = 2.0 * reach * x / float(steps);
        vec3 point = start + ray * way;
        point.xz = view_fold(point.xz);
        float width = max(way * pixel, 0.05 * step_way);
        float whole = way + max(-point.y, 0.0) / -sun_way.y;
        vec3 more = solid_before_sun(point)
                        ? vec3(-1.0)
                        : (light_here(point, width, random.y) - 1.0) * exp(-BLUR * scattering * whole);
        sum += more * volume_source(cosine, 1.0, whole) * step_way;
    }
    color = vec4(sun_below * sum, end);
}
#endif
