/* A tank's other panes, seen from in its water: nearly every sight that has come in through one pane is thrown back
 * whole by those at its sides. What it then meets is looked for along it, step by step, in the picture of what is seen
 * straight through the first pane; what that does not show is missing. */
uniform sampler2D through_color, through_depth;

const int TANK_STEPS = 64;

/* m along a ray to where it leaves the tank at a side, and that side's normal, outwards. */
float tank_exit(vec3 start, vec3 ray, out vec3 normal)
{
    vec2 beside = mix(vec2(-1.0), vec2(1.0), greaterThan(ray.xz, vec2(0.0)));
    vec2 ways = (beside * waves_extent - start.xz) / (beside * max(abs(ray.xz), 1e-6));
    normal = ways.x < ways.y ? vec3(beside.x, 0.0, 0.0) : vec3(0.0, 0.0, beside.y);
    return max(min(ways.x, ways.y), 0.0);
}

/* How far beyond what the picture shows at its place a point in the tank lies, m; negative before it. Beside the
 * picture, or where that shows nothing: far before it. */
float tank_beyond(vec3 point, out vec2 place)
{
    place = view_place(view_apparent(point, LAYER_THROUGH, -1.0));
    float depth = textureLod(through_depth, place, 0.0).r;
    vec3 shown = view_point(view_ray(place), depth, LAYER_THROUGH);
    return depth < 1.0 && place == clamp(place, 0.0, 1.0) ? distance(point, eye) - distance(shown, eye) : -planes.y;
}

/* What a ray in the tank meets: radiance and coverage, and how far off it is. Where that is hidden by something
 * nearer, it is what shows last beside that. */
vec4 tank_find(vec3 start, vec3 ray, out float way)
{
    vec3 unused;
    float first = 0.05 * waves_extent; /* m: the pane's own frame is left out */
    float step_way = (tank_exit(start, ray, unused) + first) / float(TANK_STEPS);
    float thickness = 0.02 * waves_extent + 0.5 * step_way; /* of all that is in the tank: the picture does not say */
    vec2 place, last = vec2(-1.0);
    for (int i = 1; i <= TANK_STEPS; i++) {
        way = first + step_way * float(i);
        float beyond = tank_beyond(start + ray * way, place);
        if (beyond <= 0.0 && beyond > -planes.y)
            last = place;
        if (beyond <= 0.0 || beyond >= thickness)
            continue;
        vec2 between = vec2(way - step_way, way);
        for (int k = 0; k < 4; k++) {
            way = 0.5 * (between.x + between.y);
            between = tank_beyond(start + ray * way, place) > 0.0 ? vec2(between.x, way) : vec2(way, between.y);
        }
        return textureLod(through_color, place, 0.0);
    }
    return last.x < 0.0 ? vec4(0.0) : textureLod(through_color, last, 0.0);
}

/* Radiance in the water at the pane that a sight from a place in it meets `way` metres off; `outside`: that beyond. */
vec3 tank_pane(vec3 start, vec3 ray, vec3 outside, out float way)
{
    vec3 normal, leaving;
    way = tank_exit(start, ray, normal);
    bool leaves = optics_refract_out(ray, normal, ior, leaving);
    float share = leaves ? optics_fresnel_reflectance(dot(leaving, normal), ior) : 1.0, back_way;
    vec4 found = tank_find(start + ray * way, reflect(ray, normal), back_way);
    vec3 back = found.rgb * exp(-extinction * back_way) + (1.0 - found.a) * ior * ior * outside;
    return mix(ior * ior * outside, back, share);
}
