#include "render/physical.h"

#include "light/map_texture.h"
#include "optics/phase.h"
#include "optics/refraction.h"
#include "optics/water_types.h"
#include "scene/sway.h"

#include <math.h>

#define DIFFUSE_ENTERS 0.934 /* share of light from all around that flat water lets in (Preisendorfer 1976) */
#define DIFFUSE_SLANT 1.2    /* m of its way for each m of depth (Gordon 1989: the inverse of its mean cosine) */
#define BENDING 0.25         /* of a wave's slope: how far it turns the light that enters, 1 - 1 / index */

static const double degree = M_PI / 180;

static void scatter(struct physical_light *light, const struct water_medium *medium)
{
    struct optics_water water = water_optics(medium);
    light->anisotropy = water.anisotropy;
    for (int c = 0; c < 3; c++) {
        double rest = water.scattering[c] * (1 - water.anisotropy * water.anisotropy);
        light->absorption[c] = water.absorption[c];
        light->scattering[c] = water.scattering[c];
        light->extinction[c] = water.absorption[c] + rest;
    }
}

/* Light that comes into a tank through its panes. */
static void find_sides(struct physical_light *light, const struct frame *frame)
{
    double ior = frame->scene->medium.ior;
    light->glass = frame->scene->settings.edge == SCENE_EDGE_GLASS ? waves_extent(frame) : 0;
    for (int i = 0; i < 2 && light->glass > 0; i++) {
        double normal[3] = {0}, cosine = fabs(light->to_sun[2 * i]);
        normal[2 * i] = copysign(1, light->to_sun[2 * i]);
        optics_refract(light->to_sun, normal, ior, light->side_way[i]);
        double share = (1 - optics_fresnel_reflectance(cosine, ior)) * cosine / fabs(light->side_way[i][2 * i]);
        for (int c = 0; c < 3; c++)
            light->side[i][c] = light->sun[c] * share;
    }
}

struct physical_light physical_light(const struct optics_sky *sky, const struct frame *frame)
{
    static const double up[3] = {0, 1, 0};
    const struct dpl_scene *scene = frame->scene;
    struct physical_light light = {.sun_spread = 0.5 * fmax(scene->sun.angular_radius, 0.01) * degree};
    optics_sun_direction(&scene->sun, light.to_sun);
    optics_refract(light.to_sun, up, scene->medium.ior, light.sun_way);
    scatter(&light, &scene->medium);
    double backward = optics_phase_backward(light.anisotropy);
    double height = light.to_sun[1], share = optics_fresnel_reflectance(height, scene->medium.ior);
    for (int c = 0; c < 3; c++) {
        light.sun[c] = sky->sun[c];
        light.sun_reflected[c] = sky->sun[c] * height * share;
        light.sun_below[c] = sky->sun[c] * height * (1 - share) / -light.sun_way[1];
        light.diffuse_below[c] = sky->irradiance[c] * DIFFUSE_ENTERS;
        /* what is scattered forwards still comes to the floor */
        double lost = scene->settings.depth * (light.absorption[c] + light.scattering[c] * backward);
        double below = light.sun_below[c] * -light.sun_way[1] * exp(lost / light.sun_way[1]) +
                       light.diffuse_below[c] * exp(-lost * DIFFUSE_SLANT);
        light.floor_radiance[c] = scene->floor.color[c] / M_PI * below;
    }
    find_sides(&light, frame);
    return light;
}

static void bind_sight(const struct physical *physical, const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    const struct scene_camera *camera = frame->camera;
    const struct sight *sight = &physical->sight;
    const float plane[4] = {(float)sight->plane[0], (float)sight->plane[1], (float)sight->plane[2],
                            (float)sight->plane[3]};
    program_mat4(gl, program, "view_projection", frame->view_projection);
    program_vec3(gl, program, "eye", camera->position);
    program_vec3(gl, program, "ahead", frame->rays.ahead);
    program_vec3(gl, program, "right", frame->rays.right);
    program_vec3(gl, program, "up", frame->rays.up);
    program_vec2(gl, program, "planes", camera->near_plane, camera->far_plane);
    program_vec2(gl, program, "corner", frame->view.left, frame->view.bottom);
    program_float(gl, program, "ior", frame->scene->medium.ior);
    program_float(gl, program, "side", sight->side);
    program_vec4s(gl, program, "plane", 1, plane);
    program_float(gl, program, "plane_index", sight->plane_index);
    program_int(gl, program, "pane", sight->pane);
    program_int(gl, program, "line_there", sight->line);
    program_int(gl, program, "beside", sight->beside);
    program_vec2(gl, program, "mirrors", sight->mirrors[0], sight->mirrors[1]);
}

static void bind_light(const struct physical *physical, const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    const struct physical_light *light = &physical->light;
    program_vec3(gl, program, "to_sun", light->to_sun);
    program_vec3(gl, program, "sun_way", light->sun_way);
    program_vec3(gl, program, "sun_irradiance", light->sun);
    program_vec3(gl, program, "sun_below", light->sun_below);
    program_vec3(gl, program, "sun_reflected", light->sun_reflected);
    program_float(gl, program, "sun_spread", light->sun_spread);
    program_float(gl, program, "glass", light->glass);
    program_vec3(gl, program, "side_way_x", light->side_way[0]);
    program_vec3(gl, program, "side_way_z", light->side_way[1]);
    program_vec3(gl, program, "side_light_x", light->side[0]);
    program_vec3(gl, program, "side_light_z", light->side[1]);
    program_vec3(gl, program, "diffuse_below", light->diffuse_below);
    program_vec3(gl, program, "absorption", light->absorption);
    program_vec3(gl, program, "extinction", light->extinction);
    program_vec3(gl, program, "scattering", light->scattering);
    program_float(gl, program, "anisotropy", light->anisotropy);
    program_float(gl, program, "diffuse_slant", DIFFUSE_SLANT);
    program_vec3(gl, program, "floor_radiance", light->floor_radiance);
    program_vec3(gl, program, "ground_radiance", physical->sky_texture.ground);
    texture_bind(gl, &physical->sky_texture.texels, UNIT_SKY);
    program_int(gl, program, "sky_texels", UNIT_SKY);
}

