/* The GPU's half of vertex_ray.c: brightness interpolated over the triangles of its mesh. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D vertices; /* their brightness, both edges of the mesh included */
uniform vec3 square;        /* cells of the mesh: x and z where the target starts, and its side */
uniform int periodic;
out float map;

float vertex(ivec2 place)
{
    return texelFetch(vertices, place, 0).x;
}

void main()
{
    vec2 cells = vec2(textureSize(vertices, 0) - 1);
    vec2 at = square.xy + target * square.z;
    vec2 place = periodic != 0 ? at - floor(at / cells) * cells : clamp(at, vec2(0.0), cells);
    ivec2 cell = min(ivec2(place), ivec2(cells) - 1);
    vec2 inside = place - vec2(cell);
    bool second = inside.x + inside.y > 1.0;
    vec2 weights = second ? 1.0 - inside.yx : inside;
    float corner = vertex(cell + (second ? ivec2(1) : ivec2(0)));
    map = corner * (1.0 - weights.x - weights.y) + vertex(cell + ivec2(1, 0)) * weights.x +
          vertex(cell + ivec2(0, 1)) * weights.y;
    if (periodic == 0 && place != at)
        map = 0.0; /* no water above */
}
#endif
