/** Inside the deflation of eigenvalues: the scaled problem, and the choice of pivots with the block it leaves. */
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
    double columns[JLT_DEFLATION_SIZE_MAX]; /* sizes of the gradients' columns */
    int row[JLT_DEFLATION_SIZE_MAX];        /* which gradient each is */
    int exponent;
} jlt_deflation_problem;

typedef struct {
    size_t pivots[JLT_DEFLATION_SIZE_MAX], others[JLT_DEFLATION_SIZE_MAX];
    double follow[JLT_DEFLATION_SQUARE_MAX], follow_error[JLT_DEFLATION_SQUARE_MAX]; /* W_p^(-1) W_f, shape (rank, n - rank) */
    double inverse[JLT_DEFLATION_SQUARE_MAX]; /* W_p^(-1), shape (rank, rank) */
    double block[JLT_DEFLATION_SQUARE_MAX], error[JLT_DEFLATION_SQUARE_MAX];
    double merit; /* largest error that the elimination adds to B, relative to its largest entry */
} jlt_deflation_choice;

/** Scale, and keep the gradients that are independent. Arguments as of jlt_deflation_compute. Errors: NONFINITE. */
JLT_CHECKED jlt_status jlt_deflation_problem_set(jlt_deflation_problem *problem, const double *a, const double *error,
                                                 size_t n, const double *gradients, const double *gradient_error,
                                                 size_t count);

/* The largest |W A| / (|W| |A|), entry by entry. */
double jlt_deflation_problem_defect(const jlt_deflation_problem *problem);

/* Between which bounds the rank of the matrix lies for all that its errors allow, by elimination with complete pivoting. */
void jlt_deflation_problem_rank(size_t *least, size_t *most, const jlt_deflation_problem *problem);

/** Of all choices of pivots the one that adds the least rounding error to B; false when none is usable.
 *  Cost: choose(n, rank) eliminations. */
bool jlt_deflation_problem_choose(jlt_deflation_choice *best, const jlt_deflation_problem *problem);

#endif
