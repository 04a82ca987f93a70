/* ttc prove: proves or refutes every claim of the tables, exactly. */
#include "base/text.h"
#include "command/command.h"
#include "command/command_challenge.h"
#include "command/command_guard.h"
#include "prove/mutate.h"
#include "readback/prove_functions.h"
#include "readback/prove_kernels.h"

#include <string.h>

static bool is_proved_kernel(const ttc_proof *proof)
{
    return proof->status == TTC_PROVED && strcmp(proof->kind, "kernel") == 0;
}

/* The proved kernels of one field, which follow each other, on one line. Returns the index of the last. */
static size_t print_kernels(const ttc_proof_report *report, size_t first)
{
    const char *name = report->proofs[first].name;
    size_t stem = strcspn(name, " "), i = first;
    printf("%-11s %-11s %.*s:", ttc_proof_status_name(TTC_PROVED), "kernel", (int)stem, name);
    while (i < report->proof_count && is_proved_kernel(&report->proofs[i])
           && strncmp(report->proofs[i].name, name, stem + 1) == 0)
        printf(" %s", report->proofs[i++].name + stem + 1);
    printf("\n");
    return i - 1;
}

/* Print what backs a verdict; without --verbose only points that refute, and notes but those on densities that are smooth. */
static void print_backing(const ttc_proof *proof, bool verbose)
{
    if (proof->note != NULL && (verbose || !proof->has_smooth_density)) printf("\n            %s", proof->note);
    if (proof->point != NULL && (verbose || proof->status == TTC_REFUTED))
        printf("\n            %s %s", proof->status == TTC_REFUTED ? "false at" : "for one at", proof->point);
    if (proof->relies_on_solver && verbose) printf("\n            relies on the solver for real arithmetic");
}

static void print_text(const ttc_proof_report *report, bool verbose)
{
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = &report->proofs[i];
        if (is_proved_kernel(proof)) {
            i = print_kernels(report, i);
            continue;
        }
        printf("%-11s %-11s %s", ttc_proof_status_name(proof->status), proof->kind, proof->name);
        if (proof->status != TTC_PROVED)
            printf("\n            %s:%u: %s", report->file, (unsigned)proof->place.line,
                   proof->remainder != NULL ? proof->remainder : "no reason could be stored");
        print_backing(proof, verbose);
        printf("\n");
    }
    printf("%s: %zu claim%s: %zu proved, %zu refuted", report->model, report->proof_count, ttc_text_plural(report->proof_count),
           report->proved, report->refuted);
    if (report->unsettled > 0) printf(", %zu not settled", report->unsettled);
    printf("\n");
}

static json_t *proof_json(const ttc_proof *proof)
{
    bool is_proved = proof->status == TTC_PROVED;
    json_t *object = json_pack("{s:s, s:s, s:i, s:s, s:s?, s:s?, s:s?, s:b}", "name", proof->name, "kind", proof->kind, "line",
                               (int)proof->place.line, "status", ttc_proof_status_name(proof->status), "remainder",
                               proof->remainder, is_proved ? "witness" : "point", proof->point, "note", proof->note,
                               "relies_on_solver", proof->relies_on_solver ? 1 : 0);
    if (object != NULL && strcmp(proof->kind, "measure") == 0)
        json_object_set_new(object, "smooth_positive_density", json_boolean(proof->has_smooth_density));
    return object;
}

static json_t *report_json(const ttc_proof_report *report)
{
    json_t *claims = json_array();
    for (size_t i = 0; i < report->proof_count; i++) json_array_append_new(claims, proof_json(&report->proofs[i]));
    return json_pack("{s:s, s:o, s:s, s:o, s:{s:I, s:I, s:I, s:I}}", "model", report->model, "file",
                     ttc_command_string(report->file), "hash", report->sha256, "claims", claims, "totals", "claims",
                     (json_int_t)report->proof_count, "proved", (json_int_t)report->proved, "refuted",
                     (json_int_t)report->refuted, "not settled", (json_int_t)report->unsettled);
}

static void complain(const ttc_proof_report *report)
{
    for (size_t i = 0; i < report->proof_count; i++)
        if (report->proofs[i].status == TTC_UNSETTLED)
            fprintf(stderr, "%s:%u:%u: error: the %s claim '%s' is not settled: %s\n", report->file,
                    (unsigned)report->proofs[i].place.line, (unsigned)report->proofs[i].place.column,
                    report->proofs[i].kind, report->proofs[i].name,
                    report->proofs[i].remainder != NULL ? report->proofs[i].remainder : "no reason could be stored");
}

/* One table gives an object, several an array of them. */
static void print_json(json_t *reports, size_t file_count)
{
    json_t *shown = file_count == 1 && json_array_size(reports) == 1 ? json_array_get(reports, 0) : reports;
    json_dumpf(shown, stdout, JSON_INDENT(2));
    printf("\n");
}

static const char *fate_name(ttc_mutant_fate fate)
{
    switch (fate) {
    case TTC_MUTANT_REFUTED: return "refuted";
    case TTC_MUTANT_SURVIVED: return "survived";
    case TTC_MUTANT_UNREADABLE: break;
    }
    return "unreadable";
}

