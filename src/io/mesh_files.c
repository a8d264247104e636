#include "io/mesh_files.h"

#include "base/file.h"
#include "base/log.h"

#include <stdlib.h>
#include <string.h>

/* A file that is open. */
struct reader {
    struct aiFile file; /* first: assimp knows the reader by it */
    const char *bytes;
    char *owned; /* NULL: the bytes are the mesh's own */
    size_t length, place;
};

static size_t read_items(struct aiFile *file, char *to, size_t size, size_t count)
{
    struct reader *reader = (struct reader *)file;
    size_t whole = size > 0 ? (reader->length - reader->place) / size : 0;
    count = count < whole ? count : whole;
    memcpy(to, reader->bytes + reader->place, count * size);
    reader->place += count * size;
    return count;
}

static size_t write_nothing(struct aiFile *file, const char *from, size_t size, size_t count)
{
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

static size_t place_of(struct aiFile *file)
{
    return ((struct reader *)file)->place;
}

static size_t length_of(struct aiFile *file)
{
    return ((struct reader *)file)->length;
}

/* A negative offset is one in two's complement, as for fseek(). */
static aiReturn move_to(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    struct reader *reader = (struct reader *)file;
    size_t place = origin == aiOrigin_SET   ? offset
                   : origin == aiOrigin_CUR ? reader->place + offset
                                            : reader->length + offset;
    if (place > reader->length)
        return aiReturn_FAILURE;
    reader->place = place;
    return aiReturn_SUCCESS;
}

static void flush_nothing(struct aiFile *file)
{
    (void)file;
}

static struct aiFile *open_bytes(const char *bytes, char *owned, size_t length)
{
    struct reader *reader = calloc(1, sizeof *reader);
    if (!reader) {
        free(owned);
        return NULL;
    }
    *reader = (struct reader){
        {read_items, write_nothing, place_of, length_of, move_to, flush_nothing, NULL}, bytes, owned, length, 0};
    return &reader->file;
}

/* True for names that lie in the mesh's folder or below it. */
static bool is_inside(const char *name)
{
    if (*name == '\0' || *name == '/' || strpbrk(name, "\\:"))
        return false;
    for (const char *part = name; part; part = strchr(part, '/') ? strchr(part, '/') + 1 : NULL)
        if (!strncmp(part, "..", 2) && (part[2] == '/' || part[2] == '\0'))
            return false;
    return true;
}

static struct aiFile *open_beside(struct mesh_files *files, const char *name)
{
    int folder = (int)file_folder(files->path);
    char path[PATH_MAX];
    size_t length = 0;
    if (!is_inside(name) || snprintf(path, sizeof path, "%.*s%s", folder, files->path, name) >= (int)sizeof path ||
        !file_exists(path)) {
        if (files->missing[0] == '\0')
            snprintf(files->missing, sizeof files->missing, "%s", name);
        return NULL;
    }
    char *bytes = file_read(path, files->left, &length, files->log);
    files->failed = !bytes;
    files->left -= length;
    return bytes ? open_bytes(bytes, bytes, length) : NULL;
}

static struct aiFile *open_file(struct aiFileIO *io, const char *name, const char *mode)
{
    struct mesh_files *files = (struct mesh_files *)io->UserData;
    size_t folder = (size_t)(strchr(files->name, '/') - files->name) + 1;
    if (*mode != 'r' || files->failed)
        return NULL;
    if (!strcmp(name, files->name))
        return open_bytes(files->bytes, NULL, files->length);
    return open_beside(files, strncmp(name, files->name, folder) ? name : name + folder);
}

static void close_file(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    if (file)
        free(((struct reader *)file)->owned);
    free(file);
}

void mesh_files_open(struct mesh_files *files)
{
    files->io = (struct aiFileIO){open_file, close_file, (char *)files};
    files->left = MESH_FILES_SIZE_MAX - files->length;
    files->failed = false;
    files->missing[0] = '\0';
}
