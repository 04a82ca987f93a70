#include "top/balanced_form.h"

#include <math.h>

#include "kernel/descriptor.h"
#include "kernel/way.h"

/* Bounds of the terms of E, G, F0 and M at gamma3 and velocities of at most 1, from their values where one velocity is 1 and the
 * others are 0: E and F0 are of second degree in the velocities, G is linear, and M is the length of a linear vector. */
static jlt_balanced_levels sizes_at(const jlt_top *top, double gamma3)
{
    jlt_balanced_levels size = { 0 };

    for (unsigned i = JLT_TOP_V_NU; i < JLT_TOP_STATES; i++) {
        double x[JLT_TOP_STATES] = { gamma3 };
        jlt_balanced_levels at;
        x[i] = 1;
        jlt_balanced_levels_of(&at, top, x);
        size.E += sqrt(at.E);
        size.G += fabs(at.G);
        size.F0 += sqrt(fabs(at.F0));
        size.M += at.M;
    }
    size.E *= size.E;
    size.F0 *= size.F0;
    return size;
}

/* The levels at (gamma3, v_nu, 0, 0, omega3), a point of the family. */
static jlt_balanced_levels on_family(const jlt_top *top, double gamma3, double v_nu, double omega3)
{
    const double x[JLT_TOP_STATES] = { [JLT_TOP_GAMMA3] = gamma3, [JLT_TOP_V_NU] = v_nu, [JLT_TOP_OMEGA3] = omega3 };
    jlt_balanced_levels levels;

    jlt_balanced_levels_of(&levels, top, x);
    return levels;
}

static bool family_has_form(const jlt_top *top, double gamma3, const jlt_balanced_levels *size)
{
    const jlt_balanced_levels along = on_family(top, 0, 1, 0), equator = on_family(top, 0, 0, 1), pole = on_family(top, 1, 0, 1);
    const jlt_balanced_levels both = on_family(top, gamma3, 1, 1);
    const double u = gamma3 * gamma3;

    return jlt_top_agrees(both.E, along.E + equator.E * (1 - u) + pole.E * u, size->E)
           && jlt_top_agrees(both.F0, along.F0 + equator.F0 * (1 - u) + pole.F0 * u, size->F0)
           && jlt_top_agrees(both.G, pole.G * gamma3, size->G);
}

/* Everywhere: E by the other levels, and F0 by v_slip and omega3. */
static bool levels_have_form(const jlt_top *top, const double *x, const jlt_balanced_levels *size)
{
    double of_F0, of_G, of_M, gamma3, v_slip, psi;
    jlt_balanced_levels here;

    jlt_balanced_shares(&of_F0, &of_G, &of_M, top);
    jlt_balanced_levels_of(&here, top, x);
    jlt_balanced_from_state(top, &gamma3, &v_slip, &psi, x);
    const double F_v = on_family(top, gamma3, 1, 0).F0, F_w = on_family(top, gamma3, 0, 1).F0, omega3 = x[JLT_TOP_OMEGA3];
    return jlt_top_agrees(here.E, of_F0 * here.F0 + of_G * here.G * here.G + of_M * here.M * here.M,
                          of_F0 * size->F0 + of_G * size->G * size->G + of_M * size->M * size->M)
           && jlt_top_agrees(here.F0, F_v * v_slip * v_slip + F_w * omega3 * omega3, size->F0);
}

