/** The kernels of one field: what each computes, and the programs that compute it. */
#ifndef TTC_KERNELS_H
#define TTC_KERNELS_H

#include "fields/prepared.h"
#include "fields/field.h"
#include "kernels/watched.h"
#include "optimize/lower.h"
#include "optimize/optimize.h"
#include "optimize/program.h"

/* In the order of the descriptor. */
typedef enum {
    TTC_KERNEL_RHS,
    TTC_KERNEL_JACOBIAN,
    TTC_KERNEL_RHS_JACOBIAN,
    TTC_KERNEL_DIVERGENCE,
    TTC_KERNEL_INTEGRAL_VALUES,
    TTC_KERNEL_INTEGRAL_GRADIENTS,
    TTC_KERNEL_MEASURE_VALUES,
    TTC_KERNEL_MEASURE_DIVERGENCES,
    TTC_KERNEL_TIME_FACTOR,
    TTC_KERNEL_ELIMINATED,
    TTC_KERNEL_OBSERVE_VALUES,
    TTC_KERNEL_VALID_VALUES,
    TTC_KERNEL_DOMAIN_VALUES,
    TTC_KERNEL_DOMAIN_GRADIENTS,
    TTC_KERNEL_KINDS
} ttc_kernel_kind;

typedef struct {
    ttc_id *outputs; /* what is computed, in the field's symbols */
    size_t count;    /* 0: the field has no such kernel */
    ttc_id *gathered; /* the same outputs from the gathered right-hand sides; NULL if equal */
    ttc_program *naive;     /* on raw parameters, as the expressions stand, only units, roots and functions shared */
    ttc_program *reference; /* the same, equal subexpressions shared: what ball kernels evaluate */
    ttc_program *optimized; /* on the prepared values */
} ttc_kernel;

typedef struct {
    ttc_field *field;
    ttc_prepared prepared;
    ttc_program *jet;     /* outputs: rhs, then dt/dtau if the field has a time of its own; for Taylor recurrences */
    ttc_program *prepare; /* raw parameters -> prepared values after the parameters */
    ttc_kernel kernels[TTC_KERNEL_KINDS];
    uint32_t *integrals; /* claims that hold here, in order of appearance */
    size_t integral_count;
    uint32_t *measures;
    size_t measure_count;
    uint32_t *families;  /* families of equilibria served here */
    size_t family_count;
    ttc_watched *watched; /* conditions of the domain */
    size_t watched_count;
    char *unproved;      /* names of claims that these kernels rest on without a proof; NULL: none */
    ttc_effort effort;
    const ttc_claim *failed_claim; /* the family of equilibria whose kernels could not be written; NULL: none */
} ttc_kernels;

/** Make all kernels of a field, which it takes ownership of, also on failure. Returns NULL when memory is out or an expression
 *  outgrows the graph. */
ttc_kernels *ttc_kernels_create(ttc_field *field, ttc_effort effort);

/** Make each kernel again with sums without cancellation (see fields/simplify.h); the new one is kept where no output loses
 *  digits, or where no more outputs do than before, for no more operations. To be called once. Returns false when memory is out;
 *  the kernels can then only be destroyed. */
bool ttc_kernels_keep_digits(ttc_kernels *kernels, ttc_effort effort);

/** Keep those families of equilibria that have values in the field. */
void ttc_kernels_keep_families(ttc_kernels *kernels);

/* What a kernel's program is for. Where memory is out it is for values. */
ttc_purpose ttc_kernel_purpose(const ttc_kernels *kernels, ttc_kernel_kind kind);

/* Outputs of the program for jets, for the caller to free. NULL when memory is out. */
ttc_id *ttc_kernels_jet_outputs(const ttc_kernels *kernels);
void ttc_kernels_destroy(ttc_kernels *kernels); /* legal on NULL */

const char *ttc_kernel_name(ttc_kernel_kind kind); /* as in the descriptor */

#endif
