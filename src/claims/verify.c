#include "claims/verify.h"

#include <stdlib.h>
#include <string.h>

#include "kernel/descriptor.h"

jlt_status jlt_verify_measure(jlt_verify_run *run, const volatile sig_atomic_t *interrupt)
{
    run->interrupt = interrupt;
    JLT_PASS(jlt_verify_families(run));
    JLT_PASS(jlt_verify_certify(run));
    return jlt_verify_densities(run);
}

void jlt_verify_clear(jlt_verify_run *run)
{
    ttc_proof_report_destroy(run->proofs);
    for (size_t i = 0; i < run->certificate_count; i++) {
        free(run->certificates[i].point);
        free(run->certificates[i].trace);
        free(run->certificates[i].enclosure);
    }
    for (size_t i = 0; i < run->density_count; i++) {
        jlt_measure_clear(&run->densities[i].attempt);
        free(run->densities[i].params);
    }
    free(run->families);
    free(run->certificates);
    free(run->densities);
    jlt_oracle_destroy(run->oracle);
}

/* ---- exact proofs of the claims, and the other tables that these name ---- */

/* Whether `target` is the file of the table `name`, "NAME.tt". */
static bool is_file_of(const char *target, const char *name)
{
    const size_t length = strlen(name);
    return strncmp(name, target, length) == 0 && strcmp(target + length, ".tt") == 0;
}

/* Find the table that a claim names: beside the user's own file; for a built-in table, another built-in table, or a table of
 * coordinates that a section holds. */
static ttc_model *resolve(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    const jlt_verify_run *run = context;
    const jlt_descriptor *asked = run->descriptor;
    (void)model;

    if (run->file != NULL) return ttc_model_beside(run->file, target, diagnostics);
    for (size_t i = 0; i <= jlt_descriptor_count(); i++) {
        const jlt_descriptor *d = i == 0 ? asked->family[0] : jlt_descriptor_at(i - 1);
        if (is_file_of(target, d->model)) return ttc_model_parse(d->table, strlen(d->table), target, diagnostics);
        for (unsigned k = 0; k < d->section_count; k++)
            if (is_file_of(target, d->sections[k].chart))
                return ttc_model_parse(d->sections[k].table, strlen(d->sections[k].table), target, diagnostics);
    }
    return NULL;
}

jlt_status jlt_verify_prove(jlt_verify_run *run)
{
    JLT_PASS(jlt_oracle_create(&run->oracle, run->descriptor, run->file));
    jlt_random_seed(&run->random, run->seed);
    if (!ttc_prove(run->oracle->model, resolve, run, TTC_PROVE_ALL, &run->proofs)) return JLT_ERR_NOMEM;
    run->held += run->proofs->proved;
    run->failed += run->proofs->proof_count - run->proofs->proved;
    return JLT_OK;
}
