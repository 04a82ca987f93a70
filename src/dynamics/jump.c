#include "dynamics/jump.h"

#include <math.h>
#include <string.h>

enum {
    N = JLT_CHART_STATES_MAX,
    SOON = 4,    /* steps after they became shorter: before a jump they grow again until one is rejected, or leads across */
    HALVINGS = 4 /* of a step: a rate that is smooth, and was integrated as smooth, shows it within a sixteenth of the step */
};

/* A rate that is smooth over a step changes by at most so many times what its tangent, the Jacobian times the field, predicts. */
static const double more = 16;
/* Part of the field and of the terms of its rates below which a change is rounding, or too small a jump to matter. */
static const double noise = 1e-8;

/* An end of a part of the step: the state there, and field and Jacobian, shape (n + n*n,). */
typedef struct {
    double x[N], both[N * (1 + N)];
} end;

/* The change in the time h of rate i by the Jacobian. */
static double tangent(const end *at, unsigned n, unsigned i, double h)
{
    double sum = 0;

    for (unsigned j = 0; j < n; j++) sum += at->both[n + i * n + j] * at->both[j];
    return fabs(sum * h);
}

/* Whether rate i changes by more than is explained, in the time h between two ends. */
static bool is_unexplained(const end *from, const end *to, unsigned n, unsigned i, double h)
{
    const double explained = fmax(tangent(from, n, i, h), tangent(to, n, i, h));
    double terms = 0;

    for (unsigned j = 0; j < n; j++) terms = fmax(terms, fmax(fabs(from->both[j]), fabs(to->both[j])));
    for (unsigned j = 0; j < n; j++) terms += fabs(to->both[n + i * n + j] * to->x[j]);
    return fabs(to->both[i] - from->both[i]) > more * explained + noise * terms;
}

/* Whether rate i jumps within a step that does not explain its change: nor does one half of the step, a half of that, and so on. */
static bool jumps(const end ends[2], const jlt_varied *varied, unsigned i, double h)
{
    const unsigned n = varied->plain->dim;
    end from = ends[0], to = ends[1], middle;
    bool is_jump = true;

    for (int k = 0; k < HALVINGS && is_jump; k++) {
        for (unsigned j = 0; j < n; j++) middle.x[j] = from.x[j] + (to.x[j] - from.x[j]) / 2;
        jlt_varied_linear(varied, middle.x, middle.both);
        h /= 2;
        *(fabs(middle.both[i] - from.both[i]) > fabs(to.both[i] - middle.both[i]) ? &to : &from) = middle;
        is_jump = is_unexplained(&from, &to, n, i, h);
    }
    return is_jump;
}

bool jlt_jump_is_behind(jlt_jump_watch *self, const jlt_stepper *stepper, const jlt_varied *varied)
{
    const unsigned n = varied->plain->dim;
    end ends[2];

    const double length = fabs(stepper->h);
    const bool is_shorter = stepper->rejected != self->rejected && !(length >= self->length / 2 && self->length > 0);
    self->calm = is_shorter ? 0 : self->calm + (self->calm <= SOON);
    self->rejected = stepper->rejected;
    self->length = length;
    if (self->calm > SOON && !jlt_stepper_is_held(stepper)) return false;
    memcpy(ends[0].x, stepper->x_start, n * sizeof *stepper->x_start);
    memcpy(ends[1].x, stepper->x, n * sizeof *stepper->x);
    for (int k = 0; k < 2; k++) jlt_varied_linear(varied, ends[k].x, ends[k].both);
    for (unsigned i = 0; i < n; i++)
        if (is_unexplained(&ends[0], &ends[1], n, i, stepper->h) && jumps(ends, varied, i, stepper->h)) return true;
    return false;
}
