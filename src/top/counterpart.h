/** The top that a user's own table is, where the table proves so.
 *
 *  What is known here of the spherical top in closed form is known of the tables built in. It serves for another table where a
 *  proved reduction leads from that one to a table built in which JLT_DEFAULT_MODEL reduces to as well: there the two have the same
 *  motion, and states of the same name are the same, for the records `embedding` of the table between say what they are. Parameters
 *  are those that the reduction says. */
#ifndef JLT_TOP_COUNTERPART_H
#define JLT_TOP_COUNTERPART_H

#include "kernel/way.h"
#include "top/top.h"

typedef struct {
    jlt_top top;
    const jlt_way *way;           /* of the other table; NULL: it is JLT_DEFAULT_MODEL itself */
    size_t place[JLT_TOP_STATES]; /* of the top's states in the other table */
} jlt_counterpart;

/** The top that `model` with params, shape (params,), is by its reduction to the table built in of the name `shared`. x, shape
 *  (states,): where the reduction is to serve; NULL: anywhere. Out: *broken, where it fails: the claim that is not proved, NULL
 *  where there is none.
 *  Errors: UNSUPPORTED, no proved reduction leads there whose conditions are met; ARG, m, R or I1 is missing. */
JLT_CHECKED jlt_status jlt_counterpart_open(jlt_counterpart *out, const jlt_claim **broken, const jlt_descriptor *model,
                                            const char *shared, const double *params, const double *x);

/* The top's state, shape (JLT_TOP_STATES,), where the table's is x, of the same shape, and the other way round. */
void jlt_counterpart_look(const jlt_counterpart *self, double *of_top, const double *x);
void jlt_counterpart_return(const jlt_counterpart *self, double *x, const double *of_top);

/** The first condition that params do not meet of a reduction of `model` to the table built in of the name `shared`; NULL where
 *  there is no such reduction, or all are met. */
const jlt_way_condition *jlt_counterpart_condition(const jlt_descriptor *model, const char *shared, const double *params);

/** Write "reduction NAME : by FILE with STATE = ..., ..." as a table needs it to have a counterpart by the table built in of the
 *  name `shared`. Out: text, `size` bytes. */
void jlt_counterpart_record(char *text, size_t size, const char *shared);

#endif
