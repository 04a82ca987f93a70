#include "cli/motion_many.h"

#include "cli/interrupt.h"
#include "dynamics/section_flows.h"
#include "integrate/batch_method.h"
#include "kernel/batch_isa.h"

enum { THREADS = 1200 };

static const struct argp_option option_table[] = {
    { "threads", THREADS, "N", 0,
      "Use N threads; default: all processors, or as many as OMP_NUM_THREADS says. Rows do not depend on N", 11 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_motion_options *options = state->input;

    if (key != THREADS) return ARGP_ERR_UNKNOWN;
    jlt_common_count(&options->threads, value, 1, 1024, "--threads");
    return 0;
}

const struct argp jlt_motion_many_argp = { option_table, parse, NULL, NULL, NULL, NULL, NULL };

void jlt_motion_many_begin(jlt_motion_options *options)
{
    options->threads = jlt_common_processors();
    options->flow.method = NULL;
}

void jlt_motion_many_choose(jlt_motion_options *options, bool many, bool project)
{
    options->many = options->common.lanes = many && options->flow.method == NULL;
    options->project = project;
    if (options->flow.method == NULL) options->flow.method = jlt_method_find(NULL);
}

void jlt_motion_many_settle(jlt_motion_options *options, const jlt_system *system)
{
    const jlt_descriptor *d = system->instance->descriptor;

    options->alone = options->many ? jlt_section_flows_obstacle(&system->flow, jlt_batch_isa_best(d, 0)) : NULL;
    if (options->many && options->project && options->alone == NULL && system->flow.chart->roots > 0)
        options->alone = "with --project its lifted root is put back after every step";
    options->in_lanes = options->many && options->alone == NULL;
}

/* Set up the projection onto levels: lanes project orbits at crossings, a single orbit is projected after every step, and so is one
 * that a lane leaves to the flow's own method. */
static jlt_exit set_projection(jlt_section_batch_options *batch_options, const jlt_motion_options *options, jlt_system *system)
{
    const jlt_descriptor *d = system->instance->descriptor;
    jlt_exit code;

    if (!options->in_lanes && system->surface != NULL && options->alone == NULL)
        return jlt_command_fail(JLT_EXIT_USAGE, "--project works on this section only without --method: leave out --method");
    if (!options->in_lanes && system->surface != NULL)
        return jlt_command_fail(JLT_EXIT_USAGE,
                                "--project works on this section only in lanes, and %s: ask for one of the table itself, --section "
                                "STATE=VALUE, with all other states as coordinates (--level and --solve leave fewer)",
                                options->alone);
    if (!options->in_lanes) return jlt_motion_project(system);
    code = jlt_common_project(d);
    if (code == JLT_EXIT_DONE && d->integral_count == JLT_INVARIANTS_MAX)
        return jlt_command_fail(JLT_EXIT_USAGE, "--project: lanes serve at most %d integrals, and %s has %u: add --method gauss%s",
                                JLT_INVARIANTS_MAX - 1, d->model, d->integral_count,
                                system->surface != NULL ? " and --section STATE=VALUE" : "");
    batch_options->project = system->instance;
    return code == JLT_EXIT_DONE && system->surface == NULL ? jlt_motion_project(system) : code;
}

jlt_exit jlt_motion_many_open(jlt_section_batch **batch, jlt_section_batch_options *batch_options,
                              const jlt_motion_options *options, jlt_system *system)
{
    JLT_PASS(options->project ? set_projection(batch_options, options, system) : JLT_EXIT_DONE);
    batch_options->threads = (unsigned)options->threads;
    batch_options->watches = true;
    jlt_interrupt_spare(options->threads);
    const jlt_kernel_batch *kernels = options->in_lanes ? jlt_batch_isa_best(system->instance->descriptor, 0) : NULL;
    const jlt_status st = jlt_section_batch_create(batch, &system->flow, kernels, batch_options);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "section");
}

void jlt_motion_many_line(FILE *file, const char *before, const jlt_motion_options *options, const jlt_system *system)
{
    const jlt_kernel_batch *kernels = jlt_batch_isa_best(system->instance->descriptor, 0);

    if (options->alone != NULL)
        fprintf(file, "%s one orbit at a time by %s: %s\n", before, options->flow.method->name, options->alone);
    if (!options->in_lanes) return;
    fprintf(file,
            "%s many orbits at once by %s on %s, lanes %u%s; %s %sfrom where an orbit comes near a pole, or where steps err\n",
            before, jlt_batch_method_for(options->flow.tolerance)->name, kernels->isa, kernels->lanes,
            options->project ? ", projected at crossings" : "", options->flow.method->name,
            system->flow.end_where_invalid ? "for orbits that lose a condition, " : "");
}
