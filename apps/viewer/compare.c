#include "viewer/compare.h"

#define REFINE_SECONDS 0.03 /* a frame */
#define MEASURE_SECONDS 0.5 /* from one measurement to the next: maps are read back for it */

static bool refine(void *user, double done)
{
    const struct viewer_compare *compare = user;
    (void)done;
    return compare->real_time() < compare->ends;
}

/* The first technique that refines its map; the first of all where there is none. */
static int find_reference(void)
{
    for (int i = 0; dpl_technique(i).name; i++)
        if (dpl_technique(i).refines)
            return i;
    return 0;
}

void compare_start(struct viewer_compare *compare, struct dpl_renderer *renderer, double (*real_time)(void))
{
    *compare = (struct viewer_compare){
        .shown = {DPL_COMPARE_NOTHING, .technique = find_reference(), .place = 0.5, .gain = 1, .range = 1},
        .real_time = real_time,
    };
    dpl_renderer_progress(renderer, refine, compare);
}

void compare_begin_frame(struct viewer_compare *compare, struct dpl_renderer *renderer)
{
    compare->ends = compare->real_time() + REFINE_SECONDS;
    dpl_renderer_compare(renderer, &compare->shown);
}

void compare_end_frame(struct viewer_compare *compare, struct dpl_renderer *renderer, bool drawn)
{
    if (!drawn || compare->shown.mode == DPL_COMPARE_NOTHING) {
        compare->measured = false;
        compare->next_measure = 0;
    } else if (compare->real_time() >= compare->next_measure) {
        compare->measured = dpl_renderer_measure(renderer, &compare->measure);
        compare->noise = dpl_renderer_noise(renderer);
        compare->shown.gain = compare->measured ? compare->measure.gain : 1;
        compare->next_measure = compare->real_time() + MEASURE_SECONDS;
    }
}
