/* Provers of claims about the flow or about expressions alone: integrals, rates, invariants, equalities, inequalities. */
#include "prove/domain.h"
#include "prove/signs.h"
#include "prove/tangent.h"

#include "algebra/independence.h"

#include <flint/fmpz_mpoly_factor.h>
#include <stdio.h>
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

/* Require that an expression has this rate along the flow; what: the difference, in words. */
static void require_rate(ttc_task *task, ttc_id expression, ttc_id rate, const char *what)
{
    if (ttc_task_open(task) && ttc_task_has_rate_in_other_states(task, expression, rate)) return;
    ttc_task_require_identity(task, ttc_derive_field(task->model, expression), rate, what);
}

void ttc_prove_integral(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    char what[160];
    ttc_ratio value;
    if (ttc_task_restricts_states(task))
        ttc_task_require_kept(task, "an integral needs a set that is kept: use 'modulo' with an invariant");
    ttc_ratio_init(task->ring, &value);
    const bool moves = ttc_task_moves_at_point(task, claim->expression);
    if (!moves) ttc_evaluate(task->field, &value, claim->expression);
    const bool constant = ttc_task_open(task) && !moves && !ttc_task_moves(task, &value);
    task->varies |= !constant;
    if (constant && !task->is_thin && ttc_task_open(task) && ttc_task_may_have_point(task))
        ttc_task_unsettle(task, "%s is constant%s, whatever the motion: being an integral says nothing", claim->name,
                          task->ring->choice_count > 0 ? " on a part of the domain" : "");
    snprintf(what, sizeof what, "d(%s)/dt", claim->name);
    require_rate(task, claim->expression, ttc_integer(task->model->graph, 0), what);
    if (!moves) ttc_evaluate(task->field, &value, claim->expression);
    if (!task->is_thin && !moves) require_moving(task, &value);
    ttc_ratio_clear(task->ring, &value);
}

void ttc_prove_rate(ttc_task *task)
{
    require_rate(task, task->claim->expression, task->claim->other, "rate - right side");
}

/* The leaf is a Zariski-dense part of a component of NAME = 0, which the flow keeps if it is tangent to the leaf. */
void ttc_prove_invariant(ttc_task *task)
{
    if (!task->is_integral) ttc_task_require_kept(task, NULL);
}

