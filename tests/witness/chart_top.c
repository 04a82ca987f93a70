#include "witness/chart_top.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

typedef struct {
    double s2, b, K, Theta, D;
} geometry;

static geometry at(const jlt_chart_top *self, double gamma3, double s)
{
    geometry here;

    here.s2 = s * s;
    here.b = self->a3 + self->R * gamma3;
    here.K = self->I1 * self->R * self->R * here.s2 + self->I3 * here.b * here.b;
    here.Theta = self->m * here.K + self->I1 * self->I3;
    here.D = self->I1 + self->m * self->a3 * self->a3 * here.s2;
    return here;
}

static double root_of(double gamma3)
{
    return sqrt((1 - gamma3) * (1 + gamma3));
}

static double speed2(const jlt_chart_top *self, double gamma3, double K)
{
    return (2 * (self->E - self->m * self->g * self->a3 * gamma3) - self->G * self->G / K) / self->m;
}

/* dK/dgamma3 along the section, where s^2 = 1 - gamma3^2. */
static double slope_of_K(const jlt_chart_top *self, double gamma3, double b)
{
    return 2 * self->R * (self->I3 * b - self->I1 * self->R * gamma3);
}

/* The nearest numbers to odd multiples of pi/2 and to those of pi mean these themselves: a v_tau or v_nu of rounding size would
 * decide how an orbit that runs through a pole goes on. */
static void direction(double *sine, double *cosine, double eta)
{
    const double last_digit = DBL_EPSILON * fmax(1, fabs(eta) / 2);

    *sine = sin(eta);
    *cosine = cos(eta);
    if (fabs(*sine) < last_digit) *sine = 0, *cosine = *cosine > 0 ? 1 : -1;
    if (fabs(*cosine) < last_digit) *cosine = 0, *sine = *sine > 0 ? 1 : -1;
}

static jlt_status lift(const jlt_chart *base, double *x, double *tangent, const double *q)
{
    const jlt_chart_top *self = (const jlt_chart_top *)base;
    const double eta = q[0], gamma3 = q[1];
    geometry here;
    double sine, cosine, W2, W, ratio, K_slope, W_slope, ratio_slope;

    if (!isfinite(eta) || !isfinite(gamma3)) return JLT_ERR_NONFINITE;
    if (gamma3 <= -1 || gamma3 >= 1) return JLT_ERR_DOMAIN;
    here = at(self, gamma3, root_of(gamma3));
    W2 = speed2(self, gamma3, here.K);
    if (!(W2 > 0)) return JLT_ERR_EMPTY;
    W = sqrt(W2);
    direction(&sine, &cosine, eta);
    ratio = sqrt(self->m * here.K / here.Theta);
    x[JLT_CHART_TOP_GAMMA3] = gamma3;
    x[JLT_CHART_TOP_V_NU] = W * sine;
    x[JLT_CHART_TOP_OMEGA_TAU] = 0;
    x[JLT_CHART_TOP_V_TAU] = W * ratio * cosine;
    x[JLT_CHART_TOP_S] = root_of(gamma3);
    if (tangent == NULL) return JLT_OK;

    /* W W' = (G^2 K'/K^2 / 2 - m g a3)/m;  ratio^2 = m K/Theta, so ratio'/ratio = K' I1 I3/(2 K Theta). */
    K_slope = slope_of_K(self, gamma3, here.b);
    W_slope = (self->G * self->G * K_slope / (2 * here.K * here.K) - self->m * self->g * self->a3) / (self->m * W);
    ratio_slope = ratio * K_slope * self->I1 * self->I3 / (2 * here.K * here.Theta);
    memset(tangent, 0, sizeof *tangent * base->states * base->dim);
    tangent[2 * JLT_CHART_TOP_GAMMA3 + 1] = 1;
    tangent[2 * JLT_CHART_TOP_V_NU] = W * cosine;
    tangent[2 * JLT_CHART_TOP_V_NU + 1] = W_slope * sine;
    tangent[2 * JLT_CHART_TOP_V_TAU] = -W * ratio * sine;
    tangent[2 * JLT_CHART_TOP_V_TAU + 1] = (W_slope * ratio + W * ratio_slope) * cosine;
    tangent[2 * JLT_CHART_TOP_S + 1] = -gamma3 / x[JLT_CHART_TOP_S];
    return JLT_OK;
}

static void lower(const jlt_chart *base, double *q, double *slope, const double *x)
{
    const jlt_chart_top *self = (const jlt_chart_top *)base;
    const geometry here = at(self, x[JLT_CHART_TOP_GAMMA3], x[JLT_CHART_TOP_S]);
    const double v_nu = x[JLT_CHART_TOP_V_NU], v_tau = x[JLT_CHART_TOP_V_TAU];
    const double ratio = sqrt(self->m * here.K / here.Theta), u = v_tau / ratio;
    double W2, K_slope;

    q[0] = atan2(v_nu, u);
    q[1] = fmax(-1, fmin(1, x[JLT_CHART_TOP_GAMMA3])); /* near a pole it may pass 1 by a rounding error */
    if (slope == NULL) return;

    /* eta = atan2(v_nu, u), u = v_tau/ratio; the derivative in gamma3 goes along s^2 = 1 - gamma3^2, so that s itself
     * gets none: tangent vectors of the flow satisfy the relation. */
    W2 = v_nu * v_nu + u * u;
    K_slope = slope_of_K(self, x[JLT_CHART_TOP_GAMMA3], here.b);
    memset(slope, 0, sizeof *slope * base->states * base->dim);
    slope[JLT_CHART_TOP_V_NU] = u / W2;
    slope[JLT_CHART_TOP_V_TAU] = -v_nu / (W2 * ratio);
    slope[JLT_CHART_TOP_GAMMA3] = v_nu * u * K_slope * self->I1 * self->I3 / (2 * here.K * here.Theta * W2);
    slope[base->states + JLT_CHART_TOP_GAMMA3] = 1;
}

