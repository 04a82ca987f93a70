#include "discover/dependence.h"

#include <flint/nmod_mat.h>
#include <flint/nmod_poly.h>

#include <string.h>

enum { POINTS = 20, TERMS_MAX = 2000, ROWS_TO_SPARE = 3 };

/* By function and parameter: degrees of numerator and denominator. */
typedef struct {
    int *above, *below;
} degrees;

typedef struct {
    const ttc_flow *flow;
    size_t count; /* functions */
    ttc_dependence_sampler sample;
    void *context;
    ulong *parameters; /* of each sample: shape (samples, variable_count) */
    ulong *values;     /* shape (samples, count) */
    size_t samples;
} search;

static bool draw(search *s, size_t at, const ulong *parameters)
{
    const size_t width = s->flow->ring->variable_count;
    ulong *place = s->parameters + at * width;
    memcpy(place, parameters, width * sizeof *place);
    return s->sample(s->context, s->values + at * s->count, place);
}

/* The degrees of the quotient r/t, with r = t y at the points x, of the least sum of degrees, by the Euclidean algorithm. Returns
 * false if they are too high for so few points. */
static bool univariate(int *above, int *below, const ulong *x, const ulong *y, nmod_t mod)
{
    slong best = 2 * POINTS;
    nmod_poly_t r, next_r, t, next_t, quotient, product;
    nmod_poly_struct *all[] = { r, next_r, t, next_t, quotient, product };
    for (size_t i = 0; i < 6; i++) nmod_poly_init(all[i], mod.n);
    nmod_poly_product_roots_nmod_vec(r, x, POINTS);
    nmod_poly_interpolate_nmod_vec(next_r, x, y, POINTS);
    nmod_poly_one(next_t);
    while (!nmod_poly_is_zero(next_r)) {
        const slong sum = nmod_poly_degree(next_r) + nmod_poly_degree(next_t);
        if (sum < best) {
            best = sum;
            *above = (int)nmod_poly_degree(next_r);
            *below = (int)nmod_poly_degree(next_t);
        }
        nmod_poly_divrem(quotient, r, r, next_r);
        nmod_poly_swap(r, next_r);
        nmod_poly_mul(product, quotient, next_t);
        nmod_poly_sub(t, t, product);
        nmod_poly_swap(t, next_t);
    }
    for (size_t i = 0; i < 6; i++) nmod_poly_clear(all[i]);
    return best <= POINTS - 3;
}

static bool find_degrees(search *s, degrees *d, uint64_t *source)
{
    const ttc_flow *flow = s->flow;
    const size_t width = flow->ring->variable_count;
    bool good = true;
    ulong x[POINTS], y[POINTS];
    ulong *base = flint_calloc(width, sizeof *base);
    ttc_flow_draw_parameters(flow, base, -1, source);
    for (size_t i = 0; good && i < flow->parameter_count; i++) {
        const ulong kept = base[flow->parameters[i]];
        for (size_t k = 0; good && k < POINTS; k++) {
            x[k] = base[flow->parameters[i]] = ttc_modular_draw(source, flow->mod);
            good = draw(s, k, base);
        }
        base[flow->parameters[i]] = kept;
        for (size_t j = 0; good && j < s->count; j++) {
            const size_t at = j * flow->parameter_count + i;
            for (size_t k = 0; k < POINTS; k++) y[k] = s->values[k * s->count + j];
            good = univariate(&d->above[at], &d->below[at], x, y, flow->mod);
        }
    }
    flint_free(base);
    return good;
}

/* The number of monomials with at most these degrees; as a double, for it may be huge. */
static double box_size(const int *of, size_t count)
{
    double size = 1;
    for (size_t i = 0; i < count; i++) size *= of[i] + 1;
    return size;
}

/* Monomial number k of the box: its exponents by parameter. */
static void box_exponents(int *exponents, size_t k, const int *of, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        exponents[i] = (int)(k % ((size_t)of[i] + 1));
        k /= (size_t)of[i] + 1;
    }
}

static ulong box_value(size_t k, const int *of, const ttc_flow *flow, const ulong *parameters)
{
    ulong value = 1;
    for (size_t i = 0; i < flow->parameter_count; i++) {
        const size_t e = k % ((size_t)of[i] + 1);
        k /= (size_t)of[i] + 1;
        for (size_t n = 0; n < e; n++) value = nmod_mul(value, parameters[flow->parameters[i]], flow->mod);
    }
    return value;
}

