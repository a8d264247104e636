/* The window: opens it, and draws frame after frame. */
#include "viewer/viewer.h"

#include "viewer/clock.h"
#include "viewer/compare.h"
#include "viewer/document.h"
#include "viewer/input.h"
#include "viewer/panel.h"
#include "viewer/watch.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define WIDTH 1280 /* of the window that is not told its size */
#define HEIGHT 720
#define INFO_SECONDS 4   /* a message stays this long */
#define ERROR_SECONDS 30 /* an error */

struct viewer {
    const struct viewer_options *options;
    struct dpl_log log; /* into the message line, and on to the caller's log */
    struct document document;
    GLFWwindow *window;
    struct dpl_gl *gl;
    struct dpl_renderer *renderer;
    struct panel *panel;
    struct input input;
    struct viewer_clock clock;
    struct viewer_compare compare;
    struct viewer_path path;
    struct viewer_still still;
    struct touch touch;
    struct watch watch;
    double frame_seconds; /* mean of the last frames, real time */
    bool hidden;
    struct {
        char text[512];
        bool is_error;
        double until; /* s, real time */
    } message;
};

static bool message_shows(const struct viewer *viewer)
{
    return *viewer->message.text && glfwGetTime() < viewer->message.until;
}

/* Shows the message; hands it on unless it only repeats what is shown, as when every frame fails for one reason. */
static void write_message(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    struct viewer *viewer = user;
    const struct dpl_log *log = viewer->options->log;
    bool repeated = message_shows(viewer) && !strncmp(text, viewer->message.text, sizeof viewer->message.text - 1);
    viewer->message.is_error = level == DPL_LOG_ERROR;
    viewer->message.until = glfwGetTime() + (level == DPL_LOG_ERROR ? ERROR_SECONDS : INFO_SECONDS);
    snprintf(viewer->message.text, sizeof viewer->message.text, "%s", text);
    if (log && !repeated)
        log->write(log->user, level, reason, text);
}

DPL_PRINTF(4, 5)
static bool say(struct viewer *viewer, enum dpl_log_level level, enum dpl_reason reason, const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    write_message(viewer, level, reason, text);
    return level != DPL_LOG_ERROR;
}

static bool no_window(struct viewer *viewer)
{
    const char *reason = NULL;
    glfwGetError(&reason);
    return say(viewer, DPL_LOG_ERROR, DPL_REASON_NO_GL,
               "window: cannot be opened: %s (needed: a display and OpenGL 3.3)", reason ? reason : "unknown reason");
}

static void show_title(struct viewer *viewer)
{
    char title[300];
    snprintf(title, sizeof title, "dapple%s%.255s", *viewer->document.path ? " - " : "", viewer->document.path);
    glfwSetWindowTitle(viewer->window, title);
}

static bool open_window(struct viewer *viewer)
{
    const struct viewer_options *options = viewer->options;
    if (!glfwInit())
        return no_window(viewer);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    viewer->window = glfwCreateWindow(options->width > 0 ? options->width : WIDTH,
                                      options->height > 0 ? options->height : HEIGHT, "dapple", NULL, NULL);
    if (!viewer->window)
        return no_window(viewer);
    glfwMakeContextCurrent(viewer->window);
    glfwSwapInterval(1);
    show_title(viewer);
    return true;
}

static void *get_proc_address(void *user, const char *name)
{
    (void)user;
    return (void *)glfwGetProcAddress(name);
}

static void time_passes(struct viewer *viewer)
{
    const struct dpl_gl_info *info = dpl_gl_describe(viewer->gl);
    bool queries = info->timer_queries && !info->software;
    dpl_renderer_time_passes(viewer->renderer, queries ? DPL_TIMING_QUERIES : DPL_TIMING_WAIT, glfwGetTime);
}

/* While a large picture is being drawn the window tells how far it is. */
static void show_progress(void *user, int done, int tiles)
{
    struct viewer *viewer = user;
    char text[256];
    snprintf(text, sizeof text, "%s (%d x %d): tile %d of %d", viewer->still.name, viewer->still.size[0],
             viewer->still.size[1], done, tiles);
    struct panel_view view = {.message = text, .hidden = true, .blank = true};
    panel_draw(viewer->panel, &view);
    glfwSwapBuffers(viewer->window);
    glfwPollEvents();
}

