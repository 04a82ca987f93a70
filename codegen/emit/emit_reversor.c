/* What a reversor of the table does to the states, where that is a change of signs. */
#include "emit/emit.h"

/* The first reversor that changes signs of states and no more, and holds for all parameters. NULL: none. */
static const ttc_claim *sign_reversor(const ttc_field *field)
{
    const ttc_model *model = field->model;
    if (field->time != NULL || field->elimination != NULL) return NULL;
    for (size_t k = 0; k < model->claim_count; k++) {
        const ttc_claim *claim = model->claims + k;
        bool changes_signs = claim->kind == TTC_CLAIM_REVERSOR && claim->when.count == 0;
        for (size_t i = 0; changes_signs && i < claim->bindings.count; i++) {
            ttc_id state = model->symbols[claim->bindings.items[i].symbol].node, image = claim->bindings.items[i].expression;
            changes_signs = image == state || ttc_add(field->graph, image, state) == ttc_integer(field->graph, 0);
        }
        if (changes_signs) return claim;
    }
    return NULL;
}

void ttc_emit_reversor(ttc_text *text, const ttc_field *field)
{
    const ttc_model *model = field->model;
    const ttc_claim *claim = sign_reversor(field);
    if (claim == NULL) return;
    ttc_text_add(text, "static const signed char reversed[] = {");
    for (size_t i = 0; i < field->state_count; i++) {
        int sign = 1;
        for (size_t k = 0; k < claim->bindings.count; k++)
            if (claim->bindings.items[k].symbol == field->states[i] && claim->bindings.items[k].expression != model->symbols[field->states[i]].node)
                sign = -1;
        ttc_text_format(text, "%s %d", i == 0 ? "" : ",", sign);
    }
    ttc_text_add(text, " };\n\n");
}

void ttc_emit_reversor_member(ttc_text *text, const ttc_field *field)
{
    const ttc_claim *claim = sign_reversor(field);
    if (claim != NULL) ttc_text_format(text, "    .reversed = reversed, .reversor = %zu,\n", (size_t)(claim - field->model->claims));
}
