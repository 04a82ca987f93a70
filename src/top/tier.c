#include "top/tier.h"

#include "integrate/field.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SLIP_GRID = 64 };

/* ---- whom a tier serves ---- */

static const char *needs_rod(const jlt_top *top, const double *x)
{
    if (top->I3 != 0) return "I3 is not 0";
    if (jlt_top_jellett(top, x) == 0) return "G = 0: the orbit runs through the poles";
    return NULL;
}

static const char *needs_balance(const jlt_top *top, const double *x)
{
    if (top->a3 != 0) return "a3 is not 0";
    if (top->I3 == 0 && jlt_top_jellett(top, x) == 0)
        return "I3 = G = 0: the orbit runs into the poles, where the levels do not tell the velocities";
    if (x[JLT_TOP_OMEGA_N] == 0 && x[JLT_TOP_OMEGA3] == 0)
        return "omega_n = omega3 = 0: the motion is planar into the poles, which the angle psi does not hold to the last digit";
    return NULL;
}

static const char *needs_halves(const jlt_top *top, const double *x)
{
    jlt_balanced_levels levels;
    const double v_slip = x[JLT_TOP_V_NU] + top->R * x[JLT_TOP_OMEGA_TAU];

    if (needs_balance(top, x) != NULL) return needs_balance(top, x);
    if (top->I1 == top->I3) return NULL; /* v_slip is constant */
    jlt_balanced_levels_of(&levels, top, x);
    if (!(jlt_balanced_least_slip2(top, &levels, SLIP_GRID) > 0.02 * v_slip * v_slip))
        return "v_slip may vanish on this level: the halves of M^2 meet";
    return NULL;
}

static const char *needs_spin(const jlt_top *top, const double *x)
{
    (void)x;
    return top->I3 == 0 ? "I3 = 0: G does not contain omega3" : NULL;
}

static const char *needs_inertia(const jlt_top *top, const double *x)
{
    (void)x;
    return top->I3 == 0 ? "I3 = 0: its table asks for I3 > 0" : NULL;
}

/* ---- coordinates ---- */

static void plane_embed(const jlt_tier_view *view, double *y, const double *x)
{
    double v_slip, psi;

    jlt_balanced_from_state(&view->top, &y[0], &v_slip, &psi, x);
    y[1] = view->mirror * psi;
    y[2] = jlt_top_sine(y[0]);
}

static void plane_extract(const jlt_tier_view *view, double *x, const double *y)
{
    const double v_slip = jlt_balanced_slip(&view->top, &view->levels, y[0], y[2], y[1]);
    jlt_balanced_to_state(&view->top, &view->levels, x, y[0], y[2], view->mirror * v_slip, view->mirror * y[1]);
}

static void balanced_embed(const jlt_tier_view *view, double *y, const double *x)
{
    jlt_balanced_from_state(&view->top, &y[0], &y[1], &y[2], x);
    y[3] = jlt_top_sine(y[0]);
}

static void balanced_extract(const jlt_tier_view *view, double *x, const double *y)
{
    jlt_balanced_to_state(&view->top, &view->levels, x, y[0], y[3], y[1], y[2]);
}

static void level_embed(const jlt_tier_view *view, double *y, const double *x)
{
    jlt_level_state(&view->top, y, x);
}

static void level_extract(const jlt_tier_view *view, double *x, const double *y)
{
    x[JLT_TOP_GAMMA3] = y[JLT_LEVEL_GAMMA3];
    x[JLT_TOP_V_NU] = y[JLT_LEVEL_V_NU];
    x[JLT_TOP_OMEGA_TAU] = y[JLT_LEVEL_OMEGA_TAU];
    jlt_level_rotation(&view->top, view->G, &x[JLT_TOP_OMEGA_N], &x[JLT_TOP_OMEGA3], y);
}

