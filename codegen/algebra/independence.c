#include "algebra/independence.h"

#include <stdint.h>
#include <stdlib.h>

/* The variables that a polynomial uses, also in squares of generators. */
typedef struct {
    size_t count[TTC_TRUST_MASK + 1]; /* number of variables of each trust */
    bool doubtful; /* a variable is neither free nor a number */
    bool nested;   /* a variable that is not free occurs in squares of generators alone */
    bool generators;
} usage;

static void mark(const ttc_ring *ring, unsigned char *used, const fmpz_mpoly_t polynomial)
{
    for (slong v = 0; v < (slong)ring->variable_count; v++)
        if (fmpz_mpoly_degree_si(polynomial, v, ring->context) > 0) used[v] = 1;
}

/* Fill in a usage, from the last generator to the first, as squares contain only earlier ones. Returns false when memory is out. */
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
        if (!used[v] || ttc_ring_generator(ring, v) != NULL) continue;
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

/* The coefficient, a polynomial in variables that are not free, of this term's monomial in the free variables. */
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

/* Returns true for a product of numbers, none of which is zero, or a linear form in pi and logarithms: neither is zero. */
static bool is_simple(const ttc_ring *ring, const usage *u, const fmpz_mpoly_t coefficient)
{
    if (u->count[TTC_TRUST_NONE] > 0) return false;
    return fmpz_mpoly_length(coefficient, ring->context) == 1
           || (u->count[TTC_TRUST_ALGEBRAIC] == 0 && fmpz_mpoly_total_degree_si(coefficient, ring->context) <= 1);
}

/* Returns true if some coefficient of the polynomial, taken as one in the free variables, is known to be nonzero: free variables
 * are independent over the complex numbers, so that the polynomial is nonzero then. */
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
