/* The image of one cell of the surface on a receiver, in texels of the map. Large cells are split, and the parts count
 * as cells. */
#include "light/coverage_area.glsl"
#include "light/coverage_vertex.glsl"
uniform vec3 channels;       /* 1 where light is to be added */
uniform vec4 offset;         /* whole texels of the first vertex' place on the receiver, and the rest of it */
uniform float cell;          /* texels, its side under flat water */
uniform int split;           /* cells a side that one of the surface is split into */
uniform float texels_a_meter;
uniform float widest;        /* texels */

const float SLIVER = 1.0 / 64.0; /* texels: triangles are made no thinner, so that floats hold their area */

struct image {
    ivec2 first, count; /* texels that it may touch */
    triangle upper, lower; /* the places of their corners start at texel `first` */
};

struct corner {
    vec2 place; /* of its light, from where flat water has that of the surface's cell, texels */
    vec2 from;  /* of itself, seen from above, from where it rests in the cell's first corner, texels */
    vec3 weight;
};

corner find_vertex(ivec2 index, ivec2 side)
{
    vertex_light light = find_light(index + side);
    vec2 from = vec2(side) * cell * float(split) + light.shift * texels_a_meter;
    return corner(from + light.moved * texels_a_meter, from, light.weight * channels);
}

float cross_product(vec2 a, vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/* A triangle of no width would need an endless density: it becomes one as long, and of some width. */
void thicken(inout triangle t)
{
    vec2 ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c;
    float doubled = abs(cross_product(ab, bc));
    vec3 squares = vec3(dot(ab, ab), dot(bc, bc), dot(ca, ca));
    float square = max(squares.x, max(squares.y, squares.z));
    float extent = max(sqrt(square), SLIVER);
    if (doubled >= SLIVER * extent)
        return;
    vec2 from = square == squares.x ? t.a : square == squares.y ? t.b : t.c;
    vec2 along = square == squares.x ? ab : square == squares.y ? bc : ca;
    vec2 apex = square == squares.x ? t.c : square == squares.y ? t.a : t.b;
    along = square > 0.0 ? along * inversesqrt(square) : vec2(1.0, 0.0);
    t.a = from;
    t.b = from + along * extent;
    t.c = from + along * clamp(dot(apex - from, along), 0.0, extent) + vec2(-along.y, along.x) * SLIVER;
}

/* The area of the surface's triangle seen from above; none where it overhangs. */
float patch_area(corner a, corner b, corner c)
{
    return max(0.5 * cross_product(b.from - a.from, c.from - a.from), 0.0) / float(split * split);
}

/* `weight`: three times the mean of the corners'; `area`: of the surface. */
triangle make_triangle(vec2 a, vec2 b, vec2 c, vec3 weight, float area)
{
    triangle t = triangle(a, b, c, weight * (area / 3.0));
    thicken(t);
    t.density *= 2.0 / cross_product(t.b - t.a, t.c - t.a);
    return t;
}

void move(inout triangle t, vec2 by)
{
    t.a += by;
    t.b += by;
    t.c += by;
}

/* A corner of a part of the surface's cell, on the cell's own two triangles. */
vec2 split_corner(corner corners[4], ivec2 part)
{
    vec2 inside = vec2(part) / float(split);
    bool second = part.x + part.y > split;
    vec2 from = second ? corners[3].place : corners[0].place;
    vec2 x = (second ? corners[2].place : corners[1].place) - from;
    vec2 z = (second ? corners[1].place : corners[2].place) - from;
    return from + (second ? x * (1.0 - inside.x) + z * (1.0 - inside.y) : x * inside.x + z * inside.y);
}

/* A cell whose image is wider than `widest` is drawn smaller, with the same light: it is too thin to be seen. */
void shrink(inout vec2 places[4])
{
    vec2 least = min(min(places[0], places[1]), min(places[2], places[3]));
    vec2 most = max(max(places[0], places[1]), max(places[2], places[3])), middle = 0.5 * (least + most);
    float extent = max(most.x - least.x, most.y - least.y);
    for (int k = 0; k < 4 && extent > widest; k++)
        places[k] = middle + (places[k] - middle) * (widest / extent);
}

image make_image(ivec2 index)
{
    ivec2 parent = split > 1 ? index / split : index, part = index - parent * split;
    corner corners[4] = corner[4](find_vertex(parent, ivec2(0, 0)), find_vertex(parent, ivec2(1, 0)),
                                  find_vertex(parent, ivec2(0, 1)), find_vertex(parent, ivec2(1, 1)));
    vec2 places[4] = vec2[4](corners[0].place, corners[1].place, corners[2].place, corners[3].place);
    if (split > 1)
        places = vec2[4](split_corner(corners, part), split_corner(corners, part + ivec2(1, 0)),
                         split_corner(corners, part + ivec2(0, 1)), split_corner(corners, part + ivec2(1, 1)));
    shrink(places);
    vec2 place = vec2(parent) * cell * float(split) + offset.zw, whole = floor(place);
    vec3 diagonal = corners[1].weight + corners[2].weight, first = diagonal + corners[0].weight;
    vec3 second = diagonal + corners[3].weight;
    float first_area = patch_area(corners[0], corners[1], corners[2]);
    float second_area = patch_area(corners[1], corners[3], corners[2]);
    bool upper = part.x + part.y < split, lower = part.x + part.y < split - 1; /* on the cell's first triangle */
    image i;
    i.upper = make_triangle(places[0], places[1], places[2], upper ? first : second, upper ? first_area : second_area);
    i.lower = make_triangle(places[1], places[3], places[2], lower ? first : second, lower ? first_area : second_area);
    move(i.upper, place - whole);
    move(i.lower, place - whole);
    vec2 least = min(min(min(i.upper.a, i.upper.b), i.upper.c), min(min(i.lower.a, i.lower.b), i.lower.c));
    vec2 most = max(max(max(i.upper.a, i.upper.b), i.upper.c), max(max(i.lower.a, i.lower.b), i.lower.c));
    vec2 start = floor(least);
    move(i.upper, -start);
    move(i.lower, -start);
    i.first = ivec2(whole + start + offset.xy);
    i.count = ivec2(floor(most - start)) + 1;
    return i;
}
