#include "cli/section_many.h"

#include "integrate/batch_method.h"
#include "kernel/batch_isa.h"

jlt_exit jlt_section_many_open(jlt_section_batch **batch, jlt_section_batch_options *options, const jlt_system *system, bool project)
{
    const jlt_descriptor *d = system->instance->descriptor;

    if (jlt_batch_isa_best(d, 0) == NULL)
        return jlt_command_fail(JLT_EXIT_USAGE, "--batch: the kernels of %s follow one orbit at a time: leave out --batch", d->model);
    if (system->flow.chart->turn != 0)
        return jlt_command_fail(JLT_EXIT_USAGE, "--batch: not where the section's state is an angle: leave out --batch");
    if (system->flow.chart->level != 0)
        return jlt_command_fail(JLT_EXIT_USAGE, "--batch: sections STATE=0 alone: leave out --batch for %s=%.10g",
                                d->states[system->flow.chart->column].name, system->flow.chart->level);
    if (d->state_count > JLT_BATCH_STATES_MAX)
        return jlt_command_fail(JLT_EXIT_USAGE, "--batch: %s has %u states; batches serve up to %d: leave out --batch", d->model, d->state_count,
                                JLT_BATCH_STATES_MAX);
    const jlt_exit code = project ? jlt_common_project(d) : JLT_EXIT_DONE;
    if (code != JLT_EXIT_DONE) return code;
    if (project && d->integral_count == JLT_INVARIANTS_MAX)
        return jlt_command_fail(JLT_EXIT_USAGE, "--project: %s has %u integrals, of which batches serve fewer", d->model, d->integral_count);
    options->project = project ? d->integral_count : 0;
    const jlt_status st = jlt_section_batch_create(batch, &system->flow, jlt_batch_isa_best(d, 0), options);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "section");
}

void jlt_section_many_line(FILE *file, const char *before, const jlt_motion_options *options, const jlt_system *system, bool project)
{
    const jlt_kernel_batch *kernels = jlt_batch_isa_best(system->instance->descriptor, 0);

    fprintf(file, "%s many orbits at once by %s on %s, lanes %u%s; %s from where an orbit comes near a pole\n", before,
            jlt_batch_method_for(options->flow.tolerance)->name, kernels->isa, kernels->lanes, project ? ", projected at crossings" : "",
            options->flow.method->name);
}
