/* A pole: at both ends of the state's interval a lifted root is zero, and orbits do not run through. In each time that lifts
 * such a root the rates of the root and of the state are ratios N/D; with way, the distance of the state from the end, and the
 * roots that vanish there no more slowly than those lifted, N lies in the ideal of these, and D is not zero for parameters in
 * general. So the rates are bounded by multiples of way and the root, which where they are zero stay so, and orbits of the lifted
 * field come to the end only as its time goes to infinity. */
#include "prove/prove_task.h"

typedef struct {
    ttc_task *task;
    uint32_t state;
    bool is_high;
    slong variable;                      /* of the state */
    fmpz_mpoly_t way;                    /* linear in the state, positive inside */
    bool vanishes[TTC_GENERATOR_LIMIT];  /* roots that are zero at the end */
} pole_end;

typedef enum { GOES_TO_ZERO, GOES_ELSEWHERE, IS_NOT_FOLLOWED } limit;

static const fmpz_mpoly_ctx_struct *context_of(const pole_end *end) { return end->task->ring->context; }

static const char *side_of(const pole_end *end) { return end->is_high ? "upper" : "lower"; }

/* These roots, of those that vanish, are put to zero. */
static void drop(const pole_end *end, fmpz_mpoly_t out, const fmpz_mpoly_t polynomial, const bool *roots)
{
    const ttc_ring *ring = end->task->ring;
    fmpz_t zero;
    fmpz_init(zero);
    fmpz_mpoly_set(out, polynomial, ring->context);
    for (size_t i = 0; i < ring->generator_count; i++)
        if (roots[i]) fmpz_mpoly_evaluate_one_fmpz(out, out, ring->generators[i].variable, zero, ring->context);
    fmpz_clear(zero);
}

static bool has_factor(const pole_end *end, const fmpz_mpoly_t polynomial)
{
    fmpz_mpoly_t quotient;
    fmpz_mpoly_init(quotient, context_of(end));
    const bool has = fmpz_mpoly_divides(quotient, polynomial, end->way, context_of(end));
    fmpz_mpoly_clear(quotient, context_of(end));
    return has;
}

/* out = the polynomial, without roots that vanish, with the state at its end. Its resultant with way = b x + c is (-b)^degree
 * times that. */
static void put_state(const pole_end *end, ttc_ratio *out, const fmpz_mpoly_t polynomial)
{
    ttc_ring *ring = end->task->ring;
    fmpz_mpoly_t value, slope;
    ttc_ratio scale;
    fmpz_mpoly_init(value, ring->context);
    fmpz_mpoly_init(slope, ring->context);
    ttc_ratio_init(ring, &scale);
    fmpz_mpoly_derivative(slope, end->way, end->variable, ring->context);
    fmpz_mpoly_neg(slope, slope, ring->context);
    const slong degree = fmpz_mpoly_degree_si(polynomial, end->variable, ring->context);
    if (fmpz_mpoly_resultant(value, polynomial, end->way, end->variable, ring->context)) {
        ttc_ratio_set_polynomial(ring, out, value);
        ttc_ratio_set_polynomial(ring, &scale, slope);
        ttc_ratio_power(ring, &scale, &scale, degree > 0 ? degree : 0);
        ttc_ratio_divide(ring, out, out, &scale);
    } else {
        ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
    }
    ttc_ratio_clear(ring, &scale);
    fmpz_mpoly_clear(slope, ring->context);
    fmpz_mpoly_clear(value, ring->context);
}

