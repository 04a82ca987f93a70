/** The systems that a command line describes while some of its parameters and levels run over their ranges. */
#ifndef JLT_CLI_MOTION_FAMILY_H
#define JLT_CLI_MOTION_FAMILY_H

#include "cli/motion_plane.h"

enum { JLT_FAMILY_AXES_MAX = 3 };

typedef struct {
    jlt_motion_plane plane;
    const jlt_surface *surface; /* of a section that tables describe instead: its values, and the flow */
    double values[JLT_CHART_VALUES_MAX];
    jlt_flow flow;
    double *entries[JLT_FAMILY_AXES_MAX]; /* the values that run, in the order of the axes; at first those of the options */
    jlt_system_family systems;            /* as the first of them runs */
    unsigned no_angle;                    /* the state that was none when the last system was made, else the number of states */
} jlt_motion_family;

/** system: the one that the options describe; they must stay. axes: what runs, shape (count,), of which names are read; option:
 *  for messages. *out must not move, and is cleared after, whatever is returned. Says what is wrong. */
jlt_exit jlt_motion_family_open(jlt_motion_family *out, const jlt_system *system, const jlt_motion_options *options,
                                const jlt_grid_axis *axes, size_t count, const char *option);
void jlt_motion_family_clear(jlt_motion_family *family);

/** The system at the entries as they stand, for jlt_system_destroy. Errors: as jlt_motion_plane_make and jlt_surface_system. */
JLT_CHECKED jlt_status jlt_motion_family_make(jlt_motion_family *family, jlt_system **out);

/** Why that failed: "OPTION: at NAME=VALUE, ...: reason". axes: as for open. */
jlt_exit jlt_motion_family_fail(const jlt_motion_family *family, jlt_status status, const char *option, const jlt_grid_axis *axes,
                                size_t count);

#endif
