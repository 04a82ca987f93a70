#include "cli/common.h"
#include "cli/interrupt.h"
#include "cli/table.h"
#include "cli/verify.h"
#include "top/top.h"


#include <stdlib.h>

enum { KEY_SEED = 256, KEY_SAMPLES, SAMPLES_DEFAULT = 400, SAMPLES_MAX = 10000000 };

static const struct argp_option option_table[] = {
    { "json", 'j', NULL, 0, "Print JSON", 0 },
    { "seed", KEY_SEED, "N", 0, "Seed of the random points; the same seed gives the same output, byte for byte (1)", 0 },
    { "samples", KEY_SAMPLES, "N", 0, "Points on each family of equilibria (400)", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_verify_run *run = state->input;

    switch (key) {
    case 'j': run->json = true; return 0;
    case KEY_SEED: jlt_common_count(&run->seed, value, 0, INT64_MAX, "--seed"); return 0;
    case KEY_SAMPLES: jlt_common_count(&run->samples, value, 1, SAMPLES_MAX, "--samples"); return 0;
    case ARGP_KEY_ARG:
        if (state->arg_num > 0) argp_error(state, "one model at most: '%s' is too many", value);
        run->model = value;
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Prove what the model claims, and verify it through the compiled kernels."
    "\v(a) Every claim of the table is proved or refuted in exact arithmetic.\n"
    "(b) On every family of equilibria, at random and extreme parameters and points, the generated Jacobian, divergence and "
    "gradients are compared with the table's formulas, with ball enclosures of 256 bits and with complex-step "
    "differentiation; characteristic polynomials by the method of Faddeev and LeVerrier with the table's and with the "
    "eigenvalues; and where the trace excludes an invariant measure, certificates at rational points.\n"
    "(c) The density of an invariant measure is computed from the divergence alone, where there is one.\n"
    "(d) Totals. Exit status 0 when all holds, 1 when something fails.",
    NULL, NULL, NULL,
};

void jlt_verify_clear(jlt_verify_run *run)
{
    ttc_proof_report_destroy(run->proofs);
    for (size_t i = 0; i < run->certificate_count; i++) {
        free(run->certificates[i].point);
        free(run->certificates[i].trace);
        free(run->certificates[i].enclosure);
    }
    for (size_t i = 0; i < run->density_count; i++) free(run->densities[i].params);
    free(run->families);
    free(run->certificates);
    free(run->densities);
    jlt_oracle_destroy(run->oracle);
}

static jlt_status verify(jlt_verify_run *run)
{
    jlt_status st;

    JLT_TRY(jlt_oracle_create(&run->oracle, run->descriptor));
    jlt_random_seed(&run->random, run->seed);
    JLT_TRY(jlt_verify_prove(run));
    run->interrupt = jlt_interrupt_install();
    JLT_TRY(jlt_verify_families(run));
    JLT_TRY(jlt_verify_certify(run));
    JLT_TRY(jlt_verify_densities(run));
done:
    return st;
}

static jlt_exit run_command(int argc, char **argv)
{
    jlt_verify_run run = { .model = JLT_DEFAULT_MODEL, .seed = 1, .samples = SAMPLES_DEFAULT };
    jlt_command_output output = { 0 };
    jlt_exit code;
    jlt_status st;

    argp_parse(&parser, argc, argv, 0, NULL, &run);
    code = jlt_table_open(&run.descriptor, run.model, false);
    if (code != JLT_EXIT_DONE) return code;
    jlt_command_warn_unproved(run.descriptor);
    st = verify(&run);
    if (run.interrupt != NULL && *run.interrupt) {
        jlt_verify_clear(&run);
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "interrupted; nothing is reported: verdicts need all samples");
    }
    if (st == JLT_OK) st = jlt_command_open(&output);
    if (st == JLT_OK) {
        if (run.json) st = jlt_verify_write_json(output.stream, &run);
        else jlt_verify_write_text(output.stream, &run);
    }
    if (st == JLT_OK) code = jlt_command_deliver(&output, NULL);
    else code = jlt_command_fail(jlt_command_exit(st), "verify %s: %s", run.model, jlt_status_text(st));
    if (code == JLT_EXIT_DONE && run.failed > 0)
        code = jlt_command_fail(JLT_EXIT_FAILED, "%s: %zu checks fail", run.model, run.failed);
    jlt_command_discard(&output);
    jlt_verify_clear(&run);
    return code;
}

const jlt_command jlt_command_verify = {
    "verify", "[MODEL] [--json] [--seed N] [--samples N]",
    "Prove the model's claims, and verify them through the compiled kernels", run_command
};
