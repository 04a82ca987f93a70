/** Tiers: the same motion by models of different size.  * The full system has 17 states, but most questions need fewer:
 *  attitude and track follow from five states by quadratures, these five move on levels of integrals, and in special cases
 *  little or nothing is left to integrate. A tier says which kernel is integrated, for which parameters and starts it may be,
 *  and how its coordinates are computed from the five reduced states and back. The table is ordered from the smallest to the
 *  largest; some tiers serve for comparison and are taken by name only. */
#ifndef JLT_TOP_TIER_H
#define JLT_TOP_TIER_H

#include <stdbool.h>

#include "top/level.h"
#include "top/attitude.h"
#include "top/balanced.h"

/** What a tier knows of an orbit besides its own coordinates: parameters and the levels of the start. */
typedef struct {
    jlt_top top;
    const jlt_descriptor *descriptor; /* of the tier's kernel */
    double start[JLT_TOP_STATES];
    double G;
    jlt_balanced_levels levels;       /* a3 = 0 */
    const jlt_descriptor *asked;      /* the model that was asked about, and its parameters; NULL where the top's are all */
    const double *asked_params;
    int mirror;                       /* -1: the reversor's image is integrated, in reversed time */
} jlt_tier_view;

/** What must be proved for a tier to serve: that a chain of claims links its table to the asked one, and claims of the
 *  latter. */
enum { JLT_TIER_CLAIMS_MAX = 3 };

typedef struct {
    const char *table;
    struct {
        const char *kind, *name;
    } claims[JLT_TIER_CLAIMS_MAX];
} jlt_tier_proofs;

/* Where coordinates of a tier end: value > 0 where they are good. longest_step: as in jlt_event, for a kernel that is rough
 * near there. */
typedef struct {
    double (*value)(void *view, const double *y);
    double (*longest_step)(void *view, const double *y, const double *f, double direction);
    const char *meaning;
} jlt_tier_edge;

typedef struct {
    const char *name, *meaning;
    unsigned dimension;                 /* of the flow that is integrated, without a lifted root; 0: none is */
    const char *model, *time, *elimination; /* of its kernel; model NULL: none */
    bool by_name;                       /* a comparison: never chosen by the planner */
    bool attitude;                      /* gives attitude and track */
    unsigned columns;                   /* states of its kernel, with a lifted root, as embed and extract know them */
    const char *(*refuses)(const jlt_top *top, const double *x); /* why it does not serve, NULL when it does; may be NULL */
    void (*embed)(const jlt_tier_view *view, double *y, const double *x);
    void (*extract)(const jlt_tier_view *view, double *x, const double *y);
    void (*orient)(const jlt_tier_view *view, jlt_attitude *out, const double *y); /* NULL without attitude */
    const jlt_tier_edge *edge;          /* where its coordinates end before the kernel's domain does; NULL: nowhere */
    jlt_tier_proofs proofs;
} jlt_tier;

/* What the edge of a kernel's domain means in plain time. */
extern const char jlt_tier_near_pole[];

/* The table, from the smallest; NULL past the end. */
const jlt_tier *jlt_tier_at(size_t index);

const jlt_tier *jlt_tier_find(const char *name); /* NULL when there is none */

/** Whether a model has tiers: the spherical top's reduced system has, in its five states. */
bool jlt_tier_has(const jlt_descriptor *model);

/** Open two views of the orbit of `model` from x, shape (JLT_TOP_STATES,): *told in the units of the table, in which
 *  told_params and x are, and *view in units of the problem, *units; where the table's units do not fit together these are the
 *  table's as well.
 *  Out: params, shape (model->param_count,), the parameters in *units. Both views point to told_params or params, which must
 *  live on.
 *  Errors: ARG, the model has not the top's parameters; as jlt_instance_scales. */
JLT_CHECKED jlt_status jlt_tier_open(jlt_tier_view *told, jlt_tier_view *view, jlt_units *units, double *params, const jlt_tier *tier,
                                     const jlt_descriptor *kernel, const jlt_descriptor *model, const double *told_params, const double *x);

/** Round the states x, shape (JLT_TOP_STATES,), that an orbit has reached into their domain, in place; with `ends`, to the pole
 *  at which it ended. Returns the side of that pole, +1 or -1, or 0. */
int jlt_tier_settle(double *x, bool ends);

enum { JLT_TIER_TEXT_MAX = 256 };

/** For messages: what the pole at x is called, and the limits of the other states there. */
void jlt_tier_pole_text(char pole[JLT_TIER_TEXT_MAX], char limits[JLT_TIER_TEXT_MAX], const double *x);

/** Fill a view of the orbit from x, shape (JLT_TOP_STATES,): its levels, and whether the reversor's image is integrated in its
 *  place. tier NULL: the model's own kernel. */
void jlt_tier_look(jlt_tier_view *out, const jlt_tier *tier, const jlt_descriptor *descriptor, const jlt_top *top,
                   const double *x);

/** The kernel's parameters by name: the asked model's, or the top's, and the levels it asks for (G, G_level, M, F0).
 *  params: shape (descriptor->param_count,). Errors: UNSUPPORTED, one that nobody knows. */
JLT_CHECKED jlt_status jlt_tier_params(double *params, const jlt_tier_view *view);

#endif