static void print_mutants(const ttc_model *model, const ttc_mutation_report *report)
{
    for (size_t i = 0; i < report->count; i++) {
        const ttc_mutant *mutant = &report->mutants[i];
        if (mutant->fate == TTC_MUTANT_REFUTED) continue;
        printf("%s:%u:%u: mutant %s: %s '%.*s'\n", model->file, (unsigned)mutant->place.line,
               (unsigned)mutant->place.column, fate_name(mutant->fate), mutant->dropped ? "dropped" : "flipped",
               (int)mutant->term_length, mutant->term);
    }
    printf("%s: %zu mutants: %zu refuted, %zu survived, %zu unreadable\n", model->name, report->count, report->refuted,
           report->survived, report->unreadable);
}

static json_t *mutants_json(const ttc_model *model, const ttc_mutation_report *report)
{
    json_t *mutants = json_array();
    for (size_t i = 0; i < report->count; i++) {
        const ttc_mutant *mutant = &report->mutants[i];
        json_array_append_new(mutants,
                              json_pack("{s:i, s:i, s:s%, s:s, s:s, s:s?}", "line", (int)mutant->place.line, "column",
                                        (int)mutant->place.column, "term", mutant->term, mutant->term_length, "change",
                                        mutant->dropped ? "dropped" : "flipped", "fate", fate_name(mutant->fate),
                                        "refuted", mutant->refuted));
    }
    return json_pack("{s:s, s:s, s:s?, s:o, s:{s:I, s:I, s:I, s:I}}", "model", model->name, "hash", model->sha256, "broken",
                     report->broken, "mutants", mutants, "totals", "mutants", (json_int_t)report->count, "refuted",
                     (json_int_t)report->refuted, "survived", (json_int_t)report->survived, "unreadable",
                     (json_int_t)report->unreadable);
}

/* A survivor means that a claim is missing: exit status 1, as for a claim that fails, by which mutants cannot be judged. */
static int mutate(const ttc_model *model, bool json, json_t *reports)
{
    ttc_mutation_report *report = NULL;
    if (!ttc_mutate(model, ttc_resolve_beside, NULL, &report)) {
        fprintf(stderr, "ttc: out of memory while mutating %s\n", model->file);
        return TTC_EXIT_MEMORY;
    }
    if (json) json_array_append_new(reports, mutants_json(model, report));
    else if (report->broken == NULL) print_mutants(model, report);
    if (report->broken != NULL)
        fprintf(stderr, "%s: error: the claim '%s' is refuted of the table itself, and would seem to notice every mutant: correct "
                "it\n", model->file, report->broken);
    int status = report->survived > 0 || report->broken != NULL ? TTC_EXIT_REFUTED : TTC_EXIT_DONE;
    ttc_mutation_report_destroy(report);
    return status;
}

/* Without --json, the report on the claims is printed even if the kernels cannot be made; with it, only why they cannot. Kernels
 * are made before proofs, whose expressions would change them: so the programs are those that `generate` writes. */
static int prove(const ttc_model *model, const ttc_options *options, json_t *reports)
{
    ttc_catalogue catalogue = { 0 };
    int status = TTC_EXIT_DONE;
    json_t *problems = json_array();
    bool has_catalogue = options->kernels && model->lift.file == NULL
                         && ttc_command_catalogue(&catalogue, model, options, &status, problems);
    ttc_proof_report *report = ttc_command_prove_guarded(model, options, &status);
    if (report != NULL && has_catalogue && !(ttc_prove_kernels(&catalogue, report) && ttc_prove_functions(&catalogue, report))) {
        fprintf(stderr, "ttc: out of memory while proving the kernels of %s\n", model->file);
        ttc_command_raise(&status, TTC_EXIT_MEMORY);
    }
    ttc_catalogue_clear(&catalogue);
    if (report == NULL || (options->json && status == TTC_EXIT_BAD_TABLE)) {
        json_array_append_new(reports, ttc_command_failure(model->file, problems));
        ttc_proof_report_destroy(report);
        return status;
    }
    json_decref(problems);
    json_t *shown = options->json ? report_json(report) : NULL;
    if (!options->json) print_text(report, options->verbose);
    complain(report);
    if (options->challenge > 0) ttc_command_raise(&status, ttc_command_challenge(model, report, options, shown));
    if (options->json) json_array_append_new(reports, shown);
    if (report->refuted > 0) ttc_command_raise(&status, TTC_EXIT_REFUTED);
    if (report->unsettled > 0) ttc_command_raise(&status, TTC_EXIT_BAD_TABLE);
    ttc_proof_report_destroy(report);
    return status;
}

int ttc_command_prove(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    json_t *reports = json_array();
    for (size_t i = 0; i < options->file_count; i++) {
        json_t *problems = json_array();
        ttc_model *model = ttc_command_read(options->files[i], &status, problems);
        if (model == NULL) {
            json_array_append_new(reports, ttc_command_failure(options->files[i], problems));
            continue;
        }
        json_decref(problems);
        ttc_command_raise(&status, options->mutate ? mutate(model, options->json, reports) : prove(model, options, reports));
        ttc_model_destroy(model);
    }
    if (options->json) print_json(reports, options->file_count);
    json_decref(reports);
    return status;
}
