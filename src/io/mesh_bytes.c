#include "io/mesh_parts.h"

#include "base/log.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char *const endings[] = {".obj", ".gltf", ".glb", ".ply", ".stl", NULL};

const char *mesh_ending(const char *path, const struct dpl_log *log)
{
    const char *ending = strrchr(path, '.');
    for (int i = 0; ending && endings[i]; i++)
        if (!strcasecmp(ending, endings[i]))
            return endings[i];
    base_fail(log, DPL_REASON_FILE_FORMAT,
              "%s: no mesh format has the ending \"%s\" (accepted: .obj, .gltf, .glb, .ply, .stl)", path,
              ending ? ending : "");
    return NULL;
}

/* A vertex at the start of a line, and nothing but text. */
static bool is_obj(const char *bytes, size_t length)
{
    return strlen(bytes) == length && (!strncmp(bytes, "v ", 2) || strstr(bytes, "\nv "));
}

/* Text, or 80 bytes, a number of triangles, and 50 bytes for each. */
static bool is_stl(const char *bytes, size_t length)
{
    bool binary = length >= 84 && length == 84 + (uint64_t)50 * mesh_little_endian(bytes + 80);
    return binary || (!strncmp(bytes, "solid", 5) && strlen(bytes) == length && strstr(bytes, "endsolid"));
}

bool mesh_bytes_are_sound(const char *ending, const char *bytes, size_t length, const char *path,
                          const struct dpl_log *log)
{
    if (length == 0)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: is empty (accepted: a mesh)", path);
    if (!strcmp(ending, ".gltf"))
        return mesh_gltf_is_sound(bytes, length, path, log);
    if (!strcmp(ending, ".glb"))
        return mesh_glb_is_sound(bytes, length, path, log);
    if (!strcmp(ending, ".ply"))
        return mesh_ply_is_sound(bytes, length, path, log);
    if (!strcmp(ending, ".obj"))
        return is_obj(bytes, length) ||
               base_fail(log, DPL_REASON_FILE_FORMAT, "%s: no OBJ: text with lines \"v x y z\" is wanted", path);
    return is_stl(bytes, length) ||
           base_fail(log, DPL_REASON_FILE_FORMAT,
                     "%s: no STL, or cut short (accepted: \"solid\" … \"endsolid\", or 84 bytes and 50 a triangle)",
                     path);
}
