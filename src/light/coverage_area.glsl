/* The light that a triangle throws on a texel. */
struct triangle {
    vec2 a, b, c;
    vec3 density; /* light a texel; negative where the image is turned over */
};

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