/* Volume dgamma3 dv_nu domega_tau dv_tau = (dt omega_tau') dE deta dgamma3 * d(v_nu, v_tau)/d(eta, E), and the last factor
 * is W ratio dW/dE = ratio/m. The lifted field keeps s^2 + gamma3^2 exactly, so that the trace of its Jacobian is the
 * divergence on s^2 + gamma3^2 = 1, whose volume carries 1/(2s); f holds s omega_tau'. */
static double flux(const jlt_chart *base, const double *x, const double *f)
{
    const jlt_chart_top *self = (const jlt_chart_top *)base;
    const geometry here = at(self, x[JLT_CHART_TOP_GAMMA3], x[JLT_CHART_TOP_S]);

    return sqrt(here.K / (self->m * here.Theta)) * f[JLT_CHART_TOP_OMEGA_TAU] / x[JLT_CHART_TOP_S];
}

static int side(const jlt_chart *base, double *x)
{
    const int sign = x[JLT_CHART_TOP_GAMMA3] > 0 ? 1 : -1;

    (void)base;
    x[JLT_CHART_TOP_GAMMA3] = sign;
    x[JLT_CHART_TOP_S] = 0;
    return sign;
}

void jlt_chart_top_init(jlt_chart_top *out, double m, double R, double g, double I1, double I3, double a3, double E,
                        double G)
{
    memset(out, 0, sizeof *out);
    out->base.dim = 2;
    out->base.states = 5;
    out->base.column = JLT_CHART_TOP_OMEGA_TAU;
    out->base.names[0] = "eta";
    out->base.names[1] = "gamma3";
    out->base.period[0] = 2 * pi;
    out->base.reversible = true;
    out->base.mirror[0] = -1;
    out->base.mirror[1] = 1;
    out->base.lift = lift;
    out->base.lower = lower;
    out->base.flux = flux;
    out->base.side = side;
    out->m = m;
    out->R = R;
    out->g = g;
    out->I1 = I1;
    out->I3 = I3;
    out->a3 = a3;
    out->E = E;
    out->G = G;
}

double jlt_chart_top_speed2(const jlt_chart_top *self, double gamma3)
{
    return speed2(self, gamma3, at(self, gamma3, root_of(gamma3)).K);
}

void jlt_chart_top_rotation(const jlt_chart_top *self, double *omega_n, double *omega3, const double *x)
{
    const double s = x[JLT_CHART_TOP_S], v_tau = x[JLT_CHART_TOP_V_TAU];
    const geometry here = at(self, x[JLT_CHART_TOP_GAMMA3], s);

    if (here.K == 0) {
        *omega_n = *omega3 = NAN;
        return;
    }
    *omega_n = (self->R * s * self->G + self->I3 * here.b * v_tau) / here.K;
    *omega3 = (self->I1 * self->R * s * v_tau - here.b * self->G) / here.K;
}

double jlt_chart_top_energy(const jlt_chart_top *self, const double *x)
{
    const double gamma3 = x[JLT_CHART_TOP_GAMMA3], v_nu = x[JLT_CHART_TOP_V_NU];
    const double omega_tau = x[JLT_CHART_TOP_OMEGA_TAU], v_tau = x[JLT_CHART_TOP_V_TAU];
    const geometry here = at(self, gamma3, x[JLT_CHART_TOP_S]);

    return (self->m * v_nu * v_nu + here.D * omega_tau * omega_tau + here.Theta / here.K * v_tau * v_tau +
            self->G * self->G / here.K) / 2 + self->m * self->g * self->a3 * gamma3;
}

void jlt_chart_top_state(const jlt_chart_top *self, double *x, double gamma3, double v_nu, double omega_tau,
                         double omega_n, double omega3)
{
    const double s = root_of(gamma3);

    x[JLT_CHART_TOP_GAMMA3] = gamma3;
    x[JLT_CHART_TOP_V_NU] = v_nu;
    x[JLT_CHART_TOP_OMEGA_TAU] = omega_tau;
    x[JLT_CHART_TOP_V_TAU] = (self->a3 + self->R * gamma3) * omega_n + self->R * s * omega3;
    x[JLT_CHART_TOP_S] = s;
}

/* The end of the interval from a point inside towards another: between the two, or there. */
static double edge(const jlt_chart_top *chart, double inside, double outside)
{
    int i;

    if (jlt_chart_top_speed2(chart, outside) > 0) return outside;
    for (i = 0; i < 60; i++) {
        const double middle = (inside + outside) / 2;
        if (jlt_chart_top_speed2(chart, middle) > 0) inside = middle;
        else outside = middle;
    }
    return inside;
}

bool jlt_chart_top_interval(const jlt_chart_top *chart, double *low, double *high)
{
    enum { POINTS = 4096 };
    double start = 0, before = -1;
    bool open = false, found = false;
    int i;

    for (i = 0; i <= POINTS; i++) {
        const double at = -1 + 2 * (i + 0.5) / POINTS;
        const bool inside = i < POINTS && jlt_chart_top_speed2(chart, at) > 0;
        if (inside && !open) start = edge(chart, at, i == 0 ? -1 + 1e-9 : before);
        if (!inside && open) {
            const double end = edge(chart, before, i == POINTS ? 1 - 1e-9 : at);
            if (!found || end - start > *high - *low) *low = start, *high = end;
            found = true;
        }
        open = inside;
        before = at;
    }
    return found;
}
