/** Encloses an equilibrium and its spectrum in ball arithmetic, from exact values, at increasing precision. */
#ifndef JLT_EXT_BALL_SPECTRUM_H
#define JLT_EXT_BALL_SPECTRUM_H

#include "core/status.h"
#include "ext/ball_texts.h"

#include <stddef.h>

enum { JLT_BALL_SIZE_MAX = 32 };

/* An exact input: the fraction "p/q" or "p", or if there is none, the double as it is. */
typedef struct {
    double value;
    const char *fraction; /* borrowed, or NULL */
} jlt_ball_value;

typedef struct {
    const struct jlt_ball_table *table;    /* of the model in its own time (generated/kernel_ball.h); NULL if there is none */
    const jlt_ball_value *params, *states; /* in the model's order */
    const double *reach;                   /* shape (states,): how far from the states the equilibrium may lie */
    const char *const *integrals;          /* names of the integrals that hold at these parameters */
    size_t integral_count;
    const signed char *const *reversors;   /* of each that holds: the signs of the states, +1 or -1, shape (states,) */
    size_t reversor_count;
    struct jlt_exact_matrix *exact;        /* the matrix in exact numbers, factored on demand (ext/exact_matrix.h); or NULL */
    long digits;                           /* decimal digits of the texts, at most JLT_BALL_TEXTS_DIGITS_MAX; 0: no texts */
} jlt_ball_question;

typedef struct {
    double re, im;
    double error;     /* bound on the distance from the exact eigenvalue: radius of its ball plus rounding to doubles */
    double condition; /* |x| |y| / |y^H x|; of a multiple eigenvalue INFINITY if it is defective, else NaN */
} jlt_ball_eigenvalue;

typedef struct {
    long precision;             /* bits that sufficed, or the most that were tried */
    size_t n, zeros;            /* number of states; number of eigenvalues that are zero, including those that integrals force */
    size_t attributed;          /* number of zeros that independent gradients of integrals force */
    int counted;                /* 1: all zeros are proved; 0: those that integrals do not force may be small instead */
    int source[JLT_BALL_SIZE_MAX]; /* shape (attributed,): index in the question of the integral that forces each */
    int rooted;                 /* 1: `values` are computed; 0: they are not separated, and zero is defective */
    jlt_ball_eigenvalue values[JLT_BALL_SIZE_MAX]; /* the nonzero eigenvalues, shape (n - zeros,), ascending in (re, im) */
    double jacobian[JLT_BALL_SIZE_MAX * JLT_BALL_SIZE_MAX]; /* shape (n, n) */
    double charpoly[JLT_BALL_SIZE_MAX + 1], charpoly_error[JLT_BALL_SIZE_MAX + 1]; /* highest power first */
    double trace, trace_error;
    int expelling; /* an eigenvalue has a positive real part */
    int growing;   /* it has, or a multiple one on the imaginary axis is defective */
    int decaying;  /* there are nonzero eigenvalues, and all of them have negative real parts */
    int defective; /* the eigenvalue zero is defective */
    int exists;    /* the equilibrium is proved to exist */
    int proved;    /* the flags that decide on stability are proved */
    int sure;      /* every double and every decimal is the nearest to the exact number */
    jlt_ball_texts *texts; /* to be destroyed with jlt_ball_texts_destroy; NULL if no digits were asked for */
} jlt_ball_spectrum;

/** Compute the spectrum at an equilibrium of the model, in its own time.
 *  The precision rises until every double and every text is the nearest to its exact value, and the flags are proved. At the last
 *  precision, what is not known to differ from zero is taken as zero, and is not `proved`.
 *  That a number is zero is proved by exact arithmetic; that an eigenvalue is zero, also by an integral, or by where the matrix
 *  is zero; that a real part is zero, also by a reversor that fixes the equilibrium, since the characteristic polynomial is then
 *  even or odd.
 *  Out: *spectrum, untouched on failure.
 *  Errors: ARG (more than JLT_BALL_SIZE_MAX states, a malformed fraction, too many digits); UNSUPPORTED (no such table); EMPTY (no
 *  equilibrium within reach); NO_CONVERGENCE (the highest precision, 6144 bits or eight times what the digits need, does not
 *  enclose the eigenvalues, as happens for defective ones without exact numbers); NONFINITE (outside the range of doubles); NOMEM.
 *  Cost: a fraction of a millisecond for five states if 192 bits suffice. Source: Arb, acb_poly_find_roots. */
JLT_CHECKED jlt_status jlt_ball_spectrum_compute(jlt_ball_spectrum *spectrum, const jlt_ball_question *question);

#endif
