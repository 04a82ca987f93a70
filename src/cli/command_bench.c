#include "cli/bench.h"
#include "cli/command.h"
#include "cli/grid.h"
#include "cli/progress.h"
#include "integrate/method.h"
#include "report/picture.h"

#include <argp.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *reference, *output, *picture, *script;
    size_t returns, repeats, threads;
    bool quick;
} options;

static const struct argp_option option_table[] = {
    { "reference", 'r', "FILE", 0, "Starts and true returns: CSV with columns orbit, return, t, gamma3, v_nu, omega_n, omega3", 0 },
    { "returns", 'n', "N", 0, "Returns of every orbit; default 50", 0 },
    { "repeats", 'k', "N", 0, "Runs that are counted, after one that is not; default 3", 0 },
    { "threads", 't', "N", 0, "Measure batches on so many threads too; default 1", 0 },
    { "quick", 'q', NULL, 0, "Only the form and the methods that sections use", 0 },
    { "output", 'o', "FILE", 0, "Where the table goes; default standard output", 0 },
    { "plot", 'p', "FILE", 0, "Draw the work-precision diagram: .svg, .png or .pdf", 0 },
    { "keep", 's', "FILE", 0, "Keep the gnuplot script with its data", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;
    jlt_exit code = JLT_EXIT_DONE;

    switch (key) {
    case 'r': o->reference = value; return 0;
    case 'n': code = jlt_grid_count(&o->returns, value, 1, 1000000, "--returns"); break;
    case 'k': code = jlt_grid_count(&o->repeats, value, 1, 100, "--repeats"); break;
    case 't': code = jlt_grid_count(&o->threads, value, 1, 1024, "--threads"); break;
    case 'q': o->quick = true; return 0;
    case 'o': o->output = value; return 0;
    case 'p':
        if (!jlt_picture_known(value)) argp_error(state, "--plot wants a name that ends in .svg, .png or .pdf");
        o->picture = value;
        return 0;
    case 's': o->script = value; return 0;
    case ARGP_KEY_END:
        if (o->reference == NULL) argp_error(state, "--reference FILE is needed: errors are measured against it");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
    if (code != JLT_EXIT_DONE) exit((int)code);
    return 0;
}

static const struct argp parser = {
    option_table, parse, NULL,
    "Speed against accuracy of the section map of the spherical top, parameters (5.1): every method on every form of the "
    "field, every tolerance a row."
    "\vColumns: program, method, form, threads, tolerance, error, returns_per_second (median), slowest, fastest, "
    "steps_per_return, failed. The error is the largest in gamma3, v_nu, omega3 over the returns that the reference knows; it "
    "is empty where an orbit failed before, and `failed` counts such orbits.\n\n"
    "  jellett bench --reference tests/reference/data/grid_regular_51.csv --plot work.svg > work.csv",
    NULL, NULL, NULL,
};

/* A curve of the diagram: scalar when lanes is 0. */
typedef struct {
    const jlt_bench_form *form;
    const char *method;
    unsigned lanes, threads;
} curve;

enum { CURVES = 64 };

static size_t list_curves(curve *out, const options *o)
{
    static const unsigned lanes[] = { 8, 4, 2 };
    static const char *const names[] = { "dop853 x8", "dop853 x4", "dop853 x2" };
    size_t count = 0;

    for (const jlt_bench_form *form = jlt_bench_forms; form->name != NULL; form++) {
        const bool main_form = form == jlt_bench_forms;
        if (o->quick && !main_form) break;
        const jlt_method *method;
        for (size_t i = 0; (method = jlt_method_at(i)) != NULL && count < CURVES; i++)
            out[count++] = (curve){ form, method->name, 0, 1 };
        for (unsigned i = 0; i < 3 && count < CURVES; i++) out[count++] = (curve){ form, names[i], lanes[i], 1 };
        if (main_form && o->threads > 1 && count < CURVES)
            out[count++] = (curve){ form, names[0], lanes[0], (unsigned)o->threads };
    }
    return count;
}

static jlt_status measure(jlt_bench_result *result, const curve *c, const options *o, const jlt_bench_grid *grid, double tolerance)
{
    if (c->lanes > 0)
        return jlt_bench_batch(result, c->form, c->lanes, c->threads, grid, tolerance, o->returns, (unsigned)o->repeats);
    return jlt_bench_scalar(result, c->form, c->method, grid, tolerance, o->returns, (unsigned)o->repeats);
}

static void write_row(FILE *file, const curve *c, double tolerance, const jlt_bench_result *r)
{
    fprintf(file, "jellett,%s,%s,%u,%g,", c->method, c->form->name, c->threads, tolerance);
    if (isfinite(r->error)) fprintf(file, "%.3e", r->error);
    fprintf(file, ",%.0f,%.0f,%.0f,%.2f,%zu\n", r->returns / r->seconds[1], r->returns / r->seconds[2],
            r->returns / r->seconds[0], r->steps, r->failed);
}

static void write_header(FILE *file, const options *o, const jlt_bench_grid *grid, const char *command)
{
    char line[256];
    FILE *cpu = fopen("/proc/cpuinfo", "r");

    fprintf(file, "# %s\n# jellett %s, compiler %s\n", command, JLT_VERSION, __VERSION__);
    while (cpu != NULL && fgets(line, sizeof line, cpu) != NULL)
        if (strncmp(line, "model name", 10) == 0) {
            fprintf(file, "# processor%s", strchr(line, ':'));
            break;
        }
    if (cpu != NULL) fclose(cpu);
    fprintf(file, "# %zu orbits, %zu returns each, %zu repeats; errors over the first %zu returns against %s\n", grid->orbits,
            o->returns, o->repeats, grid->checked, o->reference);
    fputs("program,method,form,threads,tolerance,error,returns_per_second,slowest,fastest,steps_per_return,failed\n", file);
}

static void write_points(FILE *points, const jlt_bench_result *r)
{
    if (isfinite(r->error) && r->error > 0)
        fprintf(points, "%.3e %.6e %.6e %.6e\n", r->error, 1e6 * r->seconds[1] / r->returns, 1e6 * r->seconds[0] / r->returns,
                1e6 * r->seconds[2] / r->returns);
}

static jlt_exit draw(const options *o, const char *blocks, const curve *curves, size_t count)
{
    char *script = NULL;
    size_t size;
    FILE *stream = open_memstream(&script, &size);

    if (stream == NULL) return jlt_command_fail(JLT_EXIT_NUMERICAL, "%s", jlt_status_text(JLT_ERR_NOMEM));
    fputs("set encoding utf8\n", stream);
    fputs(blocks, stream);
    fputs("set logscale xy\nset format x '10^{%T}'\nset xlabel 'largest error in γ_3, v_ν, ω_3 over the first returns'\n"
          "set ylabel 'time per return [µs], median; bars: least and largest'\nset key outside right\n"
          "set title 'Section map of the spherical top at (5.1)'\nplot ", stream);
    for (size_t i = 0; i < count; i++)
        fprintf(stream, "%s$C%zu using 1:2:3:4 with yerrorlines pt %zu ps 0.5 title '%s, %s%s'", i == 0 ? "" : ", \\\n  ", i, i % 13 + 1,
                curves[i].method, curves[i].form->name, curves[i].threads > 1 ? ", threads" : "");
    fputs("\n", stream);
    fclose(stream);
    const jlt_status st = jlt_picture_draw(o->picture, script, o->script);
    free(script);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_command_fail(jlt_command_exit(st), "%s: %s", o->picture, jlt_status_text(st));
}

/* All curves, a row a tolerance. A method without such a kernel, or lanes that the processor has not, are passed over. */
static jlt_exit run_all(FILE *table, FILE *points, const options *o, const jlt_bench_grid *grid, curve *curves, size_t *count)
{
    jlt_progress progress;
    size_t kept = 0;

    jlt_progress_start(&progress, "curves");
    for (size_t i = 0; i < *count; i++) {
        jlt_status st = JLT_OK;
        fprintf(points, "$C%zu << END\n", kept);
        for (int decade = -5; decade >= -15 && st == JLT_OK; decade--) {
            const double tolerance = pow(10, decade);
            jlt_bench_result r;
            st = measure(&r, &curves[i], o, grid, tolerance);
            if (st != JLT_OK) break;
            write_row(table, &curves[i], tolerance, &r);
            write_points(points, &r);
        }
        fputs("END\n", points);
        if (st == JLT_OK) curves[kept++] = curves[i];
        else if (st != JLT_ERR_UNSUPPORTED) return jlt_command_fail(jlt_command_exit(st), "%s on %s: %s", curves[i].method, curves[i].form->name, jlt_status_text(st));
        jlt_progress_show(&progress, i + 1, *count);
    }
    jlt_progress_end(&progress);
    *count = kept;
    return JLT_EXIT_DONE;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .returns = 50, .repeats = 3, .threads = 1 };
    jlt_bench_grid grid = { 0 };
    jlt_command_output output = { 0 };
    curve curves[CURVES];
    char *command = jlt_command_line(argc, argv), *blocks = NULL;
    size_t size;
    FILE *points = NULL;
    jlt_exit code = JLT_EXIT_NUMERICAL;

    if (argp_parse(&parser, argc, argv, 0, NULL, &o) != 0) {
        code = JLT_EXIT_USAGE;
        goto done;
    }
    const jlt_status st = jlt_bench_read(&grid, o.reference);
    if (st != JLT_OK) {
        code = jlt_command_fail(st == JLT_ERR_IO ? JLT_EXIT_IO : JLT_EXIT_INPUT, "%s: %s (expected CSV with the columns of 'jellett bench --help')",
                                o.reference, jlt_status_text(st));
        goto done;
    }
    points = open_memstream(&blocks, &size);
    if (command == NULL || points == NULL || jlt_command_open(&output) != JLT_OK) {
        code = jlt_command_fail(JLT_EXIT_NUMERICAL, "%s", jlt_status_text(JLT_ERR_NOMEM));
        goto done;
    }
    size_t count = list_curves(curves, &o);
    write_header(output.stream, &o, &grid, command);
    code = run_all(output.stream, points, &o, &grid, curves, &count);
    if (code == JLT_EXIT_DONE) code = jlt_command_deliver(&output, o.output);
    if (code == JLT_EXIT_DONE && o.picture != NULL && fflush(points) == 0) code = draw(&o, blocks, curves, count);
done:
    jlt_command_discard(&output);
    if (points != NULL) fclose(points);
    free(blocks);
    free(command);
    jlt_bench_clear(&grid);
    return code;
}

const jlt_command jlt_command_bench = {
    "bench", "--reference FILE [OPTION...]", "Speed against accuracy: every method on every form of the field", run,
};
