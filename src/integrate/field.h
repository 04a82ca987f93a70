/** What is integrated: an autonomous field dx/dtau = f(x), its time, and what is known of it. Plain data; nothing is owned.
 *
 *  A field in a time of its own (dt = factor(x) dtau) carries the physical time t as a quadrature: the integrator keeps it
 *  as one more component after the states, with the same order and in the same error control. */
#ifndef JLT_INTEGRATE_FIELD_H
#define JLT_INTEGRATE_FIELD_H

#include "core/status.h"
#include "kernel_abi.h"

/* The largest field is that of 128 states with their derivatives by as many coordinates, and an integral. */
enum { JLT_FIELD_DIM_MAX = 128 * 128 + 1, JLT_JACOBIAN_DIM_MAX = 32 };

typedef struct {
    unsigned dim;                  /* 1 .. JLT_FIELD_DIM_MAX */
    jlt_kernel_function call;      /* x (dim,), p -> dx/dtau (dim,) */
    const double *p;               /* passed through: a prepared block, or a structure aligned for double, cast */
    jlt_kernel_function time_rate; /* x, p -> dt/dtau > 0 (1,); NULL: tau is t */
    jlt_kernel_function jacobian;  /* x, p -> df/dx (dim, dim); NULL where not known */
    jlt_kernel_jet jet;            /* NULL where not known; the method taylor needs it */
    const jlt_kernel_batch *batch; /* the same field on vectors, for the method gauss; NULL where not known */
    unsigned controlled;           /* leading states in the error norm; 0: all of them */
    int root;                      /* the lifted root whose zero is the pole, as an index into x; -1: none */
    const jlt_quantity *domain;    /* (dim,), the open intervals the states must stay in; NULL: not watched */
    const double *scale;           /* (dim,), >= 0, the size below which a state counts as small: its error is measured
                                      against max(|x_i|, scale_i). NULL: 1, and 0 for the root, whose error is relative */
} jlt_field;

/** How near a state may come to a finite bound of its domain, relative to the bound: nearer, fewer than 16 bits of the distance
 *  are left, and the field, which divides by its root, is worth nothing. */
#define JLT_FIELD_NEAREST 0x1p-37

/** The field of a generated kernel. In the model's own time its domain is watched; a lifted root does without. p: its prepared
 *  block, kept by the caller as long as the field is in use.
 *  The last state is taken for the pole's root when the kernel has a time of its own and that state is bounded by 0 below.
 *  Errors: UNSUPPORTED, the descriptor has no right-hand side. */
JLT_CHECKED jlt_status jlt_field_of(jlt_field *out, const jlt_descriptor *descriptor, const double *p);

#endif
