/** What the provers of the claim kinds share: one claim, in one field, on one branch of the zero level it is restricted to. */
#ifndef TTC_PROVE_TASK_H
#define TTC_PROVE_TASK_H

#include "algebra/derive.h"
#include "prove/prove.h"
#include "algebra/valuation.h"

typedef struct {
    const ttc_model *model;
    const ttc_claim *claim;
    ttc_resolver resolver;
    void *resolver_context;
    /* of the branch in hand */
    ttc_valuation *field;
    ttc_ring *ring;
    /* the verdict so far */
    ttc_proof_status status;
    char *remainder;
} ttc_task;

typedef void (*ttc_prover)(ttc_task *task);

/* Verdicts. The first one that is not `proved` stays. The format names what; the ratio, when given, is appended. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void ttc_task_refute(ttc_task *task, const ttc_ratio *remainder, const char *format, ...);
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void ttc_task_reject(ttc_task *task, const char *format, ...);
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void ttc_task_require_zero(ttc_task *task, const ttc_ratio *remainder, const char *format, ...);
bool ttc_task_open(const ttc_task *task); /* nothing against the claim so far, and the ring is sound */

/** Run `prover` in the field of the claim: its `when` and the family's, the family's states, its `modulo` zero levels, on
 *  every branch: each factor of a zero level, each sign of a root whose radicand became a square. All must agree. */
void ttc_task_run(ttc_task *task, ttc_prover prover);

/* Parameters and states bound to numbers must lie in their domains; rejects the claim otherwise. */
void ttc_task_check_domain(ttc_task *task);

/* The equilibria claim that a claim is about: itself, or its family; NULL for other kinds. */
const ttc_claim *ttc_task_family(const ttc_task *task);

/* out = the entry of the Jacobian of the field. */
void ttc_task_jacobian(ttc_task *task, ttc_ratio *out, size_t row, size_t column);
/* shape (count,), zeros; for ttc_task_free. NULL and a rejection when memory is out. */
ttc_ratio *ttc_task_ratios(ttc_task *task, size_t count);
void ttc_task_free(ttc_task *task, ttc_ratio *ratios, size_t count);

/* Records a rational equilibrium of the family, inside the domain, with nonzero trace; rejects when none is found. */
void ttc_task_find_witness(ttc_task *task);

/* The provers, one a kind. */
void ttc_prove_integral(ttc_task *task);
void ttc_prove_rate(ttc_task *task);
void ttc_prove_invariant(ttc_task *task);
void ttc_prove_measure(ttc_task *task);
void ttc_prove_reversor(ttc_task *task);
void ttc_prove_symmetry(ttc_task *task);
void ttc_prove_equilibria(ttc_task *task);
void ttc_prove_trace(ttc_task *task);
void ttc_prove_charpoly(ttc_task *task);
void ttc_prove_obstructs(ttc_task *task);
void ttc_prove_matrix(ttc_task *task);
void ttc_prove_left_null(ttc_task *task);
void ttc_prove_equal(ttc_task *task);
void ttc_prove_reduction(ttc_task *task);

#endif
