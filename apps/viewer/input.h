/* input.h: keys and mouse, as commands and as movements of the camera. What Dear ImGui wants for itself is left to it.
 */
#ifndef VIEWER_INPUT_H
#define VIEWER_INPUT_H

#include "viewer/camera_control.h"
#include "viewer/commands.h"
#include "viewer/touch.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

struct input {
    double x, y;                /* the mouse, in the window's coordinates */
    struct camera_input camera; /* since the last input_take_camera() */
    bool pressed;               /* the left button, since the last input_take_touch() */
    double pressed_x, pressed_y;
    struct commands commands; /* since the last input_take_commands() */
};

/* Listens to the window, whose user pointer it takes. Before the panel, which passes events on. */
void input_start(struct input *input, GLFWwindow *window);

/* What happened since the last call; `seconds` have passed. */
struct camera_input input_take_camera(struct input *input, GLFWwindow *window, double seconds);
struct touch_input input_take_touch(struct input *input, GLFWwindow *window);
struct commands input_take_commands(struct input *input);

/* The keys, for people: NULL-named past the last. */
struct input_key {
    const char *name, *meaning;
};
const struct input_key *input_keys(void);

#endif
