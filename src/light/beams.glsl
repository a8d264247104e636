/* The second pass of beams_gpu.c: a triangle of light for each of the surface's. */
#ifdef VERTEX
#include "light/tracing.glsl"
uniform sampler2D ends; /* of beams_rays.glsl */
uniform int side, margin; /* texels, of the map and around it */
uniform float widest;   /* texels, of a triangle */
uniform float most;     /* intensity of a triangle */
flat out vec3 light;

float doubled_area(vec2 a, vec2 b, vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void main()
{
    ivec2 count = textureSize(ends, 0), cells = surface_periodic != 0 ? count : count - 1;
    int triangle = gl_VertexID / 3, cell = triangle / 2;
    ivec2 first = ivec2(cell % cells.x, cell / cells.x);
    ivec2 corners[3] = triangle % 2 == 0 ? ivec2[3](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1))
                                         : ivec2[3](ivec2(1, 0), ivec2(1, 1), ivec2(0, 1));
    vec2 above[3], places[3]; /* texels, from where the cell rests */
    vec3 sum = vec3(0.0);
    float spacing = surface_spacing() * texels_a_meter;
    bool arrives = true;
    for (int k = 0; k < 3; k++) {
        ivec2 vertex = first + corners[k];
        vec4 end = texelFetch(ends, vertex % count, 0);
        vec2 rest = vec2(corners[k]) * spacing;
        above[k] = rest + surface_shift(vertex) * texels_a_meter;
        places[k] = rest + end.xy * texels_a_meter;
        sum += end.z * optics_transmittance(absorption, end.w) * channels;
        arrives = arrives && end.z > 0.0;
    }
    float area = doubled_area(above[0], above[1], above[2]), image = doubled_area(places[0], places[1], places[2]);
    vec2 least = min(min(places[0], places[1]), places[2]), extents = max(max(places[0], places[1]), places[2]) - least;
    float extent = max(extents.x, extents.y), smaller = min(widest / max(extent, 1e-9), 1.0);
    vec2 middle = least + 0.5 * extents;
    vec2 cell_place = (vec2(first) - 0.5 * vec2(cells)) * spacing + flat_offset.xy + middle;
    if (surface_periodic != 0)
        cell_place -= floor(cell_place / float(side)) * float(side);
    vec2 place = cell_place + (places[gl_VertexID % 3] - middle) * smaller + float(margin);
    light = min(sum * (area / (3.0 * max(abs(image) * smaller * smaller, 1e-12))), most);
    bool seen = arrives && area > 0.0 && image != 0.0;
    gl_Position = vec4(seen ? place / float(side + 2 * margin) * 2.0 - 1.0 : vec2(2.0), 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
flat in vec3 light;
out vec4 color;

void main()
{
    color = vec4(light, 0.0);
}
#endif
