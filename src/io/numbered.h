/* io/numbered.h: names of numbered files, as in water-%04d.png. */
#ifndef IO_NUMBERED_H
#define IO_NUMBERED_H

#include <limits.h>
#include <stdbool.h>

/* A name taken apart. */
struct io_numbered {
    const char *name; /* of all files */
    const char *rest; /* in the name, what follows the number; NULL: it has none, and stands for one file */
    int before;       /* characters of the name that precede the number */
    int digits;       /* that the number has at least; 0: as many as it needs */
};

/* Finds the number in the last part of a path: %d, or %0Nd with N from 1 to 9. False where there is another %, or a
 * second one. The name must outlive it. */
bool io_numbered_split(struct io_numbered *numbered, const char *name);

/* Name of the file with that number. */
void io_numbered_path(const struct io_numbered *numbered, int number, char path[PATH_MAX]);

#endif
