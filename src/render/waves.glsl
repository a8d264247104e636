/* The surface for sight: height, slopes and the mean square of the slopes, with smaller levels (render/waves.c). */
uniform sampler2D waves_texels;
uniform float waves_size, waves_spacing; /* m, of the tile and from vertex to vertex */
uniform float waves_extent;              /* m, half a side of the water that there is; 0: it has no end */
uniform float waves_wall; /* m, half a side of what the water wets: walls around it, not the frame of a tank */
uniform float waves_roughness;           /* variance of the slopes too fine for the grid */

vec2 waves_place(vec2 xz)
{
    return ((xz + 0.5 * waves_size) / waves_spacing + 0.5) / vec2(textureSize(waves_texels, 0));
}

float waves_height(vec2 xz, float level)
{
    return textureLod(waves_texels, waves_place(xz), level).x;
}

bool waves_cover(vec2 xz)
{
    return waves_extent == 0.0 || max(abs(xz.x), abs(xz.y)) < waves_extent;
}

/* True where a point is in the water, by that many metres out of it, or into it where they are less than 0. */
bool waves_wet(vec3 point, float slack)
{
    bool inside = waves_extent == 0.0 || max(abs(point.x), abs(point.z)) < waves_wall;
    return inside && point.y < waves_height(point.xz, 0.0) + slack;
}
