/* `jellett separation`: whether attractor and repeller are apart, from the cells that orbits visit in both directions of time. */
#include "base/options.h"
#include "cli/motion_many.h"
#include "cli/swept.h"
#include "core/memory.h"
#include "dynamics/separation.h"
#include "kernel/batch_isa.h"
#include "report/csv.h"

#include <string.h>

typedef struct {
    jlt_motion_options motion;
    const char *cells;
    size_t returns, settle;
} options;

enum { CELLS = 2000, SETTLE };

static const struct argp_option option_table[] = {
    { "grid", 'g', "COUNTxCOUNT", 0,
      "A grid of starts over the whole section, or over NAME=LOW:HIGH:COUNT,...; default 24x16", 1 },
    { "cells", CELLS, "COUNTxCOUNT", 0, "The cells in which visits are counted, written like --grid; default 200x200", 1 },
    { "returns", 'n', "N", 0, "Count N returns of every orbit; default 1024", 1 },
    { "settle", SETTLE, "N|0", 0, "Leave out N returns first; default 200", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_motion_many_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'g': jlt_motion_typed(o->motion.grid = value, "--grid"); return 0;
    case CELLS: jlt_motion_typed(o->cells = value, "--cells"); return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, (size_t)1 << 40, "--returns"); return 0;
    case SETTLE: jlt_common_count(&o->settle, value, 0, (size_t)1 << 40, "--settle"); return 0;
    case ARGP_KEY_END: jlt_plot_check_log(&o->motion.common, "x", state); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Find out whether attractor and repeller are apart: compare the cells of the section that long orbits visit forwards and "
    "backwards in time, as the orbits grow longer. A reversor maps one set onto the other."
    "\vColumns:\n"
    "  returns           returns counted of every orbit\n"
    "  alive_forward, alive_backward: orbits that had not ended after all returns;\n"
    "                    the others, such as at a pole, count up to their ends\n"
    "  cells_forward, cells_backward, cells_common: cells visited forwards,\n"
    "                    backwards, both\n"
    "  overlap           common/union: 1 where the sets agree, as in conservative\n"
    "                    dynamics; 0 where they are apart; mixed dynamics between\n"
    "  mirror_overlap    the same of the mirror image of the forward set and the\n"
    "                    backward set; its distance from 1 is the error that comes\n"
    "                    from the finite length of orbits\n\n"
    "Orbits backwards are not followed, but taken as mirror images of those forwards, where the table proves the reversor, only "
    "poles end orbits, and the mirror images of starts are starts. If that holds for all orbits, mirror_overlap is 1 by "
    "construction, and shows nothing.\n\n"
    "Orbits are followed side by side as by `jellett section`, with a method that --tol chooses; with --method, one at a time.\n\n"
    "Examples:\n"
    "  jellett separation --grid eta=-0.5:0.5:20,gamma3=-0.75:-0.5:20 \\\n"
    "    --returns 4096",
    children, NULL, NULL,
};

static const char default_cells[] = "200x200";

/* Read the grid of starts and the cells, each of shape (2,). */
static jlt_exit read_cells(jlt_grid_axis *axes, jlt_grid_axis *cells, const options *o, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;

    if (chart->dim != 2)
        return jlt_command_fail(JLT_EXIT_INPUT, "the comparison needs a section of two coordinates, not of %u%s", chart->dim,
                                chart->dim > 2 ? ": --level and --solve leave fewer" : "");
    if (!chart->reversible)
        return jlt_motion_no_reversor(system, "the comparison needs a reversor that takes the section to itself, crossed as it is");
    JLT_PASS(jlt_motion_axes(axes, system, o->motion.grid, "--grid"));
    return jlt_motion_cells(cells, system, o->cells, o->cells != default_cells ? "--cells" : "--cells, by default 200x200");
}

