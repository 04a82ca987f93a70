/* ttc generate: writes all files of all tables, or none. */
#include "command/command.h"
#include "command/kept.h"
#include "emit/emit.h"
#include "emit/emit_registry.h"
#include "emit/runtime.h"
#include "base/output.h"
#include "kernels/catalogue.h"
#include "kernels/unproved.h"
#include "kernels/wide_number.h"
#include "prove/section_chart.h"
#include "readback/prove_functions.h"
#include "readback/prove_kernels.h"

#include <stdlib.h>
#include <string.h>

/* What the files of one model are made of. */
typedef struct {
    ttc_output *output;
    const ttc_catalogue *catalogue;
    const ttc_proof_report *report;
    const char *unproved; /* for every file's first line; NULL: all is proved */
} model_files;

static ttc_text *add_file(const model_files *f, const char *name, const char *extension)
{
    ttc_text path = { 0 };
    ttc_text_format(&path, "%s/%s%s", f->catalogue->model->name, name, extension);
    ttc_text *text = path.failed ? NULL : ttc_output_add(f->output, ttc_text_string(&path));
    ttc_text_clear(&path);
    if (text != NULL && f->unproved != NULL) {
        ttc_text_add(text, "/* UNPROVED: kernels of this model rest on claims that are not proved: ");
        ttc_text_add_comment(text, f->unproved);
        ttc_text_add(text, " */\n");
    }
    return text;
}

static bool generate_field(const model_files *f, ttc_kernels *kernels)
{
    ttc_text stem = { 0 };
    ttc_emit_stem(&stem, kernels->field);
    ttc_text *text = stem.failed ? NULL : add_file(f, ttc_text_string(&stem), ".c");
    bool ok = text != NULL && ttc_emit_descriptor(text, kernels);
    text = ok ? add_file(f, ttc_text_string(&stem), "_lanes.inc") : NULL;
    ttc_text_clear(&stem);
    if (text != NULL) ttc_emit_lanes(text, kernels);
    return text != NULL && !text->failed;
}

/* *failed: the kernels that could not be written, NULL if something else failed. */
static bool generate_model(const model_files *f, ttc_kernels **failed)
{
    const ttc_catalogue *catalogue = f->catalogue;
    *failed = NULL;
    ttc_text *text = add_file(f, "table", ".c");
    if (text == NULL) return false;
    ttc_emit_model(text, catalogue, f->report);
    for (size_t i = 0; i < catalogue->count; i++) {
        if (catalogue->fields[i].kernels == NULL || generate_field(f, catalogue->fields[i].kernels)) continue;
        *failed = catalogue->fields[i].kernels;
        return false;
    }
    for (unsigned isa = 0; isa < TTC_ISA_COUNT; isa++) {
        text = add_file(f, "batch_", ttc_isa_files[isa]);
        if (text == NULL) return false;
        ttc_emit_batch(text, catalogue, isa);
    }
    text = add_file(f, catalogue->model->name, "_ball.c");
    return text != NULL && ttc_emit_ball(text, catalogue);
}

/* The lists of all tables. Rows of a table that is kept come from the lists there are. */
static bool generate_lists(ttc_output *output, ttc_model *const *models, const ttc_catalogue *catalogues, size_t count,
                           const ttc_kept *kept)
{
    ttc_text *counts = ttc_output_add(output, "counts.tsv");
    if (counts == NULL) return false;
    ttc_emit_counts_titles(counts);
    for (size_t i = 0; i < count; i++)
        if (catalogues[i].model != NULL) ttc_emit_counts_rows(counts, catalogues + i);
        else ttc_copy_rows(counts, kept->counts, models[i]->name);
    ttc_text *manifest = ttc_output_add(output, "manifest.tsv"), rows = { 0 };
    if (manifest == NULL) return false;
    ttc_emit_manifest_titles(&rows);
    for (size_t i = 0; i < count; i++)
        if (catalogues[i].model != NULL) ttc_emit_manifest_rows(&rows, catalogues + i);
        else ttc_copy_rows(&rows, kept->manifest, models[i]->name);
    *manifest = rows;
    const char *list = ttc_text_string(&rows);
    ttc_text *registry = ttc_output_add(output, "registry.c");
    if (registry != NULL) ttc_emit_registry(registry, list);
    return registry != NULL;
}

static bool generate_runtime(ttc_output *output)
{
    for (size_t i = 0; i < ttc_runtime_file_count; i++) {
        ttc_text *text = ttc_output_add(output, ttc_runtime_files[i].name);
        if (text == NULL) return false;
        ttc_text_add(text, ttc_runtime_files[i].text);
    }
    return true;
}

