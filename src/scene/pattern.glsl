/* The GPU's twin of pattern.c, which has no filter.
 *
 * All patterns are bricks: rows of one height, each shifted along. Joints are filtered over the pixel by the exact mean
 * of the pulses that they are (Apodaca & Gritz 2000, ch. 11). */
const int PATTERN_PLAIN = 0;

/* Length of a brick in its height; how far a row is shifted (0, half a brick every other row, or by chance); share of
 * the height that is joint; how much bricks differ in brightness. */
const vec4 pattern_styles[4] =
    vec4[4](vec4(1.0, 0.0, 0.0, 0.0), vec4(1.0, 0.0, 0.03, 0.06), vec4(14.0, 2.0, 0.02, 0.16),
            vec4(2.0, 1.0, 0.045, 0.12));

/* 0 to 1 for each brick (integer hash by multiplication and shift, PCG: O'Neill 2014; Jarzynski & Olano 2020). */
float pattern_random(int column, int row)
{
    uint state = uint(column) * 1664525u + uint(row) * 22695477u + 2891336453u;
    state = state * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

/* Joint up to a place, where each whole number has one of that width about it. */
float pattern_joint_until(float place, float joint)
{
    float inside = place + 0.5 * joint;
    return joint * floor(inside) + min(inside - floor(inside), joint);
}

/* Share of joint within `width` about a place. */
float pattern_joint_share(float place, float joint, float width)
{
    float inside = place + 0.5 * joint;
    if (width < 1e-5)
        return inside - floor(inside) < joint ? 1.0 : 0.0;
    return (pattern_joint_until(place + 0.5 * width, joint) - pattern_joint_until(place - 0.5 * width, joint)) / width;
}

/* Reflectance at a place of a surface, m; `width` is how much of it the pixel covers: fwidth(place), taken outside of
 * any branch. */
vec3 pattern_color(int pattern, float size, vec3 joint, vec3 color, vec2 place, vec2 width)
{
    if (pattern == PATTERN_PLAIN)
        return color;
    vec4 style = pattern_styles[pattern];
    float across = place.y / size, row = floor(across);
    float shift = style.y == 1.0 ? 0.5 * mod(row, 2.0) : style.y == 2.0 ? pattern_random(0, int(row)) : 0.0;
    float along = place.x / (size * style.x) + shift;
    vec2 covered = width / vec2(size * style.x, size);
    float open = (1.0 - pattern_joint_share(along, style.z / style.x, covered.x)) *
                 (1.0 - pattern_joint_share(across, style.z, covered.y));
    float seen = 1.0 - min(max(covered.x, covered.y), 1.0);
    float shade = 1.0 + style.w * seen * (2.0 * pattern_random(int(floor(along)), int(row)) - 1.0);
    return mix(joint, clamp(color * shade, 0.0, 1.0), open);
}
