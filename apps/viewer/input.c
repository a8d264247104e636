#include "viewer/input.h"

#include "viewer/panel.h"

#include <math.h>

const struct input_key *input_keys(void)
{
    static const struct input_key keys[] = {
        {"left drag", "round the target"},
        {"  on water", "drops (ripples)"},
        {"  on the ball", "moves it"},
        {"wheel", "nearer, farther"},
        {"right drag", "look around"},
        {"W A S D", "fly"},
        {"E, Q", "fly up, down"},
        {"shift", "fly faster"},
        {"P, space", "pause, play"},
        {"N", "step of 1/60 s"},
        {"G", "gravity of the ball"},
        {"L", "sun from the eye"},
        {"K", "key of the camera"},
        {"C", "camera's path"},
        {"F2", "screenshot"},
        {"F3", "still picture"},
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
    bool again = action == GLFW_REPEAT && key == GLFW_KEY_L; /* held down, the sun follows the eye */
    if ((action != GLFW_PRESS && !again) || panel_wants_keyboard())
        return;
    switch (key) {
    case GLFW_KEY_G:
        commands->gravity = !commands->gravity;
        break;
    case GLFW_KEY_L:
        commands->light = true;
        break;
    case GLFW_KEY_P:
    case GLFW_KEY_SPACE:
        commands->pause = !commands->pause;
        break;
    case GLFW_KEY_N:
        commands->step = true;
        break;
    case GLFW_KEY_K:
        commands->add_key = true;
        break;
    case GLFW_KEY_C:
        commands->path = !commands->path;
        break;
    case GLFW_KEY_F3:
        commands->still = true;
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

static void press_button(GLFWwindow *window, int button, int action, int modifiers)
{
    struct input *input = glfwGetWindowUserPointer(window);
    (void)modifiers;
    if (button != GLFW_MOUSE_BUTTON_LEFT || action != GLFW_PRESS || panel_wants_mouse())
        return;
    input->pressed = true;
    glfwGetCursorPos(window, &input->pressed_x, &input->pressed_y);
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
    glfwSetMouseButtonCallback(window, press_button);
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
    /* Over a panel shift belongs to its controls. */
    if (panel_wants_keyboard() || panel_wants_mouse())
        return camera;
    camera.forward = held(window, GLFW_KEY_W) - held(window, GLFW_KEY_S);
    camera.right = held(window, GLFW_KEY_D) - held(window, GLFW_KEY_A);
    camera.up = held(window, GLFW_KEY_E) - held(window, GLFW_KEY_Q);
    camera.fast = held(window, GLFW_KEY_LEFT_SHIFT) || held(window, GLFW_KEY_RIGHT_SHIFT);
    return camera;
}

struct touch_input input_take_touch(struct input *input, GLFWwindow *window)
{
    int width, height;
    glfwGetWindowSize(window, &width, &height);
    double half_width = fmax(width, 1) / 2, half_height = fmax(height, 1) / 2;
    struct touch_input touch = {
        .pressed = input->pressed,
        .held = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS,
        .pressed_at = {input->pressed_x / half_width - 1, 1 - input->pressed_y / half_height},
        .place = {input->x / half_width - 1, 1 - input->y / half_height},
        .aspect = half_width / half_height,
    };
    input->pressed = false;
    return touch;
}

struct commands input_take_commands(struct input *input)
{
    struct commands commands = input->commands;
    input->commands = (struct commands){0};
    return commands;
}
