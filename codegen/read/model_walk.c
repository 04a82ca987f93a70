/* Expansion, derivatives and dependence of expressions through the definitions of lets and functions. */
#include "read/model.h"

#include <stdlib.h>

typedef struct {
    const ttc_model *model;
    uint32_t symbol; /* the variable of differentiation */
} frame;

static ttc_id let_definition(void *context, uint32_t symbol)
{
    const ttc_symbol_entry *entry = ((const frame *)context)->model->symbols + symbol;
    return entry->kind == TTC_LET ? entry->definition : TTC_NONE;
}

static ttc_id any_definition(void *context, uint32_t symbol)
{
    return ((const frame *)context)->model->symbols[symbol].definition;
}

static ttc_id expanded_value(void *context, uint32_t symbol, ttc_id definition_value)
{
    return definition_value != TTC_NONE ? definition_value : ((const frame *)context)->model->symbols[symbol].node;
}

ttc_id ttc_model_expand(const ttc_model *model, ttc_id id)
{
    frame f = { model, 0 };
    return ttc_substitute_through(model->graph, id, let_definition, expanded_value, &f);
}

ttc_id ttc_model_dividing_sum(const ttc_model *model, ttc_id id)
{
    if (ttc_kind_of(model->graph, id) != TTC_PRODUCT) return TTC_NONE;
    for (size_t i = 0; i < ttc_part_count(model->graph, id); i++) {
        const ttc_part part = ttc_part_at(model->graph, id, i);
        const ttc_id base = ttc_model_without_lets(model, part.id);
        if (part.exponent < 0 && ttc_kind_of(model->graph, base) == TTC_SUM) return base;
    }
    return TTC_NONE;
}

/* r^2 = q gives r' = q'/(2 r); (cos a)' = -(sin a) a', (sin a)' = (cos a) a'; (exp a)' = (exp a) a'; (log a)' = a'/a. */
static ttc_id slope(void *context, uint32_t symbol, ttc_id definition_slope)
{
    const frame *f = context;
    ttc_graph *graph = f->model->graph;
    const ttc_symbol_entry *entry = f->model->symbols + symbol;
    if (symbol == f->symbol) return ttc_integer(graph, 1);
    if (definition_slope == TTC_NONE || ttc_is_number(graph, definition_slope, 0)) return TTC_NONE;
    ttc_id factor;
    switch (entry->kind) {
    case TTC_ROOT: return ttc_divide(graph, definition_slope, ttc_multiply(graph, ttc_integer(graph, 2), entry->node));
    case TTC_COSINE:
        factor = ttc_multiply(graph, ttc_integer(graph, -1), f->model->symbols[entry->partner].node);
        return ttc_multiply(graph, factor, definition_slope);
    case TTC_SINE: return ttc_multiply(graph, f->model->symbols[entry->partner].node, definition_slope);
    case TTC_EXP: return ttc_multiply(graph, entry->node, definition_slope);
    case TTC_LOG: return ttc_divide(graph, definition_slope, entry->definition);
    default: return definition_slope;
    }
}

ttc_id ttc_model_partial(const ttc_model *model, ttc_id id, uint32_t symbol)
{
    frame f = { model, symbol };
    return ttc_derivative_through(model->graph, id, any_definition, slope, &f);
}

/* out + factor * term; where the factor is a sum it is multiplied out. */
static ttc_id add_products(ttc_graph *graph, ttc_id out, ttc_id factor, ttc_id term)
{
    if (ttc_kind_of(graph, factor) != TTC_SUM) return ttc_add(graph, out, ttc_multiply(graph, factor, term));
    out = ttc_add(graph, out, ttc_scale(graph, term, ttc_coefficient(graph, factor)));
    for (size_t i = 0; out != TTC_NONE && i < ttc_part_count(graph, factor); i++) {
        const ttc_part part = ttc_part_at(graph, factor, i);
        out = ttc_add(graph, out, ttc_scale(graph, ttc_multiply(graph, part.id, term), part.coefficient));
    }
    return out;
}

ttc_id ttc_model_rate(const ttc_model *model, ttc_id id)
{
    ttc_id rate = ttc_integer(model->graph, 0);
    for (size_t i = 0; rate != TTC_NONE && i < model->state_count; i++) {
        const ttc_id partial = ttc_model_partial(model, id, model->states[i]);
        if (partial == TTC_NONE) return TTC_NONE;
        for (size_t k = 0; rate != TTC_NONE && k < model->equations[i].term_count; k++)
            rate = add_products(model->graph, rate, partial, model->equations[i].terms[k].expression);
    }
    return rate;
}

unsigned char *ttc_model_support(const ttc_model *model, const ttc_id *ids, size_t count)
{
    ttc_id last = TTC_NONE;
    for (size_t i = 0; i < count; i++)
        if (ids[i] > last) last = ids[i];
    unsigned char *seen = calloc((size_t)last + 1, 1);
    unsigned char *support = calloc(model->symbol_count, 1);
    if (seen == NULL || support == NULL) {
        free(seen);
        free(support);
        return NULL;
    }
    for (size_t i = 0; i < count; i++) seen[ids[i]] = 1;
    for (ttc_id at = last; at > 0; at--) {
        if (!seen[at]) continue;
        for (size_t i = 0; i < ttc_part_count(model->graph, at); i++) seen[ttc_part_at(model->graph, at, i).id] = 1;
        if (ttc_kind_of(model->graph, at) != TTC_SYMBOL) continue;
        uint32_t symbol = ttc_symbol_of(model->graph, at);
        support[symbol] = 1;
        seen[model->symbols[symbol].definition] = 1; /* TTC_NONE marks the unused entry 0 */
    }
    free(seen);
    return support;
}

