/** What an extraction could take, in two indices: pairs of factors that occur in several cubes, and pairs of terms that occur,
 *  up to a common factor, in one or several sums. A cube that changes is retracted before and renewed after; what concerns
 *  other cubes stays. Memory that is out shows in workspace->failed. */
#ifndef TTC_EXTRACT_CANDIDATES_H
#define TTC_EXTRACT_CANDIDATES_H

#include "optimize/extract_binomial.h"
#include "optimize/extract_index.h"
#include "optimize/workspace.h"

#define TTC_SCALE_FACTOR UINT32_C(0x80000000) /* marks a scale among factors; the rest is its graph id */

/* The sum of a variable. Positions of its cubes stay what they are: a cube that is gone has sign 0. */
typedef struct {
    size_t base;     /* of its cubes among `cubes` */
    uint32_t window; /* a term is compared with so many after it */
} ttc_candidate_sum;

typedef struct {
    uint32_t places;  /* head of the list of places, see ttc_extract_index_add */
    bool is_changed;  /* its places are removed, and come anew when candidates are renewed */
} ttc_candidate_cube;

/* A cube that holds a factor, or held it. */
typedef struct {
    uint32_t variable, position, next; /* next: 1 + index */
} ttc_occurrence;

typedef struct {
    uint32_t variable, position;
} ttc_cube_name;

/* Zeroed before first use, but for workspace. */
typedef struct {
    ttc_workspace *workspace;
    ttc_scale_ratios own_ratios;
    ttc_extract_index pairs, binomials; /* keys of pairs: one factor in the upper half, the other in the lower */
    ttc_candidate_sum *sums;            /* by variable */
    ttc_candidate_cube *cubes;
    uint32_t *first_occurrence;         /* by variable: 1 + index */
    ttc_occurrence *occurrences;
    ttc_cube_name *changed;
    size_t sum_count, sum_capacity, cube_count, cube_capacity, factor_capacity, occurrence_count, occurrence_capacity;
    size_t changed_count, changed_capacity;
} ttc_candidates;

void ttc_candidates_clear(ttc_candidates *candidates);

ttc_polynomial *ttc_candidates_definition(const ttc_candidates *candidates, uint32_t variable);

/* Take a variable's sum in: its cubes count as changed. window: a term is compared with so many after it. */
void ttc_candidates_enroll(ttc_candidates *candidates, uint32_t variable, uint32_t window);

/* A cube holds a factor; the same of all factors of all cubes of a sum. */
void ttc_candidates_note_factor(ttc_candidates *candidates, uint32_t factor, uint32_t variable, uint32_t position);
void ttc_candidates_note_factors(ttc_candidates *candidates, uint32_t variable);

/* To be called before a cube is changed: what it takes part in is no longer there. */
void ttc_candidates_retract(ttc_candidates *candidates, uint32_t variable, uint32_t position);
bool ttc_candidates_is_changed(const ttc_candidates *candidates, uint32_t variable, uint32_t position);

/* What the cubes changed since the last call take part in now; the indices are then ranked. */
void ttc_candidates_renew(ttc_candidates *candidates);

/* The normal form of two terms, see ttc_binomial_of. */
bool ttc_candidates_binomial(ttc_candidates *candidates, ttc_binomial *out, const ttc_cube *a, const ttc_cube *b);

#endif
