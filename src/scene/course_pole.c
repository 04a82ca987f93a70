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
