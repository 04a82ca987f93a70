/* Definitions, equations and Jacobian in the same order as text and as LaTeX. */
#include "show/show.h"

#include "show/show_section.h"

static bool show_definitions(FILE *stream, const ttc_model *model, ttc_notation notation)
{
    bool latex = notation == TTC_NOTATION_LATEX;
    for (size_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const bool function = ttc_symbol_is_function(entry->kind);
        const char *open = !function ? "" : !latex ? "(" : entry->kind == TTC_ROOT ? "{" : "\\left(";
        const char *close = !function ? "" : !latex ? ")" : entry->kind == TTC_ROOT ? "}" : "\\right)";
        if (entry->definition == TTC_NONE) continue;
        ttc_print_symbol(stream, model, (uint32_t)i, notation);
        fprintf(stream, "%s%s%s%s", latex ? " &= " : " = ", latex && function ? "\\" : "", ttc_symbol_function(entry->kind), open);
        if (!ttc_print(stream, model, entry->definition, notation)) return false;
        fprintf(stream, latex ? "%s \\\\\n" : "%s\n", close);
    }
    return true;
}

static bool show_equations(FILE *stream, const ttc_model *model, ttc_notation notation)
{
    bool latex = notation == TTC_NOTATION_LATEX;
    for (size_t i = 0; i < model->state_count; i++) {
        fputs(latex ? "\\frac{\\mathrm{d}}{\\mathrm{d}t} " : "d ", stream);
        ttc_print_symbol(stream, model, model->states[i], notation);
        fputs(latex ? " &= " : "/dt = ", stream);
        if (!ttc_print(stream, model, ttc_model_field(model, i), notation)) return false;
        fputs(latex ? (i + 1 < model->state_count ? " \\\\\n" : "\n") : "\n", stream);
    }
    return true;
}

static bool show_jacobian(FILE *stream, const ttc_model *model, ttc_notation notation)
{
    bool latex = notation == TTC_NOTATION_LATEX;
    size_t shown = 0;
    for (size_t i = 0; i < model->state_count; i++)
        for (size_t k = 0; k < model->state_count; k++) {
            ttc_id entry = ttc_model_partial(model, ttc_model_field(model, i), model->states[k]);
            if (entry == TTC_NONE) return false;
            if (ttc_is_number(model->graph, entry, 0)) continue;
            if (latex && shown++ > 0) fputs(" \\\\\n", stream);
            fputs(latex ? "\\frac{\\partial \\dot{" : "J[", stream);
            ttc_print_symbol(stream, model, model->states[i], notation);
            fputs(latex ? "}}{\\partial " : ", ", stream);
            ttc_print_symbol(stream, model, model->states[k], notation);
            fputs(latex ? "} &= " : "] = ", stream);
            if (!ttc_print(stream, model, entry, notation)) return false;
            if (!latex) fputc('\n', stream);
        }
    if (latex && shown > 0) fputc('\n', stream);
    return true;
}

bool ttc_show_text(FILE *stream, const ttc_model *model)
{
    fprintf(stream, "# %s%s%s\n# sha256 %s\n\n", model->name, model->title == NULL ? "" : ": ",
            model->title == NULL ? "" : model->title, model->sha256);
    if (!show_definitions(stream, model, TTC_NOTATION_TEXT)) return false;
    if (model->lift.file != NULL) {
        fprintf(stream, "\n# lift into %s\n", model->lift.file);
        return ttc_show_lift(stream, model, TTC_NOTATION_TEXT);
    }
    fputs("\n# equations\n", stream);
    if (!show_equations(stream, model, TTC_NOTATION_TEXT)) return false;
    for (size_t i = 0; i < model->validity_count; i++) {
        fprintf(stream, "%s%s: ", i == 0 ? "\n# the model holds where\n" : "", model->validities[i].name);
        if (!ttc_print(stream, model, model->validities[i].expression, TTC_NOTATION_TEXT)) return false;
        fputs(" > 0\n", stream);
    }
    if (!ttc_show_sections(stream, model, TTC_NOTATION_TEXT) || !ttc_show_ways(stream, model, TTC_NOTATION_TEXT)) return false;
    fputs("\n# Jacobian, entries that are not zero: J[i, k] = d(d i/dt)/d k\n", stream);
    return show_jacobian(stream, model, TTC_NOTATION_TEXT);
}

bool ttc_show_latex(FILE *stream, const ttc_model *model)
{
    fprintf(stream, "%% %s, sha256 %s\n\\begin{align}\n", model->name, model->sha256);
    if (!show_definitions(stream, model, TTC_NOTATION_LATEX)) return false;
    if (model->lift.file != NULL) {
        fprintf(stream, "%% lift into %s\n", model->lift.file);
        if (!ttc_show_lift(stream, model, TTC_NOTATION_LATEX)) return false;
        fputs("\\end{align}\n", stream);
        return true;
    }
    if (!show_equations(stream, model, TTC_NOTATION_LATEX)) return false;
    fputs("\\end{align}\n", stream);
    if (!ttc_show_sections(stream, model, TTC_NOTATION_LATEX) ||
        !ttc_show_ways(stream, model, TTC_NOTATION_LATEX))
        return false;
    fputs("% Jacobian, entries that are not zero\n\\begin{align}\n", stream);
    if (!show_jacobian(stream, model, TTC_NOTATION_LATEX)) return false;
    fputs("\\end{align}\n", stream);
    return true;
}
