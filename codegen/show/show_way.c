/* Shows a table's tier, and its ways to tables that serve in its place. */
#include "show/show_image.h"
#include "show/show_section.h"

static bool is_latex(ttc_notation notation) { return notation == TTC_NOTATION_LATEX; }

static void show_inequalities(FILE *stream, const char *word, const ttc_inequalities *list)
{
    for (size_t i = 0; i < list->count; i++) fprintf(stream, "%s%s", i == 0 ? word : ", ", list->items[i].text);
}

static void show_tier(FILE *stream, const ttc_tier *tier, ttc_notation notation)
{
    if (tier->name == NULL) return;
    fprintf(stream, "%s tier %s: %s", is_latex(notation) ? "%" : "\n#", tier->name, tier->meaning);
    show_inequalities(stream, "; while ", &tier->conditions);
    fputc('\n', stream);
}

static bool show_way(FILE *stream, const ttc_model *model, const ttc_way *way, ttc_notation notation)
{
    const ttc_claim *claim = model->claims + way->claim;
    fprintf(stream, "%s %s %s: %s %s", is_latex(notation) ? "%" : "\n#", ttc_claim_kind_name(claim->kind), claim->name,
            claim->kind == TTC_CLAIM_DESCENT ? "by" : "into", claim->target);
    for (size_t i = 0; i < claim->when.count; i++) {
        fprintf(stream, "%s%s = ", i == 0 ? ", when " : ", ", model->symbols[claim->when.items[i].symbol].name);
        if (!ttc_print(stream, model, claim->when.items[i].expression, TTC_NOTATION_TEXT)) return false;
    }
    show_inequalities(stream, ", where ", &way->where);
    fputs(is_latex(notation) ? "\n\\begin{align}\n" : "\n", stream);
    if (!ttc_show_image(stream, model, claim, &way->image, notation)) return false;
    if (is_latex(notation)) fputs("\\end{align}\n", stream);
    return true;
}

bool ttc_show_ways(FILE *stream, const ttc_model *model, ttc_notation notation)
{
    show_tier(stream, &model->tier, notation);
    for (size_t i = 0; i < model->way_count; i++)
        if (!show_way(stream, model, model->ways + i, notation)) return false;
    return true;
}
