/* Hand-written fields with known solutions, and Taylor coefficients (jets) of some. */
#ifndef JLT_TESTS_SAMPLE_FIELDS_H
#define JLT_TESTS_SAMPLE_FIELDS_H

#include <math.h>

/* x'' = -x: (cos t, -sin t) from (1, 0). */
static inline void oscillator(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)p;
    f[0] = x[1];
    f[1] = -x[0];
}

/* Plane Kepler problem: x, y, vx, vy. */
static inline void kepler(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)p;
    const double r2 = x[0] * x[0] + x[1] * x[1], pull = -1 / (r2 * sqrt(r2));
    f[0] = x[2];
    f[1] = x[3];
    f[2] = pull * x[0];
    f[3] = pull * x[1];
}

/* Taylor coefficients of its solution, c, shape (order + 1, 4): with u = x^2 + y^2 and w = u^(-3/2), u w' = -(3/2) w u'. */
static inline void kepler_jet(const double *x, const double *p, unsigned order, double *c)
{
    (void)p;
    double u[48], w[48];
    for (unsigned i = 0; i < 4; i++) c[i] = x[i];
    for (unsigned k = 0; k < order; k++) {
        u[k] = 0;
        for (unsigned j = 0; j <= k; j++) u[k] += c[j * 4] * c[(k - j) * 4] + c[j * 4 + 1] * c[(k - j) * 4 + 1];
        if (k == 0) {
            w[0] = 1 / (u[0] * sqrt(u[0]));
        } else {
            double sum = 0;
            for (unsigned j = 0; j < k; j++) sum += (-1.5 * (k - j) - j) * u[k - j] * w[j];
            w[k] = sum / (k * u[0]);
        }
        double ax = 0, ay = 0;
        for (unsigned j = 0; j <= k; j++) {
            ax -= w[j] * c[(k - j) * 4];
            ay -= w[j] * c[(k - j) * 4 + 1];
        }
        c[(k + 1) * 4] = c[k * 4 + 2] / (k + 1);
        c[(k + 1) * 4 + 1] = c[k * 4 + 3] / (k + 1);
        c[(k + 1) * 4 + 2] = ax / (k + 1);
        c[(k + 1) * 4 + 3] = ay / (k + 1);
    }
}

/* Lorenz's system, p = sigma, rho, beta. */
static inline void lorenz(const double *restrict x, const double *restrict p, double *restrict f)
{
    f[0] = p[0] * (x[1] - x[0]);
    f[1] = x[0] * (p[1] - x[2]) - x[1];
    f[2] = x[0] * x[1] - p[2] * x[2];
}

static inline void lorenz_jet(const double *x, const double *p, unsigned order, double *c)
{
    for (unsigned i = 0; i < 3; i++) c[i] = x[i];
    for (unsigned k = 0; k < order; k++) {
        double xz = 0, xy = 0;
        for (unsigned j = 0; j <= k; j++) {
            xz += c[j * 3] * c[(k - j) * 3 + 2];
            xy += c[j * 3] * c[(k - j) * 3 + 1];
        }
        const double *at = c + k * 3;
        double *next = c + (k + 1) * 3;
        next[0] = p[0] * (at[1] - at[0]) / (k + 1);
        next[1] = (p[1] * at[0] - xz - at[1]) / (k + 1);
        next[2] = (xy - p[2] * at[2]) / (k + 1);
    }
}

/* The restricted three-body problem in the rotating frame: x, y, x', y'; p = mu. */
static inline void arenstorf(const double *restrict x, const double *restrict p, double *restrict f)
{
    const double mu = p[0], nu = 1 - mu;
    const double a = (x[0] + mu) * (x[0] + mu) + x[1] * x[1], b = (x[0] - nu) * (x[0] - nu) + x[1] * x[1];
    const double pa = nu / (a * sqrt(a)), pb = mu / (b * sqrt(b));
    f[0] = x[2];
    f[1] = x[3];
    f[2] = x[0] + 2 * x[3] - pa * (x[0] + mu) - pb * (x[0] - nu);
    f[3] = x[1] - 2 * x[2] - pa * x[1] - pb * x[1];
}

/* x' = x^2, with the solution 1/(1 - t) from 1, infinite at t = 1. */
static inline void blow_up(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)p;
    f[0] = x[0] * x[0];
}

#endif