static void level_plain_embed(const jlt_tier_view *view, double *y, const double *x)
{
    double lifted[JLT_LEVEL_STATES];

    level_embed(view, lifted, x);
    memcpy(y, lifted, JLT_LEVEL_S * sizeof *y);
}

static void level_plain_extract(const jlt_tier_view *view, double *x, const double *y)
{
    double lifted[JLT_LEVEL_STATES];

    memcpy(lifted, y, JLT_LEVEL_S * sizeof *lifted);
    lifted[JLT_LEVEL_S] = jlt_top_sine(y[JLT_LEVEL_GAMMA3]);
    level_extract(view, x, lifted);
}

/* The two single charts of a level of G, in t: gamma3, v_nu, omega_tau, and the rotation that is left. */
static void without_omega_n_embed(const jlt_tier_view *view, double *y, const double *x)
{
    (void)view;
    memcpy(y, x, 3 * sizeof *y);
    y[3] = x[JLT_TOP_OMEGA3];
}

static void without_omega_n_extract(const jlt_tier_view *view, double *x, const double *y)
{
    const jlt_top *top = &view->top;
    memcpy(x, y, 3 * sizeof *x);
    x[JLT_TOP_OMEGA3] = y[3];
    x[JLT_TOP_OMEGA_N] = (view->G + top->I3 * (top->a3 + top->R * y[0]) * y[3]) / (top->I1 * top->R * jlt_top_sine(y[0]));
}

static void without_omega3_embed(const jlt_tier_view *view, double *y, const double *x)
{
    (void)view;
    memcpy(y, x, 4 * sizeof *y);
}

static void without_omega3_extract(const jlt_tier_view *view, double *x, const double *y)
{
    const jlt_top *top = &view->top;
    memcpy(x, y, 4 * sizeof *x);
    x[JLT_TOP_OMEGA3] = (top->I1 * top->R * jlt_top_sine(y[0]) * y[3] - view->G) / (top->I3 * (top->a3 + top->R * y[0]));
}

static void five_embed(const jlt_tier_view *view, double *y, const double *x)
{
    (void)view;
    memcpy(y, x, JLT_TOP_STATES * sizeof *y);
    y[JLT_TOP_STATES] = jlt_top_sine(x[JLT_TOP_GAMMA3]);
}

static void plain_embed(const jlt_tier_view *view, double *y, const double *x)
{
    (void)view;
    memcpy(y, x, JLT_TOP_STATES * sizeof *y);
}

static void five_extract(const jlt_tier_view *view, double *x, const double *y)
{
    (void)view;
    memcpy(x, y, JLT_TOP_STATES * sizeof *x);
}

/* chi, spin, x, y after the five; the contact point starts at the origin, nu along x. */
static void track_embed(const jlt_tier_view *view, double *y, const double *x)
{
    memcpy(y, x, JLT_TOP_STATES * sizeof *y);
    y[9] = jlt_top_sine(x[JLT_TOP_GAMMA3]);
    y[5] = y[6] = y[8] = 0;
    y[7] = view->top.a3 * y[9];
}

static void track_orient(const jlt_tier_view *view, jlt_attitude *out, const double *y)
{
    jlt_attitude_from_angles(out, &view->top, y[0], y[9], y[5], y[6], &y[7]);
}

/* gamma, v, omega, alpha, beta, x, y; the same start: tau = e1, n = e2. */
enum { FULL_GAMMA = 0, FULL_V = 3, FULL_OMEGA = 6, FULL_ALPHA = 9, FULL_BETA = 12, FULL_CENTRE = 15 };

