#include "top/rod.h"

#include "ext/quadrature.h"
#include "kernel/descriptor.h"
#include "kernel/way.h"

#include <math.h>
#include <string.h>

enum { NEWTON_MAX = 60 };

static const double quadrature_accuracy = 2e-14;

/* Integrals of the variant: the energies of the centre of mass and of rotation, and Jellett's integral. */
static const char *const integrals[] = { "E1", "E2", "G", NULL };
static const char variant[] = "rod";

const char jlt_rod_table[] = "spherical_top_level";

enum { LEVEL_STATES = 5 }; /* including s */

/* Whether the table on a level of G has the expected states. */
static bool has_level(void)
{
    const jlt_descriptor *table = jlt_descriptor_find(jlt_rod_table, NULL, NULL, NULL);
    static const char *const states[LEVEL_STATES - 1] = { "gamma3", "v_nu", "omega_tau", "v_tau" };

    if (table == NULL || table->state_count != LEVEL_STATES - 1 || jlt_top_way(jlt_rod_table) == NULL) return false;
    for (unsigned i = 0; i < LEVEL_STATES - 1; i++)
        if (strcmp(table->states[i].name, states[i]) != 0) return false;
    return jlt_top_way(jlt_rod_table)->state_count == LEVEL_STATES && table->param_count <= JLT_WAY_VALUES_MAX;
}

/* P at distance d from the pole gamma3 = side. */
static double force_at(const jlt_rod *rod, double side, double d)
{
    const double u = side * (1 - side * rod->start - d); /* gamma3 minus its value at the start */

    if (fabs(u) < (1 - fabs(rod->start)) / 2) return rod->force + u * (rod->slope + u * (rod->bend + u * 2 * rod->weight));
    return 2 * d * (2 - d) * (rod->kinetic + rod->weight * (rod->start - side) + side * rod->weight * d) - rod->barrier;
}

/* The distance from the pole `side` of the root of P between the distance `outside`, where P is negative, and `inside`, where it is
 * not, by bisection down to neighbouring doubles. */
static double turning_point(const jlt_rod *rod, double side, double outside, double inside)
{
    for (;;) {
        const double middle = outside + (inside - outside) / 2;
        if (middle == outside || middle == inside) return inside;
        if (force_at(rod, side, middle) < 0) outside = middle;
        else inside = middle;
    }
}

/* A tilt, by its distances from the poles. */
typedef struct {
    double below, above; /* 1 + gamma3, 1 - gamma3 */
} tilt;

static double gamma3_of(tilt at) { return at.below < at.above ? at.below - 1 : 1 - at.above; }

static double s2_of(tilt at) { return at.below * at.above; }

/* The tilt at the angle u. */
static tilt tilt_at(const jlt_rod *rod, double u)
{
    const double sine = sin(u / 2), cosine = cos(u / 2);
    return (tilt){ rod->below + 2 * rod->half * sine * sine, rod->above + 2 * rod->half * cosine * cosine };
}

/* dt/du = sqrt(D/Q). */
static double pace(const jlt_rod *rod, tilt at)
{
    const double gamma3 = gamma3_of(at), across = 2 * rod->half;
    const double D = rod->inertia_pole * gamma3 * gamma3 + rod->inertia_equator * s2_of(at);
    const double upper = at.below / (rod->above * (rod->above + across)), lower = at.above / (rod->below * (rod->below + across));
    return sqrt(D / (rod->barrier / 2 * (upper + lower)));
}

static jlt_status time_rate(void *context, double *value, double u)
{
    *value = pace(context, tilt_at(context, u));
    return isfinite(*value) ? JLT_OK : JLT_ERR_NONFINITE;
}

static jlt_status turn_rate(void *context, double *value, double u)
{
    const jlt_rod *rod = context;
    const tilt at = tilt_at(rod, u);

    *value = -rod->turning / s2_of(at) * pace(rod, at);
    return isfinite(*value) ? JLT_OK : JLT_ERR_NONFINITE;
}

/* The rod, for side -1 upside down: gamma3 changes its sign. */
static jlt_rod seen_from(const jlt_rod *rod, double side)
{
    jlt_rod seen = *rod;

    if (side > 0) return seen;
    seen.below = rod->above;
    seen.above = rod->below;
    return seen;
}

/* The integral of an even rate from u = 0, in two parts: near a pole a rate may vary over angles that doubles near pi do not tell
 * apart, so that the second part counts from the other turning point. */
