/* The caustic map as the shaders that show it see it. */
uniform sampler2D light_texels;
uniform int light_channels; /* 1 or 3 */

/* Irradiance in units of flat water at a place of the tile, 0 to 1 along x and z. */
vec3 light_at(vec2 place)
{
    vec3 light = texture(light_texels, place).rgb;
    return light_channels == 1 ? light.rrr : light;
}
