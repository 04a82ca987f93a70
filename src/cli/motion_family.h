/** The family of systems that a command line describes when some of its parameters and levels run over ranges. */
#ifndef JLT_CLI_MOTION_FAMILY_H
#define JLT_CLI_MOTION_FAMILY_H

#include "cli/motion_plane.h"

enum { JLT_FAMILY_AXES_MAX = 3 };

typedef struct {
    jlt_motion_plane plane;     /* for a section STATE=VALUE */
    const jlt_system *system;   /* the one it was opened for, whose typical sizes of coordinates all its systems get */
    const jlt_surface *surface; /* for a section that tables describe; NULL: `plane` is in use, and the next two members are not */
    double values[JLT_CHART_VALUES_MAX];
    jlt_flow flow;
    double *entries[JLT_FAMILY_AXES_MAX]; /* by axis, pointers to the values that run; write there, then call _make */
    jlt_system_family systems;            /* the same family as a function of the first axis alone, for continuation */
    unsigned no_angle;                    /* as jlt_motion_plane_make sets it, for the last system made */
} jlt_motion_family;

/** Open the family. In: system, the one that the options describe; both must outlive the family. axes, shape (count,): what runs;
 *  only the names are read. option: the option that named them, for messages. *out must not move; clear it in any case. */
jlt_exit jlt_motion_family_open(jlt_motion_family *out, const jlt_system *system, const jlt_motion_options *options,
                                const jlt_grid_axis *axes, size_t count, const char *option);
void jlt_motion_family_clear(jlt_motion_family *family);

/** Make the system for the values that `entries` point to. Out: *out, for jlt_system_destroy. Errors: as jlt_motion_plane_make and
 *  jlt_surface_system. */
JLT_CHECKED jlt_status jlt_motion_family_make(jlt_motion_family *family, jlt_system **out);

/** Whether _make has failed last because a state that --modulo calls an angle is none at these values. */
bool jlt_motion_family_no_angle(const jlt_motion_family *family);

/** Print why _make returned `status`: "OPTION: at NAME=VALUE, ...: reason". axes: as in _open. Returns the exit status for it. */
jlt_exit jlt_motion_family_fail(const jlt_motion_family *family, jlt_status status, const char *option, const jlt_grid_axis *axes,
                                size_t count);

#endif
