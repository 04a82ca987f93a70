#include "dynamics/chart_section.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "core/guard.h"
#include "dynamics/linear.h"
#include "kernel/descriptor.h"

enum { Q = JLT_CHART_COORDINATES_MAX };

static const double pi = 3.14159265358979323846;

static const jlt_chart_section *of(const jlt_chart *base) { return (const jlt_chart_section *)(const void *)base; }

static bool within(const jlt_chart_section *self, const double *q)
{
    for (unsigned k = 0; k < self->base.dim; k++) {
        const jlt_quantity *coordinate = &self->section->coordinates[k];
        if (self->base.period[k] == 0 && !(q[k] > coordinate->low && q[k] < coordinate->high)) return false;
    }
    return true;
}

static bool in_region(const jlt_chart_section *self, const double *q)
{
    double region[JLT_CHART_STATES_MAX];

    if (self->section->region_count == 0) return true;
    self->section->region(q, self->values, region);
    for (unsigned i = 0; i < self->section->region_count; i++)
        if (!(region[i] > 0)) return false;
    return true;
}

bool jlt_chart_section_holds(const jlt_chart_section *self, const double *q)
{
    return within(self, q) && in_region(self, q);
}

/* Set to 0 each state that is 0 but for the rounding of an angle: the double nearest to a multiple of pi/2 stands for the multiple,
 * and a velocity of rounding size would decide how an orbit that runs through a pole goes on. */
static void clear_rounding(const jlt_chart_section *self, double *x, const double *q, const double *slopes)
{
    const unsigned width = self->base.dim + self->section->level_count;

    for (unsigned k = 0; k < self->base.dim; k++) {
        const double last_digit = DBL_EPSILON * fmax(1, fabs(q[k]) / 2);
        for (unsigned i = 0; self->section->is_angle[k] && i < self->base.states; i++)
            if (fabs(x[i]) < last_digit * fabs(slopes[i * width + k])) x[i] = 0;
    }
}

static jlt_status lift(const jlt_chart *base, double *x, double *tangent, const double *q)
{
    const jlt_chart_section *self = of(base);
    const unsigned d = base->dim, width = d + self->section->level_count;
    double slopes[JLT_CHART_SLOPES_MAX];

    if (!jlt_guard_finite(q, d)) return JLT_ERR_NONFINITE;
    if (!within(self, q)) return JLT_ERR_DOMAIN;
    if (!in_region(self, q)) return JLT_ERR_EMPTY;
    self->section->lift(q, self->values, x);
    self->section->lift_slopes(q, self->values, slopes);
    clear_rounding(self, x, q, slopes);
    x[base->column] = base->level;
    for (unsigned i = 0; tangent != NULL && i < base->states; i++) memcpy(tangent + i * d, slopes + i * width, d * sizeof *tangent);
    return JLT_OK;
}

/* Clamp a coordinate that a method's error has carried past its bound; farther out it is NaN. */
static double bounded(const jlt_quantity *of, double value)
{
    const double inside = fmax(of->low, fmin(of->high, value));
    return isnan(value) || fabs(value - inside) > 1e-3 * fmax(1, fabs(inside)) ? NAN : inside;
}

static void lower(const jlt_chart *base, double *q, double *slope, const double *x)
{
    const jlt_chart_section *self = of(base);
    const unsigned n = base->states;
    double back[2 * Q], slopes[2 * JLT_CHART_SLOPES_MAX];

    self->section->back(x, self->values, back);
    if (slope != NULL) self->section->back_slopes(x, self->values, slopes);
    for (unsigned k = 0; k < base->dim; k++) {
        const double a = back[2 * k], b = back[2 * k + 1], *da = slopes + 2 * k * n, *db = da + n;
        const bool is_angle = self->section->is_angle[k] != 0;
        q[k] = is_angle ? atan2(a, b) : bounded(&self->section->coordinates[k], a);
        for (unsigned i = 0; slope != NULL && i < n; i++)
            slope[k * n + i] = is_angle ? (b * da[i] - a * db[i]) / (a * a + b * b) : da[i];
    }
    jlt_chart_wrap(base, q);
}

static double flux(const jlt_chart *base, const double *x, const double *f)
{
    const jlt_chart_section *self = of(base);
    const unsigned width = base->dim + self->section->level_count;
    double q[Q], slopes[JLT_CHART_SLOPES_MAX], matrix[JLT_CHART_SLOPES_MAX], roots = 1;
    unsigned entry = 0;
    int unit = 0; /* binary exponent of the determinant's unit */

    lower(base, q, NULL, x);
    self->section->lift_slopes(q, self->values, slopes);
    for (unsigned j = 0; j < width; j++) unit -= self->per[j];
    for (unsigned i = 0; i < self->plain; i++) {
        if (i == base->column) continue;
        unit += self->unit[i];
        for (unsigned j = 0; j < width; j++)
            matrix[entry++] = ldexp(slopes[i * width + j], self->per[j] - self->unit[i]);
    }
    for (unsigned i = self->plain; i < base->states; i++) roots *= x[i];
    return f[base->column] * ldexp(fabs(jlt_linear_determinant(matrix, width)), unit) / roots;
}

