/** An equilibrium and its spectrum in ball arithmetic, from exact values, at rising precision. */
#ifndef JLT_EXT_BALL_SPECTRUM_H
#define JLT_EXT_BALL_SPECTRUM_H

#include "core/status.h"

#include <stddef.h>

enum { JLT_BALL_SIZE_MAX = 16 };

/* A number as it was typed: the fraction "p/q" or "p", or where there is none the double, exactly. */
typedef struct {
    double value;
    const char *fraction; /* borrowed, or NULL */
} jlt_ball_value;

typedef struct {
    const struct jlt_ball_table *table;    /* of the model in its own time (generated/kernel_ball.h); NULL: there is none */
    const jlt_ball_value *params, *states; /* in the model's order */
    const double *reach;                   /* shape (states,): how far from the states the equilibrium may lie */
    const char *const *integrals;          /* names of those that hold at these parameters */
    size_t integral_count;
} jlt_ball_question;

typedef struct {
    double re, im;
    double error;     /* bound on the distance from the exact eigenvalue: its ball and the rounding to doubles */
    double condition; /* |x| |y| / |y^H x| */
} jlt_ball_eigenvalue;

typedef struct {
    long precision;             /* bits that sufficed */
    size_t n, zeros;            /* states; eigenvalues that are zero, those of integrals counted */
    size_t attributed;          /* zeros that independent gradients of integrals force */
    int source[JLT_BALL_SIZE_MAX]; /* the integral of each, its index in the question */
    int rooted;                 /* values are there; 0: zero is defective, and others are multiple */
    jlt_ball_eigenvalue values[JLT_BALL_SIZE_MAX]; /* the others, shape (n - zeros,), ascending in (re, im) */
    double charpoly[JLT_BALL_SIZE_MAX + 1], charpoly_error[JLT_BALL_SIZE_MAX + 1]; /* highest power first */
    double trace, trace_error;
    int growing;   /* an eigenvalue has a positive real part */
    int decaying;  /* there are others than zero, and all of them have negative real parts */
    int defective; /* zero has too few eigenvectors */
} jlt_ball_spectrum;

/** The spectrum at an equilibrium of the model, in its own time.
 *  Signs of real parts, growth at a defective zero and nonzero coefficients are certain at the equilibrium found
 *  (exactly the states given, or one within reach that Newton's method encloses to first order). Zero is said of a real part
 * 
 *  below 2^-100 of its eigenvalue, and of a coefficient of the characteristic polynomial below 2^-1000 of its size; the
 *  coefficients that integrals force to zero are zero.
 *  Out: *spectrum, untouched on failure.
 *  Errors: ARG (more than JLT_BALL_SIZE_MAX states, a bad fraction); UNSUPPORTED (no such table); EMPTY (no equilibrium
 *  within reach); NO_CONVERGENCE (6144 bits do not settle it: multiple eigenvalues); NONFINITE (beyond the doubles).
 *  Cost: a fraction of a millisecond for five states where 192 bits do. Source: Arb, acb_poly_find_roots. */
JLT_CHECKED jlt_status jlt_ball_spectrum_compute(jlt_ball_spectrum *spectrum, const jlt_ball_question *question);

#endif