void ttc_prove_equal(ttc_task *task)
{
    ttc_task_require_identity(task, task->claim->expression, task->claim->other, "left - right");
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

/* What is said of a claim at a point of the level that it is about. */
static const char *what_is_false(const ttc_claim *claim)
{
    switch (claim->kind) {
    case TTC_CLAIM_INVARIANT: return "the set is left: rate of ";
    case TTC_CLAIM_RATE: return "rate - right side";
    default: return "left - right";
    }
}

/* Refute the claim at a point of the level value = 0 at which `rest`, which should be zero there, is not. If none is found, any
 * point of the level becomes the witness, unless there is one already. */
static void look_for_zero(ttc_task *task, const ttc_ratio *value, const ttc_ratio *rest)
{
    const ttc_claim *claim = task->outer->claim;
    const size_t mark = ttc_conditions_mark(&task->domain);
    const bool contradictory = task->domain.contradictory;
    ttc_conditions_add(&task->domain, rest, TTC_IS_NONZERO);
    char *text = ttc_task_zero_of(task, value);
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    if (text != NULL) {
        ttc_task_refute_at(task, text, rest, "%s%s", what_is_false(claim), claim->kind == TTC_CLAIM_INVARIANT ? claim->name : "");
    } else if (task->kept > 0 || (text = ttc_task_zero_of(task, value)) == NULL) {
        return;
    } else {
        free(task->point);
        task->point = text;
    }
    task->kept++;
}

/* Replace a polynomial by the product of its factors, each once, which is zero at the same points. */
static void take_radical(ttc_task *task, fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = task->ring->context;
    fmpz_mpoly_factor_t factors;
    fmpz_mpoly_factor_init(factors, context);
    if (!fmpz_mpoly_factor(factors, polynomial, context)) ttc_task_unsettle(task, "the zero level could not be factored");
    fmpz_mpoly_one(polynomial, context);
    for (slong i = 0; i < factors->num; i++) fmpz_mpoly_mul(polynomial, polynomial, factors->poly + i, context);
    fmpz_mpoly_factor_clear(factors, context);
}

/* Whether a polynomial is one in parameters, states and levels alone. */
static bool is_plain(const ttc_task *task, const fmpz_mpoly_t polynomial)
{
    const ttc_model *model = task->model;
    bool plain = true;
    for (slong v = 0; plain && v < (slong)task->ring->variable_count; v++) {
        const size_t symbol = ttc_valuation_symbol(task->field, v);
        plain = fmpz_mpoly_degree_si(polynomial, v, task->ring->context) < 1 ||
                (symbol < model->symbol_count && !ttc_symbol_is_function(model->symbols[symbol].kind));
    }
    return plain;
}

/* Returns true if a divisor is not zero on a whole part of the zero level of an irreducible factor: because it is zero nowhere; or
 * because the factor does not divide it, and has both signs. The latter holds for polynomials without functions alone: y and
 * exp(y) - 1 are zero together. */
static bool is_apart(ttc_task *task, const fmpz_mpoly_t divisor, const fmpz_mpoly_t factor)
{
    ttc_ratio value;
    fmpz_mpoly_t quotient;
    if (!(ttc_conditions_signs(&task->domain, divisor) & TTC_CAN_BE_ZERO)) return true;
    if (!is_plain(task, divisor) || !is_plain(task, factor)) return false;
    ttc_ratio_init(task->ring, &value);
    fmpz_mpoly_init(quotient, task->ring->context);
    ttc_ratio_set_polynomial(task->ring, &value, factor);
    const bool apart = !fmpz_mpoly_divides(quotient, divisor, factor, task->ring->context) &&
                       ttc_task_search(task, &value, TTC_IS_POSITIVE, NULL) == TTC_POINT_FOUND &&
                       ttc_task_search_against(task, &value, TTC_IS_NONNEGATIVE, NULL) == TTC_POINT_FOUND;
    fmpz_mpoly_clear(quotient, task->ring->context);
    ttc_ratio_clear(task->ring, &value);
    return apart;
}

/* Require that what divides in the claim is zero on no whole part of the level value = 0. */
static void require_divisors(ttc_task *task, const ttc_ratio *value)
{
    const ttc_model *model = task->model;
    unsigned char *of_claim = ttc_domain_divisors_of_claim(task->outer);
    ttc_ratio divisor;
    fmpz_mpoly_factor_t factors;
    ttc_ratio_init(task->ring, &divisor);
    fmpz_mpoly_factor_init(factors, task->ring->context);
    if (of_claim == NULL || !fmpz_mpoly_factor(factors, value->numerator, task->ring->context))
        ttc_task_unsettle(task, "the zero level could not be factored");
    for (size_t i = 0; of_claim != NULL && i < model->divisor_count && ttc_task_open(task); i++) {
        if (!of_claim[i]) continue;
        ttc_evaluate(task->field, &divisor, model->divisors[i].divisor);
        for (slong k = 0; k < factors->num && ttc_task_open(task); k++)
            if ((ttc_conditions_signs(&task->domain, factors->poly + k) & TTC_CAN_BE_ZERO) &&
                !is_apart(task, divisor.numerator, factors->poly + k))
                ttc_task_unsettle(task, "what divides may be zero on a whole part of the level");
    }
    fmpz_mpoly_factor_clear(factors, task->ring->context);
    ttc_ratio_clear(task->ring, &divisor);
    free(of_claim);
}

/* Require that a polynomial is zero nowhere in the domain. By its factors, as most are what divides in the claim. */
static void require_no_zero(ttc_task *task, const fmpz_mpoly_t polynomial)
{
    ttc_ratio factor;
    fmpz_mpoly_factor_t factors;
    ttc_ratio_init(task->ring, &factor);
    fmpz_mpoly_factor_init(factors, task->ring->context);
    if (!fmpz_mpoly_factor(factors, polynomial, task->ring->context)) ttc_task_unsettle(task, "the cofactor could not be factored");
    for (slong i = 0; i < factors->num && ttc_task_open(task); i++) {
        ttc_ratio_set_polynomial(task->ring, &factor, factors->poly + i);
        const ttc_search_result pole = ttc_task_search_against(task, &factor, TTC_IS_NONZERO, NULL);
        if (pole != TTC_POINT_IMPOSSIBLE && pole != TTC_POINT_EXCLUDED) ttc_task_unsettle(task, "the cofactor may have a pole");
    }
    fmpz_mpoly_factor_clear(factors, task->ring->context);
    ttc_ratio_clear(task->ring, &factor);
}

/* The left side of the claim is f, the right one what should be zero where f is: require that it is K f with K finite all over the
 * domain. */
static void prove_cofactor(ttc_task *task)
{
    ttc_ratio value, rest;
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &rest);
    ttc_evaluate(task->field, &value, task->claim->expression);
    ttc_evaluate(task->field, &rest, task->claim->other);
    const bool is_own = task->outer->claim->kind == TTC_CLAIM_INVARIANT;
    const bool serves = ttc_task_open(task) && !task->is_at_zeros && (!is_own || ttc_task_moves(task, &value))
                        && fmpz_mpoly_is_fmpz(value.denominator, task->ring->context);
    if (!serves) ttc_task_unsettle(task, "no cofactor is looked for");
    if (serves && !is_own) take_radical(task, value.numerator);
    if (ttc_task_open(task)) look_for_zero(task, &value, &rest);
    if (ttc_task_open(task)) require_divisors(task, &value);
    if (ttc_task_open(task)) {
        ttc_ratio_divide(task->ring, &rest, &rest, &value);
        require_no_zero(task, rest.denominator);
    }
    ttc_ratio_clear(task->ring, &rest);
    ttc_ratio_clear(task->ring, &value);
}