/* With the state at its end: by the signs of its terms, or for parameters in general. */
static bool is_nonzero(const pole_end *end, const fmpz_mpoly_t polynomial)
{
    const ttc_task *task = end->task;
    const ttc_model *model = task->model;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    put_state(end, &value, polynomial);
    bool is_constant = !fmpz_mpoly_is_zero(value.numerator, task->ring->context);
    for (slong v = 0; is_constant && v < (slong)task->ring->variable_count; v++) {
        const size_t symbol = ttc_valuation_symbol(task->field, v);
        const bool is_param = symbol < model->symbol_count && model->symbols[symbol].kind == TTC_PARAM;
        is_constant = is_param || !ttc_ratio_uses(task->ring, &value, v);
    }
    const bool nonzero = is_constant || !(ttc_conditions_signs(&task->domain, value.numerator) & TTC_CAN_BE_ZERO);
    ttc_ratio_clear(task->ring, &value);
    return nonzero;
}

/* Whether what a polynomial is made of can be followed to the end: of functions of the state the values there are not looked
 * for, and what divides under other roots must not become zero. is_apart: moreover no other root changes with the state. */
static bool is_followed(const pole_end *end, const fmpz_mpoly_t polynomial, bool is_apart)
{
    const ttc_model *model = end->task->model;
    const ttc_ring *ring = end->task->ring;
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        if (fmpz_mpoly_degree_si(polynomial, v, ring->context) < 1) continue;
        const size_t symbol = ttc_valuation_symbol(end->task->field, v);
        if (symbol < model->symbol_count && model->symbols[symbol].kind != TTC_ROOT &&
            ttc_symbol_is_function(model->symbols[symbol].kind) &&
            ttc_model_depends(model, model->symbols[symbol].definition, end->state)) return false;
        for (size_t i = 0; i < ring->generator_count; i++) {
            const ttc_ratio *square = &ring->generators[i].square;
            if (ring->generators[i].variable != v || end->vanishes[i]) continue;
            if (is_apart && ttc_ratio_uses(ring, square, end->variable)) return false;
            if (!is_nonzero(end, square->denominator) || !is_followed(end, square->numerator, is_apart)) return false;
        }
    }
    return true;
}

static void find_vanishing(pole_end *end)
{
    const ttc_ring *ring = end->task->ring;
    fmpz_mpoly_t square;
    fmpz_mpoly_init(square, ring->context);
    for (size_t i = 0; i < ring->generator_count; i++) {
        drop(end, square, ring->generators[i].square.numerator, end->vanishes); /* it uses earlier ones alone */
        end->vanishes[i] = has_factor(end, square) && !has_factor(end, ring->generators[i].square.denominator) &&
                           is_followed(end, ring->generators[i].square.numerator, false);
    }
    fmpz_mpoly_clear(square, ring->context);
}

/* Where a ratio goes as the end is neared. value: receives where, unless it is not followed. lifted: NULL, or roots that vanish:
 * that it goes to zero is then followed only where it does with these and the way left, at least as fast as their sum. */
static limit follow(const pole_end *end, ttc_ratio *value, const ttc_ratio *ratio, const bool *lifted)
{
    ttc_task *task = end->task;
    ttc_ring *ring = task->ring;
    limit found = IS_NOT_FOLLOWED;
    fmpz_mpoly_t top;
    ttc_ratio bottom;
    if (!ttc_task_open(task)) return found;
    fmpz_mpoly_init(top, ring->context);
    ttc_ratio_init(ring, &bottom);
    drop(end, top, ratio->numerator, end->vanishes);
    if (is_followed(end, ratio->numerator, false) && is_followed(end, ratio->denominator, false) &&
        is_nonzero(end, ratio->denominator)) {
        put_state(end, value, top);
        put_state(end, &bottom, ratio->denominator);
        ttc_ratio_divide(ring, value, value, &bottom);
        found = has_factor(end, top) ? GOES_TO_ZERO : GOES_ELSEWHERE;
        if (lifted != NULL) drop(end, top, ratio->numerator, lifted);
        if (found == GOES_TO_ZERO && !has_factor(end, top)) found = IS_NOT_FOLLOWED;
    }
    ttc_ratio_clear(ring, &bottom);
    fmpz_mpoly_clear(top, ring->context);
    return found;
}

/* One condition of the domain as it is at the end, without powers of way, which is positive inside: so that a point which meets
 * it has points of the domain beside it. */
