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
    bool fitted;                 /* it or the reference has no physical scale */
    struct dpl_measure measure;  /* of the map; after the gain of least error where it is fitted */
    double flip;                 /* of the maps as they are shown, see compare_expose() */
    double milliseconds;         /* of water and light on this device; median */
};

struct compare {
    struct session session;
    struct dpl_entry against;
    struct dpl_image *reference; /* its map */
    double seconds, noise;       /* of the reference; noise in units of its RMS */
    double white;                /* what is shown as white: one in a hundred of the reference's values is above it */
    struct comparison *comparisons;
    int count;
    struct progress progress;
    int made;    /* maps, the reference's first */
    double ends; /* clock_seconds() when a map has been refined enough */
};

/* Turns a map, times a gain, into displayable values: 0 is black, and a gamma of 2.2. */
void compare_expose(const struct compare *compare, double gain, struct dpl_image *map);

/* The name of the device that computes. */
const char *compare_device(const struct compare *compare);

void compare_print(const struct compare *compare);
void compare_print_json(const struct compare *compare);

/* A new image: for each technique its map, the difference in false colours, and a line of both maps as curves. Returns
 * NULL on failure; the caller destroys it. */
struct dpl_image *compare_sheet(const struct compare *compare);

/* The other thing that the command does: pictures of two looks in place of maps. */
bool compare_looks(const struct options *options, struct program_log *log);

#endif
