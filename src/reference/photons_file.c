/* What a count belongs to, and the file that keeps it: a header, then the sums as they are in memory. */
#include "reference/photons.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/log.h"

#include <stdlib.h>
#include <string.h>

#define MAGIC "dapple photons 1" /* the number grows when the photons or the file change their meaning */

struct header {
    char magic[sizeof MAGIC - 1];
    uint64_t fingerprint, passes;
    uint64_t sum_count;
    uint64_t check; /* of all before it and of the sums */
};

uint64_t photons_fingerprint(const struct photons_task *task)
{
    const struct water_setup *setup = task->setup;
    uint64_t value = hash_bytes(hash_start, MAGIC, sizeof MAGIC);
    value = hash_bytes(value, task->model->name, strlen(task->model->name) + 1);
    value = hash_params(value, task->model->params, setup->params);
    value = hash_number(value, setup->size);
    value = hash_number(value, setup->depth);
    value = hash_number(value, setup->loop);
    value = hash_number(value, task->time);
    value = water_hash(value, task->model, task->setup, task->time);
    for (int w = 0; w < setup->wave_count; w++)
        value = hash_params(value, water_wave_params, setup->waves + w);
    value = hash_params(value, optics_sun_params, task->sun);
    value = hash_number(value, task->medium->ior);
    value = hash_number(value, task->medium->dispersion);
    struct optics_water water = water_optics(task->medium);
    for (int c = 0; c < 3; c++)
        value = hash_number(value, water.absorption[c]);
    for (int r = 0; r < task->receiver_count; r++)
        value = hash_number(value, task->receivers[r]);
    for (int r = 0; r < task->receiver_count && task->windows; r++)
        value = hash_bytes(value, task->windows + r, sizeof *task->windows);
    value = hash_number(value, task->receiver_count);
    return hash_number(value, task->side);
}

static struct header header_of(const struct photons *photons, const uint64_t *sums, uint64_t passes)
{
    struct header header = {
        .fingerprint = photons->fingerprint, .passes = passes, .sum_count = photons_sum_count(photons)};
    memcpy(header.magic, MAGIC, sizeof header.magic);
    header.check = hash_bytes(hash_start, &header, offsetof(struct header, check));
    header.check = hash_bytes(header.check, sums, photons_sum_count(photons) * sizeof *sums);
    return header;
}

bool photons_save(const struct photons *photons, const char *path, const struct dpl_log *log)
{
    struct file_writer writer;
    struct header header = header_of(photons, photons->sums, photons->passes);
    if (!file_begin(&writer, path, log))
        return false;
    fwrite(&header, sizeof header, 1, writer.stream);
    fwrite(photons->sums, sizeof *photons->sums, photons_sum_count(photons), writer.stream);
    return file_end(&writer, true, log); /* which looks whether anything failed */
}

/* Checks a file's bytes against the count that it shall go on. */
static bool check(const struct photons *photons, const char *path, const char *bytes, size_t length,
                  const struct dpl_log *log)
{
    struct header header = {0}, wanted;
    memcpy(&header, bytes, length < sizeof header ? length : sizeof header);
    if (memcmp(header.magic, MAGIC, sizeof header.magic) != 0)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: holds no photon counts of this version", path);
    if (length >= sizeof header && header.fingerprint != photons->fingerprint)
        return base_fail(log, DPL_REASON_FILE_FORMAT,
                         "%s: its photons are those of another scene, time or map (remove it, or name another file)",
                         path);
    size_t size = sizeof header + photons_sum_count(photons) * sizeof *photons->sums;
    if (length != size)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: is cut short or too long: %zu bytes (accepted: %zu)", path,
                         length, size);
    wanted = header_of(photons, (const uint64_t *)(const void *)(bytes + sizeof header), header.passes);
    if (memcmp(&header, &wanted, sizeof header) != 0 || header.passes == 0)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: is damaged: its bytes and their check sum differ", path);
    return true;
}

bool photons_load(struct photons *photons, const char *path, const struct dpl_log *log)
{
    size_t length = 0;
    char *bytes = file_read(path, SIZE_MAX - 1, &length, log);
    bool ok = bytes && check(photons, path, bytes, length, log);
    if (ok) {
        struct header header;
        memcpy(&header, bytes, sizeof header);
        photons->passes = header.passes;
        memcpy(photons->sums, bytes + sizeof header, length - sizeof header);
    }
    free(bytes);
    return ok;
}
