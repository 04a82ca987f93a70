#include "top/balanced.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "kernel/way.h"

const char jlt_balanced_table[] = "spherical_top_balanced";

static const char half[] = "spherical_top_plane", family[] = "spin", variant[] = "balanced";
static const char third[] = "F0";

/* Coordinates of the table of the surface, and of the table of its half v_slip >= 0. */
enum { GAMMA3, V_SLIP, PSI, SINE, COORDINATES };
enum { HALF_GAMMA3, HALF_PSI, HALF_SINE, HALF_COORDINATES };

/* Relative error of levels with respect to their terms: more roundings than any integral takes. */
static const double rounding = 32 * (DBL_EPSILON / 2);

/* ---- what the tables say ---- */

static bool has(const jlt_descriptor *table, const char *const *states, unsigned count)
{
    if (table == NULL || table->state_count != count || table->param_count > JLT_WAY_VALUES_MAX) return false;
    for (unsigned i = 0; i < count; i++)
        if (strcmp(table->states[i].name, states[i]) != 0) return false;
    return true;
}

/* The field of the surface's table in the time in which s is a state; NULL if the table has other states than expected. */
static const jlt_descriptor *surface_field(void)
{
    static const char *const states[COORDINATES] = { "gamma3", "v_slip", "psi", "s" };
    const jlt_way *way = jlt_top_way(jlt_balanced_table);
    const jlt_descriptor *table = way == NULL ? NULL : jlt_descriptor_find(jlt_balanced_table, NULL, way->time, NULL);

    return has(table, states, COORDINATES) ? table : NULL;
}

static const jlt_way *half_way(const jlt_descriptor **field)
{
    static const char *const states[HALF_COORDINATES] = { "gamma3", "psi", "s" };
    const jlt_descriptor *table = surface_field();

    for (unsigned i = 0; table != NULL && i < table->way_count; i++) {
        *field = jlt_descriptor_find(half, NULL, table->ways[i].time, NULL);
        if (strcmp(table->ways[i].model, half) == 0 && has(*field, states, HALF_COORDINATES)) return &table->ways[i];
    }
    return NULL;
}

static const jlt_equilibria *spin(void)
{
    const jlt_descriptor *table = jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL);

    for (unsigned i = 0; table != NULL && i < table->equilibria_count; i++)
        if (strcmp(table->equilibria[i].name, family) == 0) return &table->equilibria[i];
    return NULL;
}

bool jlt_balanced_serves(const jlt_claim **broken)
{
    const jlt_descriptor *field, *table = surface_field();
    const jlt_way *way;

    if (!jlt_top_serves(broken, jlt_balanced_table, (const char *const[]){ "E", "G", third, NULL })) return false;
    way = half_way(&field);
    if (way == NULL || spin() == NULL || spin()->trace == NULL || spin()->charpoly == NULL) return false;
    if (!jlt_top_claims(broken, "trace", family) || !jlt_top_claims(broken, "charpoly", family)) return false;
    if (!jlt_way_holds(broken, table, way, field)) return false;
    *broken = NULL;
    return true;
}

/* The parameters of a table of the surface at these levels. */
static void write_levels(double *params, const jlt_descriptor *table, const jlt_top *top, const jlt_balanced_levels *levels)
{
    const char *const names[] = { "G", "M", third };
    const double values[] = { levels->G, levels->M, levels->F0 };
    size_t index;

    jlt_top_write(params, table, top);
    for (int i = 0; i < 3; i++)
        if (jlt_descriptor_param(table, names[i], &index)) params[index] = values[i];
}

static double energy(const jlt_top *top, const double *x)
{
    return jlt_top_integral(top, variant, "E", x);
}

static double third_integral(const jlt_top *top, const double *x)
{
    return jlt_top_integral(top, variant, third, x);
}

void jlt_balanced_from_state(const jlt_top *top, double *gamma3, double *v_slip, double *psi, const double *x)
{
    const jlt_way *way = jlt_top_way(jlt_balanced_table);
    double y[JLT_WAY_VALUES_MAX] = { NAN, NAN, NAN }, other[JLT_WAY_VALUES_MAX];

    if (surface_field() != NULL) jlt_top_look(way, y, other, top, x);
    *gamma3 = x[JLT_TOP_GAMMA3];
    *v_slip = y[V_SLIP];
    *psi = y[PSI];
}

