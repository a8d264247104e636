/* tests/world.h: what tests of the world's triangles share: a scene, and the world that is built of it. */
#ifndef TESTS_WORLD_H
#define TESTS_WORLD_H

#include "support.h"

#include "scene/sway.h"
#include "scene/world.h"

struct fixture {
    struct support_log log;
    struct dpl_scene *scene;
    struct world world;
    char folder[64];
};

/* Where the water has carried a vertex at that time, m from its place at rest. */
static inline void world_sway(const struct dpl_scene *scene, const struct world_vertex *vertex, double time,
                              float moved[3])
{
    struct sway sway;
    sway_now(scene, time, &sway);
    sway_move(&sway, vertex->position, vertex->sway, moved);
}

static inline int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->scene = dpl_scene_create(support_log_start(&fixture->log));
    support_folder_make(fixture->folder);
    *state = fixture;
    return 0;
}

static inline int teardown(void **state)
{
    struct fixture *fixture = *state;
    world_finish(&fixture->world);
    dpl_scene_destroy(fixture->scene);
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static inline void build(struct fixture *fixture)
{
    if (!world_build(&fixture->world, fixture->scene, &fixture->log.log))
        fail_msg("%s", fixture->log.text);
}

static inline void expect_near(double found, double wanted, double tolerance)
{
    if (!(fabs(found - wanted) <= tolerance))
        fail_msg("%.9g, not %.9g", found, wanted);
}

#endif
