#include "dynamics/jump.h"

enum { N = JLT_CHART_STATES_MAX };

/* Of what is smooth over a step, the rate's change is that of its tangent: the Jacobian times the field. */
static const double more = 16;
/* Part of the field and of the terms of its rates below which a change is rounding, or too small a jump to matter. */
static const double noise = 1e-8;

/* The change in the time h of rate i by the Jacobian, both: field and Jacobian, shape (n + n*n,). */
static double tangent(const double *both, unsigned n, unsigned i, double h)
{
    double sum = 0;

    for (unsigned j = 0; j < n; j++) sum += both[n + i * n + j] * both[j];
    return fabs(sum * h);
}

bool jlt_jump_is_behind(const jlt_stepper *stepper, const jlt_varied *varied)
{
    const unsigned n = varied->plain->dim;
    double from[N * (1 + N)], to[N * (1 + N)], fastest = 0;

    if (!jlt_stepper_is_held(stepper)) return false;
    jlt_varied_linear(varied, stepper->x_start, from);
    jlt_varied_linear(varied, stepper->x, to);
    for (unsigned i = 0; i < n; i++) fastest = fmax(fastest, fmax(fabs(from[i]), fabs(to[i])));
    for (unsigned i = 0; i < n; i++) {
        double terms = fastest;
        for (unsigned j = 0; j < n; j++) terms += fabs(to[n + i * n + j] * stepper->x[j]);
        const double explained = fmax(tangent(from, n, i, stepper->h), tangent(to, n, i, stepper->h));
        if (fabs(to[i] - from[i]) > more * explained + noise * terms) return true;
    }
    return false;
}
