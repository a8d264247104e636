/* The window's panels, by Dear ImGui. On the left a control for every value of the scene, made from the tables that
 * describe them; on the right what a frame costs and what it is made from; at the bottom a message. */
extern "C" {
#include "viewer/panel.h"
#include "viewer/control.h"
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
static const float DRAG_SPEED = 0.02f; /* units a pixel */

struct panel {
    GLFWwindow *window;
    float density; /* pixels of the font for one of FONT_SIZE */
    float scale;   /* window coordinates for one at a scale of 1 */
    bool show_all; /* also sections that the scene does not use */
};

static bool edit_numbers(const dpl_param &param, control_value *value)
{
    bool whole = param.type == DPL_PARAM_INT;
    ImGuiDataType type = whole ? ImGuiDataType_S32 : ImGuiDataType_Double;
    int whole_minimum = (int)param.minimum, whole_maximum = (int)param.maximum;
    const void *minimum = whole ? (const void *)&whole_minimum : &param.minimum;
    const void *maximum = whole ? (const void *)&whole_maximum : &param.maximum;
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    char format[64];
    control_format(&param, format, sizeof format);
    enum control_kind kind = control_kind(&param);
    if (kind == CONTROL_DRAG)
        return ImGui::DragScalarN(param.name, type, value, param.count, DRAG_SPEED, minimum, maximum, format, flags);
    if (kind == CONTROL_LOGARITHMIC)
        flags |= ImGuiSliderFlags_Logarithmic;
    return ImGui::SliderScalarN(param.name, type, value, param.count, minimum, maximum, format, flags);
}

static bool edit_color(const dpl_param &param, double *numbers)
{
    float color[3] = {(float)numbers[0], (float)numbers[1], (float)numbers[2]};
    ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoOptions;
    if (!ImGui::ColorEdit3(param.name, color, flags | (param.maximum > 1 ? ImGuiColorEditFlags_HDR : 0)))
        return false;
    for (int i = 0; i < 3; i++)
        numbers[i] = fmin(fmax(round(color[i] * 1e4) / 1e4, param.minimum), param.maximum);
    return true;
}

static bool edit_choice(const dpl_param &param, int *index)
{
    bool changed = false;
    if (!ImGui::BeginCombo(param.name, param.choice(*index)))
        return false;
    for (int i = 0; param.choice(i); i++) {
        if (ImGui::Selectable(param.choice(i), i == *index)) {
            *index = i;
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

static bool edit_value(const dpl_param &param, control_value *value)
{
    switch (param.type) {
    case DPL_PARAM_BOOL:
        return ImGui::Checkbox(param.name, &value->flag);
    case DPL_PARAM_CHOICE:
        return edit_choice(param, value->integers);
    case DPL_PARAM_COLOR:
        return edit_color(param, value->numbers);
    case DPL_PARAM_TEXT:
        return ImGui::InputText(param.name, value->text, sizeof value->text, ImGuiInputTextFlags_EnterReturnsTrue);
    default:
        return edit_numbers(param, value);
    }
}

static void show_tooltip(const char *text)
{
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/* Explains the control drawn last while the mouse rests on it. */
static void explain(const char *text)
{
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        show_tooltip(text);
}

static void draw_param(document *document, const dpl_section &section, const dpl_param &param)
{
    control_value value;
    char text[1024];
    control_read(&section, &param, &value);
    if (edit_value(param, &value))
        control_write(document->scene, &section, &param, &value);
    control_help(&section, &param, text, sizeof text);
    explain(text);
    if (ImGui::BeginPopupContextItem(param.name)) {
        control_reset_label(document, &section, &param, text, sizeof text);
        if (ImGui::MenuItem(text))
            document_reset_values(document, section.name, param.name);
        ImGui::EndPopup();
    }
}

static void draw_section(document *document, const dpl_section &section)
{
    ImGui::PushID(section.name);
    bool open = ImGui::CollapsingHeader(section.name, ImGuiTreeNodeFlags_AllowItemOverlap |
                                                          (section.active ? ImGuiTreeNodeFlags_DefaultOpen : 0));
    bool over_header = ImGui::IsItemHovered();
    float width = ImGui::CalcTextSize("reset").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    if (ImGui::SmallButton("reset"))
        document_reset_values(document, section.name, nullptr);
    if (over_header)
        show_tooltip(ImGui::IsItemHovered() ? "back to the values that were loaded" : section.help);
    for (const dpl_param *param = section.params; open && param->name; param++)
        draw_param(document, section, *param);
    ImGui::PopID();
}

static void draw_scene_menu(const document *document, commands *pressed)
{
    const char *slash = strrchr(document->path, '/');
    ImGui::SetNextItemWidth(-ImGui::CalcTextSize(" scene").x);
    if (!ImGui::BeginCombo("scene", slash ? slash + 1 : document->path, ImGuiComboFlags_HeightLarge))
        return;
    for (const dpl_builtin_scene *scene = dpl_builtin_scenes(); scene->name; scene++) {
        if (ImGui::Selectable(scene->name, !strcmp(scene->name, document->path)))
            pressed->load = scene->name;
        explain(scene->summary);
    }
    ImGui::EndCombo();
}

/* Buttons side by side that share the width. */
static bool button(const char *label, int of, bool first)
{
    float spacing = ImGui::GetStyle().ItemSpacing.x;
    float width =
        (ImGui::GetContentRegionMax().x - ImGui::GetStyle().WindowPadding.x - spacing * (float)(of - 1)) / (float)of;
    if (!first)
        ImGui::SameLine();
    return ImGui::Button(label, ImVec2(width, 0));
}

static void draw_wireframe(dpl_scene *scene)
{
    char text[16] = "";
    bool on = dpl_scene_get(scene, "render.wireframe", text, sizeof text) && !strcmp(text, "true");
    if (ImGui::Checkbox("wireframe", &on))
        dpl_scene_set(scene, "render.wireframe", on ? "true" : "false");
}

static void draw_controls(panel *panel, const panel_view &view, commands *pressed)
{
    draw_scene_menu(view.document, pressed);
    pressed->pause = button(view.clock->paused ? "Play###pause" : "Pause###pause", 3, true);
    pressed->step = button("Step", 3, false);
    pressed->reset = button("Reset", 3, false);
    pressed->screenshot = button("Screenshot", 2, true);
    pressed->save = button("Save scene", 2, false);
    static const double slowest = 0, fastest = 4;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    ImGui::SliderScalar("time scale", ImGuiDataType_Double, &view.clock->scale, &slowest, &fastest, "%.2f",
                        ImGuiSliderFlags_AlwaysClamp);
    draw_wireframe(view.document->scene);
    ImGui::SameLine();
    ImGui::Checkbox("show all", &panel->show_all);
    explain("also water models, techniques and looks that the scene does not use");
    char time[32];
    snprintf(time, sizeof time, "%.2f s", view.clock->time);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(time).x);
    ImGui::TextDisabled("%s", time);
}

static void draw_sections(const panel *panel, document *document)
{
    ImGui::BeginChild("sections");
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    for (int i = 0; dpl_scene_section(document->scene, i).name; i++) {
        dpl_section section = dpl_scene_section(document->scene, i);
        if (section.active || panel->show_all)
            draw_section(document, section);
    }
    ImGui::PopItemWidth();
    ImGui::EndChild();
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
        panel_compare_controls(&view);
        ImGui::Separator();
        draw_sections(panel, view.document);
    }
    ImGui::End();
}

static void draw_passes(const panel_view &view)
{
    ImGui::Text("%.1f frames/s", view.frame_seconds > 0 ? 1 / view.frame_seconds : 0);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%d x %d pixels\n%s", view.width, view.height, view.device);
    ImGui::PopStyleColor();
    if (!ImGui::BeginTable("passes", 2, ImGuiTableFlags_BordersInnerH))
        return;
    double sum = 0;
    for (int i = 0; dpl_renderer_pass_time(view.renderer, i).name; i++) {
        dpl_pass_time pass = dpl_renderer_pass_time(view.renderer, i);
        sum += pass.milliseconds;
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(pass.name);
        ImGui::TableNextColumn();
        ImGui::Text("%8.3f ms", pass.milliseconds);
    }
    ImGui::TableNextColumn();
    ImGui::TextDisabled("sum");
    ImGui::TableNextColumn();
    ImGui::Text("%8.3f ms", sum);
    ImGui::EndTable();
}

/* Their size leaves room for a scroll bar whether there is one or not: it must not depend on the bar that it calls for.
 */
static void draw_thumbnails(const panel *panel, const panel_view &view)
{
    const ImGuiStyle &style = ImGui::GetStyle();
    float side = RIGHT_WIDTH * panel->scale - 2 * style.WindowPadding.x - style.ScrollbarSize;
    for (int i = 0;; i++) {
        dpl_thumbnail thumbnail = dpl_renderer_thumbnail(view.renderer, i);
        if (!thumbnail.name)
            return;
        ImGui::TextUnformatted(thumbnail.name);
        ImGui::Image((ImTextureID)(intptr_t)thumbnail.texture,
                     ImVec2(side, side * (float)thumbnail.height / (float)thumbnail.width));
    }
}

static void draw_keys()
{
    if (!ImGui::CollapsingHeader("keys") || !ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit))
        return;
    for (const input_key *key = input_keys(); key->name; key++) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", key->name);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(key->meaning);
    }
    ImGui::EndTable();
}

static void draw_right(const panel *panel, const panel_view &view)
{
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float margin = MARGIN * panel->scale, width = RIGHT_WIDTH * panel->scale;
    if (display.x < BOTH_WIDTH * panel->scale)
        return;
    ImGui::SetNextWindowPos(ImVec2(display.x - margin - width, margin));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, display.y - 2 * margin));
    if (ImGui::Begin("Frame", nullptr, FIXED_WINDOW | ImGuiWindowFlags_AlwaysAutoResize)) {
        draw_passes(view);
        draw_thumbnails(panel, view);
        draw_keys();
    }
    ImGui::End();
}

static void draw_message(const panel *panel, const panel_view &view)
{
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float margin = MARGIN * panel->scale, left = view.hidden ? margin : (LEFT_WIDTH + 2 * MARGIN) * panel->scale;
    float width = fmaxf(display.x - left - margin, 1);
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
    panel *created = new (std::nothrow) panel{window, 0, 0, false};
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
