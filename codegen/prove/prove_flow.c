/* Claims about the flow: integrals, rates, invariants, measures. */
#include "prove/prove_task.h"

static bool depends_on_state(ttc_task *task, const ttc_ratio *value)
{
    for (size_t v = 0; v < task->ring->variable_count; v++) {
        size_t symbol = ttc_valuation_symbol(task->field, (slong)v);
        bool quantity = symbol < task->model->symbol_count
                        && (task->model->symbols[symbol].kind == TTC_PARAM || task->model->symbols[symbol].kind == TTC_LEVEL
                            || task->model->symbols[symbol].kind == TTC_LAMBDA || task->model->symbols[symbol].kind == TTC_PI);
        if (!quantity && ttc_ratio_uses(task->ring, value, (slong)v)) return true;
    }
    return false;
}

void ttc_prove_integral(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, claim->expression);
    if (ttc_task_open(task) && !depends_on_state(task, &value))
        ttc_task_reject(task, "%s is constant, so that being an integral says nothing", claim->name);
    ttc_evaluate(task->field, &value, ttc_derive_field(task->model, claim->expression));
    ttc_task_require_zero(task, &value, "d(%s)/dt", claim->name);
    ttc_ratio_clear(task->ring, &value);
}

void ttc_prove_rate(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    ttc_ratio rate, claimed;
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_init(task->ring, &claimed);
    ttc_evaluate(task->field, &rate, ttc_derive_field(task->model, claim->expression));
    ttc_evaluate(task->field, &claimed, claim->other);
    ttc_ratio_subtract(task->ring, &rate, &rate, &claimed);
    ttc_task_require_zero(task, &rate, "rate - right side");
    ttc_ratio_clear(task->ring, &claimed);
    ttc_ratio_clear(task->ring, &rate);
}

/* NAME = 0 is kept when grad(NAME) . f = cofactor * NAME with a cofactor that has no pole on the zero level: its reduced
 * denominator shares no factor with the norm of NAME. Denominators of the field are allowed in it. */
void ttc_prove_invariant(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    ttc_ratio level, rate, cofactor;
    fmpz_mpoly_t norm, common;
    ttc_ratio_init(task->ring, &level);
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_init(task->ring, &cofactor);
    fmpz_mpoly_init(norm, task->ring->context);
    fmpz_mpoly_init(common, task->ring->context);
    ttc_evaluate(task->field, &level, claim->expression);
    ttc_evaluate(task->field, &rate, ttc_derive_field(task->model, claim->expression));
    if (!ttc_task_open(task)) goto done;
    if (ttc_ratio_is_zero(task->ring, &level) || !depends_on_state(task, &level)) {
        ttc_task_reject(task, "%s does not depend on the states, so that its zero level says nothing", claim->name);
        goto done;
    }
    ttc_ratio_divide(task->ring, &cofactor, &rate, &level);
    ttc_ratio_norm(task->ring, norm, &level);
    if (task->ring->status != TTC_RING_OK) goto done;
    if (!fmpz_mpoly_gcd(common, norm, cofactor.denominator, task->ring->context)) {
        ttc_ring_fail(task->ring, TTC_RING_TOO_LARGE);
        goto done;
    }
    /* A common factor in the parameters alone is no pole. */
    ttc_ratio_set_polynomial(task->ring, &level, common);
    if (depends_on_state(task, &level)) ttc_task_refute(task, &rate, "d(%s)/dt", claim->name);
done:
    fmpz_mpoly_clear(common, task->ring->context);
    fmpz_mpoly_clear(norm, task->ring->context);
    ttc_ratio_clear(task->ring, &cofactor);
    ttc_ratio_clear(task->ring, &rate);
    ttc_ratio_clear(task->ring, &level);
}

static bool binds_states(const ttc_task *task)
{
    for (size_t i = 0; i < task->claim->when.count; i++)
        if (task->model->symbols[task->claim->when.items[i].symbol].kind == TTC_STATE) return true;
    return task->claim->modulo_count > 0;
}

/* div(NAME f) = grad(NAME) . f + NAME div f */
void ttc_prove_measure(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    ttc_ratio density, rate, entry;
    if (binds_states(task)) {
        ttc_task_reject(task, "a density needs an open set of states");
        return;
    }
    ttc_ratio_init(task->ring, &density);
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_init(task->ring, &entry);
    ttc_evaluate(task->field, &density, claim->expression);
    if (ttc_task_open(task) && ttc_ratio_is_zero(task->ring, &density))
        ttc_task_reject(task, "the density %s is zero", claim->name);
    ttc_evaluate(task->field, &rate, ttc_derive_field(task->model, claim->expression));
    for (size_t i = 0; i < task->model->state_count && ttc_task_open(task); i++) {
        ttc_task_jacobian(task, &entry, i, i);
        ttc_ratio_add_product(task->ring, &rate, &density, &entry);
    }
    ttc_task_require_zero(task, &rate, "div(%s f)", claim->name);
    ttc_ratio_clear(task->ring, &entry);
    ttc_ratio_clear(task->ring, &rate);
    ttc_ratio_clear(task->ring, &density);
}

void ttc_prove_equal(ttc_task *task)
{
    ttc_ratio left, right;
    ttc_ratio_init(task->ring, &left);
    ttc_ratio_init(task->ring, &right);
    ttc_evaluate(task->field, &left, task->claim->expression);
    ttc_evaluate(task->field, &right, task->claim->other);
    ttc_ratio_subtract(task->ring, &left, &left, &right);
    ttc_task_require_zero(task, &left, "left - right");
    ttc_ratio_clear(task->ring, &right);
    ttc_ratio_clear(task->ring, &left);
}
