/* Shows poles and sections, and the lift of a table of coordinates. */
#include "show/show_section.h"

#include "show/show_image.h"

static bool is_latex(ttc_notation notation) { return notation == TTC_NOTATION_LATEX; }

bool ttc_show_lift(FILE *stream, const ttc_model *model, ttc_notation notation)
{
    const ttc_lift *lift = &model->lift;
    for (size_t i = 0; i < lift->bindings.count; i++) {
        if (!ttc_show_row(stream, model, lift->names[i], lift->bindings.items[i].expression, notation)) return false;
        fputs(ttc_show_end_of_row(notation, i + 1 == lift->bindings.count), stream);
    }
    return true;
}

static bool show_poles(FILE *stream, const ttc_model *model, ttc_notation notation)
{
    for (size_t i = 0; i < model->pole_count; i++) {
        const ttc_symbol_entry *state = model->symbols + model->poles[i].state;
        fputs(is_latex(notation) ? "% orbits end at " : i == 0 ? "\n# orbits end at\n" : "", stream);
        fprintf(stream, "%s = ", state->name);
        if (!ttc_print(stream, model, state->low, TTC_NOTATION_TEXT)) return false;
        fputs(" and ", stream);
        if (!ttc_print(stream, model, state->high, TTC_NOTATION_TEXT)) return false;
        if (model->poles[i].meaning != NULL) fprintf(stream, ": %s", model->poles[i].meaning);
        fputc('\n', stream);
    }
    return true;
}

static bool show_section(FILE *stream, const ttc_model *model, const ttc_section *section, ttc_notation notation)
{
    const ttc_claim *claim = model->claims + section->claim;
    fprintf(stream, "%s section %s: %s = ", is_latex(notation) ? "%" : "\n#", claim->name,
            model->symbols[claim->when.items[0].symbol].name);
    if (!ttc_print(stream, model, claim->when.items[0].expression, TTC_NOTATION_TEXT)) return false;
    fprintf(stream, ", in the coordinates of %s\n%s", claim->target, is_latex(notation) ? "\\begin{align}\n" : "");
    if (!ttc_show_image(stream, model, claim, &section->image, notation)) return false;
    if (is_latex(notation)) fputs("\\end{align}\n", stream);
    return true;
}

bool ttc_show_sections(FILE *stream, const ttc_model *model, ttc_notation notation)
{
    if (!show_poles(stream, model, notation)) return false;
    for (size_t i = 0; i < model->section_count; i++)
        if (!show_section(stream, model, model->sections + i, notation)) return false;
    return true;
}
