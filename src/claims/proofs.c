#include "claims/verify.h"

#include "kernel/descriptor.h"

#include <stdlib.h>
#include <string.h>

/* The target of a reduction is a table that is built in, too. */
static ttc_model *resolve(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    const size_t length = strlen(target);
    (void)context;
    (void)model;

    for (size_t i = 0; length > 3 && i < jlt_descriptor_count(); i++) {
        const jlt_descriptor *d = jlt_descriptor_at(i);
        if (strlen(d->model) == length - 3 && strncmp(d->model, target, length - 3) == 0)
            return ttc_model_parse(d->table, strlen(d->table), target, diagnostics);
    }
    return NULL;
}

jlt_status jlt_verify_prove(jlt_verify_run *run)
{
    jlt_status st;

    JLT_TRY(jlt_oracle_create(&run->oracle, run->descriptor));
    jlt_random_seed(&run->random, run->seed);
    st = JLT_ERR_NOMEM;
    if (!ttc_prove(run->oracle->model, resolve, NULL, TTC_PROVE_ALL, &run->proofs)) goto done;
    run->held += run->proofs->proved;
    run->failed += run->proofs->proof_count - run->proofs->proved;
    st = JLT_OK;
done:
    return st;
}
