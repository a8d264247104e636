#include "dapple/param.h"

#include <stdio.h>
#include <string.h>

#define LENGTH_MAX 31 /* bytes of a word that count */

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* Letters to insert, delete or replace to get from one word to the other (Levenshtein's distance). */
static int edit_distance(const char *from, const char *to)
{
    int row[LENGTH_MAX + 1];
    int width = (int)strnlen(to, LENGTH_MAX);
    for (int i = 0; i <= width; i++)
        row[i] = i;
    for (int j = 1; j <= LENGTH_MAX && from[j - 1]; j++) {
        int diagonal = row[0];
        row[0] = j;
        for (int i = 1; i <= width; i++) {
            int replaced = diagonal + (from[j - 1] != to[i - 1]);
            diagonal = row[i];
            row[i] = least(replaced, least(row[i], row[i - 1]) + 1);
        }
    }
    return row[width];
}

void dpl_hint(const char *word, const char *(*name)(const void *user, int i), const void *user, char *text, size_t size)
{
    int nearest = ((int)strnlen(word, LENGTH_MAX) + 1) / 3 + 1; /* a third of the letters may be wrong */
    *text = '\0';
    for (int i = 0; name(user, i); i++) {
        int distance = edit_distance(word, name(user, i));
        if (distance >= nearest)
            continue;
        nearest = distance;
        snprintf(text, size, "did you mean \"%s\"? ", name(user, i));
    }
}
