#include "cli/json.h"

#include <math.h>

/* Bytes of the UTF-8 character at `text`, 0 where there is none (RFC 3629). */
static int character_length(const unsigned char *text)
{
    static const struct {
        unsigned char first, last, second_first, second_last;
        int length;
    } forms[] = {
        {0x00, 0x7f, 0, 0, 1},       {0xc2, 0xdf, 0x80, 0xbf, 2}, {0xe0, 0xe0, 0xa0, 0xbf, 3},
        {0xe1, 0xec, 0x80, 0xbf, 3}, {0xed, 0xed, 0x80, 0x9f, 3}, {0xee, 0xef, 0x80, 0xbf, 3},
        {0xf0, 0xf0, 0x90, 0xbf, 4}, {0xf1, 0xf3, 0x80, 0xbf, 4}, {0xf4, 0xf4, 0x80, 0x8f, 4},
    };
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        if (text[0] < forms[i].first || text[0] > forms[i].last)
            continue;
        if (forms[i].length > 1 && (text[1] < forms[i].second_first || text[1] > forms[i].second_last))
            return 0;
        for (int b = 2; b < forms[i].length; b++)
            if (text[b] < 0x80 || text[b] > 0xbf)
                return 0;
        return forms[i].length;
    }
    return 0;
}

static void write_string(FILE *stream, const char *text)
{
    const unsigned char *next = (const unsigned char *)text;
    fputc('"', stream);
    while (*next) {
        int length = character_length(next);
        if (length == 0)
            fputs("\\ufffd", stream);
        else if (*next == '"' || *next == '\\')
            fprintf(stream, "\\%c", *next);
        else if (*next < 0x20 || *next == 0x7f)
            fprintf(stream, "\\u%04x", *next);
        else
            fwrite(next, 1, (size_t)length, stream);
        next += length ? length : 1;
    }
    fputc('"', stream);
}

/* What stands before a value: the comma, and the key. */
static void write_start(struct json *json, const char *key)
{
    if (json->comma)
        fputs(", ", json->stream);
    if (key) {
        write_string(json->stream, key);
        fputs(": ", json->stream);
    }
    json->comma = true;
}

void json_open(struct json *json, const char *key, char bracket)
{
    write_start(json, key);
    fputc(bracket, json->stream);
    json->comma = false;
}

void json_close(struct json *json, char bracket)
{
    fputc(bracket, json->stream);
    json->comma = true;
}

void json_text(struct json *json, const char *key, const char *text)
{
    write_start(json, key);
    if (text)
        write_string(json->stream, text);
    else
        fputs("null", json->stream);
}

void json_number(struct json *json, const char *key, double number)
{
    write_start(json, key);
    if (isfinite(number))
        fprintf(json->stream, "%.9g", number);
    else
        fputs("null", json->stream);
}

void json_bool(struct json *json, const char *key, bool value)
{
    write_start(json, key);
    fputs(value ? "true" : "false", json->stream);
}
