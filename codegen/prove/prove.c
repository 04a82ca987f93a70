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
    { TTC_CLAIM_POSITIVE, ttc_prove_positive },     { TTC_CLAIM_REDUCTION, ttc_prove_reduction },
    { TTC_CLAIM_EMBEDDING, ttc_prove_reduction },   { TTC_CLAIM_SYMMETRY, ttc_prove_symmetry },
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
    case TTC_UNSETTLED: break;
    }
    return "not settled";
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

/* Claims are proved when they are first asked for: by their turn, or by one that rests on them. */
typedef struct {
    const ttc_model *model;
    ttc_resolver resolver;
    void *resolver_context;
    ttc_proof *proofs; /* by claim, derived ones last */
    bool *begun;
    bool out_of_memory;
} proof_run;

static ttc_proof_status verdict_of(void *context, uint32_t claim);

static void keep(ttc_proof *proof, const ttc_task *task)
{
    proof->status = task->status;
    proof->remainder = task->remainder;
    proof->point = task->point;
    proof->note = task->note;
    proof->has_smooth_density = task->status == TTC_PROVED && task->has_smooth_density;
    proof->relies_on_solver = task->relies_on_solver;
}

static void prove_task(proof_run *run, size_t index, ttc_task task, const char *name, const char *kind, ttc_prover prove)
{
    ttc_proof *proof = &run->proofs[index];
    double start = seconds();
    run->begun[index] = true;
    task.model = run->model;
    task.resolver = run->resolver;
    task.resolver_context = run->resolver_context;
    task.verdict_of = verdict_of;
    task.verdict_context = run;
    ttc_graph_clear_error(run->model->graph);
    ttc_task_run(&task, prove);
    proof->name = copy(name);
    proof->kind = kind;
    proof->place = task.claim->place;
    keep(proof, &task);
    proof->seconds = seconds() - start;
    run->out_of_memory |= proof->name == NULL;
}

static void prove_index(proof_run *run, size_t index)
{
    const ttc_model *model = run->model;
    ttc_derived_claim derived;
    if (run->begun[index]) return;
    if (index < model->claim_count) {
        const ttc_claim *claim = &model->claims[index];
        ttc_task task = { .claim = claim, .role = TTC_DIVIDES_CLAIM, .owner = (uint32_t)index,
                          .tested = claim->kind == TTC_CLAIM_EQUILIBRIA ? &claim->bindings : NULL };
        prove_task(run, index, task, claim->name, ttc_claim_kind_name(claim->kind), prover_of(claim->kind));
    } else {
        ttc_derived_claim_get(model, index - model->claim_count, &derived);
        ttc_task task = { .claim = &derived.claim, .role = derived.role, .owner = derived.claim.family, .divisor = derived.divisor,
                          .tested = derived.tests_conditions ? &derived.claim.when : NULL, .tested_root = derived.tested_root };
        prove_task(run, index, task, derived.name, derived.kind, derived.prove);
    }
}

static ttc_proof_status verdict_of(void *context, uint32_t claim)
{
    proof_run *run = context;
    prove_index(run, claim);
    return run->proofs[claim].name == NULL ? TTC_UNSETTLED : run->proofs[claim].status;
}

static void count(ttc_proof_report *report, ttc_proof_status status)
{
    report->proved += status == TTC_PROVED;
    report->refuted += status == TTC_REFUTED;
    report->unsettled += status == TTC_UNSETTLED;
}

static void clear_proof(ttc_proof *proof)
{
    free(proof->remainder);
    free(proof->point);
    free(proof->note);
    free(proof->name);
}

static bool prove_all(const ttc_model *model, ttc_resolver resolver, void *context, ttc_prove_extent extent,
                      ttc_proof_report *report)
{
    size_t total = model->claim_count + ttc_derived_count(model);
    proof_run run = { .model = model, .resolver = resolver, .resolver_context = context };
    run.proofs = calloc(total + 1, sizeof *run.proofs);
    run.begun = calloc(total + 1, sizeof *run.begun);
    run.out_of_memory = run.proofs == NULL || run.begun == NULL;
    for (size_t i = 0; i < total && !run.out_of_memory; i++) {
        prove_index(&run, i);
        report->proofs[report->proof_count++] = run.proofs[i];
        count(report, run.proofs[i].status);
        if (extent == TTC_PROVE_UNTIL_REFUTED && run.proofs[i].status == TTC_REFUTED) break;
    }
    /* What was proved on the way and is not in the report. */
    for (size_t i = report->proof_count; run.proofs != NULL && i < total; i++) clear_proof(&run.proofs[i]);
    free(run.begun);
    free(run.proofs);
    return !run.out_of_memory;
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
    for (size_t i = 0; i < report->proof_count; i++) clear_proof(&report->proofs[i]);
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
