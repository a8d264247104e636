/* Loops from numbered pictures: loop_read() of loop.h.
 *
 *   1. A pattern is split into what stands before and after the number. A folder's pattern is that of any picture in
 *      it whose name has a number, and there may be no others.
 *   2. The files that fit are sorted by number; every number from the first to the last has to be there.
 *   3. All are read. The first says how large they are. */
#include "base/log.h"
#include "io/format.h"
#include "io/numbered.h"
#include "light/loop.h"

#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define DIGITS "0123456789"
#define DIGITS_MAX 9

struct file {
    long number;
    char name[NAME_MAX + 1];
};

struct listing {
    const char *place; /* as the user gave it */
    char folder[DPL_PARAM_TEXT_SIZE];
    bool any, split;                                /* `any`: the pattern comes from the files; it is there already */
    char before[NAME_MAX + 1], after[NAME_MAX + 1]; /* the number */
    struct file *files;
    int count;
};

/* Step 1, of a pattern or a folder. */
static bool split_place(struct listing *listing, const char *place, const struct dpl_log *log)
{
    struct stat status;
    struct io_numbered numbered;
    const char *slash = strrchr(place, '/'), *name = slash ? slash + 1 : place;
    listing->place = place;
    listing->any = stat(place, &status) == 0 && S_ISDIR(status.st_mode);
    if (listing->any) {
        snprintf(listing->folder, sizeof listing->folder, "%s", place);
        return true;
    }
    if (!io_numbered_split(&numbered, place) || !numbered.rest)
        return base_fail(log, DPL_REASON_FILE_READ,
                         "%s: no numbered pictures (accepted: the folder that holds them, or a name with one %%d or "
                         "%%0Nd, N from 1 to 9, as in loop/%%04d.exr)",
                         place);
    snprintf(listing->folder, sizeof listing->folder, "%.*s", slash ? (int)(slash - place) + 1 : 1,
             slash ? place : ".");
    snprintf(listing->before, sizeof listing->before, "%.*s", (int)(place + numbered.before - name), name);
    snprintf(listing->after, sizeof listing->after, "%s", numbered.rest);
    listing->split = true;
    return true;
}

/* Step 1, of a name in a folder: at its last number. False where it has none or is no picture. */
static bool split_name(struct listing *listing, const char *name)
{
    const char *ending = strrchr(name, '.');
    if (!ending || !dpl_image_format_known(name, NULL))
        return false;
    int end = (int)(ending - name);
    while (end > 0 && !strchr(DIGITS, name[end - 1]))
        end--;
    int start = end;
    while (start > 0 && strchr(DIGITS, name[start - 1]))
        start--;
    if (start == end)
        return false;
    snprintf(listing->before, sizeof listing->before, "%.*s", start, name);
    snprintf(listing->after, sizeof listing->after, "%s", name + end);
    listing->split = true;
    return true;
}

/* The number in a name that fits the pattern, otherwise -1. */
static long number_in(const struct listing *listing, const char *name)
{
    size_t before = strlen(listing->before), length = strlen(name);
    if (strncmp(name, listing->before, before) != 0)
        return -1;
    size_t digits = strspn(name + before, DIGITS);
    bool fits = digits >= 1 && digits <= DIGITS_MAX && before + digits <= length &&
                !strcmp(name + before + digits, listing->after);
    return fits ? strtol(name + before, NULL, 10) : -1;
}

static bool add_file(struct listing *listing, const char *name, const struct dpl_log *log)
{
    if (listing->any && !listing->split && !split_name(listing, name))
        return true;
    long number = number_in(listing, name);
    if (number < 0) {
        struct listing other = {0};
        return !listing->any || !split_name(&other, name) ||
               base_fail(log, DPL_REASON_FILE_READ, "%s: numbered pictures of several names: \"%s\" beside \"%s…%s\"",
                         listing->place, name, listing->before, listing->after);
    }
    if (listing->count == LOOP_FRAMES_MAX)
        return base_fail(log, DPL_REASON_LIMIT, "%s: too many pictures (at most %d)", listing->place, LOOP_FRAMES_MAX);
    listing->files[listing->count].number = number;
    snprintf(listing->files[listing->count++].name, NAME_MAX + 1, "%s", name);
    return true;
}

static int compare(const void *a, const void *b)
{
    long first = ((const struct file *)a)->number, second = ((const struct file *)b)->number;
    return (first > second) - (first < second);
}

/* Step 2. */
static bool list(struct listing *listing, const struct dpl_log *log)
{
    DIR *folder = opendir(listing->folder);
    if (!folder)
        return base_fail(log, DPL_REASON_FILE_READ, "%s: cannot be read: %s", listing->place, strerror(errno));
    bool ok = true;
    for (struct dirent *entry; ok && (entry = readdir(folder));)
        ok = add_file(listing, entry->d_name, log);
    closedir(folder);
    if (ok && listing->count == 0)
        return base_fail(log, DPL_REASON_FILE_READ, "%s: no numbered pictures there", listing->place);
    qsort(listing->files, (size_t)listing->count, sizeof *listing->files, compare);
    for (int i = 1; ok && i < listing->count; i++) {
        long last = listing->files[i - 1].number, number = listing->files[i].number;
        if (number != last + 1)
            ok = base_fail(log, DPL_REASON_FILE_READ, "%s: picture %ld %s", listing->place,
                           number == last ? number : last + 1, number == last ? "is there twice" : "is missing");
    }
    return ok;
}

/* Step 3, one picture, as three channels. */
static bool add_frame(struct loop *loop, int frame, const struct dpl_image *image, const char *path, int count,
                      const struct dpl_log *log)
{
    size_t values = (size_t)image->width * (size_t)image->height * 3;
    if (image->width != image->height || image->width > LIGHT_MAP_MAX)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: a map is square: %d × %d (accepted: 1 to %d a side)", path,
                         image->width, image->height, LIGHT_MAP_MAX);
    if (frame == 0 && !loop_resize(loop, count, image->width, 3, path, log))
        return false;
    if (image->width != loop->side)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: not as large as the first picture: %d × %d (accepted: %d)",
                         path, image->width, image->height, loop->side);
    for (size_t i = 0; i < values; i++)
        if (!isfinite(image->pixels[i]) || image->pixels[i] < 0)
            return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: no light in column %zu, row %zu: \"%g\"", path,
                             i / 3 % (size_t)image->width, i / 3 / (size_t)image->width, (double)image->pixels[i]);
    memcpy(loop->texels + (size_t)frame * values, image->pixels, values * sizeof(float));
    return true;
}

static bool read_frames(struct loop *loop, const struct listing *listing, const struct dpl_log *log)
{
    bool ok = true;
    for (int i = 0; ok && i < listing->count; i++) {
        char path[PATH_MAX];
        snprintf(path, sizeof path, "%s/%s", listing->folder, listing->files[i].name);
        struct dpl_image *image = io_read(path, log);
        ok = image && add_frame(loop, i, image, path, listing->count, log);
        dpl_image_destroy(image);
    }
    return ok;
}

bool loop_read(struct loop *loop, const char *place, const struct dpl_log *log)
{
    struct listing listing = {0};
    struct loop new = {0};
    listing.files = base_allocate(log, LOOP_FRAMES_MAX, sizeof *listing.files, "names of pictures");
    bool ok =
        listing.files && split_place(&listing, place, log) && list(&listing, log) && read_frames(&new, &listing, log);
    free(listing.files);
    if (ok) {
        loop_finish(loop);
        *loop = new;
    } else
        loop_finish(&new);
    return ok;
}
