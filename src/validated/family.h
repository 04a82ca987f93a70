/** The trace of the linearization along a family of equilibria, enclosed over a box of parameters and of coordinates along it.
 *
 *  At an equilibrium x the flow multiplies volumes by exp(t div f(x)); where div f(x), the trace, is not 0, no measure with a
 *  density that is continuous and positive at x is invariant. Over a box this holds of all its equilibria once an enclosure of the
 *  trace on it holds no 0. It is enclosed by ends, of the table's expressions differentiated, and of the table's own formula for it
 *  where that is proved; and the box is cut in halves until that is so (R. E. Moore, Interval Analysis, 1966). Parts where a
 *  condition of the table's domain surely fails are left out. */
#ifndef JLT_VALIDATED_FAMILY_H
#define JLT_VALIDATED_FAMILY_H

#include "core/status.h"
#include "read/model.h"
#include "validated/range.h"

typedef struct {
    const ttc_model *model;  /* its graph grows by derivatives */
    const ttc_claim *family; /* of equilibria */
    const ttc_claim *trace;  /* its trace, which is proved; NULL: none is */
    unsigned dim;            /* parameters and states that the family leaves free: all of them */
    const uint32_t *symbols; /* (dim,), these three */
    const fmpq *low, *high;
    unsigned limit;          /* boxes, at most */
    slong bits;
} jlt_family_question;

typedef enum {
    JLT_FAMILY_PROVED,
    JLT_FAMILY_ZERO,    /* refuted: the trace is 0 at `point` */
    JLT_FAMILY_CHANGES, /* refuted: it is > 0 at `point`, < 0 at `other` */
    JLT_FAMILY_OUTSIDE, /* no point of the box is shown to be in the table's domain */
    JLT_FAMILY_LEFT     /* not settled in the box from `point` to `other`: `limit` boxes are spent, or all its sides were halved 30
                           times */
} jlt_family_verdict;

typedef struct {
    jlt_family_verdict verdict;
    unsigned dim, valid_count, boxes; /* boxes: how many were looked at */
    fmpq *point, *other; /* (dim,); PROVED: `point` is one of the domain */
    jlt_range trace;     /* PROVED: over all of the box that may be in the domain, 0 not among it */
    arf_struct *least;   /* (valid_count,), lower bounds of the model's conditions likewise; NaN: none is known */
} jlt_family_result;

/** Room for what jlt_family_prove finds. Ends with jlt_family_result_clear. */
void jlt_family_result_init(jlt_family_result *self, const jlt_family_question *question);
void jlt_family_result_clear(jlt_family_result *self);

/** The proof. Out: *result, set up before by jlt_family_result_init. Errors: NOMEM. Cost: at most `limit` boxes, of dim + 2
 *  enclosures each. Boxes are cut where the trace changes most while other sides stay at their middles, the same way whenever this
 *  runs. */
JLT_CHECKED jlt_status jlt_family_prove(jlt_family_result *result, const jlt_family_question *question);

#endif
