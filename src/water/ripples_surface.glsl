/* Height and slopes of water between two steps: the GPU's twin of grid_fill() in water/grid.c. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D water; /* red its height, green its speed */
uniform float lag;       /* steps that the time is before that of the heights */
uniform float spacing;   /* m */
out vec4 texel;

float height_at(ivec2 vertex)
{
    ivec2 last = textureSize(water, 0) - 1;
    vec2 now = texelFetch(water, clamp(vertex, ivec2(0), last), 0).xy;
    return now.x - lag * now.y;
}

void main()
{
    ivec2 vertex = ivec2(gl_FragCoord.xy);
    float along = height_at(vertex + ivec2(1, 0)) - height_at(vertex - ivec2(1, 0));
    float across = height_at(vertex + ivec2(0, 1)) - height_at(vertex - ivec2(0, 1));
    texel = vec4(height_at(vertex), vec2(along, across) * (0.5 / spacing), 0.0);
}
#endif
