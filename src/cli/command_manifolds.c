/* `jellett manifolds`: separatrices of a saddle, homoclinic points, their angles and lobes. */
#include "base/options.h"
#include "cli/interrupt.h"
#include "cli/motion_many.h"
#include "cli/swept.h"
#include "dynamics/scale.h"
#include "dynamics/separatrices.h"
#include "kernel/batch_isa.h"
#include "report/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    const char *points;
    size_t period;
    jlt_manifold_options growth;
    double seed;
    bool no_crossings;
} options;

enum { LENGTH = 2000, SPACING, TURN, SEED, CROSSINGS, NO_CROSSINGS, COUNT };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", 0,
      "A point near the saddle: a value for every coordinate of the section; for the spherical top default the saddle of "
      "Figure 3", 1 },
    { "period", 'n', "N", 0, "The saddle's orbit closes after N returns; default 1", 1 },
    { "length", LENGTH, "VALUE", 0, "Arc length of every branch, which ends with the first point beyond it, in coordinates of "
      "the section; default 1.6", 1 },
    { "spacing", SPACING, "VALUE", 0, "Largest distance between neighbouring points, in coordinates; default 0.01", 1 },
    { "turn", TURN, "VALUE", 0, "Largest angle between neighbouring segments, in radians; default 0.2", 1 },
    { "count", COUNT, "N", 0, "Compute at most N points on a branch, by at most 100*N returns; default 4000", 1 },
    { "seed", SEED, "VALUE", 0,
      "Distance from the saddle at which branches begin, in coordinates, 1e-6 to 1e-3; default 1e-4", 1 },
    { "crossings", CROSSINGS, "FILE", 0, "Write the points where separatrices cross to FILE, as CSV", 1 },
    { "no-crossings", NO_CROSSINGS, NULL, 0, "Do not look for points where separatrices cross", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_motion_many_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'a': jlt_motion_one_start(&o->motion, value); return 0;
    case 'n': jlt_common_count(&o->period, value, 1, JLT_PERIODIC_MAX, "--period"); return 0;
    case LENGTH: jlt_common_positive(&o->growth.length_max, value, "--length"); return 0;
    case SPACING:
        jlt_common_positive(&o->growth.spacing, value, "--spacing");
        if (!(o->growth.spacing > JLT_MANIFOLD_FINEST))
            exit((int)jlt_command_fail(JLT_EXIT_INPUT, "--spacing: '%s' is not above %g, where branches are no longer refined",
                                       value, JLT_MANIFOLD_FINEST));
        return 0;
    case TURN: jlt_common_positive(&o->growth.turn, value, "--turn"); return 0;
    case COUNT: jlt_common_count(&o->growth.points_max, value, 2, 10000000, "--count"); return 0;
    case SEED:
        jlt_common_number(&o->seed, value, "--seed");
        if (!(o->seed >= JLT_BRANCH_SEED_LEAST && o->seed <= JLT_BRANCH_SEED_MOST))
            exit((int)jlt_command_fail(JLT_EXIT_INPUT, "--seed: '%s' is not from %g to %g", value, JLT_BRANCH_SEED_LEAST,
                                       JLT_BRANCH_SEED_MOST));
        return 0;
    case CROSSINGS: o->points = value; return 0;
    case NO_CROSSINGS: o->no_crossings = true; return 0;
    case ARGP_KEY_END:
        if (o->no_crossings && o->points != NULL) argp_error(state, "--crossings and --no-crossings exclude each other");
        if (o->points != NULL && o->motion.common.sweep != NULL)
            argp_error(state, "--crossings: one file for all points of --sweep: leave it out");
        jlt_common_check_files(&o->motion.common, "--crossings", o->points);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Compute the stable and unstable branches of a saddle of the map, on both sides, with their arc length and curvature under "
    "control; and find where they cross: homoclinic points, with the angle of crossing and its error bar, and the areas of the "
    "lobes."
    "\vColumns of the branches:\n"
    "  branch, side      unstable or stable; one side or the other\n"
    "  sigma             number of fundamental domains from the saddle\n"
    "  length            arc length along the branch from its first point, --seed\n"
    "                    away from the saddle\n"
    "  COORDINATE        the two coordinates\n\n"
    "Columns of the homoclinic points (--crossings):\n"
    "  COORDINATE        the two coordinates\n"
    "  sigma_unstable, sigma_stable, side_unstable, side_stable: as above\n"
    "  angle             from the unstable to the stable tangent, in the plane of\n"
    "                    the coordinates\n"
    "  angle_error       its error\n"
    "  residual          of the crossing\n"
    "  lobe              signed area up to the next crossing along the unstable\n"
    "                    branch; empty where one branch goes around an angle on the\n"
    "                    way and the other does not\n"
    "  lobe_error        its error\n\n"
    "Errors are the changes that another tolerance, a beginning nearer to the saddle, and one curved like the manifold make, and, "
    "for lobes, other points on the branches, and no less than an error of one tolerance makes. Branches grow, crossings are "
    "refined, and lobes are integrated many points at a time in lanes, by a method that --tol chooses; if --method is given, by "
    "that method.\n\n"
    "Examples:\n"
    "  jellett manifolds --plot fig3b.svg > branches.csv",
    children, NULL, NULL,
};

