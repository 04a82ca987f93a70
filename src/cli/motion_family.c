#include "cli/motion_family.h"

#include "dynamics/scale.h"
#include "dynamics/surface_units.h"
#include "kernel/descriptor.h"

#include <string.h>

jlt_status jlt_motion_family_make(jlt_motion_family *self, jlt_system **out)
{
    jlt_status st = self->surface != NULL ? jlt_surface_system(out, self->surface, self->values, &self->flow)
                                          : jlt_motion_plane_make(&self->plane, out, &self->no_angle);

    if (st == JLT_OK && self->surface != NULL && jlt_surface_units_named(self->surface->section))
        st = jlt_surface_count_in(*out, &self->system->units);
    if (st == JLT_OK) jlt_scale_copy(*out, self->system);
    return st;
}

static jlt_status make_at(void *context, jlt_system **out, double value, const jlt_system *near)
{
    jlt_motion_family *self = context;

    *self->entries[0] = value;
    if (self->surface == NULL || near == NULL) return jlt_motion_family_make(self, out);
    JLT_PASS(jlt_surface_system_near(out, near, self->values, &self->flow));
    jlt_scale_copy(*out, near);
    return JLT_OK;
}

bool jlt_motion_family_no_angle(const jlt_motion_family *self)
{
    return self->surface == NULL && self->no_angle < self->plane.descriptor->state_count;
}

jlt_exit jlt_motion_family_fail(const jlt_motion_family *self, jlt_status status, const char *option, const jlt_grid_axis *axes,
                                size_t count)
{
    const jlt_region *region;
    double value;
    size_t index;
    char where[256];
    size_t used = (size_t)snprintf(where, sizeof where, "%s: at", option);

    for (size_t i = 0; i < count && used < sizeof where; i++)
        used += (size_t)snprintf(where + used, sizeof where - used, "%s %s=%.10g", i == 0 ? "" : ",", axes[i].name,
                                 *self->entries[i]);
    if (self->surface != NULL) return jlt_motion_refuse(self->surface, self->values, status, where);
    if (jlt_motion_family_no_angle(self))
        return jlt_command_fail(JLT_EXIT_INPUT, "%s, growing %s by its period changes the equations: narrow the range, or add "
                                "--modulo %s=0", where, self->plane.descriptor->states[self->no_angle].name,
                                self->plane.descriptor->states[self->no_angle].name);
    if (status == JLT_ERR_DOMAIN && jlt_descriptor_check_params(self->plane.descriptor, self->plane.params, &index) != JLT_OK)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: %s needs %s%s", where, self->plane.descriptor->model,
                                self->plane.descriptor->params[index].name,
                                jlt_descriptor_condition(&self->plane.descriptor->params[index]));
    if (status == JLT_ERR_DOMAIN && jlt_region_check(&region, &value, self->plane.descriptor, self->plane.params, NULL) == status)
        return jlt_assign_refuse_region(where, self->plane.descriptor, region, value);
    return jlt_motion_no_plane(status, where);
}

/* Refuse a name that cannot run, and print those that can. */
static jlt_exit refuse(const jlt_motion_family *self, const jlt_descriptor *d, const char *name, const char *option)
{
    if (self->surface != NULL) {
        fprintf(stderr, "jellett: %s: there is no '%s'; there are", option, name);
        for (unsigned i = 0; i < self->surface->count; i++) fprintf(stderr, "%s %s", i == 0 ? "" : ",", self->surface->names[i]);
        fputc('\n', stderr);
        return JLT_EXIT_INPUT;
    }
    for (unsigned i = 0; i < d->integral_count; i++)
        if (strcmp(d->integrals[i].name, name) == 0)
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: to vary the level %s, fix it first: add --level %s=VALUE --solve "
                                    "STATE=GUESS", option, name, name);
    return jlt_motion_plane_refuse(d, name, option);
}

static double *entry_of(jlt_motion_family *self, const char *name)
{
    const unsigned index = self->surface != NULL ? jlt_surface_value(self->surface, name) : 0;

    if (self->surface == NULL) return jlt_motion_plane_value(&self->plane, name);
    return index < self->surface->count ? &self->values[index] : NULL;
}

jlt_exit jlt_motion_family_open(jlt_motion_family *out, const jlt_system *system, const jlt_motion_options *options,
                                const jlt_grid_axis *axes, size_t count, const char *option)
{
    const jlt_descriptor *d = system->instance->descriptor;
    jlt_exit code = JLT_EXIT_DONE;

    *out = (jlt_motion_family){ .system = system, .surface = system->surface, .flow = options->flow };
    out->systems = (jlt_system_family){ .make = make_at, .context = out };
    if (out->surface != NULL) memcpy(out->values, system->values, out->surface->count * sizeof *out->values);
    else code = jlt_motion_plane_read(&out->plane, options, jlt_descriptor_sibling(d, NULL, d->time, NULL), axes, count);
    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++) {
        out->entries[i] = entry_of(out, axes[i].name);
        if (out->entries[i] == NULL) code = refuse(out, d, axes[i].name, option);
    }
    return code;
}

void jlt_motion_family_clear(jlt_motion_family *family)
{
    jlt_system_family_clear(&family->systems);
    jlt_motion_plane_clear(&family->plane);
}
