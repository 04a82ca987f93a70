#include "top/known.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "top/system_top.h"

static const char *const names[] = { "m", "R", "g", "I1", "I3", "a3", "E", "G" }; /* as in jlt_top_values */
enum { VALUES = sizeof names / sizeof *names, PARAMS = VALUES - 2 };
_Static_assert(sizeof(jlt_top_values) == VALUES * sizeof(double), "values are in the order of their names");

static jlt_top_values values_of(const double *values)
{
    jlt_top_values out;
    memcpy(&out, values, sizeof out);
    return out;
}

static jlt_status make(jlt_system **out, const double *values, const jlt_flow *options)
{
    const jlt_top_values v = values_of(values);
    return jlt_system_top(out, &v, options);
}

/* The least energy of a state with omega_tau = 0 on the level of G, over gamma3. */
static double least_energy(const jlt_top_values *v)
{
    jlt_chart_top chart;
    double least = INFINITY;

    jlt_chart_top_init(&chart, v->m, v->R, v->g, v->I1, v->I3, v->a3, 0, v->G);
    for (int i = 0; i < 4096; i++)
        least = fmin(least, -v->m * jlt_chart_top_speed2(&chart, -1 + 2 * (i + 0.5) / 4096) / 2);
    return least;
}

static void refuse(char *text, size_t size, const double *values, jlt_status status)
{
    const jlt_top_values v = values_of(values);
    const bool allowed = v.m > 0 && v.R > 0 && v.I1 > 0 && v.g >= 0 && v.I3 >= 0;

    if (status == JLT_ERR_EMPTY)
        snprintf(text, size, "no state with omega_tau = 0 has E = %.10g and G = %.10g: raise E above %.10g, or take G nearer to 0",
                 v.E, v.G, least_energy(&v));
    else if (status == JLT_ERR_DOMAIN)
        snprintf(text, size, "%s", allowed ? "the parameters are so far apart that products of them leave the range of doubles"
                                                  : "m, R and I1 must be positive, g >= 0 and I3 >= 0");
    else if (status == JLT_ERR_UNSUPPORTED)
        snprintf(text, size, "the kernels of spherical_top_level in regular time are not built in");
    else snprintf(text, size, "the spherical top: %s", jlt_status_text(status));
}

static bool interval(const jlt_system *system, unsigned coordinate, double *low, double *high)
{
    return coordinate == 1 && jlt_system_top_interval(jlt_system_top_chart(system), low, high);
}

/* gamma3; at a pole it may pass 1 by a rounding error. */
static void off_section(double *q, const double *x)
{
    q[0] = NAN;
    q[1] = fmax(-1, fmin(1, x[JLT_CHART_TOP_GAMMA3]));
}

static const char *const return_names[] = { "v_nu", "omega_n", "omega3" };

static void at_return(double *out, const jlt_system *system, const double *x)
{
    out[0] = x[JLT_CHART_TOP_V_NU];
    jlt_chart_top_rotation(jlt_system_top_chart(system), &out[1], &out[2], x);
}

static const char *const end_names[] = { "v_nu", "omega_tau", "omega3" };

static void at_end(double *out, const jlt_system *system, const double *x)
{
    double omega_n;
    out[0] = x[JLT_CHART_TOP_V_NU];
    out[1] = x[JLT_CHART_TOP_OMEGA_TAU];
    jlt_chart_top_rotation(jlt_system_top_chart(system), &omega_n, &out[2], x);
}

/* With its centre of mass below the centre of the sphere. */
static bool is_low(const jlt_system *system, const double *q)
{
    return jlt_system_top_chart(system)->a3 * q[1] < 0;
}

static jlt_fate turned_at(const jlt_system *system)
{
    return jlt_system_top_chart(system)->a3 < 0 ? JLT_FATE_POLE_MINUS : JLT_FATE_POLE_PLUS;
}

static const double defaults[VALUES] = { 1, 1, 1, 1. / 3, 1. / 3, 0.51, 2.15, -0.56 }; /* (5.1) of Kilin & Ivanova (2023) */
static const char *const coordinates[] = { "eta", "gamma3" }; /* as the chart has them */
static const char *const units[] = { "rad", "" };
static const double frame[] = { -3.14159265358979323846, 3.14159265358979323846, -1, 1 };

const jlt_known jlt_known_top = {
    .subject = "the spherical top",
    .table = "spherical_top_level",
    .plane = "omega_tau=0",
    .count = VALUES,
    .params = PARAMS,
    .names = names,
    .defaults = defaults,
    .coordinates = coordinates,
    .coordinate_count = sizeof coordinates / sizeof *coordinates,
    .starts = { "eta=0.44,gamma3=-0.62", "eta=0.1,gamma3=-0.6", "eta=0,gamma3=-0.61" },
    .units = units,
    .frame = frame,
    .domain = "gamma3 must lie strictly between -1 and 1, and the orbit return before it ends at a pole or at rest",
    .at_return = { sizeof return_names / sizeof *return_names, return_names, at_return },
    .at_end = { sizeof end_names / sizeof *end_names, end_names, at_end },
    .make = make,
    .refuse = refuse,
    .interval = interval,
    .off_section = off_section,
    .low = "with a low centre of mass",
    .is_low = is_low,
    .turned_at = turned_at,
};

const jlt_known *jlt_known_of(const jlt_descriptor *descriptor)
{
    return strcmp(descriptor->model, "spherical_top") == 0 || strcmp(descriptor->model, "spherical_top_level") == 0 ? &jlt_known_top : NULL;
}

unsigned jlt_known_value(const jlt_known *known, const char *name)
{
    unsigned i = 0;

    while (i < known->count && strcmp(known->names[i], name) != 0) i++;
    return i;
}
