/* A control for every value of the scene, made from the tables that describe them. */
#include "viewer/panel_parts.h"
extern "C" {
#include "viewer/control.h"
}

#include <imgui.h>

#include <cmath>
#include <cstring>

static const float DRAG_SPEED = 0.02f;    /* units a pixel */
static const float CONTROL_SHARE = 0.58f; /* of the width; the rest is for names */

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

void panel_value(document *document, const dpl_section &section, const dpl_param &param)
{
    control_value value;
    char text[1024];
    control_read(&section, &param, &value);
    if (edit_value(param, &value))
        control_write(document->scene, &section, &param, &value);
    control_help(&section, &param, text, sizeof text);
    panel_explain(text);
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
        panel_tooltip(ImGui::IsItemHovered() ? "back to the values that were loaded" : section.help);
    for (const dpl_param *param = section.params; open && param->name; param++)
        panel_value(document, section, *param);
    ImGui::PopID();
}

void panel_values(document *document, bool all)
{
    ImGui::BeginChild("sections");
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * CONTROL_SHARE);
    for (int i = 0; dpl_scene_section(document->scene, i).name; i++) {
        dpl_section section = dpl_scene_section(document->scene, i);
        if (section.active || all)
            draw_section(document, section);
    }
    ImGui::PopItemWidth();
    ImGui::EndChild();
}

void panel_named_value(document *document, const char *name)
{
    for (int i = 0; dpl_scene_section(document->scene, i).name; i++) {
        dpl_section section = dpl_scene_section(document->scene, i);
        size_t length = strlen(section.name);
        if (strncmp(name, section.name, length) || name[length] != '.')
            continue;
        for (const dpl_param *param = section.params; param->name; param++)
            if (!strcmp(param->name, name + length + 1))
                panel_value(document, section, *param);
    }
}
