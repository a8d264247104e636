/* A still picture: how large, and where it is written. */
#include "viewer/panel_parts.h"

#include <imgui.h>

#include <unistd.h>

static const struct {
    const char *name;
    int size[2]; /* pixels */
} sizes[] = {
    {"1920 x 1080", {1920, 1080}}, {"2560 x 1440", {2560, 1440}},   {"3840 x 2160", {3840, 2160}},
    {"7680 x 4320", {7680, 4320}}, {"16000 x 9000", {16000, 9000}},
};

static void choose_size(const panel_view &view)
{
    int *size = view.still->size;
    ImGui::SameLine();
    if (!ImGui::BeginCombo("##sizes", nullptr, ImGuiComboFlags_NoPreview))
        return;
    if (ImGui::Selectable("as the window")) {
        size[0] = view.width;
        size[1] = view.height;
    }
    for (const auto &entry : sizes) {
        if (ImGui::Selectable(entry.name)) {
            size[0] = entry.size[0];
            size[1] = entry.size[1];
        }
    }
    ImGui::EndCombo();
}

void panel_still(const panel_view &view, commands *pressed)
{
    if (!ImGui::CollapsingHeader("still picture"))
        return;
    viewer_still *still = view.still;
    const int least = 1, most = DPL_IMAGE_SIDE_MAX;
    char path[PATH_MAX];
    ImGui::PushID("still picture");
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    ImGui::InputText("file", still->name, sizeof still->name);
    still_path(still, view.document->path, path, sizeof path);
    panel_explain(path);
    ImGui::DragScalarN("##size", ImGuiDataType_S32, still->size, 2, 1, &least, &most, "%d",
                       ImGuiSliderFlags_AlwaysClamp);
    panel_explain(
        "width and height in pixels, up to 16384 each; a click with the control key held down takes a number");
    choose_size(view);
    ImGui::SameLine();
    ImGui::TextUnformatted("size");
    ImGui::PopItemWidth();
    pressed->still =
        panel_button(access(path, F_OK) ? "Save still###still" : "Save still (replaces the file)###still", 1, true);
    ImGui::PopID();
}
