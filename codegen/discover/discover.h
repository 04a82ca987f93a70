/** Discovery: finds first integrals, polynomials with a cofactor, and invariant densities that a table does not claim.
 *
 *  An ansatz is linear algebra over a prime field (discover/null_space.h says what its rank proves). Solutions are lifted to
 *  functions of the parameters (discover/solution.h), written as claims, and reported only if the host has proved them. */
#ifndef TTC_DISCOVER_H
#define TTC_DISCOVER_H

#include "discover/search.h"

/** Begin a discovery. conditions and `when` say the same, as bindings and as the clause that ends a claim (" when a3 = 0"); NULL
 *  and "": none. degree: the greatest, 1 to 64. memory: bytes that matrices may take. Returns NULL, and *why, if the equations of
 *  motion are no ratios, or have no points in a prime field. */
ttc_discovery *ttc_discovery_create(const ttc_model *model, const ttc_bindings *conditions, const char *when, int degree,
                                    size_t memory,
                                    ttc_discovery_host host, const char **why);
void ttc_discovery_destroy(ttc_discovery *d); /* legal on NULL */

/* The value of an expression under the conditions. Returns false if there is none, or none was computed. */
bool ttc_discovery_value(ttc_discovery *d, ttc_ratio *out, ttc_id expression);

/* Add a proved claim of the table to d->integrals or d->densities: products with it are not new. Returns false if it has no value
 * under the conditions, or is an integral that is no polynomial in the quantities, so that nothing follows for products. */
bool ttc_discovery_know(ttc_discovery *d, ttc_knowns *knowns, const char *name, ttc_id expression);

/* Whether the largest matrix, with *columns columns, fits in the memory; else d->too_large has its bytes. Allocates none. */
bool ttc_discovery_fits(ttc_discovery *d, size_t *columns);

/* Remark what the polynomials of an ansatz are made of. */
void ttc_discovery_introduce(ttc_discovery *d);

/** Find integrals P, or P/denominator, with polynomials P, and add them to d->integrals. denominator_text: as claims write it;
 *  both NULL: there is none. */
void ttc_discover_integrals(ttc_discovery *d, const ttc_ratio *denominator, const char *denominator_text);

/* Find integrals P/Q for each irreducible factor Q of the rates' denominators. */
void ttc_discover_fractions(ttc_discovery *d);

/** Find polynomials P with P' = cofactor P, the cofactor a rational function of parameters alone; those of low degree with any
 *  cofactor (discover/extactic.h); then integrals and densities that are products of powers of all known factors (these, states,
 *  roots, the divisors of the equations, and `given`). */
void ttc_discover_factors(ttc_discovery *d, const ttc_id *given, size_t given_count);

/* Find a density P^(1/k), k = 1, -1, 2, -2, of least degree, if none is known. */
void ttc_discover_densities(ttc_discovery *d);

/* For the functions above: a name that the table does not use, the stem with a number, for flint_free. */
char *ttc_discovery_name(ttc_discovery *d, const char *stem);
/* Report a claim if the host proves it; else complain, and count it. Returns whether it is proved. */
bool ttc_discovery_publish(ttc_discovery *d, const char *claim);
/* The two halves of this: let the host prove a claim, see ttc_discovery_host; report it. */
bool ttc_discovery_try(ttc_discovery *d, const char *claim, bool *is_smooth);
void ttc_discovery_say(ttc_discovery *d, const char *claim);
/* The same for the density base^(1/power), power 1 or 2, or for that of -base. */
bool ttc_discovery_publish_density(ttc_discovery *d, const char *base, int power);
/* Report a comment line. */
TTC_PRINTF(2, 3) void ttc_discovery_remark(ttc_discovery *d, const char *format, ...);

#endif
