#include "prove/domain.h"

#include "base/array.h"
#include "prove/question.h"
#include "prove/signs.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* A list of expressions whose symbols are looked for. */
typedef struct {
    ttc_id *ids;
    size_t count;
    bool failed;
} id_list;

static void add_id(id_list *list, ttc_id id)
{
    if (id == TTC_NONE) return;
    list->failed |= !TTC_ARRAY_GROW(list->ids, list->count);
    if (list->failed) return;
    list->ids[list->count++] = id;
}

static void add_bindings(id_list *list, const ttc_bindings *bindings)
{
    for (size_t i = 0; i < bindings->count; i++) add_id(list, bindings->items[i].expression);
}

static void add_claim(id_list *list, const ttc_model *model, const ttc_claim *claim)
{
    add_id(list, claim->expression);
    add_id(list, claim->other);
    add_bindings(list, &claim->bindings);
    add_bindings(list, &claim->when);
    for (size_t i = 0; i < claim->entry_count; i++) add_id(list, claim->entries[i]);
    for (size_t i = 0; i < claim->member_count; i++) add_id(list, model->claims[claim->members[i]].expression);
    for (size_t i = 0; i < claim->modulo_count; i++) add_id(list, model->claims[claim->modulo[i]].expression);
}

static bool owner_counts(const ttc_task *task, const ttc_divisor *d, ttc_domain_extent extent)
{
    const ttc_claim *claim = task->claim, *family = ttc_task_family(task);
    if (d->role == task->role && d->owner == task->owner) return extent != TTC_DOMAIN_WITHOUT_CLAIM;
    if (d->role != TTC_DIVIDES_CLAIM) return false;
    if (family != NULL && family != claim && d->owner == claim->family) return true;
    for (size_t i = 0; i < claim->member_count; i++)
        if (claim->members[i] == d->owner) return extent != TTC_DOMAIN_WITHOUT_CLAIM;
    for (size_t i = 0; i < claim->modulo_count; i++)
        if (claim->modulo[i] == d->owner) return true;
    return false;
}

/* Returns true for roots and logarithms of the domain, which need not be used: all but those after one under test. */
static bool is_in_domain(const ttc_task *task, uint32_t symbol)
{
    const ttc_symbol_kind kind = task->model->symbols[symbol].kind;
    return (kind == TTC_ROOT || kind == TTC_LOG) && (task->tested_root == 0 || symbol <= task->tested_root);
}

unsigned char *ttc_domain_support(const ttc_task *task, ttc_domain_extent extent)
{
    const ttc_model *model = task->model;
    const ttc_claim *family = ttc_task_family(task);
    id_list list = { NULL, 0, false };
    for (size_t i = 0; i < model->equation_count; i++) add_id(&list, model->equations[i].sum);
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        if (is_in_domain(task, i)) add_id(&list, model->symbols[i].node);
        if (model->symbols[i].kind != TTC_STATE) continue;
        add_id(&list, model->symbols[i].low);
        add_id(&list, model->symbols[i].high);
    }
    for (size_t i = 0; i < model->region_count; i++) add_id(&list, model->regions[i].expression);
    for (size_t i = 0; i < model->divisor_count; i++)
        if (model->divisors[i].role == TTC_DIVIDES_FIELD
            || (extent != TTC_DOMAIN_WITHOUT_CLAIM && model->divisors[i].role == task->role
                && model->divisors[i].owner == task->owner))
            add_id(&list, model->divisors[i].divisor);
    if (extent != TTC_DOMAIN_WITHOUT_CLAIM) add_claim(&list, model, task->claim);
    if (family != NULL && family != task->claim) add_claim(&list, model, family);
    unsigned char *support = list.failed ? NULL : ttc_model_support(model, list.ids, list.count);
    free(list.ids);
    for (size_t i = 0; support != NULL && i < model->use_count; i++) {
        const ttc_use *use = &model->uses[i];
        const ttc_divisor as_divisor = { TTC_NONE, use->role, use->owner };
        if (use->role == TTC_DIVIDES_FIELD || owner_counts(task, &as_divisor, extent)) support[use->symbol] = 1;
    }
    if (support != NULL) ttc_model_close_uses(model, support);
    return support;
}

static bool depends_on_states(const ttc_model *model, ttc_id id)
{
    unsigned char *support = ttc_model_support(model, &id, 1);
    bool result = support == NULL;
    for (size_t i = 0; !result && i < model->state_count; i++) result = support[model->states[i]] != 0;
    free(support);
    return result;
}

