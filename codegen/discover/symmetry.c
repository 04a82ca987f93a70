#include "discover/symmetry.h"

#include <flint/fmpz_mat.h>
#include <flint/ulong_extras.h>

#include <stdlib.h>

/* Linear conditions on weights of the ring's variables and, last, of time: each rate and radicand is homogeneous. */
typedef struct {
    const ttc_flow *flow;
    long *rows; /* shape (count, variable_count + 1) */
    size_t count, capacity, width;
} conditions;

static long *new_row(conditions *c)
{
    if (c->count == c->capacity) {
        c->capacity = 2 * c->capacity + 16;
        c->rows = flint_realloc(c->rows, c->capacity * c->width * sizeof *c->rows);
    }
    long *row = c->rows + c->count++ * c->width;
    for (size_t i = 0; i < c->width; i++) row[i] = 0;
    return row;
}

static void add_exponents(const conditions *c, long *row, const fmpz_mpoly_t a, slong term, long sign)
{
    ulong *exponents = flint_calloc(c->flow->ring->variable_count, sizeof *exponents);
    fmpz_mpoly_get_term_exp_ui(exponents, a, term, c->flow->ring->context);
    for (size_t v = 0; v + 1 < c->width; v++) row[v] += sign * (long)exponents[v];
    flint_free(exponents);
}

/* All terms of a have the weight of the first. */
static void add_homogeneous(conditions *c, const fmpz_mpoly_t a)
{
    for (slong t = 1; t < fmpz_mpoly_length(a, c->flow->ring->context); t++) {
        long *row = new_row(c);
        add_exponents(c, row, a, 0, 1);
        add_exponents(c, row, a, t, -1);
    }
}

/* weight of `ratio` = multiple * weight of variable + times * weight of time */
static void add_ratio(conditions *c, const ttc_ratio *ratio, slong variable, long multiple, long times)
{
    if (fmpz_mpoly_is_zero(ratio->numerator, c->flow->ring->context)) return;
    add_homogeneous(c, ratio->numerator);
    add_homogeneous(c, ratio->denominator);
    long *row = new_row(c);
    add_exponents(c, row, ratio->numerator, 0, 1);
    add_exponents(c, row, ratio->denominator, 0, -1);
    row[variable] -= multiple;
    row[c->width - 1] -= times;
}

static void gather(conditions *c, const ttc_flow *flow)
{
    *c = (conditions){ .flow = flow, .width = flow->ring->variable_count + 1 };
    for (size_t i = 0; i < flow->count; i++) add_ratio(c, &flow->slopes[flow->variables[i]], flow->variables[i], 1, 1);
    for (size_t i = 0; i < flow->ring->generator_count; i++)
        add_ratio(c, &flow->ring->generators[i].square, flow->ring->generators[i].variable, 2, 0);
}

/* The null space over the field of two elements, of rows with `width` bits; returns its dimension, at most `most`. */
static size_t null_space(uint64_t *basis, size_t most, uint64_t *rows, size_t row_count, size_t width)
{
    size_t rank = 0, count = 0;
    bool is_pivot[64] = { false };
    size_t pivot_of[64];
    for (size_t bit = 0; bit < width && rank < row_count; bit++) {
        size_t found = rank;
        while (found < row_count && (rows[found] >> bit & 1) == 0) found++;
        if (found == row_count) continue;
        const uint64_t row = rows[found];
        rows[found] = rows[rank];
        rows[rank] = row;
        for (size_t i = 0; i < row_count; i++)
            if (i != rank && (rows[i] >> bit & 1) != 0) rows[i] ^= row;
        is_pivot[bit] = true;
        pivot_of[rank++] = bit;
    }
    for (size_t bit = 0; bit < width && count < most; bit++) {
        if (is_pivot[bit]) continue;
        basis[count] = UINT64_C(1) << bit;
        for (size_t i = 0; i < rank; i++)
            if ((rows[i] >> bit & 1) != 0) basis[count] |= UINT64_C(1) << pivot_of[i];
        count++;
    }
    return count;
}

/* Combine changes so that at most the last one contains `time`, the bit of backward ones. */
static void put_backwards_last(ttc_sign_changes *out, uint64_t time)
{
    size_t last = out->count;
    for (size_t i = 0; i < out->count; i++)
        if ((out->changes[i] & time) != 0) last = i;
    out->last_is_backwards = last < out->count;
    if (!out->last_is_backwards) return;
    const uint64_t backwards = out->changes[last];
    out->changes[last] = out->changes[out->count - 1];
    for (size_t i = 0; i + 1 < out->count; i++)
        if ((out->changes[i] & time) != 0) out->changes[i] ^= backwards;
    out->changes[out->count - 1] = backwards & ~time;
}

void ttc_sign_changes_find(ttc_sign_changes *out, const ttc_flow *flow)
{
    conditions c;
    *out = (ttc_sign_changes){ .count = 0 };
    if (flow->count > 62) return;
    gather(&c, flow);
    uint64_t *rows = flint_calloc(c.count + 1, sizeof *rows);
    for (size_t r = 0; r < c.count; r++) {
        const long *row = c.rows + r * c.width;
        for (size_t i = 0; i < flow->count; i++) rows[r] |= (uint64_t)(row[flow->variables[i]] & 1) << i;
        rows[r] |= (uint64_t)(row[c.width - 1] & 1) << flow->count;
    }
    out->count = null_space(out->changes, TTC_SIGN_CHANGES_MAX, rows, c.count, flow->count + 1);
    put_backwards_last(out, UINT64_C(1) << flow->count);
    flint_free(rows);
    flint_free(c.rows);
}

