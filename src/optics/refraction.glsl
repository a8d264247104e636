/* The GPU's twin of refraction.c. */

vec3 optics_refract(vec3 to_light, vec3 normal, float ior)
{
    float cosine = dot(to_light, normal);
    float inside = sqrt(max(ior * ior - 1.0 + cosine * cosine, 0.0));
    return ((cosine - inside) * normal - to_light) / ior;
}

bool optics_refract_out(vec3 ray, vec3 normal, float ior, out vec3 leaving)
{
    float cosine = dot(ray, normal);
    float outside = 1.0 - ior * ior * (1.0 - cosine * cosine);
    leaving = ior * ray + (sqrt(max(outside, 0.0)) - ior * cosine) * normal;
    return outside >= 0.0;
}

vec3 optics_reflect(vec3 to_light, vec3 normal)
{
    return 2.0 * dot(to_light, normal) * normal - to_light;
}

float optics_fresnel_reflectance(float cosine, float ior)
{
    float inside = sqrt(max(ior * ior - 1.0 + cosine * cosine, 0.0));
    if (inside + cosine <= 0.0)
        return 1.0;
    float across = (cosine - inside) / (cosine + inside);
    float along = (ior * ior * cosine - inside) / (ior * ior * cosine + inside);
    return 0.5 * (across * across + along * along);
}

const float OPTICS_GAIN_MOST = 8.0;

vec3 optics_transmittance(vec3 absorption, float length)
{
    return exp(min(-absorption * length, OPTICS_GAIN_MOST));
}
