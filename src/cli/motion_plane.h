/** A plane section STATE=VALUE of a table, as --section, --level, --solve, --modulo and --mirror describe it. The options are read
 *  once; systems are then made for any values of parameters and levels. */
#ifndef JLT_CLI_MOTION_PLANE_H
#define JLT_CLI_MOTION_PLANE_H

#include "cli/motion.h"

typedef struct {
    const jlt_descriptor *descriptor; /* the most special of the table's fields that holds for all values that are to run */
    double *params;        /* (param_count,), owned */
    jlt_flow flow;
    jlt_grid_axis section; /* --section STATE=VALUE */
    size_t column;         /* index of that state */
    bool mirrored;         /* `signs` is a reversor, from --mirror or proved in the table */
    int signs[JLT_CHART_STATES_MAX];      /* by state, +1 or -1 */
    double periods[JLT_CHART_STATES_MAX]; /* by state; 0: it is not an angle */
    jlt_level levels[JLT_INVARIANTS_MAX];
    unsigned level_count;
    double sizes[JLT_CHART_STATES_MAX]; /* by state, the largest absolute value typed in --section, --solve, --start and --grid */
} jlt_motion_plane;

/** Read the options. running, shape (count,): the parameters and levels whose values will change later; only their names are read.
 *  *out must be zeroed before the call and cleared after it, whatever is returned. */
jlt_exit jlt_motion_plane_read(jlt_motion_plane *out, const jlt_motion_options *options, const jlt_descriptor *descriptor,
                               const jlt_grid_axis *running, size_t count);
void jlt_motion_plane_clear(jlt_motion_plane *plane);

/** A pointer to the value of the parameter or level of this name, through which the caller may change it; NULL: there is none. */
double *jlt_motion_plane_value(jlt_motion_plane *plane, const char *name);

/** Refuse, after `option`, a name that is neither a parameter nor an integral of the table, and print those that are. Returns
 *  INPUT. */
jlt_exit jlt_motion_plane_refuse(const jlt_descriptor *d, const char *name, const char *option);

/** Make the system from the current values. Out: *system, for jlt_system_destroy; *no_angle, the index of a state that --modulo
 *  calls an angle although the field does not have its period, or the number of states if there is none. Errors: as
 *  jlt_system_plane, jlt_system_angles and jlt_system_levels. */
JLT_CHECKED jlt_status jlt_motion_plane_make(const jlt_motion_plane *plane, jlt_system **system, unsigned *no_angle);

/** Read the options and make the system. Out: *system, for jlt_system_destroy. */
jlt_exit jlt_motion_plane_system(jlt_system **system, const jlt_motion_options *options, const jlt_descriptor *descriptor);

#endif
