/* reference/photons.h: the ground truth: light as photons, counted where they land.
 *
 * The tile of water is divided into strata. A pass sends two photons through each, one for each half of the count; a
 * photon draws its place in the stratum and its place on the sun's disc from a low-discrepancy sequence over the
 * passes (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences") with a start of its own for each
 * stratum and half (Cranley & Patterson 1976). The surface is the water model's own at that point, not a grid's. What
 * a texel gets is a sum of whole numbers: the order of adding, and so the number of threads, does not matter.
 *
 * The map is in units of what flat water gives under the same sun. A photon counts for the texel it lands in; those of
 * periodic water come in again at the other side, those of other water are lost beyond the map. */
#ifndef REFERENCE_PHOTONS_H
#define REFERENCE_PHOTONS_H

#include "reference/ray.h"

#include <stdint.h>

#define PHOTONS_RECEIVERS_MAX 64

/* What is to be found out. */
struct photons_task {
    const struct water_model *model;
    const struct water_setup *setup;
    double time; /* s */
    const struct optics_sun *sun;
    const struct water_medium *medium;
    const double *receivers; /* m, heights: below the rest surface for refracted light, above it for reflected */
    int receiver_count;      /* 1 to PHOTONS_RECEIVERS_MAX */
    const struct ray_window *windows; /* that the maps show; NULL: the square below the tile */
    int side;                         /* texels of a map */
};

/* A count that goes on from pass to pass. All zero: none. */
struct photons {
    uint64_t fingerprint; /* of the task */
    uint64_t passes;      /* done */
    int side, receiver_count;
    uint64_t *sums; /* halves × receivers × side × side × 3, in parts of a photon */

    int strata; /* a side of the tile */
    struct optics_disc disc;
    struct ray_medium rays;
    /* Mean weight of flat water's rays over the sun's disc, times the window's area in tiles. */
    double flat[PHOTONS_RECEIVERS_MAX][3];
};

/* A number that differs, but for 1 in 2^64, where anything differs that a result depends on. */
uint64_t photons_fingerprint(const struct photons_task *task);

/* Starts to count anew, in the same memory where it has the size. */
bool photons_begin(struct photons *photons, const struct photons_task *task, const struct dpl_log *log);
/* Leaves it zeroed. */
void photons_finish(struct photons *photons);

/* One more pass of the task that the count began with. */
void photons_pass(struct photons *photons, const struct photons_task *task);

/* How many photons a pass sends for each texel. */
double photons_per_texel(const struct photons *photons);

/* The map of a receiver after at least one pass: side × side × 3. */
void photons_read(const struct photons *photons, int receiver, float *texels);

/* What chance adds: the RMS difference of the halves, over 2, in units of the RMS of the map, over all receivers. The
 * halves are independent, so this is what to expect between the map and an endless count's. */
double photons_noise(const struct photons *photons);

/* Writes the count into a file that photons_load() goes on from, to the same bytes as without a stop. The file is for
 * machines with the same order of bytes. */
bool photons_save(const struct photons *photons, const char *path, const struct dpl_log *log);
/* Goes on from a file. Fails where it is not whole or belongs to another task; then the count stays. */
bool photons_load(struct photons *photons, const char *path, const struct dpl_log *log);

/* Numbers in `sums`. */
size_t photons_sum_count(const struct photons *photons);

#endif
