/* The command line of jellett-bench: picks the kind of measurement, and opens the table that is written. */
#include "base/options.h"
#include "bench.h"
#include "cli/common.h"
#include "cli/program.h"
#include "kernel/descriptor.h"
#include "top/top.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const jlt_bench_kind *const kinds[] = {
    &jlt_bench_section, &jlt_bench_slope, &jlt_bench_jacobian, &jlt_bench_eigenvalues, &jlt_bench_tiers,
};

enum { KINDS = sizeof kinds / sizeof *kinds };

typedef struct {
    const jlt_bench_kind *kind;
    const char *output;
    unsigned long typed; /* bit n: the option whose letter is n behind 'a' */
    jlt_bench_options bench;
} options;

static const struct argp_option option_table[] = {
    { "reference", 'r', "FILE", 0, "File of true values, as CSV in the form of tests/reference/data", 0 },
    { "form", 'f', "TIER", 0, "Measure only this tier", 0 },
    { "method", 'm', "NAME", 0, "Measure only this method", 0 },
    { "returns", 'n', "N", 0, "Follow every orbit for N returns; default 200", 0 },
    { "repeats", 'k', "N", 0, "Measure N runs, after one that is not counted; default 3", 0 },
    { "threads", 't', "N", 0, "Also measure batches on N threads; default 1", 0 },
    { "quick", 'q', NULL, 0, "Measure only at every third tolerance", 0 },
    { "list", 'l', NULL, 0,
      "Measure nothing, but list the tiers and methods of section, or the methods of slope; --reference is needed here too", 0 },
    { "output", 'o', "FILE", 0, "Write the table to FILE; default standard output", 0 },
    { 0 },
};

/* Refuse options that this kind does not take, which would otherwise have no effect. */
static void check_typed(const options *o, const struct argp_state *state)
{
    for (const struct argp_option *each = option_table; each->name != NULL; each++)
        if ((o->typed >> (each->key - 'a') & 1) != 0 && strchr(o->kind->takes, each->key) == NULL)
            argp_error(state, "%s knows no --%s", o->kind->name, each->name);
    if (strchr(o->kind->takes, 'r') != NULL && o->bench.reference == NULL)
        argp_error(state, "%s needs --reference FILE: errors are measured against it", o->kind->name);
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    if (key >= 'a' && key <= 'z') o->typed |= 1ul << (key - 'a');
    switch (key) {
    case 'r': o->bench.reference = value; return 0;
    case 'f': o->bench.form = value; return 0;
    case 'm': o->bench.method = value; return 0;
    case 'n': jlt_common_count(&o->bench.returns, value, 1, 1000000, "--returns"); return 0;
    case 'k': jlt_common_count(&o->bench.repeats, value, 1, 1000, "--repeats"); return 0;
    case 't': jlt_common_count(&o->bench.threads, value, 1, 1024, "--threads"); return 0;
    case 'q': o->bench.quick = true; return 0;
    case 'l': o->bench.list = true; return 0;
    case 'o': o->output = value; return 0;
    case ARGP_KEY_ARG:
        for (size_t i = 0; o->kind == NULL && i < KINDS; i++)
            if (strcmp(kinds[i]->name, value) == 0) o->kind = kinds[i];
        if (state->arg_num > 0 || o->kind == NULL) argp_error(state, "'%s' is no kind of question; see --help", value);
        return 0;
    case ARGP_KEY_END:
        if (o->kind == NULL) argp_error(state, "what is to be measured? See --help");
        check_typed(o, state);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

/* Append the list of kinds to the help, after the options. */
static char *help_filter(int key, const char *text, void *input)
{
    char *out = NULL;
    size_t size;
    FILE *stream;

    (void)input;
    if (key != ARGP_KEY_HELP_POST_DOC || (stream = open_memstream(&out, &size)) == NULL) return (char *)(uintptr_t)text;
    fputs("KIND and the columns of its table:\n", stream);
    for (size_t i = 0; i < KINDS; i++)
        fprintf(stream, "\n  %s: %s\n    %s\n", kinds[i]->name, kinds[i]->meaning, kinds[i]->columns);
    fputs("\nTimes are medians of the repeats, with the least and the largest. An error is empty where the method failed before it "
          "could be measured. Example:\n\n  jellett bench section --reference tests/reference/data/grid_regular_51.csv \\\n"
          "    --form level\n", stream);
    fclose(stream);
    return out;
}

static const struct argp parser = {
    option_table, parse, "KIND",
    "Measure speed against accuracy: what the same question costs with every method, and how large the error of the answer is."
    "\vKinds", NULL, help_filter, NULL,
};

static void write_header(FILE *file, const options *o, const char *command)
{
    char line[256];
    FILE *cpu = fopen("/proc/cpuinfo", "r");

    fprintf(file, "# %s\n# jellett %s, compiler %s, flags %s\n", command, JLT_VERSION, __VERSION__, JLT_FLAGS);
    while (cpu != NULL && fgets(line, sizeof line, cpu) != NULL)
        if (strncmp(line, "model name", 10) == 0) {
            fprintf(file, "# processor%s", strchr(line, ':'));
            break;
        }
    if (cpu != NULL) fclose(cpu);
    fprintf(file, "%s\n", o->kind->columns);
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .bench = { .returns = 200, .repeats = 3, .threads = 1 } };
    jlt_command_output output = { 0 };
    char *command = jlt_command_line(argc, argv);
    jlt_exit code = JLT_EXIT_USAGE;

    ttc_options_parse(&parser, argc, argv, &o);
    const jlt_command_file files[] = { { "--output", o.output }, { "--reference", o.bench.reference } };
    code = jlt_command_distinct(files, o.bench.reference != NULL ? 2 : 1);
    if (code == JLT_EXIT_DONE) code = jlt_command_check_output(o.output);
    if (code != JLT_EXIT_DONE) goto done;
    if (command == NULL || jlt_command_open(&output) != JLT_OK) {
        code = jlt_command_no_memory();
        goto done;
    }
    const jlt_descriptor *model = jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL);
    if (!o.bench.list && model != NULL) jlt_command_warn_unproved(model);
    if (!o.bench.list) write_header(output.stream, &o, command);
    const long before = ftell(output.stream);
    code = o.kind->run(output.stream, &o.bench);
    if (code == JLT_EXIT_DONE && ftell(output.stream) == before)
        code = jlt_command_fail(JLT_EXIT_INPUT,
                                "%s: nothing goes by these names; without %s--method, --list shows what there is", o.kind->name,
                                strchr(o.kind->takes, 'f') != NULL ? "--form and " : "");
    if (code == JLT_EXIT_DONE) code = jlt_command_deliver(&output, o.output);
done:
    jlt_command_discard(&output);
    free(command);
    return code;
}

int main(int argc, char **argv)
{
    const jlt_command bench = { .name = "bench", .run = run };
    const jlt_exit begun = jlt_program_begin();

    return (int)(begun == JLT_EXIT_DONE ? jlt_program_run(&bench, argc, argv) : begun);
}
