#include "top/level.h"

#include <math.h>

void jlt_level_rotation(const jlt_top *top, double G, double *omega_n, double *omega3, const double *y)
{
    const double s = y[JLT_LEVEL_S], v_tau = y[JLT_LEVEL_V_TAU], b = top->a3 + top->R * y[JLT_LEVEL_GAMMA3];
    const double K = top->I1 * top->R * top->R * (s * s) + top->I3 * b * b;

    *omega_n = K == 0 ? NAN : (top->R * s * G + top->I3 * b * v_tau) / K;
    *omega3 = K == 0 ? NAN : (top->I1 * top->R * s * v_tau - b * G) / K;
}

void jlt_level_state(const jlt_top *top, double *y, const double *x)
{
    y[JLT_LEVEL_GAMMA3] = x[JLT_TOP_GAMMA3];
    y[JLT_LEVEL_V_NU] = x[JLT_TOP_V_NU];
    y[JLT_LEVEL_OMEGA_TAU] = x[JLT_TOP_OMEGA_TAU];
    y[JLT_LEVEL_V_TAU] = jlt_top_v_tau(top, x);
    y[JLT_LEVEL_S] = jlt_top_sine(x[JLT_TOP_GAMMA3]);
}

jlt_units jlt_level_units(const jlt_top *top, double E)
{
    const double energy = (E + top->m * top->g * fabs(top->a3)) / top->m;
    jlt_units units = { 0 };

    if (!(top->m > 0 && top->R > 0) || !isfinite(top->m) || !isfinite(top->R)) return units;
    units.mass = ilogb(top->m);
    units.length = ilogb(top->R);
    if (energy > 0 && isfinite(energy)) units.time = units.length - (ilogb(energy) >> 1);
    return units;
}
