/* `jellett section`: returns of orbits to a section, with fates and a picture. */
#include "base/options.h"
#include "cli/section_run.h"
#include "cli/shelf.h"
#include "cli/swept.h"

#include <stdint.h>
#include <stdlib.h>

enum { SKIP = 2000, BACKWARD, CHECK, PROJECT };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", TTC_OPTIONS_REPEATED,
      "A start on the section: a value for every coordinate; may be repeated", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0,
      "A grid of starts over the whole section, or over NAME=LOW:HIGH:COUNT,...; points where no state has the levels are "
      "left out", 1 },
    { "returns", 'n', "N", 0, "Follow every orbit for N returns; default 100", 1 },
    { "skip", SKIP, "N|0", 0,
      "Leave out the rows of the start and of N returns before those of --returns; an orbit that ends among them still has its "
      "last row; default 0", 1 },
    { "backward", BACKWARD, NULL, 0, "Follow orbits backwards in time", 1 },
    { "check", CHECK, NULL, 0,
      "Compute the derivative DP of every return by the variational equations, and compare its determinant with that from "
      "the flux through the section and the integral of the divergence", 1 },
    { "project", PROJECT, NULL, 0,
      "Put orbits back onto the levels that the integrals have at the start: in lanes at every crossing, otherwise after "
      "every step", 2 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_contact_argp, 0, NULL, 0 },
                                              { &jlt_motion_many_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_section_run_options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'a': o->motion.starts[o->motion.start_count++] = value; return 0;
    case 'g': jlt_motion_typed(o->motion.grid = value, "--grid"); return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, SIZE_MAX / 4, "--returns"); return 0;
    case SKIP: jlt_common_count(&o->skip, value, 0, SIZE_MAX / 4, "--skip"); return 0;
    case BACKWARD: o->time_direction = -1; return 0;
    case CHECK: o->check = true; return 0;
    case PROJECT: o->project = true; return 0;
    case ARGP_KEY_END:
        if (o->motion.start_count == 0 && o->motion.grid == NULL)
            jlt_common_incomplete(&o->motion.common, state, "say where to start: --start or --grid");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Compute the Poincare map: the returns of orbits to a section, and how orbits end. The spherical top has a section of its "
    "own, at levels of E and G. For another model, --section STATE=VALUE takes all its other states as coordinates, or fewer "
    "with --level and --solve."
    "\vColumns:\n"
    "  orbit, return     numbers from 0; return 0 is the start\n"
    "  t                 time\n"
    "  COORDINATE        each coordinate of the section\n"
    "  QUANTITY          further quantities that the table shows at returns; of the\n"
    "                    spherical top three velocities\n"
    "  fate              alive, or how the orbit ended\n"
    "  NAME_min          with --contact report: the least value so far\n"
    "  trace, det, divergence, defect: with --check (below)\n\n"
    "An orbit that ends has one more row, with its fate. In that row coordinates that are angles are empty, on a section "
    "STATE=VALUE all of them, and so is what the levels do not determine at a pole.\n\n"
    "Fates:\n"
    "  pole+, pole-      the axis is vertical; the velocities are the limits\n"
    "  lost_NAME         with --contact end: this condition of the model breaks;\n"
    "                    lost_contact: the plane would have to pull the top\n"
    "  equilibrium       the orbit has come to rest, to within 1000 tolerances, by\n"
    "                    the time t, which depends on steps; the values are the\n"
    "                    limits\n"
    "  left_domain       the model's domain ends there\n"
    "  budget            one return took more than --max-steps, or the orbit has\n"
    "                    settled on the section, to within 10 tolerances\n"
    "  nonfinite, no_convergence, no_progress: the method failed\n\n"
    "Where the method failed, the exit status is 4; all other orbits are written. Where an integral that the table "
    "proves changes by more than a thousand errors of one tolerance a return, as on a pass close to a singularity, the worst such "
    "return is named at the end, with what it differs by at another tolerance.\n\n"
    "With --check: trace and det of DP at that return; divergence, its integral on the levels; and defect, which is det - "
    "flux(start)/flux(end)*exp(divergence), relative to the size of DP. The exit status is 1 when a defect is larger than an "
    "error of one tolerance a step explains, or when DP cannot be computed at a return that has one. That bound is wide where the "
    "section is crossed slowly. DP of many returns is computed in lanes; the bound there is that of one step, and where it does "
    "not hold DP is computed alone.\n\n"
    "Two or more orbits are followed side by side, in lanes of vectors and on all processors, by a Runge-Kutta method that "
    "--tol chooses; near a pole or at rest, where steps, taken again in halves, differ by more than the tolerance, and, with "
    "--contact end, where a condition is lost, one at a time. `jellett plan section ...` and the header of the table name the "
    "method, or say why there are no lanes. Orbits go in blocks of 256 a thread, and the rows of a block are written when it "
    "is done. Rows beyond 1024 of an orbit, or beyond 256 MiB, wait in a file in TMPDIR. One orbit alone, and all orbits with "
    "--method, are integrated by the method named, gauss by default. With --sweep the orbits of all points go side by side, "
    "even where each point has one orbit only; the rows of a point do not depend on the other points.\n\n"
    "A picture shows the ranges that --grid names and a third more, or all returns if hardly any lies there. Of more than 400000 "
    "returns it shows a random half, a quarter, and so on; its title says so, and the table has all.\n\n"
    "Examples:\n"
    "  jellett section --level E=2.15,G=-0.56 --start eta=0.1,gamma3=-0.6 \\\n"
    "    --returns 10 --tol 1e-13\n"
    "  jellett section --grid 24x16 --returns 400 --plot section.svg > section.csv\n"
    "  jellett section --threads 2 --grid 100x100 > section.csv",
    children, NULL, NULL,
};

