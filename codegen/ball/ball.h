/** Encloses expressions of a model in ball arithmetic, or evaluates them exactly, at rational values of its symbols.
 *
 *  An oracle for everything that computes in doubles: it shares the expression graph with the kernels, and no later stage. It also
 *  estimates the error of plain double arithmetic on the expression as written: the radius that 53-bit balls grow to, which is a
 *  running error analysis.
 *  Source: F. Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic, IEEE TC 66(8), 2017;
 *  N. J. Higham, Accuracy and Stability of Numerical Algorithms, 3.3. */
#ifndef TTC_BALL_H
#define TTC_BALL_H

#include "read/model.h"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

typedef struct ttc_ball ttc_ball;

typedef struct {
    double value, rest; /* the enclosure's midpoint is value + rest to 106 bits, value being its nearest double */
    double radius;      /* of the enclosure around value + rest */
    /* only ttc_ball_estimate sets these two */
    double rounding;    /* radius in 53-bit balls, with radicands in full precision: kernels factor these */
    double plain_rounding; /* radius in 53-bit balls throughout, with radicands as written and a rounding of every symbol's value:
                            * for arithmetic that multiplies products out and rounds each */
} ttc_enclosure;

/* model: borrowed; its graph may grow in the meantime. Returns NULL when memory is out. */
ttc_ball *ttc_ball_create(const ttc_model *model);
void ttc_ball_destroy(ttc_ball *ball); /* legal on NULL */

/* Give a parameter, state or level its value: a finite double, taken exactly, or a fraction "p/q" or "p".
 * Returns false when it is neither. */
bool ttc_ball_set(ttc_ball *ball, uint32_t symbol, double value);
bool ttc_ball_set_fraction(ttc_ball *ball, uint32_t symbol, const char *fraction);

/* The same with a ball, which is copied, and not rounded to the precision in use. It has no exact value. */
void ttc_ball_set_ball(ttc_ball *ball, uint32_t symbol, const arb_t value);

/* Let a symbol stand for an expression, as in a `when` clause or on a family of equilibria: it is then enclosed, never
 * rounded on the way. A symbol that stands for itself has no value. */
void ttc_ball_bind(ttc_ball *ball, uint32_t symbol, ttc_id id);

/** Enclose an expression. Starts with 256 bits and doubles them, up to 2048, until the radius is below 2^-100 of the value or the
 *  value is zero. Returns false, with *out unchanged, when a symbol has no value, or no finite enclosure exists (a pole, the root
 *  of a negative number). Values beyond the doubles give infinities. Cost: one visit a node, remembered until a value changes. */
bool ttc_ball_enclose(ttc_enclosure *out, ttc_ball *ball, ttc_id id);

/** Enclose an expression with 256 bits, also one that is far from thin, as over an interval. Returns false in the same cases. */
bool ttc_ball_value(arb_t out, ttc_ball *ball, ttc_id id);

/** 1 or -1, the sign of all numbers of that enclosure, however large or small; 0 where there is none, or zero is one of them. */
int ttc_ball_sign(ttc_ball *ball, ttc_id id);

/** ttc_ball_enclose with the rounding errors to expect in doubles, at three times the cost. */
bool ttc_ball_estimate(ttc_enclosure *out, ttc_ball *ball, ttc_id id);

/** Exact sign (-1, 0, 1), in rational arithmetic. Returns false when a root on the way is irrational, another function or pi is
 *  met, a symbol has no value, or a denominator vanishes. */
bool ttc_ball_exact_sign(int *sign, ttc_ball *ball, ttc_id id);

/* The exact value as a fraction, for the caller to free(); NULL where there is none, as above. */
char *ttc_ball_exact_text(ttc_ball *ball, ttc_id id);

/** The enclosure as decimal text, "[midpoint +/- radius]" with `digits` digits, for the caller to free(), and whether it excludes
 *  zero. NULL where there is none. */
char *ttc_ball_text(ttc_ball *ball, ttc_id id, long digits, bool *excludes_zero);

#endif
