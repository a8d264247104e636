/* The few values that change a picture most, at hand at the top. */
#include "viewer/panel_parts.h"

#include <imgui.h>

void panel_sun_and_water(document *document)
{
    /* Those that the scene has are shown. */
    static const char *const names[] = {"sun.by",   "sun.elevation", "sun.azimuth",
                                        "sun.hour", "water.type",    "render.quality"};
    if (!ImGui::CollapsingHeader("sun and water", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    ImGui::PushID("sun and water");
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    for (const char *name : names)
        panel_named_value(document, name);
    ImGui::PopItemWidth();
    ImGui::PopID();
}
