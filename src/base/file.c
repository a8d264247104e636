#include "base/file.h"

#include "base/log.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define TEMPORARY_ATTEMPTS 100

static char *read_stream(FILE *stream, const char *path, size_t most, size_t *length, const struct dpl_log *log)
{
    struct stat status;
    if (fstat(fileno(stream), &status) != 0 || !S_ISREG(status.st_mode)) {
        base_fail(log, DPL_REASON_FILE_READ, "%s: is not a regular file", path);
        return NULL;
    }
    if ((unsigned long long)status.st_size > most) {
        base_fail(log, DPL_REASON_FILE_READ, "%s: too large: %lld bytes (at most %zu)", path, (long long)status.st_size,
                  most);
        return NULL;
    }
    size_t size = (size_t)status.st_size;
    char *text = base_allocate(log, size + 1, 1, path);
    if (!text)
        return NULL;
    *length = fread(text, 1, size, stream);
    if (ferror(stream)) {
        base_fail(log, DPL_REASON_FILE_READ, "%s: cannot be read: %s", path, strerror(errno));
        free(text);
        return NULL;
    }
    return text;
}

char *file_read(const char *path, size_t most, size_t *length, const struct dpl_log *log)
{
    /* Without waiting: a pipe that nobody writes to is refused, not waited for. */
    int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    FILE *stream = descriptor >= 0 ? fdopen(descriptor, "rb") : NULL;
    if (!stream) {
        base_fail(log, DPL_REASON_FILE_READ, "%s: cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    char *text = read_stream(stream, path, most, length, log);
    fclose(stream);
    return text;
}

bool file_exists(const char *path)
{
    return access(path, F_OK) == 0;
}

/* Creates a file that was not there, in the folder of the final one. */
static FILE *create_temporary(struct file_writer *writer)
{
    for (int attempt = 0; attempt < TEMPORARY_ATTEMPTS; attempt++) {
        int length = snprintf(writer->temporary, sizeof writer->temporary, "%s.%ld-%d.part", writer->path,
                              (long)getpid(), attempt);
        if (length >= (int)sizeof writer->temporary) {
            errno = ENAMETOOLONG;
            return NULL;
        }
        int descriptor = open(writer->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0)
            return fdopen(descriptor, "wb");
        if (errno != EEXIST)
            return NULL;
    }
    return NULL;
}

size_t file_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash + 1 - path) : 0;
}

bool file_begin(struct file_writer *writer, const char *path, const struct dpl_log *log)
{
    struct stat status;
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode))
        return base_fail(log, DPL_REASON_FILE_WRITE, "%s: cannot be written: is a directory", path);
    if (snprintf(writer->path, sizeof writer->path, "%s", path) >= (int)sizeof writer->path)
        return base_fail(log, DPL_REASON_FILE_WRITE, "%.80s…: name too long", path);
    writer->stream = create_temporary(writer);
    if (!writer->stream)
        return base_fail(log, DPL_REASON_FILE_WRITE, "%s: cannot be written: %s", path, strerror(errno));
    return true;
}

bool file_end(struct file_writer *writer, bool ok, const struct dpl_log *log)
{
    bool written = fflush(writer->stream) == 0 && !ferror(writer->stream);
    int error = errno;
    written = fclose(writer->stream) == 0 && written;
    if (ok && written && rename(writer->temporary, writer->path) == 0)
        return true;
    if (ok)
        base_fail(log, DPL_REASON_FILE_WRITE, "%s: cannot be written: %s", writer->path,
                  strerror(written ? errno : error));
    unlink(writer->temporary);
    return false;
}
