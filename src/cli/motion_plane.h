/** The section of a table that --section, --level, --solve, --modulo and --mirror describe: the options are read once, and
 *  systems are made from them for any values of parameters and levels. */
#ifndef JLT_CLI_MOTION_PLANE_H
#define JLT_CLI_MOTION_PLANE_H

#include "cli/motion.h"

typedef struct {
    const jlt_descriptor *descriptor; /* the table's general field */
    double *params;        /* (param_count,), owned */
    jlt_flow flow;
    jlt_grid_axis section; /* --section STATE=VALUE */
    size_t column;         /* which state that is */
    bool mirrored;         /* --mirror was given, or the table proves a reversor: `signs` has it */
    int signs[JLT_CHART_STATES_MAX];      /* by state, +1 or -1 */
    double periods[JLT_CHART_STATES_MAX]; /* by state; 0: it is no angle */
    jlt_level levels[JLT_INVARIANTS_MAX];
    unsigned level_count;
    double sizes[JLT_CHART_STATES_MAX]; /* the largest value of each state where orbits begin, as far as it is typed */
} jlt_motion_plane;

/** Read the options. running: parameters and levels whose values will change later, shape (count,), of which only names are read.
 *  *out is all zeros before; clear it after, whatever is returned. */
jlt_exit jlt_motion_plane_read(jlt_motion_plane *out, const jlt_motion_options *options, const jlt_descriptor *descriptor,
                               const jlt_grid_axis *running, size_t count);
void jlt_motion_plane_clear(jlt_motion_plane *plane);

/** Where the value of the parameter or level of this name stands, to be changed there; NULL: there is none. */
double *jlt_motion_plane_value(jlt_motion_plane *plane, const char *name);

/** Make the system from the values as they stand. Out: *system, for jlt_system_destroy; *no_angle, the state that --modulo calls an
 *  angle although the field has not its period, else the number of states.
 *  Errors: as jlt_system_plane, jlt_system_angles and jlt_system_levels. */
JLT_CHECKED jlt_status jlt_motion_plane_make(const jlt_motion_plane *plane, jlt_system **system, unsigned *no_angle);

/** Read the options and make the system. Out: *system, for jlt_system_destroy. */
jlt_exit jlt_motion_plane_system(jlt_system **system, const jlt_motion_options *options, const jlt_descriptor *descriptor);

#endif