static bool start(struct viewer *viewer)
{
    const struct viewer_options *options = viewer->options;
    struct dpl_gl_options gl_options = {.get_proc_address = get_proc_address, .shader_folder = options->shader_folder};
    if (!document_open(&viewer->document, options->scene, options->scene_path, &viewer->log) || !open_window(viewer))
        return false;
    input_start(&viewer->input, viewer->window);
    viewer->gl = dpl_gl_create(&gl_options, &viewer->log);
    if (!viewer->gl)
        return false;
    viewer->renderer = dpl_renderer_create(viewer->gl, options->device, &viewer->log);
    viewer->panel = panel_create(viewer->window);
    if (!viewer->renderer || !viewer->panel)
        return say(viewer, DPL_LOG_ERROR, DPL_REASON_LIMIT, "window: memory is short");
    time_passes(viewer);
    compare_start(&viewer->compare, viewer->renderer, glfwGetTime);
    dpl_renderer_path(viewer->renderer, false); /* the path moves [camera] itself, so that hands can go on from there */
    dpl_renderer_tiles(viewer->renderer, show_progress, viewer);
    viewer->still = (struct viewer_still){.size = {3840, 2160}};
    still_rename(&viewer->still, viewer->document.path);
    watch_start(&viewer->watch, viewer->document.path, options->shader_folder);
    clock_start(&viewer->clock, options->time, glfwGetTime());
    return true;
}

static void finish(struct viewer *viewer)
{
    panel_destroy(viewer->panel);
    dpl_renderer_destroy(viewer->renderer);
    dpl_gl_destroy(viewer->gl);
    if (viewer->window)
        glfwDestroyWindow(viewer->window);
    glfwTerminate();
    document_close(&viewer->document);
}

/* Names a file of the current folder that is not there yet: dapple-0001.png, dapple-0002.png, … */
static bool new_file_name(struct viewer *viewer, const char *ending, char *name, size_t size)
{
    for (int number = 1; number <= 9999; number++) {
        snprintf(name, size, "dapple-%04d%s", number, ending);
        if (access(name, F_OK) != 0)
            return true;
    }
    return say(viewer, DPL_LOG_ERROR, DPL_REASON_FILE_WRITE, "%s: cannot be written: all numbers are taken (1 to 9999)",
               name);
}

static void take_screenshot(struct viewer *viewer, int width, int height)
{
    char name[32];
    if (!new_file_name(viewer, ".png", name, sizeof name))
        return;
    struct dpl_image *image =
        dpl_renderer_picture(viewer->renderer, viewer->document.scene, viewer->clock.time, width, height);
    if (image && dpl_image_save(image, name, NULL, &viewer->log))
        say(viewer, DPL_LOG_INFO, DPL_REASON_NONE, "written: %s (%d × %d)", name, width, height);
    dpl_image_destroy(image);
}

static void save_still(struct viewer *viewer)
{
    struct viewer_still *still = &viewer->still;
    char path[PATH_MAX];
    still_path(still, viewer->document.path, path, sizeof path);
    if (!dpl_image_format_known(path, &viewer->log))
        return;
    struct dpl_image *image = dpl_renderer_picture(viewer->renderer, viewer->document.scene, viewer->clock.time,
                                                   still->size[0], still->size[1]);
    if (image && dpl_image_save(image, path, NULL, &viewer->log))
        say(viewer, DPL_LOG_INFO, DPL_REASON_NONE, "written: %s (%d × %d)", path, still->size[0], still->size[1]);
    dpl_image_destroy(image);
    viewer->clock.last = glfwGetTime(); /* the water waits */
}

static void add_key(struct viewer *viewer)
{
    if (path_add_key(viewer->document.scene, viewer->clock.time))
        say(viewer, DPL_LOG_INFO, DPL_REASON_NONE, "camera: key at %.2f s", viewer->clock.time);
}

static void save_scene(struct viewer *viewer)
{
    char name[32];
    if (new_file_name(viewer, ".ini", name, sizeof name) && dpl_scene_save(viewer->document.scene, name))
        say(viewer, DPL_LOG_INFO, DPL_REASON_NONE, "written: %s", name);
}

static void load_scene(struct viewer *viewer, const char *path)
{
    if (!*path || !document_load(&viewer->document, path))
        return;
    watch_start(&viewer->watch, viewer->document.path, viewer->options->shader_folder);
    show_title(viewer);
    if (path != viewer->document.path)
        still_rename(&viewer->still, viewer->document.path);
    say(viewer, DPL_LOG_INFO, DPL_REASON_NONE, "loaded: %s", viewer->document.path);
}

