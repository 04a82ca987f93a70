#include "integrate/approach.h"

#include <math.h>

#include "ext/eigen.h"

enum { DIM_MAX = JLT_JACOBIAN_DIM_MAX };

static const double rounding = 1e-16;
static const double nothing = 1e-40; /* relative size of entries set to 0: a root may be 1e-180, which eigenvalue solvers fail on */

double jlt_approach_size(const jlt_stepper *stepper, unsigned i)
{
    return (int)i == stepper->field->root ? 1 : fmax(fabs(stepper->x[i]), jlt_stepper_unit(stepper, i));
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

/* List the states that move, or whose rates depend on such states, in order. Returns their number. */
static unsigned moving_states(unsigned *moving, const double *a, const double *f, unsigned n)
{
    bool moves[DIM_MAX];
    unsigned count = 0;

    for (unsigned i = 0; i < n; i++) moves[i] = f[i] != 0;
    for (bool more = true; more;) {
        more = false;
        for (unsigned i = 0; i < n; i++)
            for (unsigned j = 0; j < n && !moves[i]; j++) more |= moves[i] = moves[j] && a[i * n + j] != 0;
    }
    for (unsigned i = 0; i < n; i++)
        if (moves[i]) moving[count++] = i;
    return count;
}

/* Find the slowest and the fastest rate of decay across the set of equilibria, and the number of rates. slowest <= 0: something
 * grows. Eigenvalues along the set, which are 0 on it, are of the order of the distance from it here, and left out. */
static jlt_status rates(double *slowest, double *fastest, unsigned *count, const double *a, unsigned n, double direction)
{
    double re[DIM_MAX], im[DIM_MAX];
    JLT_PASS(jlt_eigen_values(re, im, a, n));

    *fastest = *count = 0;
    *slowest = INFINITY;
    for (unsigned i = 0; i < n; i++) *fastest = fmax(*fastest, hypot(re[i], im[i]));
    for (unsigned i = 0; i < n; i++) {
        if (hypot(re[i], im[i]) <= 1e-5 * *fastest) continue;
        *slowest = fmin(*slowest, -re[i] * direction);
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

/* Find the remaining displacement y, a y = f, in the decaying subspace, which a f, a^2 f, ... span, `count` of them; f itself has
 * a part of second order along the equilibria, where a is 0. Equation i counts by importance[i]. Singular values below 1e-9 of the
 * largest are rounding. */
static jlt_status way_left(double *y, const double *a, const double *f, const double *importance, unsigned n, unsigned count,
                           double fastest)
{
    double power[DIM_MAX][DIM_MAX], system[DIM_MAX * DIM_MAX], weight[DIM_MAX], right[DIM_MAX];

    multiply(power[0], a, f, n, 1 / fastest);
    for (unsigned k = 1; k < count; k++) multiply(power[k], a, power[k - 1], n, 1 / fastest);
    for (unsigned k = 0; k < count; k++) {
        double image[DIM_MAX];
        multiply(image, a, power[k], n, 1 / fastest);
        for (unsigned i = 0; i < n; i++) system[i * count + k] = importance[i] * image[i];
    }
    for (unsigned i = 0; i < n; i++) right[i] = importance[i] * f[i];
    const jlt_status st = jlt_eigen_least_squares(weight, system, right, n, count, 1e-9);
    for (unsigned i = 0; i < n; i++) {
        y[i] = 0;
        for (unsigned k = 0; st == JLT_OK && k < count; k++) y[i] += weight[k] * power[k][i] / fastest;
    }
    return st;
}

bool jlt_approach_is_near(const jlt_field *field, const double *x, double size, double distance)
{
    static const double singular = 1e-9;
    double a[DIM_MAX * DIM_MAX], f[JLT_FIELD_DIM_MAX], y[DIM_MAX], image[DIM_MAX], slowest, fastest, nearest = 0, most = 0;
    const unsigned n = field->dim;
    unsigned count;

    field->call(x, field->p, f);
    for (unsigned i = 0; i < n; i++) most = fmax(most, fabs(f[i]));
    if (n > DIM_MAX) return most <= distance * size;
    if (most == 0) return true;
    jacobian(a, field, x);
    jlt_status st = rates(&slowest, &fastest, &count, a, n, 1);
    if (st == JLT_OK) st = jlt_eigen_least_squares(y, a, f, n, n, singular);
    if (st != JLT_OK) return st != JLT_ERR_NONFINITE;
    multiply(image, a, y, n, 1);
    for (unsigned i = 0; i < n; i++) nearest = fmax(nearest, fabs(y[i]) / fmax(fabs(x[i]), size));
    for (unsigned i = 0; i < n; i++) {
        double terms = fastest * size; /* not fastest |x_i|: the phase of a forcing grows, and its rate is the same for ever */
        for (unsigned j = 0; j < n; j++) terms += fabs(a[i * n + j] * x[j]);
        const double second_order = nearest * nearest * fastest * fmax(fabs(x[i]), size);
        if (fabs(image[i] - f[i]) > fmax(8 * rounding * terms, second_order)) return false;
    }
    return nearest <= distance;
}

bool jlt_approach_is_known(const jlt_approach *self, const jlt_stepper *stepper)
{
    const double negligible = fmax(rounding, stepper->asked / 100);
    return self->decays && self->longest * self->longest * self->fastest <= negligible * self->slowest;
}

jlt_status jlt_approach_judge(jlt_approach *out, const jlt_stepper *stepper)
{
    const jlt_field *field = stepper->field;
    double whole[DIM_MAX * DIM_MAX], a[DIM_MAX * DIM_MAX], f[DIM_MAX], y[DIM_MAX], image[DIM_MAX], importance[DIM_MAX];
    double largest = 0, defect = 0, slope = 0;
    unsigned moving[DIM_MAX], count;

    *out = (jlt_approach){ .decays = false };
    if (field->dim > DIM_MAX) return JLT_OK;
    jacobian(whole, field, stepper->x);
    const unsigned n = moving_states(moving, whole, stepper->f, field->dim);
    if (n == 0) return JLT_OK;
    for (unsigned i = 0; i < n; i++) {
        f[i] = stepper->f[moving[i]];
        slope = fmax(slope, fabs(f[i]));
        for (unsigned j = 0; j < n; j++) {
            a[i * n + j] = whole[moving[i] * field->dim + moving[j]];
            largest = fmax(largest, fabs(a[i * n + j]));
        }
    }
    for (unsigned i = 0; i < n * n; i++)
        if (fabs(a[i]) < nothing * largest) a[i] = 0;
    JLT_PASS(rates(&out->slowest, &out->fastest, &count, a, n, stepper->direction));
    if (!(out->slowest > 0) || count == 0) return JLT_OK;
    /* That of the root holds relative to the root, which may push another state a million times as far. */
    for (unsigned i = 0; i < n; i++)
        importance[i] = (int)moving[i] == field->root && fabs(f[i]) > nothing * slope ? slope / fabs(f[i]) : 1;
    JLT_PASS(way_left(y, a, f, importance, n, count, out->fastest));
    multiply(image, a, y, n, 1);
    for (unsigned i = 0; i < n; i++) {
        out->left[moving[i]] = y[i];
        out->longest = fmax(out->longest, fabs(y[i]) / jlt_approach_size(stepper, moving[i]));
        const double rest = fabs(image[i] - f[i]);
        defect = fmax(defect, rest);
        if ((int)moving[i] == field->root) out->root_left_out = rest / out->slowest;
    }
    out->decays = defect <= 1e-3 * slope;
    return JLT_OK;
}