static void full_embed(const jlt_tier_view *view, double *y, const double *x)
{
    const double gamma3 = x[JLT_TOP_GAMMA3], s = jlt_top_sine(gamma3);
    const double v_nu = x[JLT_TOP_V_NU], v_tau = jlt_top_v_tau(&view->top, x);
    const double v_gamma = view->top.a3 * s * x[JLT_TOP_OMEGA_TAU];
    const double full[] = { 0, -s, gamma3,
                            v_tau, gamma3 * v_nu - s * v_gamma, s * v_nu + gamma3 * v_gamma,
                            x[JLT_TOP_OMEGA_TAU], x[JLT_TOP_OMEGA_N], x[JLT_TOP_OMEGA3],
                            0, gamma3, s,
                            -1, 0, 0,
                            view->top.a3 * s, 0 };
    memcpy(y, full, sizeof full);
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void full_extract(const jlt_tier_view *view, double *x, const double *y)
{
    const double *gamma = y + FULL_GAMMA, *v = y + FULL_V, *omega = y + FULL_OMEGA;
    const double s = hypot(gamma[0], gamma[1]);
    const double tau[] = { -gamma[1] / s, gamma[0] / s, 0 };
    const double n[] = { -gamma[0] / s, -gamma[1] / s, 0 };
    const double nu[] = { gamma[2] * n[0], gamma[2] * n[1], s };

    (void)view;
    x[JLT_TOP_GAMMA3] = gamma[2];
    x[JLT_TOP_V_NU] = dot(v, nu);
    x[JLT_TOP_OMEGA_TAU] = dot(omega, tau);
    x[JLT_TOP_OMEGA_N] = dot(omega, n);
    x[JLT_TOP_OMEGA3] = omega[2];
}

static void full_orient(const jlt_tier_view *view, jlt_attitude *out, const double *y)
{
    double axes[3][3];

    memcpy(axes[0], y + FULL_ALPHA, sizeof axes[0]);
    memcpy(axes[1], y + FULL_BETA, sizeof axes[1]);
    memcpy(axes[2], y + FULL_GAMMA, sizeof axes[2]);
    jlt_attitude_from_axes(out, &view->top, (const double (*)[3])axes, y + FULL_CENTRE);
}

/* ---- where coordinates end ---- */

const char jlt_tier_near_pole[] = "the orbit is so near a pole that in plain time nothing is left of its digits";

/* In components a step may lead past a pole: the field is as good as in plain time, no nearer. */
static double full_room(void *view, const double *y)
{
    (void)view;
    return y[FULL_GAMMA] * y[FULL_GAMMA] + y[FULL_GAMMA + 1] * y[FULL_GAMMA + 1] - 2 * JLT_FIELD_NEAREST;
}

static const jlt_tier_edge full_edge = { full_room, NULL, jlt_tier_near_pole };

/* An error of omega_n is one of omega3 divided by b: within a thousandth of R more than three digits are lost. */
static double without_omega3_room(void *view, const double *y)
{
    const jlt_top *top = &((const jlt_tier_view *)view)->top;
    const double b = top->a3 / top->R + y[JLT_TOP_GAMMA3];
    return b * b - 1e-6;
}

/* Three tenths of the straight way to b = 0: b may fall faster than it begins to. */
static double without_omega3_step(void *view, const double *y, const double *f, double direction)
{
    const jlt_top *top = &((const jlt_tier_view *)view)->top;
    const double b = top->a3 / top->R + y[JLT_TOP_GAMMA3], approach = -direction * f[JLT_TOP_GAMMA3] * (b < 0 ? -1 : 1);
    return approach > 0 ? 0.3 * fabs(b) / approach : INFINITY;
}

static const jlt_tier_edge without_omega3_edge = { without_omega3_room, without_omega3_step,
                                                   "b = a3 + R gamma3 is below R/1000, where G does not tell omega3" };

/* ---- the table ---- */

static const jlt_tier tiers[] = {
    { "quadrature", "I3 = 0: tilt, turn and time by quadratures, nothing is integrated in time", 0,
      NULL, NULL, NULL, false, false, 0, needs_rod, NULL, NULL, NULL, NULL,
      { "spherical_top_level", { { "integral", "E1" }, { "integral", "E2" }, { "integral", "G" } } } },
    { "plane", "a3 = 0: the flow on a half of M^2, levels of E, G and F0 fixed", 2,
      "spherical_top_plane", "regular", NULL, false, false, 3, needs_halves, plane_embed, plane_extract, NULL, NULL,
      { "spherical_top_plane", { { 0 } } } },
    { "balanced", "a3 = 0: M^2 whole, in three states on levels of G and of the horizontal momentum", 3,
      "spherical_top_balanced", "regular", NULL, false, false, 4, needs_balance, balanced_embed, balanced_extract, NULL, NULL,
      { "spherical_top_balanced", { { 0 } } } },
    { "level", "four states on a level of G, in coordinates that divide by nothing small", 4,
      "spherical_top_level", "regular", NULL, false, false, 5, NULL, level_embed, level_extract, NULL, NULL,
      { "spherical_top_level", { { 0 } } } },
    { "level_plain", "the same in t: steps collapse at the poles", 4,
      "spherical_top_level", NULL, NULL, true, false, 4, NULL, level_plain_embed, level_plain_extract, NULL, NULL,
      { "spherical_top_level", { { 0 } } } },
    { "level_omega_n", "a level of G with omega_n eliminated: loses digits near the poles", 4,
      "spherical_top", NULL, "level_G", true, false, 4, NULL, without_omega_n_embed, without_omega_n_extract, NULL, NULL,
      { "spherical_top", { { "eliminate", "level_G" } } } },
    { "level_omega3", "a level of G with omega3 eliminated: loses digits near b = 0", 4,
      "spherical_top", NULL, "level_G_omega3", true, false, 4, needs_spin, without_omega3_embed, without_omega3_extract,
      NULL, &without_omega3_edge,
      { "spherical_top", { { "eliminate", "level_G_omega3" } } } },
    { "five", "the reduced system (3.2)", 5,
      "spherical_top", "regular", NULL, false, false, 6, NULL, five_embed, five_extract, NULL, NULL,
      { "spherical_top", { { 0 } } } },
    { "five_plain", "the same in t: steps collapse at the poles", 5,
      "spherical_top", NULL, NULL, true, false, 5, NULL, plain_embed, five_extract, NULL, NULL,
      { "spherical_top", { { 0 } } } },
    { "track", "the reduced system with attitude and track by quadratures", 9,
      "spherical_top_track", "regular", NULL, false, true, 10, NULL, track_embed, five_extract, track_orient, NULL,
      { "spherical_top_track", { { 0 } } } },
    { "full", "the full system (2.7) with (2.1): every vector by its components", 17,
      "spherical_top_full", NULL, NULL, false, true, 17, needs_inertia, full_embed, full_extract, full_orient,
      &full_edge,
      { "spherical_top_full", { { 0 } } } },
};

const jlt_tier *jlt_tier_at(size_t index)
{
    return index < sizeof tiers / sizeof *tiers ? &tiers[index] : NULL;
}

const jlt_tier *jlt_tier_find(const char *name)
{
    for (size_t i = 0; i < sizeof tiers / sizeof *tiers; i++)
        if (strcmp(tiers[i].name, name) == 0) return &tiers[i];
    return NULL;
}

void jlt_tier_look(jlt_tier_view *out, const jlt_tier *tier, const jlt_descriptor *descriptor, const jlt_top *top,
                   const double *x)
{
    const double v_slip = x[JLT_TOP_V_NU] + top->R * x[JLT_TOP_OMEGA_TAU];

    *out = (jlt_tier_view){ .top = *top, .descriptor = descriptor, .G = jlt_top_jellett(top, x), .mirror = 1 };
    memcpy(out->start, x, sizeof out->start);
    jlt_balanced_levels_of(&out->levels, top, x);
    if (tier != NULL && tier->refuses == needs_halves && v_slip < 0) out->mirror = -1;
}

bool jlt_tier_has(const jlt_descriptor *model)
{
    static const char *const states[JLT_TOP_STATES] = { "gamma3", "v_nu", "omega_tau", "omega_n", "omega3" };

    if (strcmp(model->model, "spherical_top") != 0 || model->state_count != JLT_TOP_STATES) return false;
    for (unsigned i = 0; i < JLT_TOP_STATES; i++)
        if (strcmp(model->states[i].name, states[i]) != 0) return false;
    return true;
}

jlt_status jlt_tier_open(jlt_tier_view *told, jlt_tier_view *view, jlt_units *units, double *params, const jlt_tier *tier,
                         const jlt_descriptor *kernel, const jlt_descriptor *model, const double *told_params, const double *x)
{
    double start[JLT_TOP_STATES];
    bool scales = false;
    jlt_top top;
    jlt_status st = JLT_OK;

    JLT_TRY(jlt_top_read(&top, model, told_params));
    jlt_tier_look(told, tier, kernel, &top, x);
    *units = jlt_level_units(&top, jlt_top_energy(&top, x));
    JLT_TRY(jlt_instance_scales(&scales, model, told_params, units));
    if (!scales) *units = (jlt_units){ 0 };
    jlt_units_count(params, told_params, model->params, model->param_count, units);
    jlt_units_count(start, x, model->states, JLT_TOP_STATES, units);
    JLT_TRY(jlt_top_read(&top, model, params));
    jlt_tier_look(view, tier, kernel, &top, start);
    told->asked = view->asked = model;
    told->asked_params = told_params;
    view->asked_params = params;
done:
    return st;
}

int jlt_tier_settle(double *x, bool ends)
{
    const int side = !ends ? 0 : x[JLT_TOP_GAMMA3] > 0 ? 1 : -1;

    x[JLT_TOP_GAMMA3] = ends ? side : fmax(-1, fmin(1, x[JLT_TOP_GAMMA3])); /* it may pass 1 by a rounding error */
    return side;
}

void jlt_tier_pole_text(char pole[JLT_TIER_TEXT_MAX], char limits[JLT_TIER_TEXT_MAX], const double *x)
{
    const int size = JLT_TIER_TEXT_MAX;
    const int used = snprintf(limits, (size_t)size, "v_nu = %.10g, omega_tau = %.10g", x[JLT_TOP_V_NU], x[JLT_TOP_OMEGA_TAU]);

    snprintf(pole, (size_t)size, "gamma3 = %+.0f", x[JLT_TOP_GAMMA3]);
    if (isfinite(x[JLT_TOP_OMEGA3])) snprintf(limits + used, (size_t)(size - used), ", omega3 = %.10g", x[JLT_TOP_OMEGA3]);
    else snprintf(limits + used, (size_t)(size - used), " (there I3 b = 0, and G and v_tau do not tell omega3)");
}

jlt_status jlt_tier_params(double *params, const jlt_tier_view *view)
{
    const struct {
        const char *name;
        double value;
    } known[] = { { "m", view->top.m }, { "R", view->top.R }, { "g", view->top.g }, { "a3", view->top.a3 },
                  { "I1", view->top.I1 }, { "I3", view->top.I3 }, { "G", view->G }, { "G_level", view->G },
                  { "M", view->levels.M }, { "F0", view->levels.F0 } };

    for (unsigned i = 0; i < view->descriptor->param_count; i++) {
        const char *name = view->descriptor->params[i].name;
        size_t k = 0;
        if (view->asked != NULL && jlt_descriptor_param(view->asked, name, &k)) {
            params[i] = view->asked_params[k];
            continue;
        }
        for (k = 0; k < sizeof known / sizeof *known && strcmp(known[k].name, name) != 0;) k++;
        if (k == sizeof known / sizeof *known) return JLT_ERR_UNSUPPORTED;
        params[i] = known[k].value;
    }
    return JLT_OK;
}
