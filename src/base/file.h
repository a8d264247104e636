/* base/file.h: reading whole files, and writing files that appear whole or not at all. */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include "dapple/log.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>

/* Reads a regular file of at most `most` bytes. The result ends with a zero byte that `length` does not count; the
 * caller frees it. Returns NULL, with the reason logged. */
char *file_read(const char *path, size_t most, size_t *length, const struct dpl_log *log);

/* True where `path` names something that exists. */
bool file_exists(const char *path);

/* How many bytes of the path name its folder, the last slash included; 0: it has none. */
size_t file_folder(const char *path);

/* A file being written under a temporary name in the folder of its final one. */
struct file_writer {
    FILE *stream;
    char path[PATH_MAX], temporary[PATH_MAX];
};
bool file_begin(struct file_writer *writer, const char *path, const struct dpl_log *log);
/* Closes and renames if `ok` and nothing failed to be written; otherwise removes what was written. */
bool file_end(struct file_writer *writer, bool ok, const struct dpl_log *log);

#endif
