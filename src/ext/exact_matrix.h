/** The linearization at an equilibrium in exact numbers: the characteristic polynomial, the multiplicity of its root zero, its
 *  factors by multiplicity, and whether eigenvalues are semisimple. */
#ifndef JLT_EXT_EXACT_MATRIX_H
#define JLT_EXT_EXACT_MATRIX_H

#include "core/status.h"
#include "ext/exact_poly.h"

enum { JLT_EXACT_FACTORS_MAX = 16 };

/* A monic factor of the characteristic polynomial without the root 0. */
typedef struct {
    jlt_exact_poly poly;
    size_t multiplicity; /* of its roots in the characteristic polynomial */
    bool even;           /* poly(-x) = poly(x); in a split matrix, a factor that is not even has no root on the imaginary axis */
    bool semisimple;     /* each root has as many eigenvectors as its multiplicity */
} jlt_exact_factor;

typedef struct jlt_exact_matrix {
    size_t n;
    jlt_surd_field *field;
    jlt_surd *point, *entries; /* shapes (n,) and (n, n): the equilibrium, and the Jacobian there; set by the caller */
    jlt_exact_poly charpoly;   /* this and the following members are set by jlt_exact_matrix_analyse */
    size_t zeros;              /* algebraic multiplicity of the eigenvalue zero */
    bool zero_semisimple;
    jlt_exact_factor factors[JLT_EXACT_FACTORS_MAX];
    size_t factor_count;
    bool split; /* no factor has multiple roots, and no two factors have a common root */
} jlt_exact_matrix;

jlt_exact_matrix *jlt_exact_matrix_create(size_t n); /* returns NULL if memory is out */
void jlt_exact_matrix_destroy(jlt_exact_matrix *m);  /* legal on NULL */
JLT_OWNED_TYPE(jlt_exact_matrix)

/** Compute the characteristic polynomial, by reduction to Hessenberg form, the multiplicity of zero, and one factor: the
 *  polynomial divided by x^zeros.
 *  Cost: n^3 operations. Source: H. Cohen, A Course in Computational Algebraic Number Theory, 1993, 2.2.4. */
void jlt_exact_matrix_analyse(jlt_exact_matrix *m);

/** Replace the factor by factors without multiple roots, each of which is even or has no root on the imaginary axis: with a root z
 *  on that axis, -z is a root of the same multiplicity.
 *  Cost: greatest common divisors, and for multiple roots powers of the matrix.
 *  Source: D. Y. Y. Yun, On square-free decomposition algorithms, SYMSAC 1976. */
void jlt_exact_matrix_split(jlt_exact_matrix *m);

#endif