bool ttc_domain_is_of_tested(const ttc_task *task, ttc_id id)
{
    return ttc_question_depends(task, id) && !depends_on_states(task->model, id);
}

/* Returns true while only conditions on parameters count: in the task of a variant, until its values are shown to obey the signs of
 * parameters. After that, conditions on states count too. */
static bool is_of_parameters(const ttc_task *task)
{
    return task->role == TTC_DIVIDES_VARIANT && (task->tested != NULL || task->claim->when.count == 0);
}

static bool divisor_counts(const ttc_task *task, const ttc_divisor *d, const unsigned char *support, ttc_domain_extent extent)
{
    if (is_of_parameters(task) && depends_on_states(task->model, d->divisor)) return owner_counts(task, d, extent);
    if (task->role == TTC_DIVIDES_LIFT) return false; /* the claim has to show that they are not zero */
    switch (d->role) {
    case TTC_DIVIDES_FIELD: return true;
    case TTC_DIVIDES_SYMBOL: return support[d->owner] != 0;
    default: return owner_counts(task, d, extent);
    }
}

unsigned char *ttc_domain_divisors_of_claim(const ttc_task *task)
{
    const ttc_model *model = task->model;
    unsigned char *whole = ttc_domain_support(task, TTC_DOMAIN_WHOLE), *rest = ttc_domain_support(task, TTC_DOMAIN_WITHOUT_CLAIM);
    unsigned char *of_claim = whole != NULL && rest != NULL ? calloc(model->divisor_count + 1, 1) : NULL;
    for (size_t i = 0; of_claim != NULL && i < model->divisor_count; i++)
        of_claim[i] = divisor_counts(task, &model->divisors[i], whole, TTC_DOMAIN_WHOLE)
                      && !divisor_counts(task, &model->divisors[i], rest, TTC_DOMAIN_WITHOUT_CLAIM);
    free(rest);
    free(whole);
    return of_claim;
}

/* Returns true if the expression is a root. A root is positive, so that dividing by it excludes no further points; but in the test
 * whether its radicand is positive it excludes that the radicand is zero. */
static bool is_root(const ttc_model *model, ttc_id id, uint32_t *root)
{
    if (ttc_kind_of(model->graph, id) != TTC_SYMBOL) return false;
    *root = ttc_symbol_of(model->graph, id);
    return model->symbols[*root].kind == TTC_ROOT;
}

/* Add a condition. If this makes the list contradictory, the text becomes task->why_empty. */
TTC_PRINTF(5, 6)
static void add(ttc_task *task, ttc_conditions *c, const ttc_ratio *value, ttc_relation relation, const char *format, ...)
{
    bool before = c->contradictory;
    ttc_conditions_add(c, value, relation);
    if (before || !c->contradictory) return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(task->why_empty, sizeof task->why_empty, format, arguments);
    va_end(arguments);
}

/* Returns true if the expression is a symbol under test: that it is not zero is part of what the claim has to show. */
static bool is_tested_symbol(const ttc_task *task, ttc_id id)
{
    return ttc_kind_of(task->model->graph, id) == TTC_SYMBOL && ttc_question_is_tested(task, ttc_symbol_of(task->model->graph, id));
}

static void add_divisor(ttc_task *task, ttc_conditions *c, ttc_id id, ttc_domain_extent extent, ttc_ratio *value)
{
    uint32_t root;
    if (is_root(task->model, id, &root)) {
        if (root != task->tested_root) return;
        id = task->model->symbols[root].definition;
    } else if (ttc_kind_of(task->model->graph, id) == TTC_PRODUCT) {
        /* Add each factor by itself: it is simpler than the product, and often a root. */
        for (size_t i = 0; i < ttc_part_count(task->model->graph, id); i++)
            add_divisor(task, c, ttc_part_at(task->model->graph, id, i).id, extent, value);
        return;
    } else if (ttc_question_uses_root(task, id) || (ttc_question_depends(task, id) && task->tested_root != 0)) {
        task->has_left_out |= task->tested_root == 0 || !ttc_model_depends(task->model, id, task->tested_root);
        return;
    } else if ((extent == TTC_DOMAIN_OUT_OF_QUESTION || extent == TTC_DOMAIN_OF_OTHERS) && ttc_question_depends(task, id)) {
        task->has_left_out |= !is_tested_symbol(task, id);
        return;
    }
    ttc_evaluate(task->field, value, id);
    add(task, c, value, TTC_IS_NONZERO, "a denominator vanishes under the conditions of this claim");
}

