/* The light that a triangle throws on a texel. A disc of the sun that is hardly wider than a texel is four points, which
 * throw the triangle ±(spread.x, 0) ±(spread.y, spread.z) texels from where its middle does.
 * With POINT_SUN defined there is only the middle: a condition would not spare a software renderer the rest. */

struct triangle {
    vec2 a, b, c;
    vec3 density; /* light a texel; negative where the image is turned over */
};

/* The mean of clamp(x, 0, 1) from `least` to `most`. */
float mean_in_square(float least, float most)
{
    vec2 inside = clamp(vec2(least, most), 0.0, 1.0);
    float sum = 0.5 * (inside.y - inside.x) * (inside.y + inside.x) + max(most - max(least, 1.0), 0.0);
    return sum / (most - least);
}

/* The area between an edge and the left side of the unit square, as far as both lie in the square: the integral of
 * clamp(x, 0, 1) along the edge's rise. The mean of that with the edge moved `apart` to either side. */
float area_left_of(vec2 a, vec2 b, float apart)
{
    float rise = b.y - a.y;
    float lower = clamp(a.y, 0.0, 1.0), upper = clamp(b.y, 0.0, 1.0);
    float slope = (b.x - a.x) / (abs(rise) < 1e-9 ? 1e-9 : rise);
    vec2 ends = a.x + slope * (vec2(lower, upper) - a.y);
    ends = clamp(ends, min(a.x, b.x), max(a.x, b.x)); /* a level edge has any slope */
    float least = min(ends.x, ends.y), most = max(max(ends.x, ends.y), least + 1e-5);
#ifdef POINT_SUN
    return (upper - lower) * mean_in_square(least, most);
#else
    return (upper - lower) * 0.5 *
           (mean_in_square(least - apart, most - apart) + mean_in_square(least + apart, most + apart));
#endif
}

/* The part of the square at `texel` that lies in the triangle. */
float area_in(triangle t, vec2 texel, float apart)
{
    vec2 a = t.a - texel, b = t.b - texel, c = t.c - texel;
    return area_left_of(a, b, apart) + area_left_of(b, c, apart) + area_left_of(c, a, apart);
}

/* The light on the texel whose first corner is there. */
vec3 light_on(triangle t, vec2 texel, vec3 spread)
{
#ifdef POINT_SUN
    return t.density * area_in(t, texel, 0.0);
#else
    return t.density * 0.5 * (area_in(t, texel - spread.yz, spread.x) + area_in(t, texel + spread.yz, spread.x));
#endif
}
