/* base/hash.h: one number for many values, which tells whether they are the same. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include "dapple/param.h"

#include <stdint.h>
#include <string.h>

/* Where every hash begins. */
static const uint64_t hash_start = 0xcbf29ce484222325u;

/* FNV-1a (Fowler, Noll & Vo 1991), eight bytes at a time as far as they go. */
static inline uint64_t hash_bytes(uint64_t value, const void *data, size_t size)
{
    const uint64_t factor = 0x100000001b3u;
    const unsigned char *bytes = data;
    for (; size >= 8; size -= 8, bytes += 8) {
        uint64_t word;
        memcpy(&word, bytes, 8);
        value = (value ^ word) * factor;
        value ^= value >> 32; /* so that high bits reach low ones too */
    }
    for (; size > 0; size--, bytes++)
        value = (value ^ *bytes) * factor;
    return value;
}

static inline uint64_t hash_number(uint64_t value, double number)
{
    return hash_bytes(value, &number, sizeof number);
}

/* The values of a table, without what may lie between them in memory. */
static inline uint64_t hash_params(uint64_t value, const struct dpl_param *param, const void *values)
{
    for (; param && param->name; param++) {
        char text[DPL_PARAM_TEXT_SIZE * 2];
        if (dpl_param_format(param, values, text, sizeof text))
            value = hash_bytes(value, text, strlen(text) + 1);
    }
    return value;
}

#endif
