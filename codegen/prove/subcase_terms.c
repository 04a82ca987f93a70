/* Splits levels that are zero only where all their terms, or the even powers of which they are sums, are zero; and replaces levels
 * by others with the same zeros. */
#include "prove/signs.h"
#include "prove/subcase.h"

static bool counts_points(const ttc_task *task)
{
    const ttc_claim_kind kind = task->claim->kind;
    return task->is_lower || kind == TTC_CLAIM_EQUAL || kind == TTC_CLAIM_POSITIVE || kind == TTC_CLAIM_RATE ||
           kind == TTC_CLAIM_INTEGRAL || kind == TTC_CLAIM_INVARIANT;
}

/* The real points of the level may be too few for their component: its leaves are shown to be kept one by one. They are parts of
 * the level like any other, on which a claim may not divide by zero. */
bool ttc_subcase_split(ttc_subcase *b, ttc_task *task, ttc_id sum)
{
    const ttc_graph *graph = task->model->graph;
    if (sum == TTC_NONE || !counts_points(task) || !ttc_signs_are_one(task, sum)) return false;
    const size_t terms = ttc_part_count(graph, sum);
    if (b->goal_count + terms > sizeof b->goals / sizeof *b->goals) return false;
    for (size_t i = 0; i < terms; i++) b->goals[b->goal_count++] = ttc_part_at(graph, sum, i).id;
    b->terms_added += terms - 1;
    return true;
}

/* The factor as the table writes it in the goal: the whole goal if it has no other factor, else a factor of it with the same zeros;
 * TTC_NONE: there is none. */
static ttc_id as_written(ttc_task *task, ttc_id goal, const fmpz_mpoly_t factor, bool is_alone)
{
    const ttc_graph *graph = task->model->graph;
    ttc_id written = TTC_NONE;
    ttc_ratio value;
    fmpz_mpoly_t multiple;
    goal = ttc_model_without_lets(task->model, goal);
    if (ttc_kind_of(graph, goal) != TTC_PRODUCT) return is_alone ? goal : TTC_NONE;
    ttc_ratio_init(task->ring, &value);
    fmpz_mpoly_init(multiple, task->ring->context);
    for (size_t i = 0; i < ttc_part_count(graph, goal) && written == TTC_NONE; i++) {
        const ttc_id part = ttc_model_without_lets(task->model, ttc_part_at(graph, goal, i).id);
        ttc_evaluate(task->field, &value, part);
        if (fmpz_mpoly_divides(multiple, value.numerator, factor, task->ring->context) &&
            fmpz_mpoly_is_fmpz(multiple, task->ring->context))
            written = part;
    }
    fmpz_mpoly_clear(multiple, task->ring->context);
    ttc_ratio_clear(task->ring, &value);
    return written;
}

/* Complete a power: p = a v^d + b v^(d-1) + ... in a variable v, where d is even, and a is of one sign and not zero. Then
 * (d!)^d a^(d-1) p = root^d - rest with root = (d-1)! (d a v + b). This serves if rest is free of v, as it always is for d = 2.
 * Returns the sign of a; 0: no v serves. */
static unsigned complete_power(const ttc_task *task, const fmpz_mpoly_t p, fmpz_mpoly_t root, fmpz_mpoly_t rest)
{
    enum { GREATEST = 8, LONGEST = 12 };
    const fmpz_mpoly_ctx_struct *context = task->ring->context;
    unsigned sign = 0;
    fmpz_mpoly_t lead;
    fmpz_mpoly_init(lead, context);
    for (slong v = 0; v < (slong)task->ring->variable_count && sign == 0; v++) {
        const slong d = fmpz_mpoly_degree_si(p, v, context);
        const ulong exponent = (ulong)d;
        if (d < 2 || d > GREATEST || d % 2 != 0 || ttc_ring_generator(task->ring, v) != NULL) continue;
        fmpz_mpoly_get_coeff_vars_ui(lead, p, &v, &exponent, 1, context);
        const unsigned signs = ttc_conditions_signs(&task->domain, lead);
        if (signs != TTC_CAN_BE_POSITIVE && signs != TTC_CAN_BE_NEGATIVE) continue;
        fmpz_mpoly_set(root, p, context);
        for (slong k = 1; k < d; k++) fmpz_mpoly_derivative(root, root, v, context);
        if (d > 2 && fmpz_mpoly_length(root, context) > LONGEST) continue;
        fmpz_mpoly_pow_ui(rest, root, exponent, context);
        fmpz_mpoly_pow_ui(lead, lead, exponent - 1, context);
        fmpz_mpoly_mul(lead, lead, p, context);
        for (slong k = 0; k < d * d; k++) fmpz_mpoly_scalar_mul_si(lead, lead, 1 + k % d, context);
        fmpz_mpoly_sub(rest, rest, lead, context);
        if (fmpz_mpoly_degree_si(rest, v, context) < 1) sign = signs;
    }
    fmpz_mpoly_clear(lead, context);
    return sign;
}

