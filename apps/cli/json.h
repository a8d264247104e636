/* cli/json.h: writes JSON. Keys are NULL in arrays and at the top. */
#ifndef CLI_JSON_H
#define CLI_JSON_H

#include <stdbool.h>
#include <stdio.h>

struct json {
    FILE *stream;
    bool comma; /* the next value needs one in front */
};

/* `bracket` is one of { [ and } ]. */
void json_open(struct json *json, const char *key, char bracket);
void json_close(struct json *json, char bracket);
/* Bytes that are not UTF-8 become U+FFFD; NULL becomes null. */
void json_text(struct json *json, const char *key, const char *text);
/* What is not finite becomes null. */
void json_number(struct json *json, const char *key, double number);
void json_bool(struct json *json, const char *key, bool value);

#endif
