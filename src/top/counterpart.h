/** Finds the spherical top that a user's own table is proved to be equivalent to.
 *
 *  The closed forms in top/ hold for the built-in tables. They apply to another table if a proved reduction leads from it to a
 *  built-in table to which JLT_DEFAULT_MODEL reduces as well: both then have the same motion, and states of the same name are the
 *  same, since the records `embedding` of the shared table define them. Parameters are those that the reduction gives. */
#ifndef JLT_TOP_COUNTERPART_H
#define JLT_TOP_COUNTERPART_H

#include "kernel/way.h"
#include "top/top.h"

typedef struct {
    jlt_top top;
    const jlt_way *way;           /* of the other table; NULL if it is JLT_DEFAULT_MODEL itself */
    size_t place[JLT_TOP_STATES]; /* index of each state of the top in the other table */
} jlt_counterpart;

/** Find the top that `model` with params, shape (params,), is equivalent to by its reduction to the built-in table named `shared`.
 *  x, shape (states,): a state at which the reduction must hold; NULL: conditions on states are ignored. Out: *broken, on failure:
 *  the unproved claim, or NULL if there is none.
 *  Errors: UNSUPPORTED, there is no proved reduction to that table whose conditions are met; ARG, m, R or I1 is missing. */
JLT_CHECKED jlt_status jlt_counterpart_open(jlt_counterpart *out, const jlt_claim **broken, const jlt_descriptor *model,
                                            const char *shared, const double *params, const double *x);

/* Convert a state x of the table to the state of the top, and back; both have shape (JLT_TOP_STATES,). */
void jlt_counterpart_look(const jlt_counterpart *self, double *of_top, const double *x);
void jlt_counterpart_return(const jlt_counterpart *self, double *x, const double *of_top);

/** The first condition of a reduction of `model` to the built-in table named `shared` that params do not meet; NULL if there is no
 *  such reduction, or all conditions are met. */
const jlt_way_condition *jlt_counterpart_condition(const jlt_descriptor *model, const char *shared, const double *params);

/** A state that only one of `model` and JLT_DEFAULT_MODEL has; NULL: there is none. */
const char *jlt_counterpart_other_state(const jlt_descriptor *model);

/** A reduction that `model` claims and that is not proved, onto the built-in table named `shared`, or onto one that is not built in
 *  or could not be read; NULL: there is none. */
const jlt_claim *jlt_counterpart_unproved(const jlt_descriptor *model, const char *shared);

/** Write "reduction NAME : by FILE with STATE = ..., ...", the record that a table needs for a counterpart by the built-in table
 *  named `shared`. Out: text, at most `size` bytes. */
void jlt_counterpart_record(char *text, size_t size, const char *shared);

#endif
