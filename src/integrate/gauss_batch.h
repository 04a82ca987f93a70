/** Inner loops of the collocation method gauss: all nodes of a step at once, one instance for each instruction set.
 *
 *  Node values of a column stand in one row of eight, aligned to 64 bytes: entry of column c at node i at [8*c + i]. */
#ifndef JLT_INTEGRATE_GAUSS_BATCH_H
#define JLT_INTEGRATE_GAUSS_BATCH_H

enum { JLT_GAUSS_BATCH_NODES = 8, JLT_GAUSS_SIZE_MAX = 511 };

typedef struct {
    unsigned dim;
    double *origin;         /* (dim,): the state at the start */
    double *inverse_weight; /* (dim or more,): weight that makes a change relative; 0: column ignored */
    double *x, *f;          /* (dim, 8): states at the nodes, and the field there */
} jlt_gauss_nodes;

typedef struct {
    unsigned lanes;
    /* x <- origin + h * (integral to each node of the polynomial through f). Returns the sum of the squares of all changes of
     * x, relative; not finite when one is not. */
    double (*move)(const jlt_gauss_nodes *nodes, double h);
    /* out[c] = sum over j of in[c][j] * table[j], `rows` rows of eight. */
    void (*transform)(double *out, const double *in, const double (*table)[JLT_GAUSS_BATCH_NODES], unsigned rows);
    /* x <- origin + h * (sum over m of power[c][m] a^(m + 1)), a = length * node. */
    void (*follow)(const jlt_gauss_nodes *nodes, const double *power, double h, double length);
    /* between->x <- origin + h * (integral to the points between the nodes of the polynomial through f). */
    void (*enter)(const jlt_gauss_nodes *between, const jlt_gauss_nodes *nodes, double h);
    /* The largest of |the integral over the step, its length being 1, of the slopes less that of the polynomial|, relative, of the
     * columns; before, after, (dim,): the slopes at the ends. */
    double (*missed)(const jlt_gauss_nodes *between, const jlt_gauss_nodes *nodes, const double *before, const double *after);
    /* out (8,): binary logarithms, within 0.05, of the root of the sum over the rows c of (in[c][k] weight[c])^2; -511 or less for
     * all that is below 2^-511, and JLT_GAUSS_SIZE_MAX or more for what is that large, infinite or NaN. */
    void (*sizes)(double *out, const double *in, const double *weight, unsigned rows);
} jlt_gauss_batch;

extern const jlt_gauss_batch jlt_gauss_batch_baseline;
#if defined(JLT_HAVE_X86)
extern const jlt_gauss_batch jlt_gauss_batch_avx2, jlt_gauss_batch_avx512;
#endif

#endif