static void bind_maps(const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    const struct dpl_scene *scene = frame->scene;
    const struct physical_settings *settings = frame->params;
    const struct gpu_texture *reflected = frame->reflected ? frame->reflected : frame->map;
    program_float(gl, program, "tile_size", scene->settings.size);
    program_float(gl, program, "tile_depth", fmax(scene->settings.depth, 1e-3));
    program_float(gl, program, "tile_floor", -scene->settings.depth);
    program_int(gl, program, "caustics", settings->caustics);
    map_texture_bind(gl, frame->map, frame->windows, scene->settings.size, program, UNIT_MAP);
    map_texture_bind_reflected(gl, reflected, frame->reflected_windows, scene->settings.size, program, UNIT_REFLECTED);
    program_float(gl, program, "reflected_height", frame->reflected ? scene->caustics.reflected_height : 0);
}

static void bind_shadow(const struct physical *physical, const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    const struct shadow *shadow = &physical->shadow;
    /* m that light is spread for each metre of height */
    double disc = 2 * physical->light.sun_spread / physical->light.to_sun[1];
    double bent = BENDING * physical->waves.slope;
    float square[4], thrown[4];
    for (int i = 0; i < 4; i++) {
        square[i] = (float)shadow->square[i];
        thrown[i] = (float)shadow->thrown_square[i];
    }
    program_vec4s(gl, program, "shadow_square", 1, square);
    program_vec4s(gl, program, "shadow_thrown_square", 1, thrown);
    program_vec2(gl, program, "shadow_span", shadow->span[0], shadow->span[1]);
    program_float(gl, program, "shadow_disc", disc);
    program_float(gl, program, "shadow_waves", fmax(disc, bent));
    program_int(gl, program, "shadow_taps", physical->quality.shadow_taps);
    texture_bind(gl, &shadow->map.depth, UNIT_SHADOW);
    program_int(gl, program, "shadow_heights", UNIT_SHADOW);
    texture_bind(gl, &shadow->thrown.depth, UNIT_SHADOW_THROWN);
    program_int(gl, program, "shadow_thrown_heights", UNIT_SHADOW_THROWN);
}

/* Where the water carries what sways in it. */
static void bind_sway(const struct frame *frame, const struct gpu_program *program)
{
    struct sway sway;
    sway_now(frame->scene, frame->time, &sway);
    program_vec4s(frame->gl, program, "sway_waves", SWAY_WAVES, sway.waves[0]);
    program_vec4s(frame->gl, program, "sway_current", 1, sway.current);
}

static void bind_floor(const struct physical *physical, const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    const struct seabed *seabed = &physical->seabed;
    program_float(gl, program, "relief_size", frame->scene->settings.size);
    program_vec3(gl, program, "ambient_square", seabed->ambient_square);
    texture_bind(gl, &seabed->relief, UNIT_RELIEF);
    program_int(gl, program, "relief_texels", UNIT_RELIEF);
    texture_bind(gl, &seabed->ambient, UNIT_AMBIENT);
    program_int(gl, program, "floor_ambient", UNIT_AMBIENT);
    texture_bind(gl, frame->sand, UNIT_SAND);
    program_int(gl, program, "sand", UNIT_SAND);
}

void physical_bind_cast(const struct physical *physical, const struct frame *frame, const struct gpu_program *program)
{
    bind_shadow(physical, frame, program);
    bind_sway(frame, program);
}

void physical_bind(const struct physical *physical, const struct frame *frame, const struct gpu_program *program)
{
    bind_sight(physical, frame, program);
    bind_light(physical, frame, program);
    bind_maps(frame, program);
    physical_bind_cast(physical, frame, program);
    bind_floor(physical, frame, program);
    waves_bind(&physical->waves, frame, program, UNIT_WAVES);
}

void physical_begin_mesh(const struct physical *physical, struct dpl_gl *gl, int width, int height)
{
    layer_begin(gl, &physical->mesh);
    gl->Viewport(0, 0, width, height);
}

void physical_bind_layers(const struct physical *physical, const struct frame *frame, const struct gpu_program *program)
{
    static const char *const names[LAYERS][2] = {
        {"direct_color", "direct_depth"}, {"through_color", "through_depth"}, {"mirror_color", "mirror_depth"}};
    struct dpl_gl *gl = frame->gl;
    for (int i = 0; i < LAYERS; i++) {
        int unit = UNIT_DIRECT_COLOR + 2 * i;
        texture_bind(gl, &physical->layers[i].color, (GLenum)unit);
        texture_bind(gl, &physical->layers[i].depth, (GLenum)unit + 1);
        program_int(gl, program, names[i][0], unit);
        program_int(gl, program, names[i][1], unit + 1);
    }
    texture_bind(gl, &physical->shafts.smooth, UNIT_SHAFTS);
    program_int(gl, program, "shafts_texels", UNIT_SHAFTS);
    program_int(gl, program, "shafts", physical->has_shafts);
}
