/** Tiers: the same motion by models of different size.
 *
 *  A table may say, with proof, that a smaller table serves in its place on levels of integrals (`reduction`), or that it is a part
 *  of a larger one that tells more (`lift`). The tiers of a model follow from these records, for any family of tables: every table
 *  that can be reached by them, in a time in which its roots are states where it has such a time, and for comparison in t as well;
 *  and the model's own field with a state eliminated. A table's record `tier` gives its tier the name.
 *
 *  A way leads from the states of one table to those of another (kernel/way.h). */
#ifndef JLT_SCENE_TIER_H
#define JLT_SCENE_TIER_H

#include "integrate/event.h"
#include "kernel/instance.h"
#include "kernel/way.h"

enum {
    JLT_TIERS_MAX = 24,
    JLT_TIER_WAYS_MAX = 4,
    JLT_TIER_NAME_MAX = 144 /* two names of a table, and more */,
    JLT_TIER_TEXT_MAX = 256,
    JLT_TIER_EDGES_MAX = 8
};

typedef struct {
    char name[JLT_TIER_NAME_MAX], meaning[JLT_TIER_TEXT_MAX];
    unsigned dimension;            /* of the flow that is integrated, without lifted roots; 0: none is */
    const jlt_descriptor *asked;   /* the model in question: the general field in its own time */
    const jlt_descriptor *table;   /* the general field of the tier's table; NULL: quadratures, nothing is integrated */
    const char *time,              /* of its kernel, as the table names it; "": t */
        *elimination;              /* of its kernel, as the table names it; "": no state is eliminated */
    bool by_name;                  /* taken where it is asked for by name, as for a comparison; the planner never chooses it */
    bool is_larger;                /* it tells more than was asked */
    jlt_units units;               /* those in which it is opened, all zero: the table's. Conditions are judged in the table's,
                                      since terms and numbers of one may have different dimensions */
    unsigned way_count;            /* of ways from the asked table to the tier's, one after another; 0: they are one table */
    const jlt_way *ways[JLT_TIER_WAYS_MAX];        /* (way_count,) */
    const jlt_descriptor *from[JLT_TIER_WAYS_MAX]; /* (way_count,): the field from whose states each way leads */
} jlt_tier;

/** The tiers of a model, from the smallest, with tables that are built in and `others`, NULL for none; each by the first way to its
 *  table. Where tables give one name to their tiers, these are called MODEL.NAME. Out: tiers, shape (JLT_TIERS_MAX,). Returns their
 *  number. */
unsigned jlt_tier_list(jlt_tier *tiers, const jlt_descriptor *asked, const jlt_way_tables *others);

/** Set *out to the same tier reached by its number-th other way (from 1). False: there are not so many. */
bool jlt_tier_by_way(jlt_tier *out, const jlt_tier *tier, unsigned number, const jlt_way_tables *others);

/** Find a tier by its name; "model" is the model's own field in t. False: there is none of this name. */
bool jlt_tier_find(jlt_tier *out, const jlt_descriptor *asked, const jlt_way_tables *others, const char *name);

/** The tier of the asked table itself, in the time in which its roots are states where it has one. */
void jlt_tier_whole(jlt_tier *out, const jlt_descriptor *asked);

/** A tier bound to an orbit: its kernel, and the parameters of every table on the way. */
typedef struct {
    jlt_tier tier;
    jlt_instance *instance;         /* its most special kernel for these parameters; owned */
    const signed char *mirror;      /* signs of the asked table's reversor where its image is integrated, in reversed time; NULL:
                                       not */
    const jlt_way *back[JLT_TIER_WAYS_MAX]; /* the ways once more, in the tier's time as far as tables have it */
    double params[JLT_TIER_WAYS_MAX + 1][JLT_WAY_VALUES_MAX]; /* of the asked table, then of each that a way leads to */
} jlt_tier_view;

/** Bind a tier to the orbit of the asked model from x, shape (state_count,), with params, shape (param_count,), both in
 *  tier->units, the table's or others in which the asked field may be counted. It is not asked whether a proof leads there. Where
 *  the start is in no place that the tier serves, but its image by a proved reversor is, that is taken.
 *  Out: *out, to be closed where OK is returned. y, shape (states of its kernel,): the tier's coordinates of the start. refusal,
 *  shape (JLT_TIER_TEXT_MAX,): why it does not serve, where UNSUPPORTED is returned. x NULL: parameters alone are looked at, and
 *  levels have values of no meaning; y is not written.
 *  Errors: UNSUPPORTED; ARG, the tier is by quadratures; those of jlt_instance_create. Cost: the kernels of its ways, once. */
JLT_CHECKED jlt_status jlt_tier_open(jlt_tier_view *out, double *y, char *refusal, const jlt_tier *tier, const double *params,
                                     const double *x);
void jlt_tier_close(jlt_tier_view *self);

/** The asked model's states, x, shape (state_count,), at the tier's coordinates y. */
void jlt_tier_extract(const jlt_tier_view *view, double *x, const double *y);

/** Values of the table's record `tier` at its coordinates y, shape (conditions,), as they are in the table's units. general: the
 *  table's general field in the tier's time. */
void jlt_tier_conditions(double *values, const jlt_tier_view *view, const jlt_descriptor *general, const double *y);

typedef struct jlt_tier_edges jlt_tier_edges;

/** The context of one edge's event: the caller need not look into it. */
typedef struct {
    const jlt_tier_edges *edges;
    unsigned index;
    int exponent; /* the value is told in the tier's units, where all its terms have one dimension */
} jlt_tier_edge;

/** Edges: where coordinates of a tier end although the domain of its kernel goes on. Each is an event whose value is > 0 where the
 *  coordinates are good. */
struct jlt_tier_edges {
    const jlt_tier_view *view;
    const jlt_descriptor *general; /* of the tier's table, in its time: what its record `tier` says */
    jlt_instance *full;            /* of the asked field in t, where a state is eliminated; owned */
    unsigned count;
    jlt_event events[JLT_TIER_EDGES_MAX];
    jlt_tier_edge contexts[JLT_TIER_EDGES_MAX];
};

/** Make the edges of a tier; *out must not move, and the view must outlive it. Errors: those of jlt_instance_create; UNSUPPORTED,
 *  there are more than JLT_TIER_EDGES_MAX. */
JLT_CHECKED jlt_status jlt_tier_edges_open(jlt_tier_edges *out, const jlt_tier_view *view);
void jlt_tier_edges_close(jlt_tier_edges *self);

/** Say in words what edge number `index` is. Out: text, shape (JLT_TIER_TEXT_MAX,). */
void jlt_tier_edge_text(char *text, const jlt_tier_edges *edges, unsigned index);

#endif
