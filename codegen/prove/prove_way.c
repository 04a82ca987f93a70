/* Provers of ways to tables that serve in place of the model B.
 *
 * A smaller table S has an embedding into B. In the ring of S: every point is embedded into B's domain, with the rates of
 * B's equations, and both tables observe the same; and where the conditions of the way hold, it leads back to the point. In
 * the ring of B, where these conditions hold: the way leads into S's domain, and the image is embedded as the point itself.
 * So the orbit of S from the image is the orbit of B.
 *
 * A larger table T has a reduction onto B. In the ring of B, where the conditions of the way hold: it leads into T's domain
 * and onto the zero levels that the reduction takes, and the reduction leads back to the point. */
#include "prove/domain.h"
#include "prove/prove_image.h"
#include "prove/way_table.h"

#include <stdlib.h>
#include <string.h>

/* Add the conditions of `where`, and that it divides by nothing that is zero, as it is written. */
static void add_where(ttc_task *task, ttc_valuation *valuation, const ttc_way *way)
{
    const ttc_model *model = ttc_valuation_model(valuation);
    unsigned char *used = ttc_model_uses_between(model, TTC_DIVIDES_CLAIM, way->claim, way->where_uses, SIZE_MAX);
    size_t own = 0;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    if (used == NULL) ttc_task_unsettle(task, "out of memory");
    for (size_t i = 0; i < model->divisor_count && ttc_task_open(task); i++) {
        const ttc_divisor *d = model->divisors + i;
        const bool is_own = d->role == TTC_DIVIDES_CLAIM && d->owner == way->claim && own++ >= way->where_divisors;
        if (!is_own && (d->role != TTC_DIVIDES_SYMBOL || !used[d->owner])) continue;
        ttc_evaluate(valuation, &value, d->divisor);
        ttc_conditions_add(&task->domain, &value, TTC_IS_NONZERO);
    }
    for (size_t i = 0; i < way->where.count && ttc_task_open(task); i++) {
        ttc_evaluate(valuation, &value, way->where.items[i].expression);
        ttc_conditions_add(&task->domain, &value, TTC_IS_POSITIVE);
    }
    ttc_ratio_clear(task->ring, &value);
    free(used);
}

/* ---- in the smaller table ---- */

static const ttc_claim *embedding_of(const ttc_task *task) { return task->model->claims + task->claim->family; }

/* S's parameter that is B's parameter of the same name, as the way gives it no other value; else UINT32_MAX. */
static uint32_t shared_param(const ttc_model *table, const ttc_image *image, const char *name)
{
    bool given = ttc_image_name(image, name) < image->count;
    for (size_t i = 0; i < image->level_count; i++) given |= strcmp(image->levels[i], name) == 0;
    return given ? UINT32_MAX : ttc_param_of(table, name);
}

/* Returns true if the embedding gives a parameter of B by more than a number, so that S determines it. */
static bool is_told(const ttc_model *table, ttc_id given)
{
    return given != TTC_NONE && ttc_kind_of(table->graph, given) != TTC_NUMBER;
}

/* A parameter of B in terms of S: the shared parameter; else what the embedding gives, if more than a number; else, if the
 * embedding gives nothing, S's parameter of that name, whatever the way gives. TTC_NONE: S does not determine it. */
static ttc_id known_param(const ttc_model *table, const ttc_claim *back, const ttc_image *image, const char *name)
{
    const uint32_t shared = shared_param(table, image, name), named = ttc_param_of(table, name);
    const ttc_id given = ttc_given_for(back, name);
    if (shared != UINT32_MAX) return table->symbols[shared].node;
    if (is_told(table, given)) return given;
    return given == TTC_NONE && named != UINT32_MAX ? table->symbols[named].node : TTC_NONE;
}

typedef struct {
    const ttc_model *table, *model;
    const ttc_claim *back;
    const ttc_image *image;
} translation;

static ttc_id translated_symbol(const translation *t, uint32_t symbol)
{
    const ttc_symbol_entry *entry = t->model->symbols + symbol;
    return entry->kind == TTC_PARAM ? known_param(t->table, t->back, t->image, entry->name) : TTC_NONE;
}

