/** Data and picture of the command `portrait`: the flow on M^2 of the balanced sphere. */
#ifndef JLT_TOP_COMMAND_PORTRAIT_H
#define JLT_TOP_COMMAND_PORTRAIT_H

#include "top/balanced.h"
#include "top/counterpart.h"
#include "cli/session.h"

typedef enum {
    JLT_PORTRAIT_ATTRACTED, /* followed to an attracting fixed point */
    JLT_PORTRAIT_POLE_PLUS,
    JLT_PORTRAIT_POLE_MINUS,
    JLT_PORTRAIT_WANDERING, /* none of these within the time */
    JLT_PORTRAIT_FATES
} jlt_portrait_fate;

typedef struct {
    jlt_session session;
    jlt_assign_list level;
    const char *trajectories; /* file for the orbits */
    size_t orbits;
    double until;

    jlt_counterpart counterpart;  /* of the model asked for */
    jlt_top top;                  /* with the general field and the parameters of JLT_DEFAULT_MODEL */
    const jlt_descriptor *model;
    double params[JLT_WAY_VALUES_MAX];
    double start[JLT_TOP_STATES]; /* all 0 if levels are given */
    jlt_balanced_levels levels;
    jlt_fixed_point fixed[4];
    unsigned fixed_count;
    bool fixed_curve;         /* the fixed points are not isolated */
    size_t fates[JLT_PORTRAIT_FATES];
} jlt_portrait_request;

/** Plot the orbits that were collected. Prints an error message on failure. */
jlt_exit jlt_portrait_draw(const jlt_portrait_request *request);

#endif
