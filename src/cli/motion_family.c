#include "cli/motion_family.h"

#include "kernel/descriptor.h"

#include <string.h>

static jlt_status make_plane(void *context, jlt_system **out, double value)
{
    jlt_motion_family *self = context;
    unsigned no_angle;

    *self->entry = value;
    return jlt_motion_plane_make(&self->plane, out, &no_angle);
}

/* Names of what may run. */
static jlt_exit refuse(const jlt_motion_family *self, const jlt_system *system, const char *name)
{
    const jlt_descriptor *d = system->instance->descriptor;

    if (system->is_top)
        return jlt_command_fail(JLT_EXIT_INPUT, "--along: there is no '%s'; there are m, R, g, I1, I3, a3, E, G", name);
    for (unsigned i = 0; i < d->integral_count; i++)
        if (strcmp(d->integrals[i].name, name) == 0)
            return jlt_command_fail(JLT_EXIT_INPUT, "--along: the level of %s runs from a value: --level %s=VALUE, with --solve", name, name);
    fprintf(stderr, "jellett: --along: there is no '%s'; there are the parameters", name);
    for (unsigned i = 0; i < d->param_count; i++) fprintf(stderr, "%s %s", i == 0 ? "" : ",", d->params[i].name);
    fputs(d->param_count == 0 ? " (none)" : "", stderr);
    for (unsigned i = 0; i < self->plane.level_count; i++)
        fprintf(stderr, "%s %s", i == 0 ? ", and of --level" : ",", self->plane.descriptor->integrals[self->plane.levels[i].integral].name);
    fputc('\n', stderr);
    return JLT_EXIT_INPUT;
}

jlt_exit jlt_motion_family_open(jlt_motion_family *out, const jlt_system *system, const jlt_motion_options *options,
                                const char *name)
{
    const jlt_descriptor *d = system->instance->descriptor;
    jlt_exit code = JLT_EXIT_DONE;

    *out = (jlt_motion_family){ .entry = NULL };
    if (system->is_top) {
        out->top = (jlt_top_family){ .values = system->values, .name = name, .options = options->flow };
        out->entry = jlt_system_value(&out->top.values, name);
        out->systems = (jlt_system_family){ .make = jlt_system_top_at, .context = &out->top };
    } else {
        code = jlt_motion_plane_read(&out->plane, options, jlt_descriptor_sibling(d, NULL, d->time, NULL), name);
        if (code == JLT_EXIT_DONE) out->entry = jlt_motion_plane_value(&out->plane, name);
        out->systems = (jlt_system_family){ .make = make_plane, .context = out };
    }
    if (code != JLT_EXIT_DONE) return code;
    return out->entry != NULL ? JLT_EXIT_DONE : refuse(out, system, name);
}

void jlt_motion_family_clear(jlt_motion_family *family)
{
    jlt_system_family_clear(&family->systems);
    jlt_motion_plane_clear(&family->plane);
}
