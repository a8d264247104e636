/* The light on a solid's surface: with WET, in the water, with TANK, in an aquarium's; without, above it. */
#include "light/map.glsl"
#include "render/waves.glsl"
#include "render/shadow.glsl"
#include "render/sky.glsl"

uniform float tile_size, tile_depth; /* m */
uniform int caustics;                /* 0: the water's light is that of flat water everywhere */
uniform vec3 sun_reflected;          /* irradiance on a ceiling of what flat water throws back */
uniform sampler2DArray reflected_texels;
uniform vec3 reflected_window, reflected_step; /* as in light/map.glsl */
uniform float reflected_height;                /* m, of the last layer; 0: none, it is that of flat water */

/* A layer shows what is in the water, or what is not; both a little beyond the surface, coarse far off as its mesh
 * is. */
bool layer_leaves_out(vec3 point)
{
    float slack = 0.01 + 0.004 * distance(point, eye);
#ifdef WET
    return !waves_wet(point, slack);
#else
    return waves_wet(point, -slack);
#endif
}

#ifdef WET
/* The caustics at a point in the water, as irradiance in units of flat water's. ON_FLOOR: by the map of the floor
 * alone, along the light's way. */
vec3 receiver_caustics(vec3 point)
{
    vec2 slant = tile_depth * sun_way.xz / (-sun_way.y * tile_size), place = point.xz / tile_size + 0.5;
#ifdef ON_FLOOR
    vec3 light = light_at(place + slant * (1.0 + point.y / tile_depth));
#else
    vec3 light = light_at_height(place, 1.0 + point.y / tile_depth, slant);
    /* above the last layer it becomes that of flat water, which it is at the surface */
    float count = float(textureSize(light_texels, 0).z);
    light = mix(light, vec3(1.0), clamp(1.0 + count * point.y / tile_depth, 0.0, 1.0));
#endif
    return caustics != 0 ? light : vec3(1.0);
}

#ifdef TANK
uniform float glass;                     /* m, half a side of the tank */
uniform vec3 side_way_x, side_way_z;     /* unit vectors: the sun's light in it from the panes across x and z */
uniform vec3 side_light_x, side_light_z; /* irradiance across these */

/* Irradiance of the sun's light that comes to a point in a tank through the panes; no solid's shadow is in it. */
vec3 receiver_sides(vec3 point, vec3 normal)
{
    vec2 from_x = vec2((glass + point.x * sign(side_way_x.x)) / max(abs(side_way_x.x), 1e-4), -side_way_x.y);
    vec2 from_z = vec2((glass + point.z * sign(side_way_z.z)) / max(abs(side_way_z.z), 1e-4), -side_way_z.y);
    /* waves draw the edge of what comes in below the surface wide */
    vec2 start = point.y + vec2(from_x.x * from_x.y, from_z.x * from_z.y), wide = vec2(0.15 * tile_depth);
    vec2 below = 1.0 - smoothstep(-wide, wide, start);
    vec2 facing = max(-vec2(dot(normal, side_way_x), dot(normal, side_way_z)), 0.0) * below;
    return side_light_x * facing.x * exp(-extinction * from_x.x) +
           side_light_z * facing.y * exp(-extinction * from_z.x);
}
#endif

/* Radiance of a diffuse surface; `ambient` is its irradiance from all around, with what the water has scattered out of
 * the sun's beam. */
vec3 receiver_radiance(vec3 point, vec3 normal, vec3 reflectance, vec3 ambient)
{
    float depth = max(-point.y, 0.0), facing = max(dot(normal, -sun_way), 0.0);
    float lit = facing * shadow_light(point, normal, to_sun, facing > 0.0);
    vec3 sun = sun_below * volume_sun(depth) * lit * receiver_caustics(point);
#ifdef TANK
    vec2 from = abs(shadow_crossing(point, to_sun));
    sun = sun * step(max(from.x, from.y), glass) + receiver_sides(point, normal);
#endif
    return reflectance / SKY_PI * (sun + ambient);
}
#else
/* The caustics of light that the water throws up to a point above it, in units of what flat water throws back; between
 * layers along its way. */
vec3 receiver_reflected(vec3 point)
{
    float count = float(textureSize(reflected_texels, 0).z);
    float height = point.y / max(reflected_height, 1e-3) * count - 1.0;
    float layer = clamp(height, 0.0, count - 1.0), lower = floor(layer), upper = min(lower + 1.0, count - 1.0);
    vec2 place = (point.xz / tile_size + 0.5 - reflected_window.xy) / reflected_window.z;
    vec2 slant = -to_sun.xz / to_sun.y * reflected_height / (count * tile_size); /* from a layer to the next */
    vec2 step_in = (slant - reflected_step.xy) / reflected_window.z, along_x = dFdx(place), along_y = dFdy(place);
    place -= slant / reflected_window.z * height; /* where its light comes from at the first layer */
    vec2 below = place + step_in * lower, above = place + step_in * upper;
    vec3 light = mix(textureGrad(reflected_texels, vec3(below, lower), along_x, along_y).rgb,
                     textureGrad(reflected_texels, vec3(above, upper), along_x, along_y).rgb, layer - lower);
    light = mix(light, vec3(1.0), clamp(-height, 0.0, 1.0)); /* at the water it is that of flat water */
    return caustics != 0 && reflected_height > 0.0 ? light : vec3(1.0);
}

/* Irradiance from the sun on a surface in the air, straight and thrown back by the water. */
vec3 receiver_above(vec3 point, vec3 normal, float lit)
{
    vec3 up_way = vec3(-to_sun.x, to_sun.y, -to_sun.z), light = receiver_reflected(point);
    vec3 origin = point - up_way * (max(point.y, 0.0) / up_way.y); /* on the water */
    float facing = max(-dot(normal, up_way), 0.0) / up_way.y;
    bool thrown = facing > 0.0 && waves_cover(origin.xz);
    float shown = thrown ? shadow_light(origin + vec3(0.0, 1e-3, 0.0), vec3(0.0), to_sun, thrown) : 0.0;
    shown *= shadow_thrown(point, origin.xz, thrown);
    return sun_irradiance * lit * max(dot(normal, to_sun), 0.0) + sun_reflected * light * facing * shown;
}

vec3 receiver_radiance(vec3 point, vec3 normal, vec3 reflectance, vec3 ambient)
{
    float lit = shadow_light(point, normal, to_sun, dot(normal, to_sun) > 0.0);
    return reflectance / SKY_PI * (receiver_above(point, normal, lit) + ambient);
}
#endif
