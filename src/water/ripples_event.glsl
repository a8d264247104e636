/* The GPU's twin of ripples_tank.c: one thing happens to the water, red its height and green its speed. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D water;
uniform int kind;            /* enum ripples_kind */
uniform float damping;
uniform float spacing, half_side; /* m */
uniform vec4 drop;           /* x, z, radius, height */
uniform vec4 from, to;       /* the ball: its middle, its radius */
out vec2 changed;

float height_at(ivec2 vertex)
{
    ivec2 last = textureSize(water, 0) - 1;
    return texelFetch(water, clamp(vertex, ivec2(0), last), 0).x;
}

vec2 step_at(ivec2 vertex)
{
    vec2 now = texelFetch(water, vertex, 0).xy;
    float along = height_at(vertex - ivec2(1, 0)) + height_at(vertex + ivec2(1, 0));
    float across = height_at(vertex - ivec2(0, 1)) + height_at(vertex + ivec2(0, 1));
    float speed = damping * (now.y + (0.5 * (along + across) - 2.0 * now.x));
    return vec2(now.x + speed, speed);
}

float drop_at(vec2 place)
{
    float w = max(0.0, 1.0 - distance(place, drop.xy) / drop.z);
    return drop.w * (0.5 - 0.5 * cos(3.14159265 * w));
}

/* As ball_volume(). */
float volume_at(vec2 place, vec4 ball)
{
    if (ball.w <= 0.0)
        return 0.0;
    vec3 away = (vec3(place.x, 0.0, place.y) - ball.xyz) / ball.w;
    float squared = 2.25 * dot(away, away);
    return squared > 3.0 ? 0.0 : 0.2 * exp(-squared * squared * squared) * half_side;
}

void main()
{
    ivec2 vertex = ivec2(gl_FragCoord.xy);
    vec2 place = vec2(vertex) * spacing - half_side;
    changed = texelFetch(water, vertex, 0).xy;
    if (kind == 0)
        changed = step_at(vertex);
    else if (kind == 1)
        changed.x += drop_at(place);
    else
        changed.x += volume_at(place, from) - volume_at(place, to);
}
#endif