static bool add_at_end(const pole_end *end, const fmpz_mpoly_t polynomial, ttc_relation relation)
{
    ttc_task *task = end->task;
    const ttc_ring *ring = task->ring;
    bool ok = is_followed(end, polynomial, true);
    fmpz_mpoly_t rest, quotient;
    ttc_ratio value;
    fmpz_mpoly_init(rest, ring->context);
    fmpz_mpoly_init(quotient, ring->context);
    ttc_ratio_init(task->ring, &value);
    drop(end, rest, polynomial, end->vanishes);
    const bool is_whole = fmpz_mpoly_equal(rest, polynomial, ring->context);
    if (is_whole && fmpz_mpoly_degree_si(rest, end->variable, ring->context) < 1) goto done; /* the state says nothing of it */
    ok = ok && relation != TTC_IS_ZERO && (is_whole || !has_factor(end, rest)) && !fmpz_mpoly_is_zero(rest, ring->context);
    while (ok && fmpz_mpoly_divides(quotient, rest, end->way, ring->context)) fmpz_mpoly_swap(rest, quotient, ring->context);
    if (ok) put_state(end, &value, rest);
    if (ok) ttc_conditions_add(&task->domain, &value, relation == TTC_IS_NONNEGATIVE ? TTC_IS_POSITIVE : relation);
done:
    ttc_ratio_clear(task->ring, &value);
    fmpz_mpoly_clear(quotient, ring->context);
    fmpz_mpoly_clear(rest, ring->context);
    return ok;
}

static void refute(const pole_end *end, const ttc_symbol_entry *entry, const ttc_time *time, const ttc_ratio *value)
{
    ttc_task *task = end->task;
    const size_t mark = ttc_conditions_mark(&task->domain);
    const bool contradictory = task->domain.contradictory;
    const char *state = task->model->symbols[end->state].name;
    bool ok = is_followed(end, value->numerator, true);
    for (size_t i = 0; ok && i < mark; i++) {
        fmpz_mpoly_t polynomial; /* items move as conditions are added */
        fmpz_mpoly_init(polynomial, task->ring->context);
        fmpz_mpoly_set(polynomial, task->domain.items[i].polynomial, task->ring->context);
        ok = add_at_end(end, polynomial, task->domain.items[i].relation);
        fmpz_mpoly_clear(polynomial, task->ring->context);
    }
    if (ok) ttc_conditions_add(&task->domain, value, TTC_IS_NONZERO);
    if (ok)
        ttc_task_refute(task, value, "orbits run through the %s end of %s: there, and else as at the point, %s has in the time "
                        "%s the rate", side_of(end), state, entry->name, time->name);
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    ttc_task_unsettle(task, "at the %s end of %s the rate of %s in the time %s is not zero everywhere; that orbits come there "
                      "was not shown", side_of(end), state, entry->name, time->name);
}

/* Of the roots that vanish, those that are bounded by one that the time lifts: others may go to zero more slowly, so that an end
 * is come to although the rates vanish there. */
static void find_lifted(const pole_end *end, bool *lifted, const ttc_time *time)
{
    ttc_task *task = end->task;
    ttc_ratio root, quotient, value;
    ttc_ratio_init(task->ring, &root);
    ttc_ratio_init(task->ring, &quotient);
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < task->ring->generator_count; i++) {
        lifted[i] = false;
        for (size_t k = 0; end->vanishes[i] && !lifted[i] && k < time->lifted_count; k++) {
            ttc_evaluate(task->field, &root, task->model->symbols[time->lifted[k]].node);
            ttc_ratio_set_variable(task->ring, &quotient, task->ring->generators[i].variable);
            ttc_ratio_divide(task->ring, &quotient, &quotient, &root);
            lifted[i] = follow(end, &value, &quotient, NULL) != IS_NOT_FOLLOWED;
        }
    }
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &quotient);
    ttc_ratio_clear(task->ring, &root);
}