static bool is_failed(const ttc_output *output)
{
    bool failed = output->failed;
    for (size_t i = 0; i < output->count; i++) failed |= output->files[i].text.failed;
    return failed;
}

/* Report why kernels could not be written. Returns the exit status. */
static int complain(const model_files *f, const ttc_kernels *failed)
{
    const ttc_model *model = f->catalogue->model;
    ttc_graph_status error = ttc_graph_error(model->graph);
    const ttc_claim *claim = failed == NULL ? NULL : failed->failed_claim;
    ttc_place place = f->catalogue->count > 0 ? ttc_catalogue_place(f->catalogue->fields, model) : (ttc_place){ 1, 1 };
    for (size_t i = 0; i < f->catalogue->count; i++)
        if (failed != NULL && f->catalogue->fields[i].kernels == failed)
            place = ttc_catalogue_place(f->catalogue->fields + i, model);
    const char *reason = error != TTC_GRAPH_OK ? ttc_graph_status_text(error) : "memory is out";
    if (f->output->taken != NULL)
        ttc_command_complain(model, place, NULL, "'%s' would be written twice, or names in it (expected tables, and variants, "
                             "times and eliminations of one, to have names of their own, also with '_' between them)",
                             f->output->taken);
    else if (ttc_find_wide_number(f->catalogue, &place))
        ttc_command_complain(model, place, NULL, "a number is beyond double precision (expected zero, or a size of 2^-1022 to "
                             "2^1023)");
    else if (claim != NULL && claim->kind == TTC_CLAIM_CHARPOLY && error == TTC_GRAPH_OK)
        ttc_command_complain(model, claim->place, NULL, "the charpoly of '%s' has no kernel (expected a polynomial in lambda, of "
                             "degree %zu at most)", claim->name, model->state_count);
    else if (claim != NULL)
        ttc_command_complain(model, claim->place, NULL, "the %s '%s' has no kernel: %s", ttc_claim_kind_name(claim->kind),
                             claim->name, error != TTC_GRAPH_OK ? reason : "memory is out, or a number is divided by zero");
    else {
        ttc_command_complain(model, place, NULL, "the kernels asked for here cannot be written: %s", reason);
        if (error == TTC_GRAPH_OK) return TTC_EXIT_MEMORY;
    }
    return error == TTC_GRAPH_NO_MEMORY ? TTC_EXIT_MEMORY : TTC_EXIT_BAD_TABLE;
}

/* The kernels of a catalogue that rest on a claim, "FIELD: KERNELS; ...". */
static void add_resting(ttc_text *text, const ttc_catalogue *catalogue, const ttc_proof_report *report, size_t proof)
{
    for (size_t i = 0; i < catalogue->count; i++) {
        ttc_text kernels = { 0 };
        if (catalogue->fields[i].kernels == NULL) continue;
        ttc_unproved_kernels(&kernels, catalogue->fields[i].kernels, report, proof);
        if (kernels.length > 0) {
            if (text->length > 0) ttc_text_add(text, "; ");
            ttc_emit_stem(text, catalogue->fields[i].kernels->field);
            ttc_text_format(text, ": %s", ttc_text_string(&kernels));
        }
        text->failed |= kernels.failed;
        ttc_text_clear(&kernels);
    }
}

/* Report what a claim without a proof entails; resting: from add_resting. */
static void tell_consequence(const ttc_model *model, const ttc_proof *proof, const ttc_claim *claim, const ttc_text *resting,
                             bool refuse)
{
    const char *cut = resting->length > 200 ? "..." : "";
    char status[400];
    snprintf(status, sizeof status, "%s", ttc_proof_status_name(proof->status));
    if (proof->status == TTC_UNSETTLED && proof->remainder != NULL)
        snprintf(status, sizeof status, "not settled (%.300s%s)", proof->remainder, strlen(proof->remainder) > 300 ? "..." : "");
    if (resting->length > 0 && refuse)
        ttc_command_complain(model, proof->place, NULL, "the %s claim '%s' is %s, and kernels rest on it (%.200s%s): correct it, "
                             "or write them marked as unproved with --unproved", proof->kind, proof->name, status,
                             ttc_text_string(resting), cut);
    else if (resting->length > 0)
        ttc_command_warn(model, proof->place, "the %s claim '%s' is %s: kernels that rest on it are marked as unproved "
                         "(%.200s%s)", proof->kind, proof->name, status, ttc_text_string(resting), cut);
    else if (claim != NULL && claim->target != NULL)
        ttc_command_warn(model, proof->place, "the %s claim '%s' is %s: %s and this table no longer serve in place of each "
                         "other", proof->kind, proof->name, status, claim->target);
    else ttc_command_warn(model, proof->place, "the %s claim '%s' is %s", proof->kind, proof->name, status);
}

