/* Finds points on zero levels: Newton's method for as many symbols as levels, then Krawczyk's test that the balls around the result
 * contain a solution. Points of few digits may lie on levels exactly, even where these are singular. */
#include "challenge/random_point.h"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

enum { ITERATIONS = 60, FEW_BITS = 16 };

typedef struct {
    ttc_probe *probe;
    const ttc_random_point *point;
    const ttc_situation *situation;
    long precision, n;
    arb_mat_t x, step, value, slope, inverse;
} solver;

/* Levels and their derivatives by the pivots, at the pivots' values. */
static bool evaluate(solver *s)
{
    const size_t spare = 1 + s->situation->model->state_count;
    if (!ttc_random_point_set(s->probe, s->point, s->situation, s->precision, arb_mat_entry(s->x, 0, 0))) return false;
    for (long i = 0; i < s->n; i++) {
        arb_srcptr jet = ttc_probe_at(s->probe, s->point->levels[i]);
        if (jet == NULL) return false;
        arb_set(arb_mat_entry(s->value, i, 0), jet);
        for (long j = 0; j < s->n; j++) arb_set(arb_mat_entry(s->slope, i, j), jet + spare + (size_t)j);
    }
    return true;
}

static void take_midpoints(arb_mat_t matrix)
{
    for (long i = 0; i < arb_mat_nrows(matrix); i++)
        for (long j = 0; j < arb_mat_ncols(matrix); j++)
            mag_zero(arb_radref(arb_mat_entry(matrix, i, j)));
}

static bool is_finite(const arb_mat_t matrix)
{
    for (long i = 0; i < arb_mat_nrows(matrix); i++)
        for (long j = 0; j < arb_mat_ncols(matrix); j++)
            if (!arb_is_finite(arb_mat_entry(matrix, i, j))) return false;
    return true;
}

/* Start from the values that were drawn for the pivots. */
static bool begin(solver *s)
{
    const ttc_situation *without = s->situation;
    if (!ttc_random_point_set(s->probe, s->point, without, s->precision, NULL)) return false;
    for (long i = 0; i < s->n; i++)
        arb_set(arb_mat_entry(s->x, i, 0), ttc_probe_value(s->probe, s->point->pivots[i]));
    take_midpoints(s->x);
    return true;
}

/* Whether the step is below 2^(-3/4 precision), relative to pivots above 1. */
static bool is_settled(const solver *s)
{
    bool settled = true;
    arf_t bound;
    arf_init(bound);
    for (long i = 0; i < s->n; i++) {
        arf_abs(bound, arb_midref(arb_mat_entry(s->x, i, 0)));
        if (arf_cmp_si(bound, 1) < 0) arf_one(bound);
        arf_mul_2exp_si(bound, bound, -(3 * s->precision) / 4);
        settled = settled && arf_cmpabs(arb_midref(arb_mat_entry(s->step, i, 0)), bound) <= 0;
    }
    arf_clear(bound);
    return settled;
}

static bool newton(solver *s)
{
    for (int k = 0; k < ITERATIONS; k++) {
        if (!evaluate(s)) return false;
        take_midpoints(s->slope);
        if (!arb_mat_inv(s->inverse, s->slope, s->precision) || !is_finite(s->inverse)) return false;
        arb_mat_mul(s->step, s->inverse, s->value, s->precision);
        if (!is_finite(s->step)) return false;
        take_midpoints(s->step);
        arb_mat_sub(s->x, s->x, s->step, s->precision);
        take_midpoints(s->x);
        if (is_settled(s)) return true;
    }
    return false;
}

/* K = x - C F(x) + (E - C F'(X)) (X - x) lies inside X: then X contains one solution, which K encloses. The probe is set to K,
 * where the levels are zero. */