static bool keep(const ttc_sign_changes *changes, const ttc_flow *flow, const fmpz_mpoly_t a)
{
    bool kept = true;
    uint32_t first = 0;
    ulong *exponents = flint_calloc(flow->ring->variable_count, sizeof *exponents);
    for (slong t = 0; t < fmpz_mpoly_length(a, flow->ring->context); t++) {
        uint32_t signs = 0;
        fmpz_mpoly_get_term_exp_ui(exponents, a, t, flow->ring->context);
        for (size_t k = 0; k < changes->count; k++)
            for (size_t i = 0; i < flow->count; i++)
                signs ^= (uint32_t)(changes->changes[k] >> i & exponents[flow->variables[i]] & 1) << k;
        if (t == 0) first = signs;
        kept &= signs == first;
    }
    flint_free(exponents);
    return kept;
}

bool ttc_sign_changes_keep(const ttc_sign_changes *changes, const ttc_flow *flow, const ttc_ratio *a)
{
    return keep(changes, flow, a->numerator) && keep(changes, flow, a->denominator);
}

/* The weights in a column of `null`, of either sign, if they are a grading. Rows: quantities, the parameter, time. */
static bool accept(ttc_grading *out, const ttc_flow *flow, const fmpz_mat_t null, slong column, slong parameter)
{
    const slong count = (slong)flow->count;
    long common = 0; /* greatest common divisor of all weights */
    for (slong i = 0; i <= count + 1; i++)
        common = (long)n_gcd((ulong)common, (ulong)labs((long)fmpz_get_si(fmpz_mat_entry(null, i, column))));
    for (long sign = 1; sign >= -1 && common > 0; sign -= 2) {
        bool good = true, some = false;
        for (slong i = 0; i < count; i++) {
            const long weight = sign * (long)fmpz_get_si(fmpz_mat_entry(null, i, column)) / common;
            good &= weight >= 0;
            some |= weight > 0;
            out->weights[i] = weight;
        }
        if (parameter >= 0) good &= sign * fmpz_sgn(fmpz_mat_entry(null, count, column)) > 0;
        if (good && some) {
            out->parameter = parameter;
            return true;
        }
    }
    return false;
}

/* Whether the leading part, where this parameter is 0, is defined: no denominator vanishes, no radicand contains it. */
static bool may_vanish(const ttc_flow *flow, slong parameter)
{
    for (size_t i = 0; i < flow->ring->generator_count; i++)
        if (ttc_ratio_uses(flow->ring, &flow->ring->generators[i].square, parameter)) return false;
    ulong exponent = 0;
    bool may = true;
    fmpz_mpoly_t rest;
    fmpz_mpoly_init(rest, flow->ring->context);
    for (size_t i = 0; i < flow->count; i++) {
        fmpz_mpoly_get_coeff_vars_ui(rest, flow->slopes[flow->variables[i]].denominator, &parameter, &exponent, 1,
                                     flow->ring->context);
        may &= !fmpz_mpoly_is_zero(rest, flow->ring->context);
    }
    fmpz_mpoly_clear(rest, flow->ring->context);
    return may;
}

static bool find_with(ttc_grading *out, const conditions *c, slong parameter)
{
    const ttc_flow *flow = c->flow;
    const slong count = (slong)flow->count, width = count + 2;
    fmpz_mat_t rows, null;
    bool found = false;
    fmpz_mat_init(rows, (slong)c->count, width);
    fmpz_mat_init(null, width, width);
    for (slong r = 0; r < (slong)c->count; r++) {
        const long *row = c->rows + (size_t)r * c->width;
        for (slong i = 0; i < count; i++) fmpz_set_si(fmpz_mat_entry(rows, r, i), row[flow->variables[i]]);
        if (parameter >= 0) fmpz_set_si(fmpz_mat_entry(rows, r, count), row[parameter]);
        fmpz_set_si(fmpz_mat_entry(rows, r, count + 1), row[c->width - 1]);
    }
    const slong dimension = fmpz_mat_nullspace(null, rows);
    for (slong k = 0; k < dimension && !found; k++) found = accept(out, flow, null, k, parameter);
    fmpz_mat_clear(null);
    fmpz_mat_clear(rows);
    return found;
}

void ttc_grading_find(ttc_grading *out, const ttc_flow *flow)
{
    conditions c;
    gather(&c, flow);
    *out = (ttc_grading){ .weights = flint_calloc(flow->count + 1, sizeof *out->weights), .parameter = -1 };
    bool found = flow->is_graded && find_with(out, &c, -1);
    for (size_t i = 0; !found && flow->is_graded && i < flow->parameter_count; i++)
        found = may_vanish(flow, flow->parameters[i]) && find_with(out, &c, flow->parameters[i]);
    if (!found) ttc_grading_clear(out);
    flint_free(c.rows);
}

void ttc_grading_clear(ttc_grading *grading)
{
    flint_free(grading->weights);
    *grading = (ttc_grading){ .parameter = -1 };
}