static void write_known(FILE *file, int digits, double value)
{
    fputc(',', file);
    if (!isnan(value)) fprintf(file, "%.*g", digits, value);
}

static void write_crossings(FILE *file, const jlt_separatrices *p, const char *prefix)
{
    jlt_csv_names names;

    fputs(prefix, file);
    fprintf(jlt_csv_names_begin(&names, file),
            "%s,%s,sigma_unstable,sigma_stable,side_unstable,side_stable,angle,angle_error,residual,lobe,lobe_error",
            p->chart->names[0], p->chart->names[1]);
    jlt_csv_names_end(&names);
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++)
            for (size_t i = 0; i < p->count[u][s]; i++) {
                const jlt_homoclinic *h = &p->crossings[u][s][i];
                fputs(prefix, file);
                jlt_csv_values(file, h->q, 2);
                fprintf(file, ",%.10g,%.10g,%d,%d,", h->sigma_unstable, h->sigma_stable, u == 0 ? 1 : -1, s == 0 ? 1 : -1);
                jlt_csv_value(file, h->angle);
                write_known(file, 3, h->angle_error);
                write_known(file, 3, h->residual);
                write_known(file, 15, h->lobe);
                write_known(file, 3, h->lobe_error);
                fputc('\n', file);
            }
}

static const char *branch_name(int k)
{
    return k < 2 ? "unstable" : "stable";
}

static void write_end(FILE *file, const char *prefix, const jlt_separatrices *p, int k)
{
    static const char *const ends[] = { "length reached", "number of points reached", "number of returns reached",
                                        "errors outgrow the spacing on its last part (a connection to another saddle?)",
                                        "settles on a periodic orbit", "runs into orbits that end", "interrupted" };

    fprintf(file, "%s%s branch, side %+d: %zu points, length %.6g, %s%s\n", prefix, branch_name(k), k % 2 == 0 ? 1 : -1,
            p->curve[k].count, p->curve[k].length[p->curve[k].count - 1], ends[p->curve[k].end],
            p->curve[k].end == JLT_MANIFOLD_POLE && p->chart->solved_count > 0 ? ", or leave the branch of --solve" : "");
}

static void write_all(FILE *file, const jlt_separatrices *p, const jlt_periodic *saddle, bool crossings)
{
    jlt_csv_names names;

    fprintf(file, "# saddle of period %zu: %s=%.17g %s=%.17g, multipliers %.15g, %.15g, residual %.2g\n", saddle->period,
            p->chart->names[0], saddle->points[0], p->chart->names[1], saddle->points[1], saddle->re[0], saddle->re[1],
            saddle->residual);
    for (int k = 0; k < JLT_SEPARATRICES; k++) write_end(file, "# ", p, k);
    if (crossings) {
        fputs("# homoclinic points:\n", file);
        write_crossings(file, p, "# ");
    }
    fprintf(jlt_csv_names_begin(&names, file), "branch,side,sigma,length,%s,%s", p->chart->names[0], p->chart->names[1]);
    jlt_csv_names_end(&names);
    for (int k = 0; k < JLT_SEPARATRICES; k++)
        for (size_t i = 0; i < p->curve[k].count; i++) {
            fprintf(file, "%s,%d,%.12g,%.12g,", branch_name(k), k % 2 == 0 ? 1 : -1, p->curve[k].sigma[i],
                    p->curve[k].length[i]);
            jlt_csv_row(file, p->curve[k].points + 2 * i, 2);
        }
}

