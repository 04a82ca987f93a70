/* Writes an array of quantities: name, unit, meaning, interval, sign, default, period. */
#include "emit/emit.h"

static void add_double(ttc_text *text, const ttc_graph *graph, ttc_id id, const char *otherwise)
{
    if (ttc_number_value(graph, id) != NULL) ttc_emit_constant(text, ttc_number_value(graph, id));
    else ttc_text_add(text, otherwise);
}

void ttc_emit_quantities(ttc_text *text, const char *name, const ttc_model *model, const uint32_t *symbols, size_t count,
                         const bool *is_angle)
{
    static const char *const signs[] = { "JLT_ANY_SIGN", "JLT_POSITIVE", "JLT_NONNEGATIVE", "JLT_NONZERO" };
    if (count == 0) return;
    ttc_text_format(text, "static const jlt_quantity %s[] = {\n", name);
    for (size_t i = 0; i < count; i++) {
        const ttc_symbol_entry *s = model->symbols + symbols[i];
        ttc_text_format(text, "    { \"%s\", \"", s->name);
        ttc_text_add_escaped(text, s->unit);
        ttc_text_add(text, "\", \"");
        ttc_text_add_escaped(text, s->meaning);
        ttc_text_add(text, "\", ");
        add_double(text, model->graph, s->kind == TTC_STATE ? s->low : TTC_NONE, s->kind == TTC_ROOT ? "0.0" : "-INFINITY");
        ttc_text_add(text, ", ");
        add_double(text, model->graph, s->kind == TTC_STATE ? s->high : TTC_NONE, "INFINITY");
        ttc_text_format(text, ", %s, ", s->kind == TTC_PARAM ? signs[s->sign] : signs[0]);
        add_double(text, model->graph, s->kind == TTC_PARAM ? s->value : TTC_NONE, "NAN");
        ttc_text_add(text, ", ");
        const bool turns = is_angle != NULL && is_angle[i];
        add_double(text, model->graph, s->kind == TTC_STATE ? s->period : TTC_NONE, turns ? "2.0*" TTC_PI_DOUBLE : "0.0");
        if (s->kind == TTC_STATE && s->in_pi) ttc_text_add(text, "*" TTC_PI_DOUBLE);
        ttc_text_add(text, " },\n");
    }
    ttc_text_add(text, "};\n\n");
}
