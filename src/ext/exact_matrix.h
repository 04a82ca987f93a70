/** An equilibrium's linearization in exact numbers: characteristic polynomial, its zeros, its factors that tell how often an
 *  eigenvalue is multiple, and whether it has as many eigenvectors. */
#ifndef JLT_EXT_EXACT_MATRIX_H
#define JLT_EXT_EXACT_MATRIX_H

#include "ext/exact_poly.h"

enum { JLT_EXACT_FACTORS_MAX = 16 };

/* A monic factor of the characteristic polynomial without the root 0. */
typedef struct {
    jlt_exact_poly poly;
    size_t multiplicity; /* of its roots in the characteristic polynomial */
    bool even;           /* poly(-x) = poly(x); where it is not, and the matrix is split, no root lies on the imaginary axis */
    bool semisimple;     /* its roots have as many eigenvectors as they are often roots */
} jlt_exact_factor;

typedef struct jlt_exact_matrix {
    size_t n;
    jlt_surd_field *field;
    jlt_surd *point, *entries; /* shapes (n,) and (n, n): the equilibrium, and the Jacobian there; set by the caller */
    jlt_exact_poly charpoly;   /* these from jlt_exact_matrix_analyse on */
    size_t zeros;              /* how often zero is an eigenvalue */
    bool zero_semisimple;
    jlt_exact_factor factors[JLT_EXACT_FACTORS_MAX];
    size_t factor_count;
    bool split; /* factors have no multiple roots and no common ones */
} jlt_exact_matrix;

jlt_exact_matrix *jlt_exact_matrix_create(size_t n); /* NULL when memory is out */
void jlt_exact_matrix_destroy(jlt_exact_matrix *m);  /* legal on NULL */

/** The characteristic polynomial, by reduction to Hessenberg form; zeros; and as the only factor what zeros leave of it.
 *  Cost: n^3 operations. Source: H. Cohen, A Course in Computational Algebraic Number Theory, 1993, 2.2.4. */
void jlt_exact_matrix_analyse(jlt_exact_matrix *m);

/** Factors without multiple roots, each even or without roots on the imaginary axis: such a root z comes with -z, as often.
 *  Cost: greatest common divisors, and for multiple roots powers of the matrix.
 *  Source: D. Y. Y. Yun, On square-free decomposition algorithms, SYMSAC 1976. */
void jlt_exact_matrix_split(jlt_exact_matrix *m);

#endif