static jlt_exit draw(const options *o, const jlt_system *system, const jlt_separatrices *p, const jlt_periodic *saddle)
{
    static const char *const halves[] = { "UNSTABLE", "STABLE" }, *const names[] = { "unstable", "stable" };
    jlt_extent extent[2] = { JLT_EXTENT_NONE, JLT_EXTENT_NONE };
    jlt_plot plot;
    FILE *stream;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    stream = plot.stream;
    for (int half = 0; half < 2; half++) {
        fprintf(stream, "$%s << END\n", halves[half]);
        for (int k = 2 * half; k < 2 * half + 2; k++) {
            for (size_t i = 0; i < p->curve[k].count; i++) {
                const double *to = p->curve[k].points + 2 * i;
                for (unsigned c = 0; c < 2; c++) jlt_extent_add(&extent[c], to[c]);
                jlt_look_line(stream, i == 0 ? to : to - 2, to, 2, p->chart->period);
            }
            fputc('\n', stream);
        }
        fputs("END\n", stream);
    }
    fputs("$CROSSINGS << END\n", stream);
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++)
            for (size_t i = 0; i < p->count[u][s]; i++) jlt_look_row(stream, p->crossings[u][s][i].q, 2);
    jlt_look_row(stream, saddle->points, 2);
    fputs("END\n", stream);
    jlt_plot_words(&plot, "Separatrices of the saddle\n");
    jlt_motion_caption(&plot, system, NULL);
    for (unsigned c = 0; c < 2; c++) jlt_motion_axis(&plot, system, c == 0 ? 'x' : 'y', c, jlt_extent_wider(extent[c]));
    fputs("plot ", stream);
    for (unsigned half = 0; half < 2; half++) {
        fprintf(stream, "$%s using 1:2 ", halves[half]);
        jlt_look_pen(stream, plot.look, (jlt_pen){ "lines", .colour = 1 + half, .size = 0.1 });
        fprintf(stream, " title '%s', ", names[half]);
    }
    fputs("$CROSSINGS using 1:2 ", stream);
    jlt_look_pen(stream, plot.look, (jlt_pen){ "points", .size = 0.3 });
    fputs(" title 'saddle and homoclinic points'\n", stream);
    return jlt_plot_draw(&plot);
}

/* Say why a file of crossings is empty: the branches end before they meet. */
static void tell_none(const jlt_separatrices *p)
{
    size_t count = 0, ended = 0;

    for (int k = 0; k < JLT_SEPARATRICES; k++) {
        count += p->count[k / 2][k % 2] + p->touching[k / 2][k % 2];
        ended += p->curve[k].end == JLT_MANIFOLD_LENGTH;
    }
    if (count == 0 && ended > 0)
        fprintf(stderr, "jellett: separatrices do not cross within --length: %zu of %d branches end there; ask for a larger one\n",
                ended, JLT_SEPARATRICES);
}

static jlt_exit save(jlt_stream *crossings, options *o, const jlt_system *system,
                     const jlt_separatrices *p, const jlt_periodic *saddle)
{
    jlt_common *common = &o->motion.common;

    jlt_motion_header(common->table.file, &o->motion, system);
    write_all(common->table.file, p, saddle, !o->no_crossings);
    jlt_exit code = jlt_common_save(common);
    if (code == JLT_EXIT_DONE && o->points != NULL) {
        jlt_motion_header(crossings->file, &o->motion, system);
        write_crossings(crossings->file, p, "");
        code = jlt_stream_close(crossings);
    }
    if (code == JLT_EXIT_DONE && jlt_motion_interrupted(&o->motion))
        fprintf(stderr, "jellett: interrupted; the branches as far as they have grown are saved in %s\n", common->table.path);
    for (int k = 0; k < JLT_SEPARATRICES && code == JLT_EXIT_DONE; k++)
        if (p->curve[k].end != JLT_MANIFOLD_LENGTH && p->curve[k].end != JLT_MANIFOLD_INTERRUPT)
            write_end(stderr, "jellett: shorter than --length: ", p, k);
    if (code == JLT_EXIT_DONE && o->points != NULL && !jlt_motion_interrupted(&o->motion)) tell_none(p);
    if (code == JLT_EXIT_DONE && common->plot != NULL) code = draw(o, system, p, saddle);
    return code;
}