/* Whether anything divides in claim number `level`, also in what cancels from it; true when memory is out. */
static bool divides(const ttc_model *model, uint32_t level)
{
    unsigned char *used = ttc_model_uses_of(model, TTC_DIVIDES_CLAIM, level);
    bool found = used == NULL;
    for (size_t i = 0; i < model->divisor_count && !found; i++) {
        const ttc_divisor *divisor = &model->divisors[i];
        found = (divisor->role == TTC_DIVIDES_CLAIM && divisor->owner == level) ||
                (divisor->role == TTC_DIVIDES_SYMBOL && used[divisor->owner]);
    }
    free(used);
    return found;
}

/* Put an expression f and what should be zero where f is in place of the two sides. Returns false if there is no such f. */
static bool set_level(const ttc_task *task, ttc_claim *rest)
{
    const ttc_model *model = task->model;
    const ttc_claim *claim = task->claim;
    const bool is_own = claim->kind == TTC_CLAIM_INVARIANT;
    const bool is_equal = claim->kind == TTC_CLAIM_EQUAL, is_rate = claim->kind == TTC_CLAIM_RATE;
    if ((!is_own && !is_equal && !is_rate) || claim->modulo_count != !is_own || task->level_count > 0) return false;
    const uint32_t index = is_own ? task->owner : claim->modulo[0];
    const ttc_claim *level = &model->claims[index];
    if (is_own ? ttc_task_restricts_states(task) : level->when.count + level->modulo_count > 0) return false;
    if (divides(model, index) || (!is_own && task->verdict_of(task->verdict_context, index) != TTC_PROVED)) return false;
    rest->modulo_count = 0;
    rest->expression = level->expression;
    rest->other = is_equal ? claim->expression : ttc_derive_field(model, claim->expression);
    if (rest->other != TTC_NONE && !is_own) rest->other = ttc_subtract(model->graph, rest->other, claim->other);
    return rest->other != TTC_NONE;
}

void ttc_prove_by_cofactor(ttc_task *task)
{
    ttc_claim rest = *task->claim;
    if (task->status != TTC_UNSETTLED || task->is_partial || task->role != TTC_DIVIDES_CLAIM || !set_level(task, &rest)) return;
    rest.kind = TTC_CLAIM_EQUAL;
    ttc_task inner = { .model = task->model, .claim = &rest, .role = task->role, .owner = task->owner, .outer = task,
                       .verdict_of = task->verdict_of, .verdict_context = task->verdict_context };
    ttc_task_run(&inner, prove_cofactor);
    if (inner.status != TTC_UNSETTLED && inner.kept > 0) {
        free(task->remainder);
        free(task->point);
        task->status = inner.status;
        task->remainder = inner.remainder;
        task->point = inner.point;
        task->relies_on_solver |= inner.relies_on_solver;
        inner.remainder = inner.point = NULL;
    }
    free(inner.remainder);
    free(inner.point);
    free(inner.note);
}