static jlt_exit measure(jlt_separation *table, size_t *rows, const jlt_grid_axis *axes, const jlt_grid_axis *cells,
                        const options *o, const jlt_system *system)
{
    const jlt_kernel_batch *kernels = o->motion.in_lanes ? jlt_batch_isa_best(system->instance->descriptor, 0) : NULL;
    jlt_separation_options wanted = {
        .settle = o->settle, .returns = o->returns, .kernels = kernels, .threads = (unsigned)o->motion.threads,
        .by_mirror = o->motion.mirror == NULL
    };

    for (int k = 0; k < 2; k++) {
        wanted.low[k] = cells[k].low;
        wanted.high[k] = cells[k].high;
        wanted.cells[k] = cells[k].count;
    }
    const size_t all = jlt_motion_grid_size(axes, system);
    JLT_FREED double *starts = malloc(all * 2 * sizeof *starts);
    if (starts == NULL) return jlt_motion_fail(JLT_ERR_NOMEM, system, "separation");
    for (size_t i = 0; i < all; i++) jlt_motion_grid_point(starts + 2 * i, axes, system, i);
    const jlt_status st = jlt_separation_measure(table, rows, &system->flow, starts, all, &wanted);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "separation");
}

static jlt_exit draw(const options *o, const jlt_system *system, const jlt_separation *table, size_t rows)
{
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    fputs("$OVERLAP << END\n", plot.stream);
    for (size_t i = 0; i < rows; i++)
        jlt_look_row(plot.stream, (const double[]){ (double)table[i].returns, table[i].overlap, table[i].mirror_overlap }, 3);
    fputs("END\n", plot.stream);
    jlt_plot_words(&plot, "Cells visited forwards and backwards\n");
    jlt_motion_caption(&plot, system, NULL);
    jlt_plot_log(&plot, 'x', "returns of every orbit", JLT_EXTENT_OPEN, 2);
    jlt_plot_axis(&plot, 'y', "overlap", (jlt_extent){ 0, 1.05 }, 0);
    fputs("plot $OVERLAP using 1:2 ", plot.stream);
    jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "linespoints", .colour = 2, .size = 0.7 });
    fputs(" title 'forward and backward', $OVERLAP using 1:3 ", plot.stream);
    jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "linespoints", .colour = 1, .dash = 1, .mark = 3, .size = 0.7 });
    fputs(" title 'mirrored forward and backward'\n", plot.stream);
    return jlt_plot_draw(&plot);
}

static const jlt_swept_form swept = { &jlt_command_separation, true, 6 };

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end) options o = { .cells = default_cells, .returns = 1024, .settle = 200 };
    jlt_grid_axis axes[JLT_CHART_DIM_MAX], cells[JLT_CHART_DIM_MAX];
    jlt_separation table[48];
    jlt_common *common = &o.motion.common;
    JLT_OWNED(jlt_system) *system = NULL;
    size_t rows = 0;
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.grid = "24x16";
    jlt_motion_many_begin(&o.motion);
    ttc_options_parse(&parser, argc, argv, &o);
    jlt_motion_many_choose(&o.motion, true, false);
    if (jlt_swept_done(&code, &swept, &o.motion.common)) return code;
    JLT_PASS(jlt_motion_system(&system, &o.motion));
    JLT_PASS(read_cells(axes, cells, &o, system));
    JLT_PASS(jlt_motion_plan(system, &o.motion));
    JLT_PASS(jlt_common_write(common));
    JLT_PASS(measure(table, &rows, axes, cells, &o, system));
    jlt_motion_header(common->table.file, &o.motion, system);
    fputs("returns,alive_forward,alive_backward,cells_forward,cells_backward,cells_common,overlap,mirror_overlap\n",
          common->table.file);
    for (size_t i = 0; i < rows; i++) {
        const jlt_separation *row = &table[i];
        fprintf(common->table.file, "%zu,%zu,%zu,%zu,%zu,%zu,", row->returns, row->alive_forward, row->alive_backward, row->forward,
                row->backward, row->common);
        /* NaN, written as an empty field, if no cell is visited */
        jlt_csv_row(common->table.file, (const double[]){ row->overlap, row->mirror_overlap }, 2);
    }
    if (table[0].strayed > 0)
        fprintf(stderr, "jellett: %zu orbits, of both directions, left the branch of --solve and were followed no further: try "
                        "another --direction or section\n", table[0].strayed);
    JLT_PASS(jlt_common_save(common));
    return common->plot != NULL ? draw(&o, system, table, rows) : JLT_EXIT_DONE;
}

const jlt_command jlt_command_separation = {
    "separation", "[MODEL] [OPTION...]",
    "Whether attractor and repeller are apart, by the cells orbits visit", run, &parser, NULL
};