static int side(const jlt_chart *base, double *x)
{
    return jlt_chart_pole_side(base, of(base)->table, of(base)->plain, x);
}

/* ---- points of the section ---- */

unsigned jlt_chart_section_places(const jlt_chart_section *self, unsigned coordinate, unsigned angles)
{
    unsigned others = 0;

    if (self->base.period[coordinate] != 0) return angles;
    for (unsigned k = 0; k < self->base.dim; k++) others += self->base.period[k] == 0;
    return others < 12 ? 1u << 12 / others : 2; /* 2^12 combinations of these coordinates, at least two places of each */
}

size_t jlt_chart_section_points(const jlt_chart_section *self, unsigned angles)
{
    size_t all = 1;

    for (unsigned k = 0; k < self->base.dim; k++) all *= jlt_chart_section_places(self, k, angles);
    return all;
}

void jlt_chart_section_point(const jlt_chart_section *self, double *q, size_t index, unsigned angles)
{
    for (unsigned k = 0; k < self->base.dim; k++) {
        const jlt_quantity *coordinate = &self->section->coordinates[k];
        const double period = self->base.period[k];
        const double low = period != 0 ? -period / 2 : coordinate->low;
        const unsigned places = jlt_chart_section_places(self, k, angles);
        const double from = isfinite(low) ? low : isfinite(coordinate->high) ? coordinate->high - 2 : -1;
        const double to = period != 0 ? period / 2 : isfinite(coordinate->high) ? coordinate->high : from + 2;
        q[k] = from + (to - from) * ((double)(index % places) + 0.5) / places;
        index /= places;
    }
}

enum { SIZES = 26, SIDES = 4 };

static double middle_of(const jlt_quantity *coordinate, double period)
{
    if (period != 0) return 0;
    if (!isfinite(coordinate->high)) return isfinite(coordinate->low) ? coordinate->low + 1 : 0;
    return isfinite(coordinate->low) ? (coordinate->low + coordinate->high) / 2 : coordinate->high - 1;
}

size_t jlt_chart_section_probes(const jlt_chart_section *self, unsigned angles)
{
    return jlt_chart_section_points(self, angles) + (self->section->start_count + 1) * SIZES * SIDES;
}

void jlt_chart_section_probe(const jlt_chart_section *self, double *q, size_t index, unsigned angles)
{
    const size_t all = jlt_chart_section_points(self, angles);

    if (index < all) {
        jlt_chart_section_point(self, q, index * 2654435761u % all, angles);
        return;
    }
    index -= all;
    const size_t centre = index / (SIZES * SIDES), side = index / SIZES % SIDES;
    const int size = (int)(index % SIZES);
    for (unsigned k = 0; k < self->base.dim; k++) {
        const double c = centre < self->section->start_count ? self->section->starts[centre].point[k]
                                                             : middle_of(&self->section->coordinates[k], self->base.period[k]);
        const double unit = c != 0 ? fabs(c) : 1;
        q[k] = size == 0 ? c : c + ldexp(unit, 2 * size - SIZES) * sin(1 + k + 2.3 * (double)side);
    }
    jlt_chart_wrap(&self->base, q);
}

/* ---- which coordinates are angles ---- */

enum { POINTS = 5 };

static const double same = 1e-9; /* relative to the coordinate, or its period */

static bool is_same(const jlt_chart_section *self, unsigned k, double difference, double q)
{
    return fabs(difference) <= same * fmax(fabs(q), self->base.period[k]);
}

/* The distance by which a period of `state` moves one coordinate, *moved, found at POINTS points of the section; 0: it moves none,
 * several, or not equally far everywhere. */
static double shift_by(const jlt_chart_section *self, unsigned *moved, unsigned state)
{
    const double period = self->table->states[state].period;
    const unsigned angles = 8;
    const size_t all = jlt_chart_section_probes(self, angles);
    double shift = 0;
    unsigned seen = 0;

    for (size_t i = 0; i < all && seen < POINTS; i++) {
        double q[Q], p[Q], x[JLT_CHART_STATES_MAX], slope[JLT_CHART_SLOPES_MAX];
        jlt_chart_section_probe(self, q, i, angles);
        if (lift(&self->base, x, NULL, q) != JLT_OK) continue;
        lower(&self->base, p, slope, x);
        x[state] += period;
        lower(&self->base, p, NULL, x);
        jlt_chart_difference(&self->base, p, p, q);
        for (unsigned k = 0; seen == 0 && k < self->base.dim; k++) {
            if (is_same(self, k, p[k], q[k])) continue;
            *moved = k;
            shift = slope[k * self->base.states + state] * period;
        }
        if (shift != 0) p[*moved] -= shift;
        for (unsigned k = 0; k < self->base.dim; k++)
            if (!is_same(self, k, p[k], fmax(fabs(q[k]), fabs(shift)))) return 0;
        seen++;
    }
    return seen == POINTS ? fabs(shift) : 0;
}

