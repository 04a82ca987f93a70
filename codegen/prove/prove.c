#include "prove/prove.h"

#include "base/array.h"
#include "base/source.h"
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
    { TTC_CLAIM_PERIODIC, ttc_prove_symmetry },     { TTC_CLAIM_SECTION, ttc_prove_section },
    { TTC_CLAIM_DESCENT, ttc_prove_descent },       { TTC_CLAIM_LIFT, ttc_prove_lift },
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

struct ttc_proof_run {
    ttc_model *own; /* of a table that names another: a copy with pi, which is `model` then; else NULL */
    const ttc_model *model;
    ttc_resolver resolver;
    void *resolver_context;
    ttc_proof *proofs; /* by claim; derived ones last */
    bool *begun;
    size_t count;
    ttc_proof_witness witness; /* or NULL */
    void *witness_context;
};

static void clear_proof(ttc_proof *proof)
{
    free(proof->remainder);
    free(proof->point);
    free(proof->note);
    free(proof->name);
    *proof = (ttc_proof){ .name = NULL };
}

typedef void (*task_user)(ttc_proof_run *run, size_t index, ttc_task *task, const char *name, const char *kind, ttc_prover prove);

/* Make the task of claim number `index`, of the table or derived, and call `use` with it. */
static void with_task(ttc_proof_run *run, size_t index, task_user use)
{
    const ttc_model *model = run->model;
    ttc_task task = { .model = model, .resolver = run->resolver, .resolver_context = run->resolver_context };
    if (index < model->claim_count) {
        const ttc_claim *claim = &model->claims[index];
        task.claim = claim;
        task.role = TTC_DIVIDES_CLAIM;
        task.owner = (uint32_t)index;
        if (claim->kind == TTC_CLAIM_EQUILIBRIA) task.tested = &claim->bindings;
        use(run, index, &task, claim->name, ttc_claim_kind_name(claim->kind), prover_of(claim->kind));
        return;
    }
    ttc_derived_claim derived;
    ttc_derived_claim_get(model, index - model->claim_count, &derived);
    task.claim = &derived.claim;
    task.role = derived.role;
    task.owner = derived.claim.family;
    task.divisor = derived.divisor;
    task.tested_root = derived.tested_root;
    if (derived.tests_conditions) task.tested = &derived.claim.when;
    use(run, index, &task, derived.name, derived.kind, derived.prove);
}

static void name_proof(ttc_proof_run *run, size_t index, ttc_task *task, const char *name, const char *kind, ttc_prover prove)
{
    (void)prove;
    run->proofs[index] = (ttc_proof){ .name = copy(name), .kind = kind, .place = task->claim->place, .status = TTC_UNSETTLED };
}

static bool names_another(const ttc_model *model)
{
    for (size_t i = 0; i < model->claim_count; i++)
        if (model->claims[i].target != NULL) return true;
    return model->lift.file != NULL;
}

ttc_proof_run *ttc_proof_run_create(const ttc_model *model, ttc_resolver resolver, void *context)
{
    ttc_proof_run *run = calloc(1, sizeof *run);
    if (run == NULL) return NULL;
    const bool compares = names_another(model);
    *run = (ttc_proof_run){ .resolver = resolver, .resolver_context = context };
    run->own = compares ? ttc_model_with_pi(model) : NULL;
    run->model = compares ? run->own : model;
    size_t count = model->claim_count + ttc_derived_count(model);
    run->proofs = calloc(count + 1, sizeof *run->proofs);
    run->begun = calloc(count + 1, sizeof *run->begun);
    bool ok = run->model != NULL && run->proofs != NULL && run->begun != NULL;
    for (; ok && run->count < count; run->count++) {
        with_task(run, run->count, name_proof);
        ok = run->proofs[run->count].name != NULL;
    }
    if (ok) return run;
    ttc_proof_run_destroy(run);
    return NULL;
}

void ttc_proof_run_destroy(ttc_proof_run *run)
{
    if (run == NULL) return;
    for (size_t i = 0; i < run->count; i++) clear_proof(&run->proofs[i]);
    free(run->begun);
    free(run->proofs);
    ttc_model_destroy(run->own);
    free(run);
}