static void add_state(ttc_task *task, ttc_conditions *c, const ttc_symbol_entry *entry, ttc_ratio *value, ttc_ratio *end)
{
    if (entry->low != TTC_NONE) {
        ttc_evaluate(task->field, value, entry->node);
        ttc_evaluate(task->field, end, entry->low);
        ttc_ratio_subtract(task->ring, value, value, end);
        add(task, c, value, TTC_IS_POSITIVE, "%s lies outside its domain under the conditions of this claim", entry->name);
    }
    if (entry->high != TTC_NONE) {
        ttc_evaluate(task->field, value, entry->node);
        ttc_evaluate(task->field, end, entry->high);
        ttc_ratio_subtract(task->ring, value, end, value);
        add(task, c, value, TTC_IS_POSITIVE, "%s lies outside its domain under the conditions of this claim", entry->name);
    }
}

ttc_relation ttc_domain_relation(ttc_sign sign)
{
    switch (sign) {
    case TTC_POSITIVE: return TTC_IS_POSITIVE;
    case TTC_NONZERO: return TTC_IS_NONZERO;
    default: return TTC_IS_NONNEGATIVE;
    }
}

/* Add that a radicand, or the argument of a logarithm, is positive; and that the root is, if it has a value. A root that nothing
 * has used is not evaluated, so that it does not enter the ring. */
static void add_root(ttc_task *task, ttc_conditions *c, uint32_t symbol, ttc_ratio *value)
{
    const ttc_symbol_entry *entry = &task->model->symbols[symbol];
    if (ttc_question_has(task, symbol)) return;
    ttc_evaluate(task->field, value, entry->definition);
    add(task, c, value, TTC_IS_POSITIVE, "what %s is the %s of is zero or negative under the conditions of this claim", entry->name,
        entry->kind == TTC_LOG ? "logarithm" : "root");
    if (entry->kind == TTC_LOG || !ttc_valuation_has_value(task->field, symbol)) return;
    ttc_evaluate(task->field, value, entry->node);
    ttc_conditions_add(c, value, TTC_IS_POSITIVE);
}

/* Add the signs of an angle that nothing here uses: conditions of the other table, or a multiple of the angle, may use it. Only if
 * it has a value, which the domain does not require; and only while the ring has many generators left for what the claim uses. */
static void add_unused_angle(ttc_task *task, ttc_conditions *c, uint32_t cosine)
{
    ttc_ring *ring = task->ring;
    if (ring->status != TTC_RING_OK || ring->generator_count >= TTC_GENERATOR_LIMIT / 4) return;
    ttc_domain_add_angle(task, c, cosine);
    if (ring->status != TTC_RING_NO_MEMORY) ring->status = TTC_RING_OK;
}

/* Flags, by symbol, of what the angles that are used depend on, for free(); NULL when memory is out. */
static unsigned char *support_of_angles(const ttc_model *model, const unsigned char *support)
{
    id_list list = { NULL, 0, false };
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_COSINE && support[i]) add_id(&list, model->symbols[i].definition);
    unsigned char *turned = list.failed ? NULL : ttc_model_support(model, list.ids, list.count);
    free(list.ids);
    return turned;
}

/* Returns true if an angle depends on a state on which angles in use depend: these may be multiples of it. */
static bool turns_with(const ttc_model *model, uint32_t cosine, const unsigned char *turned)
{
    bool turns = false;
    for (size_t i = 0; !turns && i < model->state_count; i++)
        turns = turned[model->states[i]] && ttc_model_depends(model, model->symbols[cosine].definition, model->states[i]);
    return turns;
}

