/* What a frame costs, and what it is made from. */
#include "viewer/panel_parts.h"
extern "C" {
#include "viewer/input.h"
}

#include <imgui.h>

#include <cmath>
#include <cstdio>

/* A pass's share of the budget, as a bar that its milliseconds stand in; red where it alone is more than all. */
static void show_bar(const char *name, double milliseconds, double budget)
{
    char text[32];
    double share = milliseconds / budget;
    snprintf(text, sizeof text, "%.3f ms", milliseconds);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram,
                          share > 1 ? ImVec4(0.72f, 0.24f, 0.2f, 1) : ImVec4(0.2f, 0.45f, 0.7f, 1));
    ImGui::ProgressBar((float)fmin(share, 1), ImVec2(-1, ImGui::GetTextLineHeight()), text);
    ImGui::PopStyleColor();
}

void panel_passes(const panel_view &view, double *budget)
{
    static const double least = 0.1, most = 1000;
    ImGui::Text("%.1f frames/s", view.frame_seconds > 0 ? 1 / view.frame_seconds : 0);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%d x %d pixels\n%s", view.width, view.height, view.device);
    ImGui::PopStyleColor();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    ImGui::DragScalar("budget", ImGuiDataType_Double, budget, 0.1f, &least, &most, "%.1f ms",
                      ImGuiSliderFlags_AlwaysClamp);
    panel_explain("what a frame may take; the bars are shares of it");
    if (!ImGui::BeginTable("passes", 2, ImGuiTableFlags_SizingStretchSame))
        return;
    double sum = 0;
    for (int i = 0; dpl_renderer_pass_time(view.renderer, i).name; i++) {
        dpl_pass_time pass = dpl_renderer_pass_time(view.renderer, i);
        sum += pass.milliseconds;
        show_bar(pass.name, pass.milliseconds, *budget);
    }
    show_bar("sum", sum, *budget);
    ImGui::EndTable();
}

void panel_thumbnails(const panel_view &view, float side)
{
    for (int i = 0;; i++) {
        dpl_thumbnail thumbnail = dpl_renderer_thumbnail(view.renderer, i);
        if (!thumbnail.name)
            return;
        ImGui::TextUnformatted(thumbnail.name);
        ImGui::Image((ImTextureID)(intptr_t)thumbnail.texture,
                     ImVec2(side, side * (float)thumbnail.height / (float)thumbnail.width));
    }
}

void panel_keys(void)
{
    if (!ImGui::CollapsingHeader("keys"))
        return;
    float widest = 0;
    for (const input_key *key = input_keys(); key->name; key++)
        widest = fmaxf(widest, ImGui::CalcTextSize(key->name).x);
    for (const input_key *key = input_keys(); key->name; key++) {
        ImGui::TextDisabled("%s", key->name);
        ImGui::SameLine(widest + 2 * ImGui::GetStyle().ItemSpacing.x);
        ImGui::TextWrapped("%s", key->meaning);
    }
}
