/* tests/reference.h: a photon tracer and what it is asked for. */
#ifndef TESTS_REFERENCE_H
#define TESTS_REFERENCE_H

#include "support.h"

#include "reference/photons.h"

#include <math.h>

#define SIDE_MAX 64
#define SIZE 2.0 /* m */

struct fixture {
    struct wave waves[3];
    struct water_setup setup;
    struct optics_sun sun;
    struct water_medium medium;
    double receivers[16];
    struct photons_task task;
    struct photons photons;
    float map[SIDE_MAX * SIDE_MAX * 3];
};

static inline int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->setup = (struct water_setup){.size = SIZE, .depth = 1, .waves = fixture->waves};
    fixture->sun = (struct optics_sun){.elevation = 60, .azimuth = 30, .angular_radius = 0.2665};
    fixture->medium = (struct water_medium){.ior = 1.333, .dispersion = 0, .absorption = {0.35, 0.07, 0.03}};
    fixture->receivers[0] = -1;
    fixture->task = (struct photons_task){.model = water_models[0],
                                          .setup = &fixture->setup,
                                          .sun = &fixture->sun,
                                          .medium = &fixture->medium,
                                          .receivers = fixture->receivers,
                                          .receiver_count = 1,
                                          .side = 16};
    *state = fixture;
    return 0;
}

static inline int teardown(void **state)
{
    struct fixture *fixture = *state;
    photons_finish(&fixture->photons);
    free(fixture);
    return 0;
}

static inline void trace(struct fixture *fixture, int passes)
{
    assert_true(photons_begin(&fixture->photons, &fixture->task, NULL));
    for (int i = 0; i < passes; i++)
        photons_pass(&fixture->photons, &fixture->task);
}

/* Reads the map of a receiver; mean of a channel over all of it. */
static inline double read_mean(struct fixture *fixture, int receiver, int color)
{
    int side = fixture->task.side;
    double sum = 0;
    photons_read(&fixture->photons, receiver, fixture->map);
    for (int i = 0; i < side * side; i++) {
        assert_true(isfinite(fixture->map[3 * i + color]) && fixture->map[3 * i + color] >= 0);
        sum += (double)fixture->map[3 * i + color];
    }
    return sum / (side * side);
}

#endif
