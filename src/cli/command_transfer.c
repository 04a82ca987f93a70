/* `jellett transfer`: transfer operators of the return map, their stationary densities, escape rates, and sets that mix slowly. */
#include "base/options.h"
#include "cli/motion_many.h"
#include "cli/motion_map.h"
#include "cli/progress.h"
#include "cli/swept.h"
#include "cli/transfer_report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Keys of options; LIST_MAX, most values of --noise and of --coarse; BLOCK, points mapped together, for each thread. */
enum { STRATA = 2000, NOISE, COARSE, SEED, BACKWARD, CANDIDATES, LIST_MAX = 8, BLOCK = 8192 };

typedef struct {
    jlt_motion_options motion;
    size_t strata, eigenvalues, candidates, seed;
    double noise[LIST_MAX];
    size_t noise_count, coarse[LIST_MAX], coarse_count;
    bool backwards, json;
} options;

static const char default_boxes[] = "100x100";

static const double drawn = 1e-6; /* pictures show densities down to this fraction of the largest */

static const struct argp_option option_table[] = {
    { "boxes", 'b', "COUNTxCOUNT", 0,
      "Boxes over the whole section, or over NAME=LOW:HIGH:COUNT,...; of a section that tables describe, default 100x100", 1 },
    { "strata", STRATA, "N", 0,
      "Points in each box: N along each coordinate, at random within each of N equal cells; default 10", 1 },
    { "eigenvalues", 'e', "N|0", 0,
      "Compute the N leading eigenvalues; default 6. 0: compute only the matrix and the density that is known", 1 },
    { "noise", NOISE, "PART,...", 0,
      "Move each image at random, along each coordinate by up to this part of its interval either way; one matrix for each "
      "PART; default 0", 1 },
    { "coarse", COARSE, "N,...", 0, "Compare with boxes that are N times as wide, computed from the same points", 1 },
    { "backward", BACKWARD, NULL, 0, "Use the inverse map, whose invariant set is the repeller", 1 },
    { "candidates", CANDIDATES, "N|0", 0, "Print the N boxes of highest density, each as a --start; default 3", 1 },
    { "seed", SEED, "N|0", 0, "Seed of the places of points, and of the noise; default 1", 1 },
    { "json", 'j', NULL, 0, "Print the comparison of operators as JSON, instead of the rows", 1 },
    { 0 },
};

/* Read the next item of a list separated by commas. Returns false at its end. */
static bool next_item(char item[64], const char **text, const char *option, struct argp_state *state)
{
    const size_t length = strcspn(*text, ",");

    if (**text == '\0') return false;
    if (length == 0 || length >= 64) argp_error(state, "%s: '%s' is no list", option, *text);
    memcpy(item, *text, length);
    item[length] = '\0';
    *text += length + ((*text)[length] == ',');
    return true;
}

static void parse_noise(options *o, const char *value, struct argp_state *state)
{
    char item[64];

    for (o->noise_count = 0; next_item(item, &value, "--noise", state); o->noise_count++) {
        if (o->noise_count == LIST_MAX) argp_error(state, "--noise: at most %d values", LIST_MAX);
        jlt_common_number(&o->noise[o->noise_count], item, "--noise");
        if (!(o->noise[o->noise_count] >= 0 && o->noise[o->noise_count] <= 1))
            argp_error(state, "--noise: '%s' is not from 0 to 1", item);
    }
    if (o->noise_count == 0) argp_error(state, "--noise: no value");
}

