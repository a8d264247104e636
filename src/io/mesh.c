#include "io/mesh.h"

#include "base/file.h"
#include "base/log.h"
#include "io/mesh_files.h"
#include "io/mesh_parts.h"

#include <assimp/cimport.h>
#include <assimp/scene.h>

#include <stdlib.h>
#include <string.h>

static void tell_unread(const struct mesh_files *files)
{
    if (files->missing[0] != '\0')
        base_fail(files->log, DPL_REASON_FILE_READ,
                  "%s: names a file that is not there: \"%s\" (accepted: one in its folder or below that)", files->path,
                  files->missing);
    else
        base_fail(files->log, DPL_REASON_FILE_FORMAT, "%s: cannot be read: %s (accepted: a whole, sound file)",
                  files->path, aiGetErrorString());
}

static const struct aiScene *import(struct mesh_files *files)
{
    const struct aiScene *scene = aiImportFileEx(files->name, 0, &files->io);
    if (scene && files->missing[0] != '\0')
        base_inform(files->log, "%s: is read without \"%s\", which is not in its folder", files->path, files->missing);
    if (!scene && !files->failed)
        tell_unread(files);
    return scene;
}

static bool read_bytes(struct mesh_files *files, struct io_mesh *mesh)
{
    mesh_files_open(files);
    const struct aiScene *scene = import(files);
    bool ok = scene && !files->failed && mesh_parts_are_sound(scene, files->path, files->log) &&
              mesh_parts_collect(scene, files->path, mesh, files->log);
    if (scene)
        aiReleaseImport(scene);
    return ok;
}

bool io_mesh_read(const char *path, struct io_mesh *mesh, const struct dpl_log *log)
{
    char name[32];
    struct mesh_files files = {.path = path, .name = name, .log = log};
    *mesh = (struct io_mesh){0};
    const char *ending = mesh_ending(path, log);
    char *bytes = ending ? file_read(path, MESH_FILES_SIZE_MAX, &files.length, log) : NULL;
    files.bytes = bytes;
    snprintf(name, sizeof name, "mesh/main%s", ending ? ending : "");
    bool ok = bytes && mesh_bytes_are_sound(ending, bytes, files.length, path, log) && read_bytes(&files, mesh);
    free(bytes);
    if (!ok)
        io_mesh_finish(mesh);
    return ok;
}

void io_mesh_finish(struct io_mesh *mesh)
{
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->colors);
    free(mesh->indices);
    *mesh = (struct io_mesh){0};
}
