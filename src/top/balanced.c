#include "top/balanced.h"

#include <math.h>

static double theta(const jlt_top *top, double gamma3, double s)
{
    return top->I1 * top->I3 + top->m * top->R * top->R * (top->I1 * s * s + top->I3 * gamma3 * gamma3);
}

/* The momentum about the contact point along tau (reversed) and nu: M sin psi and M cos psi. */
static void momentum(const jlt_top *top, double *sine, double *cosine, const double *x)
{
    const double s = jlt_top_sine(x[JLT_TOP_GAMMA3]), mR2 = top->m * top->R * top->R;
    *sine = top->m * top->R * x[JLT_TOP_V_NU] - top->I1 * x[JLT_TOP_OMEGA_TAU];
    *cosine = x[JLT_TOP_GAMMA3] * (top->I1 + mR2) * x[JLT_TOP_OMEGA_N] + s * (top->I3 + mR2) * x[JLT_TOP_OMEGA3];
}

static double third_integral(const jlt_top *top, const double *x)
{
    const double s = jlt_top_sine(x[JLT_TOP_GAMMA3]);
    const double v_slip = x[JLT_TOP_V_NU] + top->R * x[JLT_TOP_OMEGA_TAU];
    return top->m * top->I1 * top->I1 * v_slip * v_slip
           + (top->I1 - top->I3) * theta(top, x[JLT_TOP_GAMMA3], s) * x[JLT_TOP_OMEGA3] * x[JLT_TOP_OMEGA3];
}

void jlt_balanced_levels_of(jlt_balanced_levels *out, const jlt_top *top, const double *x)
{
    double sine, cosine;

    momentum(top, &sine, &cosine, x);
    out->E = jlt_top_energy(top, x);
    out->G = jlt_top_jellett(top, x);
    out->F0 = third_integral(top, x);
    out->M = hypot(sine, cosine);
}

/* v_slip^2 >= 0 somewhere: Theta omega3^2 is 0 at the equator, where cos psi = 0; and with u = (s, gamma3), cos psi = +-1, it is
 * (a u)^2/(u D u) for a = (I1 M, (I1 + m R^2) |G|/R) and D = diag(I1 (I3 + m R^2), I3 (I1 + m R^2)), whose maximum is a D^-1 a. */
static double least_third_integral(const jlt_top *top, const jlt_balanced_levels *levels)
{
    const double mR2 = top->m * top->R * top->R, vertical = levels->G / top->R;

    if (top->I1 >= top->I3) return 0;
    return (top->I1 - top->I3)
           * (top->I1 * levels->M * levels->M / (top->I3 + mR2) + (top->I1 + mR2) * vertical * vertical / top->I3);
}

jlt_status jlt_balanced_complete(jlt_balanced_levels *levels, const jlt_top *top)
{
    const double J1 = top->I1 + top->m * top->R * top->R;
    const double left = 2 * levels->E - levels->G * levels->G / (top->R * top->R * top->I1);
    const double M2 = J1 * left - levels->F0 / top->I1;

    if (!(M2 >= 0)) return JLT_ERR_EMPTY;
    levels->M = sqrt(M2);
    if (!(levels->F0 >= least_third_integral(top, levels))) return JLT_ERR_EMPTY;
    return JLT_OK;
}

static void spin_rates(const jlt_top *top, const jlt_balanced_levels *levels, double *omega_n, double *omega3,
                       double gamma3, double s, double psi)
{
    const double mR2 = top->m * top->R * top->R, Theta = theta(top, gamma3, s);
    const double along = levels->M * cos(psi), vertical = levels->G / top->R;
    *omega_n = ((top->I3 + mR2) * s * vertical + top->I3 * gamma3 * along) / Theta;
    *omega3 = (top->I1 * s * along - (top->I1 + mR2) * gamma3 * vertical) / Theta;
}

static double slip2(const jlt_top *top, const jlt_balanced_levels *levels, double gamma3, double s, double psi)
{
    double omega_n, omega3;

    spin_rates(top, levels, &omega_n, &omega3, gamma3, s, psi);
    return (levels->F0 - (top->I1 - top->I3) * theta(top, gamma3, s) * omega3 * omega3) / (top->m * top->I1 * top->I1);
}

double jlt_balanced_slip(const jlt_top *top, const jlt_balanced_levels *levels, double gamma3, double s, double psi)
{
    return sqrt(slip2(top, levels, gamma3, s, psi));
}

void jlt_balanced_from_state(const jlt_top *top, double *gamma3, double *v_slip, double *psi, const double *x)
{
    double sine, cosine;

    momentum(top, &sine, &cosine, x);
    *gamma3 = x[JLT_TOP_GAMMA3];
    *v_slip = x[JLT_TOP_V_NU] + top->R * x[JLT_TOP_OMEGA_TAU];
    *psi = atan2(sine, cosine);
}

void jlt_balanced_to_state(const jlt_top *top, const jlt_balanced_levels *levels, double *x, double gamma3, double s,
                           double v_slip, double psi)
{
    const double mR = top->m * top->R, J1 = top->I1 + mR * top->R, across = levels->M * sin(psi);

    x[JLT_TOP_GAMMA3] = gamma3;
    x[JLT_TOP_V_NU] = (top->I1 * v_slip + top->R * across) / J1;
    x[JLT_TOP_OMEGA_TAU] = (mR * v_slip - across) / J1;
    spin_rates(top, levels, &x[JLT_TOP_OMEGA_N], &x[JLT_TOP_OMEGA3], gamma3, s, psi);
}

