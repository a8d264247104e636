/* What several panels are made of. */
#include "viewer/panel_parts.h"

#include <imgui.h>

void panel_tooltip(const char *text)
{
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/* Explains the control drawn last while the mouse rests on it. */
void panel_explain(const char *text)
{
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        panel_tooltip(text);
}

/* Buttons side by side that share the width. */
bool panel_button(const char *label, int of, bool first)
{
    float spacing = ImGui::GetStyle().ItemSpacing.x;
    float width =
        (ImGui::GetContentRegionMax().x - ImGui::GetStyle().WindowPadding.x - spacing * (float)(of - 1)) / (float)of;
    if (!first)
        ImGui::SameLine();
    return ImGui::Button(label, ImVec2(width, 0));
}
