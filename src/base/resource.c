#include "base/resource.h"

#include <string.h>

const char *base_resource_find(const char *path)
{
    for (const struct base_resource *resource = base_resources; resource->path; resource++)
        if (!strcmp(resource->path, path))
            return resource->text;
    return NULL;
}
