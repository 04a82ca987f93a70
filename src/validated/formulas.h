/** What a validated integration evaluates of a table, as the compiler's straight-line programs: the field, its derivatives, the
 *  divergence, conditions under which the model holds, those of its domain, integrals with their gradients.
 *
 *  They are made from the text that the descriptor carries, by the passes that make kernels in balls, and interpreted over whatever
 *  arithmetic is wanted. A free parameter is one that may have any value of a ball: it becomes a state whose rate is 0, so that
 *  what depends on it stays correlated. In a time tau that lifts roots, these are states behind the table's, and the table's own time
 *  t is the last one, with the rate dt/dtau. */
#ifndef JLT_VALIDATED_FORMULAS_H
#define JLT_VALIDATED_FORMULAS_H

#include "core/status.h"
#include "kernel_abi.h"
#include "optimize/program.h"
#include "read/model.h"

enum { JLT_FORMULAS_FREE_MAX = 8, JLT_FORMULAS_LEVELS_MAX = 8 };

typedef struct {
    const jlt_descriptor *descriptor; /* general field, in its own time */
    ttc_model *model;
    unsigned states, params;          /* states: also lifted roots and the clock, where there are any */
    unsigned lifted_count;            /* 0 in the table's own time */
    unsigned free_count, free[JLT_FORMULAS_FREE_MAX]; /* parameters that are states as well, behind the states */
    unsigned dim;                                     /* states + free_count */
    unsigned valid_count, domain_count, level_count;
    ttc_program *motion;    /* f, (states,) */
    ttc_program *variation; /* f, (states,); df/d(x, free), (states, dim); div f, (1,); valids, (valid_count,);
                               what is positive in the domain, (domain_count,); radicands of lifted roots, (lifted_count,) */
    ttc_program *levels;    /* integrals, (level_count,); their gradients, (level_count, dim) */
} jlt_formulas;

/** Out: *formulas, NULL on failure; destroy with jlt_formulas_destroy. In: free, shape (free_count,), indices of parameters;
 *  levels, shape (level_count,), names of integrals. Errors: ARG, more than there is room for; UNSUPPORTED, no such integral, or a
 *  table that does not read; NOMEM. */
JLT_CHECKED jlt_status jlt_formulas_create(jlt_formulas **formulas, const jlt_descriptor *descriptor, const unsigned *free,
                                           unsigned free_count, const char *const *levels, unsigned level_count);

/** The same in the table's time of this name, with all parameters in balls and without integrals. What is positive in the domain is
 *  so with lifted roots taken out: where they are zero too. Errors: as above; UNSUPPORTED, no such time, or one that lifts no root. */
JLT_CHECKED jlt_status jlt_formulas_create_lifted(jlt_formulas **formulas, const jlt_descriptor *descriptor, const char *time);
void jlt_formulas_destroy(jlt_formulas *formulas); /* legal on NULL */

/* Which output of `variation` is what: */
unsigned jlt_formulas_slope(const jlt_formulas *self, unsigned row, unsigned column); /* df_row by x_column, or a free parameter */
unsigned jlt_formulas_divergence(const jlt_formulas *self);
unsigned jlt_formulas_valid(const jlt_formulas *self, unsigned index);  /* the quantity of the model's condition `index` */
unsigned jlt_formulas_domain(const jlt_formulas *self, unsigned index); /* what is positive in the domain, number `index` */
unsigned jlt_formulas_radicand(const jlt_formulas *self, unsigned index); /* of the lifted root `index` */

#endif
