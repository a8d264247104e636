/* Moving caustics in a window of the program's own. `caustics --once` shows nothing and writes caustics.png. */
#include <dapple/dapple.h>

#include <GLFW/glfw3.h>
#include <stdio.h>
#include <string.h>

static void print_message(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    (void)user, (void)level, (void)reason;
    fprintf(stderr, "%s\n", text);
}

static void *find_function(void *user, const char *name)
{
    (void)user;
    return (void *)glfwGetProcAddress(name);
}

static bool save_frame(struct dpl_renderer *renderer, const struct dpl_scene *scene, const struct dpl_log *log)
{
    struct dpl_image *picture = dpl_renderer_picture(renderer, scene, 1.0, 640, 360);
    bool ok = picture && dpl_image_save(picture, "caustics.png", NULL, log);
    dpl_image_destroy(picture);
    return ok;
}

int main(int count, char **arguments)
{
    bool once = count > 1 && !strcmp(arguments[1], "--once");
    glfwInit();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_VISIBLE, !once);
    GLFWwindow *window = glfwCreateWindow(1280, 720, "caustics", NULL, NULL);
    if (!window) {
        fprintf(stderr, "no window (a display with OpenGL 3.3 is needed)\n");
        return 1;
    }
    glfwMakeContextCurrent(window);
    const struct dpl_log log = {.write = print_message};
    struct dpl_gl *gl = dpl_gl_create(&(struct dpl_gl_options){.get_proc_address = find_function}, &log);
    struct dpl_scene *scene = dpl_scene_create(&log);
    struct dpl_renderer *renderer = gl && scene ? dpl_renderer_create(gl, DPL_DEVICE_AUTO, &log) : NULL;
    bool ok = renderer && dpl_scene_load(scene, "collard-1");
    do {
        int width, height;
        glfwGetFramebufferSize(window, &width, &height);
        ok = ok && dpl_renderer_draw(renderer, scene, glfwGetTime(), 0, width, height);
        glfwSwapBuffers(window);
        glfwPollEvents();
    } while (ok && !once && !glfwWindowShouldClose(window));
    ok = ok && (!once || save_frame(renderer, scene, &log));
    dpl_renderer_destroy(renderer);
    dpl_scene_destroy(scene);
    dpl_gl_destroy(gl);
    glfwTerminate();
    return ok ? 0 : 1;
}
