/* Finds conditions that bound the motions of a table but not those of the target of its reduction: computed in the target, a motion
 * would be continued beyond its end. */
#include "emit/emit.h"

#include "fields/scratch.h"
#include "prove/image.h"
#include "prove/way_table.h"

#include <stdlib.h>

/* The expression of this table for a symbol of the target; TTC_NONE: not known. images, by id in the target's graph, has those of
 * earlier symbols. */
static ttc_id image_of(const ttc_model *model, const ttc_claim *claim, const ttc_model *target, const ttc_symbol_entry *symbol,
                       ttc_id *images)
{
    const ttc_id given = ttc_given_for(claim, symbol->name);
    const uint32_t own = symbol->kind == TTC_PARAM ? ttc_param_of(model, symbol->name) : UINT32_MAX;
    ttc_id definition = TTC_NONE;

    if (given != TTC_NONE) return ttc_model_expand(model, given);
    if (own != UINT32_MAX) return model->symbols[own].node;
    if (symbol->definition != TTC_NONE)
        definition = ttc_model_expand(model, ttc_carry(model->graph, target->graph, symbol->definition, images));
    if (symbol->kind == TTC_LET || (definition == TTC_NONE && symbol->kind != TTC_PI)) return definition;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const ttc_id defined = entry->definition != TTC_NONE ? ttc_model_expand(model, entry->definition) : TTC_NONE;
        if (entry->kind == symbol->kind && defined == definition) return entry->node;
    }
    return TTC_NONE;
}

/* Put the image of each condition in its place. What is not known of the target has the image `lambda`, which stands in no
 * condition. Returns false when memory is out. */
static bool map_conditions(ttc_id *conditions, size_t count, const ttc_model *model, const ttc_claim *claim,
                           const ttc_model *target)
{
    ttc_id *images = calloc(ttc_graph_size(target->graph) + 1, sizeof *images);
    if (images == NULL) return false;
    for (uint32_t i = 0; i < target->symbol_count; i++) {
        const ttc_symbol_entry *symbol = target->symbols + i;
        const ttc_id image = image_of(model, claim, target, symbol, images);
        images[symbol->node] = image != TTC_NONE ? image : model->symbols[0].node;
    }
    for (size_t i = 0; i < count; i++)
        conditions[i] = ttc_model_expand(model, ttc_carry(model->graph, target->graph, conditions[i], images));
    free(images);
    return true;
}

/* The expressions that are positive on the target's domain, in this table's names, lets written out. For free(); NULL when memory
 * is out. */
static ttc_id *find_conditions(size_t *count, const ttc_model *model, const ttc_claim *claim, const ttc_model *target)
{
    ttc_id *conditions = malloc((target->region_count + 2 * target->state_count + 1) * sizeof *conditions);
    *count = 0;
    if (conditions == NULL) return NULL;
    for (size_t i = 0; i < target->region_count; i++) conditions[(*count)++] = target->regions[i].expression;
    for (size_t i = 0; i < 2 * target->state_count; i++) {
        const ttc_id inside = ttc_model_inside(target, target->states[i / 2], i % 2 != 0);
        if (inside != TTC_NONE) conditions[(*count)++] = inside;
    }
    if (map_conditions(conditions, *count, model, claim, target)) return conditions;
    free(conditions);
    return NULL;
}

/* An expression divided by the size of its first coefficient: equal for two that differ by a positive number as a factor. */
static ttc_id without_factor(ttc_graph *graph, ttc_id id)
{
    const ttc_kind kind = id == TTC_NONE ? TTC_NUMBER : ttc_kind_of(graph, id);
    fmpq_t factor;
    if (kind != TTC_SUM && kind != TTC_PRODUCT) return id;
    fmpq_init(factor);
    fmpq_abs(factor, kind == TTC_SUM ? ttc_part_at(graph, id, 0).coefficient : ttc_coefficient(graph, id));
    fmpq_inv(factor, factor);
    id = ttc_scale(graph, id, factor);
    fmpq_clear(factor);
    return id;
}

/* Whether an expression has no state, or is one of these, up to a positive number. */
static bool is_kept(const ttc_model *model, ttc_id expression, const ttc_id *conditions, size_t count)
{
    const ttc_id own = without_factor(model->graph, ttc_model_expand(model, expression));
    unsigned char *support = ttc_model_support(model, &expression, 1);
    bool found = false, moves = support == NULL;
    for (size_t i = 0; i < count && !found; i++) found = without_factor(model->graph, conditions[i]) == own;
    for (size_t i = 0; i < model->state_count && !moves; i++) moves = support[model->states[i]] != 0;
    free(support);
    return found || !moves;
}

const char *ttc_emit_widened(const ttc_kernels *general, const ttc_claim *claim, const ttc_model *target)
{
    const ttc_model *model = general->field->model;
    size_t count;
    const char *name = NULL;
    if (claim->kind != TTC_CLAIM_REDUCTION) return NULL;
    ttc_id *conditions = find_conditions(&count, model, claim, target);
    if (conditions == NULL) return model->name;
    for (size_t i = 0; i < 2 * model->state_count && name == NULL; i++) {
        const ttc_id inside = ttc_model_inside(model, model->states[i / 2], i % 2 != 0);
        if (inside != TTC_NONE && !is_kept(model, inside, conditions, count)) name = model->symbols[model->states[i / 2]].name;
    }
    for (size_t i = 0; i < general->watched_count && name == NULL; i++)
        if (!is_kept(model, general->watched[i].expression, conditions, count)) name = general->watched[i].name;
    free(conditions);
    return name;
}
