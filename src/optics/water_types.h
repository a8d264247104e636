/* optics/water_types.h: what kinds of water do to light, by the names that oceanography gives them. */
#ifndef OPTICS_WATER_TYPES_H
#define OPTICS_WATER_TYPES_H

/* At the wavelengths that stand for red, green and blue in all tables of water: 625, 550 and 450 nm. */
struct optics_water {
    double absorption[3]; /* 1/m */
    double scattering[3]; /* 1/m */
    double anisotropy;    /* mean cosine of the angle of scattering (optics/phase.h) */
};

/* Type 0 is water that is described by numbers of its own. */
#define OPTICS_WATER_CUSTOM 0

/* The i-th type's name, NULL past the last. */
const char *optics_water_type_name(int i);

/* The water of a type, not of type 0. `anisotropy` is that of its particles; what the water's own molecules scatter
 * goes evenly everywhere. */
struct optics_water optics_water_type(int type, double anisotropy);

#endif
