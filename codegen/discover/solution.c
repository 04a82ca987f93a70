#include "discover/solution.h"

#include "discover/dependence.h"

#include <flint/nmod_poly.h>
#include <flint/nmod_poly_factor.h>

#include <stdlib.h>
#include <string.h>

enum { PERMUTATIONS = 60, KEPT_A_PERMUTATION = 64 };

static slong support(const mp_limb_t *row, slong count)
{
    slong size = 0;
    for (slong j = 0; j < count; j++) size += row[j] != 0;
    return size;
}

typedef struct {
    mp_limb_t *row;
    slong size, count;
} candidate;

static int fewest_first(const void *left, const void *right)
{
    const candidate *a = left, *b = right;
    if (a->size != b->size) return a->size < b->size ? -1 : 1;
    for (slong j = a->count; j-- > 0;) /* of the same size, those of low degree first */
        if ((a->row[j] != 0) != (b->row[j] != 0)) return a->row[j] == 0 ? -1 : 1;
    return memcmp(a->row, b->row, (size_t)a->count * sizeof *a->row);
}

static void permute(slong *order, slong count, uint64_t *source, nmod_t mod)
{
    for (slong i = count - 1; i > 0; i--) {
        const slong k = (slong)(ttc_modular_draw(source, mod) % (ulong)(i + 1)), kept = order[i];
        order[i] = order[k];
        order[k] = kept;
    }
}

void ttc_solution_sparse(nmod_mat_t out, const nmod_mat_t null, uint64_t *source)
{
    const slong dimension = null->r, count = null->c;
    const slong kept = dimension < KEPT_A_PERMUTATION ? dimension : KEPT_A_PERMUTATION;
    const slong permutations = dimension == 1 ? 1 : PERMUTATIONS;
    slong at = 0;
    nmod_t mod = null->mod;
    slong *order = flint_calloc((size_t)count + 1, sizeof *order);
    candidate *candidates = flint_calloc((size_t)(permutations * kept) + 1, sizeof *candidates);
    mp_limb_t *rows = flint_calloc((size_t)(permutations * kept * count) + 1, sizeof *rows);
    for (slong j = 0; j < count; j++) order[j] = j;
    for (slong p = 0; p < permutations; p++) {
        nmod_mat_t permuted;
        nmod_mat_init(permuted, dimension, count, mod.n);
        for (slong i = 0; i < dimension; i++)
            for (slong j = 0; j < count; j++) nmod_mat_entry(permuted, i, j) = nmod_mat_entry(null, i, order[j]);
        nmod_mat_rref(permuted);
        for (slong i = 0; i < kept; i++, at++) {
            mp_limb_t *row = rows + at * count;
            ulong last = 1;
            for (slong j = 0; j < count; j++) row[order[j]] = nmod_mat_entry(permuted, i, j);
            for (slong j = 0; j < count; j++)
                if (row[j] != 0) last = row[j];
            for (slong j = 0; j < count; j++) row[j] = nmod_div(row[j], last, mod);
            candidates[at] = (candidate){ row, support(row, count), count };
        }
        nmod_mat_clear(permuted);
        permute(order, count, source, mod);
    }
    qsort(candidates, (size_t)at, sizeof *candidates, fewest_first);
    slong found = 0;
    for (slong i = 0; i < at; i++)
        if (i == 0 || memcmp(candidates[i].row, candidates[i - 1].row, (size_t)count * sizeof *rows) != 0)
            candidates[found++] = candidates[i];
    nmod_mat_init(out, found, count, mod.n);
    for (slong i = 0; i < found; i++)
        for (slong j = 0; j < count; j++) nmod_mat_entry(out, i, j) = candidates[i].row[j];
    flint_free(rows);
    flint_free(candidates);
    flint_free(order);
}

bool ttc_solution_cofactors(ulong *out, size_t *count, const ttc_flow *flow, const ttc_ansatz_sector *sector, ulong *parameters,
                            uint64_t *source)
{
    const slong size = (slong)sector->count;
    nmod_mat_t values, rates, cut;
    *count = 0;
    nmod_mat_init(values, size, size, flow->mod.n);
    nmod_mat_init(rates, size, size, flow->mod.n);
    nmod_mat_init(cut, size, size, flow->mod.n);
    const bool good = ttc_null_space_rows(values, rates, flow, sector, (ttc_twist){ NULL, 0 }, parameters, source)
                      && nmod_mat_solve(cut, values, rates) != 0;
    if (good) {
        nmod_poly_t polynomial;
        nmod_poly_factor_t roots;
        nmod_poly_init(polynomial, flow->mod.n);
        nmod_poly_factor_init(roots);
        nmod_mat_charpoly(polynomial, cut);
        nmod_poly_roots(roots, polynomial, 0);
        for (slong i = 0; i < roots->num; i++) {
            const ulong root = nmod_neg(nmod_poly_get_coeff_ui(roots->p + i, 0), flow->mod);
            if (root != 0) out[(*count)++] = root;
        }
        nmod_poly_factor_clear(roots);
        nmod_poly_clear(polynomial);
    }
    nmod_mat_clear(cut);
    nmod_mat_clear(rates);
    nmod_mat_clear(values);
    return good;
}

/* A solution at variable parameters, with fixed monomials. */
typedef struct {
    const ttc_flow *flow;
    ttc_ansatz_sector sector;
    const ttc_modular_ratio *twist;
    bool has_cofactor;
    ulong cofactor;   /* if there are no parameters to depend on */
    size_t reference; /* the monomial whose coefficient is 1 */
    uint64_t *source;
} family;