/* Returns true if a polynomial is nowhere of this sign, by the signs of its factors and by even powers. */
static bool is_never(const ttc_task *task, const fmpz_mpoly_t p, unsigned sign)
{
    ttc_ratio whole;
    fmpz_mpoly_t root, rest;
    ttc_ratio_init(task->ring, &whole);
    ttc_ratio_set_polynomial(task->ring, &whole, p);
    bool never = !(ttc_conditions_signs_of_ratio(&task->domain, &whole) & sign);
    ttc_ratio_clear(task->ring, &whole);
    if (never) return true;
    fmpz_mpoly_init(root, task->ring->context);
    fmpz_mpoly_init(rest, task->ring->context);
    const unsigned other = complete_power(task, p, root, rest);
    never = other != 0 && other != sign && is_never(task, rest, TTC_CAN_BE_POSITIVE);
    fmpz_mpoly_clear(rest, task->ring->context);
    fmpz_mpoly_clear(root, task->ring->context);
    return never;
}

/* Add as goals a root and a rest that is never positive; an even power of the root less the rest is a multiple of the factor. */
static bool split_powers(ttc_subcase *b, ttc_task *task, const fmpz_mpoly_t factor)
{
    fmpz_mpoly_t root, rest;
    fmpz_mpoly_init(root, task->ring->context);
    fmpz_mpoly_init(rest, task->ring->context);
    bool splits = counts_points(task) && b->goal_count + 2 <= sizeof b->goals / sizeof *b->goals &&
                  complete_power(task, factor, root, rest) != 0 && is_never(task, rest, TTC_CAN_BE_POSITIVE);
    const ttc_id first = splits ? ttc_subcase_expression(task, root) : TTC_NONE;
    const ttc_id second = splits ? ttc_subcase_expression(task, rest) : TTC_NONE;
    splits = first != TTC_NONE && second != TTC_NONE;
    if (splits) b->goals[b->goal_count++] = first;
    if (splits) b->goals[b->goal_count++] = second;
    b->terms_added += splits;
    fmpz_mpoly_clear(rest, task->ring->context);
    fmpz_mpoly_clear(root, task->ring->context);
    return splits;
}

bool ttc_subcase_split_factor(ttc_subcase *b, ttc_task *task, const fmpz_mpoly_t factor, bool is_alone)
{
    /* is_orphan is known for solved levels only, whose leaves have the dimensions of complex ones; split levels may have less. */
    if (b->is_degenerate && !b->is_orphan && task->claim->kind == TTC_CLAIM_INVARIANT) return false;
    return ttc_subcase_split(b, task, as_written(task, b->goals[b->goal_count - 1], factor, is_alone)) ||
           ttc_subcase_split(b, task, ttc_subcase_expression(task, factor)) || split_powers(b, task, factor);
}

bool ttc_subcase_add_turns(ttc_subcase *b, ttc_task *task, ttc_id expression)
{
    enum { MOST = 3 };
    const ttc_model *model = task->model;
    const size_t before = b->goal_count, room = sizeof b->goals / sizeof *b->goals;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *cosine = &model->symbols[i];
        if (cosine->kind != TTC_COSINE) continue;
        if (!ttc_model_depends(model, expression, i) && !ttc_model_depends(model, expression, cosine->partner)) continue;
        if (b->goal_count == room || b->goal_count - before == MOST) return false;
        b->goals[b->goal_count++] = ttc_multiply(model->graph, cosine->node, model->symbols[cosine->partner].node);
    }
    return b->goal_count > before;
}

/* The exponent e if the sum is a number times exp(e) - 1, which is zero where e is; else TTC_NONE. */
static ttc_id exponent_of(const ttc_model *model, ttc_id sum)
{
    const ttc_graph *graph = model->graph;
    if (ttc_kind_of(graph, sum) != TTC_SUM || ttc_part_count(graph, sum) != 1) return TTC_NONE;
    const ttc_part part = ttc_part_at(graph, sum, 0);
    fmpq_t value;
    fmpq_init(value);
    fmpq_add(value, ttc_coefficient(graph, sum), part.coefficient);
    const bool is_one = fmpq_is_zero(value) && ttc_kind_of(graph, part.id) == TTC_SYMBOL;
    fmpq_clear(value);
    const ttc_symbol_entry *entry = is_one ? model->symbols + ttc_symbol_of(graph, part.id) : NULL;
    return entry != NULL && entry->kind == TTC_EXP ? entry->definition : TTC_NONE;
}

ttc_id ttc_subcase_without_functions(const ttc_model *model, ttc_id level)
{
    ttc_graph *graph = model->graph;
    const ttc_id expanded = ttc_model_expand(model, level);
    if (expanded != TTC_NONE) level = expanded; /* within limits */
    const ttc_kind kind = ttc_kind_of(graph, level);
    const ttc_id exponent = exponent_of(model, level);
    if (exponent != TTC_NONE) return ttc_subcase_without_functions(model, exponent);
    if (kind == TTC_SYMBOL && model->symbols[ttc_symbol_of(graph, level)].kind == TTC_LOG) {
        const ttc_id argument = model->symbols[ttc_symbol_of(graph, level)].definition;
        return ttc_subcase_without_functions(model, ttc_subtract(graph, argument, ttc_integer(graph, 1)));
    }
    if (kind != TTC_PRODUCT) return level;
    ttc_id product = ttc_number(graph, ttc_coefficient(graph, level));
    for (size_t i = 0; i < ttc_part_count(graph, level); i++) {
        const ttc_part part = ttc_part_at(graph, level, i);
        const ttc_id base = part.exponent > 0 ? ttc_subcase_without_functions(model, part.id) : part.id;
        product = ttc_multiply(graph, product, ttc_power(graph, base, part.exponent));
    }
    return product == TTC_NONE ? level : product; /* it exceeds a limit */
}