void jlt_balanced_to_state(const jlt_top *top, const jlt_balanced_levels *levels, double *x, double gamma3, double s,
                           double v_slip, double psi)
{
    const jlt_descriptor *table = surface_field();
    const double y[COORDINATES] = { [GAMMA3] = gamma3, [V_SLIP] = v_slip, [PSI] = psi, [SINE] = s };
    double params[JLT_WAY_VALUES_MAX];

    for (int i = 0; i < JLT_TOP_STATES; i++) x[i] = NAN;
    if (table == NULL) return;
    write_levels(params, table, top, levels);
    jlt_top_return(jlt_top_way(jlt_balanced_table), x, y, params);
}

double jlt_balanced_slip(const jlt_top *top, const jlt_balanced_levels *levels, double gamma3, double s, double psi)
{
    const jlt_descriptor *table;
    const jlt_way *way = half_way(&table);
    const double y[HALF_COORDINATES] = { [HALF_GAMMA3] = gamma3, [HALF_PSI] = psi, [HALF_SINE] = s };
    double params[JLT_WAY_VALUES_MAX], back[COORDINATES];

    if (way == NULL) return NAN;
    write_levels(params, table, top, levels);
    way->back(y, params, back);
    return back[V_SLIP];
}

void jlt_balanced_levels_of(jlt_balanced_levels *out, const jlt_top *top, const double *x)
{
    const jlt_descriptor *table = surface_field();
    double y[JLT_WAY_VALUES_MAX], other[JLT_WAY_VALUES_MAX];
    size_t M;

    *out = (jlt_balanced_levels){ energy(top, x), jlt_top_jellett(top, x), third_integral(top, x), NAN };
    if (table == NULL || !jlt_descriptor_param(table, "M", &M)) return;
    jlt_top_look(jlt_top_way(jlt_balanced_table), y, other, top, x);
    out->M = other[M];
}

/* ---- the length of the momentum ---- */

/* The state with these levels at the equator, with the momentum M perpendicular to the axis, and this v_slip. */
static void across(double *x, const jlt_top *top, const jlt_balanced_levels *levels, double v_slip)
{
    jlt_balanced_to_state(top, levels, x, 0, 1, v_slip, acos(0));
}

/* The least F0 for which v_slip^2 >= 0 at some point. If I1 < I3 it is attained with v_slip = 0 at one gamma3 and cos psi = +-1:
 * there, with u = (s, gamma3), F0 = -(a u)^2/(u D u) for a diagonal D, and its minimum, -a D^-1 a, is the sum of the values at the
 * equator and at the pole. The value at the equator is proportional to M^2, whose relative error is `error`; the result is lowered
 * by all rounding errors. */
static double least_third_integral(const jlt_top *top, const jlt_balanced_levels *levels, double error)
{
    double equator[JLT_TOP_STATES], pole[JLT_TOP_STATES];

    jlt_balanced_to_state(top, levels, equator, 0, 1, 0, 0);
    jlt_balanced_to_state(top, levels, pole, 1, 0, 0, 0);
    const double turning = third_integral(top, equator), upright = third_integral(top, pole);
    const double sizes = rounding * (fabs(levels->F0) + fabs(turning) + fabs(upright));
    return fmin(0, turning + upright - sizes - error * fabs(turning));
}

void jlt_balanced_shares(double *of_F0, double *of_G, double *of_M, const jlt_top *top)
{
    double slipping[JLT_TOP_STATES], upright[JLT_TOP_STATES], tilting[JLT_TOP_STATES];

    across(slipping, top, &(jlt_balanced_levels){ 0 }, 1);
    across(upright, top, &(jlt_balanced_levels){ .G = 1 }, 0);
    across(tilting, top, &(jlt_balanced_levels){ .M = 1 }, 0);
    *of_F0 = energy(top, slipping) / third_integral(top, slipping);
    *of_G = energy(top, upright);
    *of_M = energy(top, tilting);
}

