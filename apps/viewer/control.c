#include "viewer/control.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define NAME_SIZE 128
#define TEXT_SIZE (2 * DPL_PARAM_TEXT_SIZE)

void control_read(const struct dpl_section *section, const struct dpl_param *param, union control_value *value)
{
    static const size_t sizes[] = {
        [DPL_PARAM_FLOAT] = sizeof(double), [DPL_PARAM_INT] = sizeof(int),      [DPL_PARAM_BOOL] = sizeof(bool),
        [DPL_PARAM_CHOICE] = sizeof(int),   [DPL_PARAM_COLOR] = sizeof(double), [DPL_PARAM_TEXT] = DPL_PARAM_TEXT_SIZE,
    };
    memcpy(value, (const char *)section->values + param->offset, (size_t)param->count * sizes[param->type]);
}

void control_write(struct dpl_scene *scene, const struct dpl_section *section, const struct dpl_param *param,
                   const union control_value *value)
{
    char name[NAME_SIZE], text[TEXT_SIZE];
    struct dpl_param alone = *param;
    alone.offset = 0;
    snprintf(name, sizeof name, "%s.%s", section->name, param->name);
    if (dpl_param_format(&alone, value, text, sizeof text))
        dpl_scene_set(scene, name, text);
}

enum control_kind control_kind(const struct dpl_param *param)
{
    double usual = fmax(fabs(param->initial[0]), param->minimum);
    if (param->minimum <= -1000 && param->maximum >= 1000)
        return CONTROL_DRAG;
    if (param->type == DPL_PARAM_INT)
        return param->minimum >= 0 && param->maximum >= 1000 ? CONTROL_LOGARITHMIC : CONTROL_SLIDER;
    return param->minimum >= 0 && param->maximum > 1 && usual < param->maximum / 20 ? CONTROL_LOGARITHMIC
                                                                                    : CONTROL_SLIDER;
}

void control_format(const struct dpl_param *param, char *format, size_t size)
{
    bool logarithmic = control_kind(param) == CONTROL_LOGARITHMIC;
    bool roomy = param->count == 1 && *param->unit;
    snprintf(format, size, "%s%s%s",
             param->type == DPL_PARAM_INT ? "%d"
             : logarithmic                ? "%.4g"
                                          : "%.3f",
             roomy ? " " : "", roomy ? param->unit : "");
}

void control_help(const struct dpl_section *section, const struct dpl_param *param, char *text, size_t size)
{
    char accepted[TEXT_SIZE];
    dpl_param_describe(param, accepted, sizeof accepted);
    snprintf(text, size, "%s.%s\n%s\n%s%s", section->name, param->name, param->help, accepted,
             param->type == DPL_PARAM_TEXT ? "; taken with the enter key" : "");
}

void control_reset_label(const struct document *document, const struct dpl_section *section,
                         const struct dpl_param *param, char *text, size_t size)
{
    char name[NAME_SIZE], value[TEXT_SIZE];
    snprintf(name, sizeof name, "%s.%s", section->name, param->name);
    bool known = dpl_scene_get(document->start, name, value, sizeof value);
    snprintf(text, size, "reset to %s", known && *value ? value : "nothing");
}
