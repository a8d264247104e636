#include "render/thumbnail.h"

#include "light/map_texture.h"

#define SIDE 256 /* texels */

static const struct ray_window whole[] = {{-0.5, -0.5, 1}, {-0.5, -0.5, 1}}; /* of a map, whatever it shows */
static const char *const names[THUMBNAILS] = {"normals", "caustic map", "compared with"};

struct dpl_thumbnail thumbnails_draw(struct dpl_gl *gl, struct thumbnails *thumbnails, int index,
                                     const struct surface_gpu *surface, const struct gpu_texture *map,
                                     const struct gpu_texture *other)
{
    int count = other ? THUMBNAILS : THUMBNAILS - 1;
    if (index < 0 || index >= count || !program_ready(gl, &thumbnails->program, "render/thumbnail.glsl", ""))
        return (struct dpl_thumbnail){0};
    struct gpu_texture *texture = thumbnails->textures + index;
    texture_resize(gl, texture, GL_RGBA8, SIDE, SIDE, TEXTURE_CLAMP, TEXTURE_LINEAR);
    texture_draw_to(gl, texture);
    program_use(gl, &thumbnails->program);
    surface_gpu_bind(gl, surface, &thumbnails->program, 0);
    map_texture_bind(gl, index == 2 ? other : map, whole, 1, &thumbnails->program, 1);
    program_int(gl, &thumbnails->program, "subject", index);
    gpu_draw_screen(gl);
    return (struct dpl_thumbnail){names[index], texture->name, SIDE, SIDE};
}

void thumbnails_finish(struct dpl_gl *gl, struct thumbnails *thumbnails)
{
    program_finish(gl, &thumbnails->program);
    for (int i = 0; i < THUMBNAILS; i++)
        texture_finish(gl, thumbnails->textures + i);
}
