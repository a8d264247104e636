/* optics/sky_parts.h: what makes the upper half of a sky's picture: a file a model. */
#ifndef OPTICS_SKY_PARTS_H
#define OPTICS_SKY_PARTS_H

#include "optics/scattering.h"
#include "optics/sky.h"

#define SKY_HORIZON (SKY_ROWS / 2) /* the first row below it */

/* What is kept from one sky to the next. */
struct sky_kept {
    struct atmosphere_columns columns;
    struct atmosphere atmosphere;
    struct scattering scattering;
    double turbidity, ground; /* of the scattering; a turbidity of 0: not made yet */
    float *picture;           /* SKY_HORIZON × SKY_COLUMNS × 3 of an environment that is not turned; NULL: none */
    char path[DPL_PARAM_TEXT_SIZE];
};

/* Unit vector towards a place of the picture, in texels from its corner: the middle of texel (i, j) is (i + ½, j + ½).
 */
void sky_direction(double column, double row, double direction[3]);

/* Irradiance of the sun's disc across its rays below clear air. */
void sky_clear_sun(const struct sky_kept *kept, const double to_sun[3], double sun[3]);

void sky_clear_draw(const struct sky_kept *kept, const double to_sun[3], float *texels);
void sky_overcast_draw(const double to_sun[3], float *texels);
/* `turn` in degrees. The picture has been read. */
void sky_environment_draw(const struct sky_kept *kept, double turn, float *texels);
bool sky_environment_read(struct sky_kept *kept, const char *path, const struct dpl_log *log);

#endif
