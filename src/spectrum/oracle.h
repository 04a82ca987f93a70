/** Uses the model's own table as an independent oracle for its kernels: parses it again, differentiates it symbolically and
 *  encloses the expressions in ball arithmetic at exact values. */
#ifndef JLT_SPECTRUM_ORACLE_H
#define JLT_SPECTRUM_ORACLE_H

#include "ball/ball.h"
#include "core/status.h"
#include "kernel_abi.h"

typedef struct {
    const jlt_descriptor *descriptor; /* general field */
    ttc_model *model;
    ttc_ball *ball;
    uint32_t *states, *params;        /* their symbols, in the descriptor's order */
    char **defaults;                  /* shape (params,): the table's defaults as "p/q"; NULL where it has none */
    ttc_id *field, *jacobian;         /* shapes (n,) and (n, n) */
    ttc_id trace;                     /* sum of the Jacobian's diagonal */
    ttc_id *gradients;                /* (claims, n): gradients of claimed integrals, computed on demand; TTC_NONE before */
    ttc_id *charpoly;                 /* (claims, n + 1): claimed characteristic polynomials, likewise */
} jlt_oracle;

/** file: the path of the table, by whose last part other tables refer to it; NULL: MODEL.tt. Errors: NOMEM; UNSUPPORTED if the
 *  embedded table cannot be parsed, which means that the build is broken. */
JLT_CHECKED jlt_status jlt_oracle_create(jlt_oracle **oracle, const jlt_descriptor *descriptor, const char *file);
void jlt_oracle_destroy(jlt_oracle *oracle); /* legal on NULL */
JLT_OWNED_TYPE(jlt_oracle)

/** Set the values of parameters, shape (params,), or states, shape (states,), each a double taken exactly. exact, of the same
 *  shape, or NULL: where exact[i] is not NULL, it is the value, "p/q", instead of the double. */
void jlt_oracle_set_params(jlt_oracle *oracle, const double *params, const char *const *exact);
void jlt_oracle_set_states(jlt_oracle *oracle, const double *x, const char *const *exact);

/** Enclose `count` expressions, out, shape (count,). Errors: DOMAIN if one has no finite enclosure. */
JLT_CHECKED jlt_status jlt_oracle_enclose(jlt_oracle *oracle, ttc_enclosure *out, const ttc_id *ids, size_t count);

/** The same, with the rounding errors to be expected of arithmetic in doubles. */
JLT_CHECKED jlt_status jlt_oracle_estimate(jlt_oracle *oracle, ttc_enclosure *out, const ttc_id *ids, size_t count);

/** The gradient, shape (n,), of the integral that is claimed by this name, which the oracle owns and computes once. NULL: no claim
 *  has the name. */
const ttc_id *jlt_oracle_gradient(jlt_oracle *oracle, const char *integral);

/** Bound the errors of computed gradients of integrals against the exact gradients at the values set.
 *  Out: errors, shape (count, n). In: gradients, shape (count, n), as computed; integrals, whose names are claims of the table.
 *  Errors: DOMAIN, UNSUPPORTED (a name that is not a claim), NONFINITE. */
JLT_CHECKED jlt_status jlt_oracle_gradient_errors(jlt_oracle *oracle, double *errors, const double *gradients,
                                                  const jlt_named *integrals, size_t count);

/** The characteristic polynomial c[0] l^n + c[1] l^(n-1) + ... + c[n], c[0] = 1, that claim number `claim` gives: c, (n + 1,),
 *  which the oracle owns and computes once. Returns NULL if the claim's expression is no polynomial of degree n. */
const ttc_id *jlt_oracle_charpoly(jlt_oracle *oracle, size_t claim);

/* A bound on |computed - exact|: the distance to the farthest point of the enclosure, rounded up. */
double jlt_oracle_error(double computed, const ttc_enclosure *enclosure);

#endif
