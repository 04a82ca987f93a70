/** Numbers, vectors and matrices of FLINT that live as long as the block that declares them: they are initialized, to zero, where
 *  they are declared, and cleared where the block ends, however it is left. No JLT_TRY may stand before them in their block.
 *
 *      JLT_SCOPED(arb, x, y);             declares arb_t x, y
 *      JLT_SCOPED_VECTOR(arb, v, n);      declares arb_ptr v, shape (n,)
 *      JLT_SCOPED_MATRIX(arb, m, n, A);   declares arb_mat_t A, shape (m, n)
 *
 *  JLT_SCOPED_TYPE does so for a type of one's own, beside its _t, _init and _clear. */
#ifndef JLT_EXT_SCOPED_H
#define JLT_EXT_SCOPED_H

#if __has_include(<flint/arb.h>) /* Arb's headers lie within FLINT 3, or beside FLINT 2 */
#include <flint/acb_mat.h>
#include <flint/acb_poly.h>
#include <flint/arb_mat.h>
#include <flint/arb_poly.h>
#else
#include <acb_mat.h>
#include <acb_poly.h>
#include <arb_mat.h>
#include <arb_poly.h>
#endif
#include <flint/fmpq.h>

#define JLT_SCOPED(type, ...)                                                          \
    __attribute__((cleanup(jlt_scoped_##type##_clear))) type##_t __VA_ARGS__;          \
    jlt_scoped_##type##_init((jlt_scoped_##type *[]){ __VA_ARGS__, NULL })

#define JLT_SCOPED_VECTOR(type, name, size)                                            \
    __attribute__((cleanup(jlt_scoped_##type##_vector_clear)))                         \
        jlt_scoped_##type##_vector name##_scoped = jlt_scoped_##type##_vector_of(size); \
    const type##_ptr name = name##_scoped.at

#define JLT_SCOPED_MATRIX(type, rows, columns, ...)                                    \
    __attribute__((cleanup(jlt_scoped_##type##_matrix_clear))) type##_mat_t __VA_ARGS__; \
    jlt_scoped_##type##_matrix_init(rows, columns, (type##_mat_struct *[]){ __VA_ARGS__, NULL })

#define JLT_SCOPED_TYPE(type, number)                                                  \
    typedef number jlt_scoped_##type;                                                  \
    static inline void jlt_scoped_##type##_clear(type##_t *x) { type##_clear(*x); }    \
    static inline void jlt_scoped_##type##_init(jlt_scoped_##type *const *x)           \
    {                                                                                  \
        for (; *x != NULL; x++) type##_init(*x);                                       \
    }

#define JLT_SCOPED_ARRAYS(type)                                                        \
    typedef struct {                                                                   \
        type##_ptr at;                                                                 \
        slong size;                                                                    \
    } jlt_scoped_##type##_vector;                                                      \
    static inline jlt_scoped_##type##_vector jlt_scoped_##type##_vector_of(slong size) \
    {                                                                                  \
        return (jlt_scoped_##type##_vector){ _##type##_vec_init(size), size };         \
    }                                                                                  \
    static inline void jlt_scoped_##type##_vector_clear(jlt_scoped_##type##_vector *v) \
    {                                                                                  \
        _##type##_vec_clear(v->at, v->size);                                           \
    }                                                                                  \
    static inline void jlt_scoped_##type##_matrix_clear(type##_mat_t *A) { type##_mat_clear(*A); } \
    static inline void jlt_scoped_##type##_matrix_init(slong rows, slong columns, type##_mat_struct *const *A) \
    {                                                                                  \
        for (; *A != NULL; A++) type##_mat_init(*A, rows, columns);                    \
    }

JLT_SCOPED_TYPE(arb, arb_struct)
JLT_SCOPED_TYPE(arf, arf_struct)
JLT_SCOPED_TYPE(mag, mag_struct)
JLT_SCOPED_TYPE(acb, acb_struct)
JLT_SCOPED_TYPE(arb_poly, arb_poly_struct)
JLT_SCOPED_TYPE(acb_poly, acb_poly_struct)
JLT_SCOPED_TYPE(fmpz, fmpz)
JLT_SCOPED_TYPE(fmpq, fmpq)
JLT_SCOPED_ARRAYS(arb)
JLT_SCOPED_ARRAYS(acb)

#endif
