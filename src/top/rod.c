#include "top/rod.h"

#include "ext/quadrature.h"
#include "kernel/descriptor.h"
#include "kernel/way.h"

#include <math.h>
#include <string.h>

enum { NEWTON_MAX = 60 };

static const double quadrature_accuracy = 2e-14;

/* P at the distance d from the pole gamma3 = side. */
static double force_at(const jlt_rod *rod, double side, double d)
{
    const jlt_top *top = &rod->top;
    const double weight = top->m * top->g * top->a3;
    return 2 * d * (2 - d) * (rod->E2 - side * weight + side * weight * d) - rod->G * rod->G / (top->I1 * top->R * top->R);
}

/* The root of P between the pole, where it is negative, and `inside`, where it is not: bisection to neighbouring numbers. */
static double turning_point(const jlt_rod *rod, double side, double inside)
{
    double low = 0, high = inside;

    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return high;
        if (force_at(rod, side, middle) < 0) low = middle;
        else high = middle;
    }
}

/* gamma3 and s^2 at u. */
static void tilt(const jlt_rod *rod, double *gamma3, double *s2, double u)
{
    const double sine = sin(u / 2), cosine = cos(u / 2);
    const double from_below = rod->below + 2 * rod->half * sine * sine;
    const double from_above = rod->above + 2 * rod->half * cosine * cosine;
    *gamma3 = from_below < from_above ? from_below - 1 : 1 - from_above;
    *s2 = from_below * from_above;
}

static double pace(const jlt_rod *rod, double gamma3, double s2)
{
    const jlt_top *top = &rod->top;
    const double D = top->I1 + top->m * top->a3 * top->a3 * s2;
    const double Q = 2 * rod->E2 - 2 * top->m * top->g * top->a3 * (gamma3 + rod->below - rod->above);
    return sqrt(D / Q);
}

static jlt_status time_rate(void *context, double *value, double u)
{
    double gamma3, s2;

    tilt(context, &gamma3, &s2, u);
    *value = pace(context, gamma3, s2);
    return isfinite(*value) ? JLT_OK : JLT_ERR_NONFINITE;
}

static jlt_status turn_rate(void *context, double *value, double u)
{
    const jlt_rod *rod = context;
    double gamma3, s2;

    tilt(rod, &gamma3, &s2, u);
    *value = -rod->G / (rod->top.I1 * rod->top.R * s2) * pace(rod, gamma3, s2);
    return isfinite(*value) ? JLT_OK : JLT_ERR_NONFINITE;
}

static jlt_status over(jlt_rod *rod, double *integral, jlt_quadrature_integrand rate, double from, double to)
{
    double error;

    *integral = 0;
    if (from == to) return JLT_OK;
    return jlt_quadrature_integrate(integral, &error, rate, rod, from, to, 1e-300, quadrature_accuracy);
}

static void find_turning_points(jlt_rod *rod, const double *x)
{
    const jlt_top *top = &rod->top;
    const double weight = top->m * top->g * top->a3;
    /* where P is largest */
    const double crest = -weight / (rod->E2 + sqrt(rod->E2 * rod->E2 + 3 * weight * weight));
    const double inside = force_at(rod, 1, 1 - crest) > 0 ? crest : x[JLT_TOP_GAMMA3];

    rod->below = turning_point(rod, -1, 1 + inside);
    rod->above = turning_point(rod, 1, 1 - inside);
    rod->half = fmax(0, (2 - rod->below - rod->above) / 2);
}

jlt_status jlt_rod_open(jlt_rod *out, const jlt_top *top, const double *x)
{
    jlt_status st = JLT_OK;
    jlt_rod rod = { .top = *top };
    const double gamma3 = x[JLT_TOP_GAMMA3], s = jlt_top_sine(gamma3), v_tau = jlt_top_v_tau(top, x);
    double s2, u, turned;

    if (top->I3 != 0) return JLT_ERR_ARG;
    if (!(s > 0)) return JLT_ERR_DOMAIN;
    rod.G = jlt_top_jellett(top, x);
    if (rod.G == 0) return JLT_ERR_DOMAIN;
    rod.speed = hypot(x[JLT_TOP_V_NU], v_tau);
    rod.E1 = top->m * rod.speed * rod.speed / 2;
    rod.E2 = (top->I1 * x[JLT_TOP_OMEGA_N] * x[JLT_TOP_OMEGA_N]
              + (top->I1 + top->m * top->a3 * top->a3 * s * s) * x[JLT_TOP_OMEGA_TAU] * x[JLT_TOP_OMEGA_TAU]) / 2
             + top->m * top->g * top->a3 * gamma3;
    if (!isfinite(rod.E1) || !isfinite(rod.E2) || !isfinite(rod.G)) return JLT_ERR_NONFINITE;
    find_turning_points(&rod, x);
    s2 = s * s;
    /* gamma3' = half sin u / pace, and gamma3 = mid - half cos u */
    u = atan2(s * x[JLT_TOP_OMEGA_TAU] * pace(&rod, gamma3, s2), (rod.below - rod.above) / 2 - gamma3);
    rod.psi = atan2(v_tau, x[JLT_TOP_V_NU]); /* here; at the lower turning point below */
    JLT_TRY(over(&rod, &rod.period, time_rate, 0, acos(-1)));
    JLT_TRY(over(&rod, &rod.turn, turn_rate, 0, acos(-1)));
    rod.period *= 2;
    rod.turn *= 2;
    JLT_TRY(over(&rod, &rod.elapsed, time_rate, 0, u));
    JLT_TRY(over(&rod, &turned, turn_rate, 0, u));
    rod.psi -= turned;
    *out = rod;
done:
    return st;
}

