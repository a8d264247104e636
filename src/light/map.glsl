/* Caustic maps as the shaders that show them see them: a layer a receiver, at even steps from the floor (layer 0) up
 * towards the surface; or one layer, that of a ceiling. */
uniform sampler2DArray light_texels;
uniform int light_channels; /* 1 or 3 */
uniform vec3 light_window;  /* of the first receiver, in tiles: its corner along x and z, its side */
uniform vec3 light_step;    /* from there to that of the next */

/* Keeps lines that run away from the eye sharp, at the price of a little shimmer far off: a level 0.7 finer. */
const float LIGHT_SHARPER = 0.616;

/* Where a place is in a layer's map. */
vec2 light_place(vec2 place, float layer)
{
    return (place - light_window.xy - layer * light_step.xy) / light_window.z;
}

/* Irradiance in units of flat water at a place of the tile, 0 to 1 along x and z, of the first receiver. */
vec3 light_at(vec2 place)
{
    vec3 light = texture(light_texels, vec3(light_place(place, 0.0), 0.0), log2(LIGHT_SHARPER)).rgb;
    return light_channels == 1 ? light.rrr : light;
}

/* The same at a height between the floor, 0, and the surface, 1. `slant`: how far light under flat water moves along
 * `place` on its way from the surface to the floor; between two layers light is looked up along its way. The level
 * follows from `place` alone, which has no step where the layers change. */
vec3 light_at_height(vec2 place, float height, vec2 slant)
{
    float count = float(textureSize(light_texels, 0).z);
    float layer = clamp(height * count, 0.0, count - 1.0), lower = floor(layer), upper = min(lower + 1.0, count - 1.0);
    vec2 along_x = LIGHT_SHARPER * dFdx(place) / light_window.z, along_y = LIGHT_SHARPER * dFdy(place) / light_window.z;
    vec2 below = light_place(place + slant * (height - lower / count), lower);
    vec2 above = light_place(place + slant * (height - upper / count), upper);
    vec3 light = mix(textureGrad(light_texels, vec3(below, lower), along_x, along_y).rgb,
                     textureGrad(light_texels, vec3(above, upper), along_x, along_y).rgb, layer - lower);
    return light_channels == 1 ? light.rrr : light;
}