jlt_status jlt_balanced_complete(jlt_balanced_levels *levels, const jlt_top *top)
{
    double by_F0, by_G, of_M;

    jlt_balanced_shares(&by_F0, &by_G, &of_M, top);
    by_F0 *= levels->F0;
    by_G *= levels->G * levels->G;
    const double rest = levels->E - by_F0 - by_G, error = rounding * (levels->E + fabs(by_F0) + by_G);
    const double M2 = rest < 0 && rest >= -error ? 0 : rest / of_M;

    if (!(M2 >= 0)) return JLT_ERR_EMPTY;
    levels->M = sqrt(M2);
    if (!(levels->F0 >= least_third_integral(top, levels, rest > 0 ? error / rest : 0))) return JLT_ERR_EMPTY;
    return JLT_OK;
}

/* ---- fixed points ---- */

static void classify(jlt_fixed_point *point, const jlt_top *top, double gamma3, double v0, double w0)
{
    const jlt_descriptor *table = jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL);
    const jlt_equilibria *known = spin();
    double params[JLT_WAY_VALUES_MAX], polynomial[JLT_TOP_STATES + 1], half_trace, root2;

    *point = (jlt_fixed_point){ .x = { gamma3, v0, 0, 0, w0 } };
    jlt_balanced_from_state(top, &gamma3, &point->v_slip, &point->psi, point->x);
    jlt_top_write(params, table, top);
    known->trace(point->x, params, &point->trace);
    known->charpoly(point->x, params, polynomial); /* (q0 lambda^2 + q1 lambda + q2) lambda^3 */
    point->determinant = polynomial[2] / polynomial[0];
    half_trace = point->trace / 2;
    root2 = half_trace * half_trace - point->determinant;
    point->focus = root2 < 0;
    if (point->focus) {
        point->re[0] = point->re[1] = half_trace;
        point->im[0] = sqrt(-root2);
        point->im[1] = -point->im[0];
    } else {
        const double far = half_trace + copysign(sqrt(root2), half_trace); /* sums of one sign: no cancellation */
        point->re[0] = far;
        point->re[1] = far != 0 ? point->determinant / far : 0;
    }
    point->kind = point->trace < 0 ? JLT_FIXED_ATTRACTING : point->trace > 0 ? JLT_FIXED_REPELLING : JLT_FIXED_CENTRE;
}

/* Coefficients of the integrals on the family at one tilt: their values at unit velocities. */
typedef struct {
    double E_v, E_w, F_v, F_w, G_w;
} family_levels;

static family_levels levels_at(const jlt_top *top, double gamma3)
{
    const double along[JLT_TOP_STATES] = { [JLT_TOP_GAMMA3] = gamma3, [JLT_TOP_V_NU] = 1 };
    const double about[JLT_TOP_STATES] = { [JLT_TOP_GAMMA3] = gamma3, [JLT_TOP_OMEGA3] = 1 };

    return (family_levels){ energy(top, along), energy(top, about), third_integral(top, along), third_integral(top, about),
                            jlt_top_jellett(top, about) };
}

static unsigned both_ways(jlt_fixed_point *out, const jlt_top *top, double gamma3, double speed, double w0)
{
    classify(&out[0], top, gamma3, speed, w0);
    if (speed == 0) return 1;
    classify(&out[1], top, gamma3, -speed, w0);
    return 2;
}

/* v_nu^2 from E or F0, whichever has the smaller error, for omega3^2 = w2 with a relative error; 0 if it is 0 within its error. */
static double slip_square(const jlt_balanced_levels *levels, const family_levels *at, double w2, double error)
{
    const double by_E = (levels->E - at->E_w * w2) / at->E_v, by_F = (levels->F0 - at->F_w * w2) / at->F_v;
    const double error_E = (rounding * fabs(levels->E) + (rounding + error) * fabs(at->E_w) * w2) / at->E_v;
    const double error_F = (rounding * fabs(levels->F0) + (rounding + error) * fabs(at->F_w) * w2) / at->F_v;
    const double v2 = error_E <= error_F ? by_E : by_F;

    return fabs(v2) <= fmin(error_E, error_F) ? 0 : v2;
}

