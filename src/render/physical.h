/* render/physical.h: what the passes of the physical look share.
 *
 * The order of a frame (look_physical.c draws it):
 *
 *     waves     the surface with smaller levels, for sight
 *     shadow    how high solids stand in the sun's way, above and below the surface;
 *               how low in the way of what the water throws up
 *     layers    solids and floor: straight; through the rest surface; mirrored in it
 *     shafts    the sun's light in the water along every sight, from an eye in it
 *     sea       the surface, which looks into the other two layers
 *     backdrop  where it is not: what is seen straight, and the sky or the open water behind
 *
 * Floor and surface are meshes of many small triangles. Their depth is drawn first, alone; what is seen there is then
 * computed once for each pixel, however many triangles share it. */
#ifndef RENDER_PHYSICAL_H
#define RENDER_PHYSICAL_H

#include "gpu/layer.h"
#include "optics/sky.h"
#include "render/rings.h"
#include "render/waves.h"
#include "scene/world.h"

/* Section [look.physical]. */
struct physical_settings {
    bool caustics, shafts;
};

enum physical_layer { LAYER_DIRECT, LAYER_THROUGH, LAYER_MIRROR, LAYERS };

/* Texture units, the same in every pass. */
enum physical_unit {
    UNIT_MAP,
    UNIT_REFLECTED,
    UNIT_SHADOW,
    UNIT_WAVES,
    UNIT_SKY,
    UNIT_RELIEF,
    UNIT_SAND,
    UNIT_AMBIENT,
    UNIT_NOISE = UNIT_AMBIENT,
    UNIT_SEA_DEPTH = UNIT_AMBIENT,
    UNIT_DIRECT_COLOR,
    UNIT_DIRECT_DEPTH,
    UNIT_THROUGH_COLOR,
    UNIT_THROUGH_DEPTH,
    UNIT_MIRROR_COLOR,
    UNIT_MIRROR_DEPTH,
    UNIT_SHAFTS,
    UNIT_SEABED_DEPTH = UNIT_SHAFTS,
    UNIT_SHADOW_THROWN,
    PHYSICAL_UNITS,
};
_Static_assert(PHYSICAL_UNITS <= GPU_TEXTURE_UNITS, "a unit for each");

/* The light of the scene in numbers; what render/volume.glsl and render/receiver.glsl get. */
struct physical_light {
    double to_sun[3], sun_way[3];      /* unit vectors */
    double sun[3], sun_below[3];       /* irradiance across the sun's rays, in the air and just below flat water */
    double sun_reflected[3];           /* on a ceiling, of what flat water throws back */
    double sun_spread;                 /* radians */
    double side_way[2][3], side[2][3]; /* the sun's light in a tank from the panes across x and z, and its irradiance
                                          across that way; 0: none comes in there */
    double glass;                      /* m, half a side of the tank; 0: it is none */
    double diffuse_below[3];           /* irradiance from all around on a horizontal surface just below */
    double absorption[3], scattering[3], extinction[3], anisotropy;
    double floor_radiance[3]; /* of the flat floor under flat water */
};

/* How much work a picture is worth. */
struct quality {
    int shadow_side, shadow_taps;
    int shaft_steps, shaft_share;       /* share: the picture of shafts has its sides divided by it */
    double through_scale, mirror_scale; /* of these layers' sides to the picture's */
    int ambient_rays, look_ups;
};

struct sky_texture {
    struct gpu_texture texels;
    double ground[3];     /* radiance below the horizon */
    uint64_t fingerprint; /* of the sky that is in it */
};

struct shadow {
    struct gpu_program cast;
    struct gpu_layer map, thrown; /* for light from the sun, and for what the water throws up: 1 × 1 without that */
    double square[4], thrown_square[4], span[2]; /* as in render/shadow.glsl */
};

/* Dry, wet, and wet in a tank, which its panes light too. */
enum solid_kind { SOLID_DRY, SOLID_WET, SOLID_IN_TANK, SOLID_KINDS };

struct solids {
    struct gpu_program programs[SOLID_KINDS];
    GLuint array, vertices, ambient, indices;
    uint64_t fingerprint; /* of the world that is in the buffers */
    struct part_extent {
        float low, high; /* m, of its vertices */
        float edge;      /* m, its longest */
    } * extents;         /* of each part */
    struct dry_box {
        uint64_t fingerprint; /* of the world */
        double level;         /* m, below which nothing ever stands out of the water */
        double low[3], high[3];
    } dry;
};

enum seabed_kind { SEABED_SAND, SEABED_PATTERN, SEABED_KINDS };

struct seabed {
    struct gpu_program mesh, programs[2][SEABED_KINDS]; /* of open water, of a tank */
    struct gpu_texture relief, ambient;
    double ambient_square[3]; /* m: least x and z, side */
    uint64_t fingerprint;
};

