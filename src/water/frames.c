#include "water/frames.h"

#include "base/file.h"
#include "base/log.h"
#include "io/format.h"
#include "io/numbered.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FRAMES_MAX 100000
#define LOOK_AHEAD 100                 /* pictures */
#define MEMORY_MAX ((size_t)256 << 20) /* bytes of pictures that are kept */
#define VALUE_MAX 1e6

static bool split_name(struct io_numbered *numbered, const char *name, const struct dpl_log *log)
{
    return io_numbered_split(numbered, name) ||
           base_fail(log, DPL_REASON_VALUE,
                     "not a name of numbered pictures: \"%s\" (accepted: one %%d or %%0Nd, N from "
                     "1 to 9, as in heights-%%04d.png)",
                     name);
}

/* Checks an image and copies its first channel; a side of 0 becomes the image's. */
static bool take_values(const struct dpl_image *image, int *side, float **values, const char *path,
                        const struct dpl_log *log)
{
    if (image->width != image->height || image->width < 2)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: %d × %d pixels (accepted: as wide as high, 2 at least)",
                         path, image->width, image->height);
    if (*side != 0 && image->width != *side)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: %d pixels a side (accepted: as the first picture, %d)", path,
                         image->width, *side);
    size_t count = (size_t)image->width * (size_t)image->width;
    for (size_t i = 0; i < count; i++)
        if (!(fabsf(image->pixels[i * 3]) <= (float)VALUE_MAX))
            return base_fail(log, DPL_REASON_RANGE, "%s: %g at column %zu, row %zu (accepted: -1e6 to 1e6)", path,
                             (double)image->pixels[i * 3], i % (size_t)image->width, i / (size_t)image->width);
    if (!*values)
        *values = base_allocate(log, count, sizeof **values, "heights");
    if (!*values)
        return false;
    *side = image->width;
    for (size_t i = 0; i < count; i++)
        (*values)[i] = image->pixels[i * 3];
    return true;
}

static int slots_for(int side)
{
    size_t slots = MEMORY_MAX / ((size_t)side * (size_t)side * sizeof(float));
    return slots < 1 ? 1 : slots > FRAME_SLOTS_MAX ? FRAME_SLOTS_MAX : (int)slots;
}

const float *frames_get(struct frames *frames, int frame, const struct dpl_log *log)
{
    int slot = frames->side == 0 ? 0 : frame % frames->slots;
    if (frames->slot[slot].values && frames->slot[slot].frame == frame)
        return frames->slot[slot].values;
    struct io_numbered numbered;
    char path[PATH_MAX];
    if (!split_name(&numbered, frames->name, log))
        return NULL;
    io_numbered_path(&numbered, frames->first + frame, path);
    struct dpl_image *image = io_read(path, log);
    bool ok = image && take_values(image, &frames->side, &frames->slot[slot].values, path, log);
    dpl_image_destroy(image);
    if (!ok)
        return NULL;
    frames->slot[slot].frame = frame;
    return frames->slot[slot].values;
}

bool frames_are_open(const struct frames *frames, const char *name, int first)
{
    return *name && !strcmp(frames->name, name) && frames->first == first;
}

/* Counts pictures up to the first that is not there; others soon after it tell that one is missing. */
static bool count_pictures(struct frames *frames, const struct io_numbered *numbered, const struct dpl_log *log)
{
    char path[PATH_MAX], missing[PATH_MAX];
    do
        io_numbered_path(numbered, frames->first + frames->count, missing);
    while (file_exists(missing) && ++frames->count < FRAMES_MAX);
    for (int ahead = 1; ahead <= LOOK_AHEAD; ahead++) {
        io_numbered_path(numbered, frames->first + frames->count + ahead, path);
        if (file_exists(path))
            return base_fail(log, DPL_REASON_FILE_READ,
                             "%s: is missing, and %s is there (accepted: numbers without a gap)", missing, path);
    }
    return true;
}

bool frames_open(struct frames *frames, const char *name, int first, const struct dpl_log *log)
{
    struct io_numbered numbered;
    if (frames_are_open(frames, name, first))
        return true;
    frames_close(frames);
    if (*name == '\0')
        return base_fail(log, DPL_REASON_VALUE,
                         "no picture is named (accepted: the name of a picture, or as heights-%%04d.png)");
    if (!split_name(&numbered, name, log))
        return false;
    strcpy(frames->name, name);
    frames->first = first;
    frames->count = 1; /* a missing first one is told when it is read */
    bool counted = !numbered.rest || count_pictures(frames, &numbered, log);
    if (counted && frames_get(frames, 0, log)) {
        frames->slots = slots_for(frames->side);
        return true;
    }
    frames_close(frames);
    return false;
}

void frames_close(struct frames *frames)
{
    for (int i = 0; i < FRAME_SLOTS_MAX; i++)
        free(frames->slot[i].values);
    *frames = (struct frames){0};
}
