/* The prover of poles: at both ends of the state's interval a lifted root is zero, and orbits do not pass through. In each time
 * that lifts such a root, the rates of the root and of the state are ratios N/D. N lies in the ideal of way, the distance of the
 * state from the end, and of the roots that vanish there at least as fast as a lifted one; D is not zero there for parameters in
 * general. So the rates are bounded by multiples of way and the root, which therefore stay zero where they are zero, and orbits of
 * the lifted field reach the end only as its time goes to infinity. */
#include "prove/pole_end.h"

static const char *side_of(const ttc_pole_end *end) { return end->is_high ? "upper" : "lower"; }

/* Add a condition of the domain with the state at its end, divided by powers of way, which is positive inside: a point that meets
 * it has points of the domain nearby. Returns false if the condition cannot be followed to the end. */
static bool add_at_end(const ttc_pole_end *end, const fmpz_mpoly_t polynomial, ttc_relation relation)
{
    ttc_task *task = end->task;
    const ttc_ring *ring = task->ring;
    bool ok = ttc_pole_is_followed(end, polynomial, true);
    fmpz_mpoly_t rest, quotient;
    ttc_ratio value;
    fmpz_mpoly_init(rest, ring->context);
    fmpz_mpoly_init(quotient, ring->context);
    ttc_ratio_init(task->ring, &value);
    ttc_pole_drop(end, rest, polynomial, end->vanishes);
    const bool is_whole = fmpz_mpoly_equal(rest, polynomial, ring->context);
    if (is_whole && fmpz_mpoly_degree_si(rest, end->variable, ring->context) < 1) goto done; /* it does not depend on the state */
    ok = ok && relation != TTC_IS_ZERO && (is_whole || !ttc_pole_has_factor(end, rest)) && !fmpz_mpoly_is_zero(rest, ring->context);
    while (ok && fmpz_mpoly_divides(quotient, rest, end->way, ring->context)) fmpz_mpoly_swap(rest, quotient, ring->context);
    if (ok) ttc_pole_put_state(end, &value, rest);
    if (ok) ttc_conditions_add(&task->domain, &value, relation == TTC_IS_NONNEGATIVE ? TTC_IS_POSITIVE : relation);
done:
    ttc_ratio_clear(task->ring, &value);
    fmpz_mpoly_clear(quotient, ring->context);
    fmpz_mpoly_clear(rest, ring->context);
    return ok;
}

static void refute(const ttc_pole_end *end, const ttc_symbol_entry *entry, const ttc_time *time, const ttc_ratio *value)
{
    ttc_task *task = end->task;
    const size_t mark = ttc_conditions_mark(&task->domain);
    const bool contradictory = task->domain.contradictory;
    const char *state = task->model->symbols[end->state].name;
    bool ok = ttc_pole_is_followed(end, value->numerator, true);
    for (size_t i = 0; ok && i < mark; i++) {
        fmpz_mpoly_t polynomial; /* a copy, as adding conditions reallocates the items */
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

/* Flag the vanishing roots that are bounded by a multiple of one that the time lifts. Others may go to zero more slowly, so that
 * orbits may reach the end although the rates vanish there. */
static void find_lifted(const ttc_pole_end *end, bool *lifted, const ttc_time *time)
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
            lifted[i] = ttc_pole_follow(end, &value, &quotient, NULL) != TTC_POLE_IS_NOT_FOLLOWED;
        }
    }
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &quotient);
    ttc_ratio_clear(task->ring, &root);
}

static void require_rest(const ttc_pole_end *end, const ttc_symbol_entry *entry, const ttc_time *time)
{
    ttc_task *task = end->task;
    ttc_graph *graph = task->model->graph;
    ttc_ratio rate, value;
    bool lifted[TTC_GENERATOR_LIMIT];
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_init(task->ring, &value);
    find_lifted(end, lifted, time);
    ttc_evaluate(task->field, &rate, ttc_multiply(graph, time->factor, ttc_derive_field(task->model, entry->node)));
    const ttc_pole_limit found = ttc_pole_follow(end, &value, &rate, lifted);
    if (found == TTC_POLE_GOES_ELSEWHERE) refute(end, entry, time, &value);
    if (found == TTC_POLE_IS_NOT_FOLLOWED)
        ttc_task_unsettle(task, "the rate of %s in the time %s could not be followed to the %s end of %s", entry->name,
                          time->name, side_of(end), task->model->symbols[end->state].name);
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &rate);
}

/* Require that dt/dtau is the root times a factor with a nonzero limit: the time that is left to the end is computed from dt/dtau
 * and the root's rate of decay, which must be of one order. */
