/* Provers of claims about the flow or about expressions alone: integrals, rates, invariants, equalities, inequalities. */
#include "prove/signs.h"
#include "prove/tangent.h"

#include "algebra/independence.h"

#include <stdlib.h>

/* Returns true if the derivative along some free state is known to be nonzero, in form or at a point. */
static bool is_known_to_move(ttc_task *task, ttc_id expression)
{
    ttc_tangent tangent;
    bool known = false, ok = ttc_tangent_init(task, &tangent);
    ttc_ratio *row = ttc_task_ratios(task, tangent.columns);
    if (ok && row != NULL) ttc_tangent_gradient(task, &tangent, row, expression);
    for (size_t k = 0; ok && row != NULL && !known && k < tangent.columns && ttc_task_open(task); k++)
        known = !fmpz_mpoly_is_zero(row[k].numerator, task->ring->context)
                && (ttc_ring_settles(task->ring, row[k].numerator)
                    || ttc_task_search(task, &row[k], TTC_IS_NONZERO, NULL) == TTC_POINT_FOUND);
    ttc_task_free(task, row, tangent.columns);
    ttc_tangent_clear(task, &tangent);
    return known;
}

/* Require that an integral is known to depend on the states: its form may contain functions whose relations are unknown. */
static void require_moving(ttc_task *task, const ttc_ratio *value)
{
    const ttc_claim *claim = task->claim;
    if (!ttc_task_open(task) || ttc_ring_settles_all(task->ring, value, 1) || is_known_to_move(task, claim->expression)) return;
    ttc_task_unsettle(task, "that %s depends on the states rests on the independence of exponentials, logarithms or pi, "
                            "which is not known", claim->name);
}

void ttc_prove_integral(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    ttc_ratio value;
    if (ttc_task_restricts_states(task))
        ttc_task_require_kept(task, "an integral needs a set that is kept: use 'modulo' with an invariant");
    ttc_ratio_init(task->ring, &value);
    ttc_id rate = ttc_derive_field(task->model, claim->expression);
    char *form = NULL;
    bool is_zero = ttc_task_open(task) && ttc_task_is_zero_in_general(task, rate, &form);
    const bool moves = !ttc_task_restricts_states(task) && ttc_task_moves_at_point(task, claim->expression);
    if (!moves) ttc_evaluate(task->field, &value, claim->expression);
    const bool constant = ttc_task_open(task) && !moves && !ttc_task_moves(task, &value);
    task->varies |= !constant;
    if (constant && !task->is_thin && ttc_task_open(task) && ttc_task_may_have_point(task))
        ttc_task_unsettle(task, "%s is constant%s, whatever the motion: being an integral says nothing", claim->name,
                          task->ring->choice_count > 0 ? " on a part of the domain" : "");
    if (!is_zero && !ttc_task_refute_at_point(task, rate, "the rate")) {
        ttc_evaluate(task->field, &value, rate);
        ttc_task_require_zero(task, &value, "d(%s)/dt", claim->name);
        ttc_task_shorten(task, form);
    }
    free(form);
    if (!moves) ttc_evaluate(task->field, &value, claim->expression);
    if (!task->is_thin && !moves) require_moving(task, &value);
    ttc_ratio_clear(task->ring, &value);
}

/* Require left = right of a claim that writes both; what: their difference, in words. */
static void require_sides(ttc_task *task, ttc_id left, ttc_id right, const char *what)
{
    const ttc_id difference = ttc_subtract(task->model->graph, left, right);
    char *form = NULL;
    if (!ttc_task_is_zero_in_general(task, difference, &form) && !ttc_task_refute_at_point(task, difference, what))
        ttc_task_require_equal(task, task->field, left, task->field, right, "%s", what);
    ttc_task_shorten(task, form);
    free(form);
}

void ttc_prove_rate(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    require_sides(task, ttc_derive_field(task->model, claim->expression), claim->other, "rate - right side");
}

/* The leaf is a Zariski-dense part of a component of NAME = 0, which the flow keeps if it is tangent to the leaf. */
void ttc_prove_invariant(ttc_task *task)
{
    if (!task->is_integral) ttc_task_require_kept(task, NULL);
}

void ttc_prove_equal(ttc_task *task)
{
    require_sides(task, task->claim->expression, task->claim->other, "left - right");
}

void ttc_prove_positive(ttc_task *task)
{
    ttc_signs_require(task, task->field, task->claim->expression, TTC_IS_POSITIVE, "not positive: %s", task->claim->name);
}

bool ttc_prove_is_integral(ttc_task *task)
{
    ttc_graph *graph = task->model->graph;
    if (ttc_task_restricts_states(task)) return false;
    ttc_claim rest = *task->claim;
    rest.kind = TTC_CLAIM_EQUAL;
    rest.expression = ttc_derive_field(task->model, task->claim->expression);
    rest.other = ttc_integer(graph, 0);
    ttc_task inner = { .model = task->model, .claim = &rest, .role = task->role, .owner = task->owner, .outer = task,
                       .verdict_of = task->verdict_of, .verdict_context = task->verdict_context };
    if (rest.expression != TTC_NONE) ttc_task_run(&inner, ttc_prove_equal);
    free(inner.remainder);
    free(inner.point);
    free(inner.note);
    if (rest.expression == TTC_NONE || inner.status != TTC_PROVED) return false;
    task->relies_on_solver |= inner.relies_on_solver;
    return true;
}
