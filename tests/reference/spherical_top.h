/* The reduced system (3.2) of Kilin and Ivanova (2023), written by hand, in its own time t, and regularised with dt = s dtau and s
 * lifted to a state: an oracle for kernels and a field for integrators. p = m, R, g, I1, I3, a3. States: gamma3, v_nu, omega_tau,
 * omega_n, omega3, and s if lifted. */
#ifndef JLT_TESTS_SPHERICAL_TOP_H
#define JLT_TESTS_SPHERICAL_TOP_H

#include <math.h>

#define TOP_PARAMETERS                                                                              \
    const double m = p[0], R = p[1], g = p[2], I1 = p[3], I3 = p[4], a3 = p[5];                     \
    const double y = x[0], v = x[1], wt = x[2], wn = x[3], w3 = x[4];                               \
    const double b = a3 + R * y, e = R + a3 * y, Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b; \
    const double D = I1 + m * a3 * a3 * s * s, V = e * wt + v

static inline void top_plain(const double *restrict x, const double *restrict p, double *restrict f)
{
    const double s = sqrt((1 - x[0]) * (1 + x[0]));
    TOP_PARAMETERS;
    f[0] = s * wt;
    f[1] = wn * (b * wn + R * s * w3) / s;
    f[2] = (m * a3 * s * s * (a3 * y * wt * wt - g) - wn * (I1 * y * wn + I3 * s * w3)) / (s * D);
    f[3] = y * wn * wt / s - m * I3 * b * wn * V / (s * Theta) + I3 * w3 * wt * (I3 + m * R * e) / Theta;
    f[4] = -m * R * I1 * wn * V / Theta + m * R * s * w3 * wt * (R * y * (I1 - I3) - a3 * I3) / Theta;
}

static inline void top_regular(const double *restrict x, const double *restrict p, double *restrict f)
{
    const double s = x[5];
    TOP_PARAMETERS;
    f[0] = s * s * wt;
    f[1] = wn * (b * wn + R * s * w3);
    f[2] = (m * a3 * s * s * (a3 * y * wt * wt - g) - wn * (I1 * y * wn + I3 * s * w3)) / D;
    f[3] = y * wn * wt + I3 * (s * w3 * wt * (I3 + m * R * e) - m * b * wn * V) / Theta;
    f[4] = m * R * s * (s * w3 * wt * (R * y * (I1 - I3) - a3 * I3) - I1 * wn * V) / Theta;
    f[5] = -y * s * wt;
}

static inline void top_time_rate(const double *restrict x, const double *restrict p, double *restrict rate)
{
    (void)p;
    rate[0] = x[5];
}

/* The integrals E, G in levels[0], levels[1]. lifted: x has s as a sixth state. */
static inline void top_levels(const double *x, const double *p, int lifted, double *levels)
{
    const double s = lifted ? x[5] : sqrt((1 - x[0]) * (1 + x[0]));
    TOP_PARAMETERS;
    (void)e, (void)Theta, (void)V;
    const double slip = b * wn + R * s * w3;
    levels[0] = 0.5 * (m * v * v + D * wt * wt + I1 * wn * wn + I3 * w3 * w3 + m * slip * slip) + m * g * a3 * y;
    levels[1] = I1 * R * s * wn - I3 * b * w3;
}

/* The point (eta, gamma3) of the section omega_tau = 0 on the levels E, G, after (5.1) and above; six states. */
static inline void top_section_point(double *x, const double *p, double eta, double gamma3, double E, double G)
{
    const double m = p[0], R = p[1], g = p[2], I1 = p[3], I3 = p[4], a3 = p[5];
    const double s = sqrt((1 - gamma3) * (1 + gamma3)), b = a3 + R * gamma3;
    const double Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b, rest = Theta - I1 * I3;
    const double E0 = G * G * (I1 + m * b * b) / (2 * I1 * I1 * R * R * s * s);
    /* Theta/(2 m I1^2 R^2 s^2) (rest (w3 + m G b/rest)^2 - m^2 G^2 b^2/rest) + m v^2/2 = E - m g a3 gamma3 - E0 */
    const double unit = 2 * m * I1 * I1 * R * R * s * s;
    const double radius = sqrt(unit * (E - m * g * a3 * gamma3 - E0) + Theta * m * m * G * G * b * b / rest);
    const double w3 = radius * cos(eta) / sqrt(Theta * rest) - m * G * b / rest;
    const double v = radius * sin(eta) / (m * I1 * R * s);
    const double point[6] = { gamma3, v, 0, (G + I3 * b * w3) / (I1 * R * s), w3, s };
    for (int i = 0; i < 6; i++) x[i] = point[i];
}

#endif
