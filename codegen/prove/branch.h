/** A branch of a zero level: relations solved one after the other, each for a state, so that the field of the branch can be
 *  built with the solutions in it. */
#ifndef TTC_BRANCH_H
#define TTC_BRANCH_H

#include "prove/prove_task.h"

#include <flint/fmpz_mpoly.h>

enum { TTC_BRANCH_RELATIONS_MAX = 16 };

/* A substitution found by solving: a state equal to an expression, or to a square root of one. */
typedef struct {
    uint32_t symbol;
    ttc_id expression;
    bool square;
} ttc_solution;

/* Begins zeroed. */
typedef struct {
    ttc_solution solutions[2 * TTC_BRANCH_RELATIONS_MAX];
    size_t solution_count, spares;
    size_t relation_count;                      /* solved so far */
    ttc_id leading[TTC_BRANCH_RELATIONS_MAX];   /* coefficients divided by that may vanish somewhere */
    size_t leading_count;
} ttc_branch;

/* Whether an irreducible factor cannot vanish: it is free of states, or a factor of the radicand of a positive root. */
bool ttc_branch_never_zero(ttc_task *task, const fmpz_mpoly_t factor);

/** Add the solution of factor = 0, in the ring of the task's field, for a state in which it is linear or quadratic. False when
 *  there is none, or no room; the branch is then of no use. */
bool ttc_branch_solve(ttc_branch *branch, ttc_task *task, const fmpz_mpoly_t factor);

#endif
