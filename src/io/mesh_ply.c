/* Whether a PLY is as long as its header says: assimp asks for memory by the header, and goes on where bytes end. A
 * zero byte, which follows the last, ends text. */
#include "io/mesh_parts.h"

#include "base/log.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE_MAX_LENGTH 256
#define PROPERTIES_MAX 64
#define ELEMENTS_MAX 16 /* kinds of them: the header is read anew for each */

/* One kind of element: `count` times these properties. */
struct element {
    long long count;
    int properties;
    int size[PROPERTIES_MAX];  /* bytes of a value */
    int times[PROPERTIES_MAX]; /* 0: one value; otherwise a list, of which the bytes of its length */
};

struct ply {
    const char *at, *end;
    bool text, big_endian;
};

static int type_size(const char *type)
{
    static const struct {
        const char *name;
        int size;
    } types[] = {{"char", 1},  {"uchar", 1},  {"int8", 1},    {"uint8", 1},  {"short", 2}, {"ushort", 2},
                 {"int16", 2}, {"uint16", 2}, {"int", 4},     {"uint", 4},   {"int32", 4}, {"uint32", 4},
                 {"float", 4}, {"double", 8}, {"float32", 4}, {"float64", 8}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (!strcmp(type, types[i].name))
            return types[i].size;
    return 0;
}

/* The next line of the header, without its end; false: there is none, or it is too long. */
static bool next_line(struct ply *ply, char line[LINE_MAX_LENGTH])
{
    const char *stop = memchr(ply->at, '\n', (size_t)(ply->end - ply->at));
    if (!stop || stop - ply->at >= LINE_MAX_LENGTH)
        return false;
    size_t length = (size_t)(stop - ply->at);
    memcpy(line, ply->at, length);
    line[length] = '\0';
    line[strcspn(line, "\r")] = '\0';
    ply->at = stop + 1;
    return true;
}

static bool add_property(struct element *element, const char *line)
{
    char type[16] = "", length[16] = "";
    if (element->properties == PROPERTIES_MAX)
        return false;
    bool list = sscanf(line, "property list %15s %15s", length, type) == 2;
    if (!list && sscanf(line, "property %15s", type) != 1)
        return false;
    int i = element->properties++;
    element->size[i] = type_size(type);
    element->times[i] = list ? type_size(length) : 0;
    return element->size[i] > 0 && (!list || element->times[i] > 0);
}

/* The length of a list, which has that many bytes; a negative one is a long one. */
static uint64_t list_length(const struct ply *ply, int size)
{
    uint64_t value = 0;
    for (int i = 0; i < size; i++)
        value |= (uint64_t)(unsigned char)ply->at[i] << 8 * (ply->big_endian ? size - 1 - i : i);
    return value;
}

static bool skip_bytes(struct ply *ply, int size, int length_size)
{
    uint64_t bytes = (uint64_t)size, left = (uint64_t)(ply->end - ply->at);
    if (length_size > 0) {
        if (left < (uint64_t)length_size || list_length(ply, length_size) > left)
            return false;
        bytes = (uint64_t)length_size + (uint64_t)size * list_length(ply, length_size);
    }
    if (bytes > left)
        return false;
    ply->at += bytes;
    return true;
}

static bool skip_word(struct ply *ply)
{
    ply->at += strspn(ply->at, " \t\r\n");
    const char *first = ply->at;
    ply->at += strcspn(ply->at, " \t\r\n");
    return ply->at > first;
}

static bool skip_words(struct ply *ply, bool list)
{
    const char *number = ply->at;
    if (!skip_word(ply))
        return false;
    for (long left = list ? strtol(number, NULL, 10) : 0; left > 0; left--)
        if (!skip_word(ply))
            return false;
    return true;
}

static bool skip_elements(struct ply *ply, const struct element *element)
{
    if (element->count > ply->end - ply->at || (element->count > 0 && element->properties == 0))
        return false;
    for (long long i = 0; i < element->count; i++)
        for (int k = 0; k < element->properties; k++)
            if (!(ply->text ? skip_words(ply, element->times[k] > 0)
                            : skip_bytes(ply, element->size[k], element->times[k])))
                return false;
    return true;
}

/* Reads the header once for each element, of which it keeps one: number `wanted`. Returns 1 where there is one, 0 where
 * there are no more, -1 where this is no header; then the place is behind it. */
static int read_header(struct ply *ply, int wanted, struct element *element)
{
    char line[LINE_MAX_LENGTH], format[32];
    int elements = 0;
    *element = (struct element){0};
    if (!next_line(ply, line) || strcmp(line, "ply") != 0)
        return -1;
    while (next_line(ply, line) && strcmp(line, "end_header") != 0) {
        bool mine = elements == wanted + 1;
        if (sscanf(line, "format %31s", format) == 1) {
            ply->text = !strcmp(format, "ascii");
            ply->big_endian = !strcmp(format, "binary_big_endian");
        } else if (!strncmp(line, "element ", 8)) {
            if (elements++ == wanted && (sscanf(line, "element %*s %lld", &element->count) != 1 || element->count < 0))
                return -1;
            if (elements > ELEMENTS_MAX)
                return -1;
        } else if (!strncmp(line, "property ", 9) && mine && !add_property(element, line))
            return -1;
    }
    return strcmp(line, "end_header") != 0 ? -1 : elements > wanted;
}

bool mesh_ply_is_sound(const char *bytes, size_t length, const char *path, const struct dpl_log *log)
{
    const char *body = NULL;
    for (int i = 0;; i++) {
        struct ply ply = {.at = bytes, .end = bytes + length};
        struct element element;
        int found = read_header(&ply, i, &element);
        if (found < 0)
            return base_fail(log, DPL_REASON_FILE_FORMAT,
                             "%s: no PLY (accepted: \"ply\" … \"end_header\", at most %d elements)", path,
                             ELEMENTS_MAX);
        if (found == 0)
            return true;
        ply.at = body ? body : ply.at;
        if (!skip_elements(&ply, &element))
            return base_fail(log, DPL_REASON_FILE_FORMAT,
                             "%s: cut short: %zu bytes (accepted: all %lld of element %d, as the header says)", path,
                             length, element.count, i + 1);
        body = ply.at;
    }
}
