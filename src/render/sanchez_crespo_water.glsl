/* What water takes from the light on its way to the eye. */
uniform vec3 eye, water_color;
uniform float transmittance; /* share of the light that a metre of water lets through */

/* How much of the way from a place below the surface to the eye lies in the water, m. */
float length_in_water(vec3 from)
{
    vec3 way = eye - from;
    float share = eye.y > 0.0 ? clamp(-from.y / max(way.y, 1e-4), 0.0, 1.0) : 1.0;
    return share * length(way);
}