/* G != 0: omega3 = G/G_w. Eliminating v_nu^2 between E and F0, and multiplying by u = gamma3^2, gives constant + slope u = 0. */
static unsigned tilted(jlt_fixed_point *out, const jlt_top *top, const jlt_balanced_levels *levels)
{
    const family_levels equator = levels_at(top, 0), pole = levels_at(top, 1);
    const double w = levels->G / pole.G_w, w2 = w * w, share = pole.E_v / pole.F_v; /* w: omega3 gamma3 */
    const double constant = w2 * (equator.E_w - share * equator.F_w);
    const double slope = share * levels->F0 - levels->E + w2 * (pole.E_w - equator.E_w - share * (pole.F_w - equator.F_w));
    const double u = -constant / slope;
    const double parts = w2 * (equator.E_w + share * fabs(equator.F_w)); /* sizes of the terms */
    const double rest = share * fabs(levels->F0) + levels->E + w2 * (pole.E_w + share * fabs(pole.F_w)) + parts;
    const double error = rounding * (parts / fabs(constant) + rest / fabs(slope));
    unsigned count = 0;

    if (!(u > 0 && u < 1)) return 0;
    for (int side = -1; side <= 1; side += 2) {
        const double gamma3 = side * sqrt(u), w0 = w / gamma3;
        const family_levels at = levels_at(top, gamma3);
        const double v2 = slip_square(levels, &at, w0 * w0, error);
        if (v2 >= 0) count += both_ways(out + count, top, gamma3, sqrt(v2), w0);
    }
    return count;
}

/* G = 0: fixed points at the equator; E and F0 give v_nu and omega3. Returns false if omega3 is 0, when every gamma3 is fixed. */
static bool equatorial(jlt_fixed_point *out, unsigned *count, const jlt_top *top, const jlt_balanced_levels *levels)
{
    const family_levels at = levels_at(top, 0);
    const double numerator = at.F_v * levels->E - at.E_v * levels->F0, divisor = at.F_v * at.E_w - at.E_v * at.F_w;
    const double above = at.F_v * levels->E + at.E_v * fabs(levels->F0), below = at.F_v * at.E_w + at.E_v * fabs(at.F_w);
    const double w2 = numerator / divisor;

    if (fabs(numerator) <= rounding * above) return false;
    const double v2 = slip_square(levels, &at, w2, rounding * (above / fabs(numerator) + below / fabs(divisor)));
    if (!(w2 > 0 && v2 >= 0)) return true;
    for (int side = -1; side <= 1; side += 2) *count += both_ways(out + *count, top, 0, sqrt(v2), side * sqrt(w2));
    return true;
}

jlt_status jlt_balanced_fixed_points(jlt_fixed_point out[4], unsigned *count, const jlt_top *top,
                                     const jlt_balanced_levels *levels)
{
    *count = 0;
    if (!(top->I3 > 0)) return JLT_ERR_UNSUPPORTED;
    if (levels->G == 0) return equatorial(out, count, top, levels) ? JLT_OK : JLT_ERR_UNSUPPORTED;
    *count = tilted(out, top, levels);
    return JLT_OK;
}

bool jlt_balanced_fixed_like(jlt_fixed_point out[4], unsigned *count, const jlt_top *top, const double *x)
{
    const double gamma3 = x[JLT_TOP_GAMMA3], v_nu = x[JLT_TOP_V_NU], omega3 = x[JLT_TOP_OMEGA3];

    *count = 0;
    if (x[JLT_TOP_OMEGA_TAU] != 0 || x[JLT_TOP_OMEGA_N] != 0 || omega3 == 0 || !(top->I3 > 0)) return false;
    for (int side = -1; side <= 1; side += 2)
        *count += both_ways(out + *count, top, 0.0 + side * fabs(gamma3), fabs(v_nu), side * copysign(omega3, gamma3 * omega3));
    return true;
}

/* Points (u, v) are multiples of the generalized golden ratio in two dimensions (M. Roberts, 2018). */
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
