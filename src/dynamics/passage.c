#include "dynamics/passage.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "ext/eigen.h"

enum { N = JLT_CHART_STATES_MAX };
static const double like = 16;           /* sizes of one kind of state differ by less than this factor */
static const double finest = 0x1p-40;    /* part of a state below which it is less than rounding errors of others */

/* Scale balanced sizes so that every one is at most as large as the states of its kind count. */
static void fit(double *size, const double *counted, unsigned n)
{
    double factor = INFINITY;

    for (unsigned i = 0; i < n; i++) {
        double kind = 0;
        for (unsigned j = 0; j < n; j++)
            if (size[j] < like * size[i] && size[i] < like * size[j]) kind = fmax(kind, counted[j] / size[j]);
        factor = fmin(factor, kind);
    }
    for (unsigned i = 0; i < n; i++) size[i] = fmax(size[i] * factor, finest * counted[i]);
}

/* Cap the size of a state that no other state drives, or only such states do, as of a clock and of what only the clock drives:
 * balancing leaves it as it is, whatever the sizes of others. */
static void cap(double *size, const double *counted, const double *jacobian, unsigned n)
{
    bool alone[N] = { false };

    for (unsigned at = 0; at < n * n; at++) {
        const unsigned i = at % n;
        bool driven = false;
        for (unsigned j = 0; j < n; j++) driven = driven || (j != i && !alone[j] && jacobian[i * n + j] != 0);
        alone[i] = !driven;
        if (alone[i]) size[i] = fmin(size[i], counted[i]);
    }
}

jlt_status jlt_passage_keep(jlt_orbit *orbit, const jlt_varied *varied)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    const unsigned n = varied->plain->dim;
    double both[N * (1 + N)], size[N], counted[N], x[JLT_VARIED_DIM_MAX], scale[JLT_VARIED_DIM_MAX], speed = 0;

    memcpy(x, stepper->x, varied->field.dim * sizeof *x);
    jlt_varied_linear(varied, x, both);
    JLT_PASS(jlt_eigen_balance(size, both + n, n));
    for (unsigned i = 0; i < n; i++) {
        const double declared = varied->scale[i] == 1 && i < varied->field.sized ? stepper->size : varied->scale[i];
        counted[i] = fmax(fabs(x[i]), fmax(declared, JLT_STEPPER_SCALE_LEAST));
    }
    fit(size, counted, n);
    cap(size, counted, both + n, n);
    for (unsigned i = 0; i < n; i++) speed += both[i] / size[i] * (both[i] / size[i]);
    for (unsigned i = 0; i < n; i++) /* relative errors stay so */
        scale[i] = varied->scale[i] > 0 ? size[i] : JLT_STEPPER_SCALE_LEAST;
    scale[varied->field.dim - 1] = 1;
    for (unsigned k = 1; k <= varied->tangents; k++) {
        double *y = x + k * n, along = 0, largest = 0;
        for (unsigned i = 0; speed > 0 && i < n; i++) along += y[i] / size[i] * (both[i] / size[i]) / speed;
        for (unsigned i = 0; i < n; i++) {
            y[i] -= along * both[i];
            largest = fmax(largest, fabs(y[i]) / size[i]);
        }
        for (unsigned i = 0; i < n; i++)
            scale[k * n + i] = fmax(varied->scale[k * n + i] * largest * size[i], JLT_STEPPER_SCALE_LEAST);
    }
    return jlt_orbit_replace(orbit, x, scale);
}
