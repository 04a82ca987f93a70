/* `jellett measure`: the density of an invariant measure, from the divergence alone, or what excludes one. */
#include "analysis/measure.h"
#include "base/options.h"
#include "cli/plot.h"
#include "cli/swept.h"
#include "core/digits.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "report/decimal.h"
#include "report/json.h"
#include "report/symbol.h"
#include "spectrum/oracle.h"

#include <math.h>
#include <string.h>

enum { KEY_SEED = 256, KEY_POINTS, POINTS = 41, POINTS_MAX = 100001 };

typedef struct {
    jlt_common common;
    bool json, csv;
    size_t seed, points;
} request;

static const struct argp_option option_table[] = {
    { "points", KEY_POINTS, "N", 0, "Rows in the table of the density, at least 3; default 41", 1 },
    { "seed", KEY_SEED, "N|0", 0, "Seed of the random states at which the divergence is examined; default 1", 1 },
    { "json", 'j', NULL, 0, "Print JSON", 1 },
    { "csv", 'c', NULL, 0, "Print the table as CSV with a header of comments, as a sweep always does", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    request *r = state->input;

    switch (key) {
    case ARGP_KEY_INIT: state->child_inputs[0] = state->child_inputs[1] = &r->common; return 0;
    case KEY_POINTS: jlt_common_count(&r->points, value, 3, POINTS_MAX, "--points"); return 0;
    case KEY_SEED: jlt_common_count(&r->seed, value, 0, INT64_MAX, "--seed"); return 0;
    case 'j': r->json = true; return 0;
    case 'c': r->csv = true; return 0;
    case ARGP_KEY_END:
        r->csv |= r->common.sweep != NULL && !r->json;
        if (r->json && r->common.sweep != NULL) argp_error(state, "--sweep writes rows: leave out --json");
        if (r->json && r->csv) argp_error(state, "--json and --csv exclude each other");
        if (!r->csv) jlt_common_no_table(&r->common, state, "a report");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &jlt_common_argp, 0, NULL, 0 }, { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Compute the density of an invariant measure from the divergence of the field alone, or report what excludes one."
    "\vA density rho that depends on one state q alone obeys d ln rho/dq = -div f/f_q. Where the right-hand side depends on q "
    "alone, a quadrature gives rho, which is compared with the density that the table claims. Otherwise the report says by how "
    "much the right-hand side varies with the other states. It also has the residual of div(rho f) for every density that the "
    "table claims at these parameters. An equilibrium that excludes measures is proved to do so at the exact values of the "
    "parameters (1/3, 0.51).\n\n"
    "Columns:\n"
    "  PARAM             the values of --sweep\n"
    "  along, at         the name of q, the state on which the density depends; its\n"
    "                    values\n"
    "  density           as computed; 1 at the middle of what q may be\n"
    "  error             an estimate of its error, as a part of it\n"
    "  closed_form       as the table claims it; empty where it claims none\n\n"
    "Examples:\n"
    "  jellett measure --set I3=0 --plot density.svg   # of Euler and Jacobi\n"
    "  jellett measure --set a3=0                      # obstructed",
    children, NULL, NULL,
};

static const char *along_name(const jlt_measure_finding *f)
{
    return f->instance->descriptor->states[f->attempt.along].name;
}

static void write_attempt(FILE *stream, const jlt_measure_finding *f)
{
    const jlt_measure_attempt *a = &f->attempt;

    if (!a->found) {
        fputs(
            "\nno density of one state q alone: at fixed q, -div f/f_q varies with the other states, relative to its size, by\n  ",
            stream);
        jlt_decimal_write_rounded(stream, f->instance->descriptor->states, a->defects, f->instance->descriptor->state_count);
        fputc('\n', stream);
        return;
    }
    fprintf(stream, "\ndensity of %s alone: -div f/f_q is a function of it (defect %.2g)\n", along_name(f), a->defect);
    if (a->singular) {
        fprintf(stream, "it has a pole or a zero where %s' = 0, so it is no smooth positive density\n", along_name(f));
        return;
    }
    if (a->turn != 1.0) {
        fprintf(stream, "it changes by the factor %.6g in a period of %s, so it is no density of an angle\n", a->turn,
                along_name(f));
        return;
    }
    if (a->points == NULL) {
        fputs("it is not tabulated: its slope -div f/f_q changes too fast, or grows beyond bounds, for the quadrature\n", stream);
        return;
    }
    if (a->closed_form != NULL)
        fprintf(stream, "against the closed form %s: largest relative difference %.2g (bound %.2g)\n", a->closed_form,
                a->difference, a->difference_bound);
    fprintf(stream, "\n%24s %24s", along_name(f), "density");
    if (a->closed != NULL) fprintf(stream, " %24s", a->closed_form);
    fputs("   (1 in the middle)\n", stream);
    for (size_t i = 0; i < a->count; i++) {
        fprintf(stream, "%24.16g %24.16g", a->points[i].at, a->points[i].density);
        if (a->closed != NULL) fprintf(stream, " %24.16g", a->closed[i]);
        fputc('\n', stream);
    }
}

static bool has_kernel(const jlt_descriptor *of, const char *density)
{
    for (unsigned i = 0; i < of->measure_count; i++)
        if (strcmp(of->measures[i].name, density) == 0) return true;
    return false;
}

/* What the prover says of the claim of a density. */
static const char *verdict_of(const jlt_descriptor *of, const char *density)
{
    static const char *const words[] = { [JLT_PROVED] = "proved", [JLT_REFUTED] = "refuted", [JLT_UNSETTLED] = "not settled" };

    return words[jlt_descriptor_claim(of, "measure", density)->verdict];
}

static void write_claims(FILE *stream, const jlt_measure_finding *f)
{
    const jlt_descriptor *d = f->instance->descriptor;
    bool is_any = d->measure_count > 0;

    for (unsigned i = 0; i < d->measure_count; i++) {
        const char *name = d->measures[i].name, *verdict = verdict_of(d, name);
        fprintf(stream, "table        density %s: |div(rho f)| is at most %.2g of its terms over %d random states", name,
                f->residual[i], JLT_MEASURE_SAMPLES);
        if (strcmp(verdict, "proved") != 0) fprintf(stream, "; its claim is %s", verdict);
        fputc('\n', stream);
    }
    for (const jlt_claim *claim = d->claims; claim->kind != NULL; claim++) {
        if (strcmp(claim->kind, "measure") != 0 || claim->verdict != JLT_PROVED || has_kernel(d, claim->name)) continue;
        fprintf(stream, "table        density %s, claimed where %s, is not compared: no record 'variant' that sets this holds at "
                "these parameters\n", claim->name, claim->condition);
        is_any = true;
    }
    if (!is_any) fputs("table        claims no invariant density at these parameters\n", stream);
}

static void write_text(FILE *stream, const jlt_measure_finding *f)
{
    const jlt_descriptor *d = f->instance->descriptor;
    char trace[JLT_DIGITS_SIZE];

    fprintf(stream, "%s%s%s\nkernels      %s, table %.12s\nparameters  ", d->model, *d->title == '\0' ? "" : ": ", d->title,
            d->variant[0] == '\0' ? "general" : d->variant, d->sha256);
    jlt_decimal_write_named(stream, d->params, f->instance->params, d->param_count);
    fputc('\n', stream);
    write_claims(stream, f);
    write_attempt(stream, f);
    if (!f->obstructed) return;
    fprintf(stream, "\nobstruction: at the equilibrium");
    jlt_decimal_write_named(stream, d->states, f->x, d->state_count);
    jlt_digits_shortest(trace, f->obstruction.trace);
    fprintf(stream, "\nthe trace is %s (", trace);
    jlt_decimal_write_error(stream, f->obstruction.trace_error);
    fputs("), so no invariant measure has a smooth positive density\n", stream);
}

static json_t *obstruction_json(const jlt_measure_finding *f)
{
    const jlt_descriptor *d = f->instance->descriptor;

    if (!f->obstructed) return json_null();
    return json_pack("{s:o,s:o,s:o}", "state", jlt_json_named(d->states, f->x, d->state_count), "trace",
                     jlt_json_number(f->obstruction.trace), "trace_error", jlt_json_number(f->obstruction.trace_error));
}

static jlt_status write_json(FILE *stream, const jlt_measure_finding *f)
{
    const jlt_descriptor *d = f->instance->descriptor;
    const jlt_measure_attempt *a = &f->attempt;
    json_t *measures = json_array(), *table = json_array();

    for (unsigned i = 0; i < d->measure_count; i++)
        json_array_append_new(measures, json_pack("{s:s,s:s,s:o}", "name", d->measures[i].name, "verdict",
                                                  verdict_of(d, d->measures[i].name), "residual", jlt_json_number(f->residual[i])));
    for (size_t i = 0; a->points != NULL && i < a->count; i++)
        json_array_append_new(table, json_pack("{s:o,s:o,s:o}", "at", jlt_json_number(a->points[i].at), "density",
                                               jlt_json_number(a->points[i].density), "closed_form",
                                               jlt_json_number(a->closed == NULL ? NAN : a->closed[i])));
    return jlt_json_write(stream,
                          json_pack("{s:s,s:s,s:s,s:o,s:o,s:s,s:o,s:o,s:b,s:b,s:o,s:o,s:o,s:o,s:o}", "model", d->model, "sha256",
                                    d->sha256, "variant", d->variant, "parameters",
                                    jlt_json_named(d->params, f->instance->params, d->param_count), "measures", measures, "along",
                                    along_name(f), "defect", jlt_json_number(a->defect), "defects",
                                    jlt_json_named(d->states, a->defects, d->state_count), "found", a->found, "singular",
                                    a->singular, "turn", jlt_json_number(a->turn), "closed_form", jlt_json_string(a->closed_form),
                                    "difference", jlt_json_number(a->closed_form == NULL ? NAN : a->difference), "table", table,
                                    "obstruction", obstruction_json(f)));
}

static jlt_status write_csv(FILE *stream, const jlt_measure_finding *f, const request *r)
{
    const jlt_measure_attempt *a = &f->attempt;
    const jlt_instance *instance = f->instance;
    JLT_FREED double *params = jlt_common_steady(&r->common, instance->descriptor, instance->params);
    jlt_csv_names names;

    if (params == NULL) return JLT_ERR_NOMEM;
    jlt_csv_header(stream, &(jlt_csv_settings){ .command = r->common.command, .descriptor = instance->descriptor,
                                                .params = params });
    fprintf(stream, "# defect of %s: %.17g\n", along_name(f), a->defect);
    fputs("along,at,density,error,closed_form", jlt_csv_names_begin(&names, stream));
    jlt_csv_names_end(&names);
    for (size_t i = 0; a->points != NULL && i < a->count; i++) {
        const double row[4] = { a->points[i].at, a->points[i].density, a->points[i].error,
                                a->closed == NULL ? NAN : a->closed[i] };
        fprintf(stream, "%s,", along_name(f));
        jlt_csv_row(stream, row, 4);
    }
    return JLT_OK;
}

/* Compare what the table claims with what was computed. */
static jlt_exit judge(const jlt_measure_finding *f)
{
    const jlt_descriptor *d = f->instance->descriptor;
    const jlt_measure_attempt *a = &f->attempt;
    jlt_exit code = JLT_EXIT_DONE;

    for (unsigned i = 0; i < d->measure_count; i++) {
        const char *name = d->measures[i].name;
        const jlt_claim *claim = jlt_descriptor_claim(d, "measure", name);
        if (!(f->residual[i] <= JLT_DENSITY_TOLERANCE))
            code = jlt_command_fail(JLT_EXIT_FAILED, "the density %s is not invariant: |div(rho f)| is %.2g of its terms, %.0e is "
                                                     "allowed", name, f->residual[i], JLT_DENSITY_TOLERANCE);
        else if (claim->verdict == JLT_REFUTED)
            code = jlt_command_fail(JLT_EXIT_FAILED, "the density %s is not invariant, by less than random states show: its claim "
                                                     "is refuted: %s", name, claim->reason);
    }
    if (a->closed_form != NULL && !(a->difference <= a->difference_bound))
        code = jlt_command_fail(JLT_EXIT_FAILED, "the density %s differs from the quadrature by %.2g, %.2g is allowed",
                                a->closed_form, a->difference, a->difference_bound);
    return code;
}

static jlt_exit draw(const jlt_measure_finding *f, const request *r)
{
    const jlt_descriptor *d = f->instance->descriptor;
    const jlt_measure_attempt *a = &f->attempt;
    char label[JLT_LOOK_LABEL_MAX];
    jlt_extent extent = JLT_EXTENT_NONE;
    jlt_plot plot;
    FILE *stream;

    if (a->points == NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "--plot: there is no density to draw at these parameters");
    if (jlt_plot_open(&plot, &r->common) != JLT_OK) return jlt_command_no_memory();
    stream = plot.stream;
    fputs("$DENSITY << END\n", stream);
    for (size_t i = 0; i < a->count; i++) {
        jlt_extent_add(&extent, a->points[i].density);
        if (a->closed != NULL) jlt_extent_add(&extent, a->closed[i]);
        jlt_look_row(stream, (const double[]){ a->points[i].at, a->points[i].density, a->closed == NULL ? NAN : a->closed[i] }, 3);
    }
    fputs("END\n", stream);
    jlt_plot_words(&plot, "Density of an invariant measure of %s\n", d->model);
    for (unsigned i = 0; i < d->param_count; i++) jlt_plot_value(&plot, d->params[i].name, f->instance->params[i]);
    jlt_plot_label(label, d, along_name(f));
    jlt_plot_axis(&plot, 'x', label, jlt_extent_wider((jlt_extent){ a->points[0].at, a->points[a->count - 1].at }), 0);
    jlt_plot_axis(&plot, 'y', "density, 1 in the middle", jlt_extent_wider(extent), 0);
    fputs(JLT_LOOK_GRID "plot ", stream);
    if (a->closed != NULL) {
        fputs("$DENSITY using 1:3 ", stream);
        jlt_look_pen(stream, plot.look, (jlt_pen){ "lines", .colour = 2 });
        fputs(" title '", stream);
        jlt_symbol_write(stream, a->closed_form);
        fputs("', ", stream);
    }
    fputs("$DENSITY using 1:2 ", stream);
    jlt_look_pen(stream, plot.look, (jlt_pen){ "points", .mark = 3, .size = 0.7 });
    fputs(" title 'quadrature of the divergence'\n", stream);
    return jlt_plot_draw(&plot);
}

static jlt_exit deliver(const jlt_measure_finding *f, const request *r)
{
    jlt_command_output output;
    jlt_status st = jlt_command_open(&output);

    if (st == JLT_OK) {
        if (r->json) st = write_json(output.stream, f);
        else if (r->csv) st = write_csv(output.stream, f, r);
        else write_text(output.stream, f);
    }
    if (st == JLT_OK) return jlt_stream_deliver(&output, r->common.output);
    jlt_command_discard(&output);
    return jlt_command_fail(JLT_EXIT_NUMERICAL, "%s", jlt_status_text(st));
}

static const char *why_not(jlt_status st)
{
    if (st == JLT_ERR_NONFINITE) return " (use units in which parameters are nearer one)";
    return st == JLT_ERR_NO_CONVERGENCE
               ? ": of random states hardly one lies in the table's domain and has a field and a divergence "
                 "(use units in which parameters and intervals are nearer one, or another domain)"
               : "";
}

static const jlt_swept_form swept = { &jlt_command_measure, false, 2 };

static jlt_exit run(int argc, char **argv)
{
    request r = { .seed = 1, .points = POINTS };
    JLT_FREED jlt_measure_finding *f = calloc(1, sizeof *f);
    const jlt_descriptor *general = NULL;
    JLT_FREED double *params = NULL;
    JLT_FREED const char **exact = NULL;
    JLT_OWNED(jlt_oracle) *oracle = NULL;
    jlt_random random;
    jlt_exit code = JLT_EXIT_NUMERICAL;

    jlt_common_begin(&r.common, argc, argv);
    ttc_options_parse(&parser, argc, argv, &r);
    if (jlt_swept_done(&code, &swept, &r.common)) goto done;
    if (f == NULL) {
        code = jlt_command_no_memory();
        goto done;
    }
    code = jlt_common_open(&r.common, &general, &params);
    if (code == JLT_EXIT_DONE && general->state_count > JLT_MEASURE_STATES_MAX)
        code = jlt_command_fail(JLT_EXIT_INPUT, "%s has %u states; measure serves up to %d", general->model, general->state_count,
                                JLT_MEASURE_STATES_MAX);
    if (code == JLT_EXIT_DONE && general->measure_count > JLT_MEASURE_CLAIMS_MAX)
        code = jlt_command_fail(JLT_EXIT_INPUT, "%s has %u densities; measure serves up to %d", general->model,
                                general->measure_count, JLT_MEASURE_CLAIMS_MAX);
    if (code == JLT_EXIT_DONE && r.common.plan) code = jlt_common_still();
    if (code != JLT_EXIT_DONE) goto done;
    if (jlt_oracle_create(&oracle, general, NULL) != JLT_OK
        || (exact = jlt_common_exact(&r.common, general, oracle->defaults)) == NULL) {
        code = jlt_command_no_memory();
        goto done;
    }
    jlt_random_seed(&random, r.seed);
    const jlt_status st = jlt_measure_find(f, general, params, exact, r.points, &random);
    if (st != JLT_OK)
        code = jlt_command_fail(jlt_command_exit(st), "measure %s: %s%s", general->model, jlt_status_text(st),
                                why_not(st));
    if (code == JLT_EXIT_DONE) code = deliver(f, &r);
    if (code == JLT_EXIT_DONE && r.common.plot != NULL) code = draw(f, &r);
    if (code == JLT_EXIT_DONE) code = judge(f);
done:
    if (f != NULL) jlt_measure_forget(f);
    jlt_common_end(&r.common);
    return code;
}

const jlt_command jlt_command_measure = {
    "measure", "[MODEL] [OPTION...]",
    "An invariant density from the divergence alone, or what excludes one", run, &parser, NULL
};
