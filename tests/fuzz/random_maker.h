/** The inner interface of random_table.h: a table under construction, and the functions that make its parts. */
#ifndef RANDOM_MAKER_H
#define RANDOM_MAKER_H

#include "fuzz/random_polynomial.h"
#include "fuzz/random_table.h"

enum { MOST_PARAMS = 3, MOST_STATES = 4, FIRST_STATE = MOST_PARAMS };

typedef enum { ANY, POSITIVE, NONNEGATIVE, NONZERO, SIGNS } sign;

typedef struct {
    ttc_random random;
    FILE *out;
    made_table *made;
    size_t params, states;
    sign signs[MOST_PARAMS];
    bool bounded[MOST_STATES];    /* has an interval */
    polynomial field[MOST_STATES];
    polynomial radicand;          /* of the root r, 1 + e^2 */
    polynomial exponent;          /* of the exponential E; the logarithm L is of the radicand */
    bool has_root, has_angle, has_exponential, random_root, has_region;
    const char *names[VARIABLES];
} maker;

uint64_t below(maker *m, uint64_t bound);
bool chance(maker *m, uint64_t in); /* true with probability 1/in */
unsigned param_mask(const maker *m), state_mask(const maker *m), any_mask(const maker *m); /* bit i: variable i */

/* A random polynomial in the variables of the mask: never zero, and constant only if the mask is empty. */
polynomial some(maker *m, unsigned mask, size_t terms, unsigned degree);

/* Write the format, with every %P replaced by the next polynomial of the list, which ends with NULL. */
void write_polynomials(maker *m, const char *format, const polynomial *const *list);

#define WRITE(m, format, ...) write_polynomials((m), (format), (const polynomial *const[]){ __VA_ARGS__, NULL })

/* Begin the record of a claim with a new name: "KIND NAME". If a polynomial has overflowed, its truth becomes CLAIM_OPEN. */
void open_claim(maker *m, const char *kind, claim_truth truth);
const char *last_name(const maker *m);

/* Write the records that define the model. Each make_ function chooses the field, and returns what is known of it. */
void write_declarations(maker *m, size_t states);
void write_definitions(maker *m);
polynomial make_orthogonal(maker *m, bool *constant);
polynomial make_darboux(maker *m, bool integral);
void make_linear(maker *m, polynomial matrix[2][2], polynomial rest[2]);
void write_field(maker *m);

/* Write claims that any model can have. */
void claim_identities(maker *m);
void claim_roots_and_angles(maker *m);
void claim_exponentials(maker *m);
void claim_rates(maker *m);
void claim_signs(maker *m);
void claim_reductions(maker *m, FILE *target); /* writes the target as well */
void claim_towers(maker *m);

/* Write whole tables: pairs that serve in place of each other; a section with the table of its coordinates. */
void write_ways(maker *m, FILE *target);
void write_section(maker *m, FILE *target);

#endif
