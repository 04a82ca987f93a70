#include "integrate/pole.h"

#include <math.h>

#include "ext/eigen.h"

enum { DIM_MAX = JLT_JACOBIAN_DIM_MAX };

/* Where the question is asked at all: the root and all rates this small, relative to scale. */
static const double near_root = 1e-8, near_rest = 1e-6;
static const double rounding = 1e-16;

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

/* Slowest and fastest rate across the equilibria, and how many there are. A slowest rate <= 0: something grows. Eigenvalues
 * that are 0 on the set of equilibria are of the order of the distance from it here. */
static jlt_status rates(double *slowest, double *fastest, unsigned *count, const double *a, const jlt_stepper *stepper)
{
    const unsigned n = stepper->field->dim;
    double re[DIM_MAX], im[DIM_MAX];
    const jlt_status st = jlt_eigen_values(re, im, a, n);
    if (st != JLT_OK) return st;

    *fastest = *count = 0;
    *slowest = INFINITY;
    for (unsigned i = 0; i < n; i++) *fastest = fmax(*fastest, hypot(re[i], im[i]));
    for (unsigned i = 0; i < n; i++) {
        if (hypot(re[i], im[i]) <= 1e-5 * *fastest) continue;
        *slowest = fmin(*slowest, -re[i] * stepper->direction);
        ++*count;
    }
    return JLT_OK;
}

static void multiply(double *out, const double *a, const double *x, unsigned n, double factor)
{
    for (unsigned i = 0; i < n; i++) {
        out[i] = 0;
        for (unsigned j = 0; j < n; j++) out[i] += factor * a[i * n + j] * x[j];
    }
}

/* The way left, y with a y = f in the space of what decays: that is spanned by f, a f, a^2 f, ..., as many as there are
 * rates. Below a part of 1e-9 such a vector is rounding. */
static jlt_status way_left(double *y, const double *a, const double *f, unsigned n, unsigned count, double fastest)
{
    double power[DIM_MAX][DIM_MAX], system[DIM_MAX * DIM_MAX], weight[DIM_MAX];

    for (unsigned i = 0; i < n; i++) power[0][i] = f[i];
    for (unsigned k = 1; k < count; k++) multiply(power[k], a, power[k - 1], n, 1 / fastest);
    for (unsigned k = 0; k < count; k++) {
        double image[DIM_MAX];
        multiply(image, a, power[k], n, 1 / fastest);
        for (unsigned i = 0; i < n; i++) system[i * count + k] = image[i];
    }
    const jlt_status st = jlt_eigen_least_squares(weight, system, f, n, count, 1e-9);
    for (unsigned i = 0; i < n; i++) {
        y[i] = 0;
        for (unsigned k = 0; st == JLT_OK && k < count; k++) y[i] += weight[k] * power[k][i] / fastest;
    }
    return st;
}

jlt_status jlt_pole_judge(jlt_pole_verdict *out, const jlt_stepper *stepper)
{
    const jlt_field *field = stepper->field;
    double a[DIM_MAX * DIM_MAX], image[DIM_MAX], fastest, longest = 0, defect = 0, slope = 0;
    unsigned count;
    jlt_status st;

    out->ends = false;
    if (field->root < 0 || field->dim > DIM_MAX) return JLT_OK;

    const double s = stepper->x[field->root], rate = stepper->f[field->root];
    if (!(s < near_root)) return JLT_OK;
    for (unsigned i = 0; i < field->dim; i++)
        if (!(fabs(stepper->f[i]) < near_rest * size_of(stepper, i))) return JLT_OK;
    out->mu = s > 0 ? -rate / s * stepper->direction : INFINITY;
    if (!(out->mu > 0)) return JLT_OK;

    jacobian(a, field, stepper->x);
    st = rates(&out->kappa, &fastest, &count, a, stepper);
    if (st != JLT_OK || !(out->kappa > 0) || count == 0) return st;
    st = way_left(out->left, a, stepper->f, field->dim, count, fastest);
    if (st != JLT_OK) return st;
    multiply(image, a, out->left, field->dim, 1);
    for (unsigned i = 0; i < field->dim; i++) {
        longest = fmax(longest, fabs(out->left[i]) / size_of(stepper, i));
        defect = fmax(defect, fabs(image[i] - stepper->f[i]));
        slope = fmax(slope, fabs(stepper->f[i]));
    }
    const double negligible = fmax(rounding, stepper->tolerance / 100);
    out->ends = defect <= 1e-3 * slope && longest * longest * fastest <= negligible * out->kappa;
    out->t_end = jlt_stepper_time(stepper) + (s > 0 ? stepper->direction * s / out->mu : 0);
    return JLT_OK;
}
