/** The section of a table that --section, --level, --solve, --modulo and --mirror describe: the options are read once, and
 *  systems are made from them for any values of parameters and levels. */
#ifndef JLT_CLI_MOTION_PLANE_H
#define JLT_CLI_MOTION_PLANE_H

#include "cli/motion.h"

typedef struct {
    const jlt_descriptor *descriptor;
    double *params; /* (param_count,), owned */
    jlt_flow flow;
    jlt_grid_axis section;
    size_t column;
    bool mirrored;
    int signs[JLT_CHART_STATES_MAX];      /* these two in the order of the table's states */
    double periods[JLT_CHART_STATES_MAX]; /* 0: none */
    jlt_level levels[JLT_INVARIANTS_MAX];
    unsigned level_count;
} jlt_motion_plane;

/** Says what is wrong. running: parameters and levels whose values will change, shape (count,), of which names are read. Zero
 *  *out before, clear it after. */
jlt_exit jlt_motion_plane_read(jlt_motion_plane *out, const jlt_motion_options *options, const jlt_descriptor *descriptor,
                               const jlt_grid_axis *running, size_t count);
void jlt_motion_plane_clear(jlt_motion_plane *plane);

/** Where the value of a parameter or level stands; NULL: there is none of this name. */
double *jlt_motion_plane_value(jlt_motion_plane *plane, const char *name);

/** The system, for jlt_system_destroy. *no_angle gets the state whose period the field has not, else the number of states.
 *  Errors: as jlt_system_plane, jlt_system_angles and jlt_system_levels. */
JLT_CHECKED jlt_status jlt_motion_plane_make(const jlt_motion_plane *plane, jlt_system **system, unsigned *no_angle);

/** Both at once. Says what is wrong. */
jlt_exit jlt_motion_plane_system(jlt_system **system, const jlt_motion_options *options, const jlt_descriptor *descriptor);

#endif
