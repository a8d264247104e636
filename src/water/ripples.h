/* water/ripples.h: the parts of the model `ripples` as they see each other. */
#ifndef WATER_RIPPLES_H
#define WATER_RIPPLES_H

#include "gpu/program.h"
#include "water/ripples_tank.h"

#include <stdint.h>

enum ripples_speed { RIPPLES_DEMO, RIPPLES_DEPTH, RIPPLES_GIVEN };
enum ripples_device { RIPPLES_CPU, RIPPLES_GPU };

/* Section [ripples]. */
struct ripples {
    int side; /* vertices */
    double damping;
    int speed;         /* enum ripples_speed */
    double wave_speed; /* m/s */
    int drops;
    double drop_radius; /* sides of the pool */
    double drop_height; /* half sides of the pool */
    double rain;        /* 1/s */
    int device;         /* enum ripples_device */
};

#define RIPPLES_NUMBERS 11     /* of the scene, that all of the water's past depends on */
#define RIPPLES_EVENTS_MAX 128 /* between two frames; after more of them the GPU is given the CPU's water */

/* The GPU's copy of the water. */
struct ripples_gpu {
    struct gpu_texture water[2]; /* height and speed; the first is now, the second was a step ago */
    struct gpu_texture heights;  /* those shown, from the CPU */
    struct gpu_program event, surface;
    int64_t frame; /* that `water` is of; 0: none */
    float *upload;
    int upload_side;
};

/* What is kept between frames. */
struct ripples_state {
    double scene[RIPPLES_NUMBERS]; /* that the water was made with */
    double rate;                   /* steps a second */
    int64_t steps;                 /* since time 0 */
    int64_t life;                  /* steps that a wave lives */
    int64_t next_change;
    struct tank tank, next_tank; /* next_tank takes over in time; see ripples_prepare.c */
    bool next_started;
    float *shown;                                    /* heights at the time that was asked for */
    double lag;                                      /* steps that it is behind `tank` */
    struct ball start, ball, placed;                 /* at time 0, now, and where the scene had it last */
    double velocity[3];                              /* m/s */
    int64_t ticks;                                   /* of the ball */
    int64_t rain;                                    /* drops that have fallen */
    int64_t frame;                                   /* counts calls of prepare() */
    struct ripples_event events[RIPPLES_EVENTS_MAX]; /* of the last of them */
    int event_count;                                 /* RIPPLES_EVENTS_MAX + 1: too many, or other water */
    struct ripples_gpu gpu;
};

/* Brings the water to a time; see water.h. */
bool ripples_prepare(void *state, const struct water_setup *setup, double time, const struct dpl_log *log);

/* The surface as a texture, from the GPU's copy or from the CPU. */
bool ripples_draw(void *state, struct dpl_gl *gl, const struct water_setup *setup, double time,
                  struct gpu_texture *texels, struct gpu_texture *shifts);

/* gl is NULL where there is no OpenGL. */
void ripples_gpu_finish(struct ripples_gpu *gpu, struct dpl_gl *gl);

#endif