static void parse_coarse(options *o, const char *value, struct argp_state *state)
{
    char item[64];

    for (o->coarse_count = 1; next_item(item, &value, "--coarse", state); o->coarse_count++) {
        if (o->coarse_count == LIST_MAX) argp_error(state, "--coarse: at most %d values", LIST_MAX - 1);
        jlt_common_count(&o->coarse[o->coarse_count], item, 2, 1 << 20, "--coarse");
        if (o->coarse[o->coarse_count] <= o->coarse[o->coarse_count - 1]) argp_error(state, "--coarse: write 2,4,8, ascending");
    }
}

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_contact_argp, 0, NULL, 0 },
                                              { &jlt_motion_many_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'b': jlt_motion_typed(o->motion.grid = value, "--boxes"); return 0;
    case STRATA: jlt_common_count(&o->strata, value, 1, 1000, "--strata"); return 0;
    case 'e': jlt_common_count(&o->eigenvalues, value, 0, 100, "--eigenvalues"); return 0;
    case NOISE: parse_noise(o, value, state); return 0;
    case COARSE: parse_coarse(o, value, state); return 0;
    case BACKWARD: o->backwards = true; return 0;
    case CANDIDATES: jlt_common_count(&o->candidates, value, 0, 1000, "--candidates"); return 0;
    case SEED: jlt_common_count(&o->seed, value, 0, INT64_MAX, "--seed"); return 0;
    case 'j': o->json = true; return 0;
    case ARGP_KEY_END:
        if (strcmp(o->motion.contact, "report") == 0)
            argp_error(state, "--contact report writes a column of orbits, and rows here are boxes: write end, or leave it out");
        if (o->json && o->motion.common.sweep != NULL) argp_error(state, "--sweep writes rows: leave out --json");
        if (o->json) jlt_common_no_table(&o->motion.common, state, "a report");
        if (o->motion.common.plot != NULL && o->eigenvalues == 0)
            argp_error(state, "--plot draws the density that stays: leave out --eigenvalues 0");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Compute the densities that a section's return map leaves invariant, by Ulam's method: the section is cut into boxes, the "
    "shares of each box that one return sends to every other box form a matrix, and its leading eigenvalues and vectors are "
    "computed. Orbits that end are lost mass."
    "\vColumns, one row for each box that has states:\n"
    "  COORDINATE        each coordinate of the box's centre\n"
    "  share             the part of the box that has states\n"
    "  mass, density     of the invariant density, in the box\n"
    "  second            the eigenvector of the next positive eigenvalue; the signs\n"
    "                    show sets that mix slowly\n"
    "  known_density     where the table claims an invariant measure: rho times\n"
    "                    the flux\n"
    "  one for each fate, and for leaving the boxes: the share lost at a return\n"
    "  time              mean time of a return\n\n"
    "For each matrix, standard error or --json has:\n"
    "  the eigenvalues, as far as two computations agree to three digits\n"
    "  the escape rate, -ln of the leading eigenvalue, and the mass lost by fate\n"
    "  the distance from the density to its mirror image, which is invariant under\n"
    "  the inverse map (1: attractor and repeller are apart)\n"
    "  how much of each set that mixes slowly stays in it\n"
    "  the distance from the known density to its image, and the order in which it\n"
    "  falls with the width of the boxes\n\n"
    "Distances are in total variation, 0 to 1.\n\n"
    "All this is evidence, not proof: spreading mass over whole boxes hides dissipation and transport that are weaker. Compare "
    "--coarse and --noise, and prove what matters with `jellett certify`, from the orbits that `jellett orbits` finds in the "
    "boxes printed.\n\n"
    "Memory: 12 bytes for each entry of a matrix, of which a box has a few, and less than 2 kB a box for 6 eigenvalues. Orbits "
    "are followed side by side as by `jellett section`, with a method that --tol chooses; with --method, one at a time.\n\n"
    "Examples:\n"
    "  jellett transfer --boxes 300x300 --tol 1e-8 --coarse 2,3 \\\n"
    "    --plot density.png -o density.csv\n"
    "  jellett transfer --set I3=0 --boxes 64x64 --eigenvalues 0\n"
    "  jellett transfer --sweep a3=0.4:0.6:5 --boxes 64x64 -o densities.csv\n"
    "  jellett transfer nose_hoover --section z=0 --boxes q=-4:4:64,p=-4:4:64",
    children, NULL, NULL,
};