size_t ttc_proof_run_count(const ttc_proof_run *run) { return run->count; }
const ttc_proof *ttc_proof_run_proof(const ttc_proof_run *run, size_t index) { return &run->proofs[index]; }

static ttc_proof_status verdict_of(void *context, uint32_t claim)
{
    ttc_proof_run *run = context;
    ttc_proof_run_prove(run, claim);
    return run->proofs[claim].status;
}

static void hear_witness(ttc_proof_run *run, ttc_proof *proof)
{
    if (run->witness == NULL || proof->status != TTC_PROVED) return;
    char *contradiction = run->witness(run->witness_context, proof);
    if (contradiction == NULL) return;
    free(proof->remainder);
    proof->remainder = contradiction;
    proof->status = TTC_UNSETTLED;
    proof->ending = TTC_ENDED_BY_FAULT;
    proof->has_smooth_density = false;
}

static void prove_task(ttc_proof_run *run, size_t index, ttc_task *task, const char *name, const char *kind, ttc_prover prove)
{
    ttc_proof *proof = &run->proofs[index];
    double start = seconds();
    (void)name;
    (void)kind;
    task->verdict_of = verdict_of;
    task->verdict_context = run;
    ttc_graph_clear_error(run->model->graph);
    task->is_integral = task->claim->kind == TTC_CLAIM_INVARIANT && ttc_prove_is_integral(task);
    ttc_task_run(task, prove);
    ttc_prove_by_cofactor(task);
    if (task->status == TTC_PROVED && task->claim->kind == TTC_CLAIM_INTEGRAL && !task->varies)
        task->note = copy("constant on each part of its level, whatever the motion: being an integral says nothing");
    proof->status = task->status;
    proof->remainder = task->remainder;
    proof->point = task->point;
    proof->note = task->note;
    proof->has_smooth_density = task->status == TTC_PROVED && task->has_smooth_density;
    proof->relies_on_solver = task->relies_on_solver && task->status != TTC_REFUTED; /* a refuting point is verified */
    hear_witness(run, proof);
    proof->seconds = seconds() - start;
}

void ttc_proof_run_set_witness(ttc_proof_run *run, ttc_proof_witness witness, void *context)
{
    run->witness = witness;
    run->witness_context = context;
}

void ttc_proof_run_prove(ttc_proof_run *run, size_t index)
{
    if (run->begun[index]) return;
    run->begun[index] = true;
    with_task(run, index, prove_task);
}

void ttc_proof_run_accept(ttc_proof_run *run, size_t index, const ttc_proof *verdict)
{
    ttc_proof *proof = &run->proofs[index];
    run->begun[index] = true;
    free(proof->remainder);
    free(proof->point);
    free(proof->note);
    proof->status = verdict->status;
    proof->ending = verdict->ending;
    proof->remainder = verdict->remainder;
    proof->point = verdict->point;
    proof->note = verdict->note;
    proof->has_smooth_density = verdict->has_smooth_density;
    proof->relies_on_solver = verdict->relies_on_solver;
    proof->seconds = verdict->seconds;
}

static void count(ttc_proof_report *report, ttc_proof_status status)
{
    report->proved += status == TTC_PROVED;
    report->refuted += status == TTC_REFUTED;
    report->unsettled += status == TTC_UNSETTLED;
}

ttc_proof_report *ttc_proof_run_report(ttc_proof_run *run, size_t proof_count)
{
    const ttc_model *model = run->model;
    ttc_proof_report *made = calloc(1, sizeof *made);
    if (made == NULL) return NULL;
    made->model = copy(model->name);
    made->file = copy(model->file);
    made->title = copy(model->title != NULL ? model->title : "");
    memcpy(made->sha256, model->sha256, sizeof made->sha256);
    made->proofs = calloc(proof_count + 1, sizeof *made->proofs);
    if (made->model == NULL || made->file == NULL || made->title == NULL || made->proofs == NULL) {
        ttc_proof_report_destroy(made);
        return NULL;
    }
    for (; made->proof_count < proof_count; made->proof_count++) {
        ttc_proof *proof = &run->proofs[made->proof_count];
        count(made, proof->status);
        made->proofs[made->proof_count] = *proof;
        *proof = (ttc_proof){ .name = NULL };
    }
    return made;
}

