/** A subcase of what a claim's conditions allow: relations solved one after the other, each for a symbol, and those still to
 *  be met, so that the field of the subcase can be built with the solutions in it. */
#ifndef TTC_SUBCASE_H
#define TTC_SUBCASE_H

#include "prove/prove_task.h"

#include <flint/fmpz_mpoly.h>

enum { TTC_SUBCASE_RELATIONS_MAX = 16 };

/* A substitution found by solving: a symbol equal to an expression, or to a square root of one. */
typedef struct {
    uint32_t symbol;
    ttc_id expression;
    bool square;
} ttc_solution;

/* Begins zeroed but for its goals. */
typedef struct {
    ttc_solution solutions[2 * TTC_SUBCASE_RELATIONS_MAX];
    size_t solution_count, spares;
    size_t relation_count;                         /* solved so far */
    bool own_solved;                               /* some of them for the invariant's own level */
    bool is_degenerate;                            /* one of them says that what another would divide by vanishes */
    bool is_orphan;                                /* and where it does not vanish, the level has no real points */
    ttc_id apart;                                  /* zero on the other factors of the own level; TTC_NONE: there are none */
    ttc_id leads[TTC_SUBCASE_RELATIONS_MAX];        /* what solutions divide by, not zero here */
    size_t lead_count;
    ttc_id goals[2 * TTC_SUBCASE_RELATIONS_MAX];    /* expressions that are still to be made zero; the last one is next */
    size_t goal_count;
    ttc_id met[4 * TTC_SUBCASE_RELATIONS_MAX];      /* goals that are zero now, for some signs of roots */
    size_t met_count;
} ttc_subcase;

/* A polynomial of the task's ring as an expression; TTC_NONE where it uses roots that have no name. */
ttc_id ttc_subcase_expression(ttc_task *task, const fmpz_mpoly_t polynomial);

/** Add the solution of factor = 0, in the ring of the task's field, for a state or parameter in which it is linear or quadratic.
 *  lead: what the solution divides by, as an expression; it is a number where the solution divides by one.
 *  False when there is none, or no room; the subcase is then of no use. */
bool ttc_subcase_solve(ttc_subcase *subcase, ttc_id *lead, ttc_task *task, const fmpz_mpoly_t factor);

/** Make the field of a subcase, with these signs of the roots that become rational, and no conditions yet: the task's field and
 *  ring until it is closed. False when memory is out. */
bool ttc_subcase_open(ttc_task *task, const ttc_subcase *subcase, unsigned choices);
void ttc_subcase_close(ttc_task *task);

/* What solutions divide by is not zero: to the conditions of the task. */
void ttc_subcase_add_leads(ttc_task *task, const ttc_subcase *subcase);

/* What a claim rests on through `modulo` must be proved, under conditions that hold in the field at hand. */
void ttc_subcase_check_foundations(ttc_task *task);

#endif
