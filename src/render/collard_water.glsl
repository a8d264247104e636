/* Collard & Mundi 2022, section 3.6: Phong's shading, its green weighted by 2q - q², its highlights white above a
 * threshold, its opacity q plus the highlight. */
#include "render/water_mesh.glsl"

#ifdef FRAGMENT
uniform vec3 eye, lamp_position, lamp_color, water_color;
uniform float ambient, shininess, threshold;
out vec4 color;

void main()
{
    vec3 up = normalize(normal), to_lamp = normalize(lamp_position - position), to_eye = normalize(eye - position);
    float q = max(dot(up, to_lamp), 0.0);
    vec3 diffuse = vec3(q, clamp(2.0 * q - q * q, 0.0, 1.0), q) * lamp_color;
    diffuse /= max(length(diffuse), 1e-6);
    vec3 highlight = pow(max(dot(to_eye, reflect(-to_lamp, up)), 0.0), shininess) * lamp_color;
    if (dot(highlight, vec3(1.0 / 3.0)) > threshold)
        highlight = vec3(1.0);
    vec3 shaded = (ambient * lamp_color + diffuse) * water_color + highlight;
    color = clamp(vec4(shaded, q + highlight.r), 0.0, 1.0);
}
#endif
