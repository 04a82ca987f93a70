/** Numbers of an equilibrium as decimals of any length. */
#ifndef JLT_EXT_BALL_TEXTS_H
#define JLT_EXT_BALL_TEXTS_H

#include <stddef.h>

enum { JLT_BALL_TEXTS_DIGITS_MAX = 1000 };

/* Each with as many digits as were asked for, or fewer where the last are zeros, to the nearest. */
typedef struct {
    long digits;
    size_t params, n;
    char **param, **state, **jacobian, **charpoly, *trace; /* shapes (params,), (n,), (n, n), (n + 1,) */
    char **re, **im;                                       /* of all eigenvalues, zeros first, shape (n,) */
} jlt_ball_texts;

void jlt_ball_texts_destroy(jlt_ball_texts *texts); /* legal on NULL */

#endif
