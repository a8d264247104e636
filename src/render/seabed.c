/* The floor, from below the eye to the horizon. */
#include "render/physical.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

#define FARTHEST 4.0 /* radius of the last ring, in far planes: beyond what the picture shows */

/* Heights and slopes of the relief as a texture. */
static bool upload_relief(struct seabed *seabed, const struct frame *frame, const struct world *world)
{
    struct dpl_gl *gl = frame->gl;
    double size = frame->scene->settings.size;
    int side = world->relief_side > 0 ? world->relief_side : 1;
    float *texels = base_allocate(gl->log, (size_t)side * (size_t)side * 4, sizeof *texels, "relief of the floor");
    if (!texels)
        return false;
    for (int j = 0; j < side && world->relief_side > 0; j++) {
        for (int i = 0; i < side; i++) {
            double place[3];
            world_floor(world, size, (i + 0.5) / side * size - size / 2, (j + 0.5) / side * size - size / 2, place);
            for (int c = 0; c < 3; c++)
                texels[4 * ((size_t)j * (size_t)side + (size_t)i) + (size_t)c] = (float)place[c];
        }
    }
    texture_resize(gl, &seabed->relief, GL_RGBA16F, side, side, TEXTURE_REPEAT, TEXTURE_MIPMAP);
    texture_upload(gl, &seabed->relief, texels);
    texture_make_mipmaps(gl, &seabed->relief);
    free(texels);
    return true;
}

static int in_tank(const struct physical *physical)
{
    return physical->light.glass > 0;
}

bool seabed_prepare(struct seabed *seabed, const struct frame *frame, const struct physical *physical)
{
    static const char *const defines[2][SEABED_KINDS] = {
        {"#define WET\n#define ON_FLOOR\n", "#define WET\n#define ON_FLOOR\n#define PATTERN\n"},
        {"#define WET\n#define TANK\n#define ON_FLOOR\n",
         "#define WET\n#define TANK\n#define ON_FLOOR\n#define PATTERN\n"}};
    const struct world *world = &physical->world;
    int tank = in_tank(physical);
    if (!program_ready(frame->gl, &seabed->mesh, "render/seabed_mesh.glsl", ""))
        return false;
    for (int i = 0; i < SEABED_KINDS; i++)
        if (!program_ready(frame->gl, seabed->programs[tank] + i, "render/seabed.glsl", defines[tank][i]))
            return false;
    if (seabed->relief.name && seabed->fingerprint == world->fingerprint)
        return true;
    seabed->fingerprint = 0;
    if (!upload_relief(seabed, frame, world))
        return false;
    seabed->fingerprint = world->fingerprint;
    return true;
}

static void draw_mesh(const struct physical *physical, const struct frame *frame, enum physical_layer layer)
{
    struct dpl_gl *gl = frame->gl;
    const struct gpu_program *program = &physical->seabed.mesh;
    double height = frame->camera->position[1] + frame->scene->settings.depth;
    physical_begin_mesh(physical, gl, physical->layers[layer].depth.width, physical->layers[layer].depth.height);
    program_use(gl, program);
    physical_bind(physical, frame, program);
    program_int(gl, program, "layer", (int)layer);
    rings_draw(&physical->rings, frame, program, height, fmin(frame->camera->far_plane, 1000) * FARTHEST,
               waves_extent(frame));
}

void seabed_draw(const struct physical *physical, const struct frame *frame, enum physical_layer layer)
{
    struct dpl_gl *gl = frame->gl;
    const struct dpl_scene *scene = frame->scene;
    enum seabed_kind kind = scene->floor.pattern == WORLD_PLAIN ? SEABED_SAND : SEABED_PATTERN;
    const struct gpu_program *program = physical->seabed.programs[in_tank(physical)] + kind;
    draw_mesh(physical, frame, layer);
    layer_resume(gl, physical->layers + layer);
    program_use(gl, program);
    physical_bind(physical, frame, program);
    program_int(gl, program, "layer", (int)layer);
    program_int(gl, program, "pattern", scene->floor.pattern);
    program_float(gl, program, "pattern_size", scene->floor.pattern_size);
    program_vec3(gl, program, "pattern_joint", scene->floor.joint);
    program_vec3(gl, program, "floor_color", scene->floor.color);
    texture_bind(gl, &physical->mesh.depth, UNIT_SEABED_DEPTH);
    program_int(gl, program, "mesh_depth", UNIT_SEABED_DEPTH);
    gpu_draw_screen(gl);
}

void seabed_finish(struct seabed *seabed, struct dpl_gl *gl)
{
    program_finish(gl, &seabed->mesh);
    for (int i = 0; i < SEABED_KINDS; i++) {
        program_finish(gl, seabed->programs[0] + i);
        program_finish(gl, seabed->programs[1] + i);
    }
    texture_finish(gl, &seabed->relief);
    texture_finish(gl, &seabed->ambient);
}
