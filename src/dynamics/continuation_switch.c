/* Finds the first point of the other branch at a period doubling or a branch point. */
#include "dynamics/continuation_step.h"

#include <math.h>
#include <string.h>

#include "dynamics/linear.h"

enum { U = JLT_CONTINUATION_U, HALVINGS = 12 };

/* The direction of the other branch: at a period doubling the eigenvector of -1, at a branch point the null vector of the
 * rank-one Jacobian (2, 3) that is orthogonal to the tangent: the cross product of its longer row with the tangent. */
static void other_direction(double *direction, const jlt_continuation_equation *at, const jlt_continuation_point *point)
{
    const double *first = at->jacobian, *second = at->jacobian + 3, *row, *t = point->tangent;

    if (point->kind == JLT_BIFURCATION_DOUBLING) {
        jlt_linear_eigenvector(direction, at->slope, -1);
        direction[2] = 0;
        return;
    }
    row = fabs(first[0]) + fabs(first[1]) + fabs(first[2]) > fabs(second[0]) + fabs(second[1]) + fabs(second[2]) ? first
                                                                                                               : second;
    direction[0] = row[1] * t[2] - row[2] * t[1];
    direction[1] = row[2] * t[0] - row[0] * t[2];
    direction[2] = row[0] * t[1] - row[1] * t[0];
    const double length = jlt_linear_length(direction, 3);
    direction[0] /= length, direction[1] /= length, direction[2] /= length;
}

jlt_status jlt_continuation_switch(jlt_continuation_point *out, const jlt_family *family,
                                   const jlt_continuation_point *at, int side, double offset,
                                   const jlt_continuation_options *options)
{
    jlt_continuation_runner self = { .family = family, .options = jlt_continuation_step_defaults(options),
                                     .period = at->orbit.period };
    double u[U] = { 0 }, origin[U], direction[U] = { 0 };
    jlt_continuation_equation here;
    jlt_status st = JLT_OK;

    if ((side != 1 && side != -1) || !(offset > 0)) return JLT_ERR_ARG;
    if (at->kind != JLT_BIFURCATION_BRANCH && at->kind != JLT_BIFURCATION_DOUBLING) return JLT_ERR_ARG;
    JLT_PASS(jlt_continuation_step_open(&self, at->value));
    if (self.d != 2) return JLT_ERR_ARG;
    jlt_chart_scaled(&self.chart, u, at->orbit.points);
    u[2] = at->value / self.options.scale;
    JLT_PASS(jlt_continuation_step_evaluate(&self, &here, u));
    other_direction(direction, &here, at);
    if (at->kind == JLT_BIFURCATION_DOUBLING) self.period *= 2;
    memcpy(origin, u, sizeof origin);
    for (unsigned i = 0; i < 3; i++) direction[i] *= side;
    for (unsigned halving = 0; halving < HALVINGS; halving++, offset /= 2) {
        for (unsigned i = 0; i < 3; i++) u[i] = origin[i] + offset * direction[i];
        st = jlt_continuation_step_correct(&self, u, &here, direction, NULL);
        if (st == JLT_ERR_NOMEM || st == JLT_OK) break;
    }
    JLT_PASS(st);
    return jlt_continuation_step_measure(&self, out, u, direction, 0, JLT_BIFURCATION_NONE);
}
