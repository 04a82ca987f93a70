/** Discovery: first integrals, polynomials with a cofactor, invariant densities of a table, looked for and not told.
 *
 *  An ansatz is linear algebra over a prime field (discover/null_space.h says what its rank proves); what solves it is lifted to
 *  the parameters (discover/solution.h), written as a claim in the language of tables, and said only where the host has proved it.
 *  */
#ifndef TTC_DISCOVER_H
#define TTC_DISCOVER_H

#include "discover/search.h"

/** conditions, when: the same, as bindings and as the clause that ends a claim (" when a3 = 0"), or NULL and "".
 *  degree: 1 to 64. memory: bytes that matrices may take. NULL, and *why: the motion is no ratio, for this reason. */
ttc_discovery *ttc_discovery_create(const ttc_model *model, const ttc_bindings *conditions, const char *when, int degree,
                                    size_t memory,
                                    ttc_discovery_host host, const char **why);
void ttc_discovery_destroy(ttc_discovery *d); /* legal on NULL */

/* The value of an expression under the conditions. False: it has none there, or none that could be computed. */
bool ttc_discovery_value(ttc_discovery *d, ttc_ratio *out, ttc_id expression);

/* What the table claims, proved, joins d->integrals or d->densities: products with it are not new. False: it has no value under the
 * conditions, or is an integral that is no polynomial in the quantities, so that nothing follows for products. */
bool ttc_discovery_know(ttc_discovery *d, ttc_knowns *knowns, const char *name, ttc_id expression);

/* False: the largest matrix of the greatest degree, with that many columns, is beyond the memory; too_large has its bytes. Nothing
 * is allocated for it. */
bool ttc_discovery_fits(ttc_discovery *d, size_t *columns);

/* What an ansatz is made of, and up to which degree, as a comment. */
void ttc_discovery_introduce(ttc_discovery *d);

/** Integrals P, or P/denominator, P a polynomial; finds join those that are known. denominator_text: as the claim is to write it;
 *  both NULL: there is none. */
void ttc_discover_integrals(ttc_discovery *d, const ttc_ratio *denominator, const char *denominator_text);

/* Integrals P/Q for each irreducible factor Q of what the rates divide by. */
void ttc_discover_fractions(ttc_discovery *d);

/** Polynomials P with P' = cofactor P, the cofactor a rational function of parameters alone; those of the least degrees with any
 *  cofactor (discover/extactic.h); then products of powers of all factors that are known (these, states, roots, the divisors of the
 *  equations, and `given`) that are integrals or densities. */
void ttc_discover_factors(ttc_discovery *d, const ttc_id *given, size_t given_count);

/* Densities P^(1/k), k = 1, -1, 2, -2, where none is known yet: one at the least degree. */
void ttc_discover_densities(ttc_discovery *d);

/* Shared by the above: a name that the table does not use, the stem with a number, for flint_free. */
char *ttc_discovery_name(ttc_discovery *d, const char *stem);
/* A claim, with lines broken: proved by the host, and said where it is; else told of, and counted. */
bool ttc_discovery_publish(ttc_discovery *d, const char *claim);
/* The halves of that: proved by the host, see there; said. */
bool ttc_discovery_try(ttc_discovery *d, const char *claim, bool *is_smooth);
void ttc_discovery_say(ttc_discovery *d, const char *claim);
/* The density base^(1/power), power 1 or 2, in the same way. */
bool ttc_discovery_publish_density(ttc_discovery *d, const char *base, int power);
/* A comment line. */
TTC_PRINTF(2, 3) void ttc_discovery_remark(ttc_discovery *d, const char *format, ...);

#endif