/* *out = numerator/denominator with the coefficients coefficients[k]/scale. Returns false if one is no small rational number. */
static bool set_polynomials(ttc_ratio *out, const ttc_flow *flow, const ulong *coefficients, ulong scale, const int *above,
                            size_t above_count, const int *below, size_t below_count)
{
    bool good = true;
    fmpq_t number;
    ttc_ratio parts[2], term, factor;
    int *exponents = flint_calloc(flow->parameter_count + 1, sizeof *exponents);
    fmpq_init(number);
    for (int p = 0; p < 2; p++) ttc_ratio_init(flow->ring, &parts[p]);
    ttc_ratio_init(flow->ring, &term);
    ttc_ratio_init(flow->ring, &factor);
    for (size_t k = 0; good && k < above_count + below_count; k++) {
        const bool is_above = k < above_count;
        if (coefficients[k] == 0) continue;
        good = ttc_modular_rational(number, nmod_div(coefficients[k], scale, flow->mod), flow->mod);
        ttc_ratio_set_rational(flow->ring, &term, number);
        box_exponents(exponents, is_above ? k : k - above_count, is_above ? above : below, flow->parameter_count);
        for (size_t i = 0; i < flow->parameter_count; i++) {
            ttc_ratio_set_variable(flow->ring, &factor, flow->parameters[i]);
            ttc_ratio_power(flow->ring, &factor, &factor, exponents[i]);
            ttc_ratio_multiply(flow->ring, &term, &term, &factor);
        }
        ttc_ratio_add(flow->ring, &parts[is_above ? 0 : 1], &parts[is_above ? 0 : 1], &term);
    }
    if (good) ttc_ratio_divide(flow->ring, out, &parts[0], &parts[1]);
    good = good && flow->ring->status == TTC_RING_OK;
    ttc_ratio_clear(flow->ring, &factor);
    ttc_ratio_clear(flow->ring, &term);
    for (int p = 0; p < 2; p++) ttc_ratio_clear(flow->ring, &parts[p]);
    fmpq_clear(number);
    flint_free(exponents);
    return good;
}

/* Solve numerator - value * denominator = 0 at all samples. Returns false unless the solution is unique up to a factor. */
static bool solve(ttc_ratio *out, const search *s, size_t j, const int *above, const int *below)
{
    const ttc_flow *flow = s->flow;
    const size_t above_count = (size_t)box_size(above, flow->parameter_count);
    const size_t below_count = (size_t)box_size(below, flow->parameter_count), count = above_count + below_count;
    const size_t width = flow->ring->variable_count, rows = count + ROWS_TO_SPARE;
    nmod_mat_t system, null;
    nmod_mat_init(system, (slong)rows, (slong)count, flow->mod.n);
    nmod_mat_init(null, (slong)count, (slong)count, flow->mod.n);
    for (size_t r = 0; r < rows; r++) {
        const ulong *parameters = s->parameters + r * width;
        const ulong minus = nmod_neg(s->values[r * s->count + j], flow->mod);
        for (size_t k = 0; k < above_count; k++)
            nmod_mat_entry(system, (slong)r, (slong)k) = box_value(k, above, flow, parameters);
        for (size_t k = 0; k < below_count; k++)
            nmod_mat_entry(system, (slong)r, (slong)(above_count + k)) = nmod_mul(minus, box_value(k, below, flow, parameters),
                                                                                  flow->mod);
    }
    bool good = nmod_mat_nullspace(null, system) == 1;
    ulong *coefficients = flint_calloc(count, sizeof *coefficients);
    ulong scale = 0;
    for (size_t k = 0; good && k < count; k++) {
        coefficients[k] = nmod_mat_entry(null, (slong)k, 0);
        if (k >= above_count && scale == 0) scale = coefficients[k];
    }
    good = good && scale != 0 && set_polynomials(out, flow, coefficients, scale, above, above_count, below, below_count);
    flint_free(coefficients);
    nmod_mat_clear(null);
    nmod_mat_clear(system);
    return good;
}

static bool find(ttc_ratio *out, search *s, const degrees *d, uint64_t *source)
{
    const ttc_flow *flow = s->flow;
    const size_t width = flow->ring->variable_count;
    double most = 0;
    for (size_t j = 0; j < s->count; j++) {
        const size_t at = j * flow->parameter_count;
        const double size = box_size(d->above + at, flow->parameter_count) + box_size(d->below + at, flow->parameter_count);
        if (size > most) most = size;
    }
    if (most > TERMS_MAX) return false;
    const size_t samples = (size_t)most + ROWS_TO_SPARE;
    bool good = true;
    s->parameters = flint_realloc(s->parameters, (samples + POINTS) * width * sizeof *s->parameters);
    s->values = flint_realloc(s->values, (samples + POINTS) * s->count * sizeof *s->values);
    ulong *parameters = flint_calloc(width, sizeof *parameters);
    for (size_t k = 0; good && k < samples; k++) {
        ttc_flow_draw_parameters(flow, parameters, -1, source);
        good = draw(s, k, parameters);
    }
    for (size_t j = 0; good && j < s->count; j++)
        good = solve(&out[j], s, j, d->above + j * flow->parameter_count, d->below + j * flow->parameter_count);
    flint_free(parameters);
    return good;
}

bool ttc_dependence_find(ttc_ratio *out, size_t count, const ttc_flow *flow, ttc_dependence_sampler sample, void *context,
                         uint64_t *source)
{
    search s = { .flow = flow, .count = count, .sample = sample, .context = context };
    const size_t pairs = count * flow->parameter_count + 1;
    degrees d = { flint_calloc(pairs, sizeof *d.above), flint_calloc(pairs, sizeof *d.below) };
    s.parameters = flint_calloc(POINTS * flow->ring->variable_count, sizeof *s.parameters);
    s.values = flint_calloc(POINTS * count + 1, sizeof *s.values);
    const bool good = find_degrees(&s, &d, source) && find(out, &s, &d, source);
    flint_free(s.values);
    flint_free(s.parameters);
    flint_free(d.below);
    flint_free(d.above);
    return good;
}