/* A run of the command: everything that has to be released at its end. */
typedef struct {
    options *o;
    jlt_system *system;
    jlt_boxes boxes;
    jlt_section_batch *batch;
    jlt_transfer_section *section;
    jlt_transfer *transfers[LIST_MAX * LIST_MAX];
    jlt_transfer_case cases[LIST_MAX * LIST_MAX];
    size_t *candidates, candidate_count, points;
    jlt_progress progress;
} study;

static void clear(study *s)
{
    for (size_t i = 0; i < LIST_MAX * LIST_MAX; i++) {
        jlt_transfer_finding_clear(&s->cases[i].finding);
        jlt_transfer_destroy(s->transfers[i]);
    }
    jlt_transfer_section_destroy(s->section);
    jlt_section_batch_destroy(s->batch);
    jlt_system_destroy(s->system);
    free(s->candidates);
}

static jlt_exit choose_boxes(study *s, jlt_grid_axis *axes)
{
    const options *o = s->o;
    const jlt_chart *chart = s->system->flow.chart;
    const char *text = o->motion.grid != NULL                          ? o->motion.grid
                       : s->system->surface != NULL && chart->dim == 2 ? default_boxes
                                                                       : NULL;
    size_t all;

    if (text == NULL) return jlt_command_fail(JLT_EXIT_USAGE, "say which boxes: --boxes NAME=LOW:HIGH:COUNT,...");
    if (chart->dim > JLT_BOXES_DIM_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "--boxes: the section has %u coordinates, and boxes have %d at most", chart->dim,
                                JLT_BOXES_DIM_MAX);
    JLT_PASS(jlt_motion_cells(axes, s->system, text, "--boxes"));
    s->boxes.dim = chart->dim;
    for (unsigned k = 0; k < chart->dim; k++) {
        s->boxes.low[k] = axes[k].low;
        s->boxes.high[k] = axes[k].high;
        s->boxes.period[k] = chart->period[k];
        s->boxes.count[k] = axes[k].count;
        for (size_t i = 1; i < o->coarse_count; i++)
            if (axes[k].count > 1 && axes[k].count % o->coarse[i] != 0)
                return jlt_command_fail(JLT_EXIT_INPUT, "--coarse: %zu boxes of %s cannot be taken %zu together", axes[k].count,
                                        chart->names[k], o->coarse[i]);
    }
    if (jlt_boxes_count(&all, &s->boxes) != JLT_OK)
        return jlt_command_fail(JLT_EXIT_INPUT, "--boxes: %s: more than %zu boxes", text, JLT_BOXES_MAX);
    if (jlt_boxes_samples(&s->boxes, o->strata) > 1000000)
        return jlt_command_fail(JLT_EXIT_INPUT, "--strata: %zu along %u coordinates are more than 1000000 points of a box",
                                o->strata, chart->dim);
    return JLT_EXIT_DONE;
}

static void show(void *context, size_t done, size_t all) { jlt_progress_show(context, done, all); }

static jlt_exit interrupted(void)
{
    fputs("jellett: interrupted; nothing is saved, for a part of the points has no densities\n", stderr);
    return JLT_EXIT_DONE;
}

static jlt_exit build(study *s)
{
    const options *o = s->o;
    jlt_section_batch_options batch = { .last_only = true, .backwards = o->backwards };
    const jlt_transfer_options how = { .strata = o->strata, .seed = o->seed, .noise = o->noise, .noise_count = o->noise_count,
                                       .block = BLOCK * o->motion.threads, .progress = show, .progress_context = &s->progress };
    jlt_transfer *built[LIST_MAX] = { NULL };

    JLT_PASS(jlt_motion_many_open(&s->batch, &batch, &o->motion, s->system));
    jlt_status st = jlt_transfer_section_create(&s->section, s->system, s->batch);
    if (st != JLT_OK) return jlt_motion_fail(st, s->system, "section");
    const jlt_transfer_map map = jlt_transfer_section_map(s->section);
    jlt_progress_start(&s->progress, "points");
    st = jlt_transfer_build(built, &s->points, &s->boxes, &map, &how);
    jlt_progress_end(&s->progress);
    for (size_t k = 0; k < o->noise_count; k++) s->transfers[k * o->coarse_count] = built[k];
    if (jlt_motion_interrupted(&o->motion)) return interrupted();
    if (st == JLT_ERR_EMPTY)
        return jlt_command_fail(JLT_EXIT_INPUT, "--boxes: no point of them has a state from which the section is crossed in its "
                                                "--direction");
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, s->system, "--boxes");
}