static const jlt_swept_form swept = { &jlt_command_manifolds, true, 4 };

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end) options o = { .period = 1, .seed = 1e-4 };
    JLT_OWNED(jlt_system) *system = NULL;
    JLT_OWNED(jlt_map) *map = NULL;
    JLT_CLEARED(jlt_separatrices_clear) jlt_separatrices p = { .count = { { 0 } } };
    JLT_CLEARED(jlt_stream_discard) jlt_stream crossings = { 0 };
    jlt_periodic saddle;
    double q[JLT_CHART_DIM_MAX];
    jlt_exit code;
    jlt_status st = JLT_OK;

    o.growth.length_max = 1.6;
    o.growth.points_max = 4000;
    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.tolerance = 1e-13;
    jlt_motion_many_begin(&o.motion);
    ttc_options_parse(&parser, argc, argv, &o);
    o.motion.common.lanes = o.motion.flow.method == NULL;
    if (jlt_swept_done(&code, &swept, &o.motion.common)) return code;
    if (o.motion.flow.method == NULL) o.motion.flow.method = jlt_method_find(NULL);
    JLT_PASS(jlt_motion_system(&system, &o.motion));
    if (system->flow.chart->dim != 2)
        return jlt_command_fail(JLT_EXIT_INPUT, "manifolds need a section of two coordinates, not of %u%s", system->flow.chart->dim,
                                system->flow.chart->dim > 2 ? ": --level and --solve leave fewer" : "");
    JLT_PASS(jlt_motion_default_start(&o.motion, system, JLT_START_SADDLE, "say near which saddle to begin: --start"));
    JLT_PASS(jlt_motion_start(q, system, o.motion.starts[0]));
    /* Lengths are asked for in coordinates, whether or not the saddle is near 0: sizes are those of its motion, and at least 1. */
    st = jlt_scale_find(system, q, 1, (double[]){ ldexp(1, system->flow.chart->unit[0]), ldexp(1, system->flow.chart->unit[1]) });
    if (st != JLT_OK) return jlt_motion_fail(st, system, "the map");
    JLT_PASS(jlt_motion_plan(system, &o.motion));
    JLT_PASS(jlt_common_write(&o.motion.common));
    if (o.points != NULL) JLT_PASS(jlt_stream_open(&crossings, o.points));
    st = jlt_map_create(&map, &system->flow);
    if (st == JLT_OK) st = jlt_periodic_find(map, &saddle, q, o.period, NULL);
    if (st != JLT_OK) return jlt_motion_no_orbit(st, system, o.motion.starts[0]);
    const char *const *names = system->flow.chart->names;
    if (saddle.type != JLT_ORBIT_SADDLE && saddle.type != JLT_ORBIT_FLIP_SADDLE)
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "the orbit near %s (%s=%.10g, %s=%.10g) is no saddle but %s; 'jellett orbits' lists what there is",
                                o.motion.starts[0], names[0], saddle.points[0], names[1], saddle.points[1],
                                jlt_periodic_type_name(saddle.type));
    jlt_interrupt_spare(o.motion.threads);
    const jlt_kernel_batch *kernels = o.motion.common.lanes ? jlt_batch_isa_best(system->instance->descriptor, 0) : NULL;
    st = jlt_separatrices_grow(&p, map, &saddle, o.seed, &o.growth, kernels, (unsigned)o.motion.threads);
    if (st == JLT_OK && !o.no_crossings && !jlt_motion_interrupted(&o.motion)) {
        st = jlt_separatrices_cross(&p);
        if (st == JLT_ERR_NO_CONVERGENCE && jlt_motion_interrupted(&o.motion)) st = JLT_OK; /* the branches are complete */
    }
    const size_t touching = p.touching[0][0] + p.touching[0][1] + p.touching[1][0] + p.touching[1][1];
    if (touching > 0)
        fprintf(stderr,
                "jellett: at %zu places separatrices touch, or cross by no more than errors at this --tol tell, or follow a row of "
                "%d such places, behind which none is looked at: they are not listed\n",
                touching, JLT_HOMOCLINIC_ROW);
    return st == JLT_OK ? save(&crossings, &o, system, &p, &saddle) : jlt_motion_fail(st, system, o.motion.starts[0]);
}

const jlt_command jlt_command_manifolds = {
    "manifolds", "[MODEL] [OPTION...]", "Separatrices of a saddle, homoclinic points, angles, lobes", run, &parser, NULL
};
