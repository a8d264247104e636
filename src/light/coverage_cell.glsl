/* The image of one cell of the surface on a receiver, in texels of the map, and how much of each texel it covers. */
uniform sampler2D rays;      /* of coverage_rays.glsl */
uniform vec4 flat_water;     /* u, v; q, the length of light's path for each metre of height, with its sign */
uniform vec3 absorption;     /* 1/m; 0 above the surface */
uniform vec3 channels;       /* 1 where light is to be added */
uniform vec4 offset;         /* whole texels of the first vertex' place on the receiver, and the rest of it */
uniform float receiver;      /* m, its height */
uniform float cell;          /* texels, its side under flat water */
uniform float texels_a_meter;
uniform float widest;        /* texels */

const float SLIVER = 1.0 / 64.0; /* texels: triangles are made no thinner, so that floats hold their area */

struct triangle {
    vec2 a, b, c;
    vec3 density; /* light a texel; negative where the image is turned over */
};

struct image {
    ivec2 first, count; /* texels that it may touch */
    triangle upper, lower; /* the places of their corners start at texel `first` */
};

struct corner {
    vec2 place; /* from where flat water has the cell's first vertex, texels */
    vec3 weight;
};

corner find_corner(ivec2 index, ivec2 side)
{
    ivec2 count = textureSize(rays, 0);
    vec4 ray = texelFetch(rays, (index + side) % count, 0);
    vec2 uv = flat_water.xy + ray.xy;
    float path = abs(receiver - ray.z) * sqrt(1.0 + dot(uv, uv)) - abs(receiver * flat_water.z);
    vec2 moved = ray.xy * (receiver - ray.z) - flat_water.xy * ray.z;
    return corner(vec2(side) * cell + moved * texels_a_meter, ray.w * exp(-absorption * path) * channels);
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

triangle make_triangle(corner a, corner b, corner c)
{
    triangle t = triangle(a.place, b.place, c.place, (a.weight + b.weight + c.weight) * (cell * cell / 6.0));
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

/* A cell whose image is wider than `widest` is drawn smaller, with the same light: it is too thin to be seen. */
void shrink(inout corner corners[4])
{
    vec2 least = min(min(corners[0].place, corners[1].place), min(corners[2].place, corners[3].place));
    vec2 most = max(max(corners[0].place, corners[1].place), max(corners[2].place, corners[3].place));
    float extent = max(most.x - least.x, most.y - least.y);
    vec2 middle = 0.5 * (least + most);
    for (int k = 0; k < 4 && extent > widest; k++)
        corners[k].place = middle + (corners[k].place - middle) * (widest / extent);
}

/* `index`: the cell's first vertex. */
image make_image(ivec2 index)
{
    corner corners[4] = corner[4](find_corner(index, ivec2(0, 0)), find_corner(index, ivec2(1, 0)),
                                  find_corner(index, ivec2(0, 1)), find_corner(index, ivec2(1, 1)));
    vec2 place = vec2(index) * cell + offset.zw, whole = floor(place);
    shrink(corners);
    image i;
    i.upper = make_triangle(corners[0], corners[1], corners[2]);
    i.lower = make_triangle(corners[1], corners[3], corners[2]);
    move(i.upper, place - whole);
    move(i.lower, place - whole);
    vec2 least = min(min(min(i.upper.a, i.upper.b), i.upper.c), min(min(i.lower.a, i.lower.b), i.lower.c));
    vec2 most = max(max(max(i.upper.a, i.upper.b), i.upper.c), max(max(i.lower.a, i.lower.b), i.lower.c));
    vec2 first = floor(least);
    move(i.upper, -first);
    move(i.lower, -first);
    i.first = ivec2(whole + first + offset.xy);
    i.count = ivec2(floor(most - first)) + 1;
    return i;
}

/* The area between an edge and the left side of the unit square, as far as both lie in the square: the integral of
 * clamp(x, 0, 1) along the edge's rise. */
float area_left_of(vec2 a, vec2 b)
{
    float rise = b.y - a.y;
    float lower = clamp(a.y, 0.0, 1.0), upper = clamp(b.y, 0.0, 1.0);
    float slope = (b.x - a.x) / (abs(rise) < 1e-9 ? 1e-9 : rise);
    vec2 ends = a.x + slope * (vec2(lower, upper) - a.y);
    ends = clamp(ends, min(a.x, b.x), max(a.x, b.x)); /* a level edge has any slope */
    float least = min(ends.x, ends.y), most = max(max(ends.x, ends.y), least + 1e-5);
    vec2 inside = clamp(vec2(least, most), 0.0, 1.0);
    float sum = 0.5 * (inside.y - inside.x) * (inside.y + inside.x) + max(most - max(least, 1.0), 0.0);
    return (upper - lower) * sum / (most - least);
}

/* The light that a triangle throws on the texel whose first corner is there. */
vec3 light_on(triangle t, vec2 texel)
{
    vec2 a = t.a - texel, b = t.b - texel, c = t.c - texel;
    return t.density * (area_left_of(a, b) + area_left_of(b, c) + area_left_of(c, a));
}
