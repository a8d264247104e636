#include "io/numbered.h"

#include <stdio.h>
#include <string.h>

bool io_numbered_split(struct io_numbered *numbered, const char *name)
{
    const char *slash = strrchr(name, '/'), *percent = strchr(slash ? slash : name, '%');
    *numbered = (struct io_numbered){.name = name};
    if (!percent)
        return true;
    const char *end = percent + 1;
    if (end[0] == '0' && end[1] >= '1' && end[1] <= '9') {
        numbered->digits = end[1] - '0';
        end += 2;
    }
    if (*end != 'd' || strchr(end, '%'))
        return false;
    numbered->before = (int)(percent - name);
    numbered->rest = end + 1;
    return true;
}

void io_numbered_path(const struct io_numbered *numbered, int number, char path[PATH_MAX])
{
    if (numbered->rest) /* the name is never a format */
        snprintf(path, PATH_MAX, "%.*s%0*d%s", numbered->before, numbered->name, numbered->digits, number,
                 numbered->rest);
    else
        snprintf(path, PATH_MAX, "%s", numbered->name);
}
