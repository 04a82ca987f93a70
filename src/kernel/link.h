/** Which tables may answer in place of one, because a proof says that its motions are theirs.
 *
 *  A link leads from a table to a smaller one: it claims a reduction there, without a condition, that claim is proved, and the
 *  proof was made for this very table (its SHA-256 is compared). A chain of such links is a link as well. An embedding is none: it
 *  leads into a larger table, and may say which parameters that one then has. */
#ifndef JLT_KERNEL_LINK_H
#define JLT_KERNEL_LINK_H

#include <stdbool.h>

#include "kernel/way.h"

enum { JLT_LINK_STEPS_MAX = 8 };

/** From one table to the next. */
typedef struct {
    const jlt_descriptor *from, *to; /* general fields, in their own times */
    const jlt_claim *claim;
    const jlt_way *way; /* whose kernel gives the parameters there; NULL: all go by equal names, but for levels */
} jlt_link_step;

/** A chain of them; count 0 where both tables are one. */
typedef struct {
    unsigned count;
    jlt_link_step steps[JLT_LINK_STEPS_MAX];
} jlt_link;

/** Find the shortest chain that leads from one table to the other. Only tables that are built in, or among `others`, NULL for none,
 *  may stand between the two. Returns whether there is one. Out: *link, empty where there is none; *broken, then: a claim of the
 *  first table that would lead to the other if it were proved, or gave parameters and levels by names that can be followed; or
 *  NULL. */
bool jlt_link_find(jlt_link *link, const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *to,
                   const jlt_way_tables *others);

/** What gives the parameter `name` of the last table: JLT_SOURCE_OWN, the parameter of the same name in every table of the chain;
 *  JLT_SOURCE_PARAMS, parameters of the first table, from which jlt_link_params computes it; JLT_SOURCE_LEVEL, states of the first
 *  table: it is the value of an integral there. */
jlt_source jlt_link_source(const jlt_link *link, const char *name);

/** A parameter of the table `to`, onto which a claim of `from` reduces, that cannot be followed: something else has its name in
 *  `from`; NULL: there is none. */
const char *jlt_link_renames(const jlt_descriptor *from, const jlt_claim *claim, const jlt_descriptor *to);

/** Whether any parameter of the last table is JLT_SOURCE_PARAMS. */
bool jlt_link_computes(const jlt_link *link);

/** The parameters of the last table: out, shape (param_count of it,), from those of the first, params, shape (param_count of it,).
 *  The caller replaces those that are JLT_SOURCE_LEVEL, which no parameters give. Where both are one table `out` is untouched. */
void jlt_link_params(const jlt_link *link, double *out, const double *params);

#endif
