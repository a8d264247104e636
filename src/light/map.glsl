/* Caustic maps as the shaders that show them see them: a layer a receiver, at even steps from the floor (layer 0) up
 * towards the surface; or one layer, that of a ceiling. */
uniform sampler2DArray light_texels;
uniform int light_channels; /* 1 or 3 */
uniform vec3 light_window;  /* of the first receiver, in tiles: its corner along x and z, its side */
uniform vec3 light_step;    /* from there to that of the next */

vec3 light_in_layer(vec2 place, float layer)
{
    place = (place - light_window.xy - layer * light_step.xy) / light_window.z;
    /* The bias keeps lines that run away from the eye sharp, at the price of a little shimmer far off. */
    vec3 light = texture(light_texels, vec3(place, layer), -0.7).rgb;
    return light_channels == 1 ? light.rrr : light;
}

/* Irradiance in units of flat water at a place of the tile, 0 to 1 along x and z, of the first receiver. */
vec3 light_at(vec2 place)
{
    return light_in_layer(place, 0.0);
}

/* The same at a height between the floor, 0, and the surface, 1. `slant`: how far light under flat water moves along
 * `place` on its way from the surface to the floor; between two layers light is looked up along its way. */
vec3 light_at_height(vec2 place, float height, vec2 slant)
{
    float count = float(textureSize(light_texels, 0).z);
    float layer = clamp(height * count, 0.0, count - 1.0), lower = floor(layer), upper = min(lower + 1.0, count - 1.0);
    vec3 below = light_in_layer(place + slant * (height - lower / count), lower);
    if (layer - lower < 0.02)
        return below;
    vec3 above = light_in_layer(place + slant * (height - upper / count), upper);
    return mix(below, above, layer - lower);
}
