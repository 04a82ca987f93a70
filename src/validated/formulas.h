/** The expressions that a validated integration evaluates, as the compiler's straight-line programs: the field, its derivatives,
 *  its divergence, the conditions under which the model holds, the conditions of its domain, and integrals with their gradients.
 *
 *  They are compiled from the table's text in the descriptor by the passes that make ball kernels, and can be interpreted in any
 *  arithmetic. A free parameter is one whose value is an interval: it becomes a state of rate 0, which keeps correlations. In a
 *  time tau that lifts roots, these follow the table's states, and the last state is the table's own time t, of rate dt/dtau. */
#ifndef JLT_VALIDATED_FORMULAS_H
#define JLT_VALIDATED_FORMULAS_H

#include "core/status.h"
#include "kernel_abi.h"
#include "optimize/program.h"
#include "read/model.h"

enum { JLT_FORMULAS_FREE_MAX = 8, JLT_FORMULAS_LEVELS_MAX = 8 };

typedef struct {
    ttc_model *model;
    unsigned states, params;          /* states: lifted roots and t included, where there are any */
    unsigned lifted_count, pole;      /* 0 in the table's own time; index of the state whose interval ends at the pole */
    unsigned free_count, free[JLT_FORMULAS_FREE_MAX]; /* indices of the parameters that are appended to the states */
    unsigned dim;                                     /* states + free_count */
    unsigned valid_count, domain_count, level_count;
    ttc_program *motion;    /* f, (states,) */
    ttc_program *variation; /* f, (states,); df/d(x, free), (states, dim); div f, (1,); the model's conditions, (valid_count,);
                             * quantities that are positive in the domain, (domain_count,); radicands of the lifted roots,
                             * (lifted_count,) */
    ttc_program *levels;    /* integrals, (level_count,); their gradients, (level_count, dim) */
} jlt_formulas;

/** Out: *formulas, NULL on failure; destroy it with jlt_formulas_destroy. In: free, shape (free_count,), indices of parameters;
 *  levels, shape (level_count,), names of integrals. Errors: ARG, more than the limits above; UNSUPPORTED, no such integral, or
 *  the table cannot be parsed; NOMEM. */
JLT_CHECKED jlt_status jlt_formulas_create(jlt_formulas **formulas, const jlt_descriptor *descriptor, const unsigned *free,
                                           unsigned free_count, const char *const *levels, unsigned level_count);

/** The same in the time of this name of the table, without free parameters and without integrals. In: pole, index of a state.
 *  Quantities that are positive in the domain have lifted roots divided out, so that they may be positive also where these roots
 *  are 0; distances of the state `pole` from ends at which a lifted root is 0 are left out. Errors: as jlt_formulas_create;
 *  UNSUPPORTED, there is no such time, or it lifts no root. */
JLT_CHECKED jlt_status jlt_formulas_create_lifted(jlt_formulas **formulas, const jlt_descriptor *descriptor, const char *time,
                                                  unsigned pole);
void jlt_formulas_destroy(jlt_formulas *formulas); /* legal on NULL */

/* Indices of outputs of `variation`: */
unsigned jlt_formulas_slope(const jlt_formulas *self, unsigned row, unsigned column); /* d f_row/d state or free parameter */
unsigned jlt_formulas_divergence(const jlt_formulas *self);
unsigned jlt_formulas_valid(const jlt_formulas *self, unsigned index);  /* condition number `index` of the model */
unsigned jlt_formulas_domain(const jlt_formulas *self, unsigned index); /* quantity number `index` that is positive in the domain */
unsigned jlt_formulas_radicand(const jlt_formulas *self, unsigned index); /* of lifted root number `index` */

#endif
