/* The mesh of wavefront_gpu.c: an instance a row of cells, each a strip of triangles. */
#include "light/coverage_vertex.glsl"
uniform float texels_a_meter;
uniform float cell;  /* texels, in flat water */
uniform float side;  /* of the map, texels */
uniform vec4 part;   /* first cell along x and z; texels from the map's corner to where flat water has vertex (0, 0) */
uniform int weights; /* 0: all light has the same */

struct mesh_vertex {
    vec2 before, after; /* texels from where flat water has vertex (0, 0) */
    vec3 weight;
};

mesh_vertex find_vertex(ivec2 index)
{
    vertex_light light = find_light(index);
    vec2 before = vec2(index) * cell + light.shift * texels_a_meter;
    vec3 weight = weights != 0 ? light.weight : vec3(greaterThan(light.weight, vec3(0.0)));
    return mesh_vertex(before, before + light.moved * texels_a_meter, weight);
}

/* The vertex of a strip: it goes along x, from the row's smaller z to its larger one and back. */
ivec2 strip_vertex(int vertex)
{
    return ivec2(part.xy) + ivec2(vertex / 2, gl_InstanceID + vertex % 2);
}

vec4 map_position(vec2 after)
{
    return vec4((after + part.zw) / side * 2.0 - 1.0, 0.0, 1.0);
}
