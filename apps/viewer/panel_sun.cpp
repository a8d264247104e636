/* The few values that change a picture most, at hand at the top. */
#include "viewer/panel_parts.h"

#include <imgui.h>

#include <cstring>

/* Its place in the sky, or the hour that has it there. */
static void show_sun(document *document)
{
    char by[32] = "";
    panel_named_value(document, "sun.by");
    if (dpl_scene_get(document->scene, "sun.by", by, sizeof by) && !strcmp(by, "clock")) {
        panel_named_value(document, "sun.hour");
        return;
    }
    panel_named_value(document, "sun.elevation");
    panel_named_value(document, "sun.azimuth");
}

void panel_sun_and_water(document *document)
{
    if (!ImGui::CollapsingHeader("sun and water", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    ImGui::PushID("sun and water");
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.58f);
    show_sun(document);
    panel_named_value(document, "water.type");
    panel_named_value(document, "render.quality");
    ImGui::PopItemWidth();
    ImGui::PopID();
}
