#include "algebra/independence.h"

#include <stdint.h>
#include <stdlib.h>

/* What decides: how many variables of each trust a polynomial uses, squares of generators included. */
typedef struct {
    size_t count[TTC_TRUST_MASK + 1];
    bool doubtful; /* one of them is no number */
    bool nested;   /* one of them stands in the square of a generator */
    bool generators;
} usage;

static size_t generator_of(const ttc_ring *ring, slong variable)
{
    for (size_t i = 0; i < ring->generator_count; i++)
        if (ring->generators[i].variable == variable) return i;
    return SIZE_MAX;
}

static void mark(const ttc_ring *ring, unsigned char *used, const fmpz_mpoly_t polynomial)
{
    for (slong v = 0; v < (slong)ring->variable_count; v++)
        if (fmpz_mpoly_degree_si(polynomial, v, ring->context) > 0) used[v] = 1;
}

/* The square of a generator holds earlier ones, so the last one goes first. */
static bool survey(usage *u, const ttc_ring *ring, const fmpz_mpoly_t polynomial)
{
    unsigned char *used = calloc(ring->variable_count + 1, 1), *direct = calloc(ring->variable_count + 1, 1);
    bool ok = used != NULL && direct != NULL;
    *u = (usage){ .doubtful = false };
    if (ok) mark(ring, used, polynomial);
    if (ok) mark(ring, direct, polynomial);
    for (size_t i = ring->generator_count; ok && i-- > 0;) {
        const ttc_generator *generator = &ring->generators[i];
        if (!used[generator->variable]) continue;
        u->generators = true;
        mark(ring, used, generator->square.numerator);
        mark(ring, used, generator->square.denominator);
    }
    for (slong v = 0; ok && v < (slong)ring->variable_count; v++) {
        const unsigned trust = ring->trust[v];
        if (!used[v] || generator_of(ring, v) != SIZE_MAX) continue;
        u->count[trust & TTC_TRUST_MASK]++;
        if ((trust & TTC_TRUST_MASK) == TTC_TRUST_FREE) continue;
        u->doubtful |= (trust & TTC_TRUST_CONSTANT) == 0;
        u->nested |= !direct[v];
    }
    free(direct);
    free(used);
    return ok;
}

static bool decides(const usage *u)
{
    if (u->count[TTC_TRUST_NONE] > 0) return false;
    return u->count[TTC_TRUST_SINGLE] == 0 || (u->count[TTC_TRUST_SINGLE] == 1 && u->count[TTC_TRUST_ALGEBRAIC] == 0);
}

/* The coefficient, in numbers, of the term's monomial in free variables. */
static void coefficient_of(const ttc_ring *ring, fmpz_mpoly_t coefficient, const fmpz_mpoly_t polynomial, slong term,
                           slong *variables, ulong *exponents)
{
    slong count = 0;
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        if (ring->trust[v] != TTC_TRUST_FREE) continue;
        variables[count] = v;
        exponents[count++] = fmpz_mpoly_get_term_var_exp_ui(polynomial, term, v, ring->context);
    }
    fmpz_mpoly_get_coeff_vars_ui(coefficient, polynomial, variables, exponents, count, ring->context);
}

/* A product of numbers none of which is zero, or a linear form in pi and logarithms, see independence.h. */
static bool is_simple(const ttc_ring *ring, const usage *u, const fmpz_mpoly_t coefficient)
{
    if (u->count[TTC_TRUST_NONE] > 0) return false;
    return fmpz_mpoly_length(coefficient, ring->context) == 1
           || (u->count[TTC_TRUST_ALGEBRAIC] == 0 && fmpz_mpoly_total_degree_si(coefficient, ring->context) <= 1);
}

/* Free variables are independent over the numbers, so that one coefficient that is not zero is enough. */
static bool has_settled_coefficient(const ttc_ring *ring, const fmpz_mpoly_t polynomial)
{
    slong *variables = calloc(ring->variable_count + 1, sizeof *variables);
    ulong *exponents = calloc(ring->variable_count + 1, sizeof *exponents);
    bool settled = false;
    fmpz_mpoly_t coefficient;
    fmpz_mpoly_init(coefficient, ring->context);
    const slong terms = variables != NULL && exponents != NULL ? fmpz_mpoly_length(polynomial, ring->context) : 0;
    for (slong i = 0; i < terms && !settled; i++) {
        usage u;
        coefficient_of(ring, coefficient, polynomial, i, variables, exponents);
        settled = survey(&u, ring, coefficient) && (decides(&u) || is_simple(ring, &u, coefficient));
    }
    fmpz_mpoly_clear(coefficient, ring->context);
    free(exponents);
    free(variables);
    return settled;
}

bool ttc_ring_settles(const ttc_ring *ring, const fmpz_mpoly_t polynomial)
{
    usage u;
    bool plain = true;
    for (size_t v = 0; plain && v < ring->variable_count; v++) plain = ring->trust[v] == TTC_TRUST_FREE;
    if (plain) return true;
    if (!survey(&u, ring, polynomial)) return false;
    if (decides(&u)) return true;
    return !u.doubtful && !u.nested && !u.generators && has_settled_coefficient(ring, polynomial);
}

bool ttc_ring_settles_all(const ttc_ring *ring, const ttc_ratio *ratios, size_t count)
{
    bool settled = true;
    fmpz_mpoly_t sum, variable;
    fmpz_mpoly_init(sum, ring->context);
    fmpz_mpoly_init(variable, ring->context);
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        bool used = false;
        for (size_t i = 0; i < count && !used; i++) used = ttc_ratio_uses(ring, ratios + i, v);
        fmpz_mpoly_gen(variable, v, ring->context);
        if (used) fmpz_mpoly_add(sum, sum, variable, ring->context);
    }
    usage u;
    settled = survey(&u, ring, sum) && !u.doubtful && decides(&u);
    fmpz_mpoly_clear(variable, ring->context);
    fmpz_mpoly_clear(sum, ring->context);
    return settled;
}

bool ttc_ring_is_constant(const ttc_ring *ring, const fmpz_mpoly_t polynomial)
{
    usage u;
    return survey(&u, ring, polynomial) && u.count[TTC_TRUST_FREE] == 0 && !u.doubtful;
}

bool ttc_ring_is_free(const ttc_ring *ring, const fmpz_mpoly_t polynomial)
{
    usage u;
    return survey(&u, ring, polynomial) && u.count[TTC_TRUST_ALGEBRAIC] + u.count[TTC_TRUST_SINGLE] + u.count[TTC_TRUST_NONE] == 0;
}