void ttc_domain_add(ttc_task *task, ttc_conditions *c, ttc_domain_extent extent)
{
    const ttc_model *model = task->model;
    const bool parameters_alone = is_of_parameters(task);
    const bool leads_elsewhere = task->claim->target != NULL || task->outer != NULL;
    unsigned char *support = ttc_domain_support(task, extent);
    unsigned char *turned = support == NULL ? NULL : support_of_angles(model, support);
    ttc_ratio value, end;
    if (turned == NULL) {
        free(support);
        ttc_ring_fail(task->ring, TTC_RING_NO_MEMORY);
        return;
    }
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &end);
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if (ttc_question_is_tested(task, i) || (parameters_alone && entry->kind != TTC_PARAM)) continue;
        if (entry->kind == TTC_STATE) add_state(task, c, entry, &value, &end);
        if (entry->kind == TTC_PARAM && entry->sign != TTC_ANY_SIGN && ttc_valuation_is_bound(task->field, i)) {
            ttc_evaluate(task->field, &value, entry->node);
            add(task, c, &value, ttc_domain_relation(entry->sign),
                "%s lies outside its domain under the conditions of this claim",
                entry->name);
        }
        if (entry->kind == TTC_ROOT || entry->kind == TTC_LOG) add_root(task, c, i, &value);
        /* Evaluating the sine adjoins the root of 1 - C^2, which is real only if a bound cosine C lies between -1 and 1. */
        if (entry->kind == TTC_COSINE && ttc_valuation_is_bound(task->field, i))
            ttc_evaluate(task->field, &value, model->symbols[entry->partner].node);
        if (entry->kind == TTC_COSINE && support[i]) ttc_domain_add_angle(task, c, i);
        if (entry->kind == TTC_COSINE && !support[i] && (leads_elsewhere || turns_with(model, i, turned)))
            add_unused_angle(task, c, i);
    }
    for (size_t i = 0; i < model->region_count; i++) {
        if (parameters_alone && depends_on_states(model, model->regions[i].expression)) continue;
        ttc_id region = model->regions[i].expression;
        bool is_in_question = ttc_question_depends(task, region) &&
                              (task->tested_root != 0 || extent == TTC_DOMAIN_OF_OTHERS || !depends_on_states(model, region));
        if (is_in_question || ttc_question_uses_root(task, region)) {
            task->has_left_out |= task->tested_root == 0 ? !parameters_alone
                                                         : !ttc_model_depends(model, region, task->tested_root);
            continue;
        }
        ttc_evaluate(task->field, &value, model->regions[i].expression);
        add(task, c, &value, TTC_IS_POSITIVE, "the domain record %s excludes what the conditions of this claim say",
            model->regions[i].name);
    }
    for (size_t i = 0; i < model->divisor_count; i++)
        if (divisor_counts(task, &model->divisors[i], support, extent))
            add_divisor(task, c, model->divisors[i].divisor, extent, &value);
    if (task->divisor != TTC_NONE && extent != TTC_DOMAIN_WITHOUT_CLAIM) add_divisor(task, c, task->divisor, extent, &value);
    ttc_ratio_clear(task->ring, &end);
    ttc_ratio_clear(task->ring, &value);
    free(turned);
    free(support);
}

bool ttc_domain_speaks_of_tested(const ttc_task *task)
{
    bool speaks = false;
    for (size_t i = 0; !speaks && i < task->model->region_count; i++)
        speaks = ttc_question_depends(task, task->model->regions[i].expression);
    return speaks;
}

bool ttc_domain_divides_by_tested(const ttc_task *task)
{
    bool divides = false;
    for (size_t i = 0; !divides && i < task->model->divisor_count; i++)
        divides = ttc_question_depends(task, task->model->divisors[i].divisor);
    return divides;
}

void ttc_domain_require_divisors(ttc_task *task, ttc_valuation *map, ttc_divisor_role role, uint32_t owner,
                                 const unsigned char *used, const char *where)
{
    const ttc_model *model = ttc_valuation_model(map);
    for (size_t i = 0; i < model->divisor_count && ttc_task_open(task); i++) {
        uint32_t root;
        const ttc_divisor *d = &model->divisors[i];
        const bool counts = (d->role == role && d->owner == owner) ||
                            (d->role == TTC_DIVIDES_SYMBOL && used[d->owner]);
        if (!counts || is_root(model, d->divisor, &root)) continue;
        ttc_signs_require(task, map, d->divisor, TTC_IS_NONZERO, "a denominator vanishes%s", where);
    }
}

void ttc_domain_require_field(ttc_task *task)
{
    const ttc_model *model = task->model;
    unsigned char *support = ttc_domain_support(task, TTC_DOMAIN_WITHOUT_CLAIM);
    ttc_ratio value;
    if (support == NULL) ttc_ring_fail(task->ring, TTC_RING_NO_MEMORY);
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; support != NULL && i < model->divisor_count && ttc_task_open(task); i++) {
        const ttc_divisor *d = &model->divisors[i];
        const bool counts =
            d->role == TTC_DIVIDES_FIELD || (d->role == TTC_DIVIDES_SYMBOL && support[d->owner]);
        if (!counts || !ttc_question_depends(task, d->divisor) || ttc_question_uses_root(task, d->divisor)) continue;
        ttc_evaluate(task->field, &value, d->divisor);
        const bool zero = ttc_task_open(task) && ttc_ratio_is_zero(task->ring, &value);
        if (ttc_task_open(task) && zero && ttc_task_may_have_point(task))
            ttc_task_unsettle(task, "with these values a denominator of the field vanishes on a whole part of the domain");
    }
    ttc_ratio_clear(task->ring, &value);
    free(support);
}
