/** Ways between tables: maps from the states and parameters of one table to those of another that may serve in its place, as the
 *  table's records `reduction` and `lift` define and prove them. */
#ifndef JLT_KERNEL_WAY_H
#define JLT_KERNEL_WAY_H

#include <stdbool.h>

#include "kernel/descriptor.h"

/** JLT_WAY_VALUES_MAX: the most states (lifted roots included) or parameters of a table at either end of a way.
 *  JLT_WAY_TABLES_MAX: the most loaded tables. */
enum { JLT_WAY_VALUES_MAX = JLT_DESCRIPTOR_VALUES_MAX, JLT_WAY_TABLES_MAX = 16 };

/** Tables loaded beside the built-in ones: their general fields, each in its own time. */
typedef struct {
    unsigned count;
    const jlt_descriptor *tables[JLT_WAY_TABLES_MAX];
} jlt_way_tables;

/** The way that a claim of the table `from` defines; NULL if it defines none. */
const jlt_way *jlt_way_of(const jlt_descriptor *from, const jlt_claim *claim);

/** The table with this digest among `others`; NULL if it is not there, or `others` is NULL. Prefer it to a built-in table of the
 *  same digest: its claims about further tables were proved of the tables loaded beside it. */
const jlt_descriptor *jlt_way_among(const jlt_way_tables *others, const char *sha256);

/** The general field of the table that a way leads to, found by its digest among `others` (NULL for none), then among the built-in
 *  tables; NULL if it is in neither. */
const jlt_descriptor *jlt_way_target(const jlt_way *way, const jlt_way_tables *others);

/** Whether the way is proved: its claim in the table `from`, and for a lift also the reduction of the larger table, `target`, onto
 *  `from`. Out: *broken, if the way is not proved: the unproved claim, or NULL if there is no claim. */
bool jlt_way_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_way *way, const jlt_descriptor *target);

/** The first condition of the way that x, shape (states of its field,), and params do not meet; NULL if all are met. If x is NULL,
 *  only the conditions `= 0` are tested, which contain parameters alone. */
const jlt_way_condition *jlt_way_broken(const jlt_way *way, const double *x, const double *params);

/** The first proved way from a field to another table, in the time of `table`, whose conditions x and params meet (x NULL: as for
 *  jlt_way_broken); NULL if there is none. Out: *broken: NULL on success; else the unproved claim of the first way whose
 *  conditions are met, NULL if there is no such way. */
const jlt_way *jlt_way_to(const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *table, const double *x,
                          const double *params);

/** Map a state to the other table. Out: y, shape (way->coordinate_count,), without lifted roots; other, shape (way->param_count,),
 *  the parameters there. Errors: UNSUPPORTED, too many values; DOMAIN, an angle has no value at x; NONFINITE. */
JLT_CHECKED jlt_status jlt_way_follow(const jlt_way *way, double *y, double *other, const double *x, const double *params);

/** Map the parameters alone. Out: other, shape (way->param_count,), possibly NaN or infinite. If x is NULL, parameters that are
 *  levels of integrals are meaningless. */
void jlt_way_params(const jlt_way *way, double *other, const double *x, const double *params);

#endif