static jlt_exit examine(study *s, jlt_transfer_case *c, const jlt_transfer *transfer, size_t factor, double noise)
{
    const options *o = s->o;
    jlt_status st;

    *c = (jlt_transfer_case){ .factor = factor, .noise = noise, .transfer = transfer };
    if (o->eigenvalues > 0 && transfer->count < 3)
        return jlt_command_fail(JLT_EXIT_INPUT, "--boxes: %zu have states; eigenvalues are of 3 boxes or more", transfer->count);
    st = jlt_transfer_finding_make(&c->finding, transfer, s->system->flow.chart, o->eigenvalues, o->motion.flow.interrupt);
    if (jlt_motion_interrupted(&o->motion)) return interrupted();
    if (st == JLT_ERR_EMPTY)
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "--boxes: nothing stays in them, for no box leads back to itself: choose others, or another "
                                "--section%s",
                                s->system->flow.chart->solved_count > 0 ? ", or another branch by --solve" : "");
    if (st == JLT_ERR_NO_CONVERGENCE)
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "ARPACK does not converge on the matrix of %zu boxes, as where many "
                                "eigenvalues lie on one circle (integrable motion): add --noise, or compare densities alone by "
                                "--eigenvalues 0",
                                transfer->count);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, NULL, "eigenvalues");
}

static jlt_exit examine_all(study *s)
{
    const options *o = s->o;
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t i = 0; code == JLT_EXIT_DONE && !jlt_motion_interrupted(&o->motion) && i < o->noise_count * o->coarse_count; i++) {
        const size_t width = i % o->coarse_count;
        if (width > 0) {
            const jlt_status st = jlt_transfer_coarsen(&s->transfers[i], s->transfers[i - width], o->coarse[width]);
            if (st != JLT_OK) return jlt_motion_fail(st, NULL, "--coarse");
        }
        code = examine(s, &s->cases[i], s->transfers[i], o->coarse[width], o->noise[i / o->coarse_count]);
    }
    if (code != JLT_EXIT_DONE || o->eigenvalues == 0 || o->candidates == 0 || jlt_motion_interrupted(&o->motion)) return code;
    s->candidates = calloc(o->candidates, sizeof *s->candidates);
    if (s->candidates == NULL ||
        jlt_transfer_finding_peaks(s->candidates, &s->candidate_count, o->candidates, s->transfers[0],
                                   s->cases[0].finding.spectrum.leading) != JLT_OK)
        return jlt_command_no_memory();
    return JLT_EXIT_DONE;
}

