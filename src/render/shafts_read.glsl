/* What light shafts add to a sight, from the picture of them (render/shafts.c). */
#include "render/volume.glsl"

uniform sampler2D shafts_texels; /* radiance, and the way in m to where it ends; smaller than the picture */
uniform int shafts;              /* 0: there are none */

/* From the four texels around a place, those whose sight ends near `way` count most. */
vec3 shafts_read(vec2 place, float way)
{
    if (shafts == 0)
        return vec3(0.0);
    ivec2 last = textureSize(shafts_texels, 0) - 1;
    vec2 texel = place * vec2(last + 1) - 0.5, inside = fract(texel);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; i++) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        vec4 found = texelFetch(shafts_texels, clamp(ivec2(floor(texel)) + corner, ivec2(0), last), 0);
        vec2 weights = mix(1.0 - inside, inside, vec2(corner));
        float weight = (weights.x * weights.y + 1e-3) / (1e-4 + 0.05 * way + abs(found.a - way));
        sum += weight * vec4(found.rgb, 1.0);
    }
    return sum.rgb / sum.a;
}

/* What is `way` metres off along `ray` from a place in the water, seen with the water's glow and its shafts; `place`:
 * of the picture. Where a shadow takes all of the glow, the steps of the one and the sum of the other leave a
 * little. */
vec3 shafts_sight(vec3 seen, vec3 start, vec3 ray, float way, vec2 place)
{
    vec3 glow = volume_glow(max(-start.y, 0.0), ray, way) + shafts_read(place, way);
    return seen * exp(-extinction * way) + max(glow, 0.0);
}
