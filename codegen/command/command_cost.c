/* ttc cost: operation counts of every kernel, as they stand and optimized. */
#include "command/command.h"
#include "emit/emit_registry.h"
#include "kernels/plan.h"

#include <jansson.h>
#include <stdlib.h>

static json_t *counts_to_json(ttc_count c)
{
    return json_pack("{s:i, s:i, s:i, s:i, s:i, s:i, s:i, s:i, s:i}", "flops", (int)ttc_count_flops(c), "add", (int)c.add,
                     "mul", (int)c.multiply, "fma", (int)c.fma, "div", (int)c.divide, "sqrt", (int)c.root, "elementary",
                     (int)c.elementary, "depth", (int)c.depth, "live", (int)c.live);
}

static void add_field(json_t *list, const ttc_planned *planned)
{
    json_t *kernels = json_object();
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) {
        const ttc_kernel *kernel = planned->kernels->kernels + kind;
        if (kernel->count == 0) continue;
        json_object_set_new(kernels, ttc_kernel_name((ttc_kernel_kind)kind),
                            json_pack("{s:o, s:o}", "optimized", counts_to_json(ttc_program_count(kernel->optimized)),
                                      "naive", counts_to_json(ttc_program_count(kernel->naive))));
    }
    json_array_append_new(list, json_pack("{s:s, s:s, s:s, s:o}", "variant",
                                          planned->variant == NULL ? "" : planned->variant->name, "time",
                                          planned->time == NULL ? "" : planned->time->name, "elimination",
                                          planned->elimination == NULL ? "" : planned->elimination->name, "kernels", kernels));
}

static int print_json(const ttc_plan *plans, size_t count)
{
    json_t *models = json_array();
    for (size_t i = 0; i < count; i++) {
        json_t *fields = json_array();
        for (size_t k = 0; k < plans[i].count; k++)
            if (plans[i].fields[k].kernels != NULL) add_field(fields, plans[i].fields + k);
        json_array_append_new(models, json_pack("{s:s, s:s, s:o}", "model", plans[i].model->name, "sha256",
                                                plans[i].model->sha256, "fields", fields));
    }
    char *text = json_dumps(models, JSON_INDENT(2));
    if (text != NULL) puts(text);
    int status = text == NULL ? TTC_EXIT_IO : TTC_EXIT_DONE;
    free(text);
    json_decref(models);
    return status;
}

int ttc_command_cost(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    ttc_text text = { 0 };
    ttc_model **models = calloc(options->file_count + 1, sizeof *models);
    ttc_plan *plans = calloc(options->file_count + 1, sizeof *plans);
    if (models == NULL || plans == NULL) {
        fprintf(stderr, "ttc: out of memory\n");
        status = TTC_EXIT_IO;
        goto done;
    }
    for (size_t i = 0; i < options->file_count; i++) {
        models[i] = ttc_command_read(options->files[i], &status);
        if (models[i] != NULL && !ttc_plan_create(plans + i, models[i], options->effort)) {
            fprintf(stderr, "%s: error: cannot plan kernels: memory is out, or an expression grows beyond the limits\n",
                    options->files[i]);
            status = TTC_EXIT_BAD_TABLE;
        }
    }
    if (status != TTC_EXIT_DONE) goto done;
    if (options->json) {
        status = print_json(plans, options->file_count);
    } else {
        ttc_emit_counts(&text, plans, options->file_count);
        status = text.failed ? TTC_EXIT_IO : TTC_EXIT_DONE;
        fputs(ttc_text_string(&text), stdout);
    }
done:
    ttc_text_clear(&text);
    for (size_t i = 0; i < options->file_count; i++) {
        if (plans != NULL) ttc_plan_clear(plans + i);
        if (models != NULL) ttc_model_destroy(models[i]);
    }
    free(plans);
    free(models);
    return status;
}
