/** An equilibrium and its spectrum in ball arithmetic, from exact values, at rising precision. */
#ifndef JLT_EXT_BALL_SPECTRUM_H
#define JLT_EXT_BALL_SPECTRUM_H

#include "core/status.h"
#include "ext/ball_texts.h"

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
    const signed char *const *reversors;   /* that hold at these parameters: what each makes of states, +1 or -1, shape (states,) */
    size_t reversor_count;
    struct jlt_exact_matrix *exact;        /* the equilibrium in exact numbers (ext/exact_matrix.h), split on demand; or NULL */
    long digits;                           /* of texts, JLT_BALL_TEXTS_DIGITS_MAX at most; 0: there are to be none */
} jlt_ball_question;

typedef struct {
    double re, im;
    double error;     /* bound on the distance from the exact eigenvalue: its ball and the rounding to doubles */
    double condition; /* |x| |y| / |y^H x|; of a multiple one INFINITY where it has too few eigenvectors, else NaN */
} jlt_ball_eigenvalue;

typedef struct {
    long precision;             /* bits that sufficed, or the most that were tried */
    size_t n, zeros;            /* states; eigenvalues that are zero, those of integrals counted */
    size_t attributed;          /* zeros that independent gradients of integrals force */
    int counted;                /* zeros are proved to be; 0: those that integrals do not force may be small */
    int source[JLT_BALL_SIZE_MAX]; /* the integral of each, its index in the question */
    int rooted;                 /* values are there; 0: zero is defective, and others are multiple */
    jlt_ball_eigenvalue values[JLT_BALL_SIZE_MAX]; /* the others, shape (n - zeros,), ascending in (re, im) */
    double jacobian[JLT_BALL_SIZE_MAX * JLT_BALL_SIZE_MAX]; /* shape (n, n) */
    double charpoly[JLT_BALL_SIZE_MAX + 1], charpoly_error[JLT_BALL_SIZE_MAX + 1]; /* highest power first */
    double trace, trace_error;
    int growing;   /* an eigenvalue has a positive real part, or a multiple one on the imaginary axis has too few eigenvectors */
    int decaying;  /* there are others than zero, and all of them have negative real parts */
    int defective; /* zero has too few eigenvectors */
    int exists;    /* the equilibrium is proved to be there */
    int proved;    /* so are the flags that decide on stability */
    int sure;      /* every double and decimal is the nearest one */
    jlt_ball_texts *texts; /* for jlt_ball_texts_destroy; NULL where none were asked for */
} jlt_ball_spectrum;

/** The spectrum at an equilibrium of the model, in its own time.
 *  Precision rises until every double is the nearest one to its exact value, and likewise every text, and until the flags are
 *  proved; or to the last, and what then is not known to differ from zero is said to be zero, and not `proved`.
 *  Zero is proved of a number by exact arithmetic; of an eigenvalue by an integral, too; of a real part by a reversor, too, which
 *  makes the characteristic polynomial even or odd where it leaves the equilibrium where it is.
 *  Out: *spectrum, untouched on failure.
 *  Errors: ARG (more than JLT_BALL_SIZE_MAX states, a bad fraction, too many digits); UNSUPPORTED (no such table); EMPTY (no
 *  equilibrium within reach); NO_CONVERGENCE (6144 bits, or eight times what the digits take, do not enclose eigenvalues: defective
 *  ones, without exact numbers); NONFINITE (beyond the doubles); NOMEM.
 *  Cost: a fraction of a millisecond for five states where 192 bits do. Source: Arb, acb_poly_find_roots. */
JLT_CHECKED jlt_status jlt_ball_spectrum_compute(jlt_ball_spectrum *spectrum, const jlt_ball_question *question);

#endif
