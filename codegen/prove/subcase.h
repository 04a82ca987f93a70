/** A subcase of the set that a claim's conditions allow: zero levels solved one after the other, each for a symbol, and those that
 *  are still to be solved. The field of a subcase has the solutions bound in it. */
#ifndef TTC_SUBCASE_H
#define TTC_SUBCASE_H

#include "prove/prove_task.h"

#include <flint/fmpz_mpoly_factor.h>

enum { TTC_SUBCASE_RELATIONS_MAX = 16 };

/* A substitution found by solving: a symbol equal to an expression, or to a square root of one. */
typedef struct {
    uint32_t symbol;
    ttc_id expression;
    bool square;
} ttc_solution;

/* Initially zeroed except for its goals. */
typedef struct {
    ttc_solution solutions[2 * TTC_SUBCASE_RELATIONS_MAX];
    size_t solution_count, spares;                 /* spares: number of spare symbols in use */
    size_t relation_count;                         /* number of levels solved so far */
    bool own_solved;                               /* the invariant's own level is among these */
    bool is_degenerate;                            /* a goal is that a leading coefficient of another level vanishes */
    bool is_orphan;                                /* it may hold all real points of a component whose own leaf was skipped */
    size_t terms_added;                            /* number of levels gained by splitting sums into their terms */
    ttc_id apart;                                  /* zero on the other factors of the own level; TTC_NONE: there are none */
    ttc_id leads[TTC_SUBCASE_RELATIONS_MAX];        /* leading coefficients by which solutions divide, not zero here */
    size_t lead_count;
    ttc_id goals[2 * TTC_SUBCASE_RELATIONS_MAX];    /* expressions that are still to be made zero; the last one is next */
    size_t goal_count;
    ttc_id met[4 * TTC_SUBCASE_RELATIONS_MAX];      /* what is zero here, for some signs of roots: goals, root - its value */
    size_t met_count;
} ttc_subcase;

/* A polynomial of the task's ring as an expression; TTC_NONE if it uses roots that have no symbol. */
ttc_id ttc_subcase_expression(ttc_task *task, const fmpz_mpoly_t polynomial);

/* The product of all factors but number `one`, each once, as an expression; TTC_NONE if there are no others. one = -1: of all. */
ttc_id ttc_subcase_others(ttc_task *task, const fmpz_mpoly_factor_t factors, slong one);

/* An expression with the same zeros, of the same orders: for a factor that is a logarithm its argument less 1, for an exponential
 * less 1 its exponent. */
ttc_id ttc_subcase_without_functions(const ttc_model *model, ttc_id level);

/* level = a polynomial that is zero where a value is. As a rule this is the norm of the value, free of roots, which is zero where
 * some conjugate of the value is, and shows squares that roots hide. The numerator itself is taken if it has roots and can be
 * solved for a state on which no function but roots depends, with a leading coefficient that cannot vanish, and moreover is linear
 * in that state, has more than two roots, or its norm cannot be solved. */
void ttc_subcase_level(ttc_task *task, fmpz_mpoly_t level, const ttc_ratio *value);

/** Restrict the subcase to the present signs of roots whose radicands are squares, and of sines that are plus or minus a root.
 *  Other signs belong to other subcases, in which the last goal may be zero at other points than those found here. */
void ttc_subcase_keep_signs(ttc_subcase *subcase, ttc_task *task);

/** Add the solution of factor = 0, in the ring of the task's field, for a symbol in which it is linear or quadratic: a state, else
 *  a parameter, level or cosine. lead: the leading coefficient as an expression; a number if it cannot vanish. Returns false if
 *  there is no solution or no room for it; the subcase is then invalid. */
bool ttc_subcase_solve(ttc_subcase *subcase, ttc_id *lead, ttc_task *task, const fmpz_mpoly_t factor);

/** Add as goals the terms of a sum that is zero only where all of them are, for claims in which the dimensions of leaves do not
 *  count. Returns false, with nothing done, if it is no such sum, or TTC_NONE. */
bool ttc_subcase_split(ttc_subcase *subcase, ttc_task *task, ttc_id sum);

/** The same for a factor of the last goal: split is the factor as the table writes it in the goal, else the polynomial itself, else
 *  an even power less a rest that is never positive. is_alone: the goal has no other factor. */
bool ttc_subcase_split_factor(ttc_subcase *subcase, ttc_task *task, const fmpz_mpoly_t factor, bool is_alone);

/** Add as goals that each angle of which an expression uses the cosine or sine is a multiple of a quarter turn, where sums of these
 *  have their extreme values. Returns false, and the subcase is invalid, unless there are one to three such angles. */
bool ttc_subcase_add_turns(ttc_subcase *subcase, ttc_task *task, ttc_id expression);

/** Make the field of a subcase, without conditions, the task's field and ring until it is closed. choices: signs of roots whose
 *  radicand is a square, see ttc_ring. Returns false when memory is out. */
bool ttc_subcase_open(ttc_task *task, const ttc_subcase *subcase, unsigned choices);
void ttc_subcase_close(ttc_task *task);

/* Add to the task's conditions that the leading coefficients by which solutions divide are not zero, and that squares are not
 * negative: the root of one may be an element of the field, real or not where its denominator is zero. */
void ttc_subcase_add_conditions(ttc_task *task, const ttc_subcase *subcase);

/* The claim is not settled unless the claims of its `modulo` are proved, under conditions that hold in the present field. */
void ttc_subcase_check_foundations(ttc_task *task);

#endif
