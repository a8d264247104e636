/* The water's surface: what it throws back and what it lets through. Seen from ABOVE, with or without anything above it
 * that is MIRRORED; otherwise from below, by an eye in the water or through a PANE.
 *
 * The layers THROUGH and MIRROR hold both as flat water would show them. A wave's own ray meets what stands there at
 * another place, which is found by going on along the ray to the depth that the layer says, and looking there again. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/view.glsl"
#include "render/waves.glsl"
#include "render/line.glsl"
#include "optics/refraction.glsl"
#include "render/sky.glsl"
#include "render/shadow.glsl"
#include "render/shafts_read.glsl"
uniform sampler2D direct_depth, through_color, through_depth, mirror_color, mirror_depth;
uniform int look_ups;         /* times that a layer is asked where a ray goes */
uniform vec3 dry_low, dry_high; /* m, of the box around what stands out of the water */
uniform float tile_floor;     /* m, y of the floor */
uniform vec3 floor_radiance;  /* of the floor where it is not in the picture */
uniform sampler2D mesh_depth; /* at which a pixel shows the surface (sea_mesh.glsl); 1: nowhere */
vec3 position;                /* on the surface */
out vec4 color;

const float HORIZON = 0.9999985; /* depth: what is farther has that of sea_mesh.glsl */
const float DEPTHS_EXACT = 100.0; /* m: beyond, they tell the floor from the surface no more */

/* The water's slope that is seen at `position` and is at `xz`, which differ in an image: the mean, and the variance of
 * what is finer than the pixel. Between the texels of the finest level slopes change evenly, and a smaller pixel sees
 * only its part of that. */
vec3 slope_here(vec2 xz)
{
    vec4 texel = texture(waves_texels, waves_place(xz));
    vec2 texels = fwidth(position.xz) / waves_spacing;
    float finer = max(texel.w - dot(texel.yz, texel.yz), 0.0) * min(max(texels.x, texels.y), 1.0);
    return vec3(mix(texel.yz, -texel.yz, notEqual(xz, position.xz)), finer + waves_roughness);
}

/* m along a ray from the surface to where bounded water ends: at a tank's pane, as its images go on at its sides;
 * elsewhere about as far. */
float to_edge(vec3 ray)
{
#ifdef PANE
    float along = dot(plane.xyz, ray);
    return max(waves_extent - sign(along) * dot(plane.xyz, position), 0.0) / max(abs(along), 1e-4);
#else
    return waves_extent > 0.0 ? waves_extent / max(length(ray.xz), 1e-3) : planes.y;
#endif
}

/* What a ray from the surface meets, by a layer: radiance and coverage, and how far off it is. */
vec4 layer_color(sampler2D colors, sampler2D depths, int layer, vec3 ray, out float way)
{
    vec2 place = target, texels = vec2(textureSize(depths, 0));
    for (int i = 0;; i++) {
        /* a depth holds for the middle of its texel: far off it is another one at the texel's edge */
        ivec2 texel = ivec2(min(place * texels, texels - 1.0));
        float depth = texelFetch(depths, texel, 0).r;
        vec3 sight = view_ray((vec2(texel) + 0.5) / texels), shown = view_point(sight, depth, layer);
        float before = view_plane(sight);
        bool far_floor = layer == LAYER_THROUGH && side > 0.0 && before > DEPTHS_EXACT;
        float level = far_floor ? tile_floor : shown.y;
        way = depth < 1.0 ? clamp((level - position.y) / ray.y, 0.0, planes.y) : planes.y;
#ifdef PANE
        way = min(way, to_edge(ray));
#endif
        if (i == look_ups + (layer == LAYER_MIRROR ? 1 : 0))
            return texture(colors, place);
        float share = clamp(before / (before + distance(shown, position)), 0.0, 1.0);
        vec2 next = view_place(view_apparent(position + ray * way, layer, share));
        /* what leaves the picture comes in again, mirrored: that has no edge */
        place = next == vec2(-1.0) ? place : clamp(1.0 - abs(1.0 - abs(next)), 0.0, 1.0);
    }
}

/* True where a ray from the surface comes through the box around all that stands out of the water. */
bool meets_dry(vec3 ray)
{
    vec3 to_low = (dry_low - position) / ray, to_high = (dry_high - position) / ray;
    vec3 enters = min(to_low, to_high), leaves = max(to_low, to_high);
    float last = min(min(leaves.x, leaves.y), leaves.z);
    return last > 0.0 && last > max(max(enters.x, enters.y), enters.z);
}

/* The normal that a rough surface seems to have, where a pixel holds many slopes: those that face the eye are seen
 * larger. Of a normal distribution of cosines with mean c and deviation s their seen mean, E[c²] / E[c], is 1.25 s at c
 * = 0 and c + s² / c for large c; sqrt(c² + 1.57 s²) has the first and is near the second. */
vec3 seen_normal(vec3 normal, vec3 to_eye, float roughness)
{
    float cosine = dot(normal, to_eye), seen = sqrt(cosine * cosine + 1.57 * roughness * roughness);
    return normalize(normal + (seen - cosine) * to_eye);
}

/* Radiance of the sun's light that a rough surface throws back (Ross, Dion & Potvin 2005): the share of slopes that
 * face it. */
