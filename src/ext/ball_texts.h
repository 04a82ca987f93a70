/** The numbers of an equilibrium as decimal texts of any length. */
#ifndef JLT_EXT_BALL_TEXTS_H
#define JLT_EXT_BALL_TEXTS_H

#include <stddef.h>

enum { JLT_BALL_TEXTS_DIGITS_MAX = 1000 };

/* Each text is rounded to nearest with `digits` significant digits; trailing zeros are omitted. */
typedef struct {
    long digits;
    size_t params, n;
    char **param, **state, **jacobian, **charpoly, *trace; /* shapes (params,), (n,), (n, n), (n + 1,) */
    char **re, **im;                                       /* all eigenvalues, the zero ones first, shape (n,) */
} jlt_ball_texts;

void jlt_ball_texts_destroy(jlt_ball_texts *texts); /* legal on NULL */

#endif
