/** Inner loops of the collocation method gauss: all nodes of a step at once, one instance for each instruction set.
 *
 *  Node values of a column stand in one row of eight, aligned to 64 bytes: entry of column c at node i at [8*c + i]. */
#ifndef JLT_INTEGRATE_GAUSS_BATCH_H
#define JLT_INTEGRATE_GAUSS_BATCH_H

#include "kernel_abi.h"

enum { JLT_GAUSS_BATCH_NODES = 8 };

typedef struct {
    const jlt_kernel_batch *kernels; /* NULL: the scalar ones, node by node */
    jlt_kernel_function call, time_rate;
    const double *p;
    unsigned dim;
    const double *origin;         /* (dim,): the state at the start */
    const double *inverse_weight; /* (dim or more,): what a change is multiplied by to be relative; 0: not looked at */
    double *x, *f;                /* (dim, 8) and (dim + 1, 8): states at the nodes, and the field there; f[dim] is dt/dtau */
    double *scratch;              /* (2 dim,): without batched kernels */
} jlt_gauss_nodes;

typedef struct {
    unsigned lanes;
    /* One sweep: x <- origin + h * (integral to each node of the polynomial through f), f <- field at x.
     * Returns the sum of the squares of all changes of x, relative; not finite when one is not. */
    double (*sweep)(const jlt_gauss_nodes *nodes, double h);
    /* f[dim] from the states at the nodes. */
    void (*clock)(const jlt_gauss_nodes *nodes);
    /* out[c] = sum over j of in[c][j] * table[j], `rows` rows of eight. */
    void (*transform)(double *out, const double *in, const double (*table)[JLT_GAUSS_BATCH_NODES], unsigned rows);
    /* The polynomials with these Legendre coefficients on [0, 1], `rows` rows of eight, at the nodes of
     * [from, from + length]. */
    void (*continue_at)(double *out, const double *legendre, double from, double length, unsigned rows);
    /* out (8,): the largest |in[c][k]| weight[c] over the rows c; NaN is passed over. */
    void (*sizes)(double *out, const double *in, const double *weight, unsigned rows);
} jlt_gauss_batch;

extern const jlt_gauss_batch jlt_gauss_batch_baseline;
#if defined(JLT_HAVE_X86)
extern const jlt_gauss_batch jlt_gauss_batch_avx2, jlt_gauss_batch_avx512;
#endif

#endif