static jlt_status over(jlt_rod *rod, double *integral, jlt_quadrature_integrand rate, double to)
{
    const double pi = acos(-1), far = fabs(to);
    jlt_rod other = seen_from(rod, -1);
    double error, sum = 0, rest = 0;

    if (far > 0) JLT_PASS(jlt_quadrature_integrate(&sum, &error, rate, rod, 0, fmin(far, pi / 2), 1e-300, quadrature_accuracy));
    if (far > pi / 2)
        JLT_PASS(jlt_quadrature_integrate(&rest, &error, rate, &other, pi - far, pi / 2, 1e-300, quadrature_accuracy));
    *integral = to < 0 ? -(sum + rest) : sum + rest;
    return JLT_OK;
}

static void find_turning_points(jlt_rod *rod, const double *x)
{
    const double weight = rod->weight, gamma3 = x[JLT_TOP_GAMMA3], s = jlt_top_sine(gamma3);
    const double rate = s * x[JLT_TOP_OMEGA_TAU];
    jlt_top weightless = rod->top;

    weightless.g = 0;
    rod->kinetic = jlt_top_integral(&weightless, variant, "E2", x);
    rod->start = gamma3;
    rod->force = (rod->inertia_pole * gamma3 * gamma3 + rod->inertia_equator * s * s) * rate * rate;
    rod->slope = -4 * gamma3 * rod->kinetic - 2 * s * s * weight;
    rod->bend = 4 * gamma3 * weight - 2 * rod->kinetic;
    /* the gamma3 at which P is largest */
    const double crest = -weight / (rod->E2 + sqrt(rod->E2 * rod->E2 + 3 * weight * weight));
    const double inside = force_at(rod, 1, 1 - crest) > 0 ? crest : gamma3;

    rod->below = turning_point(rod, -1, 0, 1 + inside);
    rod->above = turning_point(rod, 1, 0, 1 - inside);
    /* the difference of distances from the pole that is near, where both turning points are near it */
    double across = 2 - rod->below - rod->above;
    if (rod->above > 1) across = turning_point(rod, -1, 2, 1 + inside) - rod->below;
    if (rod->below > 1) across = turning_point(rod, 1, 2, 1 - inside) - rod->above;
    rod->half = fmax(0, across / 2);
}

/* E2 if only `state` is 1 and the others are 0 at this gamma3; without gravity, unless `state` is gamma3. */
static double rotation_energy(const jlt_top *top, unsigned state, double gamma3)
{
    jlt_top weightless = *top;
    double x[JLT_TOP_STATES] = { 0 };

    if (state != JLT_TOP_GAMMA3) weightless.g = 0;
    x[state] = 1;
    x[JLT_TOP_GAMMA3] = gamma3;
    return jlt_top_integral(&weightless, variant, "E2", x);
}

/* Coefficients of the equations in rod.h, from values of the integrals E2 and G. */
static void take_coefficients(jlt_rod *rod)
{
    const double upright[JLT_TOP_STATES] = { [JLT_TOP_OMEGA_N] = 1 };

    rod->weight = rotation_energy(&rod->top, JLT_TOP_GAMMA3, 1);
    rod->inertia_pole = 2 * rotation_energy(&rod->top, JLT_TOP_OMEGA_TAU, 1);
    rod->inertia_equator = 2 * rotation_energy(&rod->top, JLT_TOP_OMEGA_TAU, 0);
    rod->turning = rod->G / jlt_top_integral(&rod->top, variant, "G", upright);
    rod->barrier = 2 * rotation_energy(&rod->top, JLT_TOP_OMEGA_N, 0) * rod->turning * rod->turning;
}

/* Whether E1, E2, G and the rates of gamma3 and v_nu have the form that rod.h says, at jlt_top_samples. An edited table may prove
 * other integrals of these names; with E1, E2 and G constant, these rates determine all. */
