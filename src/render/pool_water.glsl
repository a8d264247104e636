/* The surface from above and from below: each pixel follows one ray that is thrown back and one that goes through. */
#include "render/water_mesh.glsl"

#ifdef FRAGMENT
#include "render/pool.glsl"
uniform vec3 eye;
uniform float sharpening; /* sides of the pool, a step along the normal's lean */
uniform float ior, reflected_above, reflected_below;
uniform vec3 tint_above, tint_below, tint_out;
out vec4 color;

/* The unit normal, read five steps along its own lean, which peaks the crests. */
vec3 sharpened_normal()
{
    vec2 xz = position.xz;
    vec3 up = vec3(0.0, 1.0, 0.0);
    for (int look = 0; look <= 5; look++) {
        vec2 slopes = surface_between(xz).yz;
        up = normalize(vec3(-slopes.x, 1.0, -slopes.y));
        xz += sharpening * surface_size * up.xz;
    }
    return up;
}

void main()
{
    vec3 view = position - eye, ray = normalize(view), up = sharpened_normal();
    vec3 facet = cross(dFdx(position), dFdy(position));
    bool below = dot(facet * sign(facet.y), ray) > 0.0;
    vec3 normal = below ? -up : up;
    float cosine = clamp(-dot(ray, normal), 0.0, 1.0);
    float angle = max(length(dFdx(ray)), length(dFdy(ray)));
    vec2 spread = angle * vec2(length(view) / half_side, 1.0);
    vec3 back = optics_reflect(-ray, normal);
    vec3 through = optics_refract(-ray, normal, ior);
    float share = mix(below ? reflected_below : reflected_above, 1.0, pow(1.0 - cosine, 3.0));
    if (below && !optics_refract_out(ray, up, ior, through))
        share = 1.0;
    vec3 thrown = traced_color(position / half_side, back, below ? tint_below : tint_above, spread);
    vec3 passed = traced_color(position / half_side, through, below ? vec3(1.0) : tint_above, spread);
    color = vec4(clamp(mix(below ? passed * tint_out : passed, thrown, share), 0.0, 1.0), 1.0);
}
#endif
