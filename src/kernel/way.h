/** Ways between tables: from a state of one to that of another which may serve in its place, and back, as records `reduction` and
 *  `lift` of the table say and prove. */
#ifndef JLT_KERNEL_WAY_H
#define JLT_KERNEL_WAY_H

#include <stdbool.h>

#include "core/status.h"
#include "kernel_abi.h"

/** JLT_WAY_VALUES_MAX: most states (lifted roots included) or parameters of a table at either end of a way.
 *  JLT_WAY_TABLES_MAX: most loaded tables. */
enum { JLT_WAY_VALUES_MAX = 256, JLT_WAY_TABLES_MAX = 16 };

/** Tables that were loaded, beside those that are built in: general fields in their own times. */
typedef struct {
    unsigned count;
    const jlt_descriptor *tables[JLT_WAY_TABLES_MAX];
} jlt_way_tables;

/** The table of this digest among others, NULL for none; NULL where it is not there. Where one is, what it claims of further tables
 *  was proved of those beside it: a table of the same digest that is built in does not stand for it. */
const jlt_descriptor *jlt_way_among(const jlt_way_tables *others, const char *sha256);

/** The general field of the table that a way leads to, known by its digest; NULL where no such table is among `others`, NULL for
 *  none, or built in. */
const jlt_descriptor *jlt_way_target(const jlt_way *way, const jlt_way_tables *others);

/** Whether the way is proved: the claim of its own table, and of a lift also the claim of the larger table, `target`, that it
 *  reduces to this very one. Out: *broken, when it is not: the claim that lacks its proof, or NULL where there is none. */
bool jlt_way_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_way *way, const jlt_descriptor *target);

/** The first condition of the way that x, shape (states of its field,), and params do not meet; NULL when all are met. x NULL: test
 *  only the conditions `= 0`, which contain parameters alone. */
const jlt_way_condition *jlt_way_broken(const jlt_way *way, const double *x, const double *params);

/** The first proved way from a field to that of a table, in the time of the latter, whose conditions x and params meet, as for
 *  jlt_way_broken; NULL when there is none. Out: *broken: NULL on success; else the unproved claim of the first way whose
 *  conditions are met, NULL if there is none. */
const jlt_way *jlt_way_to(const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *table, const double *x,
                          const double *params);

/** Map a state to the other table. Out: y, shape (way->coordinate_count,), without lifted roots; other, shape (way->param_count,),
 *  the parameters there. Errors: UNSUPPORTED, more values than are served; DOMAIN, an angle has no value at x; NONFINITE. */
JLT_CHECKED jlt_status jlt_way_follow(const jlt_way *way, double *y, double *other, const double *x, const double *params);

/** Map the parameters alone. Out: other, shape (way->param_count,); results may be NaN or infinite. x NULL: at no state in
 *  particular; levels then mean nothing. */
void jlt_way_params(const jlt_way *way, double *other, const double *x, const double *params);

#endif
