/* Sight: where a point is seen, straight, through the rest surface, or mirrored in it, and what a pixel's depth says.
 *
 * A layer is the scene as flat water would show it; waves then look it up a little beside (sea.glsl). */
#define LAYER_DIRECT 0
#define LAYER_THROUGH 1
#define LAYER_MIRROR 2

uniform mat4 view_projection;
uniform vec3 eye, ahead, right, up; /* a pixel's ray is ahead + x right + y up, x and y from -1 to 1 */
uniform vec2 planes;                /* m, near and far */
uniform float ior;
uniform float side; /* of the rest surface that the eye is on: 1 above, -1 below */

/* Refractive index of the other side to that of the eye's. */
float view_index()
{
    return side > 0.0 ? ior : 1.0 / ior;
}

/* How far off, horizontally, sight of a point passes the rest surface: `level` m across, it is `beyond` m behind the
 * surface, the eye `before` it. By Snell's law s / |s, before| = index (level - s) / |level - s, beyond|, whose left side less
 * its right one grows with s; Newton's method from its paraxial solution, kept between the ends. */
float view_crossing(float level, float before, float beyond)
{
    float index = view_index(), s = level * index * before / (index * before + beyond);
    for (int i = 0; i < 5; i++) {
        float rest = level - s, in_front = inversesqrt(s * s + before * before), behind = inversesqrt(rest * rest + beyond * beyond);
        float error = s * in_front - index * rest * behind;
        float slope = before * before * in_front * in_front * in_front + index * beyond * beyond * behind * behind * behind;
        s = clamp(s - error / slope, 0.0, level);
    }
    return s;
}

/* Where a point beyond the rest surface seems to be: on the straight ray to where its sight passes the surface, as far
 * off as its light has come. */
vec3 view_through(vec3 point)
{
    float before = max(side * eye.y, 1e-4), beyond = -side * point.y;
    vec2 across = point.xz - eye.xz;
    float level = length(across);
    if (beyond <= 0.0 || level < 1e-5)
        return point;
    float s = view_crossing(level, before, beyond);
    vec3 ray = normalize(vec3(across * (s / level), -eye.y).xzy);
    float way = length(vec2(s, before)) + length(vec2(level - s, beyond));
    return eye + ray * way;
}

vec3 view_apparent(vec3 point, int layer)
{
    return layer == LAYER_THROUGH ? view_through(point) : layer == LAYER_MIRROR ? point * vec3(1.0, -1.0, 1.0) : point;
}

/* The place in the picture, 0 to 1, of an apparent point; (-1, -1) behind the eye. */
vec2 view_place(vec3 apparent)
{
    vec4 clip = view_projection * vec4(apparent, 1.0);
    return clip.w > 0.0 ? 0.5 * clip.xy / clip.w + 0.5 : vec2(-1.0);
}

vec3 view_ray(vec2 place)
{
    return normalize(ahead + (2.0 * place.x - 1.0) * right + (2.0 * place.y - 1.0) * up);
}

/* m along a unit ray of sight to what has that depth. */
float view_way(float depth, vec3 ray)
{
    float far_side = planes.y - planes.x;
    return 2.0 * planes.x * planes.y / (planes.y + planes.x - (2.0 * depth - 1.0) * far_side) / dot(ray, normalize(cross(up, right)));
}