static void classify(jlt_fixed_point *point, const jlt_top *top, double gamma3, double v0, double w0)
{
    const double s = jlt_top_sine(gamma3), Theta = theta(top, gamma3, s);
    const double mR2 = top->m * top->R * top->R;
    double half, root2;

    *point = (jlt_fixed_point){ .x = { gamma3, v0, 0, 0, w0 } };
    jlt_balanced_from_state(top, &gamma3, &point->v_slip, &point->psi, point->x);
    point->trace = -top->m * top->R * top->I3 * gamma3 * v0 / (s * Theta);
    point->determinant = top->I3 * top->I3 * w0 * w0 * (top->I3 + mR2) / (top->I1 * Theta);
    half = point->trace / 2;
    root2 = half * half - point->determinant;
    point->focus = root2 < 0;
    if (point->focus) {
        point->re[0] = point->re[1] = half;
        point->im[0] = sqrt(-root2);
        point->im[1] = -point->im[0];
    } else {
        const double far = half + copysign(sqrt(root2), half); /* the other by the product: nothing cancels */
        point->re[0] = far;
        point->re[1] = far != 0 ? point->determinant / far : 0;
    }
    point->kind = point->trace < 0 ? JLT_FIXED_ATTRACTING : point->trace > 0 ? JLT_FIXED_REPELLING : JLT_FIXED_CENTRE;
}

/* G != 0: omega_n = 0 gives w0 = -G/(R I3 gamma3), and the two levels are linear in u = gamma3^2. */
static unsigned tilted(jlt_fixed_point *out, const jlt_top *top, const jlt_balanced_levels *levels)
{
    const double mR2 = top->m * top->R * top->R, I1 = top->I1, I3 = top->I3;
    const double w = levels->G / (top->R * I3), w2 = w * w; /* |w0 gamma3| */
    const double J3 = I3 + mR2, share = mR2 / (I1 * I1);
    /* M^2 u = J3^2 (1 - u) w2 + share (F0 u - (I1 - I3) Theta(u) w2), Theta(u) = I1 J3 + m R^2 (I3 - I1) u */
    const double constant = J3 * J3 * w2 - share * (I1 - I3) * I1 * J3 * w2;
    const double slope = levels->M * levels->M + J3 * J3 * w2 - share * (levels->F0 + (I1 - I3) * (I1 - I3) * mR2 * w2);
    const double u = constant / slope;
    unsigned count = 0;

    if (!(u > 0 && u < 1)) return 0;
    for (int side = -1; side <= 1; side += 2) {
        const double gamma3 = side * sqrt(u), w0 = -w / gamma3;
        const double Theta = theta(top, gamma3, sqrt(1 - u));
        const double v2 = (levels->F0 - (I1 - I3) * Theta * w0 * w0) / (top->m * I1 * I1);
        if (!(v2 >= 0)) continue;
        classify(&out[count++], top, gamma3, sqrt(v2), w0);
        if (v2 > 0) classify(&out[count++], top, gamma3, -sqrt(v2), w0);
    }
    return count;
}

/* G = 0: the equator, w0 and v0 free there, both from M and F0. */
static unsigned equatorial(jlt_fixed_point *out, const jlt_top *top, const jlt_balanced_levels *levels)
{
    const double mR2 = top->m * top->R * top->R, I1 = top->I1, I3 = top->I3, J3 = I3 + mR2;
    /* M^2 = J3^2 w^2 + m R^2 (m v^2),  F0/I1^2 = m v^2 + (I1 - I3) J3 w^2/I1 */
    const double mv2_at_rest = levels->F0 / (I1 * I1);
    const double w2 = (levels->M * levels->M - mR2 * mv2_at_rest) / (J3 * (J3 - mR2 * (I1 - I3) / I1));
    const double v2 = (mv2_at_rest - (I1 - I3) * J3 * w2 / I1) / top->m;
    unsigned count = 0;

    if (!(w2 > 0 && v2 >= 0)) return 0;
    for (int spin = -1; spin <= 1; spin += 2) {
        classify(&out[count++], top, 0, sqrt(v2), spin * sqrt(w2));
        if (v2 > 0) classify(&out[count++], top, 0, -sqrt(v2), spin * sqrt(w2));
    }
    return count;
}

jlt_status jlt_balanced_fixed_points(jlt_fixed_point out[4], unsigned *count, const jlt_top *top,
                                     const jlt_balanced_levels *levels)
{
    *count = 0;
    if (!(top->I3 > 0)) return JLT_ERR_UNSUPPORTED;
    *count = levels->G != 0 ? tilted(out, top, levels) : equatorial(out, top, levels);
    return levels->G == 0 && *count == 0 ? JLT_ERR_UNSUPPORTED : JLT_OK;
}

/* Multiples of the golden section's generalization in two dimensions (M. Roberts, 2018). */
bool jlt_balanced_start(const jlt_top *top, const jlt_balanced_levels *levels, double *x, size_t number)
{
    static const double g = 1.32471795724474602596;
    const double u = fmod(0.5 + (double)(number + 1) / g, 1), v = fmod(0.5 + (double)(number + 1) / (g * g), 1);
    const double psi = acos(-1) * (2 * u - 1), gamma3 = 2 * v - 1, s = jlt_top_sine(gamma3);
    const double v_slip = jlt_balanced_slip(top, levels, gamma3, s, psi);

    if (isnan(v_slip) || !(s > 0.02)) return false;
    jlt_balanced_to_state(top, levels, x, gamma3, s, number % 2 == 0 ? v_slip : -v_slip, psi);
    return true;
}
