/* cli/compare.h: what the comparison of techniques found, and the ways of showing it. */
#ifndef CLI_COMPARE_H
#define CLI_COMPARE_H

#include "cli/progress.h"
#include "cli/session.h"
#include "dapple/measure.h"

/* One technique, and how far it is from the reference. */
struct comparison {
    struct dpl_entry technique;
    struct dpl_image *map;       /* NULL: the technique cannot serve this scene … */
    char failure[LOG_TEXT_SIZE]; /* … for this reason */
    struct dpl_measure measure;  /* of the map; after the gain of least error where the technique is not physical */
    double flip;                 /* of the picture; NAN: no OpenGL to draw one with */
    double milliseconds;         /* of water and light on this device; median */
};

struct compare {
    struct session session;
    struct dpl_entry against;
    struct dpl_image *reference;         /* its map */
    struct dpl_image *reference_picture; /* NULL: no OpenGL */
    double seconds, noise;               /* of the reference; noise in units of its RMS */
    struct comparison *comparisons;
    int count;
    struct progress progress;
    int made;    /* maps, the reference's first */
    double ends; /* clock_seconds() when a map has been refined enough */
};

/* The name of the device that computes. */
const char *compare_device(const struct compare *compare);

void compare_print(const struct compare *compare);
void compare_print_json(const struct compare *compare);

/* A new image: for each technique its map, the difference in false colours, and a line of both maps as curves. Returns
 * NULL on failure; the caller destroys it. */
struct dpl_image *compare_sheet(const struct compare *compare);

#endif
