/* Shadows of solids. Light that comes to a point has passed the rest surface at some place, straight above the water
 * or along its refracted way below it; the map holds, for each such place, how high the highest solid stands on that
 * light's way (shadow_cast.glsl). So a shadow goes on through the surface without a step. A second map holds how low
 * the lowest solid stands in the way of what the water throws up at such a place. */
#include "render/volume.glsl"
uniform sampler2D shadow_heights; /* 0 at shadow_span.x + shadow_span.y, 1 at shadow_span.x */
uniform vec4 shadow_square;       /* m: the least x and z, and the sides, of the places */
uniform vec2 shadow_span;         /* m: the least height, and how far the highest is above it; 0: nothing casts */
uniform sampler2D shadow_thrown_heights; /* lowest solid in the way of what the water throws up: 0 at shadow_span.x */
uniform vec4 shadow_thrown_square;       /* as shadow_square */
uniform float shadow_disc;        /* m that the sun's disc widens a shadow by for each m of height, above the water */
uniform float shadow_waves;       /* the same by the slopes of the waves, below it */
uniform int shadow_taps;
uniform vec2 corner; /* pixels, of what is drawn in the whole picture */

const mat2 SHADOW_TURN = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688); /* by the golden angle */

/* Where light to a point passes the rest surface. */
vec2 shadow_crossing(vec3 point, vec3 to_sun)
{
    vec2 slant = point.y > 0.0 ? to_sun.xz / to_sun.y : sun_way.xz / sun_way.y;
    return point.xz - slant * point.y;
}

/* A number from 0 to 1 for each pixel (interleaved gradient noise, Jimenez 2014). */
float shadow_noise()
{
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy + corner, vec2(0.06711056, 0.00583715))));
}

float shadow_height(vec2 place)
{
    return shadow_span.x + shadow_span.y * (1.0 - textureLod(shadow_heights, place, 0.0).r);
}

/* The i-th of `count` points of a disc of radius 1, on a spiral of equal areas (Vogel 1979); turns `direction` on. */
vec2 shadow_spiral(inout vec2 direction, int i, int count)
{
    vec2 place = direction * sqrt((float(i) + 0.5) / float(count));
    direction = SHADOW_TURN * direction;
    return place;
}

/* How far around a place the light of a point is spread that something `above` m higher may stand in. */
float shadow_radius(vec3 point, float above)
{
    float wet = clamp(-point.y, 0.0, max(above, 0.0));
    return (above - wet) * shadow_disc + wet * shadow_waves;
}

/* How much higher the surface at a point is where light passes a metre beside its own, along x and z. */
vec2 shadow_rise(vec3 normal, vec2 slant)
{
    float facing = normal.y + dot(normal.xz, slant);
    return -normal.xz / max(facing, 0.15);
}

/* The share of the sun that a point sees; 1 where that is not `asked`. Points around its light's place ask first
 * how high what stands in the way is, then how much of the light it covers. */
float shadow_light(vec3 point, vec3 normal, vec3 to_sun, bool asked)
{
    float texel = max(shadow_square.z, shadow_square.w) / float(textureSize(shadow_heights, 0).x);
    float most = shadow_span.x + shadow_span.y - point.y;
    vec2 rise = shadow_rise(normal, point.y > 0.0 ? to_sun.xz / to_sun.y : sun_way.xz / sun_way.y);
    vec2 place = (shadow_crossing(point, to_sun) - shadow_square.xy) / shadow_square.zw;
    vec2 outside = abs(place - 0.5);
    bool inside = asked && shadow_span.y > 0.0 && most > 0.0 && max(outside.x, outside.y) < 0.5;
    /* a texel beside is no farther up along the light than it is steep */
    vec3 way = point.y > 0.0 ? to_sun : sun_way;
    float steep = min(abs(way.y) / max(length(way.xz), 1e-3), 1.0);
    float bias = point.y + texel * (steep + length(rise)), radius = max(shadow_radius(point, most), texel);
    float angle = 6.2831853 * shadow_noise(), covered = 0.0, heights = 0.0;
    vec2 first = vec2(cos(angle), sin(angle)), direction = first;
    int count = inside ? 4 : 0;
    for (int i = 0; i < count; i++) {
        vec2 away = radius * shadow_spiral(direction, i, 4);
        float height = shadow_height(place + away / shadow_square.zw);
        float hidden = step(bias + dot(rise, away), height);
        covered += hidden;
        heights += hidden * height;
    }
    count = covered > 0.0 ? shadow_taps : 0;
    radius = max(shadow_radius(point, heights / max(covered, 1.0) - point.y), texel);
    direction = first;
    covered = 0.0;
    for (int i = 0; i < count; i++) {
        vec2 away = radius * shadow_spiral(direction, i, shadow_taps);
        covered += step(bias + dot(rise, away), shadow_height(place + away / shadow_square.zw));
    }
    return 1.0 - covered / float(shadow_taps);
}

/* The share of the light that the water throws up at `origin` that comes to a point above it; 1 where that is not
 * `asked`. Waves throw it much further aside than they bend what they let through. */
float shadow_thrown(vec3 point, vec2 origin, bool asked)
{
    float texel = max(shadow_thrown_square.z, shadow_thrown_square.w) / float(textureSize(shadow_thrown_heights, 0).x);
    vec2 place = (origin - shadow_thrown_square.xy) / shadow_thrown_square.zw, outside = abs(place - 0.5);
    bool inside = asked && shadow_span.y > 0.0 && max(outside.x, outside.y) < 0.5;
    float radius = 1.5 * texel + 2.0 * shadow_waves * point.y, angle = 6.2831853 * shadow_noise(), covered = 0.0;
    float bias = point.y - 0.05 - 2.0 * texel; /* what is nearer below is the thing itself, or lies against it */
    vec2 direction = vec2(cos(angle), sin(angle));
    int count = inside ? shadow_taps : 0;
    for (int i = 0; i < count; i++) {
        vec2 away = radius * shadow_spiral(direction, i, shadow_taps);
        float height = textureLod(shadow_thrown_heights, place + away / shadow_thrown_square.zw, 0.0).r;
        covered += step(shadow_span.x + shadow_span.y * height, bias);
    }
    return 1.0 - covered / float(shadow_taps);
}
