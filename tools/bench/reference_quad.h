/* The section flow in quadruple precision, for the programs that write reference data; independent of everything else here.
 *
 * Field: (3.2) of Kilin & Ivanova (2023), parameters (5.1), multiplied by s and written in (gamma3, s) together. Method:
 * extrapolated modified midpoint rule (Gragg, Bulirsch, Stoer), 14 rows, to be used with error of the last two columns below
 * 1e-30 of scale. */
#ifndef JLT_BENCH_REFERENCE_QUAD_H
#define JLT_BENCH_REFERENCE_QUAD_H

#include <quadmath.h>
#include <stdio.h>
#include <stdlib.h>

typedef __float128 quad;

enum { STATES = 7, ROWS = 14 }; /* gamma3, v_nu, omega_tau, omega_n, omega3, s, t */

static const quad m = 1, R = 1, g = 1;
static quad I1, I3, a3, E, G;

static void field(const quad *x, quad *f)
{
    quad gamma = x[0], v = x[1], wt = x[2], wn = x[3], w3 = x[4], s = x[5];
    quad b = a3 + R * gamma, e = R + a3 * gamma;
    quad Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b, D = I1 + m * a3 * a3 * s * s;
    quad V = e * wt + v, spread = R * gamma * (I1 - I3) - a3 * I3;
    f[0] = s * s * wt;
    f[1] = wn * (b * wn + R * s * w3);
    f[2] = (m * a3 * s * s * (a3 * gamma * wt * wt - g) - wn * (I1 * gamma * wn + I3 * s * w3)) / D;
    f[3] = gamma * wn * wt - m * I3 * b * wn * V / Theta + s * I3 * w3 * wt * (I3 + m * R * e) / Theta;
    f[4] = s * (-m * R * I1 * wn * V + m * R * s * w3 * wt * spread) / Theta;
    f[5] = -gamma * s * wt;
    f[6] = s;
}

static void midpoint(const quad *x, quad h, int n, quad *y)
{
    quad before[STATES], now[STATES], f[STATES], step = h / n;
    field(x, f);
    for (int i = 0; i < STATES; i++) {
        before[i] = x[i];
        now[i] = x[i] + step * f[i];
    }
    for (int k = 1; k < n; k++) {
        field(now, f);
        for (int i = 0; i < STATES; i++) {
            quad next = before[i] + 2 * step * f[i];
            before[i] = now[i];
            now[i] = next;
        }
    }
    field(now, f);
    for (int i = 0; i < STATES; i++) y[i] = (now[i] + before[i] + step * f[i]) / 2;
}

/* One extrapolated step; returns the difference of the last two diagonal entries. */
static quad extrapolate(const quad *x, quad h, quad *y)
{
    static quad table[ROWS][ROWS][STATES];
    quad error = 0;
    for (int j = 0; j < ROWS; j++) {
        midpoint(x, h, 2 * (j + 1), table[j][0]);
        for (int k = 1; k <= j; k++) {
            quad ratio = (quad)(j + 1) / (j + 1 - k);
            for (int i = 0; i < STATES; i++)
                table[j][k][i] = table[j][k - 1][i]
                               + (table[j][k - 1][i] - table[j - 1][k - 1][i]) / (ratio * ratio - 1);
        }
    }
    for (int i = 0; i < STATES; i++) {
        y[i] = table[ROWS - 1][ROWS - 1][i];
        quad d = fabsq(y[i] - table[ROWS - 1][ROWS - 2][i]) / (1 + fabsq(y[i]));
        if (d > error) error = d;
    }
    return error;
}

/* The point (eta, gamma) of the section omega_tau = 0. */
static void start(quad eta, quad gamma, quad *x)
{
    quad s = sqrtq((1 - gamma) * (1 + gamma)), b = a3 + R * gamma;
    quad Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b, C = Theta - I1 * I3;
    quad E0 = G * G * (I1 + m * b * b) / (2 * I1 * I1 * R * R * s * s);
    quad right = 2 * m * I1 * I1 * R * R * s * s * (E - m * g * a3 * gamma - E0) + Theta * m * m * G * G * b * b / C;
    quad radius = sqrtq(right);
    x[0] = gamma;
    x[1] = radius * sinq(eta) / (m * I1 * R * s);
    x[2] = 0;
    x[4] = radius * cosq(eta) / sqrtq(Theta * C) - m * G * b / C;
    x[3] = (G + I3 * b * x[4]) / (I1 * R * s);
    x[5] = s;
    x[6] = 0;
}

/* One step, of the length that gives 1e-30; y gets its end. Returns its length, and proposes the next in *h. */
static inline quad step(const quad *x, quad *h, quad *y)
{
    quad error;
    while ((error = extrapolate(x, *h, y)) > 1e-30Q) *h *= 0.7Q;
    quad taken = *h;
    if (error < 1e-32Q) *h *= 1.15Q;
    return taken;
}

/* The upward crossing within a step of length h from x to y; false when there is none. */
static inline int crossing(const quad *x, const quad *y, quad h, quad *z)
{
    quad f[STATES], part = h * x[2] / (x[2] - y[2]);
    if (!(x[2] < 0 && y[2] >= 0)) return 0;
    for (int newton = 0; newton < 8; newton++) {
        extrapolate(x, part, z);
        field(z, f);
        part -= z[2] / f[2];
    }
    extrapolate(x, part, z);
    return 1;
}

/* (eta, gamma3) of a point of the section, and its time. */
static inline void lower(const quad *z, quad *out)
{
    quad b = a3 + R * z[0], s = z[5], Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b, C = Theta - I1 * I3;
    out[0] = atan2q(m * I1 * R * s * z[1], sqrtq(Theta * C) * (z[4] + m * G * b / C));
    out[1] = z[0];
    out[2] = z[6];
}

/* The point after so many returns, at least one. */
static inline void image(quad eta, quad gamma, int number, quad *out)
{
    quad x[STATES], y[STATES], z[STATES], h = 0.05Q;
    start(eta, gamma, x);
    while (number > 0) {
        number -= crossing(x, y, step(x, &h, y), z);
        for (int i = 0; i < STATES; i++) x[i] = y[i];
    }
    lower(z, out);
}

#endif