/* A coordinate that a period of a state moves, and no other, has that shift as its period. */
static void find_periods(jlt_chart_section *self)
{
    bool found = true;

    while (found) { /* of two coordinates that a state moves, another state may give one's period */
        found = false;
        for (unsigned i = 0; i < self->plain; i++) {
            unsigned k = 0;
            const bool is_tried = self->table->states[i].period != 0 && i != self->base.column;
            const double shift = is_tried ? shift_by(self, &k, i) : 0;
            if (shift == 0 || self->base.period[k] != 0) continue;
            self->base.period[k] = shift;
            found = true;
        }
    }
}

/* ---- what a reversor does ---- */

/* Whether the reversor does no more than change signs of coordinates, at POINTS points of the section; sets `mirror` to these. */
static bool changes_signs(jlt_chart_section *self, const signed char *signs)
{
    const unsigned angles = 8;
    const size_t all = jlt_chart_section_probes(self, angles);
    unsigned seen = 0;

    for (unsigned k = 0; k < self->base.dim; k++) self->base.mirror[k] = 0;
    for (size_t i = 0; i < all && seen < POINTS; i++) {
        double q[Q], opposite[Q], p[Q], same_way[Q], other_way[Q], x[JLT_CHART_STATES_MAX];
        jlt_chart_section_probe(self, q, i, angles);
        if (lift(&self->base, x, NULL, q) != JLT_OK) continue;
        for (unsigned k = 0; k < self->plain; k++) x[k] *= signs[k];
        lower(&self->base, p, NULL, x);
        for (unsigned k = 0; k < self->base.dim; k++) opposite[k] = -q[k];
        jlt_chart_difference(&self->base, same_way, p, q);
        jlt_chart_difference(&self->base, other_way, p, opposite);
        for (unsigned k = 0; k < self->base.dim; k++) {
            const bool same_sign = is_same(self, k, same_way[k], q[k]), other_sign = is_same(self, k, other_way[k], q[k]);
            const int sign = same_sign ? 1 : -1;
            if (same_sign && other_sign) continue; /* this point does not tell the sign: the coordinate is 0, say */
            if (!(same_sign || other_sign) || self->base.mirror[k] == -sign) return false;
            self->base.mirror[k] = sign;
        }
        seen++;
    }
    return seen == POINTS;
}

static void find_reversor(jlt_chart_section *self)
{
    const jlt_descriptor *general = self->table->family[0];

    for (unsigned i = 0; i < general->reversor_count && !self->base.reversible; i++) {
        const jlt_reversor *reversor = &general->reversors[i];
        const bool keeps = self->base.level == 0 && reversor->signs[self->base.column] < 0;
        if (keeps && general->claims[reversor->claim].verdict == JLT_PROVED)
            self->base.reversible = changes_signs(self, reversor->signs);
    }
}

jlt_status jlt_chart_section_init(jlt_chart_section *out, const jlt_descriptor *table, const jlt_section_chart *section,
                                  const double *values)
{
    const unsigned count = table->param_count + section->level_count, width = section->coordinate_count + section->level_count;
    const unsigned plain = table->family[0]->state_count;

    if (count > JLT_CHART_VALUES_MAX || section->coordinate_count > Q || table->state_count > JLT_CHART_STATES_MAX)
        return JLT_ERR_UNSUPPORTED;
    if (table->state_count * width > JLT_CHART_SLOPES_MAX || table->state_count * section->coordinate_count > JLT_CHART_SLOPES_MAX)
        return JLT_ERR_UNSUPPORTED;
    if (width + 1 != plain || section->region_count > JLT_CHART_STATES_MAX) return JLT_ERR_UNSUPPORTED;
    *out = (jlt_chart_section){ .table = table, .section = section, .plain = plain };
    memcpy(out->values, values, count * sizeof *values);
    out->base.dim = section->coordinate_count;
    out->base.states = table->state_count;
    out->base.column = section->column;
    out->base.level = section->level;
    out->base.turn = table->states[section->column].period;
    for (unsigned k = 0; k < out->base.dim; k++) {
        out->base.names[k] = section->coordinates[k].name;
        out->base.period[k] = section->is_angle[k] ? 2 * pi : section->coordinates[k].period;
    }
    if (out->base.dim == 1) out->base.names[1] = "";
    out->base.lift = lift;
    out->base.lower = lower;
    out->base.flux = flux;
    out->base.side = jlt_descriptor_has_poles(table) ? side : NULL;
    find_periods(out);
    find_reversor(out);
    return JLT_OK;
}
