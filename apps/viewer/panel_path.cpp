/* The camera's path: its keys, and the way along it. */
#include "viewer/panel_parts.h"

#include <imgui.h>

#include <cmath>

static const double LEAST_END = 10; /* s, of the slider of time */

void panel_path(const panel_view &view, commands *pressed)
{
    if (!ImGui::CollapsingHeader("camera path"))
        return;
    double first = 0, last = 0;
    int keys = path_range(view.document->scene, &first, &last);
    ImGui::PushID("camera path");
    ImGui::BeginDisabled(keys < 2 && !view.path->follows);
    pressed->path = panel_button(view.path->follows ? "Stop###path" : "Play path###path", 3, true);
    ImGui::EndDisabled();
    panel_explain("the camera moves along its keys; stopped, or moved by hand, it goes on from where it is");
    pressed->add_key = panel_button("Add key", 3, false);
    panel_explain("the camera as it is now, at this time; one at the same time is replaced");
    pressed->clear_path = panel_button("Clear", 3, false);
    panel_explain("takes all keys away");
    double start = 0, end = fmax(fmax(last, ceil(view.clock->time)), LEAST_END);
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    ImGui::SliderScalar("time", ImGuiDataType_Double, &view.clock->time, &start, &end, "%.2f s",
                        ImGuiSliderFlags_AlwaysClamp);
    panel_named_value(view.document, "camera.closed");
    ImGui::PopItemWidth();
    ImGui::SameLine();
    if (keys > 0)
        ImGui::TextDisabled("  %d %s, %.2f to %.2f s", keys, keys == 1 ? "key" : "keys", first, last);
    else
        ImGui::TextDisabled("  no keys yet");
    ImGui::PopID();
}
