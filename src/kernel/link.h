/** Finds smaller tables whose motions are, by proof, the motions of a given table, and that may serve in its place.
 *
 *  A link is one claim or a chain of them. A claim links a table to a smaller one if it is a reduction onto it without a
 *  condition (`when`, `modulo`), is proved, and the proof was made for exactly that table (its SHA-256 is compared). An embedding
 *  is no link: it leads into a larger table, and may fix the parameters of that one. */
#ifndef JLT_KERNEL_LINK_H
#define JLT_KERNEL_LINK_H

#include <stdbool.h>

#include "kernel/way.h"

enum { JLT_LINK_STEPS_MAX = 8 };

/** One claim of a chain. */
typedef struct {
    const jlt_descriptor *from, *to; /* the general fields of the two tables, each in its own time */
    const jlt_claim *claim;
    const jlt_way *way; /* its kernel gives the parameters of `to`; NULL: all parameters go by equal names, except levels */
} jlt_link_step;

/** A chain of steps; count is 0 if both tables are the same. */
typedef struct {
    unsigned count;
    jlt_link_step steps[JLT_LINK_STEPS_MAX];
} jlt_link;

/** Find the shortest chain from one table to the other. Only tables that are built in or in `others` (NULL for none) may stand
 *  between the two. Returns whether there is a chain. Out: *link, empty if there is none; *broken, if there is none: a claim of the
 *  first table that leads to the other, but is unproved, or whose parameters cannot be followed by name, or beyond which
 *  the domain is wider; or NULL. */
bool jlt_link_find(jlt_link *link, const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *to,
                   const jlt_way_tables *others);

/** The source of the parameter `name` of the last table: JLT_SOURCE_OWN, the parameter of the same name in every table of the
 *  chain; JLT_SOURCE_PARAMS, other parameters of the first table, from which jlt_link_params computes it; JLT_SOURCE_LEVEL, the
 *  state: it is the value of an integral of the first table. */
jlt_source jlt_link_source(const jlt_link *link, const char *name);

/** The name of a parameter of the table `to` whose value under this reduction cannot be followed by name: in `from` the value has
 *  another name, or none, or the name means something else; NULL if there is no such parameter. */
const char *jlt_link_renames(const jlt_descriptor *from, const jlt_claim *claim, const jlt_descriptor *to);

/** The name of a state with an interval, or of a record `domain`, that bounds the states of `from` and not those of the claim's
 *  table: after this reduction motions would be followed beyond their end; NULL if there is none. None is lost where the claim
 *  defines a way, which leads back by proof. */
const char *jlt_link_widens(const jlt_descriptor *from, const jlt_claim *claim);

/** Whether any parameter of the last table is JLT_SOURCE_PARAMS. */
bool jlt_link_computes(const jlt_link *link);

/** Compute the parameters of the last table, out, shape (its param_count,), from those of the first, params, shape (its
 *  param_count,). The caller replaces those of source JLT_SOURCE_LEVEL. `out` is untouched if both tables are the same. */
void jlt_link_params(const jlt_link *link, double *out, const double *params);

#endif