bool ttc_prove(const ttc_model *model, ttc_resolver resolver, void *context, ttc_prove_extent extent,
               ttc_proof_report **report)
{
    *report = NULL;
    ttc_proof_run *run = ttc_proof_run_create(model, resolver, context);
    size_t done = 0;
    for (bool stop = run == NULL; !stop && done < run->count; done++) {
        ttc_proof_run_prove(run, done);
        stop = extent == TTC_PROVE_UNTIL_REFUTED && run->proofs[done].status == TTC_REFUTED;
    }
    if (run != NULL) *report = ttc_proof_run_report(run, done);
    ttc_proof_run_destroy(run);
    return *report != NULL;
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

/* The path of the table `target` in the folder of the file `of`, for free(); NULL when memory is out. */
static char *path_beside(const char *of, const char *target)
{
    const char *slash = strrchr(of, '/');
    size_t folder = slash == NULL ? 0 : (size_t)(slash - of) + 1;
    char *path = malloc(folder + strlen(target) + 1);
    if (path == NULL) return NULL;
    memcpy(path, of, folder);
    memcpy(path + folder, target, strlen(target) + 1);
    return path;
}

ttc_model *ttc_model_beside(const char *of, const char *target, ttc_diagnostics *diagnostics)
{
    char *path = path_beside(of, target);
    ttc_model *result = path == NULL ? NULL : ttc_model_read(path, diagnostics);
    free(path);
    return result;
}

ttc_model *ttc_resolve(ttc_resolver resolver, void *context, const ttc_model *model, const char *what, const char *file,
                       char *reason, size_t size)
{
    char error[TTC_DIAGNOSTIC_LINE] = "";
    ttc_diagnostics *diagnostics = resolver == NULL ? NULL : ttc_diagnostics_create();
    ttc_model *read = diagnostics == NULL ? NULL : resolver(context, model, file, diagnostics);
    if (diagnostics != NULL) ttc_diagnostics_first_error(diagnostics, error, sizeof error);
    ttc_diagnostics_destroy(diagnostics);
    if (read == NULL) snprintf(reason, size, "%s %s could not be read%s%s", what, file, *error == '\0' ? "" : ": ", error);
    ttc_model *table = read == NULL ? NULL : ttc_model_with_pi(read);
    if (read != NULL && table == NULL) snprintf(reason, size, "out of memory");
    ttc_model_destroy(read);
    return table;
}

/* The texts that ttc_resolve_beside has read, by path. */
typedef struct {
    char *path, *text;
    size_t length;
} read_text;

static struct {
    read_text *items;
    size_t count;
} texts;

/* The text of a file when it was first read. NULL after a report, or when memory is out. Takes the path over. */
static const read_text *read_once(char *path, ttc_diagnostics *diagnostics)
{
    read_text new = { .path = path };
    for (size_t i = 0; i < texts.count; i++) {
        if (strcmp(texts.items[i].path, path) != 0) continue;
        free(path);
        return texts.items + i;
    }
    ttc_diagnostics_source(diagnostics, path, NULL, 0);
    new.text = ttc_source_read(path, &new.length, diagnostics);
    if (new.text == NULL || !TTC_ARRAY_GROW(texts.items, texts.count)) {
        free(new.text);
        free(path);
        return NULL;
    }
    texts.items[texts.count] = new;
    return texts.items + texts.count++;
}

ttc_model *ttc_resolve_beside(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    (void)context;
    char *path = path_beside(model->file, target);
    const read_text *read = path == NULL ? NULL : read_once(path, diagnostics);
    return read == NULL ? NULL : ttc_model_parse(read->text, read->length, read->path, diagnostics);
}