/* An expression of B as one of S; TTC_NONE if it uses more than parameters that S determines. */
static ttc_id translate(const translation *t, ttc_id id)
{
    const ttc_graph *from = t->model->graph;
    ttc_graph *to = t->table->graph;
    const ttc_kind kind = ttc_kind_of(from, id);
    if (kind == TTC_SYMBOL) return translated_symbol(t, ttc_symbol_of(from, id));
    ttc_id value = ttc_number(to, ttc_coefficient(from, id));
    for (size_t i = 0; value != TTC_NONE && i < ttc_part_count(from, id); i++) {
        const ttc_part part = ttc_part_at(from, id, i);
        const ttc_id translated = translate(t, part.id);
        if (translated == TTC_NONE) return TTC_NONE;
        value = kind == TTC_SUM ? ttc_add(to, value, ttc_scale(to, translated, part.coefficient))
                                : ttc_multiply(to, value, ttc_power(to, translated, part.exponent));
    }
    return value;
}

static ttc_id in_table(const ttc_model *table, const ttc_claim *back, const ttc_task *outer, ttc_id id)
{
    const translation t = { table, outer->model, back, &ttc_way_of(outer->model, outer->claim)->image };
    const ttc_id expanded = ttc_model_expand(outer->model, id);
    return expanded == TTC_NONE ? TTC_NONE : translate(&t, expanded);
}

static const ttc_binding *condition_on(const ttc_claim *claim, uint32_t symbol)
{
    for (size_t i = 0; i < claim->when.count; i++)
        if (claim->when.items[i].symbol == symbol) return claim->when.items + i;
    return NULL;
}

/* Bind a parameter of B that nothing determines to a spare symbol, with any value that B's sign condition allows. */
static void bind_free(ttc_task *task, ttc_valuation *map, uint32_t symbol, uint32_t *spares)
{
    const ttc_symbol_entry *entry = ttc_valuation_model(map)->symbols + symbol;
    ttc_ratio value;
    uint32_t spare;
    if (!ttc_prove_take_spare(&spare, task, spares)) {
        ttc_task_unsettle(task, "more than %d parameters of %s are not known in %s", TTC_SPARE_SYMBOLS,
                          task->outer->model->name, task->model->name);
        return;
    }
    const ttc_id name = ttc_symbol(task->model->graph, spare);
    ttc_valuation_name(task->field, spare, entry->name);
    ttc_valuation_bind(map, symbol, name);
    if (entry->sign == TTC_ANY_SIGN) return;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, name);
    ttc_conditions_add(&task->domain, &value, ttc_domain_relation(entry->sign));
    ttc_ratio_clear(task->ring, &value);
}

/* Bind a parameter of B, in the ring of S: to what S determines, which meets the way's `when` at the points in question (see
 * set_levels); else to the value of `when`; else to any value. */
static void bind_parameter(ttc_task *task, ttc_valuation *map, uint32_t symbol, uint32_t *spares)
{
    const ttc_model *table = task->model;
    const ttc_claim *back = embedding_of(task);
    const ttc_symbol_entry *entry = ttc_valuation_model(map)->symbols + symbol;
    const ttc_binding *condition = condition_on(task->outer->claim, symbol);
    const ttc_id known = known_param(table, back, &ttc_way_of(task->outer->model, task->outer->claim)->image, entry->name);
    const ttc_id value = condition == NULL ? TTC_NONE : in_table(table, back, task->outer, condition->expression);
    if (condition != NULL && value == TTC_NONE)
        ttc_task_unsettle(task, "what the condition says of %s is not known in %s", entry->name, table->name);
    else if (known != TTC_NONE) {
        ttc_valuation_bind(map, symbol, known);
        ttc_prove_constant(task, entry->name, known);
    } else if (condition != NULL) ttc_valuation_bind(map, symbol, value);
    else bind_free(task, map, symbol, spares);
}

static void bind_embedded(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = ttc_valuation_model(map);
    uint32_t spares = 0;
    for (uint32_t i = 0; i < model->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const ttc_id given = ttc_given_for(embedding_of(task), entry->name);
        if (entry->kind == TTC_PARAM) bind_parameter(task, map, i, &spares);
        else if (given != TTC_NONE && (entry->kind == TTC_STATE || entry->kind == TTC_ROOT)) ttc_valuation_bind(map, i, given);
    }
}