ttc_id ttc_model_without_lets(const ttc_model *model, ttc_id id)
{
    while (ttc_kind_of(model->graph, id) == TTC_SYMBOL && ttc_symbol_of(model->graph, id) < model->symbol_count &&
           model->symbols[ttc_symbol_of(model->graph, id)].kind == TTC_LET)
        id = model->symbols[ttc_symbol_of(model->graph, id)].definition;
    return id;
}

bool ttc_model_depends(const ttc_model *model, ttc_id id, uint32_t symbol)
{
    unsigned char *support = ttc_model_support(model, &id, 1);
    bool result = support == NULL || support[symbol];
    free(support);
    return result;
}

/* Uses and divisors in the definition of an angle are stored with one of the pair. */
static bool is_used_by_partner(const ttc_model *model, const unsigned char *used, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    return (entry->kind == TTC_COSINE || entry->kind == TTC_SINE) && used[entry->partner];
}

void ttc_model_close_uses(const ttc_model *model, unsigned char *used)
{
    /* A definition names only what stands above it, so that one sweep from the last use to the first finds all. */
    for (size_t i = model->use_count; i-- > 0;) {
        const ttc_use *use = &model->uses[i];
        if (use->role == TTC_DIVIDES_SYMBOL && (used[use->owner] || is_used_by_partner(model, used, use->owner)))
            used[use->symbol] = 1;
    }
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (is_used_by_partner(model, used, i)) used[i] = 1;
}

unsigned char *ttc_model_uses_between(const ttc_model *model, ttc_divisor_role role, uint32_t owner, size_t first, size_t end)
{
    unsigned char *used = calloc(model->symbol_count + 1, 1);
    size_t number = 0;
    if (used == NULL) return NULL;
    for (size_t i = 0; i < model->use_count; i++) {
        const ttc_use *use = &model->uses[i];
        if (use->role != role || use->owner != owner) continue;
        if (number >= first && number < end) used[use->symbol] = 1;
        number++;
    }
    ttc_model_close_uses(model, used);
    return used;
}

unsigned char *ttc_model_uses_of(const ttc_model *model, ttc_divisor_role role, uint32_t owner)
{
    return ttc_model_uses_between(model, role, owner, 0, SIZE_MAX);
}

unsigned char *ttc_model_uses(const ttc_model *model) { return ttc_model_uses_of(model, TTC_DIVIDES_FIELD, 0); }

unsigned char *ttc_model_uses_of_domain(const ttc_model *model)
{
    unsigned char *used = ttc_model_uses(model);
    if (used == NULL) return NULL;
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_ROOT || model->symbols[i].kind == TTC_LOG) used[i] = 1;
    ttc_model_close_uses(model, used);
    return used;
}

bool ttc_model_prepares(const ttc_model *model, uint32_t claim, const ttc_divisor *divisor)
{
    const ttc_claim *of = model->claims + claim;
    const bool is_quantity = of->kind == TTC_CLAIM_INTEGRAL || of->kind == TTC_CLAIM_MEASURE;
    if (!is_quantity || of->when.count + of->modulo_count > 0) return false;
    if (divisor->role != TTC_DIVIDES_SYMBOL) return divisor->role == TTC_DIVIDES_CLAIM && divisor->owner == claim;
    unsigned char *used = ttc_model_uses_of(model, TTC_DIVIDES_CLAIM, claim);
    const bool uses = used == NULL || used[divisor->owner];
    free(used);
    return uses;
}

bool ttc_model_vanishes_with(const ttc_model *model, ttc_id expression, const ttc_symbol_entry *param)
{
    const ttc_graph *graph = model->graph;
    if (expression == param->node) return true;
    if (ttc_kind_of(graph, expression) == TTC_SYMBOL) {
        const ttc_symbol_entry *entry = model->symbols + ttc_symbol_of(graph, expression);
        return entry->kind == TTC_LET && ttc_model_vanishes_with(model, entry->definition, param);
    }
    const bool is_sum = ttc_kind_of(graph, expression) == TTC_SUM;
    const size_t count = ttc_part_count(graph, expression);
    if (is_sum && !fmpq_is_zero(ttc_coefficient(graph, expression))) return false;
    /* A sum vanishes with all its terms, a product with one factor. */
    for (size_t i = 0; i < count; i++) {
        const ttc_part part = ttc_part_at(graph, expression, i);
        if ((part.exponent > 0 && ttc_model_vanishes_with(model, part.id, param)) != is_sum) return !is_sum;
    }
    return is_sum;
}

const ttc_symbol_entry *ttc_model_zero_divisor(const ttc_model *model, ttc_id divisor)
{
    for (size_t i = 0; i < model->param_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + model->params[i];
        const bool may_vanish = entry->sign == TTC_ANY_SIGN || entry->sign == TTC_NONNEGATIVE;
        if (may_vanish && ttc_model_vanishes_with(model, divisor, entry)) return entry;
    }
    return NULL;
}
