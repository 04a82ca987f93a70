/** The model's own table as an independent oracle for its kernels: parsed again, differentiated by the compiler's graph and
 *  enclosed in ball arithmetic at exact values. */
#ifndef JLT_SPECTRUM_ORACLE_H
#define JLT_SPECTRUM_ORACLE_H

#include "ball/ball.h"
#include "core/status.h"
#include "kernel_abi.h"

typedef struct {
    const jlt_descriptor *descriptor; /* general field */
    ttc_model *model;
    ttc_ball *ball;
    uint32_t *states, *params;        /* symbols, in the descriptor's order */
    char **defaults;                  /* of the table, "p/q", shape (params,); NULL where it has none */
    ttc_id *field, *jacobian;         /* shapes (n,) and (n, n) */
    ttc_id trace;                     /* sum of the diagonal */
    ttc_id *gradients;                /* (claims, n), of claimed integrals that have been asked for; TTC_NONE of the others */
} jlt_oracle;

/** Errors: NOMEM; UNSUPPORTED when the embedded table does not read, which says that the build is broken. */
JLT_CHECKED jlt_status jlt_oracle_create(jlt_oracle **oracle, const jlt_descriptor *descriptor);
void jlt_oracle_destroy(jlt_oracle *oracle); /* legal on NULL */

/** Take values exactly, shapes (params,) and (states,). exact, of the same shape, or NULL for none: what counts in place of a
 *  double, "p/q", or NULL. */
void jlt_oracle_set_params(jlt_oracle *oracle, const double *params, const char *const *exact);
void jlt_oracle_set_states(jlt_oracle *oracle, const double *x, const char *const *exact);

/** Enclose `count` expressions. Errors: DOMAIN when one has no finite enclosure. Out: shape (count,). */
JLT_CHECKED jlt_status jlt_oracle_enclose(jlt_oracle *oracle, ttc_enclosure *out, const ttc_id *ids, size_t count);

/** The same with the rounding errors to expect of doubles. */
JLT_CHECKED jlt_status jlt_oracle_estimate(jlt_oracle *oracle, ttc_enclosure *out, const ttc_id *ids, size_t count);

/** Bounds on the errors of integrals' gradients against the exact ones, at the values set.
 *  Out: errors, shape (count, n). In: gradients, shape (count, n), as computed; integrals, their names. Errors: DOMAIN,
 *  UNSUPPORTED (a name that is no claim), NONFINITE. */
JLT_CHECKED jlt_status jlt_oracle_gradient_errors(jlt_oracle *oracle, double *errors, const double *gradients,
                                                  const jlt_named *integrals, size_t count);

/* |computed - enclosed|, rounded up a little: the distance to the farthest point of the enclosure. */
double jlt_oracle_error(double computed, const ttc_enclosure *enclosure);

#endif
