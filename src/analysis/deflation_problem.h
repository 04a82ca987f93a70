/** Shared by the files deflation*.c: the scaled problem, and a choice of pivots with the block B that it leaves. */
#ifndef JLT_ANALYSIS_DEFLATION_PROBLEM_H
#define JLT_ANALYSIS_DEFLATION_PROBLEM_H

#include "analysis/deflation.h"

#include <stdbool.h>

enum { JLT_DEFLATION_SQUARE_MAX = JLT_DEFLATION_SIZE_MAX * JLT_DEFLATION_SIZE_MAX };

/* The problem, scaled by a power of two so that the largest entry of a is near one. */
typedef struct {
    size_t n, rank;
    double a[JLT_DEFLATION_SQUARE_MAX], error[JLT_DEFLATION_SQUARE_MAX];
    double w[JLT_DEFLATION_SQUARE_MAX]; /* independent gradients, rows scaled near one, shape (rank, n) */
    double w_error[JLT_DEFLATION_SQUARE_MAX];
    double columns[JLT_DEFLATION_SIZE_MAX]; /* (n,): largest |entry| of each column of the row-scaled gradients */
    int row[JLT_DEFLATION_SIZE_MAX];        /* (rank,): index of the caller's gradient that each row of w comes from */
    int exponent;                           /* the caller's matrix is 2^exponent a */
} jlt_deflation_problem;

typedef struct {
    size_t pivots[JLT_DEFLATION_SIZE_MAX], others[JLT_DEFLATION_SIZE_MAX]; /* p and f of deflation.h, (rank,) and (n - rank,) */
    double follow[JLT_DEFLATION_SQUARE_MAX], follow_error[JLT_DEFLATION_SQUARE_MAX]; /* W_p^(-1) W_f, shape (rank, n - rank) */
    double inverse[JLT_DEFLATION_SQUARE_MAX]; /* W_p^(-1), shape (rank, rank) */
    double block[JLT_DEFLATION_SQUARE_MAX], error[JLT_DEFLATION_SQUARE_MAX]; /* B and its error bound, (n - rank, n - rank) */
    double merit; /* largest error that elimination adds to an entry of B, relative to the largest entry of B */
} jlt_deflation_choice;

/** Scale the problem, and keep the independent gradients. In/out: problem, zeroed by the caller. Other arguments and defaults as
 *  in jlt_deflation_compute. Errors: NONFINITE. */
JLT_CHECKED jlt_status jlt_deflation_problem_set(jlt_deflation_problem *problem, const double *a, const double *error,
                                                 size_t n, const double *gradients, const double *gradient_error,
                                                 size_t count);

/* The largest |W A| / (|W| |A|), entry by entry. */
double jlt_deflation_problem_defect(const jlt_deflation_problem *problem);

/* Bounds on the rank of all matrices within the errors of a, by elimination with complete pivoting; *most is n if errors leave
 * open whether the remainder is zero. */
void jlt_deflation_problem_rank(size_t *least, size_t *most, const jlt_deflation_problem *problem);

/** Find the choice of pivots that adds the least rounding error to B. Returns false if none is usable.
 *  Cost: choose(n, rank) eliminations. */
bool jlt_deflation_problem_choose(jlt_deflation_choice *best, const jlt_deflation_problem *problem);

#endif