static void require_rest(const pole_end *end, const ttc_symbol_entry *entry, const ttc_time *time)
{
    ttc_task *task = end->task;
    ttc_graph *graph = task->model->graph;
    ttc_ratio rate, value;
    bool lifted[TTC_GENERATOR_LIMIT];
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_init(task->ring, &value);
    find_lifted(end, lifted, time);
    ttc_evaluate(task->field, &rate, ttc_multiply(graph, time->factor, ttc_derive_field(task->model, entry->node)));
    const limit found = follow(end, &value, &rate, lifted);
    if (found == GOES_ELSEWHERE) refute(end, entry, time, &value);
    if (found == IS_NOT_FOLLOWED)
        ttc_task_unsettle(task, "the rate of %s in the time %s could not be followed to the %s end of %s", entry->name,
                          time->name, side_of(end), task->model->symbols[end->state].name);
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &rate);
}

/* What is left of the time at the end is told from its factor and the root's rate of decay, which are of one order there. */
static void require_first_order(const pole_end *end, const ttc_symbol_entry *entry, const ttc_time *time)
{
    ttc_task *task = end->task;
    ttc_ratio factor, root, value;
    ttc_ratio_init(task->ring, &factor);
    ttc_ratio_init(task->ring, &root);
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &factor, time->factor);
    ttc_evaluate(task->field, &root, entry->node);
    ttc_ratio_divide(task->ring, &factor, &factor, &root);
    if (ttc_task_open(task) && follow(end, &value, &factor, NULL) != GOES_ELSEWHERE)
        ttc_task_unsettle(task, "at the %s end of %s dt/dtau in the time %s is not shown to be %s times what is not zero",
                          side_of(end), task->model->symbols[end->state].name, time->name, entry->name);
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &root);
    ttc_ratio_clear(task->ring, &factor);
}

typedef void (*in_time)(const pole_end *end, const ttc_symbol_entry *root, const ttc_time *time);

static void require_rest_of_both(const pole_end *end, const ttc_symbol_entry *root, const ttc_time *time)
{
    require_rest(end, root, time);
    require_rest(end, end->task->model->symbols + end->state, time);
}

/* Whether a root goes to zero. One whose inverse has a limit, as where it grows without bounds, does not. */
static limit follow_root(const pole_end *end, const ttc_symbol_entry *entry)
{
    ttc_task *task = end->task;
    ttc_ratio root, value;
    ttc_ratio_init(task->ring, &root);
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &root, entry->node);
    limit found = follow(end, &value, &root, NULL);
    if (found == IS_NOT_FOLLOWED && ttc_task_open(task)) {
        ttc_ratio_power(task->ring, &root, &root, -1);
        if (follow(end, &value, &root, NULL) != IS_NOT_FOLLOWED) found = GOES_ELSEWHERE;
    }
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &root);
    return found;
}

/* In every time in which a root that is zero at the end is a state of its own. */
static void require_in_times(const pole_end *end, in_time require)
{
    ttc_task *task = end->task;
    const ttc_model *model = task->model;
    for (size_t i = 0; i < model->time_count; i++)
        for (size_t k = 0; k < model->times[i].lifted_count && ttc_task_open(task); k++) {
            const ttc_symbol_entry *entry = model->symbols + model->times[i].lifted[k];
            const limit found = follow_root(end, entry);
            if (found == IS_NOT_FOLLOWED) ttc_task_unsettle(task, "%s could not be followed to the ends of %s", entry->name,
                                                            model->symbols[end->state].name);
            if (found == GOES_TO_ZERO) require(end, entry, &model->times[i]);
        }
}

static ttc_id at_end(void *context, uint32_t symbol)
{
    const pole_end *end = context;
    const ttc_symbol_entry *state = end->task->model->symbols + end->state;
    if (symbol != end->state) return TTC_NONE;
    return end->is_high ? state->high : state->low;
}

