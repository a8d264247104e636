/* What is looked at in the text of glTF before assimp reads it, because assimp follows nodes by recursion: brackets in
 * each other, and whether the nodes are trees. A node that is in two places could be read exponentially often. */
#include "io/mesh_parts.h"

#include "base/log.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define NESTING_MAX 64   /* of brackets */
#define PARENTS_MAX 2000 /* nodes that have children: no chain of them is longer */
#define NODES_MAX 100000

enum { NOWHERE, CHILD }; /* where a node is; above: a root of scene number `where` - CHILD */

struct scan {
    const char *text, *end;
    int parents, scenes;
    int *where; /* NODES_MAX */
};

static const char *skip_blanks(const struct scan *scan, const char *at)
{
    while (at < scan->end && memchr(" \t\r\n", *at, 4))
        at++;
    return at;
}

/* Takes the numbers of a list of nodes, or looks no further where it is a list of something else. */
static bool take_nodes(struct scan *scan, const char *at, bool children)
{
    int list = children ? CHILD : CHILD + ++scan->scenes;
    at = skip_blanks(scan, at);
    if (at == scan->end || *at != '[')
        return !children && at < scan->end; /* "nodes": {…} of glTF 1 is refused by its children */
    do {
        at = skip_blanks(scan, at + 1);
        if (at < scan->end && *at == ']')
            return true;
        if (at < scan->end && *at == '{')
            return !children;
        int node = 0, digits = 0;
        for (; at < scan->end && *at >= '0' && *at <= '9' && node < NODES_MAX; at++, digits++)
            node = node * 10 + (*at - '0');
        if (digits == 0 || node >= NODES_MAX || scan->where[node] == CHILD || scan->where[node] == list ||
            (children && scan->where[node] != NOWHERE))
            return false;
        scan->where[node] = list;
        at = skip_blanks(scan, at);
    } while (at < scan->end && *at == ',');
    return at < scan->end && *at == ']';
}

/* `at` is behind the first quote; returns what follows the last, or NULL. A key must be written plainly. */
static const char *take_string(struct scan *scan, const char *at)
{
    const char *first = at;
    bool escapes = false;
    for (; at < scan->end && *at != '"'; at++)
        if (*at == '\\') {
            escapes = true;
            at++;
        }
    if (at >= scan->end)
        return NULL;
    size_t length = (size_t)(at - first);
    const char *next = skip_blanks(scan, at + 1);
    if (next == scan->end || *next != ':')
        return at + 1;
    bool children = length == 8 && !memcmp(first, "children", 8);
    scan->parents += children;
    if (escapes || scan->parents > PARENTS_MAX)
        return NULL;
    if (children || (length == 5 && !memcmp(first, "nodes", 5)))
        return take_nodes(scan, next + 1, children) ? next + 1 : NULL;
    return next + 1;
}

static bool is_shallow(struct scan *scan)
{
    int depth = 0;
    for (const char *at = scan->text; at < scan->end;) {
        if (*at == '"') {
            at = take_string(scan, at + 1);
            if (!at)
                return false;
            continue;
        }
        depth += (*at == '{' || *at == '[') - (*at == '}' || *at == ']');
        if (depth > NESTING_MAX || *at == '/') /* a comment could hide a quote */
            return false;
        at++;
    }
    return true;
}

static bool text_is_sound(const char *text, size_t length, const char *path, const struct dpl_log *log)
{
    struct scan scan = {.text = text, .end = text + length};
    const char *first = skip_blanks(&scan, text);
    if (first == scan.end || *first != '{')
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: no glTF: does not begin with \"{\"", path);
    scan.where = base_allocate(log, NODES_MAX, sizeof *scan.where, "nodes");
    if (!scan.where)
        return false;
    bool ok = is_shallow(&scan);
    free(scan.where);
    return ok || base_fail(log, DPL_REASON_FILE_FORMAT,
                           "%s: no glTF 2, cut short, or not one tree of nodes (accepted: each node in one place, at "
                           "most %d nodes, %d of them with children, %d brackets in each other)",
                           path, NODES_MAX, PARENTS_MAX, NESTING_MAX);
}

bool mesh_gltf_is_sound(const char *bytes, size_t length, const char *path, const struct dpl_log *log)
{
    return text_is_sound(bytes, length, path, log);
}

/* Header: "glTF", version, length of all; first chunk: length, "JSON", text (Khronos Group, glTF 2.0, 4.4). */
bool mesh_glb_is_sound(const char *bytes, size_t length, const char *path, const struct dpl_log *log)
{
    if (length < 20 || memcmp(bytes, "glTF", 4) || mesh_little_endian(bytes + 4) != 2 || memcmp(bytes + 16, "JSON", 4))
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: no GLB (accepted: \"glTF\", version 2, a chunk \"JSON\")",
                         path);
    uint32_t whole = mesh_little_endian(bytes + 8), text = mesh_little_endian(bytes + 12);
    if (whole != length || text > length - 20)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: cut short, or longer than it says: %zu bytes (accepted: %u)",
                         path, length, whole);
    return text_is_sound(bytes + 20, text, path, log);
}