static jlt_exit draw(const study *s, jlt_motion_map *map)
{
    const jlt_transfer *t = s->transfers[0];
    const double *v = s->cases[0].finding.spectrum.leading;
    double q[JLT_CHART_DIM_MAX], most = 0;
    bool has_empty = false;
    jlt_plot plot;

    for (size_t i = 0; i < t->count; i++) most = fmax(most, jlt_transfer_finding_density(t, v, i));
    for (size_t i = 0; i < t->count; i++) {
        const double density = jlt_transfer_finding_density(t, v, i);
        jlt_boxes_centre(&t->boxes, q, t->box[i]);
        if (density > 0) jlt_motion_map_add(map, q, log10(fmax(density, most * drawn)));
        else has_empty = true;
    }
    if (jlt_plot_open(&plot, &s->o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_words(&plot, "Density that stays under the %s map\n", s->o->backwards ? "inverse" : "return");
    jlt_motion_caption(&plot, s->system, NULL);
    jlt_motion_map_palette(map, &plot, "log_{10} of the density");
    jlt_motion_map_frame(map, &plot);
    jlt_motion_map_plot(map, &plot);
    jlt_motion_map_blank(map, &plot, has_empty ? "without states or of density 0" : "without states");
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

static jlt_exit write_all(study *s, jlt_motion_map *map)
{
    const options *o = s->o;
    jlt_common *common = &s->o->motion.common;
    const jlt_transfer_report report = {
        .motion = &o->motion, .system = s->system, .cases = s->cases, .case_count = o->noise_count * o->coarse_count,
        .wanted = o->eigenvalues, .points = s->points, .strata = o->strata, .seed = o->seed, .backwards = o->backwards,
        .known = jlt_transfer_section_density(s->section), .candidates = s->candidates, .candidate_count = s->candidate_count,
    };

    if (o->json) {
        if (jlt_transfer_report_json(common->table.file, &report) != JLT_OK) return jlt_command_no_memory();
    } else {
        jlt_motion_header(common->table.file, &o->motion, s->system);
        jlt_transfer_report_rows(common->table.file, &report);
    }
    JLT_PASS(jlt_common_save(common));
    jlt_transfer_report_text(stderr, &report);
    if (common->plot != NULL) JLT_PASS(draw(s, map));
    return jlt_motion_failures(s->system, jlt_transfer_section_failures(s->section), s->points);
}

/* Set the axes to the grid of the boxes' centres, for the picture. */
static void centre_axes(jlt_grid_axis *axes, const jlt_boxes *boxes)
{
    for (unsigned k = 0; k < boxes->dim; k++) {
        const double half = (boxes->high[k] - boxes->low[k]) / (double)boxes->count[k] / 2;
        const bool is_whole = boxes->period[k] != 0 && boxes->high[k] - boxes->low[k] > boxes->period[k] * (1 - 1e-12);
        axes[k].low = boxes->low[k] + half;
        axes[k].high = is_whole ? boxes->high[k] + half : boxes->high[k] - half;
        axes[k].low_text = axes[k].high_text = NULL;
    }
}

static const jlt_swept_form swept = { &jlt_command_transfer, true, 3 };

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end)
    options o = { .strata = 10, .eigenvalues = 6, .candidates = 3, .seed = 1, .noise_count = 1, .coarse = { 1 },
                 .coarse_count = 1 };
    JLT_CLEARED(clear) study s = { .o = &o };
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    JLT_CLEARED(jlt_motion_map_close) jlt_motion_map map = { .points = NULL };
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    jlt_motion_many_begin(&o.motion);
    ttc_options_parse(&parser, argc, argv, &o);
    if (jlt_swept_done(&code, &swept, &o.motion.common)) return code;
    jlt_motion_many_choose(&o.motion, true, false);
    o.motion.seed = o.seed;
    o.motion.is_random = true;
    o.motion.other = default_boxes;
    JLT_PASS(jlt_motion_system(&s.system, &o.motion));
    JLT_PASS(choose_boxes(&s, axes));
    centre_axes(axes, &s.boxes);
    JLT_PASS(jlt_motion_map_open(&map, &o.motion, s.system, o.motion.grid != NULL ? o.motion.grid : default_boxes, axes));
    JLT_PASS(jlt_motion_plan(s.system, &o.motion));
    JLT_PASS(jlt_common_write(&o.motion.common));
    JLT_PASS(build(&s));
    JLT_PASS(examine_all(&s));
    return jlt_motion_interrupted(&o.motion) ? JLT_EXIT_DONE : write_all(&s, &map);
}

const jlt_command jlt_command_transfer = {
    "transfer", "[MODEL] [OPTION...]", "Densities that stay under the map, escape rates, sets that mix slowly", run, &parser, NULL
};