/* out *= the radicand at the end; one that divides by zero there does not count. */
static void times_radicand(pole_end *end, ttc_ratio *out, const ttc_symbol_entry *root)
{
    ttc_task *task = end->task;
    ttc_graph *graph = task->model->graph;
    ttc_ratio value;
    ttc_graph_clear_error(graph);
    const ttc_id there = ttc_substitute(graph, ttc_model_expand(task->model, root->definition), at_end, end);
    if (there == TTC_NONE && ttc_graph_error(graph) == TTC_GRAPH_DIVISION_BY_ZERO) {
        ttc_graph_clear_error(graph);
        return;
    }
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, there);
    ttc_ratio_multiply(task->ring, out, out, &value);
    ttc_ratio_clear(task->ring, &value);
}

/* Of the radicands of all lifted roots, those that have a value at the end, one is zero there. */
static void require_root(pole_end *end)
{
    ttc_task *task = end->task;
    const ttc_model *model = task->model;
    ttc_ratio product;
    ttc_ratio_init(task->ring, &product);
    ttc_ratio_set_integer(task->ring, &product, 1);
    for (size_t i = 0; i < model->time_count; i++)
        for (size_t k = 0; k < model->times[i].lifted_count && ttc_task_open(task); k++)
            times_radicand(end, &product, model->symbols + model->times[i].lifted[k]);
    ttc_task_require_zero(task, &product, "at the %s end of %s no lifted root is zero: product of radicands", side_of(end),
                          model->symbols[end->state].name);
    ttc_ratio_clear(task->ring, &product);
}

static bool lifts_roots(const ttc_model *model)
{
    bool lifts = false;
    for (size_t i = 0; i < model->time_count; i++) lifts |= model->times[i].lifted_count > 0;
    return lifts;
}

/* All roots come into the ring, before it is asked which of them vanish. */
static void evaluate_all(ttc_task *task, const ttc_symbol_entry *state)
{
    const ttc_model *model = task->model;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < model->time_count; i++) {
        ttc_evaluate(task->field, &value, model->times[i].factor);
        for (size_t k = 0; k < model->times[i].lifted_count; k++)
            ttc_evaluate(task->field, &value, ttc_derive_field(model, model->symbols[model->times[i].lifted[k]].node));
    }
    ttc_evaluate(task->field, &value, ttc_derive_field(model, state->node));
    ttc_ratio_clear(task->ring, &value);
}

static void prove_end(pole_end *end)
{
    ttc_task *task = end->task;
    const ttc_symbol_entry *state = task->model->symbols + end->state;
    ttc_ratio way, bound;
    require_root(end);
    if (!ttc_task_open(task)) return;
    evaluate_all(task, state);
    if (!ttc_task_open(task)) return;
    ttc_ratio_init(task->ring, &way);
    ttc_ratio_init(task->ring, &bound);
    ttc_evaluate(task->field, &way, end->is_high ? state->high : state->node);
    ttc_evaluate(task->field, &bound, end->is_high ? state->node : state->low);
    ttc_ratio_subtract(task->ring, &way, &way, &bound);
    fmpz_mpoly_init(end->way, task->ring->context);
    fmpz_mpoly_set(end->way, way.numerator, task->ring->context);
    find_vanishing(end);
    require_in_times(end, require_rest_of_both);
    require_in_times(end, require_first_order);
    fmpz_mpoly_clear(end->way, task->ring->context);
    ttc_ratio_clear(task->ring, &bound);
    ttc_ratio_clear(task->ring, &way);
}

void ttc_prove_pole(ttc_task *task)
{
    const uint32_t state = task->model->poles[task->claim->family].state;
    if (!lifts_roots(task->model)) ttc_task_unsettle(task, "no time lifts a root, which would be zero there");
    for (int high = 0; high < 2 && ttc_task_open(task); high++) {
        const slong variable = ttc_valuation_variable(task->field, state);
        pole_end end = { .task = task, .state = state, .is_high = high, .variable = variable };
        prove_end(&end);
    }
}
