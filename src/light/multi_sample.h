/* light/multi_sample.h: what the CPU's and the GPU's half of the technique share. */
#ifndef LIGHT_MULTI_SAMPLE_H
#define LIGHT_MULTI_SAMPLE_H

#include "light/light.h"
#include "light/sun_map.h"
#include "water/normal_map.h"

#define MULTI_SAMPLE_STEPS_MAX 7
#define MULTI_SAMPLE_COUNT_MAX ((MULTI_SAMPLE_STEPS_MAX + 1) * (MULTI_SAMPLE_STEPS_MAX + 1))
#define MULTI_SAMPLE_TABLE 2048

struct multi_sample {
    int steps;
    double sun_exponent, base_intensity, half_width, falloff;
    bool faithful;
    char sun_map[DPL_PARAM_TEXT_SIZE];
};

/* All that does not change from texel to texel. */
struct multi_sample_plan {
    int lines; /* samples a side: steps + 1; a single one straight above where steps is 1 */
    float offsets[MULTI_SAMPLE_STEPS_MAX + 1]; /* of a sample along either axis, in widths of the map */
    struct multi_sample_ray {
        float direction[3]; /* unit vector from the floor to the water */
        float weight;
    } rays[MULTI_SAMPLE_COUNT_MAX];       /* row by row */
    float normal_keep;                    /* 1: the normal's height is weighted by 1 - τ³²; 0: it is kept whole */
    float power;                          /* of the finished sum, step 6 */
    float powers[MULTI_SAMPLE_TABLE + 2]; /* the same as a table, over sums from 0 to 1 */
    /* Brightness, base intensity included, by the squared cosine between the refracted ray and the sun, from
     * `table_start` to 1; below it the first entry holds. */
    float table_start;
    float table[MULTI_SAMPLE_TABLE];
};

struct multi_sample_state {
    struct multi_sample params; /* that the plan was made for */
    double depth;               /* likewise, bias included */
    bool planned;
    struct sun_map sun;
    struct multi_sample_plan plan;
    /* GPU */
    struct gpu_program normal_program, map_program;
    struct gpu_texture normals, table;
    /* CPU: unit normals, for each row its x, its y and its z, with half a width of mirror image on either side and one
     * texel more; room for one such row for each thread */
    struct normal_map normal_map;
    int side, threads;
    float *rows, *blended;
};

bool multi_sample_trace(void *state, const struct light_input *input, struct light_map *map);

/* Frees what multi_sample_trace() keeps between calls. */
void multi_sample_free_buffers(struct multi_sample_state *state);

/* Brings the plan up to date with the input, for one of its slices. */
bool multi_sample_prepare(struct multi_sample_state *state, const struct light_input *input, int slice);

#endif
