/** The systems of a command line as one of its parameters or levels runs. */
#ifndef JLT_CLI_MOTION_FAMILY_H
#define JLT_CLI_MOTION_FAMILY_H

#include "cli/motion_plane.h"

typedef struct {
    jlt_motion_plane plane;
    jlt_top_family top; /* of the spherical top instead */
    double *entry;      /* the value; at first that of the options */
    jlt_system_family systems;
} jlt_motion_family;

/** system: the one that the options describe; they must stay. *out must not move, and is cleared after, whatever is returned. Says
 *  what is wrong. */
jlt_exit jlt_motion_family_open(jlt_motion_family *out, const jlt_system *system, const jlt_motion_options *options,
                                const char *name);
void jlt_motion_family_clear(jlt_motion_family *family);

#endif
