#include "show/show_image.h"

static bool is_latex(ttc_notation notation) { return notation == TTC_NOTATION_LATEX; }

bool ttc_show_row(FILE *stream, const ttc_model *model, const char *name, ttc_id id, ttc_notation notation)
{
    ttc_print_name(stream, name, notation);
    fputs(is_latex(notation) ? " &= " : " = ", stream);
    return ttc_print(stream, model, id, notation);
}

const char *ttc_show_end_of_row(ttc_notation notation, bool is_last)
{
    return is_latex(notation) && !is_last ? " \\\\\n" : "\n";
}

static bool show_name(FILE *stream, const ttc_model *model, const ttc_id *entries, const char *name, ttc_given_form form,
                      ttc_notation notation)
{
    const bool latex = is_latex(notation), angle = form == TTC_GIVEN_ANGLE;
    if (form == TTC_GIVEN_PLAIN) return ttc_show_row(stream, model, name, entries[0], notation);
    ttc_print_name(stream, name, notation);
    if (angle) fputs(latex ? " &= \\operatorname{atan2}\\left(" : " = atan2(", stream);
    else fputs(latex ? " &= \\sqrt{" : " = sqrt(", stream);
    if (!ttc_print(stream, model, entries[0], notation)) return false;
    if (angle) fputs(", ", stream);
    if (angle && !ttc_print(stream, model, entries[1], notation)) return false;
    if (angle) fputs(latex ? "\\right)" : ")", stream);
    else fputs(latex ? "}" : ")", stream);
    return true;
}

bool ttc_show_image(FILE *stream, const ttc_model *model, const ttc_claim *claim, const ttc_image *image, ttc_notation notation)
{
    for (size_t k = 0; k < image->count; k++) {
        if (!show_name(stream, model, claim->entries + 2 * k, image->names[k], image->forms[k], notation)) return false;
        fputs(ttc_show_end_of_row(notation, image->level_count == 0 && k + 1 == image->count), stream);
    }
    for (size_t k = 0; k < image->level_count; k++) {
        if (!ttc_show_row(stream, model, image->levels[k], model->claims[claim->members[k]].expression, notation)) return false;
        fputs(ttc_show_end_of_row(notation, k + 1 == image->level_count), stream);
    }
    return true;
}
