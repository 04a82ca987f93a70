#include "analysis/density.h"

#include "ext/quadrature.h"
#include "kernel/kernel.h"
#include "kernel/region.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { SIZE = 64, PLACES = 40, DRAWS = 12, TRIES = 200 };

static double bounded(double low, double high, jlt_random *random)
{
    const double middle = low / 2 + high / 2, half = high / 2 - low / 2;
    double part = 2.0 * jlt_random_unit(random) - 1.0;

    if (jlt_random_below(random, 4) == 0) part = copysign(1.0 - jlt_random_magnitude(random, -4, -1), part);
    return middle + half * part;
}

void jlt_density_draw_state(double *x, const jlt_descriptor *descriptor, const double *prepared, jlt_random *random)
{
    double low[JLT_REGION_STATES_MAX], high[JLT_REGION_STATES_MAX];

    jlt_region_intervals(low, high, descriptor, prepared);
    for (unsigned i = 0; i < descriptor->state_count; i++) {
        const double magnitude = jlt_random_magnitude(random, -1, 1);
        if (isfinite(low[i]) && isfinite(high[i])) x[i] = bounded(low[i], high[i], random);
        else if (isfinite(low[i])) x[i] = low[i] + magnitude;
        else if (isfinite(high[i])) x[i] = high[i] - magnitude;
        else x[i] = jlt_random_below(random, 2) == 0 ? magnitude : -magnitude;
    }
}

/* -div f / f_q at x. Errors: DOMAIN if div f does not vanish and f_q does, or is so small that the quotient overflows. */
static jlt_status ratio_at(double *ratio, const jlt_instance *instance, size_t along, const double *x)
{
    double f[SIZE], divergence;

    JLT_PASS(jlt_instance_rhs(instance, f, x));
    JLT_PASS(jlt_instance_divergence(instance, &divergence, x));
    if (divergence == 0.0) *ratio = 0.0;
    else if (f[along] == 0.0) return JLT_ERR_DOMAIN;
    else *ratio = -divergence / f[along];
    return isfinite(*ratio) ? JLT_OK : JLT_ERR_DOMAIN;
}

jlt_status jlt_density_defect(double *defect, const jlt_instance *instance, size_t along, jlt_random *random)
{
    const jlt_descriptor *d = instance->descriptor;
    double widest = 0.0, largest = 0.0;
    size_t used = 0, blocked = 0;

    if (d->divergence.call == NULL || d->state_count > SIZE || along >= d->state_count) return JLT_ERR_UNSUPPORTED;
    for (int place = 0; place < PLACES; place++) {
        double x[SIZE], low = INFINITY, high = -INFINITY, q;
        int found = 0;
        jlt_density_draw_state(x, d, instance->prepared, random);
        q = x[along];
        for (int attempt = 0; found < DRAWS && attempt < TRIES; attempt++) {
            double ratio;
            jlt_status st;
            jlt_density_draw_state(x, d, instance->prepared, random);
            x[along] = q;
            st = ratio_at(&ratio, instance, along, x);
            if (st == JLT_ERR_DOMAIN) blocked++;
            if (st != JLT_OK) continue;
            low = fmin(low, ratio);
            high = fmax(high, ratio);
            found++;
        }
        if (found < 2) continue;
        used++;
        widest = fmax(widest, high - low);
        largest = fmax(largest, fmax(fabs(low), fabs(high)));
    }
    if (used == 0 && blocked == 0) return JLT_ERR_NO_CONVERGENCE;
    *defect = used == 0 ? 2.0 : largest > 0.0 ? widest / largest : 0.0;
    return JLT_OK;
}

typedef struct {
    const jlt_instance *instance;
    size_t along;
    double x[SIZE];
} line;

static jlt_status slope(void *context, double *value, double at)
{
    line *l = context;

    l->x[l->along] = at;
    return ratio_at(value, l->instance, l->along, l->x);
}

jlt_status jlt_density_tabulate(jlt_density_point *points, size_t count, const jlt_instance *instance, size_t along,
                                double low, double high, const double *x)
{
    const size_t middle = count / 2;
    line l = { .instance = instance, .along = along };

    if (count == 0 || instance->descriptor->state_count > SIZE || along >= instance->descriptor->state_count) return JLT_ERR_ARG;
    memcpy(l.x, x, instance->descriptor->state_count * sizeof *x);
    for (size_t i = 0; i < count; i++) {
        const double part = count == 1 ? 0.5 : (double)i / (double)(count - 1);
        points[i] = (jlt_density_point){ low * (1.0 - part) + high * part, 1.0, 0.0 };
    }
    /* Integrate outwards from the middle, each point from its neighbour. */
    for (size_t k = 1; k < count; k++) {
        const bool up = middle + k < count;
        for (int side = 0; side < 2; side++) {
            double integral, error;
            size_t i, from;
            if (side == 0 ? !up : k > middle) continue;
            i = side == 0 ? middle + k : middle - k;
            from = side == 0 ? i - 1 : i + 1;
            JLT_PASS(jlt_quadrature_integrate(&integral, &error, slope, &l, points[from].at, points[i].at, 1e-15, 1e-13));
            points[i].density = points[from].density * exp(integral);
            points[i].error = points[from].error + error + (integral != 0 ? DBL_EPSILON : 0); /* of exp and the product */
            if (!(points[i].density > 0) || isinf(points[i].density)) return JLT_ERR_NONFINITE;
        }
    }
    return JLT_OK;
}

/* The size of the terms of div f and of f . grad ln rho before anything cancels. */
static jlt_status size_of_terms(double *size, const jlt_instance *instance, const double *x)
{
    const unsigned n = instance->descriptor->state_count;
    double f[SIZE], jacobian[SIZE * SIZE];

    JLT_PASS(jlt_instance_rhs(instance, f, x));
    JLT_PASS(jlt_instance_jacobian(instance, jacobian, x));
    *size = 0.0;
    for (unsigned i = 0; i < n; i++) *size += fabs(jacobian[i * n + i]) + fabs(f[i] / x[i]);
    return JLT_OK;
}

jlt_status jlt_density_residual(double *residual, const jlt_instance *instance, size_t samples, jlt_random *random)
{
    const jlt_descriptor *d = instance->descriptor;
    double worst[SIZE] = { 0 }, x[SIZE], density[SIZE], divergence[SIZE], size;
    size_t used = 0;

    if (d->measure_count > SIZE || d->state_count > SIZE) return JLT_ERR_UNSUPPORTED;
    if (d->measure_count == 0) return JLT_OK;
    if (d->jacobian.call == NULL) return JLT_ERR_UNSUPPORTED;
    for (size_t k = 0; k < samples; k++) {
        jlt_density_draw_state(x, d, instance->prepared, random);
        if (size_of_terms(&size, instance, x) != JLT_OK ||
            jlt_kernel_eval(density, &d->measure_values, x, d->state_count, instance->prepared) != JLT_OK ||
            jlt_kernel_eval(divergence, &d->measure_divergences, x, d->state_count, instance->prepared) != JLT_OK)
            continue;
        used++;
        for (unsigned i = 0; i < d->measure_count; i++)
            if (divergence[i] != 0.0) worst[i] = fmax(worst[i], fabs(divergence[i] / (density[i] * size)));
    }
    if (used == 0) return JLT_ERR_NO_CONVERGENCE;
    memcpy(residual, worst, d->measure_count * sizeof *residual);
    return JLT_OK;
}
