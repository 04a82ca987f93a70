#include "discover/null_space.h"

enum { EXPONENTS = 256, ROWS_TO_SPARE = 4 };

/* Powers of the quantities at a point, and multiples of their logarithmic rates: shapes (quantities, EXPONENTS). */
typedef struct {
    ulong *powers, *multiples;
} tables;

static void tables_init(tables *t, const ttc_flow *flow)
{
    t->powers = flint_calloc(flow->count * EXPONENTS + 1, sizeof *t->powers);
    t->multiples = flint_calloc(flow->count * EXPONENTS + 1, sizeof *t->multiples);
}

static void tables_clear(tables *t)
{
    flint_free(t->multiples);
    flint_free(t->powers);
}

static void tables_fill(tables *t, const ttc_flow *flow, const ttc_ansatz_sector *sector, const ulong *values,
                        const ulong *logarithmic)
{
    unsigned most = 0;
    for (size_t i = 0; i < sector->count * flow->count; i++)
        if (sector->exponents[i] > most) most = sector->exponents[i];
    for (size_t q = 0; q < flow->count; q++) {
        ulong *power = t->powers + q * EXPONENTS, *multiple = t->multiples + q * EXPONENTS;
        power[0] = 1;
        for (unsigned e = 1; e <= most; e++) {
            power[e] = nmod_mul(power[e - 1], values[flow->variables[q]], flow->mod);
            if (logarithmic != NULL) multiple[e] = nmod_add(multiple[e - 1], logarithmic[q], flow->mod);
        }
    }
}

static ulong monomial(const tables *t, const ttc_flow *flow, const unsigned char *exponents)
{
    ulong value = 1;
    for (size_t q = 0; q < flow->count; q++)
        if (exponents[q] > 0) value = nmod_mul(value, t->powers[q * EXPONENTS + exponents[q]], flow->mod);
    return value;
}

void ttc_null_space_values(ulong *out, const ttc_flow *flow, const ttc_ansatz_sector *sector, const ulong *values)
{
    tables t;
    tables_init(&t, flow);
    tables_fill(&t, flow, sector, values, NULL);
    for (size_t j = 0; j < sector->count; j++) out[j] = monomial(&t, flow, sector->exponents + j * flow->count);
    tables_clear(&t);
}

/* m' + c m = m (sum of exponents times logarithmic rates + c). values may be NULL. */
static void fill_row(mp_limb_t *values, mp_limb_t *rates, const tables *t, const ttc_flow *flow, const ttc_ansatz_sector *sector,
                     ulong c)
{
    for (size_t j = 0; j < sector->count; j++) {
        const unsigned char *exponents = sector->exponents + j * flow->count;
        const ulong value = monomial(t, flow, exponents);
        ulong factor = c;
        for (size_t q = 0; q < flow->count; q++)
            if (exponents[q] > 0) factor = nmod_add(factor, t->multiples[q * EXPONENTS + exponents[q]], flow->mod);
        if (values != NULL) values[j] = value;
        rates[j] = nmod_mul(value, factor, flow->mod);
    }
}

/* Draw a point at which c has a value, and compute it. */
static bool draw(ulong *c, const ttc_flow *flow, ttc_twist twist, ulong *values, ulong *logarithmic, uint64_t *source)
{
    for (int attempt = 0; attempt < 64; attempt++) {
        *c = 0;
        if (!ttc_flow_draw(flow, values, logarithmic, source)) return false;
        if (twist.twist != NULL && !ttc_modular_ratio_value(c, twist.twist, values, flow->mod)) continue;
        *c = nmod_sub(*c, twist.shift, flow->mod);
        return true;
    }
    return false;
}

static bool fill(nmod_mat_struct *values, nmod_mat_t rates, const ttc_flow *flow, const ttc_ansatz_sector *sector, ttc_twist twist,
                 ulong *parameters, uint64_t *source)
{
    bool good = true;
    tables t;
    ulong *logarithmic = flint_calloc(flow->count + 1, sizeof *logarithmic);
    tables_init(&t, flow);
    for (slong i = 0; good && i < rates->r; i++) {
        ulong c = 0;
        good = draw(&c, flow, twist, parameters, logarithmic, source);
        if (!good) break;
        tables_fill(&t, flow, sector, parameters, logarithmic);
        fill_row(values == NULL ? NULL : &nmod_mat_entry(values, i, 0), &nmod_mat_entry(rates, i, 0), &t, flow, sector, c);
    }
    tables_clear(&t);
    flint_free(logarithmic);
    return good;
}

bool ttc_null_space_rows(nmod_mat_t values, nmod_mat_t rates, const ttc_flow *flow, const ttc_ansatz_sector *sector,
                         ttc_twist twist, ulong *parameters, uint64_t *source)
{
    return fill(values, rates, flow, sector, twist, parameters, source);
}

slong ttc_null_space_bound(const ttc_flow *flow, const ttc_ansatz_sector *sector, ttc_twist twist, ulong *parameters,
                           uint64_t *source)
{
    const slong count = (slong)sector->count;
    slong bound = -1;
    nmod_mat_t rates;
    nmod_mat_init(rates, count + ROWS_TO_SPARE, count, flow->mod.n);
    if (fill(NULL, rates, flow, sector, twist, parameters, source)) {
        slong *order = flint_calloc((size_t)(count + ROWS_TO_SPARE), sizeof *order);
        bound = count - nmod_mat_lu(order, rates, 0);
        flint_free(order);
    }
    nmod_mat_clear(rates);
    return bound;
}

slong ttc_null_space(nmod_mat_t null, const ttc_flow *flow, const ttc_ansatz_sector *sector, ttc_twist twist, ulong *parameters,
                     uint64_t *source)
{
    const slong count = (slong)sector->count;
    nmod_mat_t rates;
    nmod_mat_init(rates, count + ROWS_TO_SPARE, count, flow->mod.n);
    if (!fill(NULL, rates, flow, sector, twist, parameters, source)) {
        nmod_mat_clear(rates);
        nmod_mat_init(null, 0, count, flow->mod.n);
        return -1;
    }
    const slong rank = nmod_mat_rref(rates);
    slong pivot = 0, at = 0;
    slong *pivots = flint_calloc((size_t)count + 1, sizeof *pivots);
    nmod_mat_init(null, count - rank, count, flow->mod.n);
    for (slong j = 0; j < count; j++) { /* each column without pivot gives a vector that is 1 there */
        if (pivot < rank && nmod_mat_entry(rates, pivot, j) != 0) {
            pivots[pivot++] = j;
            continue;
        }
        for (slong i = 0; i < pivot; i++)
            nmod_mat_entry(null, at, pivots[i]) = nmod_neg(nmod_mat_entry(rates, i, j), flow->mod);
        nmod_mat_entry(null, at++, j) = 1;
    }
    flint_free(pivots);
    nmod_mat_clear(rates);
    return count - rank;
}