/* Report claims without a proof; all: the names of those that kernels rest on. Returns false when memory is out. */
static bool tell_unproved(const ttc_catalogue *catalogue, const ttc_proof_report *report, bool refuse, ttc_text *all)
{
    bool failed = false;
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = report->proofs + i;
        const ttc_claim *claim = i < catalogue->model->claim_count ? catalogue->model->claims + i : NULL;
        ttc_text resting = { 0 };
        if (proof->status == TTC_PROVED) continue;
        add_resting(&resting, catalogue, report, i);
        tell_consequence(catalogue->model, proof, claim, &resting, refuse);
        if (resting.length > 0) ttc_text_format(all, "%s%s %s", all->length > 0 ? ", " : "", proof->kind, proof->name);
        failed |= resting.failed;
        ttc_text_clear(&resting);
    }
    return !failed && !all->failed;
}

/* Warn of defaults in tables of coordinates where this table has other defaults of the same parameters, which take precedence. */
static void tell_other_defaults(const ttc_model *model)
{
    char reason[256];
    for (size_t i = 0; i < model->section_count; i++) {
        const ttc_section *section = model->sections + i;
        const ttc_claim *claim = model->claims + section->claim;
        ttc_model *chart = ttc_section_chart(model, section, ttc_resolve_beside, NULL, reason, sizeof reason);
        for (size_t k = 0; chart != NULL && k < chart->param_count; k++) {
            const uint32_t place = ttc_section_place(model, section, chart, k);
            const ttc_id there = chart->symbols[chart->params[k]].value;
            const ttc_id here = place < model->param_count ? model->symbols[model->params[place]].value : TTC_NONE;
            if (here == TTC_NONE || there == TTC_NONE ||
                fmpq_equal(ttc_coefficient(model->graph, here), ttc_coefficient(chart->graph, there)))
                continue;
            ttc_command_warn(model, claim->place, "the default of %s in %s has no effect: this table has another, which is taken",
                             chart->symbols[chart->params[k]].name, claim->target);
        }
        ttc_model_destroy(chart);
    }
}

/* Mark in the catalogue the unproved claims that kernels rest on. Returns false if they are refused, or when memory is out. */
static bool mark_unproved(ttc_catalogue *catalogue, const ttc_proof_report *report, const ttc_options *options, int *status,
                          ttc_text *all)
{
    if (!tell_unproved(catalogue, report, !options->unproved, all) || !ttc_catalogue_mark_unproved(catalogue, report)) {
        fprintf(stderr, "ttc: out of memory\n");
        ttc_command_raise(status, TTC_EXIT_MEMORY);
        return false;
    }
    if (all->length == 0 || options->unproved) return true;
    ttc_command_raise(status, TTC_EXIT_REFUTED);
    return false;
}

/* Prove that every kernel computes what the table says; if one is not proved, *status is raised, and nothing is written. */
static void prove_kernels(const ttc_catalogue *catalogue, ttc_proof_report *report, int *status)
{
    const size_t claims = report->proof_count;
    if (!ttc_prove_kernels(catalogue, report) || !ttc_prove_functions(catalogue, report)) {
        fprintf(stderr, "ttc: out of memory while proving the kernels of %s\n", catalogue->model->file);
        ttc_command_raise(status, TTC_EXIT_MEMORY);
    }
    for (size_t i = claims; i < report->proof_count; i++) {
        const ttc_proof *proof = report->proofs + i;
        if (proof->status == TTC_PROVED) continue;
        ttc_command_complain(catalogue->model, proof->place, NULL,
                             "kernel %s is %s: %s (--effort quick writes kernels without these proofs)",
                             proof->name, ttc_proof_status_name(proof->status), proof->remainder);
        ttc_command_raise(status, TTC_EXIT_REFUTED);
    }
}

/* All files of one table. Kernels are proved after they are written, for proofs add to the expression graph, which would change
 * them. */
