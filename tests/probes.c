/* Light probes: they stand for every vertex, are far fewer than the vertices, and give back light that is even, and
 * light that changes slowly, as it is. */
#include "support.h"

#include "render/probes.h"

static const char objects[] = "[object.rock]\nshape = rock\nposition = -1 0 0\nsize = 0.8 0.6 0.7\n"
                              "[object.box]\nshape = box\nposition = 1 0 0.5\nsize = 0.5 2 0.5\n"
                              "[object.ball]\nshape = sphere\nposition = 0 0 -1\nsize = 0.4 0.4 0.4\n"
                              "[object.weeds]\nshape = seaweed\nposition = 0.5 0 -1\ncount = 3\n";

struct fixture {
    struct support_log log;
    struct dpl_scene *scene;
    struct world world;
    struct probes probes;
    float *irradiance; /* of every vertex */
};

static void start(struct fixture *fixture)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->scene = support_scene(objects, log);
    assert_true(world_build(&fixture->world, fixture->scene, log));
    assert_true(probes_place(&fixture->probes, &fixture->world, log));
    fixture->irradiance = malloc((size_t)fixture->world.vertex_count * 3 * sizeof(float));
    assert_non_null(fixture->irradiance);
}

static void finish(struct fixture *fixture)
{
    free(fixture->irradiance);
    probes_finish(&fixture->probes);
    world_finish(&fixture->world);
    dpl_scene_destroy(fixture->scene);
    assert_int_equal(fixture->log.errors, 0);
}

/* How far the nearest probe of the part is that faces about the same way. */
static double nearest(const struct probes *probes, int part, const struct world_vertex *vertex)
{
    double least = INFINITY;
    for (int i = 0; i < probes->count; i++) {
        const struct probe *probe = probes->all + i;
        double square = 0, alike = 0;
        for (int c = 0; c < 3; c++) {
            square += pow((double)(probe->position[c] - vertex->position[c]), 2);
            alike += (double)(probe->normal[c] * vertex->normal[c]);
        }
        if (probe->part == part && alike > 0.7)
            least = fmin(least, sqrt(square));
    }
    return least;
}

/* In its cell, at most its diagonal away, each vertex has a probe that faces as it does. */
static void every_vertex_has_a_probe(void **state)
{
    (void)state;
    struct fixture fixture;
    start(&fixture);
    const struct world *world = &fixture.world;
    for (int p = 0; p < world->part_count; p++)
        for (int i = world->parts[p].first; i < world->parts[p].first + world->parts[p].count; i += 5)
            assert_true(nearest(&fixture.probes, p, world->vertices + world->indices[i]) <=
                        1.7321 * fixture.probes.spacing[p]);
    assert_true(fixture.probes.count < world->vertex_count / 2);
    assert_true(fixture.probes.count > 100 * world->part_count);
    finish(&fixture);
}

/* Weights that add up to 1, whatever they are, keep what is the same everywhere. */
static void even_light_stays_even(void **state)
{
    (void)state;
    struct fixture fixture;
    start(&fixture);
    for (int i = 0; i < fixture.probes.count; i++)
        for (int c = 0; c < 3; c++)
            fixture.probes.all[i].irradiance[c] = 0.5f + (float)c;
    probes_spread(&fixture.probes, &fixture.world, fixture.irradiance);
    for (int i = 0; i < fixture.world.index_count; i++)
        for (int c = 0; c < 3; c++)
            assert_true(fabsf(fixture.irradiance[3 * fixture.world.indices[i] + (unsigned)c] - 0.5f - (float)c) <
                        1e-4f);
    finish(&fixture);
}

/* Light that grows along x: a vertex has what it has, within a cell of the part. */
static void a_slope_stays(void **state)
{
    (void)state;
    struct fixture fixture;
    start(&fixture);
    const struct world *world = &fixture.world;
    for (int i = 0; i < fixture.probes.count; i++)
        fixture.probes.all[i].irradiance[0] = fixture.probes.all[i].position[0];
    probes_spread(&fixture.probes, world, fixture.irradiance);
    for (int p = 0; p < world->part_count; p++)
        for (int i = world->parts[p].first; i < world->parts[p].first + world->parts[p].count; i++) {
            unsigned v = world->indices[i];
            double off = (double)(fixture.irradiance[3 * v] - world->vertices[v].position[0]);
            assert_true(fabs(off) <= fixture.probes.spacing[p]);
        }
    finish(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_vertex_has_a_probe),
        cmocka_unit_test(even_light_stays_even),
        cmocka_unit_test(a_slope_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
