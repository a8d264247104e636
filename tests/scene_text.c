/* Scene text: what is read, what is refused and how that is said, and that a scene changes whole or not at all. */
#include "support.h"

#include "scene/scene.h"

#include <sys/stat.h>

struct fixture {
    struct support_log log;
    struct dpl_scene *scene;
    char folder[64];
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->scene = dpl_scene_create(support_log_start(&fixture->log));
    support_folder_make(fixture->folder);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    dpl_scene_destroy(fixture->scene);
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

/* Reads from a block of exactly that length, so that a sanitizer sees any step beyond it. */
static bool read_bytes(struct dpl_scene *scene, const char *text, size_t length)
{
    char *bytes = malloc(length ? length : 1);
    memcpy(bytes, text, length);
    bool ok = dpl_scene_read(scene, "pool.ini", bytes, length);
    free(bytes);
    return ok;
}

static void value_is(struct fixture *fixture, const char *key, const char *wanted)
{
    char value[512];
    assert_true(dpl_scene_get(fixture->scene, key, value, sizeof value));
    assert_string_equal(value, wanted);
}

/* All bytes that make up the scene, so that two moments can be compared; the caller frees them. */
static unsigned char *copy_of(const struct dpl_scene *scene, size_t *size)
{
    *size = sizeof *scene;
    for (int i = 0; water_models[i]; i++)
        *size += water_models[i]->params_size;
    for (int i = 0; light_techniques[i]; i++)
        *size += light_techniques[i]->params_size;
    unsigned char *copy = malloc(*size), *next = copy + sizeof *scene;
    memcpy(copy, scene, sizeof *scene);
    for (int i = 0; water_models[i]; next += water_models[i++]->params_size)
        if (scene->model_params[i])
            memcpy(next, scene->model_params[i], water_models[i]->params_size);
    for (int i = 0; light_techniques[i]; next += light_techniques[i++]->params_size)
        if (scene->technique_params[i])
            memcpy(next, scene->technique_params[i], light_techniques[i]->params_size);
    return copy;
}

struct sample {
    const char *text;
    const char *key, *value; /* what is then true; NULL: nothing to check */
};

static void texts_are_read(void **state)
{
    static const struct sample samples[] = {
        {"", "sun.elevation", "60"},
        {"\n\n \t\n", "sun.elevation", "60"},
        {"[sun]\nelevation = 5\n", "sun.elevation", "5"},
        {"[sun]\nelevation=5", "sun.elevation", "5"},
        {"[sun]\nelevation = 5", "sun.elevation", "5"},
        {"\xEF\xBB\xBF[sun]\nelevation = 5\n", "sun.elevation", "5"},
        {"\xEF\xBB\xBF; note\n[sun]\nelevation = 5\n", "sun.elevation", "5"},
        {"[sun]\r\nelevation = 5\r\n", "sun.elevation", "5"},
        {"[sun]\r\nelevation = 5\r", "sun.elevation", "5"},
        {"# note\n; note\n[sun]\n  # note\n\t; note\nelevation = 5\n", "sun.elevation", "5"},
        {"[sun] ; note\nelevation = 5 ; note\n", "sun.elevation", "5"},
        {"[sun] # note\nelevation = 5 # note # more ; more\n", "sun.elevation", "5"},
        {"[sun]\t# note\nelevation = 5\t# note\n", "sun.elevation", "5"},
        {"[sun]\nelevation = 5 \t  \n", "sun.elevation", "5"},
        {"  [sun]\n\televation = 5\n      azimuth = 6\n", "sun.azimuth", "6"},
        {"[sun]\nelevation = 5\nelevation = 7\n[scene]\n[sun]\nelevation = 8\n", "sun.elevation", "8"},
        {"[water]\nabsorption = 1 2 3\n", "water.absorption", "1 2 3"},
        {"[water]\nabsorption = 1, 2,\t3\n", "water.absorption", "1 2 3"},
        {"[multi-sample]\nsun_map = my moon#1;2.png\n", "multi-sample.sun_map", "my moon#1;2.png"},
        {"[multi-sample]\nsun_map = größer.png\n", "multi-sample.sun_map", "größer.png"},
        {"[multi-sample]\nsun_map =\n", "multi-sample.sun_map", ""},
        {"[multi-sample]\nsun_map = a  b.png\n", "multi-sample.sun_map", "a  b.png"},
        {"[wave.1]\ncycles = 3 1\n[wave.64]\nphase = 90\n", "wave.64.phase", "90"},
        {"[object.a]\nturn = 5\n[object.B-2]\nsize = 1 2 3\n[object.a]\ntilt = 7\n", "object.a.turn", "5"},
        {"[object.a]\nturn = 5\n[object.B-2]\nsize = 1 2 3\n[object.a]\ntilt = 7\n", "object.B-2.size", "1 2 3"},
        {"[object.a]\n", "object.a.turn", "0"},
    };
    struct fixture *fixture = *state;
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) {
        if (!read_bytes(fixture->scene, samples[i].text, strlen(samples[i].text)))
            fail_msg("%zu: %s", i, fixture->log.text);
        value_is(fixture, samples[i].key, samples[i].value);
    }
}