static void generate_table(ttc_output *output, ttc_catalogue *catalogue, const ttc_model *model, const ttc_options *options,
                           int *status, bool *passing)
{
    ttc_text unproved = { 0 };
    ttc_kernels *failed = NULL;
    ttc_proof_report *report = NULL;
    tell_other_defaults(model);
    if (ttc_command_catalogue(catalogue, model, options, status, NULL)) report = ttc_command_prove_guarded(model, options, status);
    if (report != NULL && mark_unproved(catalogue, report, options, status, &unproved)) {
        model_files f = { output, catalogue, report, unproved.length > 0 ? ttc_text_string(&unproved) : NULL };
        if (!generate_model(&f, &failed)) ttc_command_raise(status, complain(&f, failed));
        else if (options->effort == TTC_EFFORT_FULL) prove_kernels(catalogue, report, status);
    }
    for (size_t i = 0; report != NULL && i < report->proof_count; i++) *passing |= report->proofs[i].ending == TTC_ENDED_BY_SYSTEM;
    ttc_proof_report_destroy(report);
    ttc_text_clear(&unproved);
}

static int write_files(const ttc_output *output, const char *folder)
{
    const char *where = NULL;
    bool restored = true;
    int error = ttc_output_write(output, folder, &where, &restored);
    if (error == 0) return TTC_EXIT_DONE;
    if (where == folder)
        fprintf(stderr, "ttc: cannot make the folder %s: %s (the one above it must exist)\n", folder, strerror(error));
    else
        fprintf(stderr, "ttc: cannot write %s below %s: %s; %s\n", where, folder, strerror(error),
                restored ? "nothing was changed"
                         : "and some files could not be put back: what they were is in files that end in .old");
    return TTC_EXIT_IO;
}

static void refuse_name(const ttc_model *model, const ttc_model *other, int *status)
{
    ttc_command_complain(model, (ttc_place){ 1, 1 }, NULL, "the model '%s' would be written twice (%s has this name as well)",
                         model->name, other->file);
    ttc_command_raise(status, TTC_EXIT_BAD_TABLE);
}

int ttc_command_generate_models(ttc_model *const *models, size_t count, const ttc_options *options, bool *passing)
{
    int status = TTC_EXIT_DONE;
    bool is_passing = false;
    ttc_output output = { 0 };
    ttc_catalogue *catalogues = calloc(count + 1, sizeof *catalogues);
    ttc_kept kept = { 0 };
    if (catalogues == NULL) {
        fprintf(stderr, "ttc: out of memory\n");
        return TTC_EXIT_MEMORY;
    }
    if (options->keep) ttc_kept_read(&kept, options->out);
    for (size_t i = 0; i < count && status == TTC_EXIT_DONE; i++) {
        if (!ttc_kept_has(&kept, options->out, models[i]))
            generate_table(&output, catalogues + i, models[i], options, &status, &is_passing);
        for (size_t k = 0; k < i && status == TTC_EXIT_DONE; k++)
            if (strcmp(models[k]->name, models[i]->name) == 0) refuse_name(models[i], models[k], &status);
    }
    if (status == TTC_EXIT_DONE
        && (!generate_runtime(&output) || !generate_lists(&output, models, catalogues, count, &kept)
            || is_failed(&output))) {
        fprintf(stderr, "ttc: out of memory\n");
        status = TTC_EXIT_MEMORY;
    }
    if (status == TTC_EXIT_DONE) status = write_files(&output, options->out);
    ttc_kept_clear(&kept);
    for (size_t i = 0; i < count; i++) ttc_catalogue_clear(catalogues + i);
    free(catalogues);
    ttc_output_clear(&output);
    if (passing != NULL) *passing = is_passing;
    return status;
}

int ttc_command_generate(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    size_t count = 0;
    if (options->out == NULL) {
        fprintf(stderr, "ttc generate: no folder is given (expected --out DIR)\n");
        return TTC_EXIT_USAGE;
    }
    ttc_model **models = calloc(options->file_count + 1, sizeof *models);
    if (models == NULL) {
        fprintf(stderr, "ttc: out of memory\n");
        return TTC_EXIT_MEMORY;
    }
    for (size_t i = 0; i < options->file_count; i++) {
        models[count] = ttc_command_read(options->files[i], &status, NULL);
        if (models[count] == NULL || !ttc_command_passes_over(models[count], options)) count++;
        else ttc_model_destroy(models[count]), models[count] = NULL;
    }
    if (status == TTC_EXIT_DONE) status = ttc_command_generate_models(models, count, options, NULL);
    for (size_t i = 0; i < count; i++) ttc_model_destroy(models[i]);
    free(models);
    return status;
}
