#include "claims/verify.h"

#include <stdlib.h>

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
