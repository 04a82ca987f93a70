#include "scene/course_pole.h"

#include <math.h>

#include "kernel/descriptor.h"
#include "kernel/units.h"

bool jlt_course_pole_is_off(const double *x, const jlt_descriptor *model, const jlt_units *units)
{
    double restored[JLT_PLAN_STATES_MAX];
    size_t index;

    jlt_units_restore(restored, x, model->states, model->state_count, units);
    return jlt_descriptor_check_state(model, restored, &index) == JLT_OK;
}

void jlt_course_pole_settle(jlt_course_row *row, double *states, const jlt_descriptor *model, const jlt_units *units, bool ends)
{
    double nearest = INFINITY;

    for (unsigned i = 0; i < model->pole_count; i++) {
        const unsigned k = model->poles[i].state;
        const jlt_quantity *q = &model->states[k];
        const int exponent = -jlt_units_exponent(units, q->unit);
        const double low = ldexp(q->low, exponent), high = ldexp(q->high, exponent), x = states[k];
        const double off = fmin(fabs(x - low), fabs(high - x)) / (high - low);
        states[k] = fmax(low, fmin(high, x)); /* a rounding error may exceed the end */
        if (!ends || off >= nearest) continue;
        nearest = off;
        row->fate = x - low > high - x ? JLT_FATE_POLE_PLUS : JLT_FATE_POLE_MINUS;
        row->pole = k;
    }
    if (row->fate != JLT_FATE_LEFT_DOMAIN) {
        const jlt_quantity *q = &model->states[row->pole];
        states[row->pole] = ldexp(row->fate == JLT_FATE_POLE_PLUS ? q->high : q->low, -jlt_units_exponent(units, q->unit));
    }
}

/* How far x is from the pole of a row, as a part of the interval of its state. */
static double distance(const jlt_course_row *row, const double *x, const jlt_descriptor *model, const jlt_units *units)
{
    const jlt_quantity *q = &model->states[row->pole];
    const double told = ldexp(x[row->pole], jlt_units_exponent(units, q->unit));

    return fabs(told - (row->fate == JLT_FATE_POLE_PLUS ? q->high : q->low)) / (q->high - q->low);
}

bool jlt_course_pole_is_passed(jlt_leg *leg, const jlt_course_row *row, double t, const jlt_descriptor *model,
                               const jlt_units *units, double tolerance)
{
    static const double near = 1e-3;
    const double room = fmin(0.1, fmax(1e-6, 1000 * tolerance));
    double x[JLT_PLAN_STATES_MAX], off[2];
    jlt_outcome outcome;
    unsigned edge;

    for (unsigned k = 0; k < 2; k++) {
        if (jlt_leg_to(leg, k == 0 ? t : t * (1 + room), &outcome, &edge) != JLT_OK || outcome.end != JLT_END_TIME) return false;
        jlt_tier_extract(&leg->view, x, leg->y);
        off[k] = distance(row, x, model, units);
    }
    return off[0] < near && off[1] > off[0];
}
