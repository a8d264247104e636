/* The depth at which the water's surface is seen. */
#include "render/view.glsl"
#include "render/rings.glsl"
#include "render/waves.glsl"

#ifdef VERTEX
void main()
{
    float spacing;
    vec2 xz = rings_place(spacing);
    vec2 extent = pane != 0 ? rings_extent + mirrors : vec2(rings_extent);
    if (rings_extent > 0.0)
        xz = clamp(xz, -extent, extent);
    vec2 there = pane != 0 ? view_fold(xz) : xz;
    vec3 position = vec3(xz.x, waves_height(there, log2(max(spacing / waves_spacing, 1.0))), xz.y);
    gl_Position = view_projection * vec4(pane != 0 ? view_through(position, -1.0) : position, 1.0);
    gl_Position.z = min(gl_Position.z, 0.999998 * gl_Position.w); /* the horizon lies beyond the far plane */
}
#else
void main() {}
#endif
