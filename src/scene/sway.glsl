/* The GPU's twin of sway.c. */
uniform vec4 sway_waves[3];
uniform vec4 sway_current;

vec3 sway_move(vec3 position, float reach)
{
    vec3 heights;
    for (int w = 0; w < 3; w++)
        heights[w] = sin(6.28318531 * fract(dot(sway_waves[w].xyz, position) + sway_waves[w].w));
    float along = 0.55 * heights.x + 0.25 * heights.y, across = 0.3 * heights.z;
    vec2 current = sway_current.xy;
    vec2 moved = reach * (along * current + across * vec2(-current.y, current.x));
    return vec3(moved.x, 0.0, moved.y);
}