/* Whether gamma3 and psi rest where omega_tau and omega_n are 0, and nowhere else: all fixed points are then on the family. */
static bool rates_have_form(const jlt_top *top, const double *x, const jlt_balanced_levels *size)
{
    const jlt_way *way = jlt_top_way(jlt_balanced_table);
    const jlt_descriptor *surface = jlt_descriptor_find(jlt_balanced_table, NULL, way->time, NULL);
    const double gamma3 = x[JLT_TOP_GAMMA3], s = jlt_top_sine(gamma3);
    double y[JLT_WAY_VALUES_MAX], params[JLT_WAY_VALUES_MAX], block[JLT_WAY_VALUES_MAX], rates[JLT_WAY_VALUES_MAX];
    double by_slip[JLT_TOP_STATES], by_G[JLT_TOP_STATES], by_M[JLT_TOP_STATES], across_M[JLT_TOP_STATES];
    double v_slip, psi;
    size_t column, angle;

    if (surface->prepared_count > JLT_WAY_VALUES_MAX || !jlt_descriptor_state(surface, "gamma3", &column)
        || !jlt_descriptor_state(surface, "psi", &angle))
        return false;
    jlt_top_look(way, y, params, top, x);
    y[surface->state_count - 1] = s;
    surface->prepare(params, block);
    surface->rhs.call(y, block, rates); /* dt = s dtau */
    jlt_balanced_from_state(top, &(double){ 0 }, &v_slip, &psi, x);
    /* sizes of the terms of omega_tau and omega_n */
    jlt_balanced_to_state(top, &(jlt_balanced_levels){ 0 }, by_slip, gamma3, s, v_slip, 0);
    jlt_balanced_to_state(top, &(jlt_balanced_levels){ .G = size->G }, by_G, gamma3, s, 0, 0);
    jlt_balanced_to_state(top, &(jlt_balanced_levels){ .M = size->M }, by_M, gamma3, s, 0, 0);
    jlt_balanced_to_state(top, &(jlt_balanced_levels){ .M = size->M }, across_M, gamma3, s, 0, acos(0));
    return jlt_top_agrees(rates[column], s * s * x[JLT_TOP_OMEGA_TAU],
                          fabs(by_slip[JLT_TOP_OMEGA_TAU]) + fabs(across_M[JLT_TOP_OMEGA_TAU]))
           && jlt_top_agrees(rates[angle], x[JLT_TOP_OMEGA_N], fabs(by_G[JLT_TOP_OMEGA_N]) + fabs(by_M[JLT_TOP_OMEGA_N]));
}

/* omega3 where v_slip and psi are 0, on this level of G and of M. */
static double spin_at(const jlt_top *top, double gamma3, double G, double M)
{
    double x[JLT_TOP_STATES];

    jlt_balanced_to_state(top, &(jlt_balanced_levels){ .G = G, .M = M }, x, gamma3, jlt_top_sine(gamma3), 0, 0);
    return x[JLT_TOP_OMEGA3];
}

/* Where v_slip and psi are 0, F0 = F_w omega3^2, and F_w omega3 is linear in s M and gamma3 G: from this the least F0 follows. */
static bool spin_has_form(const jlt_top *top, double gamma3)
{
    const double F_w = on_family(top, gamma3, 0, 1).F0, s = jlt_top_sine(gamma3);
    const double by_G = F_w * spin_at(top, gamma3, 1, 0), pole = on_family(top, 1, 0, 1).F0 * spin_at(top, 1, 1, 0);
    const double by_M = F_w * spin_at(top, gamma3, 0, 1), equator = on_family(top, 0, 0, 1).F0 * spin_at(top, 0, 0, 1);

    if (!(top->I3 > 0)) return true; /* the pole has no value, and F0 is not negative */
    return jlt_top_agrees(by_M, s * equator, fabs(by_M)) && jlt_top_agrees(by_G, gamma3 * pole, fabs(by_G));
}

bool jlt_balanced_form_holds(const jlt_top *top)
{
    for (unsigned i = 0; i < JLT_TOP_SAMPLES; i++) {
        const double *x = jlt_top_samples[i], gamma3 = x[JLT_TOP_GAMMA3];
        const jlt_balanced_levels size = sizes_at(top, gamma3);
        if (!family_has_form(top, gamma3, &size) || !levels_have_form(top, x, &size) || !spin_has_form(top, gamma3)
            || !rates_have_form(top, x, &size))
            return false;
    }
    return true;
}
