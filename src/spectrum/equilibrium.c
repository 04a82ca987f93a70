#include "spectrum/equilibrium.h"

#include "kernel/descriptor.h"

#include <math.h>
#include <stdlib.h>

/* The report of doubles, with bounds on the errors of the Jacobian and of the integrals' gradients against the exact values. */
static jlt_status linearize(jlt_linearization *result, const jlt_equilibrium_question *q, const double *params, const double *x)
{
    const size_t n = q->descriptor->state_count;
    double errors[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX];
    double gradient_errors[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX];
    ttc_enclosure *exact = calloc(n * n, sizeof *exact);
    jlt_status st = exact == NULL ? JLT_ERR_NOMEM : JLT_OK;

    if (st == JLT_OK) st = jlt_linearization_residual(result, q->descriptor, params, x);
    if (st != JLT_OK) goto done;
    jlt_oracle_set_params(q->oracle, params, q->params);
    jlt_oracle_set_states(q->oracle, x, q->x);
    JLT_TRY(jlt_oracle_enclose(q->oracle, exact, q->oracle->jacobian, n * n));
    for (size_t i = 0; i < n * n; i++) {
        errors[i] = jlt_oracle_error(result->jacobian[i], &exact[i]);
        if (!isfinite(errors[i])) st = JLT_ERR_NONFINITE;
    }
    if (st != JLT_OK) goto done;
    JLT_TRY(jlt_oracle_gradient_errors(q->oracle, gradient_errors, result->gradients, result->descriptor->integrals,
                                       result->integrals));
    st = jlt_linearization_compute(result, q->descriptor, params, x, errors, gradient_errors);
done:
    free(exact);
    return st;
}

/* What ball arithmetic makes of the exact values; the result is untouched where it settles nothing. */
static jlt_status enclose(jlt_linearization *result, const jlt_equilibrium_question *q, const double *params, const double *x)
{
    const jlt_descriptor *d = q->descriptor;
    jlt_ball_value *exact = calloc(d->param_count + 1, sizeof *exact), exact_x[JLT_LINEARIZATION_SIZE_MAX];
    jlt_status st = JLT_ERR_NOMEM;

    if (exact == NULL) return st;
    for (size_t i = 0; i < d->param_count; i++) exact[i] = (jlt_ball_value){ params[i], q->params[i] };
    for (size_t i = 0; i < d->state_count; i++) exact_x[i] = (jlt_ball_value){ x[i], q->x[i] };
    st = jlt_linearization_enclose(result, d, exact, exact_x);
    free(exact);
    return st;
}

void jlt_equilibrium_compute(jlt_equilibrium *out, const jlt_equilibrium_question *q, double *params, double *x)
{
    const jlt_descriptor *d = q->descriptor;

    out->stage = JLT_EQUILIBRIUM_PARAMS;
    out->status = jlt_descriptor_check_params(d, params, &out->index);
    if (out->status != JLT_OK) return;
    jlt_linearization_complete(x, q->given, d, params);
    out->stage = JLT_EQUILIBRIUM_STATES;
    out->status = jlt_descriptor_check_state(d, x, &out->index);
    if (out->status != JLT_OK) return;
    out->stage = JLT_EQUILIBRIUM_SEARCH;
    if (q->find) out->status = jlt_linearization_find(x, d, params, q->order, q->held);
    if (out->status != JLT_OK) return;
    out->stage = JLT_EQUILIBRIUM_POINT;
    out->status = linearize(&out->result, q, params, x);
    if (out->status == JLT_OK && enclose(&out->result, q, params, x) == JLT_ERR_NOMEM) out->status = JLT_ERR_NOMEM;
}
