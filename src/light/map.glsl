/* The caustic map as the shaders that show it see it. */
uniform sampler2D light_texels;
uniform int light_channels; /* 1 or 3 */

/* Irradiance in units of flat water at a place of the tile, 0 to 1 along x and z. The bias keeps lines that run away from
 * the eye sharp, at the price of a little shimmer far off. */
vec3 light_at(vec2 place)
{
    vec3 light = texture(light_texels, place, -0.7).rgb;
    return light_channels == 1 ? light.rrr : light;
}
