/* tests/support.h: what the tests in C share: a log that remembers, random numbers, a folder for files, and an OpenGL
 * context without a window. Include it first: it includes what cmocka.h needs. */
#ifndef TESTS_SUPPORT_H
#define TESTS_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "dapple/dapple.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SUPPORT_SKIPPED 77 /* exit status by which meson knows a test that could not run */

/* Keeps the last message, and counts the errors. */
struct support_log {
    struct dpl_log log;
    int errors, warnings;
    enum dpl_reason reason;
    char text[1024];
};

static inline void support_write(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    struct support_log *log = user;
    log->errors += level == DPL_LOG_ERROR;
    log->warnings += level == DPL_LOG_WARNING;
    log->reason = reason;
    snprintf(log->text, sizeof log->text, "%s", text);
    assert_null(strchr(text, '\n'));
}

/* Returns the same log, emptied. */
static inline const struct dpl_log *support_log_start(struct support_log *log)
{
    *log = (struct support_log){.log = {support_write, log}};
    return &log->log;
}

/* Checks that the one error since the start has that reason and that its text holds all of `parts`; forgets it. */
static inline void support_expect(struct support_log *log, enum dpl_reason reason, const char *const parts[])
{
    if (log->errors != 1 || log->reason != reason)
        print_error("%d errors, last with reason %d: %s\n", log->errors, (int)log->reason, log->text);
    assert_int_equal(log->errors, 1);
    assert_int_equal(log->reason, reason);
    for (; *parts; parts++) {
        if (!strstr(log->text, *parts))
            print_error("\"%s\" is not in: %s\n", *parts, log->text);
        assert_non_null(strstr(log->text, *parts));
    }
    support_log_start(log);
}
#define EXPECT_ERROR(log, reason, ...) support_expect(log, reason, (const char *const[]){__VA_ARGS__, NULL})

/* Random numbers that are the same in every run (xorshift64*, Vigna 2016). Start with any number but 0. */
static inline uint32_t support_random(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (uint32_t)(*state * 2685821657736338717u >> 32);
}

/* 0 to 1, without 1. */
static inline double support_random_unit(uint64_t *state)
{
    return support_random(state) / 4294967296.0;
}

/* Writes a text into a file of a folder. */
static inline void support_file_write(const char *folder, const char *name, const char *text)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    fputs(text, stream);
    fclose(stream);
}

/* A new scene from scene text. */
static inline struct dpl_scene *support_scene(const char *text, const struct dpl_log *log)
{
    struct dpl_scene *scene = dpl_scene_create(log);
    assert_non_null(scene);
    assert_true(dpl_scene_read(scene, "test", text, strlen(text)));
    return scene;
}

/* Sets a value as text made from the arguments. */
static inline void support_set(struct dpl_scene *scene, const char *key, const char *format, ...)
{
    char value[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(value, sizeof value, format, arguments);
    va_end(arguments);
    assert_true(dpl_scene_set(scene, key, value));
}

/* A picture for the water model `heightfield`: bumps of 0.25, with a slope of their own at every place. */
static inline void support_heights_write(const char *path)
{
    struct dpl_image *image = dpl_image_create(24, 24, NULL);
    for (int i = 0; i < 24 * 24; i++)
        for (int c = 0; c < 3; c++)
            image->pixels[i * 3 + c] = (float)(0.25 * sin(2 * M_PI * (i % 24) / 24) * cos(4 * M_PI * (i / 24) / 24));
    assert_true(dpl_image_save(image, path, NULL, NULL));
    dpl_image_destroy(image);
}

/* A new, empty folder. */
static inline void support_folder_make(char folder[64])
{
    snprintf(folder, 64, "/tmp/dapple-test-XXXXXX");
    assert_non_null(mkdtemp(folder));
}

/* The number of files in the folder; removes them, and then the folder, where `remove` is true. */
static inline int support_folder_count(const char *folder, bool remove)
{
    int count = 0;
    DIR *stream = opendir(folder);
    assert_non_null(stream);
    for (struct dirent *entry; (entry = readdir(stream));) {
        char path[512];
        if (entry->d_name[0] == '.')
            continue;
        count++;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (remove && unlink(path) != 0)
            rmdir(path);
    }
    closedir(stream);
    if (remove)
        rmdir(folder);
    return count;
}

/* Where the test runs as root, whom no permission stops, goes on as nobody, to whom the folder is given. True then. */
static inline bool support_leave_root(const char *folder)
{
    const uid_t nobody = 65534;
    return geteuid() == 0 && chown(folder, nobody, (gid_t)-1) == 0 && seteuid(nobody) == 0;
}

static inline void support_become_root(bool was_root)
{
    if (was_root)
        assert_int_equal(seteuid(0), 0);
}

/* An OpenGL context without a window; skips the test where there is none. */
static inline struct dpl_gl *support_gl(bool es, const struct dpl_log *log)
{
    struct dpl_gl *gl = dpl_gl_create_headless(es, NULL, log);
    if (!gl)
        skip();
    return gl;
}

/* The same where it can draw to floats, which the test needs; skips it elsewhere. */
static inline struct dpl_gl *support_gl_of_floats(bool es, const struct dpl_log *log)
{
    struct dpl_gl *gl = support_gl(es, log);
    if (!dpl_gl_describe(gl)->float_render) {
        dpl_gl_destroy(gl);
        skip();
    }
    return gl;
}

/* True where at least one kind of context can be made. */
static inline bool support_has_gl(void)
{
    struct dpl_gl *gl = dpl_gl_create_headless(false, NULL, NULL);
    gl = gl ? gl : dpl_gl_create_headless(true, NULL, NULL);
    dpl_gl_destroy(gl);
    return gl != NULL;
}

#endif