static bool krawczyk(solver *s)
{
    bool inside = true;
    arb_mat_t centre, spread, image, box;
    arb_mat_init(centre, s->n, 1);
    arb_mat_init(spread, s->n, 1);
    arb_mat_init(image, s->n, s->n);
    arb_mat_init(box, s->n, 1);
    inside = evaluate(s);
    arb_mat_set(centre, s->x);
    arb_mat_mul(s->step, s->inverse, s->value, s->precision);
    arb_mat_sub(centre, centre, s->step, s->precision);
    for (long i = 0; i < s->n; i++) {
        mag_t radius;
        mag_init(radius);
        arb_get_mag(radius, arb_mat_entry(s->x, i, 0));
        mag_add_ui(radius, radius, 1);
        mag_mul_2exp_si(radius, radius, -s->precision / 2);
        arb_add_error_mag(arb_mat_entry(spread, i, 0), radius);
        arb_add_error_mag(arb_mat_entry(s->x, i, 0), radius);
        mag_clear(radius);
    }
    arb_mat_set(box, s->x);
    inside = inside && evaluate(s);
    if (inside) {
        arb_mat_mul(image, s->inverse, s->slope, s->precision);
        arb_mat_neg(image, image);
        for (long i = 0; i < s->n; i++)
            arb_add_si(arb_mat_entry(image, i, i), arb_mat_entry(image, i, i), 1, s->precision);
        arb_mat_mul(spread, image, spread, s->precision);
        arb_mat_add(s->x, centre, spread, s->precision);
        for (long i = 0; i < s->n; i++)
            inside = inside && arb_contains_interior(arb_mat_entry(box, i, 0), arb_mat_entry(s->x, i, 0));
        inside = inside && evaluate(s);
    }
    for (long i = 0; inside && i < s->n; i++) ttc_probe_set_zero(s->probe, s->point->levels[i]);
    arb_mat_clear(box);
    arb_mat_clear(image);
    arb_mat_clear(spread);
    arb_mat_clear(centre);
    return inside;
}

static bool are_zero(ttc_probe *probe, const ttc_id *levels, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        arb_srcptr value = ttc_probe_at(probe, levels[i]);
        if (value == NULL || !arb_is_zero(value)) return false;
    }
    return true;
}

/* Whether the numbers, with these pivots, lie on all levels exactly. */
static bool is_exact(const solver *s, arb_srcptr pivots)
{
    return ttc_random_point_set(s->probe, s->point, s->situation, s->precision, pivots)
           && are_zero(s->probe, s->point->levels, s->point->level_count)
           && are_zero(s->probe, s->situation->levels, s->situation->level_count);
}

/* Whether the solution is one of few digits: the nearest of these lies on all levels. */
static bool is_exact_rounded(const solver *s)
{
    arb_ptr rounded = _arb_vec_init(s->n);
    arf_t nearest;
    arf_init(nearest);
    for (long i = 0; i < s->n; i++) {
        arf_mul_2exp_si(nearest, arb_midref(arb_mat_entry(s->x, i, 0)), FEW_BITS + 1);
        arf_add_ui(nearest, nearest, 1, s->precision, ARF_RND_NEAR);
        arf_mul_2exp_si(nearest, nearest, -1);
        arf_floor(nearest, nearest);
        arf_mul_2exp_si(arb_midref(rounded + i), nearest, -FEW_BITS);
    }
    const bool exact = is_exact(s, rounded);
    arf_clear(nearest);
    _arb_vec_clear(rounded, s->n);
    return exact;
}

bool ttc_level_meet(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation, long precision)
{
    solver s;
    s.probe = probe;
    s.point = point;
    s.situation = situation;
    s.precision = precision;
    s.n = (long)point->level_count;
    if (is_exact(&s, NULL)) return true;
    arb_mat_init(s.x, s.n, 1);
    arb_mat_init(s.step, s.n, 1);
    arb_mat_init(s.value, s.n, 1);
    arb_mat_init(s.slope, s.n, s.n);
    arb_mat_init(s.inverse, s.n, s.n);
    const bool met = begin(&s) && newton(&s) && (is_exact_rounded(&s) || (point->solves_levels && krawczyk(&s)));
    arb_mat_clear(s.inverse);
    arb_mat_clear(s.slope);
    arb_mat_clear(s.value);
    arb_mat_clear(s.step);
    arb_mat_clear(s.x);
    return met;
}
