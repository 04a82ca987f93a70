/** Encloses the trace of the linearization along a family of equilibria over a box of parameters and of coordinates along it.
 *
 *  At an equilibrium x the flow multiplies volumes by exp(t div f(x)); if the trace div f(x) is not 0, no measure with a density
 *  that is continuous and positive at x is invariant. This holds for all equilibria over a box if an enclosure of the trace
 *  excludes 0. The trace is enclosed in intervals, from the differentiated field, and from the table's own formula if that is
 *  proved; the box is bisected until the enclosures exclude 0 (R. E. Moore, Interval Analysis, 1966). Parts where a condition of
 *  the table's domain certainly fails are discarded. */
#ifndef JLT_VALIDATED_FAMILY_H
#define JLT_VALIDATED_FAMILY_H

#include "core/status.h"
#include "read/model.h"
#include "validated/range.h"

typedef struct {
    const ttc_model *model;  /* its graph grows by derivatives */
    const ttc_claim *family; /* of equilibria */
    const ttc_claim *trace;  /* the table's proved formula for its trace; NULL if there is none */
    unsigned dim;            /* number of sides of the box: all parameters and states that the family leaves free */
    const uint32_t *symbols; /* (dim,), like low and high */
    const fmpq *low, *high;
    unsigned limit;          /* the most boxes to examine */
    slong bits;
} jlt_family_question;

typedef enum {
    JLT_FAMILY_PROVED,
    JLT_FAMILY_ZERO,    /* refuted: the trace is 0 at `point` */
    JLT_FAMILY_CHANGES, /* refuted: it is > 0 at `point`, < 0 at `other` */
    JLT_FAMILY_OUTSIDE, /* no point of the box is proved to be in the table's domain */
    JLT_FAMILY_LEFT     /* undecided in the box from `point` to `other`: `limit` boxes, or 30 halvings of all sides, are used up */
} jlt_family_verdict;

typedef struct {
    jlt_family_verdict verdict;
    unsigned dim, valid_count, boxes; /* boxes: number of boxes examined */
    fmpq *point, *other; /* (dim,); PROVED: `point` is in the domain */
    jlt_range trace;     /* PROVED: over all of the box that may be in the domain; excludes 0 */
    arf_struct *least;   /* (valid_count,), lower bounds of the model's conditions over the same; NaN if none is known */
} jlt_family_result;

/** Initialize for the results of jlt_family_prove; release with jlt_family_result_clear. */
void jlt_family_result_init(jlt_family_result *self, const jlt_family_question *question);
void jlt_family_result_clear(jlt_family_result *self);

/** Prove the sign of the trace. Out: *result, initialized by jlt_family_result_init. Errors: NOMEM. Cost: at most `limit` boxes,
 *  with dim + 2 enclosures each. A box is cut across the side along which the trace changes most, with the other sides at their
 *  midpoints; the search is deterministic. */
JLT_CHECKED jlt_status jlt_family_prove(jlt_family_result *result, const jlt_family_question *question);

#endif
