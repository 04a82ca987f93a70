/** Kernels in ball arithmetic. Edited in codegen/runtime/; ttc writes copies.
 *
 *  Each evaluates the table's expressions as they stand, without the optimizer, on unprepared parameters, and encloses
 *  every value that its inputs enclose. A table serves all variants of its time and elimination: impose the variant's
 *  substitutions on the parameters first. Outside the domain the enclosures are not finite. `out` may alias nothing. */
#ifndef JLT_KERNEL_BALL_H
#define JLT_KERNEL_BALL_H

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#include <flint/fmpq.h>
#else
#include <arb.h>
#include <flint/fmpq.h>
#endif

typedef void (*jlt_ball_function)(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec);

typedef struct jlt_ball_table {
    const char *model, *time, *elimination; /* "" for the model's own time, for all states */
    unsigned state_count, param_count;
    jlt_ball_function rhs, jacobian, divergence; /* shapes as in the descriptor */
    unsigned integral_count;                     /* all of the table, whatever their condition */
    const char *const *integral;                 /* their names */
    jlt_ball_function integral_values, integral_gradients;
} jlt_ball_table;

/* The exact rational "p/q", rounded outwards. */
void jlt_ball_rational(arb_t out, const char *digits, slong prec);

#endif
