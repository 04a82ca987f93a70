/** Ball arithmetic of equilibria: the linearization at one precision, shared by the files ball_*.c. */
#ifndef JLT_EXT_BALL_PROBLEM_H
#define JLT_EXT_BALL_PROBLEM_H

#include "ext/ball_point.h"
#include "ext/exact_matrix.h"

typedef struct {
    size_t multiplicity;
    bool semisimple;
} jlt_ball_root;

typedef struct {
    const jlt_ball_table *table;
    const jlt_ball_question *question;
    slong n, precision;
    bool last;      /* this is the highest precision: what may be zero is taken as zero */
    bool late;      /* eigenvalues that are not separated yet may be enclosed in clusters */
    bool clustered; /* eigenvalues are enclosed in clusters; no precision would tell how many of them are real */
    bool proved;    /* the point is an equilibrium */
    bool judged;    /* it is known how often zero is an eigenvalue, and whether it is semisimple */
    bool settled;   /* of every real part, the sign is known, or that it is zero */
    arb_ptr params, x;
    arb_mat_t a;
    arb_poly_t charpoly, rest; /* rest: charpoly / x^zeros */
    acb_ptr roots;             /* of rest, shape (count,), repeated by multiplicity, ascending */
    jlt_ball_root kinds[JLT_BALL_SIZE_MAX];
    slong count;
} jlt_ball_problem;

/** Enclose the eigenvalues other than zero. Parts known to be zero are exactly zero in the balls: imaginary parts of real
 *  eigenvalues, and real parts of pairs on the imaginary axis if the polynomial is even.
 *  In/out: *p. Out: expelling, growing and decaying of *s. Returns false if this precision does not separate the eigenvalues; if
 *  p->late, clusters then share balls. Source: S. Miyajima, J. Comput. Appl. Math. 233 (2010) 2994-3004, as implemented in Arb. */
bool jlt_ball_problem_roots(jlt_ball_spectrum *s, jlt_ball_problem *p);

/** Round every number to the nearest double. *sure: in every ball, all numbers round to the same double. Returns false if a number
 *  is outside the range of doubles. */
bool jlt_ball_problem_round(jlt_ball_spectrum *s, bool *sure, const jlt_ball_problem *p);

/** Write every number as a decimal. *sure becomes false if numbers in a ball round differently. Returns NULL if memory is out. */
jlt_ball_texts *jlt_ball_texts_create(bool *sure, const jlt_ball_problem *p);

#endif
