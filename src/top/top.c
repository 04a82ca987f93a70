#include "top/top.h"

#include <math.h>
#include <string.h>

jlt_status jlt_top_read(jlt_top *out, const jlt_descriptor *descriptor, const double *params)
{
    jlt_top top = { 0 };
    const struct {
        const char *name;
        double *value;
    } wanted[] = { { "m", &top.m }, { "R", &top.R }, { "I1", &top.I1 }, { "I3", &top.I3 }, { "g", &top.g },
                   { "a3", &top.a3 } };

    for (size_t w = 0; w < sizeof wanted / sizeof *wanted; w++) {
        unsigned i = 0;
        while (i < descriptor->param_count && strcmp(descriptor->params[i].name, wanted[w].name) != 0) i++;
        if (i < descriptor->param_count) *wanted[w].value = params[i];
        else if (w < 3) return JLT_ERR_ARG;
    }
    *out = top;
    return JLT_OK;
}

double jlt_top_sine(double gamma3)
{
    return sqrt(fmax(0, (1 - gamma3) * (1 + gamma3))); /* an integrated gamma3 may pass 1 by a rounding error */
}

double jlt_top_v_tau(const jlt_top *top, const double *x)
{
    const double b = top->a3 + top->R * x[JLT_TOP_GAMMA3];
    return b * x[JLT_TOP_OMEGA_N] + top->R * jlt_top_sine(x[JLT_TOP_GAMMA3]) * x[JLT_TOP_OMEGA3];
}

double jlt_top_energy(const jlt_top *top, const double *x)
{
    const double s = jlt_top_sine(x[JLT_TOP_GAMMA3]);
    const double D = top->I1 + top->m * top->a3 * top->a3 * s * s;
    const double v_tau = jlt_top_v_tau(top, x);
    const double twice = top->m * (x[JLT_TOP_V_NU] * x[JLT_TOP_V_NU] + v_tau * v_tau)
                         + D * x[JLT_TOP_OMEGA_TAU] * x[JLT_TOP_OMEGA_TAU]
                         + top->I1 * x[JLT_TOP_OMEGA_N] * x[JLT_TOP_OMEGA_N]
                         + top->I3 * x[JLT_TOP_OMEGA3] * x[JLT_TOP_OMEGA3];
    return twice / 2 + top->m * top->g * top->a3 * x[JLT_TOP_GAMMA3];
}

double jlt_top_jellett(const jlt_top *top, const double *x)
{
    const double s = jlt_top_sine(x[JLT_TOP_GAMMA3]);
    const double b = top->a3 + top->R * x[JLT_TOP_GAMMA3];
    return top->I1 * top->R * s * x[JLT_TOP_OMEGA_N] - top->I3 * b * x[JLT_TOP_OMEGA3];
}
