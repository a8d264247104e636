/* Every technique on every water: what is true of all pairs that the lists hold. */
#include "support.h"

#include "light/light.h"
#include "scene/scene.h"

#include <math.h>

#define MAP 48

struct fixture {
    char folder[64], file[96]; /* a picture for the model that reads one */
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_folder_make(fixture->folder);
    snprintf(fixture->file, sizeof fixture->file, "%s/heights.pfm", fixture->folder);
    support_heights_write(fixture->file);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

/* Every model at its defaults, with waves where it needs them. */
static struct dpl_scene *make_scene(const struct fixture *fixture, const char *model)
{
    struct dpl_scene *scene = support_scene("[caustics]\nmesh = 48\n[wave.1]\ncycles = 2 1\namplitude = 0.03\n", NULL);
    support_set(scene, "water.model", "%s", model);
    support_set(scene, "heightfield.file", "%s", fixture->file);
    support_set(scene, "heightfield.scale", "0.1");
    support_set(scene, "caustics.map", "%d", MAP);
    return scene;
}

static struct dpl_image *make_map(struct dpl_scene *scene, struct dpl_renderer *renderer, const char *technique)
{
    support_set(scene, "caustics.technique", "%s", technique);
    struct dpl_image *map = dpl_renderer_map(renderer, scene, 1.5);
    if (!map)
        fail_msg("%s makes no map", technique);
    return map;
}

/* The mean of the green channel of a map that is finite and not the same everywhere. */
static double mean_of(struct dpl_image *map, const char *technique, const char *model)
{
    double sum = 0, least = INFINITY, most = -INFINITY;
    for (int i = 0; i < MAP * MAP; i++) {
        for (int c = 0; c < 3; c++)
            if (!isfinite(map->pixels[i * 3 + c]))
                fail_msg("%s on %s: %g in texel %d", technique, model, (double)map->pixels[i * 3 + c], i);
        double light = (double)map->pixels[i * 3 + 1];
        least = fmin(least, light);
        most = fmax(most, light);
        sum += light;
    }
    if (!(least >= 0 && most - least > 0.01 * most))
        fail_msg("%s on %s: light from %g to %g", technique, model, least, most);
    dpl_image_destroy(map);
    return sum / (MAP * MAP);
}

/* A technique's mean is the reference's: no light is lost or made, but for what the technique says. */
static void check_energy(const struct light_technique *technique, const char *model, double mean, double wanted)
{
    const double noise = 0.002; /* of the reference's mean */
    if (technique->physical && !(fabs(mean / wanted - 1) <= technique->energy + noise))
        fail_msg("%s on %s: mean %g, reference %g", technique->name, model, mean, wanted);
}

static void check_every(struct fixture *fixture, struct dpl_gl *gl, enum dpl_device device)
{
    for (int w = 0; water_models[w]; w++) {
        const char *model = water_models[w]->name;
        struct dpl_scene *scene = make_scene(fixture, model);
        struct dpl_renderer *renderer = dpl_renderer_create(gl, device, NULL);
        struct wave waves[WATER_WAVES_MAX];
        const struct water_setup setup = scene_water_setup(scene, waves);
        bool periodic = water_models[w]->shape(&setup).periodic;
        double wanted = mean_of(make_map(scene, renderer, "reference"), "reference", model);
        for (int t = 0; light_techniques[t]; t++) {
            const char *name = light_techniques[t]->name;
            double mean = mean_of(make_map(scene, renderer, name), name, model);
            if (periodic)
                check_energy(light_techniques[t], model, mean, wanted);
        }
        dpl_renderer_destroy(renderer);
        dpl_scene_destroy(scene);
    }
}

static void every_technique_on_every_water_on_the_cpu(void **state)
{
    check_every(*state, NULL, DPL_DEVICE_CPU);
}

static void every_technique_on_every_water_through_opengl(void **state)
{
    for (int es = 0; es < 2; es++) {
        struct dpl_gl *gl = support_gl(es, NULL);
        check_every(*state, gl, DPL_DEVICE_GL);
        dpl_gl_destroy(gl);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_technique_on_every_water_on_the_cpu, setup, teardown),
        cmocka_unit_test_setup_teardown(every_technique_on_every_water_through_opengl, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