struct shafts {
    struct gpu_program program, smooth_program;
    struct gpu_texture raw, smooth, noise;
};

/* From above, with and without anything above the water to mirror; from below; through a pane. */
enum sea_kind { SEA_ABOVE, SEA_MIRRORING, SEA_BELOW, SEA_PANE, SEA_KINDS };

/* How the eye sees the water. */
struct sight {
    double side;     /* of the rest surface that a sight is on when it meets it: 1 above, -1 below */
    double plane[4]; /* unit normal towards the eye, and distance from the origin, of the plane between air and water */
    double plane_index; /* refractive index beyond it to that before it */
    bool pane;          /* the plane is a tank's pane, and the eye outside */
    bool line;          /* the lens is half in the water: this is one of two sights */
    bool beside;        /* of what others have drawn only what is seen through its pane changes */
    double mirrors[2];  /* m from pane to pane of a tank along x and z, where they mirror what is in it; 0: not */
};

#define SIGHTS_MAX 3

/* The sights that a picture needs, one at least, in the order of drawing; returns how many. */
int sight_find(const struct frame *frame, struct sight sights[SIGHTS_MAX]);

/* The look's state. All zero at first. */
struct physical {
    struct optics_sky sky;
    struct sky_texture sky_texture;
    struct world world;
    struct ambient_key {
        uint64_t world, sky; /* fingerprints */
        struct water_medium medium;
        struct scene_settings settings;
        struct scene_floor floor;
        int rays;
    } ambient; /* what the light from all around was last traced for */
    struct waves waves;
    struct rings rings;
    struct shadow shadow;
    struct solids solids;
    struct seabed seabed;
    struct shafts shafts;
    struct gpu_layer layers[LAYERS];
    struct gpu_layer mesh;           /* depth of the mesh that is drawn now: of the floor, or of the surface */
    struct gpu_program backdrops[2]; /* with no pane before the water, and with one */
    struct gpu_program sea_mesh, seas[SEA_KINDS];

    /* Of this frame: */
    struct physical_light light;
    struct quality quality;
    struct sight sight; /* that is drawn now */
    bool has_shafts;
};

/* Sets every uniform and texture that more than one pass uses, in the program in use. */
void physical_bind(const struct physical *physical, const struct frame *frame, const struct gpu_program *program);

/* Of these, what draws solids into the map of shadows. */
void physical_bind_cast(const struct physical *physical, const struct frame *frame, const struct gpu_program *program);

/* The layers, and the light shafts, once they are drawn. */
void physical_bind_layers(const struct physical *physical, const struct frame *frame,
                          const struct gpu_program *program);

/* Begins to draw the depth of a mesh in a picture of that size. */
void physical_begin_mesh(const struct physical *physical, struct dpl_gl *gl, int width, int height);

/* The light of the scene, from its sky. */
struct physical_light physical_light(const struct optics_sky *sky, const struct frame *frame);

bool sky_texture_update(struct sky_texture *texture, struct dpl_gl *gl, const struct optics_sky *sky);

bool shadow_prepare(struct shadow *shadow, const struct frame *frame, const struct physical *physical);
void shadow_draw(struct shadow *shadow, const struct frame *frame, const struct physical *physical);
void shadow_finish(struct shadow *shadow, struct dpl_gl *gl);

/* Solids: `ambient` is the irradiance from all around at each vertex. */
bool solids_prepare(struct solids *solids, struct dpl_gl *gl, const struct physical *physical);
bool solids_upload(struct solids *solids, struct dpl_gl *gl, const struct world *world, const float *ambient);
/* Draws what is in the water (wet), or what is not, into a layer. */
void solids_draw(const struct physical *physical, const struct frame *frame, enum physical_layer layer, bool wet);
/* All parts that cast shadows from above the rest surface, or from below it, with that program, which is in use. */
void solids_cast(const struct solids *solids, struct dpl_gl *gl, const struct world *world,
                 const struct gpu_program *program, bool above);
/* Finds the box around what may stand out of the water. */
void solids_find_dry(struct solids *solids, const struct frame *frame, const struct world *world, double reach);
void solids_finish(struct solids *solids, struct dpl_gl *gl);

bool seabed_prepare(struct seabed *seabed, const struct frame *frame, const struct physical *physical);
void seabed_draw(const struct physical *physical, const struct frame *frame, enum physical_layer layer);
void seabed_finish(struct seabed *seabed, struct dpl_gl *gl);

bool shafts_prepare(struct shafts *shafts, const struct frame *frame, const struct quality *quality);
void shafts_draw(struct physical *physical, const struct frame *frame);
void shafts_finish(struct shafts *shafts, struct dpl_gl *gl);

/* What solids and floor get from all around, into their buffers, where world or light have changed. */
bool ambient_update(struct physical *physical, const struct frame *frame);

#endif
