/* The GPU's half of multi_sample.c; the steps are numbered as there. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D normals;                 /* unit vectors, shorter in between: only the direction counts */
uniform sampler2D table;                   /* steps 4 and 5 by the squared cosine */
uniform int lines;                         /* samples a side */
uniform float first_offset, offset_step;   /* map widths */
uniform vec4 rays[64];                     /* direction to the water, weight */
uniform float normal_keep, power, table_start;
out float map;

/* Repeats the map as its mirror image beyond its edges. */
float mirror(float x)
{
    return 1.0 - abs(mod(x, 2.0) - 1.0);
}

float brightness(vec2 place, vec4 ray)
{
    vec3 n = texture(normals, place).xyz;
    float across = dot(n.xz, n.xz);
    float along = dot(ray.xyz, n);                              /* step 2 */
    float square = along * along / (across + n.y * n.y);
    square *= square;
    square *= square;
    square *= square;                                           /* τ¹⁶ */
    float height = (1.0 - normal_keep * square * square) * n.y; /* step 3 */
    float total = height * height + across;
    float cosine = total > 0.0 ? height * height / total : 1.0; /* still water seen from straight below: up */
    float entry = clamp((cosine - table_start) / (1.0 - table_start), 0.0, 1.0);
    int last = textureSize(table, 0).x - 1;
    return ray.w * texelFetch(table, ivec2(int(entry * float(last) + 0.5), 0), 0).x;
}

void main()
{
    float sum = 0.0;
    for (int l = 0; l < lines; l++) {
        float z = mirror(target.y + first_offset + float(l) * offset_step);
        for (int k = 0; k < lines; k++)
            sum += brightness(vec2(mirror(target.x + first_offset + float(k) * offset_step), z), rays[l * lines + k]);
    }
    map = min(pow(sum, power), 1.0);
}
#endif
