/* Makes the names by which emitted files refer to each other. */
#include "emit/emit.h"

static void add_stem(ttc_text *text, const char *variant, const ttc_field *field)
{
    ttc_text_add(text, variant);
    if (field->time != NULL) ttc_text_format(text, "_in_%s", field->time->name);
    if (field->elimination != NULL) ttc_text_format(text, "_on_%s", field->elimination->name);
}

void ttc_emit_stem(ttc_text *text, const ttc_field *field)
{
    add_stem(text, field->variant == NULL ? "general" : field->variant->name, field);
}

void ttc_emit_ball_name(ttc_text *text, const ttc_field *field)
{
    ttc_text_format(text, "jlt_balls_%s_", field->model->name);
    add_stem(text, "general", field);
}
