/* Messages where an orbit, a return or a search fails. */
#include "cli/motion.h"

#include <math.h>

/* Whether the method ended so because it was interrupted. */
static bool interrupted(jlt_status status, const jlt_system *system)
{
    return status == JLT_ERR_NO_CONVERGENCE && system != NULL && system->flow.interrupt != NULL && *system->flow.interrupt;
}

jlt_exit jlt_motion_fail(jlt_status status, const jlt_system *system, const char *what)
{
    double low, high;

    if (interrupted(status, system)) return jlt_command_fail(JLT_EXIT_NUMERICAL, "interrupted; nothing is saved");
    for (unsigned k = 0; status == JLT_ERR_EMPTY && system != NULL && system->surface != NULL && k < system->flow.chart->dim; k++)
        if (jlt_surface_interval(system, k, &low, &high))
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: no state has these levels there; %s may lie in (%.10g, %.10g)", what,
                                    system->flow.chart->names[k], low, high);
    if (status == JLT_ERR_EMPTY && system != NULL && system->flow.chart->solved_count > 0)
        return jlt_command_fail(JLT_EXIT_NUMERICAL,
                                "%s: Newton's method finds no state with these levels there: try another guess in "
                                "--solve, or other coordinates",
                                what);
    if (status == JLT_ERR_NO_CONVERGENCE && system != NULL && system->flow.chart->solved_count > 0)
        return jlt_command_fail(JLT_EXIT_NUMERICAL,
                                "%s: %s, or a return left the branch of --solve, or, where an integral grows with an angle, the "
                                "levels: try another --direction or section", what, jlt_status_text(status));
    if (status == JLT_ERR_BUDGET && system != NULL)
        return jlt_command_fail(JLT_EXIT_NUMERICAL,
                                "%s: %s on one return, which lasts too long (--max-steps allows more), or whose motion is stiff: "
                                "no --method here is made for that ('jellett simulate' tells which)",
                                what, jlt_status_text(status));
    if (status == JLT_ERR_NO_PROGRESS && system != NULL)
        return jlt_command_fail(JLT_EXIT_NUMERICAL,
                                "%s: %s on one return: the orbit runs into a singularity, or hardly ever meets the section "
                                "('jellett simulate' tells which)",
                                what, jlt_status_text(status));
    if (status == JLT_ERR_DOMAIN && system != NULL && system->surface != NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: the orbit ends before it returns: take another start ('jellett fates' shows "
                                "which return), unless a rate jumps on the way, as dry friction does", what);
    if (status == JLT_ERR_DOMAIN && system != NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: the map has no derivative there: the orbit crosses the section the other way "
                                "(--direction), leaves the model's domain, or does not come back ('jellett section' tells which), "
                                "or a rate jumps on the way, as dry friction does",
                                what);
    if (status == JLT_ERR_UNSUPPORTED && system != NULL)
        return system->flow.end_where_invalid
                   ? jlt_command_fail(JLT_EXIT_INPUT, "--contact end: %s has more records 'valid' than can end an orbit: take "
                                      "--contact report", system->instance->descriptor->model)
                   : jlt_common_no_kernels(system->instance->descriptor, system->flow.method);
    return jlt_command_fail(jlt_command_exit(status), "%s: %s", what, jlt_status_text(status));
}

jlt_exit jlt_motion_no_plane(jlt_status status, const char *what)
{
    if (status != JLT_ERR_EMPTY) return jlt_motion_fail(status, NULL, what);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s: the levels do not determine the states of --solve: one follows from the others, "
                            "or a state is in none of their integrals", what);
}

/* Whether the table proves a reversor that takes the section to itself, whatever it does to the coordinates. */
static bool has_reversor(const jlt_system *system)
{
    const jlt_descriptor *general = system->instance->descriptor->family[0];

    for (unsigned i = 0; i < general->reversor_count; i++) {
        const jlt_reversor *reversor = &general->reversors[i];
        if (reversor->signs[system->flow.chart->column] < 0 && general->claims[reversor->claim].verdict == JLT_PROVED) return true;
    }
    return false;
}

jlt_exit jlt_motion_no_reversor(const jlt_system *system, const char *what)
{
    const jlt_chart *chart = system->flow.chart;
    const jlt_descriptor *d = system->instance->descriptor;

    if (!jlt_chart_is_mirrored(chart))
        return jlt_command_fail(JLT_EXIT_INPUT, "%s, which changes of signs do at STATE = 0 alone%s, not at %s = %.10g: take "
                                "another --section, as %s=0",
                                what, chart->turn != 0 ? " and half a turn from it" : "", d->states[chart->column].name,
                                ldexp(chart->level, system->flow.units.state[chart->column]), d->states[chart->column].name);
    if (chart->reversible) return jlt_command_fail(JLT_EXIT_INPUT, "%s: that of %s keeps other lines", what, d->model);
    if (system->surface != NULL && has_reversor(system))
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: that of %s does more to the coordinates of %s than change signs: take another "
                                "--section", what, d->model, system->surface->section->name);
    if (chart->turns_over)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: the reversor changes the sign of a state of --solve, and so leads to another "
                                "branch: solve for states that it keeps", what);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s: write 'reversor STATE -> -STATE' in the table of %s%s", what, d->model,
                            system->surface == NULL ? ", or --mirror STATE,..." : "");
}

jlt_exit jlt_motion_failures(const jlt_system *system, const jlt_failures *failures, size_t orbits)
{
    if (failures->spent > 0)
        fprintf(stderr,
                "jellett: %zu of %zu orbits ended by budget, all steps or time spent on one return: it lasts too long "
                "(--max-steps allows more), never comes, cannot be told from errors where an orbit settles on the section, or the "
                "motion is stiff ('jellett simulate' tells which)\n",
                failures->spent, orbits);
    if (failures->count == 0) return JLT_EXIT_DONE;
    if (failures->unbounded > 0)
        fprintf(stderr, "jellett: in %zu of %zu orbits a state seems to grow without bound: in the first of them %s, towards "
                        "t = %.10g\n", failures->unbounded, orbits, system->instance->descriptor->states[failures->state].name,
                failures->t);
    return jlt_command_fail(JLT_EXIT_NUMERICAL, "the method failed on %zu of %zu orbits; the rows tell on which, or on how many",
                            failures->count, orbits);
}
