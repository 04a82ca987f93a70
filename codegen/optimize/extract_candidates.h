/** The candidates for extraction, in two indices: pairs of factors that occur in several cubes, and pairs of terms that occur, up
 *  to a common factor, in one or several sums. A cube is retracted before it changes and renewed afterwards; candidates of other
 *  cubes stay. When memory is out, workspace->failed is set. */
#ifndef TTC_EXTRACT_CANDIDATES_H
#define TTC_EXTRACT_CANDIDATES_H

#include "optimize/extract_binomial.h"
#include "optimize/extract_index.h"
#include "optimize/workspace.h"

#define TTC_SCALE_FACTOR UINT32_C(0x80000000) /* marks a scale among factors; the rest is its graph id */

/* The sum that defines a variable. Its cubes keep their positions: a removed cube has sign 0. */
typedef struct {
    size_t base;     /* index of its first cube in `cubes` */
    uint32_t window; /* each term is compared with so many after it */
} ttc_candidate_sum;

typedef struct {
    uint32_t places;  /* head of its list of places, see ttc_extract_index_add */
    bool is_changed;  /* its places are removed until ttc_candidates_renew */
} ttc_candidate_cube;

/* A cube that contains a factor, or once did. */
typedef struct {
    uint32_t variable, position, next; /* next: 1 + index of the next such cube; 0: none */
} ttc_occurrence;

typedef struct {
    uint32_t variable, position;
} ttc_cube_name;

/* All but workspace is zeroed before first use. */
typedef struct {
    ttc_workspace *workspace;
    ttc_scale_ratios own_ratios;
    ttc_extract_index pairs, binomials; /* keys of pairs: one factor in the upper half, the other in the lower */
    ttc_candidate_sum *sums;            /* by variable */
    ttc_candidate_cube *cubes;
    uint32_t *first_occurrence;         /* by variable: 1 + index; 0: none */
    ttc_occurrence *occurrences;
    ttc_cube_name *changed;
    size_t sum_count, sum_capacity, cube_count, cube_capacity, factor_capacity, occurrence_count, occurrence_capacity;
    size_t changed_count, changed_capacity;
} ttc_candidates;

void ttc_candidates_clear(ttc_candidates *candidates);

ttc_polynomial *ttc_candidates_definition(const ttc_candidates *candidates, uint32_t variable);

/* Register a variable's sum, with all cubes changed. Each term is compared with `window` terms after it. */
void ttc_candidates_enroll(ttc_candidates *candidates, uint32_t variable, uint32_t window);

/* Record that a cube contains a factor; or all factors of all cubes of a sum. */
void ttc_candidates_note_factor(ttc_candidates *candidates, uint32_t factor, uint32_t variable, uint32_t position);
void ttc_candidates_note_factors(ttc_candidates *candidates, uint32_t variable);

/* Remove the candidates of a cube; call it before the cube changes. */
void ttc_candidates_retract(ttc_candidates *candidates, uint32_t variable, uint32_t position);
bool ttc_candidates_is_changed(const ttc_candidates *candidates, uint32_t variable, uint32_t position);

/* Add the candidates of all changed cubes, and rank both indices. */
void ttc_candidates_renew(ttc_candidates *candidates);

/* ttc_binomial_of two cubes, with the workspace's ratios of scales, or else with own_ratios. */
bool ttc_candidates_binomial(ttc_candidates *candidates, ttc_binomial *out, const ttc_cube *a, const ttc_cube *b);

#endif
