#include "cli/commands.h"

#include "dapple/param.h"

#include <stdio.h>
#include <string.h>

/* Flags that choose and change a scene and say where it is computed. */
#define SCENE_FLAGS                                                                                                    \
    (FLAG_BIT(FLAG_SET) | FLAG_BIT(FLAG_MAP) | FLAG_BIT(FLAG_TECHNIQUE) | FLAG_BIT(FLAG_SEED) |                        \
     FLAG_BIT(FLAG_DEVICE) | FLAG_BIT(FLAG_SHADERS) | FLAG_BIT(FLAG_HELP))
/* Flags of the commands that write files. */
#define FILE_FLAGS                                                                                                     \
    (SCENE_FLAGS | FLAG_BIT(FLAG_OUTPUT) | FLAG_BIT(FLAG_TIME) | FLAG_BIT(FLAG_FRAMES) | FLAG_BIT(FLAG_FPS) |          \
     FLAG_BIT(FLAG_BITS) | FLAG_BIT(FLAG_JSON) | FLAG_BIT(FLAG_QUIET))

const struct command commands[] = {
    {
        .name = "render",
        .operand = "[SCENE]",
        .help = "a picture, numbered pictures or a video",
        .more = "OUT ends in .png, .exr or .pfm (a picture; with %04d in its name: numbered pictures), or in .mp4,\n"
                ".webm or .gif (a video, through ffmpeg). Needs OpenGL, but no display.\n",
        .examples = {"render collard-3 --time 2.5 -o water.png", "render --frames 120 --size 1920x1080 -o water.mp4"},
        .frames = "1; of a video scene.loop x fps, or 120 where the scene does not loop",
        .flags = FILE_FLAGS | FLAG_BIT(FLAG_SIZE) | FLAG_BIT(FLAG_SECONDS),
        .run = command_render,
    },
    {
        .name = "map",
        .operand = "[SCENE]",
        .help = "the caustic map of the floor",
        .more =
            "OUT ends in .png (clamped), .exr or .pfm (linear, unclamped). From a physical "
            "technique 1 is the light under flat water; multi-sample gives a brightness from 0 to 1. --white "
            "brightens a dim .png.\n"
            "The technique reference is the ground truth, photon by photon: what chance adds to it is printed as\n"
            "noise, a share of the map; --set reference.file=NAME keeps the photons for a later run to go on from.\n",
        .examples = {"map --map 2048 -o caustics.exr",
                     "map my-pool.ini --white 4 --bits 16 --frames 60 -o map-%04d.png"},
        .frames = "1",
        .flags = FILE_FLAGS | FLAG_BIT(FLAG_WHITE) | FLAG_BIT(FLAG_SECONDS) | FLAG_BIT(FLAG_SLICE),
        .run = command_map,
    },
    {
        .name = "surface",
        .operand = "[SCENE]",
        .help = "the water's height and slopes on its own grid",
        .more = "Red is the height in metres, green and blue are the slopes along x and z. OUT ends in .exr or .pfm\n"
                "(as they are) or .png (0.5 + 0.5 v/r, where r is the largest |v| of the channel; r is printed).\n",
        .examples = {"surface collard-4 -o water.pfm",
                     "surface --set collard.amplitude=0.1 --time 3 --bits 16 -o water.png"},
        .frames = "1",
        .flags = FILE_FLAGS,
        .run = command_surface,
    },
    {
        .name = "compare",
        .operand = "[SCENE]",
        .help = "techniques against a reference, or two looks: error, energy, difference to the eye, time",
        .more =
            "error is the relative root mean square sqrt(sum (E-R)^2 / sum R^2) over the map, the noise of the\n"
            "reference taken out; p99 the 99th percentile of |E-R| in units of the mean of R, noise and all; energy\n"
            "mean E / mean R. A technique without a physical scale is multiplied by the gain of least error first.\n"
            "FLIP (Andersson et al. 2020) is of the maps as the sheet shows them: 0 looks the same. ms is the time of\n"
            "water and light on this device. --technique may be repeated; without it all are compared. [reference]\n"
            "says how exact the reference is made. OUT is a contact sheet: .png, .exr or .pfm.\n"
            "With --look the scene's picture is compared with that of another look: error, p99 and energy are of\n"
            "radiance, over means of 4 x 4 pixels; FLIP is of the pictures. Needs OpenGL.\n",
        .examples = {"compare shallows --map 256 --seconds 60 -o sheet.png",
                     "compare reef-shafts --look path-traced --size 320x180 -o looks.png"},
        .flags = SCENE_FLAGS | FLAG_BIT(FLAG_AGAINST) | FLAG_BIT(FLAG_LOOK) | FLAG_BIT(FLAG_SIZE) |
                 FLAG_BIT(FLAG_SECONDS) | FLAG_BIT(FLAG_OUTPUT) | FLAG_BIT(FLAG_TIME) | FLAG_BIT(FLAG_JSON) |
                 FLAG_BIT(FLAG_QUIET),
        .run = command_compare,
    },
    {
        .name = "bench",
        .operand = "[SCENE]",
        .help = "time of a frame and of each of its passes on this device",
        .more = "Whole frames are timed first, then each pass by itself, waiting for the device after each: the\n"
                "passes together may take longer than the frame.\n",
        .examples = {"bench --size 1920x1080", "bench collard-2 --map 2048 --frames 101 --json"},
        .frames = "21",
        .flags = SCENE_FLAGS | FLAG_BIT(FLAG_FRAMES) | FLAG_BIT(FLAG_SIZE) | FLAG_BIT(FLAG_JSON) | FLAG_BIT(FLAG_QUIET),
        .run = command_bench,
    },
    {
        .name = "view",
        .operand = "[SCENE]",
        .help = "the scene in a window",
        .more = "Drag to look round, the wheel to come nearer; the panel lists all keys. In a scene with a ball, drag "
                "that;\n"
                "where water can be splashed (`ripples`), stroke it. Space holds time, G gives the ball weight, L puts "
                "the\n"
                "sun where the eye is. Without a GPU a small --size helps.\n"
                "Needs a display, and a build with GLFW and Dear ImGui (Debian: libglfw3-dev libimgui-dev).\n",
        .examples = {"view pool", "view collard-4 --size 1920x1080"},
        .flags = SCENE_FLAGS | FLAG_BIT(FLAG_TIME) | FLAG_BIT(FLAG_SIZE),
        .run = command_view,
    },
    {
        .name = "list",
        .operand = "scenes|waters|techniques|looks|params [PREFIX]",
        .help = "what there is, with a line on each",
        .more =
            "params are the values of a scene: for scene files and --set; of those whose names start with PREFIX.\n",
        .words = 2,
        .examples = {"list scenes", "list params sun."},
        .flags = FLAG_BIT(FLAG_JSON) | FLAG_BIT(FLAG_MARKDOWN) | FLAG_BIT(FLAG_HELP),
        .run = command_list,
    },
    {
        .name = "info",
        .help = "the device, its limits, versions, and what falls back to what",
        .more = "",
        .examples = {"info", "info --json"},
        .flags = FLAG_BIT(FLAG_JSON) | FLAG_BIT(FLAG_HELP),
        .run = command_info,
    },
    {
        .name = "help",
        .operand = "[COMMAND]",
        .help = "what the program or one of its commands does",
        .more = "",
        .examples = {"help", "help render"},
        .flags = FLAG_BIT(FLAG_HELP),
        .run = command_help,
    },
    {.name = NULL},
};

const struct command *command_find(const char *name)
{
    for (const struct command *command = commands; command->name; command++)
        if (!strcmp(command->name, name))
            return command;
    return NULL;
}

static const char *command_name(const void *user, int i)
{
    (void)user;
    return commands[i].name;
}

void command_hint(const char *word, char *text, size_t size)
{
    dpl_hint(word, command_name, NULL, text, size);
}

void command_names(char *text, size_t size)
{
    size_t used = 0;
    for (const struct command *command = commands; command->name && used < size; command++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", used ? ", " : "", command->name);
}
