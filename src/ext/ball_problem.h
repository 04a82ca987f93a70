/** Inside the ball arithmetic of equilibria: the linearization at one precision. */
#ifndef JLT_EXT_BALL_PROBLEM_H
#define JLT_EXT_BALL_PROBLEM_H

#include "ext/ball_point.h"
#include "ext/exact_matrix.h"

#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_mat.h>
#include <flint/acb_poly.h>
#include <flint/arb_poly.h>
#else
#include <acb_mat.h>
#include <acb_poly.h>
#include <arb_poly.h>
#endif

typedef struct {
    size_t multiplicity;
    bool semisimple;
} jlt_ball_root;

typedef struct {
    const jlt_ball_table *table;
    const jlt_ball_question *question;
    slong n, precision;
    bool last;      /* no higher precision follows: what is open stays so */
    bool late;      /* eigenvalues that are not told apart yet are taken for multiple ones */
    bool clustered; /* eigenvalues were taken as multiple; no precision tells how many are real */
    bool proved;    /* the point is an equilibrium, and zero is as often an eigenvalue as is said, with as many eigenvectors */
    bool settled;   /* the sign of every real part, or that it is zero, is known */
    arb_ptr params, x;
    arb_mat_t a;
    arb_poly_t charpoly, rest; /* rest: what zeros leave of it */
    acb_ptr roots;             /* of rest, shape (count,): multiple ones as often, ascending */
    jlt_ball_root kinds[JLT_BALL_SIZE_MAX];
    slong count;
} jlt_ball_problem;

/** The eigenvalues other than zero. Parts that are exactly zero are so in the balls: imaginary ones of real roots, real ones of
 *  pairs on the imaginary axis, where the polynomial is even.
 *  In/out: *p. Out: growing and decaying of *s. False where this precision does not separate them; a late one then gives
 *  balls that several share. Source: S. Miyajima, J. Comput. Appl. Math. 233 (2010) 2994-3004, as Arb has it. */
bool jlt_ball_problem_roots(jlt_ball_spectrum *s, jlt_ball_problem *p);

/** Every number to its nearest double. *sure: no ball holds two numbers that round apart. False: one is beyond the doubles. */
bool jlt_ball_problem_round(jlt_ball_spectrum *s, bool *sure, const jlt_ball_problem *p);

/** Every number as a decimal. *sure becomes false where a ball holds two numbers that round apart. NULL: memory is out. */
jlt_ball_texts *jlt_ball_texts_create(bool *sure, const jlt_ball_problem *p);

#endif
