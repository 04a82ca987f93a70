#include "integrate/pole.h"

#include <math.h>

#include "ext/eigen.h"

enum { DIM_MAX = JLT_VARIATION_DIM_MAX };

/* Where the question is asked at all: the root and all rates this small, relative to scale. */
static const double near_root = 1e-8, near_rest = 1e-6;

static double size_of(const jlt_stepper *stepper, unsigned i)
{
    return (int)i == stepper->field->root ? 1 : fmax(fabs(stepper->x[i]), stepper->scale[i]);
}

/* df/dx by central differences where no kernel gives it: their error of 1e-10 is far below what separates rates from 0. */
static void jacobian(double *a, const jlt_field *field, const double *x)
{
    const unsigned n = field->dim;
    double shifted[DIM_MAX], ahead[DIM_MAX], behind[DIM_MAX];

    if (field->jacobian != NULL) {
        field->jacobian(x, field->p, a);
        return;
    }
    for (unsigned j = 0; j < n; j++) {
        const double step = 1e-5 * fmax(1, fabs(x[j]));
        for (unsigned i = 0; i < n; i++) shifted[i] = x[i];
        shifted[j] = x[j] + step;
        field->call(shifted, field->p, ahead);
        shifted[j] = x[j] - step;
        field->call(shifted, field->p, behind);
        for (unsigned i = 0; i < n; i++) a[i * n + j] = (ahead[i] - behind[i]) / (2 * step);
    }
}

/* Slowest rate of decay across the equilibria, or a value <= 0 when something grows. Eigenvalues that are 0 on the set of
 *  equilibria are of the order of the distance from it here. */
static jlt_status slowest_decay(double *kappa, const jlt_stepper *stepper)
{
    const jlt_field *field = stepper->field;
    double a[DIM_MAX * DIM_MAX], re[DIM_MAX], im[DIM_MAX], largest = 0;
    const jlt_status st = (jacobian(a, field, stepper->x), jlt_eigen_values(re, im, a, field->dim));
    if (st != JLT_OK) return st;

    for (unsigned i = 0; i < field->dim; i++) largest = fmax(largest, hypot(re[i], im[i]));
    *kappa = INFINITY;
    for (unsigned i = 0; i < field->dim; i++)
        if (hypot(re[i], im[i]) > 1e-5 * largest) *kappa = fmin(*kappa, -re[i] * stepper->direction);
    return JLT_OK;
}

jlt_status jlt_pole_judge(jlt_pole_verdict *out, const jlt_stepper *stepper, double left)
{
    const jlt_field *field = stepper->field;
    *out = (jlt_pole_verdict){ .ends = false };
    if (field->root < 0 || field->dim > DIM_MAX) return JLT_OK;

    const double s = stepper->x[field->root], rate = stepper->f[field->root];
    if (!(s < near_root)) return JLT_OK;
    double worst = 0;
    for (unsigned i = 0; i < field->dim; i++) worst = fmax(worst, fabs(stepper->f[i]) / size_of(stepper, i));
    if (!(worst < near_rest)) return JLT_OK;
    const double mu = s > 0 ? -rate / s * stepper->direction : INFINITY;
    if (!(mu > 0) || !(worst <= 10 * left * mu)) return JLT_OK;

    const jlt_status st = slowest_decay(&out->kappa, stepper);
    if (st != JLT_OK) return st;
    out->mu = mu;
    out->ends = worst <= left * out->kappa; /* never where something grows, kappa < 0 */
    out->t_end = jlt_stepper_time(stepper) + (s > 0 ? stepper->direction * s / mu : 0);
    return JLT_OK;
}
