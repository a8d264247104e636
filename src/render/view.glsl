/* Sight: where a point is seen, straight, through a plane between air and water, or mirrored in the rest surface; and
 * what a pixel's depth says.
 *
 * The plane is the rest surface, or the pane of an aquarium that is seen from outside. A layer is the scene as flat
 * water would show it; waves then look it up a little beside (sea.glsl). */
#define LAYER_DIRECT 0
#define LAYER_THROUGH 1
#define LAYER_MIRROR 2

uniform mat4 view_projection;
uniform vec3 eye, ahead, right, up; /* a pixel's ray is ahead + x right + y up, x and y from -1 to 1 */
uniform vec2 planes;                /* m, near and far */
uniform float ior;
uniform float side;       /* of the rest surface that the sight is on when it meets it: 1 above, -1 below */
uniform vec4 plane;       /* unit normal towards the eye, and the plane's distance from the origin along it */
uniform float plane_index; /* refractive index beyond the plane to that before it */
/* 1: the plane is a pane; what is mirrored in the rest surface is seen through it, too. A shader that is made for one
 * kind of sight knows it, which spares devices that go both ways of a condition. */
#if defined PANE
const int pane = 1;
#elif defined NO_PANE
const int pane = 0;
#else
uniform int pane;
#endif

/* m from pane to pane of a tank along x and z, where they mirror what is in it; 0: they do not. An image in a pane is
 * as far beyond it as what it shows is before it. */
uniform vec2 mirrors;

/* The image of a point in the pane at the greater end of an axis (1), at the lesser (-1), or in none (0). */
vec3 view_image(vec3 point, ivec2 panes)
{
    vec2 images = vec2(panes);
    point.xz = mix(point.xz, images * mirrors - point.xz, abs(images));
    return point;
}

/* Where in the tank that stands of which an image is seen at a place; what is seen straight stands at its place. */
vec2 view_fold(vec2 xz)
{
    return xz - 2.0 * sign(xz) * max(abs(xz) - 0.5 * mirrors, 0.0) * step(1e-6, mirrors);
}

/* How far off along the plane sight of a point passes it: `level` m from the foot of the eye to that of the point,
 * `before` and `beyond` from the plane to each. By Snell's law s / |s, before| = index (level - s) / |level - s,
 * beyond|, whose left side less its right one grows with s; Newton's method from `guess`, a share of the level, kept
 * between the ends. */
float view_crossing(float level, float before, float beyond, float guess, int steps)
{
    float s = level * guess;
    for (int i = 0; i < steps; i++) {
        float rest = level - s, in_front = inversesqrt(s * s + before * before);
        float behind = inversesqrt(rest * rest + beyond * beyond);
        float error = s * in_front - plane_index * rest * behind;
        float slope = before * before * in_front * in_front * in_front +
                      plane_index * beyond * beyond * behind * behind * behind;
        s = clamp(s - error / slope, 0.0, level);
    }
    return s;
}

/* Where a point beyond the plane seems to be: on the straight ray to where its sight passes the plane, as far off as
 * its light has come. `guess`: the share of its level way before the plane; below 0: not known. */
vec3 view_through(vec3 point, float guess)
{
    float before = max(dot(plane.xyz, eye) - plane.w, 1e-4), beyond = plane.w - dot(plane.xyz, point);
    vec3 across = point - eye + plane.xyz * (before + beyond);
    float level = length(across), paraxial = plane_index * before / (plane_index * before + beyond);
    if (beyond <= 0.0 || level < 1e-5)
        return point;
    float s = view_crossing(level, before, beyond, guess < 0.0 ? paraxial : guess, guess < 0.0 ? 5 : 2);
    vec3 ray = normalize(across * (s / level) - plane.xyz * before);
    return eye + ray * (length(vec2(s, before)) + length(vec2(level - s, beyond)));
}

bool view_bends(int layer)
{
    return layer == LAYER_THROUGH || (layer == LAYER_MIRROR && pane != 0);
}

vec3 view_apparent(vec3 point, int layer, float guess)
{
    if (layer == LAYER_MIRROR)
        point.y = -point.y;
    return view_bends(layer) ? view_through(point, guess) : point;
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
    float far_side = planes.y - planes.x, ndc = 2.0 * depth - 1.0;
    return 2.0 * planes.x * planes.y / (planes.y + planes.x - ndc * far_side) / dot(ray, normalize(cross(up, right)));
}

/* m along a unit ray of sight to the plane, or a great way where it does not meet it. */
float view_plane(vec3 ray)
{
    float along = -dot(plane.xyz, ray);
    return along > 1e-6 ? (dot(plane.xyz, eye) - plane.w) / along : 1e6;
}

/* The direction in which a sight goes on beyond the plane; one that would be thrown back goes along it. */
vec3 view_bent(vec3 ray)
{
    float cosine = -dot(plane.xyz, ray);
    vec3 along = (ray + cosine * plane.xyz) / plane_index;
    return normalize(along - plane.xyz * sqrt(max(1.0 - dot(along, along), 1e-6)));
}

/* The point that a layer shows along a unit ray of sight, at that depth. */
vec3 view_point(vec3 ray, float depth, int layer)
{
    vec3 point;
    float way = view_way(depth, ray), to_plane = view_plane(ray);
    bool bends = view_bends(layer) && way > to_plane;
    point = bends ? eye + ray * to_plane + view_bent(ray) * (way - to_plane) : eye + ray * way;
    return layer == LAYER_MIRROR ? point * vec3(1.0, -1.0, 1.0) : point;
}
