/** Tiers: models of different size that give the same motion.
 *
 *  A table may claim, with proof, that a smaller table serves in its place on levels of integrals (`reduction`), or that a larger
 *  one, which observes more, reduces to it (`lift`). A way is such a record: it leads from the states of one table to those of
 *  another (kernel/way.h). The tiers of a model are: every table that ways reach, in a time in which its roots are states if it has
 *  such a time, and for comparison in t as well; and the model's own field with a state eliminated. A table's record `tier` gives
 *  its tier a name. */
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
    unsigned dimension;            /* of the flow that is integrated, without lifted roots; 0: quadratures */
    const jlt_descriptor *asked;   /* the model asked for: its general field in its own time */
    const jlt_descriptor *table;   /* the general field of the tier's table; NULL: quadratures, nothing is integrated */
    const char *time,              /* of its kernel, as the table names it; "": t */
        *elimination;              /* of its kernel, as the table names it; "": no state is eliminated */
    bool by_name;                  /* taken only if asked for by name, for a comparison; the planner never chooses it */
    bool is_larger;                /* its table is larger than the asked one */
    jlt_units units;               /* those in which it is opened; all zero: the table's. Conditions are evaluated in the table's
                                      units, since their terms and constants may have different dimensions */
    unsigned way_count;            /* ways from the asked table to the tier's, one after another; 0: it is the asked table */
    const jlt_way *ways[JLT_TIER_WAYS_MAX];        /* (way_count,) */
    const jlt_descriptor *from[JLT_TIER_WAYS_MAX]; /* (way_count,): the field from whose states each way leads */
} jlt_tier;

/** The tiers of a model, by increasing dimension, among built-in tables and `others`, NULL for none; each by the first way to its
 *  table. If several tables give their tiers one name, these are called MODEL.NAME. Out: tiers, shape (JLT_TIERS_MAX,). Returns
 *  their number. */
unsigned jlt_tier_list(jlt_tier *tiers, const jlt_descriptor *asked, const jlt_way_tables *others);

/** The same tier by another way to its table; number: 0 is the way of jlt_tier_list, 1 the next one, .... Returns false if there
 *  are not so many. */
bool jlt_tier_by_way(jlt_tier *out, const jlt_tier *tier, unsigned number, const jlt_way_tables *others);

/** Find a tier by its name; "model" is the model's own field in t. Returns false if there is none. */
bool jlt_tier_find(jlt_tier *out, const jlt_descriptor *asked, const jlt_way_tables *others, const char *name);

/** The tier of the asked table itself that the planner may choose: in the time that lifts its root, if the table has poles and such
 *  a time, else in t. */
void jlt_tier_whole(jlt_tier *out, const jlt_descriptor *asked);

/** A tier bound to an orbit: its kernel, and the parameters of every table on the way. */
typedef struct {
    jlt_tier tier;
    jlt_instance *instance;         /* its most special kernel for these parameters; owned */
    const signed char *mirror;      /* the signs of the asked table's reversor, if the orbit's image by it is integrated, in
                                       reversed time; NULL: the orbit itself is */
    const jlt_way *back[JLT_TIER_WAYS_MAX]; /* the same ways as descriptors in the tier's time have them, if there are such */
    double params[JLT_TIER_WAYS_MAX + 1][JLT_WAY_VALUES_MAX]; /* of the asked table, then of each table on the way */
} jlt_tier_view;

/** Bind a tier to the orbit of the asked model from x, shape (state_count,), with params, shape (param_count,), both in
 *  tier->units. Whether claims are proved is not checked. If the tier does not serve at x but does at the image of x by a proved
 *  reversor, the image is integrated. Out: *out, for jlt_tier_close if OK is returned; y, shape (states of its kernel,): the tier's
 *  coordinates of the start; refusal, shape (JLT_TIER_TEXT_MAX,): why it does not serve, if UNSUPPORTED is returned. x NULL: only
 *  parameters are looked at; levels get arbitrary values, and y is not written. Errors: UNSUPPORTED; ARG, the tier is by
 *  quadratures; those of jlt_instance_create. Cost: each kernel of its ways once. */
JLT_CHECKED jlt_status jlt_tier_open(jlt_tier_view *out, double *y, char *refusal, const jlt_tier *tier, const double *params,
                                     const double *x);
void jlt_tier_close(jlt_tier_view *self);

/** Compute the asked model's states, x, shape (state_count,), from the tier's coordinates y. */
void jlt_tier_extract(const jlt_tier_view *view, double *x, const double *y);

/** Evaluate the conditions of the table's record `tier` at its coordinates y. Out: values, shape (conditions,), in the table's
 *  units. general: the table's general field in the tier's time. */
void jlt_tier_conditions(double *values, const jlt_tier_view *view, const jlt_descriptor *general, const double *y);

typedef struct jlt_tier_edges jlt_tier_edges;

/** The context of one edge's event; private. */
typedef struct {
    const jlt_tier_edges *edges;
    unsigned index;
    int exponent; /* of two: converts the value to the tier's units, if all its terms have one dimension; else 0 */
} jlt_tier_edge;

/** Edges: where the coordinates of a tier end although the domain of its kernel goes on. Each edge is an event whose value is > 0
 *  where the coordinates are good. */
struct jlt_tier_edges {
    const jlt_tier_view *view;
    const jlt_descriptor *general; /* the general field of the tier's table in its time, with the conditions of its record `tier` */
    jlt_instance *full;            /* the asked field in t, if a state is eliminated, else NULL; owned */
    unsigned count;
    jlt_event events[JLT_TIER_EDGES_MAX];
    jlt_tier_edge contexts[JLT_TIER_EDGES_MAX];
};

/** Make the edges of a tier; *out must not move in memory, and the view must outlive it. Errors: those of jlt_instance_create;
 *  UNSUPPORTED, there are more than JLT_TIER_EDGES_MAX, or a state is eliminated and there is no kernel for gradients of
 *  integrals. */
JLT_CHECKED jlt_status jlt_tier_edges_open(jlt_tier_edges *out, const jlt_tier_view *view);
void jlt_tier_edges_close(jlt_tier_edges *self);

/** Say in words where edge number `index` lies. Out: text, shape (JLT_TIER_TEXT_MAX,). */
void jlt_tier_edge_text(char *text, const jlt_tier_edges *edges, unsigned index);

#endif