static void a_long_comment_is_no_long_line(void **state)
{
    struct fixture *fixture = *state;
    char text[4096] = "[sun] ; ";
    memset(text + strlen(text), 'x', 3000);
    strcat(text, "\nelevation = 5\n");
    assert_true(read_bytes(fixture->scene, text, strlen(text)));
    value_is(fixture, "sun.elevation", "5");
}

static void values_that_are_not_named_get_their_defaults(void **state)
{
    struct fixture *fixture = *state;
    assert_true(read_bytes(fixture->scene, "[sun]\nelevation = 5\n[wave.2]\nphase = 1\n[object.a]\nturn=1\n", 57));
    assert_true(read_bytes(fixture->scene, "[scene]\nsize = 2\n", 17));
    value_is(fixture, "sun.elevation", "60");
    value_is(fixture, "scene.size", "2");
    for (int i = 0; dpl_scene_section(fixture->scene, i).name; i++)
        assert_true(strncmp(dpl_scene_section(fixture->scene, i).name, "wave.", 5) != 0 &&
                    strncmp(dpl_scene_section(fixture->scene, i).name, "object.", 7) != 0);
}

struct refusal {
    const char *text;
    enum dpl_reason reason;
    const char *place, *found, *accepted; /* parts of the message */
};

static const struct refusal refusals[] = {
    {"[sun]\nelevatoin = 5\n", DPL_REASON_UNKNOWN_KEY, "pool.ini:2: sun.elevatoin", "elevatoin", "elevation, azimuth"},
    {"[sun]\n\n[moon]\nx = 5\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:3: ", "moon", "sun"},
    {"[sun]\n[moon]\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:2: ", "moon", "wave.1 to wave.64"},
    {"[]\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "", "sun"},
    {"[sun]\nelevation = 91\n", DPL_REASON_RANGE, "pool.ini:2: sun.elevation", "\"91\"", "1 to 90 degrees"},
    {"\n\n[sun]\r\n elevation = abc ; note\n", DPL_REASON_VALUE, "pool.ini:4: sun.elevation", "\"abc\"", "1 to 90"},
    {"[sun]\nelevation =\n", DPL_REASON_VALUE, "pool.ini:2: sun.elevation", "\"\"", "1 to 90"},
    {"[sun]\nelevation = 5\n = 5\n", DPL_REASON_UNKNOWN_KEY, "pool.ini:3: ", "\"\"", "elevation"},
    {"[water]\nmodel = sinus\n", DPL_REASON_CHOICE, "pool.ini:2: water.model", "\"sinus\"", "one of sines, "},
    {"elevation = 5\n[sun]\n", DPL_REASON_SYNTAX, "pool.ini:1: ", "", "[section]"},
    {"[sun]\nelevation 5\n", DPL_REASON_SYNTAX, "pool.ini:2: ", "", "key = value"},
    {"[sun]\nazimuth = 1\n5\nelevation = 5\n", DPL_REASON_SYNTAX, "pool.ini:3: ", "", "key = value"},
    {"[sun\nelevation = 5\n", DPL_REASON_SYNTAX, "pool.ini:1: ", "", "[section]"},
    {"[sun] elevation = 5\n", DPL_REASON_SYNTAX, "pool.ini:1: ", "", ""},
    {"[sun]\nbad\nelevatoin = 5\n", DPL_REASON_SYNTAX, "pool.ini:2: ", "", ""},
    {"[wave.0]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave.0", "wave.1 to wave.64"},
    {"[wave.65]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave.65", "wave.1 to wave.64"},
    {"[wave.01]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave.01", "wave.1 to wave.64"},
    {"[wave.+1]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave.+1", "wave.1 to wave.64"},
    {"[wave. 1]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave. 1", "wave.1 to wave.64"},
    {"[wave.x]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave.x", "wave.1 to wave.64"},
    {"[wave.1x]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave.1x", "wave.1 to wave.64"},
    {"[wave.100]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave.100", "wave.1 to wave.64"},
    {"[wave]\nphase = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "wave", "wave.1 to wave.64"},
    {"[object]\nturn = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "object", "object.NAME"},
    {"[object.]\nturn = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "object.", "object.NAME"},
    {"[object.a b]\nturn = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "object.a b", "object.NAME"},
    {"[object.a.b]\nturn = 1\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "object.a.b", "object.NAME"},
    {"[object.a23456789012345678901234567890123]\n", DPL_REASON_UNKNOWN_SECTION, "pool.ini:1: ", "", "object.NAME"},
    {"[object.a]\nturn = 361\n", DPL_REASON_RANGE, "pool.ini:2: object.a.turn", "\"361\"", "-360 to 360"},
    {"[object.a]\nshape = hat\n", DPL_REASON_CHOICE, "pool.ini:2: object.a.shape", "\"hat\"", "one of box, "},
    {"[object.a]\nhat = 1\n", DPL_REASON_UNKNOWN_KEY, "pool.ini:2: object.a.hat", "\"hat\"", "shape, "},
    {"[sun]\na\v;=5\n", DPL_REASON_SYNTAX, "pool.ini:2: ", "", "key = value"},
    {"\x89PNG\r\n\x1a\n\x01\x02\x03\xff\xfe\n", DPL_REASON_SYNTAX, "pool.ini:", "", ""},
};

/* Refuses the text with one message, and leaves every byte of the scene alone. */
static void expect_refused(struct fixture *fixture, const char *text, size_t length, const struct refusal *refusal)
{
    size_t size;
    unsigned char *before = copy_of(fixture->scene, &size);
    if (read_bytes(fixture->scene, text, length))
        fail_msg("is read: %s", text);
    unsigned char *after = copy_of(fixture->scene, &size);
    EXPECT_ERROR(&fixture->log, refusal->reason, refusal->place, refusal->found, refusal->accepted);
    assert_memory_equal(before, after, size);
    free(before);
    free(after);
}

static void wrong_texts_are_refused_and_change_nothing(void **state)
{
    struct fixture *fixture = *state;
    assert_true(read_bytes(fixture->scene, "[sun]\nelevation = 7\n[wave.3]\nphase = 5\n", 39));
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++)
        expect_refused(fixture, refusals[i].text, strlen(refusals[i].text), refusals + i);
    value_is(fixture, "sun.elevation", "7");
}

static void long_lines_are_refused(void **state)
{
    static const struct refusal refusal = {NULL, DPL_REASON_SYNTAX, "pool.ini:2: ", "too long", ""};
    struct fixture *fixture = *state;
    for (size_t length = 250; length < 100000; length *= 4) {
        char *text = calloc(1, length + 64);
        strcpy(text, "[multi-sample]\nsun_map = ");
        memset(text + strlen(text), 'x', length);
        expect_refused(fixture, text, strlen(text), &refusal);
        strcat(text, "\nsteps = 2\n");
        expect_refused(fixture, text, strlen(text), &refusal);
        free(text);
    }
}

static void zero_bytes_are_refused(void **state)
{
    static const struct refusal refusal = {NULL, DPL_REASON_FILE_FORMAT, "pool.ini", "zero bytes", ""};
    expect_refused(*state, "[sun]\0\nelevation = 5\n", 21, &refusal);
    expect_refused(*state, "[sun]\nelevation = 5\n", 21, &refusal);
}

static void every_number_of_a_wave_is_its_own_section(void **state)
{
    struct fixture *fixture = *state;
    char text[4096] = "", key[32], wanted[32];
    for (int i = 1; i <= WATER_WAVES_MAX; i++)
        sprintf(text + strlen(text), "[wave.%d]\nphase = %d\n", i, i);
    assert_true(read_bytes(fixture->scene, text, strlen(text)));
    for (int i = 1; i <= WATER_WAVES_MAX; i++) {
        snprintf(key, sizeof key, "wave.%d.phase", i);
        snprintf(wanted, sizeof wanted, "%d", i);
        value_is(fixture, key, wanted);
    }
    struct wave waves[WATER_WAVES_MAX];
    assert_int_equal(scene_water_setup(fixture->scene, waves).wave_count, WATER_WAVES_MAX);
}

static void objects_are_as_many_as_there_is_room_for(void **state)
{
    static const struct refusal refusal = {NULL, DPL_REASON_LIMIT, "pool.ini:193: ", "object.n64", "at most 64"};
    struct fixture *fixture = *state;
    char text[8192] = "", key[32], wanted[32];
    for (int i = 0; i < SCENE_OBJECTS_MAX; i++)
        sprintf(text + strlen(text), "[object.n%d]\nturn = %d\nsize = 1 1 1\n", i, i);
    assert_true(read_bytes(fixture->scene, text, strlen(text)));
    for (int i = 0; i < SCENE_OBJECTS_MAX; i++) {
        snprintf(key, sizeof key, "object.n%d.turn", i);
        snprintf(wanted, sizeof wanted, "%d", i);
        value_is(fixture, key, wanted);
    }
    sprintf(text + strlen(text), "[object.n64]\nturn = 1\n");
    expect_refused(fixture, text, strlen(text), &refusal);
    assert_false(dpl_scene_set(fixture->scene, "object.more.turn", "1"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_LIMIT, "object.more.turn", "at most 64");
    support_set(fixture->scene, "object.n63.turn", "5");
    value_is(fixture, "object.n63.turn", "5");
}

/* A value that is refused makes no object. */
static void an_object_needs_a_value_that_is_taken(void **state)
{
    struct fixture *fixture = *state;
    assert_false(dpl_scene_set(fixture->scene, "object.a.turn", "north"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_VALUE, "object.a.turn", "\"north\"");
    assert_int_equal(fixture->scene->object_count, 0);
    support_set(fixture->scene, "object.a.turn", "%d", 4);
    assert_int_equal(fixture->scene->object_count, 1);
}

/* 1 to 12 changes to a text, each of one of eight kinds. */
static size_t mutate(uint64_t *random, char *text, size_t length, size_t room)
{
    static const char *const pieces[] = {"[",
                                         "]",
                                         "=",
                                         "\n",
                                         "\r\n",
                                         "[wave.65]\n",
                                         "[wave.7]\ncycles = 2 3\n",
                                         "1e999",
                                         "nan",
                                         " #",
                                         " ;",
                                         "-",
                                         "\xEF\xBB\xBF",
                                         "size = 1\n",
                                         "  ",
                                         "0",
                                         "[object.a]\nsize = 2 1 3\n"};
    for (uint32_t changes = 1 + support_random(random) % 12; changes > 0; changes--) {
        size_t place = length ? support_random(random) % length : 0;
        size_t count = 1 + support_random(random) % 20;
        const char *piece = pieces[support_random(random) % (sizeof pieces / sizeof *pieces)];
        uint32_t kind = support_random(random) % 8;
        count = count > length - place ? length - place : count;
        if (kind == 0 && length) {
            text[place] = (char)support_random(random);
        } else if (kind == 1) {
            memmove(text + place, text + place + count, length - place - count);
            length -= count;
        } else if (kind == 2 && length + count < room) {
            memmove(text + place + count, text + place, length - place);
            length += count;
        } else if (kind == 3 && support_random(random) % 8 == 0) {
            length = place;
        } else if (kind >= 4 && length + strlen(piece) < room) {
            memmove(text + place + strlen(piece), text + place, length - place);
            memcpy(text + place, piece, strlen(piece));
            length += strlen(piece);
        }
    }
    return length;
}

/* Every value of the scene is one that would be accepted. */
static void expect_whole(struct fixture *fixture, struct dpl_scene *other)
{
    for (int i = 0; dpl_scene_section(fixture->scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(fixture->scene, i);
        for (const struct dpl_param *param = section.params; param->name; param++) {
            char key[128], value[512];
            snprintf(key, sizeof key, "%s.%s", section.name, param->name);
            assert_true(dpl_param_format(param, section.values, value, sizeof value));
            assert_true(dpl_scene_set(other, key, value));
        }
    }
}

static const char *builtin_text(const char *name)
{
    const struct dpl_builtin_scene *scene = dpl_builtin_scenes();
    while (strcmp(scene->name, name) != 0)
        scene++;
    return scene->text;
}

static void mutated_texts_never_leave_half_a_scene(void **state)
{
    struct fixture *fixture = *state;
    struct dpl_scene *other = dpl_scene_create(NULL);
    const char *seed = builtin_text("calm-pool"); /* short, so that some of its mutations are right */
    uint64_t random = 20220101;
    size_t size;
    int read = 0, refused = 0;
    unsigned char *before = copy_of(fixture->scene, &size);
    for (int i = 0; i < 20000; i++) {
        char text[4096];
        size_t length = strlen(seed);
        memcpy(text, seed, length);
        length = mutate(&random, text, length, sizeof text);
        support_log_start(&fixture->log);
        if (read_bytes(fixture->scene, text, length)) {
            assert_int_equal(fixture->log.errors, 0);
            if (read++ % 16 == 0)
                expect_whole(fixture, other);
            free(before);
            before = copy_of(fixture->scene, &size);
        } else {
            refused++;
            assert_int_equal(fixture->log.errors, 1);
            unsigned char *after = copy_of(fixture->scene, &size);
            assert_memory_equal(before, after, size);
            free(after);
        }
    }
    assert_true(read > 1000 && refused > 1000);
    free(before);
    dpl_scene_destroy(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(texts_are_read, setup, teardown),
        cmocka_unit_test_setup_teardown(a_long_comment_is_no_long_line, setup, teardown),
        cmocka_unit_test_setup_teardown(values_that_are_not_named_get_their_defaults, setup, teardown),
        cmocka_unit_test_setup_teardown(wrong_texts_are_refused_and_change_nothing, setup, teardown),
        cmocka_unit_test_setup_teardown(long_lines_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(zero_bytes_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(every_number_of_a_wave_is_its_own_section, setup, teardown),
        cmocka_unit_test_setup_teardown(objects_are_as_many_as_there_is_room_for, setup, teardown),
        cmocka_unit_test_setup_teardown(an_object_needs_a_value_that_is_taken, setup, teardown),
        cmocka_unit_test_setup_teardown(mutated_texts_never_leave_half_a_scene, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
