/* Every entry of every table of a scene: what it says of itself, and which texts it takes and refuses. */
#include "support.h"

#include <math.h>

struct fixture {
    struct support_log log;
    struct dpl_scene *scene;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->scene = dpl_scene_create(support_log_start(&fixture->log));
    support_set(fixture->scene, "wave.1.phase", "0"); /* so that the waves' table is met as well, and the objects' */
    support_set(fixture->scene, "object.a.seed", "1");
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    dpl_scene_destroy(fixture->scene);
    free(fixture);
    return 0;
}

/* One entry on its way through a check. */
struct entry {
    struct fixture *fixture;
    struct dpl_section section;
    const struct dpl_param *param;
    char key[128]; /* section.key */
};

static void every_entry(struct fixture *fixture, void (*check)(struct entry *entry))
{
    int entries = 0;
    for (int i = 0; dpl_scene_section(fixture->scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(fixture->scene, i);
        for (const struct dpl_param *param = section.params; param->name; param++, entries++) {
            struct entry entry = {fixture, section, param, ""};
            snprintf(entry.key, sizeof entry.key, "%s.%s", section.name, param->name);
            check(&entry);
            if (fixture->log.errors)
                print_error("%s: %s\n", entry.key, fixture->log.text);
            assert_int_equal(fixture->log.errors, 0);
        }
    }
    assert_true(entries > 40);
}

static bool is_number(const struct dpl_param *param)
{
    return param->type == DPL_PARAM_FLOAT || param->type == DPL_PARAM_INT || param->type == DPL_PARAM_COLOR;
}

/* The text of `count` numbers: `special` at one place, `other` at the rest. */
static void numbers_text(char text[256], int count, int place, const char *special, double other)
{
    size_t used = 0;
    for (int i = 0; i < count; i++) {
        if (i == place)
            used += (size_t)snprintf(text + used, 256 - used, "%s%s", i ? " " : "", special);
        else
            used += (size_t)snprintf(text + used, 256 - used, "%s%.17g", i ? " " : "", other);
    }
}

static void get(const struct entry *entry, char text[512])
{
    assert_true(dpl_scene_get(entry->fixture->scene, entry->key, text, 512));
}

/* Accepts the text, and writes it in a way that reads back to the same. */
static void expect_accepted(const struct entry *entry, const char *text)
{
    char first[512], second[512];
    if (!dpl_scene_set(entry->fixture->scene, entry->key, text))
        fail_msg("%s = %s: %s", entry->key, text, entry->fixture->log.text);
    get(entry, first);
    assert_true(dpl_scene_set(entry->fixture->scene, entry->key, first));
    get(entry, second);
    assert_string_equal(first, second);
}

/* Refuses the text for that reason, says where, what and what would do, and keeps the value. */
static void expect_refused(const struct entry *entry, const char *text, enum dpl_reason reason)
{
    char before[512], after[512], accepted[512];
    get(entry, before);
    if (dpl_scene_set(entry->fixture->scene, entry->key, text))
        fail_msg("%s takes \"%s\"", entry->key, text);
    dpl_param_describe(entry->param, accepted, sizeof accepted);
    EXPECT_ERROR(&entry->fixture->log, reason, entry->key, text, accepted);
    get(entry, after);
    assert_string_equal(before, after);
}

static void check_description(struct entry *entry)
{
    const struct dpl_param *param = entry->param;
    assert_non_null(param->unit);
    assert_non_null(param->help);
    assert_true(strlen(param->help) > 0);
    assert_null(strpbrk(param->help, "\n"));
    assert_in_range(param->count, 1, 3);
    for (const struct dpl_param *other = entry->section.params; other != param; other++)
        assert_string_not_equal(other->name, param->name);
    assert_true((param->choice != NULL) == (param->type == DPL_PARAM_CHOICE));
    char accepted[512];
    dpl_param_describe(param, accepted, sizeof accepted);
    assert_true(strlen(accepted) > 0 && strlen(accepted) < sizeof accepted - 1);
    if (is_number(param) && *param->unit)
        assert_non_null(strstr(accepted, param->unit));
}

static void every_entry_is_described(void **state)
{
    every_entry(*state, check_description);
}

static void section_names_are_unique(void **state)
{
    const struct dpl_scene *scene = ((struct fixture *)*state)->scene;
    for (int i = 0; dpl_scene_section(scene, i).name; i++) {
        assert_non_null(dpl_scene_section(scene, i).help);
        for (int k = 0; k < i; k++)
            assert_string_not_equal(dpl_scene_section(scene, i).name, dpl_scene_section(scene, k).name);
    }
}

static void check_default(struct entry *entry)
{
    const struct dpl_param *param = entry->param;
    char now[512];
    get(entry, now);
    expect_accepted(entry, now);
    for (int i = 0; is_number(param) && i < param->count; i++) {
        assert_true(param->minimum < param->maximum);
        assert_true(param->initial[i] >= param->minimum && param->initial[i] <= param->maximum);
        const void *value = (const char *)entry->section.values + param->offset;
        double held = param->type == DPL_PARAM_INT ? ((const int *)value)[i] : ((const double *)value)[i];
        assert_true(held == param->initial[i]);
    }
}

static void defaults_lie_in_range(void **state)
{
    every_entry(*state, check_default);
}

static void check_numbers(struct entry *entry)
{
    const struct dpl_param *param = entry->param;
    if (!is_number(param))
        return;
    uint64_t random = 1;
    for (int i = 0; i < 40; i++) {
        char special[64], text[256];
        double part = i == 0 ? 0 : i == 1 ? 1 : support_random_unit(&random);
        double number = param->minimum + part * (param->maximum - param->minimum);
        number = i == 1 ? param->maximum : param->type == DPL_PARAM_INT ? floor(number) : number;
        snprintf(special, sizeof special, "%.17g", number);
        numbers_text(text, param->count, i % param->count, special, param->minimum);
        expect_accepted(entry, text);
        const void *value = (const char *)entry->section.values + param->offset;
        int place = i % param->count;
        double held = param->type == DPL_PARAM_INT ? ((const int *)value)[place] : ((const double *)value)[place];
        assert_true(held == number);
    }
}

static void numbers_in_range_are_accepted_and_kept_exactly(void **state)
{
    every_entry(*state, check_numbers);
}

static void check_outside(struct entry *entry)
{
    const struct dpl_param *param = entry->param;
    double below = nextafter(param->minimum, -INFINITY), above = nextafter(param->maximum, INFINITY);
    if (!is_number(param))
        return;
    if (param->type == DPL_PARAM_INT) {
        below = param->minimum - 1;
        above = param->maximum + 1;
    }
    char low[64], high[64], text[256];
    snprintf(low, sizeof low, "%.17g", below);
    snprintf(high, sizeof high, "%.17g", above);
    const char *const outside[] = {low, high, "nan", "NAN", "inf", "-inf", "1e999", "-1e999", NULL};
    for (int place = 0; place < param->count; place++) {
        for (int i = 0; outside[i]; i++) {
            numbers_text(text, param->count, place, outside[i], param->minimum);
            expect_refused(entry, text, DPL_REASON_RANGE);
        }
    }
}

static void numbers_outside_are_refused(void **state)
{
    every_entry(*state, check_outside);
}

static void check_malformed(struct entry *entry)
{
    const struct dpl_param *param = entry->param;
    char text[256];
    if (!is_number(param))
        return;
    const char *const words[] = {"", "abc", "-"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        expect_refused(entry, words[i], DPL_REASON_VALUE);
    for (int count = 1; count <= 4; count++) {
        numbers_text(text, count, -1, "", param->maximum);
        if (count != param->count)
            expect_refused(entry, text, DPL_REASON_VALUE);
    }
    numbers_text(text, param->count, -1, "", param->maximum);
    strcat(text, " m");
    expect_refused(entry, text, DPL_REASON_VALUE);
    if (param->type == DPL_PARAM_INT) {
        numbers_text(text, param->count, 0, "2.5", param->maximum);
        expect_refused(entry, text, DPL_REASON_VALUE);
    }
}

static void malformed_numbers_are_refused(void **state)
{
    every_entry(*state, check_malformed);
}

static void check_words(struct entry *entry)
{
    const struct dpl_param *param = entry->param;
    static const char *const bools[] = {"true", "no", "on", "0", "yes", "off", "1", "False", NULL};
    static const char *const not_bools[] = {"", "2", "maybe", "true false", "truely", "1 2 3 4", NULL};
    for (int i = 0; param->type == DPL_PARAM_BOOL && bools[i]; i++) {
        char now[512];
        expect_accepted(entry, bools[i]);
        get(entry, now);
        assert_string_equal(now, i % 2 ? "false" : "true");
    }
    for (int i = 0; param->type == DPL_PARAM_BOOL && not_bools[i]; i++)
        expect_refused(entry, not_bools[i], DPL_REASON_VALUE);
    for (int i = 0; param->type == DPL_PARAM_CHOICE && param->choice(i); i++) {
        char now[512], wrong[128];
        expect_accepted(entry, param->choice(i));
        get(entry, now);
        assert_string_equal(now, param->choice(i));
        snprintf(wrong, sizeof wrong, "%sx", param->choice(i));
        const char *const parts[] = {entry->key, wrong, param->choice(i), NULL};
        assert_false(dpl_scene_set(entry->fixture->scene, entry->key, wrong));
        support_expect(&entry->fixture->log, DPL_REASON_CHOICE, parts);
    }
    static const char *const not_choices[] = {"", "nan", "0", "1 2 3 4", NULL};
    for (int i = 0; param->type == DPL_PARAM_CHOICE && not_choices[i]; i++)
        expect_refused(entry, not_choices[i], DPL_REASON_CHOICE);
}

static void words_are_those_of_the_list(void **state)
{
    every_entry(*state, check_words);
}

static void check_text(struct entry *entry)
{
    char text[DPL_PARAM_TEXT_SIZE + 1], now[512];
    if (entry->param->type != DPL_PARAM_TEXT)
        return;
    memset(text, 'x', sizeof text);
    text[DPL_PARAM_TEXT_SIZE] = '\0';
    assert_false(dpl_scene_set(entry->fixture->scene, entry->key, text));
    EXPECT_ERROR(&entry->fixture->log, DPL_REASON_RANGE, entry->key, "xxxxxxxx");
    text[DPL_PARAM_TEXT_SIZE - 1] = '\0';
    expect_accepted(entry, text);
    get(entry, now);
    assert_string_equal(now, text);
    expect_accepted(entry, "a folder/sun;1#2.png");
    expect_accepted(entry, "");
}

static void texts_have_a_longest_length(void **state)
{
    every_entry(*state, check_text);
}

static void check_room(struct entry *entry)
{
    char text[512], small[512];
    get(entry, text);
    size_t length = strlen(text);
    assert_true(dpl_scene_get(entry->fixture->scene, entry->key, small, length + 1));
    if (length == 0)
        return;
    assert_false(dpl_scene_get(entry->fixture->scene, entry->key, small, length));
    EXPECT_ERROR(&entry->fixture->log, DPL_REASON_LIMIT, entry->key);
}

static void too_little_room_is_noticed(void **state)
{
    every_entry(*state, check_room);
}

static void unknown_names_are_refused(void **state)
{
    struct fixture *fixture = *state;
    assert_false(dpl_scene_set(fixture->scene, "sun.elevatoin", "5"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_UNKNOWN_KEY, "sun.elevatoin", "elevation", "azimuth", "angular_radius");
    assert_false(dpl_scene_set(fixture->scene, "moon.elevation", "5"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_UNKNOWN_SECTION, "moon.elevation", "\"moon\"", "sun", "multi-sample");
    static const char *const malformed[] = {"", "sun", ".elevation", "sun.", ".", NULL};
    for (int i = 0; malformed[i]; i++) {
        char value[64];
        assert_false(dpl_scene_set(fixture->scene, malformed[i], "5"));
        EXPECT_ERROR(&fixture->log, DPL_REASON_UNKNOWN_KEY, "section.key");
        assert_false(dpl_scene_get(fixture->scene, malformed[i], value, sizeof value));
        EXPECT_ERROR(&fixture->log, DPL_REASON_UNKNOWN_KEY, "section.key");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_entry_is_described, setup, teardown),
        cmocka_unit_test_setup_teardown(section_names_are_unique, setup, teardown),
        cmocka_unit_test_setup_teardown(defaults_lie_in_range, setup, teardown),
        cmocka_unit_test_setup_teardown(numbers_in_range_are_accepted_and_kept_exactly, setup, teardown),
        cmocka_unit_test_setup_teardown(numbers_outside_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(malformed_numbers_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(words_are_those_of_the_list, setup, teardown),
        cmocka_unit_test_setup_teardown(texts_have_a_longest_length, setup, teardown),
        cmocka_unit_test_setup_teardown(too_little_room_is_noticed, setup, teardown),
        cmocka_unit_test_setup_teardown(unknown_names_are_refused, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