/* out = coefficients over that of the reference. Returns false unless there is one solution with this shift, without zeros. */
static bool coefficients_at(const family *f, ulong *out, ulong *parameters, ulong shift)
{
    nmod_mat_t null;
    const slong dimension = ttc_null_space(null, f->flow, &f->sector, (ttc_twist){ f->twist, shift }, parameters, f->source);
    bool good = dimension == 1;
    for (size_t j = 0; good && j < f->sector.count; j++) good = nmod_mat_entry(null, 0, (slong)j) != 0;
    for (size_t j = 0; good && j < f->sector.count; j++)
        out[j] = nmod_div(nmod_mat_entry(null, 0, (slong)j), nmod_mat_entry(null, 0, (slong)f->reference), f->flow->mod);
    nmod_mat_clear(null);
    return good;
}

static bool sample(void *context, ulong *out, ulong *parameters)
{
    const family *f = context;
    if (!f->has_cofactor) return coefficients_at(f, out, parameters, 0);
    if (f->flow->parameter_count == 0) {
        out[f->sector.count] = f->cofactor;
        return coefficients_at(f, out, parameters, f->cofactor);
    }
    ulong *shifts = flint_calloc(f->sector.count + 1, sizeof *shifts);
    size_t matches = 0, count = 0;
    ttc_solution_cofactors(shifts, &count, f->flow, &f->sector, parameters, f->source);
    for (size_t i = 0; i < count && matches < 2; i++) {
        if (!coefficients_at(f, out, parameters, shifts[i])) continue;
        out[f->sector.count] = shifts[i];
        matches++;
    }
    flint_free(shifts);
    return matches == 1;
}

/* Sum of coefficients times monomials, without denominators and common factors, with no more minus than plus signs. */
static bool assemble(ttc_solution_exact *out, const family *f, const ttc_ratio *coefficients)
{
    const ttc_flow *flow = f->flow;
    ttc_ring *ring = flow->ring;
    ttc_ratio term, factor;
    fmpz_mpoly_t content;
    fmpz_t coefficient;
    ttc_ratio_init(ring, &term);
    ttc_ratio_init(ring, &factor);
    fmpz_mpoly_init(content, ring->context);
    for (size_t j = 0; j < f->sector.count; j++) {
        ttc_ratio_set(ring, &term, &coefficients[j]);
        for (size_t q = 0; q < flow->count; q++) {
            ttc_ratio_set_variable(ring, &factor, flow->variables[q]);
            ttc_ratio_power(ring, &factor, &factor, f->sector.exponents[j * flow->count + q]);
            ttc_ratio_multiply(ring, &term, &term, &factor);
        }
        ttc_ratio_add(ring, &out->polynomial, &out->polynomial, &term);
    }
    slong negative = 0;
    bool good = ring->status == TTC_RING_OK
                && fmpz_mpoly_content_vars(content, out->polynomial.numerator, flow->variables, (slong)flow->count,
                                           ring->context) != 0;
    if (good) {
        ttc_ratio_set_polynomial(ring, &factor, content);
        ttc_ratio_set_polynomial(ring, &term, out->polynomial.numerator);
        ttc_ratio_divide(ring, &out->polynomial, &term, &factor);
        good = ring->status == TTC_RING_OK && fmpz_mpoly_is_one(out->polynomial.denominator, ring->context);
    }
    fmpz_init(coefficient);
    for (slong t = 0; t < fmpz_mpoly_length(out->polynomial.numerator, ring->context); t++) {
        fmpz_mpoly_get_term_coeff_fmpz(coefficient, out->polynomial.numerator, t, ring->context);
        negative += fmpz_sgn(coefficient) < 0 ? 1 : -1;
    }
    if (negative > 0) ttc_ratio_scale(ring, &out->polynomial, &out->polynomial, ring->minus_one);
    fmpz_clear(coefficient);
    if (good && f->has_cofactor) ttc_ratio_set(ring, &out->cofactor, &coefficients[f->sector.count]);
    fmpz_mpoly_clear(content, ring->context);
    ttc_ratio_clear(ring, &factor);
    ttc_ratio_clear(ring, &term);
    return good;
}

bool ttc_solution_lift(ttc_solution_exact *out, const ttc_flow *flow, const ttc_ansatz_sector *sector, const ulong *vector,
                       const ttc_modular_ratio *twist, ulong cofactor, uint64_t *source)
{
    const bool has_cofactor = cofactor != 0;
    family f = { .flow = flow, .twist = twist, .has_cofactor = has_cofactor, .cofactor = cofactor, .source = source };
    ttc_ratio_init(flow->ring, &out->polynomial);
    ttc_ratio_init(flow->ring, &out->cofactor);
    f.sector.exponents = flint_calloc(sector->count + 1, flow->count + 1);
    for (size_t j = 0; j < sector->count; j++)
        if (vector[j] != 0)
            memcpy(f.sector.exponents + f.sector.count++ * flow->count, sector->exponents + j * flow->count, flow->count);
    const size_t count = f.sector.count + has_cofactor;
    f.reference = f.sector.count - 1;
    ttc_ratio *coefficients = flint_calloc(count, sizeof *coefficients);
    for (size_t j = 0; j < count; j++) ttc_ratio_init(flow->ring, &coefficients[j]);
    const bool good = ttc_dependence_find(coefficients, count, flow, sample, &f, source) && assemble(out, &f, coefficients);
    for (size_t j = 0; j < count; j++) ttc_ratio_clear(flow->ring, &coefficients[j]);
    flint_free(coefficients);
    flint_free(f.sector.exponents);
    return good;
}

void ttc_solution_clear(ttc_solution_exact *solution, const ttc_flow *flow)
{
    ttc_ratio_clear(flow->ring, &solution->cofactor);
    ttc_ratio_clear(flow->ring, &solution->polynomial);
}
