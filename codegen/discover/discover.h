/** Discovery: finds first integrals, polynomials with a cofactor, and invariant densities that a table does not claim.
 *
 *  An ansatz is linear algebra over a prime field (discover/null_space.h says what its rank proves). Its solutions are lifted to
 *  functions of the parameters (discover/solution.h), written as claims in the language of tables, and reported only if the host
 *  has proved them. */
#ifndef TTC_DISCOVER_H
#define TTC_DISCOVER_H

#include "discover/search.h"

/** Begin a discovery. conditions and `when` say the same, as bindings and as the clause that ends a claim (" when a3 = 0"); NULL
 *  and "" if there are none. degree: the greatest, 1 to 64. memory: bytes that matrices may take. Returns NULL, and *why, if the
 *  equations of motion cannot be written as ratios or evaluated in a prime field. */
ttc_discovery *ttc_discovery_create(const ttc_model *model, const ttc_bindings *conditions, const char *when, int degree,
                                    size_t memory,
                                    ttc_discovery_host host, const char **why);
void ttc_discovery_destroy(ttc_discovery *d); /* legal on NULL */

/* The value of an expression under the conditions. Returns false if it has none, or if none could be computed. */
bool ttc_discovery_value(ttc_discovery *d, ttc_ratio *out, ttc_id expression);

/* Add a proved claim of the table to knowns, d->integrals or d->densities, so that products with it are not reported as new.
 * Returns false if it has no value under the conditions, or is an integral that is no polynomial in the quantities: then nothing
 * follows for products. */
bool ttc_discovery_know(ttc_discovery *d, ttc_knowns *knowns, const char *name, ttc_id expression);

/* Whether the largest matrix of the greatest degree, with *columns columns, fits in the memory; if not, d->too_large has its bytes.
 * Allocates no matrix. */
bool ttc_discovery_fits(ttc_discovery *d, size_t *columns);

/* Remark which quantities the polynomials of an ansatz are made of. */
void ttc_discovery_introduce(ttc_discovery *d);

/** Find integrals P, or P/denominator, with P a polynomial, and add them to d->integrals. denominator_text: how claims write the
 *  denominator; both NULL: there is none. */
void ttc_discover_integrals(ttc_discovery *d, const ttc_ratio *denominator, const char *denominator_text);

/* Find integrals P/Q for each irreducible factor Q of the denominators of the rates. */
void ttc_discover_fractions(ttc_discovery *d);

/** Find polynomials P with P' = cofactor P, the cofactor a rational function of parameters alone; those of low degree with any
 *  cofactor (discover/extactic.h); then integrals and densities that are products of powers of all known factors: these, states,
 *  roots, the divisors of the equations, and `given`. */
void ttc_discover_factors(ttc_discovery *d, const ttc_id *given, size_t given_count);

/* Find a density P^(1/k), k = 1, -1, 2, -2, of the least degree, if none is known yet. */
void ttc_discover_densities(ttc_discovery *d);

/* The functions below serve those above. A name that the table does not use: the stem with a number; release it by flint_free. */
char *ttc_discovery_name(ttc_discovery *d, const char *stem);
/* Let the host prove a claim; report it if it is proved, else complain of it and count it. Returns whether it is proved. */
bool ttc_discovery_publish(ttc_discovery *d, const char *claim);
/* The two halves of this: let the host prove a claim, see ttc_discovery_host; report it. */
bool ttc_discovery_try(ttc_discovery *d, const char *claim, bool *is_smooth);
void ttc_discovery_say(ttc_discovery *d, const char *claim);
/* Publish the density base^(1/power), power 1 or 2, or that of -base. Returns whether it is proved. */
bool ttc_discovery_publish_density(ttc_discovery *d, const char *base, int power);
/* Report a comment line. */
TTC_PRINTF(2, 3) void ttc_discovery_remark(ttc_discovery *d, const char *format, ...);

#endif
