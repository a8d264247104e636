#include "cli/flags.h"

#include "cli/options.h"
#include "dapple/image.h"

#include <stdio.h>

/* Where the value goes, what the flag accepts and what it is when not given: parts of the lines below. */
#define TO(member) .offset = offsetof(struct options, member)
#define RANGE(minimum_, maximum_, unit_) .minimum = minimum_, .maximum = maximum_, .unit = unit_
#define SCENE_VALUE(key_) .type = VALUE_SETTING, .key = key_, .default_text = "the scene's"

const struct flag flags[FLAG_COUNT] = {
    [FLAG_OUTPUT] = {"--output", "-o", "OUT",
                     "the file to write; its ending says the format; with %04d: numbered files", .type = VALUE_TEXT,
                     TO(output)},
    [FLAG_SET] = {"--set", NULL, "SECTION.KEY=VALUE",
                  "change a value of the scene (`dapple list params`); may be repeated", .type = VALUE_SETTING},
    [FLAG_TIME] = {"--time", NULL, "S", "time of the first picture", .type = VALUE_NUMBER, TO(time),
                   RANGE(-1e6, 1e6, "s")},
    [FLAG_FRAMES] = {"--frames", NULL, "N", "how many pictures", .type = VALUE_WHOLE, TO(frames),
                     RANGE(1, FRAMES_MAX, NULL)},
    [FLAG_FPS] = {"--fps", NULL, "F", "pictures a second", .type = VALUE_NUMBER, TO(fps), RANGE(0.01, 1000, "1/s"),
                  .initial = 30},
    [FLAG_SIZE] = {"--size", NULL, "WxH", "width and height of the picture", .type = VALUE_SIZE, TO(size),
                   RANGE(1, DPL_IMAGE_SIDE_MAX, "pixels"), .default_text = "1280x720"},
    [FLAG_MAP] = {"--map", NULL, "N", "side of the caustic map, texels", SCENE_VALUE("caustics.map")},
    [FLAG_TECHNIQUE] = {"--technique", NULL, "NAME", "what computes the caustic map (`dapple list techniques`)",
                        SCENE_VALUE("caustics.technique")},
    [FLAG_AGAINST] = {"--against", NULL, "NAME", "the technique that stands for the truth", .type = VALUE_TEXT,
                      TO(against), .default_text = DEFAULT_AGAINST},
    [FLAG_LOOK] = {"--look", NULL, "NAME", "compare pictures: by the scene's own look, against those by this one",
                   .type = VALUE_TEXT, TO(look)},
    [FLAG_SEED] = {"--seed", NULL, "N", "start of everything random", SCENE_VALUE("scene.seed")},
    [FLAG_DEVICE] = {"--device", NULL, "NAME", "where the water and its light are computed", .type = VALUE_CHOICE,
                     TO(device), .choices = {"auto", "gl", "cpu"}},
    [FLAG_BITS] = {"--bits", NULL, "N", "bits a channel of a .png", .type = VALUE_CHOICE, TO(bits),
                   .choices = {"8", "16"}},
    [FLAG_WHITE] = {"--white", NULL, "V", "value of the map that is white in a .png", .type = VALUE_NUMBER, TO(white),
                    RANGE(1e-6, 1e6, NULL), .initial = 1},
    [FLAG_SECONDS] = {"--seconds", NULL, "S", "time for a map or picture that is refined (reference, path-traced)",
                      .type = VALUE_NUMBER, TO(seconds), RANGE(0, 1e6, "s"), .default_text = "until it is finished"},
    [FLAG_SLICE] = {"--slice", NULL, "K", "which of the maps of caustics.slices; 0 = the floor", .type = VALUE_WHOLE,
                    TO(slice), RANGE(0, 63, NULL)},
    [FLAG_SHADERS] = {"--shaders", NULL, "DIR", "read shaders from this folder (the source's src/), not those built in",
                      .type = VALUE_TEXT, TO(shaders)},
    [FLAG_MARKDOWN] = {"--markdown", NULL, NULL, "params: as the reference page of the documentation",
                       .type = VALUE_NONE, TO(markdown)},
    [FLAG_JSON] = {"--json", NULL, NULL, "write the result as one JSON object, for scripts", .type = VALUE_NONE,
                   TO(json)},
    [FLAG_QUIET] = {"--quiet", NULL, NULL, "no progress bar, and no summary of what was written", .type = VALUE_NONE,
                    TO(quiet)},
    [FLAG_HELP] = {"--help", "-h", NULL, "show this help", .type = VALUE_NONE, TO(help)},
};

static void describe_choices(const struct flag *flag, char *text, size_t size)
{
    size_t used = (size_t)snprintf(text, size, "one of ");
    for (int i = 0; flag->choices[i] && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : "", flag->choices[i]);
}

void flag_describe(const struct flag *flag, char *text, size_t size)
{
    const char *unit = flag->unit ? flag->unit : "", *space = flag->unit ? " " : "";
    switch (flag->type) {
    case VALUE_NUMBER:
    case VALUE_WHOLE:
        snprintf(text, size, "%s from %.9g to %.9g%s%s", flag->type == VALUE_WHOLE ? "a whole number" : "a number",
                 flag->minimum, flag->maximum, space, unit);
        break;
    case VALUE_SIZE:
        snprintf(text, size, "two whole numbers from %.9g to %.9g%s%s, as in 640x360", flag->minimum, flag->maximum,
                 space, unit);
        break;
    case VALUE_CHOICE:
        describe_choices(flag, text, size);
        break;
    case VALUE_SETTING:
        snprintf(text, size, "%s%s", flag->key ? "a value of " : "section.key=value, as in sun.elevation=30",
                 flag->key ? flag->key : "");
        break;
    default:
        snprintf(text, size, "%s", flag->value ? flag->value : "no value");
    }
}
