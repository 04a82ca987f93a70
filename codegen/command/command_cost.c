/* ttc cost: prints operation counts of every kernel, as the terms stand and optimized. */
#include "command/command.h"
#include "emit/emit_registry.h"

#include <stdlib.h>

static json_t *counts_to_json(ttc_count c)
{
    return json_pack("{s:i, s:i, s:i, s:i, s:i, s:i, s:i, s:i, s:i}", "flops", (int)ttc_count_flops(c), "add", (int)c.add,
                     "mul", (int)c.multiply, "fma", (int)c.fma, "div", (int)c.divide, "sqrt", (int)c.root, "elementary",
                     (int)c.elementary, "depth", (int)c.depth, "live", (int)c.live);
}

static void add_field(json_t *list, const ttc_catalogue_entry *entry)
{
    json_t *kernels = json_object();
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) {
        const ttc_kernel *kernel = entry->kernels->kernels + kind;
        if (kernel->count == 0) continue;
        json_object_set_new(kernels, ttc_kernel_name((ttc_kernel_kind)kind),
                            json_pack("{s:o, s:o}", "optimized", counts_to_json(ttc_program_count(kernel->optimized)),
                                      "naive", counts_to_json(ttc_program_count(kernel->naive))));
    }
    json_array_append_new(list, json_pack("{s:s, s:s, s:s, s:o}", "variant",
                                          entry->variant == NULL ? "" : entry->variant->name, "time",
                                          entry->time == NULL ? "" : entry->time->name, "elimination",
                                          entry->elimination == NULL ? "" : entry->elimination->name, "kernels", kernels));
}

/* failures: the JSON of tables without a catalogue, which comes last. */
static int print_json(const ttc_catalogue *catalogues, size_t count, json_t *failures)
{
    json_t *models = json_array();
    for (size_t i = 0; i < count; i++) {
        if (catalogues[i].model == NULL) continue;
        json_t *fields = json_array();
        for (size_t k = 0; k < catalogues[i].count; k++)
            if (catalogues[i].fields[k].kernels != NULL) add_field(fields, catalogues[i].fields + k);
        json_array_append_new(models, json_pack("{s:s, s:s, s:o}", "model", catalogues[i].model->name, "sha256",
                                                catalogues[i].model->sha256, "fields", fields));
    }
    json_array_extend(models, failures);
    char *text = json_dumps(models, JSON_INDENT(2));
    if (text != NULL) puts(text);
    int status = text == NULL ? TTC_EXIT_MEMORY : TTC_EXIT_DONE;
    free(text);
    json_decref(models);
    return status;
}

int ttc_command_cost(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    ttc_text text = { 0 };
    ttc_model **models = calloc(options->file_count + 1, sizeof *models);
    ttc_catalogue *catalogues = calloc(options->file_count + 1, sizeof *catalogues);
    json_t *failures = json_array();
    if (models == NULL || catalogues == NULL || failures == NULL) {
        fprintf(stderr, "ttc: out of memory\n");
        status = TTC_EXIT_MEMORY;
        goto done;
    }
    for (size_t i = 0; i < options->file_count; i++) {
        json_t *problems = json_array();
        models[i] = ttc_command_read(options->files[i], &status, problems);
        const bool passes = models[i] != NULL && ttc_command_passes_over(models[i], options);
        if (models[i] == NULL || (!passes && !ttc_command_catalogue(catalogues + i, models[i], options, &status, problems)))
            json_array_append_new(failures, ttc_command_failure(options->files[i], problems));
        else json_decref(problems);
    }
    if (options->json) {
        ttc_command_raise(&status, print_json(catalogues, options->file_count, failures));
    } else if (status == TTC_EXIT_DONE) {
        ttc_emit_counts_titles(&text);
        for (size_t i = 0; i < options->file_count; i++) ttc_emit_counts_rows(&text, catalogues + i);
        status = text.failed ? TTC_EXIT_MEMORY : TTC_EXIT_DONE;
        fputs(ttc_text_string(&text), stdout);
    }
done:
    json_decref(failures);
    ttc_text_clear(&text);
    for (size_t i = 0; i < options->file_count; i++) {
        if (catalogues != NULL) ttc_catalogue_clear(catalogues + i);
        if (models != NULL) ttc_model_destroy(models[i]);
    }
    free(catalogues);
    free(models);
    return status;
}
