/* Writes the reversors of the table that only change signs of states. */
#include "emit/emit.h"

/* A reversor without condition that only changes signs of states; for fields with all states, in the model's own time. */
static bool changes_signs(const ttc_field *field, const ttc_claim *claim)
{
    const ttc_model *model = field->model;
    bool all = claim->kind == TTC_CLAIM_REVERSOR && claim->when.count == 0 && field->time == NULL && field->elimination == NULL;
    for (size_t i = 0; all && i < claim->bindings.count; i++) {
        ttc_id state = model->symbols[claim->bindings.items[i].symbol].node, image = claim->bindings.items[i].expression;
        all = image == state || ttc_add(field->graph, image, state) == ttc_integer(field->graph, 0);
    }
    return all;
}

static int sign_of(const ttc_field *field, const ttc_claim *claim, uint32_t state)
{
    for (size_t k = 0; k < claim->bindings.count; k++)
        if (claim->bindings.items[k].symbol == state)
            return claim->bindings.items[k].expression == field->model->symbols[state].node ? 1 : -1;
    return 1;
}

void ttc_emit_reversors(ttc_text *text, const ttc_field *field)
{
    const ttc_model *model = field->model;
    ttc_text list = { 0 };
    for (size_t k = 0; k < model->claim_count; k++) {
        if (!changes_signs(field, model->claims + k)) continue;
        ttc_text_format(text, "static const signed char signs_%zu[] = {", k);
        for (size_t i = 0; i < field->state_count; i++)
            ttc_text_format(text, "%s %d", i == 0 ? "" : ",", sign_of(field, model->claims + k, field->states[i]));
        ttc_text_add(text, " };\n");
        ttc_text_format(&list, "    { signs_%zu, %zu },\n", k, k);
    }
    if (list.length > 0) ttc_text_format(text, "static const jlt_reversor reversors[] = {\n%s};\n\n", ttc_text_string(&list));
    text->failed |= list.failed;
    ttc_text_clear(&list);
}

void ttc_emit_reversor_member(ttc_text *text, const ttc_field *field)
{
    size_t count = 0;
    for (size_t k = 0; k < field->model->claim_count; k++) count += changes_signs(field, field->model->claims + k);
    if (count > 0) ttc_text_format(text, "    .reversor_count = %zu, .reversors = reversors,\n", count);
}
