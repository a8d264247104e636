/* The window's panels, by Dear ImGui. On the left a control for every value of the scene, made from the tables that
 * describe them; on the right what a frame costs and what it is made from; at the bottom a message. */
#include "viewer/panel_parts.h"
extern "C" {
#include "viewer/input.h"
#include "viewer/panel_compare.h"
}

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <new>

/* Sizes in the window's coordinates at a scale of 1. */
static const float FONT_SIZE = 13, MARGIN = 8, LEFT_WIDTH = 348, RIGHT_WIDTH = 232, BOTH_WIDTH = 744;
static const double BUDGET = 16.7; /* ms, of a frame: 60 a second */

struct panel {
    GLFWwindow *window;
    float density; /* pixels of the font for one of FONT_SIZE */
    float scale;   /* window coordinates for one at a scale of 1 */
    bool show_all; /* also sections that the scene does not use */
    double budget; /* ms, of a frame */
};

static void draw_wireframe(dpl_scene *scene)
{
    char text[16] = "";
    bool on = dpl_scene_get(scene, "render.wireframe", text, sizeof text) && !strcmp(text, "true");
    if (ImGui::Checkbox("wireframe", &on))
        dpl_scene_set(scene, "render.wireframe", on ? "true" : "false");
}

static void draw_controls(panel *panel, const panel_view &view, commands *pressed)
{
    panel_scene_menu(view.document, pressed);
    pressed->pause = panel_button(view.clock->paused ? "Play###pause" : "Pause###pause", 3, true);
    pressed->step = panel_button("Step", 3, false);
    pressed->reset = panel_button("Reset", 3, false);
    pressed->screenshot = panel_button("Screenshot", 2, true);
    pressed->save = panel_button("Save scene", 2, false);
    static const double slowest = 0, fastest = 4;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    ImGui::SliderScalar("time scale", ImGuiDataType_Double, &view.clock->scale, &slowest, &fastest, "%.2f",
                        ImGuiSliderFlags_AlwaysClamp);
    draw_wireframe(view.document->scene);
    ImGui::SameLine();
    ImGui::Checkbox("show all", &panel->show_all);
    panel_explain("also water models, techniques and looks that the scene does not use");
    char time[32];
    snprintf(time, sizeof time, "%.2f s", view.clock->time);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(time).x);
    ImGui::TextDisabled("%s", time);
}

static const ImGuiWindowFlags FIXED_WINDOW = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                             ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;

static void draw_left(panel *panel, const panel_view &view, commands *pressed)
{
    float margin = MARGIN * panel->scale;
    ImGui::SetNextWindowPos(ImVec2(margin, margin));
    ImGui::SetNextWindowSize(ImVec2(LEFT_WIDTH * panel->scale, ImGui::GetIO().DisplaySize.y - 2 * margin));
    if (ImGui::Begin("Scene", nullptr, FIXED_WINDOW)) {
        draw_controls(panel, view, pressed);
        panel_sun_and_water(view.document);
        panel_path(view, pressed);
        panel_still(view, pressed);
        panel_compare_controls(&view);
        ImGui::Separator();
        panel_values(view.document, panel->show_all);
    }
    ImGui::End();
}

static void draw_right(panel *panel, const panel_view &view)
{
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float margin = MARGIN * panel->scale, width = RIGHT_WIDTH * panel->scale;
    if (display.x < BOTH_WIDTH * panel->scale)
        return;
    ImGui::SetNextWindowPos(ImVec2(display.x - margin - width, margin));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, display.y - 2 * margin));
    if (ImGui::Begin("Frame", nullptr, FIXED_WINDOW | ImGuiWindowFlags_AlwaysAutoResize)) {
        /* Room for a scroll bar whether there is one or not: a width must not depend on the bar that it calls for. */
        const ImGuiStyle &style = ImGui::GetStyle();
        panel_passes(view, &panel->budget);
        panel_keys();
        panel_thumbnails(view, width - 2 * style.WindowPadding.x - style.ScrollbarSize);
    }
    ImGui::End();
}

static void draw_message(const panel *panel, const panel_view &view)
{
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float margin = MARGIN * panel->scale, left = view.hidden ? margin : (LEFT_WIDTH + 2 * MARGIN) * panel->scale;
    float right = display.x < BOTH_WIDTH * panel->scale ? margin : (RIGHT_WIDTH + 2 * MARGIN) * panel->scale;
    float width = fmaxf(display.x - left - (view.hidden ? margin : right), 1);
    ImGui::SetNextWindowPos(ImVec2(left, display.y - margin), ImGuiCond_Always, ImVec2(0, 1));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(width, display.y));
    ImGui::Begin("message", nullptr,
                 FIXED_WINDOW | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(width - 2 * ImGui::GetStyle().WindowPadding.x);
    ImGui::PushStyleColor(ImGuiCol_Text, view.message_is_error ? ImVec4(1, 0.55f, 0.5f, 1) : ImVec4(1, 1, 1, 1));
    ImGui::TextUnformatted(view.message);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::End();
}

/* Follows the desktop's scale: the font has as many pixels as it needs, all sizes are in the window's coordinates. */
static void follow_scale(panel *panel)
{
    int window_width, picture_width;
    float density;
    glfwGetWindowSize(panel->window, &window_width, nullptr);
    glfwGetFramebufferSize(panel->window, &picture_width, nullptr);
    glfwGetWindowContentScale(panel->window, &density, nullptr);
    float scale = picture_width > 0 ? density * (float)window_width / (float)picture_width : panel->scale;
    if (density == panel->density && scale == panel->scale)
        return;
    panel->density = density;
    panel->scale = scale;
    ImGuiStyle &style = ImGui::GetStyle() = ImGuiStyle();
    ImGui::StyleColorsDark();
    style.WindowRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg].w = 0.88f;
    style.Colors[ImGuiCol_TitleBgActive] = style.Colors[ImGuiCol_TitleBg];
    style.ScaleAllSizes(scale);
    ImGuiIO &io = ImGui::GetIO();
    ImFontConfig font;
    font.SizePixels = FONT_SIZE * density;
    io.Fonts->Clear();
    io.Fonts->AddFontDefault(&font);
    io.FontGlobalScale = scale / density;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
}

panel *panel_create(GLFWwindow *window)
{
    panel *created = new (std::nothrow) panel{window, 0, 0, false, BUDGET};
    if (!created || !ImGui::CreateContext()) {
        delete created;
        return nullptr;
    }
    ImGui::GetIO().IniFilename = nullptr;
    if (ImGui_ImplGlfw_InitForOpenGL(window, true) && ImGui_ImplOpenGL3_Init("#version 330 core"))
        return created;
    panel_destroy(created);
    return nullptr;
}

void panel_destroy(panel *panel)
{
    if (!panel)
        return;
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    delete panel;
}

commands panel_draw(panel *panel, const panel_view *view)
{
    commands pressed = {};
    follow_scale(panel);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (view->blank)
        ImGui::GetBackgroundDrawList()->AddRectFilled(ImVec2(0, 0), ImGui::GetIO().DisplaySize, IM_COL32_BLACK);
    if (!view->hidden) {
        panel_compare_divider(view, panel->scale);
        draw_left(panel, *view, &pressed);
        draw_right(panel, *view);
    }
    if (view->message)
        draw_message(panel, *view);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return pressed;
}

bool panel_wants_mouse(void)
{
    return ImGui::GetCurrentContext() && ImGui::GetIO().WantCaptureMouse;
}

bool panel_wants_keyboard(void)
{
    return ImGui::GetCurrentContext() && ImGui::GetIO().WantCaptureKeyboard;
}
