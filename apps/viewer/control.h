/* control.h: what a value's control needs to know beyond its table entry, and the value's way into the control and back
 * to the scene as text. */
#ifndef VIEWER_CONTROL_H
#define VIEWER_CONTROL_H

#include "viewer/document.h"

union control_value {
    double numbers[3];
    int integers[3];
    bool flag;
    char text[DPL_PARAM_TEXT_SIZE];
};

/* Copies the value out of its section. */
void control_read(const struct dpl_section *section, const struct dpl_param *param, union control_value *value);

/* Sets the value in the scene, checked as all text is. */
void control_write(struct dpl_scene *scene, const struct dpl_section *section, const struct dpl_param *param,
                   const union control_value *value);

enum control_kind {
    CONTROL_SLIDER,
    CONTROL_LOGARITHMIC, /* a slider: the usual values would share a small part of a straight one */
    CONTROL_DRAG,        /* no end is near: moved at a steady pace */
};
enum control_kind control_kind(const struct dpl_param *param);

/* How a number is written in its control, for printf: "%.3f m". */
void control_format(const struct dpl_param *param, char *format, size_t size);

/* Lines for people: name, meaning and accepted values. */
void control_help(const struct dpl_section *section, const struct dpl_param *param, char *text, size_t size);

/* "reset to 60". */
void control_reset_label(const struct document *document, const struct dpl_section *section,
                         const struct dpl_param *param, char *text, size_t size);

#endif
