/* Writes kernels for lifted roots: root^2 - radicand, which orbits keep at zero, and its gradient; and which state is eliminated,
 * by which integral. */
#include "emit/emit.h"

#include <stdlib.h>

bool ttc_emit_roots(ttc_text *text, ttc_field *field)
{
    const size_t count = ttc_field_lifted_count(field), n = field->state_count;
    const ttc_model *model = field->model;
    if (count == 0) return true;
    ttc_id *relations = calloc(count, sizeof *relations), *gradients = calloc(count * n, sizeof *gradients);
    bool ok = relations != NULL && gradients != NULL;
    for (size_t i = 0; ok && i < count; i++) {
        const ttc_symbol_entry *root = model->symbols + field->time->lifted[i];
        const ttc_id square = ttc_power(field->graph, ttc_field_specialise(field, root->node), 2);
        const ttc_id radicand = ttc_field_specialise(field, root->definition);
        relations[i] = ttc_subtract(field->graph, square, radicand);
        ok = relations[i] != TTC_NONE;
        for (size_t j = 0; ok && j < n; j++) {
            gradients[i * n + j] = ttc_field_partial(field, relations[i], j);
            ok = gradients[i * n + j] != TTC_NONE;
        }
    }
    ok = ok && ttc_emit_outputs(text, "root_relations", field, relations, count) &&
         ttc_emit_outputs(text, "root_relation_gradients", field, gradients, count * n);
    free(gradients);
    free(relations);
    return ok;
}

static void add_elimination(ttc_text *text, const ttc_field *field)
{
    const ttc_model *model = field->model;
    size_t state = 0, integral = 0;
    while (model->states[state] != field->elimination->state) state++;
    for (size_t i = 0; i < field->elimination->integral; i++)
        integral += model->claims[i].kind == TTC_CLAIM_INTEGRAL && model->claims[i].when.count == 0
                    && model->claims[i].modulo_count == 0;
    ttc_text_format(text, "    .eliminated_state = %zu, .level_integral = %zu,\n", state, integral);
}

void ttc_emit_root_member(ttc_text *text, const ttc_field *field)
{
    if (ttc_field_lifted_count(field) > 0)
        ttc_text_format(
            text,
            "    .lifted_count = %zu, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,\n",
            ttc_field_lifted_count(field));
    if (field->elimination != NULL) add_elimination(text, field);
}
