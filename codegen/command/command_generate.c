/* ttc generate: all files of all tables, written together or not at all. */
#include "command/command.h"
#include "emit/emit.h"
#include "emit/emit_registry.h"
#include "base/output.h"
#include "kernels/plan.h"

#include <stdlib.h>
#include <string.h>

static ttc_text *add_file(ttc_output *output, const char *folder, const char *name, const char *extension)
{
    ttc_text path = { 0 };
    ttc_text_format(&path, "%s%s%s%s", folder, *folder == '\0' ? "" : "/", name, extension);
    ttc_text *text = path.failed ? NULL : ttc_output_add(output, ttc_text_string(&path));
    ttc_text_clear(&path);
    return text;
}

static bool generate_model(ttc_output *output, const ttc_plan *plan)
{
    const ttc_model *model = plan->model;
    ttc_text *text = add_file(output, model->name, "table", ".c");
    if (text != NULL) ttc_emit_table(text, model);
    for (size_t i = 0; i < plan->count && !output->failed; i++) {
        if (plan->fields[i].kernels == NULL) continue;
        ttc_text stem = { 0 };
        ttc_emit_stem(&stem, plan->fields[i].kernels->field);
        text = add_file(output, model->name, ttc_text_string(&stem), ".c");
        bool ok = text != NULL && ttc_emit_descriptor(text, plan->fields[i].kernels);
        text = ok ? add_file(output, model->name, ttc_text_string(&stem), "_lanes.inc") : NULL;
        ttc_text_clear(&stem);
        if (text == NULL) return false;
        ttc_emit_lanes(text, plan->fields[i].kernels);
    }
    for (unsigned isa = 0; isa < TTC_ISA_COUNT && !output->failed; isa++) {
        text = add_file(output, model->name, "batch_", ttc_isa_files[isa]);
        if (text != NULL) ttc_emit_batch(text, plan, isa);
    }
    text = output->failed ? NULL : add_file(output, model->name, model->name, "_ball.c");
    return text != NULL && ttc_emit_ball(text, plan);
}

static bool generate_shared(ttc_output *output, const ttc_plan *plans, size_t count)
{
    static const struct {
        const char *name;
        void (*emit)(ttc_text *text);
    } fixed[] = { { "kernel_abi.h", ttc_emit_abi },
                  { "kernel_arithmetic.h", ttc_emit_arithmetic },
                  { "kernel_ball.h", ttc_emit_ball_header },
                  { "kernel_jet.h", ttc_emit_jet_header },
                  { "lanes.h", ttc_emit_lanes_header },
                  { "registry.h", ttc_emit_registry_header } };
    static const struct {
        const char *name;
        void (*emit)(ttc_text *text, const ttc_plan *plans, size_t count);
    } lists[] = { { "registry.c", ttc_emit_registry },
                  { "ball_registry.c", ttc_emit_ball_registry },
                  { "manifest.tsv", ttc_emit_manifest },
                  { "counts.tsv", ttc_emit_counts } };
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++) {
        ttc_text *text = ttc_output_add(output, fixed[i].name);
        if (text == NULL) return false;
        fixed[i].emit(text);
    }
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        ttc_text *text = ttc_output_add(output, lists[i].name);
        if (text == NULL) return false;
        lists[i].emit(text, plans, count);
    }
    return true;
}

static bool is_failed(const ttc_output *output)
{
    bool failed = output->failed;
    for (size_t i = 0; i < output->count; i++) failed |= output->files[i].text.failed;
    return failed;
}

static void complain(const char *file, const ttc_model *model, const ttc_output *output)
{
    const ttc_graph_status error = ttc_graph_error(model->graph);
    fprintf(stderr, "%s: error: cannot generate kernels: ", file);
    if (output->taken != NULL)
        fprintf(stderr, "'%s' would be written twice (tables, and variants, times and eliminations of one, need names of their own)\n",
                output->taken);
    else if (error != TTC_GRAPH_OK) fprintf(stderr, "%s\n", ttc_graph_status_text(error));
    else fprintf(stderr, "%s\n", output->failed ? "out of memory" : "a number is beyond double precision, or memory is out");
}

static int write_files(const ttc_output *output, const char *folder)
{
    const char *where = NULL;
    int error = ttc_output_write(output, folder, &where);
    if (error == 0) return TTC_EXIT_DONE;
    if (where == folder) fprintf(stderr, "ttc: cannot make the folder %s: %s (the one above it must exist)\n", folder, strerror(error));
    else fprintf(stderr, "ttc: cannot write %s below %s: %s; nothing was changed\n", where, folder, strerror(error));
    return TTC_EXIT_IO;
}

int ttc_command_generate(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    ttc_output output = { 0 };
    ttc_model **models = calloc(options->file_count + 1, sizeof *models);
    ttc_plan *plans = calloc(options->file_count + 1, sizeof *plans);
    if (options->out == NULL) {
        fprintf(stderr, "ttc generate: no folder is given (expected --out DIR)\n");
        status = TTC_EXIT_USAGE;
        goto done;
    }
    if (models == NULL || plans == NULL) {
        fprintf(stderr, "ttc: out of memory\n");
        status = TTC_EXIT_IO;
        goto done;
    }
    for (size_t i = 0; i < options->file_count; i++) models[i] = ttc_command_read(options->files[i], &status);
    for (size_t i = 0; i < options->file_count && status == TTC_EXIT_DONE; i++)
        if (!ttc_plan_create(plans + i, models[i], options->effort) || !generate_model(&output, plans + i)) {
            complain(options->files[i], models[i], &output);
            status = TTC_EXIT_BAD_TABLE;
        }
    if (status == TTC_EXIT_DONE && (!generate_shared(&output, plans, options->file_count) || is_failed(&output))) {
        fprintf(stderr, "ttc: cannot generate: out of memory\n");
        status = TTC_EXIT_BAD_TABLE;
    }
    if (status == TTC_EXIT_DONE) status = write_files(&output, options->out);
done:
    for (size_t i = 0; i < options->file_count; i++) {
        if (plans != NULL) ttc_plan_clear(plans + i);
        if (models != NULL) ttc_model_destroy(models[i]);
    }
    free(plans);
    free(models);
    ttc_output_clear(&output);
    return status;
}