/* Require that at the embedded point, where the way's conditions hold, it gives S's own states and parameters. */
static void require_return(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *table = task->model, *model = task->outer->model;
    const ttc_claim *claim = task->outer->claim;
    const ttc_way *way = ttc_way_of(task->outer->model, task->outer->claim);
    add_where(task, map, way);
    ttc_prove_divisors(task, map, way->claim, way->where_uses, " in the way back from the embedding");
    for (size_t i = 0; i < way->image.level_count && ttc_task_open(task); i++)
        ttc_prove_divisors(task, map, claim->members[i], SIZE_MAX, " in a level on the way back from the embedding");
    for (size_t i = 0; i < table->state_count && ttc_task_open(task); i++)
        ttc_prove_return(task, map, claim, &way->image, i, true);
    for (size_t i = 0; i < table->param_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = table->symbols + table->params[i];
        bool is_root;
        const ttc_id value = ttc_image_param(model, claim, &way->image, table, i, &is_root);
        const ttc_id own = is_root ? ttc_power(table->graph, entry->node, 2) : entry->node;
        ttc_ratio root;
        ttc_task_require_equal(task, map, value, task->field, own, "the way back from the embedding leads elsewhere, in %s",
                               entry->name);
        if (!is_root) continue;
        ttc_ratio_init(task->ring, &root);
        ttc_evaluate(task->field, &root, entry->node);
        ttc_task_require(task, &root, TTC_IS_NONNEGATIVE, "negative, and no root: %s", entry->name);
        ttc_ratio_clear(task->ring, &root);
    }
}

static void prove_embedded(ttc_task *task)
{
    ttc_prove_divisors(task, task->field, task->claim->family, SIZE_MAX, " in the embedding");
    ttc_valuation *map = ttc_task_enter_map(task, task->outer->model, task->field);
    if (map == NULL) return;
    bind_embedded(task, map);
    if (ttc_task_open(task)) ttc_domain_require_image(task, map, " of the embedding");
    ttc_domain_require_roots(task, map);
    ttc_prove_chain_rule(task, embedding_of(task), map);
    ttc_prove_same_observations(task, map);
    if (ttc_task_open(task)) require_return(task, map);
    ttc_task_leave_map(task);
}

/* Expressions that are zero at the points of S in question: those that meet `when` of the way, as far as it is on parameters that
 * S determines. Returns false when memory is out. */
static bool set_levels(const ttc_task *task, const ttc_model *table, const ttc_claim *back, ttc_id *levels, size_t *count)
{
    const ttc_bindings *when = &task->claim->when;
    for (size_t i = 0; i < when->count; i++) {
        const char *name = task->model->symbols[when->items[i].symbol].name;
        const ttc_id known = known_param(table, back, &ttc_way_of(task->model, task->claim)->image, name);
        const ttc_id value = in_table(table, back, task, when->items[i].expression);
        if (known == TTC_NONE || value == TTC_NONE) continue;
        levels[*count] = ttc_subtract(table->graph, known, value);
        if (levels[(*count)++] == TTC_NONE) return false;
    }
    return true;
}

static void look_at_table(ttc_task *task, const ttc_model *table, uint32_t back)
{
    /* Its expressions are left out of the claim, as it is to be shown that their divisors do not vanish. */
    const ttc_claim embedded = { .kind = TTC_CLAIM_EQUAL, .name = task->claim->name, .place = table->claims[back].place,
                                 .family = back };
    ttc_id *levels = calloc(task->claim->when.count + 1, sizeof *levels);
    ttc_task inner = { .model = table, .claim = &embedded, .role = TTC_DIVIDES_FIELD, .outer = task, .levels = levels };
    if (levels == NULL || !set_levels(task, table, table->claims + back, levels, &inner.level_count)) {
        ttc_task_unsettle(task, "out of memory");
    } else {
        ttc_task_run(&inner, prove_embedded);
        if (inner.status == TTC_REFUTED) task->note = ttc_way_untold(task->model, task->claim, table, table->claims + back);
        ttc_task_adopt(task, &inner);
    }
    free(levels);
}

/* ---- in the model ---- */

/* Require that the way's image leads back to the point itself: in states, roots, and parameters that the claim back determines,
 * also by equal names; a reduction gives parameters as numbers, too. */
static void require_same(ttc_task *task, ttc_valuation *map, const ttc_claim *back)
{
    const ttc_model *model = task->model, *table = ttc_valuation_model(map);
    const bool reduces = back->kind == TTC_CLAIM_REDUCTION;
    for (uint32_t i = 0; i < model->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const uint32_t theirs = ttc_param_of(table, entry->name);
        ttc_id given = ttc_given_for(back, entry->name);
        if (given == TTC_NONE && entry->kind == TTC_PARAM && theirs != UINT32_MAX) given = table->symbols[theirs].node;
        const bool counts = entry->kind == TTC_STATE || entry->kind == TTC_ROOT ||
                            (entry->kind == TTC_PARAM && (reduces || is_told(table, given)));
        if (given != TTC_NONE && counts)
            ttc_task_require_equal(task, map, given, task->field, entry->node, "where the way leads is elsewhere, in %s",
                                   entry->name);
    }
}

