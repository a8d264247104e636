/* The water's surface as shaders see it: the GPU's twin of surface.c. */
uniform sampler2D surface_texels; /* height, slope along x, slope along z */
uniform sampler2D surface_shifts; /* m along x and z; where the surface is choppy */
uniform int surface_choppy;
uniform float surface_size;       /* m */
uniform int surface_periodic;

float surface_spacing()
{
    int columns = textureSize(surface_texels, 0).x;
    return surface_size / float(surface_periodic != 0 ? columns : columns - 1);
}

/* Height and slopes at a vertex, wrapped round where the surface is periodic. */
vec3 surface_vertex(ivec2 vertex)
{
    ivec2 count = textureSize(surface_texels, 0);
    if (surface_periodic != 0)
        vertex = (vertex + count) % count;
    return texelFetch(surface_texels, vertex, 0).xyz;
}

/* How far a vertex stands from its place at rest. */
vec2 surface_shift(ivec2 vertex)
{
    ivec2 count = textureSize(surface_texels, 0);
    if (surface_periodic != 0)
        vertex = (vertex + count) % count;
    return surface_choppy != 0 ? texelFetch(surface_shifts, vertex, 0).xy : vec2(0.0);
}

vec3 surface_vertex_normal(ivec2 vertex)
{
    vec2 slopes = surface_vertex(vertex).yz;
    return normalize(vec3(-slopes.x, 1.0, -slopes.y));
}

/* The unit normal at a point, from the vertices' unit normals interpolated over the triangle below it. */
vec3 surface_normal(vec2 xz)
{
    vec2 place = (xz + 0.5 * surface_size) / surface_spacing();
    vec2 cell = floor(place);
    if (surface_periodic == 0)
        cell = clamp(cell, vec2(0.0), vec2(textureSize(surface_texels, 0) - 2));
    vec2 inside = place - cell;
    ivec2 vertex = ivec2(cell);
    bool second = inside.x + inside.y > 1.0;
    vec3 corner = surface_vertex_normal(vertex + (second ? ivec2(1) : ivec2(0)));
    vec3 right = surface_vertex_normal(vertex + ivec2(1, 0));
    vec3 below = surface_vertex_normal(vertex + ivec2(0, 1));
    vec2 weights = second ? 1.0 - inside.yx : inside;
    return normalize(corner * (1.0 - weights.x - weights.y) + right * weights.x + below * weights.y);
}

/* Height and slopes at a place of the grid at rest, even between vertices. */
vec3 surface_between(vec2 xz)
{
    vec2 place = (xz + 0.5 * surface_size) / surface_spacing();
    ivec2 last = textureSize(surface_texels, 0) - 1;
    if (surface_periodic == 0)
        place = clamp(place, vec2(0.0), vec2(last));
    vec2 cell = floor(place);
    if (surface_periodic == 0)
        cell = min(cell, vec2(last - 1));
    vec2 inside = place - cell;
    ivec2 vertex = ivec2(cell);
    vec3 near = mix(surface_vertex(vertex), surface_vertex(vertex + ivec2(1, 0)), inside.x);
    vec3 far = mix(surface_vertex(vertex + ivec2(0, 1)), surface_vertex(vertex + ivec2(1, 1)), inside.x);
    return mix(near, far, inside.y);
}
