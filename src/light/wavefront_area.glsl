/* A piece of the mesh before and after, with edges a and b that start at the same corner. */
uniform int lengths;     /* 1: the product of the lengths of the derivatives, as Wallace's demo; 0: the true area */
uniform float most; /* a fold's image has no area */

float cross_product(vec2 a, vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

float bounded_ratio(float before, float after)
{
    return before < after * most ? before / after : most;
}

/* Edges that are a step of a texel along either axis of the map. */
float texel_ratio(vec2 before_x, vec2 before_y, vec2 after_x, vec2 after_y)
{
    if (lengths != 0)
        return bounded_ratio(length(before_x) * length(before_y), length(after_x) * length(after_y));
    return bounded_ratio(abs(cross_product(before_x, before_y)), abs(cross_product(after_x, after_y)));
}

/* Edges of a triangle. */
float triangle_ratio(vec2 before_a, vec2 before_b, vec2 after_a, vec2 after_b)
{
    float doubled = cross_product(after_a, after_b);
    if (lengths == 0)
        return bounded_ratio(abs(cross_product(before_a, before_b)), abs(doubled));
    vec2 per_x = before_a * after_b.y - before_b * after_a.y, per_y = before_b * after_a.x - before_a * after_b.x;
    return bounded_ratio(length(per_x) * length(per_y), doubled * doubled);
}
