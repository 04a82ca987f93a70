/* `jellett verify`: proves the model's claims, and compares them with what the compiled kernels compute. */
#include "claims/sample.h"
#include "cli/common.h"
#include "cli/interrupt.h"
#include "cli/table.h"
#include "cli/verify_report.h"
#include "top/top.h"

enum { KEY_SEED = 256, KEY_SAMPLES, SAMPLES_DEFAULT = 400, SAMPLES_MAX = 10000000 };

typedef struct {
    const char *model;
    bool json;
    jlt_verify_run verify;
} request;

static const struct argp_option option_table[] = {
    { "json", 'j', NULL, 0, "Print JSON", 0 },
    { "seed", KEY_SEED, "N|0", 0,
      "Seed of the random points; with the same seed the output is the same, byte for byte; default 1", 0 },
    { "samples", KEY_SAMPLES, "N", 0, "Points on each family of equilibria; default 400", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    request *r = state->input;

    switch (key) {
    case 'j': r->json = true; return 0;
    case KEY_SEED: jlt_common_count(&r->verify.seed, value, 0, INT64_MAX, "--seed"); return 0;
    case KEY_SAMPLES: jlt_common_count(&r->verify.samples, value, 1, SAMPLES_MAX, "--samples"); return 0;
    case ARGP_KEY_ARG:
        if (state->arg_num > 0) argp_error(state, "one model at most: '%s' is too many", value);
        r->model = value;
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Prove what the model claims, and verify it through the compiled kernels."
    "\v(a) Every claim of the table is proved or refuted in exact arithmetic.\n"
    "(b) Numbers are compared on every family of equilibria, at random and extreme parameters and points. The generated "
    "Jacobian, divergence and gradients are compared with the table's formulas, with ball enclosures of 256 bits, and with "
    "complex-step differentiation. Characteristic polynomials by the method of Faddeev and LeVerrier are compared with the "
    "table's and with the eigenvalues. Where the trace excludes an invariant measure, there are certificates at rational points.\n"
    "(c) The density of an invariant measure is computed from the divergence alone, where there is one.\n"
    "(d) Totals. The exit status is 0 when everything holds, and 1 when something fails.",
    NULL, NULL, NULL,
};

static jlt_exit run(int argc, char **argv)
{
    request r = { .model = JLT_DEFAULT_MODEL, .verify = { .seed = 1, .samples = SAMPLES_DEFAULT } };
    jlt_verify_run *v = &r.verify;
    jlt_command_output output = { 0 };
    const volatile sig_atomic_t *interrupt = NULL;

    argp_parse(&parser, argc, argv, 0, NULL, &r);
    bool has_said;
    JLT_PASS(jlt_table_open(&v->descriptor, &has_said, r.model, false));
    v->file = jlt_table_is_file(r.model) ? r.model : NULL;
    if (v->descriptor->equilibria_count > 0 && v->descriptor->state_count > JLT_SAMPLE_STATES_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s has %u states; verify serves up to %d where there are equilibria "
                                "('ttc prove --kernels' proves claims and kernels of any table)",
                                v->descriptor->model, v->descriptor->state_count, JLT_SAMPLE_STATES_MAX);
    if (!has_said) jlt_command_warn_unproved(v->descriptor);
    jlt_status st = jlt_verify_prove(v);
    if (st == JLT_OK) st = jlt_verify_measure(v, interrupt = jlt_interrupt_install());
    if (interrupt != NULL && *interrupt) {
        jlt_verify_clear(v);
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "interrupted; nothing is reported: verdicts need all samples");
    }
    if (st == JLT_OK) st = jlt_command_open(&output);
    if (st == JLT_OK && r.json) st = jlt_verify_report_json(output.stream, v);
    else if (st == JLT_OK) jlt_verify_report_text(output.stream, v);
    jlt_exit code = st == JLT_OK ? jlt_command_deliver(&output, NULL)
                                 : jlt_command_fail(jlt_command_exit(st), "verify %s: %s", r.model, jlt_status_text(st));
    if (code == JLT_EXIT_DONE && v->failed > 0)
        code = jlt_command_fail(JLT_EXIT_FAILED, "%s: %zu checks fail", r.model, v->failed);
    jlt_command_discard(&output);
    jlt_verify_clear(v);
    return code;
}

const jlt_command jlt_command_verify = {
    "verify", "[MODEL] [--json] [--seed N] [--samples N]",
    "Prove the model's claims, and verify them through the compiled kernels", run, &parser, NULL
};