/* Require that what the way gives for S's parameters is constant. This follows from the rest, but makes the clearest refutation. */
static void require_constants(ttc_task *task, const ttc_model *table, const ttc_way *way)
{
    for (size_t i = 0; i < table->param_count && ttc_task_open(task); i++) {
        bool is_root;
        const ttc_id value = ttc_image_param(task->model, task->claim, &way->image, table, i, &is_root);
        char name[TTC_DIAGNOSTIC_LINE];
        snprintf(name, sizeof name, is_root ? "(%s^2)" : "%s", table->symbols[table->params[i]].name);
        ttc_prove_constant(task, name, value);
    }
}

static void prove_descended(ttc_task *task, const ttc_model *table, const ttc_claim *back)
{
    ttc_valuation *map = ttc_task_enter_map(task, table, task->field);
    if (map == NULL) return;
    ttc_prove_bind_image(task, map, task->claim, &ttc_way_of(task->model, task->claim)->image);
    if (ttc_task_open(task)) ttc_domain_require_image(task, map, " where the way leads");
    require_same(task, map, back);
    ttc_task_leave_map(task);
}

void ttc_prove_descent(ttc_task *task)
{
    const ttc_way *way = ttc_way_of(task->model, task->claim);
    char reason[TTC_DIAGNOSTIC_LINE + 200];
    uint32_t back;
    ttc_model *table = ttc_way_table(task->model, way, task->resolver, task->resolver_context, &back, reason, sizeof reason);
    if (table == NULL) {
        ttc_task_unsettle(task, "%s", reason);
        return;
    }
    add_where(task, task->field, way);
    require_constants(task, table, way);
    if (ttc_task_open(task) && !task->is_lifted) look_at_table(task, table, back);
    task->is_lifted |= ttc_task_open(task);
    if (ttc_task_open(task)) prove_descended(task, table, table->claims + back);
    ttc_model_destroy(table);
}

/* Require that the lift meets the conditions of the reduction, and lies on the zero levels that it takes. */
static void require_reduction(ttc_task *task, ttc_valuation *map, const ttc_claim *back)
{
    const ttc_model *table = ttc_valuation_model(map);
    const ttc_id zero = ttc_integer(table->graph, 0);
    for (size_t i = 0; i < back->when.count && ttc_task_open(task); i++)
        ttc_task_require_equal(task, map, table->symbols[back->when.items[i].symbol].node, map, back->when.items[i].expression,
                               "the lift does not meet the condition of its reduction on %s",
                               table->symbols[back->when.items[i].symbol].name);
    for (size_t i = 0; i < back->modulo_count && ttc_task_open(task); i++) {
        ttc_prove_divisors(task, map, back->modulo[i], SIZE_MAX, " in a zero level of the reduction of the lift");
        ttc_task_require_equal(task, map, table->claims[back->modulo[i]].expression, map, zero,
                               "the lift is off the zero level of %s", table->claims[back->modulo[i]].name);
    }
}

static void prove_lifted(ttc_task *task, const ttc_model *table, uint32_t back)
{
    const ttc_way *way = ttc_way_of(task->model, task->claim);
    add_where(task, task->field, way);
    ttc_valuation *map = ttc_task_enter_map(task, table, task->field);
    if (map == NULL) return;
    ttc_prove_bind_image(task, map, task->claim, &way->image);
    for (size_t k = 0; k < way->image.count; k++) {
        uint32_t root;
        if (ttc_model_find_symbol(table, way->image.names[k], &root) && table->symbols[root].kind == TTC_ROOT)
            ttc_valuation_bind(map, root, task->claim->entries[2 * k]);
    }
    if (ttc_task_open(task)) ttc_domain_require_image(task, map, " of the lift");
    ttc_domain_require_roots(task, map);
    ttc_prove_divisors(task, map, back, SIZE_MAX, " in the reduction of the lift");
    if (ttc_task_open(task)) require_reduction(task, map, table->claims + back);
    require_same(task, map, table->claims + back);
    ttc_task_leave_map(task);
}

void ttc_prove_lift(ttc_task *task)
{
    char reason[TTC_DIAGNOSTIC_LINE + 200];
    const ttc_way *way = ttc_way_of(task->model, task->claim);
    uint32_t back;
    ttc_model *table = ttc_way_table(task->model, way, task->resolver, task->resolver_context, &back, reason, sizeof reason);
    if (table == NULL) ttc_task_unsettle(task, "%s", reason);
    else prove_lifted(task, table, back);
    ttc_model_destroy(table);
}
