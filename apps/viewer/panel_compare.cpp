/* Which techniques are compared in the window, and how. */
extern "C" {
#include "viewer/panel_compare.h"
}

#include <imgui.h>

#include <cmath>

static const float GRIP = 12; /* width that takes hold of the divider, at a scale of 1 */

static const char *const mode_names[] = {"off", "split", "difference"}; /* as enum dpl_comparison */
static const char *const mode_helps[] = {
    "the picture by the scene's technique alone",
    "left of the line the scene's technique, right of it another",
    "the floor alone: red where the scene's technique is brighter than the other, blue where it is darker",
};

static void choose_mode(dpl_compare *shown)
{
    if (!ImGui::BeginCombo("compare", mode_names[shown->mode]))
        return;
    for (int i = 0; i < IM_ARRAYSIZE(mode_names); i++) {
        if (ImGui::Selectable(mode_names[i], i == shown->mode))
            shown->mode = (dpl_comparison)i;
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", mode_helps[i]);
    }
    ImGui::EndCombo();
}

static void choose_technique(dpl_compare *shown)
{
    if (!ImGui::BeginCombo("with", dpl_technique(shown->technique).name))
        return;
    for (int i = 0; dpl_technique(i).name; i++)
        if (ImGui::Selectable(dpl_technique(i).name, i == shown->technique))
            shown->technique = i;
    ImGui::EndCombo();
}

static void show_measure(const viewer_compare &compare, bool paused)
{
    const dpl_measure &measure = compare.measure;
    if (compare.measured) {
        ImGui::Text("error %.3g %%   p99 %.3g %%", measure.error * 100, measure.p99 * 100);
        if (measure.gain == 1)
            ImGui::Text("energy %.4f", measure.energy);
        else
            ImGui::Text("energy %.4f   after a gain of %.3g", measure.energy, measure.gain);
    }
    if (!dpl_technique(compare.shown.technique).refines)
        return;
    if (compare.measured)
        ImGui::Text("noise of the %s %.3g %%", dpl_technique(compare.shown.technique).name, compare.noise * 100);
    if (!paused)
        ImGui::TextWrapped("It starts anew with each frame: a preview. Pause, and it gets better.");
}

/* From what is darker than the other technique to what is brighter. */
static void show_colors()
{
    static const int steps = 32;
    ImVec2 place = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x / steps, height = ImGui::GetTextLineHeight();
    for (int i = 0; i < steps; i++) {
        float color[3], left = place.x + width * (float)i;
        dpl_false_color(DPL_COLORS_DIFFERENCE, 2.0 * i / (steps - 1) - 1, color);
        ImGui::GetWindowDrawList()->AddRectFilled(
            ImVec2(left, place.y), ImVec2(left + width, place.y + height),
            ImGui::ColorConvertFloat4ToU32(ImVec4(color[0], color[1], color[2], 1)));
    }
    ImGui::Dummy(ImVec2(width * steps, height));
    ImGui::TextUnformatted("too dark");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize("too bright").x);
    ImGui::TextUnformatted("too bright");
}

void panel_compare_controls(const panel_view *view)
{
    viewer_compare *compare = view->compare;
    static const double least = 0.01, most = 100;
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    choose_mode(&compare->shown);
    if (compare->shown.mode != DPL_COMPARE_NOTHING)
        choose_technique(&compare->shown);
    if (compare->shown.mode == DPL_COMPARE_DIFFERENCE)
        ImGui::SliderScalar("strongest colour", ImGuiDataType_Double, &compare->shown.range, &least, &most,
                            "\u00b1%.2f", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopItemWidth();
    if (compare->shown.mode == DPL_COMPARE_DIFFERENCE)
        show_colors();
    if (compare->shown.mode != DPL_COMPARE_NOTHING)
        show_measure(*compare, view->clock->paused);
}

/* The names of the two techniques on either side of the line. */
static void label_parts(const panel_view *view, ImDrawList *list, float x, float scale)
{
    const char *right = dpl_technique(view->compare->shown.technique).name;
    char left[64] = "";
    dpl_scene_get(view->document->scene, "caustics.technique", left, sizeof left);
    const char *names[2] = {left, right};
    for (int i = 0; i < 2; i++) {
        ImVec2 size = ImGui::CalcTextSize(names[i]), pad(6 * scale, 3 * scale);
        ImVec2 place(i == 0 ? x - size.x - 2 * pad.x : x + 2 * pad.x, 12 * scale);
        list->AddRectFilled(ImVec2(place.x - pad.x, place.y - pad.y),
                            ImVec2(place.x + size.x + pad.x, place.y + size.y + pad.y), IM_COL32(0, 0, 0, 150), pad.y);
        list->AddText(place, IM_COL32_WHITE, names[i]);
    }
}

void panel_compare_divider(const panel_view *view, float scale)
{
    dpl_compare *shown = &view->compare->shown;
    if (shown->mode != DPL_COMPARE_SPLIT)
        return;
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float x = (float)shown->place * display.x;
    ImGui::SetNextWindowPos(ImVec2(x - GRIP * scale / 2, 0));
    ImGui::SetNextWindowSize(ImVec2(GRIP * scale, display.y));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin("divider", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::InvisibleButton("grip", ImVec2(GRIP * scale, display.y));
    bool held = ImGui::IsItemActive();
    if (held)
        shown->place = fmin(fmax(ImGui::GetIO().MousePos.x / display.x, 0), 1);
    if (held || ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled(ImVec2(x - 2 * scale, 0), ImVec2(x + 2 * scale, display.y), IM_COL32(0, 0, 0, 120));
    list->AddRectFilled(ImVec2(x - scale, 0), ImVec2(x + scale, display.y), IM_COL32_WHITE);
    list->AddCircleFilled(ImVec2(x, display.y / 2), 7 * scale, IM_COL32_WHITE);
    label_parts(view, list, x, scale);
}
