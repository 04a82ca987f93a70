#include "cli/eigen.h"

#include <stdlib.h>

static bool swept(const jlt_eigen_request *q, bool is_state, size_t index)
{
    for (size_t i = 0; i < q->axis_count; i++)
        if (q->targets[i].is_state == is_state && q->targets[i].index == index) return true;
    return false;
}

/* Parameters as typed, as the table writes their defaults, or as the doubles of a sweep. *defaults: texts to free, shape
 * (params,). */
static jlt_status exact_params(jlt_ball_value *values, char **defaults, const jlt_eigen_row *row)
{
    const jlt_eigen_request *q = row->request;
    const jlt_oracle *o = q->oracle;

    for (size_t i = 0; i < q->descriptor->param_count; i++) {
        const ttc_id written = o->model->symbols[o->params[i]].value;
        values[i] = (jlt_ball_value){ row->params[i], NULL };
        if (swept(q, false, i)) continue;
        values[i].fraction = jlt_assign_fraction(&q->common.set, q->descriptor->params[i].name);
        if (values[i].fraction != NULL || written == TTC_NONE) continue;
        values[i].fraction = defaults[i] = ttc_ball_exact_text(o->ball, written);
        if (defaults[i] == NULL) return JLT_ERR_NOMEM;
    }
    return JLT_OK;
}

jlt_status jlt_eigen_enclose(jlt_eigen_row *row)
{
    const jlt_eigen_request *q = row->request;
    const jlt_descriptor *d = q->descriptor;
    jlt_ball_value *params = calloc(d->param_count + 1, sizeof *params), x[JLT_LINEARIZATION_SIZE_MAX] = { { 0 } };
    char **defaults = calloc(d->param_count + 1, sizeof *defaults);
    jlt_status st = params == NULL || defaults == NULL ? JLT_ERR_NOMEM : exact_params(params, defaults, row);

    for (size_t i = 0; i < d->state_count; i++) {
        const bool typed = !q->find && !swept(q, true, i);
        x[i] = (jlt_ball_value){ row->x[i], typed ? jlt_assign_fraction(&q->at, d->states[i].name) : NULL };
    }
    if (st == JLT_OK) st = jlt_linearization_enclose(&row->result, d, params, x);
    for (size_t i = 0; defaults != NULL && i < d->param_count; i++) free(defaults[i]);
    free(defaults);
    free(params);
    return st;
}