static bool has_form(const jlt_top *top)
{
    jlt_rod rod = { .top = *top, .G = 1 };

    take_coefficients(&rod);
    for (unsigned i = 0; i < JLT_TOP_SAMPLES; i++) {
        const double *x = jlt_top_samples[i], gamma3 = x[JLT_TOP_GAMMA3], s = jlt_top_sine(gamma3);
        const double v_nu = x[JLT_TOP_V_NU], omega_tau = x[JLT_TOP_OMEGA_TAU], omega_n = x[JLT_TOP_OMEGA_N];
        const double v_tau = jlt_top_v_tau(top, x), reach = fabs(top->a3) + 2 * fabs(top->R); /* of v_tau */
        const double potential = rod.weight * gamma3, tilting = rod.inertia_pole * gamma3 * gamma3 + rod.inertia_equator * s * s;
        const double upright = rod.barrier / (rod.turning * rod.turning), lever = 1 / rod.turning;
        double rates[JLT_TOP_STATES];
        if (!jlt_top_rates(top, variant, rates, x)) return false;
        if (!jlt_top_agrees(rates[JLT_TOP_GAMMA3], s * omega_tau, s)
            || !jlt_top_agrees(rates[JLT_TOP_V_NU], omega_n * v_tau / s, reach / s)
            || !jlt_top_agrees(rotation_energy(top, JLT_TOP_GAMMA3, gamma3), potential, fabs(potential))
            || !jlt_top_agrees(2 * rotation_energy(top, JLT_TOP_OMEGA_TAU, gamma3), tilting, tilting)
            || !jlt_top_agrees(2 * jlt_top_integral(top, variant, "E2", x),
                               tilting * omega_tau * omega_tau + upright * omega_n * omega_n + 2 * potential,
                               tilting + upright + 2 * fabs(potential))
            || !jlt_top_agrees(2 * jlt_top_integral(top, variant, "E1", x), top->m * (v_nu * v_nu + v_tau * v_tau),
                               top->m * (1 + reach * reach))
            || !jlt_top_agrees(jlt_top_integral(top, variant, "G", x), lever * s * omega_n, fabs(lever)))
            return false;
    }
    return true;
}

/* Compute all quantities of the orbit of rod->top through x. */
static jlt_status measure(jlt_rod *out, const double *x)
{
    jlt_rod rod = *out, seen;
    const jlt_top *top = &rod.top;
    const double gamma3 = x[JLT_TOP_GAMMA3], s = jlt_top_sine(gamma3), v_tau = jlt_top_v_tau(top, x);
    double u, turned;

    if (top->I3 != 0) return JLT_ERR_ARG;
    if (!isfinite(gamma3)) return JLT_ERR_NONFINITE;
    if (!(s > 0)) return JLT_ERR_DOMAIN;
    rod.G = jlt_top_jellett(top, x);
    if (rod.G == 0) return JLT_ERR_DOMAIN;
    rod.speed = hypot(x[JLT_TOP_V_NU], v_tau);
    rod.E1 = jlt_top_integral(top, variant, "E1", x);
    rod.E2 = jlt_top_integral(top, variant, "E2", x);
    take_coefficients(&rod);
    if (!isfinite(rod.E1) || !isfinite(rod.E2) || !isfinite(rod.G)) return JLT_ERR_NONFINITE;
    find_turning_points(&rod, x);
    /* from the nearer turning point, where doubles tell u best: gamma3' = half sin u / pace, and gamma3 = mid - half cos u */
    rod.side = gamma3 > (rod.below - rod.above) / 2 ? -1 : 1;
    seen = seen_from(&rod, rod.side);
    const tilt at = { 1 + rod.side * gamma3, 1 - rod.side * gamma3 };
    u = atan2(rod.side * s * x[JLT_TOP_OMEGA_TAU] * pace(&seen, at),
              at.below < 1 ? seen.below + seen.half - at.below : at.above - seen.above - seen.half);
    rod.psi = atan2(v_tau, x[JLT_TOP_V_NU]); /* at the start; converted to that turning point below */
    JLT_PASS(over(&seen, &rod.period, time_rate, acos(-1)));
    JLT_PASS(over(&seen, &rod.turn, turn_rate, acos(-1)));
    rod.period *= 2;
    rod.turn *= 2;
    JLT_PASS(over(&seen, &rod.elapsed, time_rate, u));
    JLT_PASS(over(&seen, &turned, turn_rate, u));
    rod.psi -= turned;
    *out = rod;
    return JLT_OK;
}

jlt_status jlt_rod_open(jlt_rod *out, const jlt_descriptor *model, const double *params, const double *x)
{
    const jlt_claim *broken;
    jlt_rod rod = { 0 };
    double of_top[JLT_TOP_STATES];

    if (!has_level()) return JLT_ERR_UNSUPPORTED;
    JLT_PASS(jlt_counterpart_open(&rod.counterpart, &broken, model, jlt_rod_table, params, x));
    jlt_counterpart_look(&rod.counterpart, of_top, x);
    rod.top = rod.counterpart.top;
    JLT_PASS(measure(&rod, of_top));
    *out = rod;
    return JLT_OK;
}

