/** Which tables may answer in place of one, because a proof says that its motions are theirs.
 *
 *  A link leads from a table to another when it claims a reduction onto that one, or an embedding into it, without a condition,
 *  when that claim is proved, and when the proof was made for this very table (its SHA-256 is compared). A chain of such links is
 *  a link as well. */
#ifndef JLT_KERNEL_LINK_H
#define JLT_KERNEL_LINK_H

#include <stdbool.h>

#include "kernel/way.h"

/** Whether a chain of links leads from one table to the other; every table is linked to itself. Only tables that are built in, or
 *  among `others`, NULL for none, may stand between the two. Out: *broken, when the answer is no: a claim of the first that would
 *  lead to the other if it were proved, or NULL. */
bool jlt_link_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *to, const jlt_way_tables *others);

#endif
