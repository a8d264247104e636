/* The menu of the scenes that come with dapple: those of the physical look first. */
#include "viewer/panel_parts.h"

#include <imgui.h>

#include <cstring>

/* Whether the scene is shaded by the look `physical`. */
static bool is_physical(const dpl_builtin_scene *builtin)
{
    char look[64] = "";
    dpl_scene *scene = dpl_scene_create(nullptr);
    bool known = scene && dpl_scene_read(scene, builtin->name, builtin->text, strlen(builtin->text)) &&
                 dpl_scene_get(scene, "render.look", look, sizeof look);
    dpl_scene_destroy(scene);
    return known && !strcmp(look, "physical");
}

/* The scenes of one group under its heading; none: no heading. */
static void show_group(const document *document, const char *heading, bool physical, commands *pressed)
{
    bool shown = false;
    for (const dpl_builtin_scene *scene = dpl_builtin_scenes(); scene->name; scene++) {
        if (is_physical(scene) != physical)
            continue;
        if (!shown)
            ImGui::TextDisabled("%s", heading);
        shown = true;
        if (ImGui::Selectable(scene->name, !strcmp(scene->name, document->path)))
            pressed->load = scene->name;
        panel_explain(scene->summary);
    }
}

void panel_scene_menu(const document *document, commands *pressed)
{
    const char *slash = strrchr(document->path, '/');
    ImGui::SetNextItemWidth(-ImGui::CalcTextSize(" scene").x);
    if (!ImGui::BeginCombo("scene", slash ? slash + 1 : document->path, ImGuiComboFlags_HeightLargest))
        return;
    show_group(document, "physical", true, pressed);
    show_group(document, "as published, and studies", false, pressed);
    ImGui::EndCombo();
}