double jlt_rod_rotation(const jlt_rod *rod)
{
    return rod->turn / (2 * acos(-1));
}

/* u within the period at the time `wanted` after the lower turning point, |wanted| <= period/2: Newton's method, the time
 * counted from the turning point, so that no error builds up. The time grows with u: where a step leaves the bounds, or does not
 * halve what is left, as beside a pole where the pace is steep, the middle between them is taken. */
static jlt_status locate(jlt_rod *rod, double *u, double wanted)
{
    jlt_status st = JLT_OK;
    const double pi = acos(-1);
    double at = 2 * pi * wanted / rod->period, low = -1.5 * pi, high = 1.5 * pi, last = INFINITY, now, rate;

    for (int i = 0; i < NEWTON_MAX; i++) {
        JLT_TRY(over(rod, &now, time_rate, 0, at));
        JLT_TRY(time_rate(rod, &rate, at));
        const double change = (wanted - now) / rate;
        if (fabs(change) <= 1e-9) { /* quadratic convergence: this change is the last that counts */
            at += change;
            goto done;
        }
        if (now < wanted) low = at;
        else high = at;
        const bool halves = fabs(wanted - now) < last / 2;
        last = fabs(wanted - now);
        at = halves && at + change > low && at + change < high ? at + change : low + (high - low) / 2;
    }
    st = JLT_ERR_NO_CONVERGENCE;
done:
    if (st == JLT_OK) *u = at;
    return st;
}

jlt_status jlt_rod_at(jlt_rod *rod, double *x, double t)
{
    jlt_status st = JLT_OK;
    const jlt_top *top = &rod->top;
    const double since = rod->elapsed + t;
    const double periods = nearbyint(since / rod->period);
    double u, psi, gamma3, s2, s, v_tau;

    if (!isfinite(t)) return JLT_ERR_NONFINITE;
    JLT_TRY(locate(rod, &u, fma(-periods, rod->period, since)));
    JLT_TRY(over(rod, &psi, turn_rate, 0, u));
    psi += rod->psi + periods * rod->turn;
    tilt(rod, &gamma3, &s2, u);
    s = sqrt(s2);
    v_tau = rod->speed * sin(psi);
    x[JLT_TOP_GAMMA3] = gamma3;
    x[JLT_TOP_V_NU] = rod->speed * cos(psi);
    x[JLT_TOP_OMEGA_TAU] = rod->half * sin(u) / (pace(rod, gamma3, s2) * s);
    x[JLT_TOP_OMEGA_N] = rod->G / (top->I1 * top->R * s);
    x[JLT_TOP_OMEGA3] = (v_tau - (top->a3 + top->R * gamma3) * x[JLT_TOP_OMEGA_N]) / (top->R * s);
done:
    return st;
}

/* The energies of rotation and of the centre of mass, and Jellett's integral; and the table on a level of the latter, whose equations these
 * quadratures solve. */
static const char *const integrals[] = { "E1", "E2", "G" };
static const char level[] = "spherical_top_level";

const char jlt_rod_meaning[] = "I3 = 0: tilt, turn and time by quadratures, nothing is integrated in time";

bool jlt_rod_is_known(const jlt_descriptor *model)
{
    static const char *const states[JLT_TOP_STATES] = { "gamma3", "v_nu", "omega_tau", "omega_n", "omega3" };
    static const char *const params[] = { "m", "R", "g", "a3", "I1", "I3" };
    size_t index;

    if (model->state_count != JLT_TOP_STATES) return false;
    for (unsigned i = 0; i < JLT_TOP_STATES; i++)
        if (strcmp(model->states[i].name, states[i]) != 0) return false;
    for (unsigned i = 0; i < sizeof params / sizeof *params; i++)
        if (!jlt_descriptor_param(model, params[i], &index)) return false;
    for (unsigned i = 0; i < sizeof integrals / sizeof *integrals; i++)
        if (jlt_descriptor_claim(model, "integral", integrals[i]) == NULL) return false;
    return true;
}

static const jlt_way *way_to(const jlt_descriptor *model, const jlt_descriptor *table)
{
    for (unsigned i = 0; i < model->way_count; i++)
        if (strcmp(model->ways[i].sha256, table->sha256) == 0 && model->ways[i].condition_count == 0) return &model->ways[i];
    return NULL;
}

const char *jlt_rod_refuses(const jlt_claim **broken, const jlt_descriptor *model, const double *params, const double *x)
{
    const jlt_descriptor *table = jlt_descriptor_find(level, NULL, NULL, NULL);
    const jlt_way *way;
    jlt_top top;

    *broken = NULL;
    if (jlt_top_read(&top, model, params) != JLT_OK) return "the parameters are not those of a top";
    if (top.I3 != 0) return "I3 is not 0";
    if (x != NULL && jlt_top_jellett(&top, x) == 0) return "G = 0: the orbit runs through the poles";
    if (table == NULL || (way = way_to(model, table)) == NULL) return "no way leads to the table whose equations they solve";
    if (!jlt_way_holds(broken, model, way, table)) return "a claim that it rests on is not proved";
    for (unsigned i = 0; i < sizeof integrals / sizeof *integrals; i++) {
        *broken = jlt_descriptor_claim(model, "integral", integrals[i]);
        if ((*broken)->verdict != JLT_PROVED) return "a claim that it rests on is not proved";
    }
    *broken = NULL;
    return NULL;
}