double jlt_rod_rotation(const jlt_rod *rod)
{
    return rod->turn / (2 * acos(-1));
}

/* The angle u at the time `wanted` after the turning point from which it counts, |wanted| <= period/2, by Newton's method. Every
 * time is integrated from there, so errors do not accumulate. Time increases with u: a step that leaves the bounds, or does not
 * halve the residual, as near a pole where the rate varies steeply, is replaced by bisection. */
static jlt_status locate(jlt_rod *rod, double *u, double wanted)
{
    jlt_status st = JLT_OK;
    const double pi = acos(-1);
    double at = 2 * pi * wanted / rod->period, low = -1.5 * pi, high = 1.5 * pi, last = INFINITY, now, rate;

    for (int i = 0; i < NEWTON_MAX; i++) {
        JLT_TRY(over(rod, &now, time_rate, at));
        JLT_TRY(time_rate(rod, &rate, at));
        const double change = (wanted - now) / rate;
        if (fabs(change) <= 1e-9) { /* by quadratic convergence, further changes are negligible */
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

/* The top's state x that belongs to a state y, shape (LEVEL_STATES,), of the table on a level. */
static void find_state(const jlt_rod *rod, double *x, const double *y)
{
    const jlt_descriptor *table = jlt_descriptor_find(jlt_rod_table, NULL, NULL, NULL);
    double params[JLT_WAY_VALUES_MAX];
    size_t index;

    jlt_top_write(params, table, &rod->top);
    if (jlt_descriptor_param(table, "G", &index)) params[index] = rod->G;
    jlt_top_return(jlt_top_way(jlt_rod_table), x, y, params);
}

jlt_status jlt_rod_at(jlt_rod *rod, double *x, double t)
{
    const double since = rod->elapsed + t;
    const double periods = nearbyint(since / rod->period);
    jlt_rod seen = seen_from(rod, rod->side);
    double u, psi, s, of_top[JLT_TOP_STATES];

    if (!isfinite(t)) return JLT_ERR_NONFINITE;
    JLT_PASS(locate(&seen, &u, fma(-periods, rod->period, since)));
    JLT_PASS(over(&seen, &psi, turn_rate, u));
    psi += rod->psi + periods * rod->turn;
    const tilt at = tilt_at(&seen, u);
    s = sqrt(s2_of(at));
    find_state(rod, of_top,
               (const double[LEVEL_STATES]){ rod->side * gamma3_of(at), rod->speed * cos(psi),
                                             rod->side * rod->half * sin(u) / (pace(&seen, at) * s),
                                             rod->speed * sin(psi), s });
    jlt_counterpart_return(&rod->counterpart, x, of_top);
    return JLT_OK;
}

const char jlt_rod_meaning[] = "I3 = 0: tilt, turn and time by quadratures, nothing is integrated in time";

bool jlt_rod_is_known(const jlt_descriptor *model)
{
    const jlt_descriptor *table = jlt_descriptor_find(jlt_rod_table, NULL, NULL, NULL);

    for (unsigned i = 0; table != NULL && i < model->way_count; i++)
        if (strcmp(model->ways[i].sha256, table->sha256) == 0) return true;
    return false;
}

const char *jlt_rod_refuses(const jlt_claim **broken, const jlt_descriptor *model, const double *params, const double *x)
{
    static const char unproved[] = "a claim that it rests on is not proved";
    jlt_counterpart found;
    double of_top[JLT_TOP_STATES];

    if (!has_level() || jlt_counterpart_open(&found, broken, model, jlt_rod_table, params, x) != JLT_OK)
        return *broken != NULL ? unproved : "no way leads to the table whose equations they solve";
    if (found.top.I3 != 0) return "I3 is not 0";
    if (!has_form(&found.top)) return "the table that is built in has other equations at I3 = 0 than those that they solve";
    if (x != NULL) jlt_counterpart_look(&found, of_top, x);
    if (x != NULL && jlt_top_jellett(&found.top, of_top) == 0) return "G = 0: the orbit runs through the poles";
    return jlt_top_serves(broken, jlt_rod_table, integrals) ? NULL : unproved;
}
