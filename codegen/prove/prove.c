#include "prove/prove.h"

#include "prove/prove_derived.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

static const struct {
    ttc_claim_kind kind;
    ttc_prover prove;
} provers[] = {
    { TTC_CLAIM_INTEGRAL, ttc_prove_integral },     { TTC_CLAIM_RATE, ttc_prove_rate },
    { TTC_CLAIM_INVARIANT, ttc_prove_invariant },   { TTC_CLAIM_MEASURE, ttc_prove_measure },
    { TTC_CLAIM_REVERSOR, ttc_prove_reversor },     { TTC_CLAIM_EQUILIBRIA, ttc_prove_equilibria },
    { TTC_CLAIM_TRACE, ttc_prove_trace },           { TTC_CLAIM_CHARPOLY, ttc_prove_charpoly },
    { TTC_CLAIM_OBSTRUCTS, ttc_prove_obstructs },   { TTC_CLAIM_MATRIX, ttc_prove_matrix },
    { TTC_CLAIM_LEFT_NULL, ttc_prove_left_null },   { TTC_CLAIM_EQUAL, ttc_prove_equal },
    { TTC_CLAIM_REDUCTION, ttc_prove_reduction },   { TTC_CLAIM_SYMMETRY, ttc_prove_symmetry },
};

static ttc_prover prover_of(ttc_claim_kind kind)
{
    for (size_t i = 0; i < sizeof provers / sizeof *provers; i++)
        if (provers[i].kind == kind) return provers[i].prove;
    return NULL;
}

const char *ttc_proof_status_name(ttc_proof_status status)
{
    switch (status) {
    case TTC_PROVED: return "proved";
    case TTC_REFUTED: return "refuted";
    case TTC_MEANINGLESS: break;
    }
    return "error";
}

static double seconds(void)
{
    struct timespec now;
    return clock_gettime(CLOCK_MONOTONIC, &now) == 0 ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec : 0;
}

static char *copy(const char *text)
{
    size_t size = strlen(text) + 1;
    char *result = malloc(size);
    if (result != NULL) memcpy(result, text, size);
    return result;
}

static bool prove_one(const ttc_model *model, const ttc_claim *claim, const char *name, const char *kind,
                      ttc_prover prove, ttc_resolver resolver, void *context, ttc_proof *proof)
{
    ttc_task task = { .model = model, .claim = claim, .resolver = resolver, .resolver_context = context };
    double start = seconds();
    ttc_graph_clear_error(model->graph);
    ttc_task_run(&task, prove);
    proof->name = copy(name);
    proof->kind = kind;
    proof->place = claim->place;
    proof->status = task.status;
    proof->remainder = task.remainder;
    proof->seconds = seconds() - start;
    return proof->name != NULL;
}

static void count(ttc_proof_report *report, ttc_proof_status status)
{
    report->proved += status == TTC_PROVED;
    report->refuted += status == TTC_REFUTED;
    report->meaningless += status == TTC_MEANINGLESS;
}

static bool prove_all(const ttc_model *model, ttc_resolver resolver, void *context, ttc_prove_extent extent,
                      ttc_proof_report *report)
{
    size_t total = model->claim_count + ttc_derived_count(model);
    for (size_t i = 0; i < total; i++) {
        ttc_derived_claim derived;
        ttc_proof *proof = &report->proofs[report->proof_count++];
        bool ok;
        if (i < model->claim_count) {
            const ttc_claim *claim = &model->claims[i];
            ok = prove_one(model, claim, claim->name, ttc_claim_kind_name(claim->kind), prover_of(claim->kind), resolver,
                           context, proof);
        } else {
            ttc_derived_claim_get(model, i - model->claim_count, &derived);
            ok = prove_one(model, &derived.claim, derived.name, derived.kind, derived.prove, resolver, context, proof);
        }
        if (!ok) return false;
        count(report, proof->status);
        if (extent == TTC_PROVE_UNTIL_REFUTED && proof->status == TTC_REFUTED) break;
    }
    return true;
}

bool ttc_prove(const ttc_model *model, ttc_resolver resolver, void *context, ttc_prove_extent extent,
               ttc_proof_report **report)
{
    *report = NULL;
    ttc_proof_report *made = calloc(1, sizeof *made);
    if (made == NULL) return false;
    made->model = copy(model->name);
    made->file = copy(model->file);
    made->title = copy(model->title != NULL ? model->title : "");
    memcpy(made->sha256, model->sha256, sizeof made->sha256);
    made->proofs = calloc(model->claim_count + ttc_derived_count(model) + 1, sizeof *made->proofs);
    if (made->model == NULL || made->file == NULL || made->title == NULL || made->proofs == NULL
        || !prove_all(model, resolver, context, extent, made)) {
        ttc_proof_report_destroy(made);
        return false;
    }
    *report = made;
    return true;
}

void ttc_proof_report_destroy(ttc_proof_report *report)
{
    if (report == NULL) return;
    for (size_t i = 0; i < report->proof_count; i++) {
        free(report->proofs[i].remainder);
        free(report->proofs[i].name);
    }
    free(report->proofs);
    free(report->title);
    free(report->file);
    free(report->model);
    free(report);
}

ttc_model *ttc_resolve_beside(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    (void)context;
    const char *slash = strrchr(model->file, '/');
    size_t folder = slash == NULL ? 0 : (size_t)(slash - model->file) + 1;
    char *path = malloc(folder + strlen(target) + 1);
    if (path == NULL) return NULL;
    memcpy(path, model->file, folder);
    memcpy(path + folder, target, strlen(target) + 1);
    ttc_model *result = ttc_model_read(path, diagnostics);
    free(path);
    return result;
}
