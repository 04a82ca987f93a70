/* Makes the system that the options describe, on a section that tables describe or on a plane section; and prints its plan. */
#include <string.h>

#include "cli/motion_many.h"
#include "cli/motion_plane.h"
#include "cli/planned.h"

jlt_exit jlt_motion_system(jlt_system **system, jlt_motion_options *options)
{
    jlt_surface surface;
    bool has_surface;

    *system = NULL;
    JLT_PASS(jlt_common_model(&options->common, &options->asked));
    if (strcmp(options->contact, "ignore") != 0 && options->asked->family[0]->valid_count == 0)
        return jlt_command_fail(JLT_EXIT_USAGE, "--contact %s: %s has no record 'valid': leave out --contact",
                                options->contact, options->asked->model);
    JLT_PASS(jlt_motion_surface(&surface, &has_surface, options, options->asked));
    JLT_PASS(has_surface ? jlt_motion_surface_system(system, options, &surface)
                         : jlt_motion_plane_system(system, options, options->asked));
    jlt_motion_many_settle(options, *system);
    return JLT_EXIT_DONE;
}

jlt_exit jlt_motion_plan(const jlt_system *system, const jlt_motion_options *options)
{
    return options->common.plan ? jlt_planned_motion(system, options) : JLT_EXIT_DONE;
}