static void reload_shaders(struct viewer *viewer)
{
    say(viewer, DPL_LOG_INFO, DPL_REASON_NONE, "loaded: shaders");
    dpl_renderer_reload(viewer->renderer);
}

static void reload_changed(struct viewer *viewer)
{
    struct watch_changes changes =
        watch_poll(&viewer->watch, viewer->document.path, viewer->options->shader_folder, glfwGetTime());
    if (changes.shaders)
        reload_shaders(viewer);
    if (changes.scene)
        load_scene(viewer, viewer->document.path);
}

static void obey_files(struct viewer *viewer, const struct commands *commands, int width, int height)
{
    if (commands->screenshot)
        take_screenshot(viewer, width, height);
    if (commands->still)
        save_still(viewer);
    if (commands->save)
        save_scene(viewer);
    if (commands->reload) {
        reload_shaders(viewer);
        load_scene(viewer, viewer->document.path);
    }
    if (commands->load)
        load_scene(viewer, commands->load);
}

static void obey(struct viewer *viewer, const struct commands *commands, int width, int height)
{
    struct dpl_scene *scene = viewer->document.scene;
    if (commands->pause)
        viewer->clock.paused = !viewer->clock.paused;
    if (commands->step)
        clock_step(&viewer->clock);
    if (commands->add_key)
        add_key(viewer);
    if (commands->clear_path)
        path_clear(scene);
    if (commands->path)
        path_toggle(&viewer->path, scene, &viewer->clock);
    obey_files(viewer, commands, width, height);
    if (commands->reset)
        document_reset(&viewer->document);
    if (commands->gravity)
        touch_toggle_gravity(scene);
    if (commands->light)
        touch_place_sun(scene);
    if (commands->hide)
        viewer->hidden = !viewer->hidden;
    if (commands->quit)
        glfwSetWindowShouldClose(viewer->window, GLFW_TRUE);
}

static void draw(struct viewer *viewer, int width, int height)
{
    compare_begin_frame(&viewer->compare, viewer->renderer);
    bool drawn = dpl_renderer_draw(viewer->renderer, viewer->document.scene, viewer->clock.time, 0, width, height);
    compare_end_frame(&viewer->compare, viewer->renderer, drawn);
    struct panel_view view = {
        .document = &viewer->document,
        .clock = &viewer->clock,
        .compare = &viewer->compare,
        .path = &viewer->path,
        .still = &viewer->still,
        .renderer = viewer->renderer,
        .device = dpl_gl_describe(viewer->gl)->renderer,
        .width = width,
        .height = height,
        .frame_seconds = viewer->frame_seconds,
        .message = message_shows(viewer) ? viewer->message.text : NULL,
        .message_is_error = viewer->message.is_error,
        .hidden = viewer->hidden,
        .blank = !drawn,
    };
    struct commands pressed = panel_draw(viewer->panel, &view), keys = input_take_commands(&viewer->input);
    glfwSwapBuffers(viewer->window);
    obey(viewer, &pressed, width, height);
    obey(viewer, &keys, width, height);
}

/* By its path; or by the hands, which take it off the path. */
static void move_camera(struct viewer *viewer, const struct camera_input *hands)
{
    path_move(&viewer->path, viewer->document.scene, viewer->clock.time);
    if (camera_control_move(viewer->document.scene, hands))
        viewer->path.follows = false;
}

static void run(struct viewer *viewer)
{
    while (!glfwWindowShouldClose(viewer->window)) {
        glfwPollEvents();
        double seconds = clock_tick(&viewer->clock, glfwGetTime());
        viewer->frame_seconds += (seconds - viewer->frame_seconds) * 0.1;
        struct camera_input hands = input_take_camera(&viewer->input, viewer->window, seconds);
        struct touch_input finger = input_take_touch(&viewer->input, viewer->window);
        if (touch_move(&viewer->touch, viewer->document.scene, viewer->renderer, &finger))
            hands.orbit[0] = hands.orbit[1] = 0;
        move_camera(viewer, &hands);
        reload_changed(viewer);
        int width, height;
        glfwGetFramebufferSize(viewer->window, &width, &height);
        if (width > 0 && height > 0)
            draw(viewer, width, height);
        else
            glfwWaitEventsTimeout(0.1); /* minimised: nothing to draw to */
    }
}

int viewer_run(const struct viewer_options *options)
{
    struct viewer viewer = {.options = options};
    viewer.log = (struct dpl_log){write_message, &viewer};
    bool started = start(&viewer);
    if (started)
        run(&viewer);
    finish(&viewer);
    return started ? 0 : 1;
}