static const jlt_swept_form swept = { &jlt_command_section, true, 3 };

typedef struct {
    jlt_section_run_options options;
    jlt_section_picture picture;
    jlt_section_run run;
    jlt_system *system;
} section;

static void drop(void *run)
{
    section *self = run;

    jlt_section_run_close(&self->run);
    jlt_system_destroy(self->system);
    jlt_motion_end(&self->options.motion);
    jlt_section_picture_close(&self->picture);
    free(self);
}

static void *begin(jlt_exit *code, int argc, char **argv)
{
    section *self = calloc(1, sizeof *self);

    if (self == NULL) {
        *code = jlt_command_no_memory();
        return NULL;
    }
    jlt_section_run_options *o = &self->options;
    o->returns = 100;
    o->time_direction = 1;
    jlt_motion_begin(&o->motion, argc, argv);
    jlt_motion_many_begin(&o->motion);
    ttc_options_parse(&parser, argc, argv, o);
    jlt_motion_many_choose(&o->motion, jlt_section_run_is_of_many(o), o->project);
    if (jlt_swept_done(code, &swept, &o->motion.common)) goto done;
    *code = jlt_motion_system(&self->system, &o->motion);
    if (*code == JLT_EXIT_DONE && o->motion.common.plot != NULL)
        *code = jlt_section_picture_open(&self->picture, &o->motion, self->system);
    if (*code == JLT_EXIT_DONE) *code = jlt_motion_axes(o->axes, self->system, o->motion.grid, "--grid");
    if (*code == JLT_EXIT_DONE) *code = jlt_motion_check_starts(self->system, o->motion.starts, o->motion.start_count);
    if (*code == JLT_EXIT_DONE && o->motion.grid != NULL && o->motion.start_count == 0)
        *code = jlt_motion_check_grid(o->axes, self->system);
    self->run = (jlt_section_run){ .o = o, .system = self->system, .picture = &self->picture };
    if (*code == JLT_EXIT_DONE) *code = jlt_section_run_open(&self->run);
    if (*code == JLT_EXIT_DONE) *code = jlt_motion_plan(self->system, &o->motion);
    if (*code == JLT_EXIT_DONE) return self;
done:
    drop(self);
    return NULL;
}

static jlt_exit finish(void *run)
{
    section *self = run;
    jlt_section_run_options *o = &self->options;
    jlt_common *common = &o->motion.common;

    JLT_PASS(jlt_common_write(common));
    JLT_PASS(jlt_section_run_write(&self->run));
    JLT_PASS(jlt_common_save(common));
    const jlt_exit verdict = jlt_section_run_verdict(&self->run);
    if (common->plot != NULL)
        JLT_PASS(jlt_section_picture_draw(&self->picture, common, self->system, o->motion.grid, o->axes, o->returns,
                                          o->time_direction));
    return verdict;
}

/* Out: the section runs of `runs`, shape (count,); `out` has room for JLT_SHELF_RUNS. */
static void list(jlt_section_run **out, void *const *runs, size_t count)
{
    for (size_t i = 0; i < count; i++) out[i] = &((section *)runs[i])->run;
}

static bool are_enough(void *const *runs, size_t count)
{
    jlt_section_run *own[JLT_SHELF_RUNS];

    list(own, runs, count);
    return jlt_section_run_are_enough(own, count);
}

static void follow(void *const *runs, size_t count)
{
    jlt_section_run *own[JLT_SHELF_RUNS];

    list(own, runs, count);
    jlt_section_run_follow(own, count);
}

static const jlt_shelf_form together = { begin, are_enough, follow, finish, drop };

const jlt_command jlt_command_section = {
    "section", "[MODEL] --start ...|--grid ... [OPTION...]",
    "Poincare map at levels of E and G: returns, fates, picture", NULL, &parser, &together
};
