/* Makes the system that the options describe, on a section that tables describe or on a plane section; or prints its plan. */
#include "cli/motion_many.h"
#include "cli/motion_plane.h"
#include "cli/planned.h"

jlt_exit jlt_motion_system(jlt_system **system, jlt_motion_options *options)
{
    const jlt_descriptor *descriptor;
    jlt_surface surface;
    bool has_surface;

    *system = NULL;
    JLT_PASS(jlt_common_model(&options->common, &descriptor));
    JLT_PASS(jlt_motion_surface(&surface, &has_surface, options, descriptor));
    JLT_PASS(has_surface ? jlt_motion_surface_system(system, options, &surface)
                         : jlt_motion_plane_system(system, options, descriptor));
    jlt_motion_many_settle(options, *system);
    return options->common.plan ? jlt_planned_motion(*system, options, descriptor) : JLT_EXIT_DONE;
}
