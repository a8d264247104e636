#include "viewer/input.h"

#include "viewer/panel.h"

const struct input_key *input_keys(void)
{
    static const struct input_key keys[] = {
        {"left drag", "round the target"},
        {"wheel", "nearer, farther"},
        {"right drag", "look around"},
        {"W A S D", "fly"},
        {"space, ctrl", "fly up, down"},
        {"shift", "fly faster"},
        {"P", "pause, play"},
        {"N", "step of 1/60 s"},
        {"F2", "screenshot"},
        {"F5", "load files anew"},
        {"H", "hide the panels"},
        {"escape", "quit"},
        {NULL, NULL},
    };
    return keys;
}

static void press_key(GLFWwindow *window, int key, int scancode, int action, int modifiers)
{
    struct commands *commands = &((struct input *)glfwGetWindowUserPointer(window))->commands;
    (void)scancode, (void)modifiers;
    if (action != GLFW_PRESS || panel_wants_keyboard())
        return;
    switch (key) {
    case GLFW_KEY_P:
        commands->pause = !commands->pause;
        break;
    case GLFW_KEY_N:
        commands->step = true;
        break;
    case GLFW_KEY_F2:
        commands->screenshot = true;
        break;
    case GLFW_KEY_F5:
        commands->reload = true;
        break;
    case GLFW_KEY_H:
        commands->hide = !commands->hide;
        break;
    case GLFW_KEY_ESCAPE:
        commands->quit = true;
        break;
    default:
        break;
    }
}

static void move_mouse(GLFWwindow *window, double x, double y)
{
    struct input *input = glfwGetWindowUserPointer(window);
    double right = x - input->x, down = y - input->y;
    bool orbits = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    bool looks = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
    input->x = x;
    input->y = y;
    if (panel_wants_mouse() || orbits == looks)
        return;
    double *drag = orbits ? input->camera.orbit : input->camera.look;
    drag[0] += right;
    drag[1] += down;
}

static void turn_wheel(GLFWwindow *window, double across, double up)
{
    struct input *input = glfwGetWindowUserPointer(window);
    (void)across;
    if (!panel_wants_mouse())
        input->camera.wheel += up;
}

void input_start(struct input *input, GLFWwindow *window)
{
    *input = (struct input){0};
    glfwGetCursorPos(window, &input->x, &input->y);
    glfwSetWindowUserPointer(window, input);
    glfwSetKeyCallback(window, press_key);
    glfwSetCursorPosCallback(window, move_mouse);
    glfwSetScrollCallback(window, turn_wheel);
}

static bool held(GLFWwindow *window, int key)
{
    return glfwGetKey(window, key) == GLFW_PRESS;
}

struct camera_input input_take_camera(struct input *input, GLFWwindow *window, double seconds)
{
    struct camera_input camera = input->camera;
    input->camera = (struct camera_input){0};
    camera.seconds = seconds;
    /* Over a panel ctrl and shift belong to its controls. */
    if (panel_wants_keyboard() || panel_wants_mouse())
        return camera;
    camera.forward = held(window, GLFW_KEY_W) - held(window, GLFW_KEY_S);
    camera.right = held(window, GLFW_KEY_D) - held(window, GLFW_KEY_A);
    camera.up = held(window, GLFW_KEY_SPACE) - held(window, GLFW_KEY_LEFT_CONTROL);
    camera.fast = held(window, GLFW_KEY_LEFT_SHIFT) || held(window, GLFW_KEY_RIGHT_SHIFT);
    return camera;
}

struct commands input_take_commands(struct input *input)
{
    struct commands commands = input->commands;
    input->commands = (struct commands){0};
    return commands;
}