vec3 glint(vec3 to_eye, vec2 slopes, float variance)
{
    vec3 middle = normalize(to_eye + to_sun);
    vec2 off = -middle.xz / middle.y - slopes;
    float spread = 0.5 * variance + 0.25 * sun_spread * sun_spread; /* of each slope */
    float density = exp(-0.5 * dot(off, off) / spread) / (2.0 * SKY_PI * spread);
    float square = middle.y * middle.y;
    float share = optics_fresnel_reflectance(max(dot(middle, to_eye), 0.0), ior);
    return sun_irradiance * share * density / (4.0 * square * square * max(to_eye.y, 0.05));
}

/* What a ray that goes down from the surface sees: by its coverage what a layer has `way` metres along it; for the rest
 * the floor, or where the water ends before it, what is behind a pane, or as much as the floor. */
vec3 seen_below(vec4 found, vec3 ray, float way)
{
    float to_floor = (tile_floor - position.y) / min(ray.y, -1e-3), end = min(to_floor, to_edge(ray));
    vec3 behind = pane != 0 && end < to_floor ? ior * ior * sky_radiance(ray, 0.0) : floor_radiance;
    way = way < planes.y ? mix(end, way, found.a) : end; /* what is next to nothing is as far as what that stands for */
    return (found.rgb + (1.0 - found.a) * behind) * exp(-extinction * way) + volume_glow(0.0, ray, way);
}

#ifdef ABOVE
vec3 thrown_and_let(vec3 to_eye, vec3 normal, vec3 slope)
{
    float roughness = sqrt(0.5 * slope.z), way;
    vec3 into = optics_refract(to_eye, normal, ior), seen = seen_normal(normal, to_eye, roughness);
    vec3 back = optics_reflect(to_eye, seen);
    back = normalize(vec3(back.x, abs(back.y) + 1e-3, back.z));
    float share = optics_fresnel_reflectance(clamp(dot(to_eye, seen), 0.0, 1.0), ior);
    vec4 mirrored = vec4(0.0);
#ifdef MIRRORED
    if (meets_dry(back))
        mirrored = layer_color(mirror_color, mirror_depth, LAYER_MIRROR, back, way);
#endif
    vec3 thrown = mirrored.rgb + (1.0 - mirrored.a) * sky_radiance(back, 2.0 * roughness);
    vec4 below = layer_color(through_color, through_depth, LAYER_THROUGH, into, way);
    vec3 let = seen_below(below, into, way);
    vec3 sparkle = glint(to_eye, slope.xy, slope.z);
    if (max(max(sparkle.r, sparkle.g), sparkle.b) > 1e-4)
        sparkle *= shadow_light(position, vec3(0.0), to_sun, true);
    return share * thrown + (1.0 - share) / (ior * ior) * let + sparkle;
}
#else
vec3 thrown_and_let(vec3 to_eye, vec3 normal, vec3 slope)
{
    float roughness = sqrt(0.5 * slope.z), way;
    vec3 back = optics_reflect(to_eye, -normal), out_of;
    bool leaves = optics_refract_out(-to_eye, normal, ior, out_of);
    float share = leaves ? optics_fresnel_reflectance(max(dot(out_of, normal), 0.0), ior) : 1.0;
    back.y = -abs(back.y);
    vec4 mirrored = layer_color(mirror_color, mirror_depth, LAYER_MIRROR, back, way);
    vec3 thrown = seen_below(mirrored, back, way);
#ifdef PANE
    vec4 above = vec4(0.0); /* the layer is that of the pane */
#else
    vec4 above = layer_color(through_color, through_depth, LAYER_THROUGH, out_of, way);
#endif
    float blur = 0.33 * roughness + 1e-4;
    vec3 let = above.rgb + (1.0 - above.a) * (sky_radiance(out_of, blur) + sky_sun(out_of, blur));
    return share * thrown + (leaves ? (1.0 - share) * ior * ior * let : vec3(0.0));
}
#endif

/* Where a sight meets the surface that is seen at that depth. */
vec3 surface_at(vec3 ray, float depth)
{
    if (depth > HORIZON)
        return eye + ray * min(view_plane(ray), 4.0 * planes.y);
    return view_point(ray, depth, pane != 0 ? LAYER_THROUGH : LAYER_DIRECT);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(mesh_depth, pixel, 0).r;
    vec3 ray = view_ray(target);
    bool hidden = depth == 1.0 || (pane == 0 && texelFetch(direct_depth, pixel, 0).r < depth);
    position = surface_at(ray, depth);
    vec2 xz = pane != 0 ? view_fold(position.xz) : position.xz;
    vec3 slope = slope_here(xz);
    if (!waves_cover(xz) || hidden || line_side(target) != side)
        discard;
    gl_FragDepth = depth;
    vec3 origin = pane != 0 ? eye + ray * view_plane(ray) : eye; /* from where sight comes to the surface */
    vec3 sight = position - origin, to_eye = -normalize(sight);
    vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
    /* Waves that turn away from the eye are seen at a grazing angle at most. */
    float facing = side * dot(normal, to_eye);
    if (facing < 0.02)
        normal = normalize(normal + side * (0.02 - facing) * to_eye);
    float way = length(sight);
    vec3 radiance = thrown_and_let(to_eye, normal, slope);
#if !defined ABOVE && !defined PANE
    radiance = shafts_sight(radiance, eye, -to_eye, way, target);
#endif
    color = vec4(min(radiance, vec3(SKY_MOST)), 1.0);
}
#endif