static void require_first_order(const ttc_pole_end *end, const ttc_symbol_entry *entry, const ttc_time *time)
{
    ttc_task *task = end->task;
    ttc_ratio factor, root, value;
    ttc_ratio_init(task->ring, &factor);
    ttc_ratio_init(task->ring, &root);
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &factor, time->factor);
    ttc_evaluate(task->field, &root, entry->node);
    ttc_ratio_divide(task->ring, &factor, &factor, &root);
    if (ttc_task_open(task) &&
        (ttc_pole_follow(end, &value, &factor, NULL) != TTC_POLE_GOES_ELSEWHERE || !ttc_pole_is_nonzero(end, value.numerator)))
        ttc_task_unsettle(task, "at the %s end of %s dt/dtau in the time %s is not shown to be %s times what is not zero",
                          side_of(end), task->model->symbols[end->state].name, time->name, entry->name);
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &root);
    ttc_ratio_clear(task->ring, &factor);
}

typedef void (*in_time)(const ttc_pole_end *end, const ttc_symbol_entry *root, const ttc_time *time);

/* Require rest of the state first: where it does not come to rest, the rate of the root, which divides by the root, may be
 * unbounded. */
static void require_rest_of_both(const ttc_pole_end *end, const ttc_symbol_entry *root, const ttc_time *time)
{
    require_rest(end, end->task->model->symbols + end->state, time);
    require_rest(end, root, time);
}

/* The limit of a root. If only its inverse can be followed, as for a root that grows without bound, it does not go to zero. */
static ttc_pole_limit follow_root(const ttc_pole_end *end, const ttc_symbol_entry *entry)
{
    ttc_task *task = end->task;
    ttc_ratio root, value;
    ttc_ratio_init(task->ring, &root);
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &root, entry->node);
    ttc_pole_limit found = ttc_pole_follow(end, &value, &root, NULL);
    if (found == TTC_POLE_IS_NOT_FOLLOWED && ttc_task_open(task)) {
        ttc_ratio_power(task->ring, &root, &root, -1);
        if (ttc_pole_follow(end, &value, &root, NULL) != TTC_POLE_IS_NOT_FOLLOWED) found = TTC_POLE_GOES_ELSEWHERE;
    }
    ttc_ratio_clear(task->ring, &value);
    ttc_ratio_clear(task->ring, &root);
    return found;
}

/* Call `require` for every time and every root that it lifts and that is zero at the end. */
static void require_in_times(const ttc_pole_end *end, in_time require)
{
    ttc_task *task = end->task;
    const ttc_model *model = task->model;
    for (size_t i = 0; i < model->time_count; i++)
        for (size_t k = 0; k < model->times[i].lifted_count && ttc_task_open(task); k++) {
            const ttc_symbol_entry *entry = model->symbols + model->times[i].lifted[k];
            const ttc_pole_limit found = follow_root(end, entry);
            if (found == TTC_POLE_IS_NOT_FOLLOWED)
                ttc_task_unsettle(task, "%s could not be followed to the ends of %s", entry->name,
                                  model->symbols[end->state].name);
            if (found == TTC_POLE_GOES_TO_ZERO) require(end, entry, &model->times[i]);
        }
}

static ttc_id at_end(void *context, uint32_t symbol)
{
    const ttc_pole_end *end = context;
    const ttc_symbol_entry *state = end->task->model->symbols + end->state;
    if (symbol != end->state) return TTC_NONE;
    return end->is_high ? state->high : state->low;
}

/* out *= the radicand at the end; a radicand that divides by zero there is left out. */
static void times_radicand(ttc_pole_end *end, ttc_ratio *out, const ttc_symbol_entry *root)
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

/* Require that the product of the radicands of lifted roots, those that have a value at the end, is zero there. */
static void require_root(ttc_pole_end *end)
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

/* Evaluate all that is used below, so that its roots are in the ring before ttc_pole_find_vanishing. */
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

static void prove_end(ttc_pole_end *end)
{
    ttc_task *task = end->task;
    const ttc_symbol_entry *state = task->model->symbols + end->state;
    ttc_ratio way;
    require_root(end);
    if (!ttc_task_open(task)) return;
    evaluate_all(task, state);
    if (!ttc_task_open(task)) return;
    ttc_ratio_init(task->ring, &way);
    ttc_evaluate(task->field, &way, end->is_high ? state->high : state->node);
    ttc_task_take_off(task, &way, task->field, end->is_high ? state->node : state->low);
    fmpz_mpoly_init(end->way, task->ring->context);
    fmpz_mpoly_set(end->way, way.numerator, task->ring->context);
    ttc_pole_find_vanishing(end);
    require_in_times(end, require_rest_of_both);
    require_in_times(end, require_first_order);
    fmpz_mpoly_clear(end->way, task->ring->context);
    ttc_ratio_clear(task->ring, &way);
}

void ttc_prove_pole(ttc_task *task)
{
    const uint32_t state = task->model->poles[task->claim->family].state;
    if (!lifts_roots(task->model)) ttc_task_unsettle(task, "no time lifts a root, which would be zero there");
    for (int high = 0; high < 2 && ttc_task_open(task); high++) {
        const slong variable = ttc_valuation_variable(task->field, state);
        ttc_pole_end end = { .task = task, .state = state, .is_high = high, .variable = variable };
        prove_end(&end);
    }
}
