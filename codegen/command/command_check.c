/* ttc check: reports whether tables are well formed. Nothing is proved. */
#include "command/command.h"

#include <stdlib.h>

static json_t *describe(const char *path, const ttc_model *model, const ttc_diagnostics *diagnostics)
{
    json_t *result = json_pack("{s:o, s:b}", "file", ttc_command_string(path), "ok", model != NULL);
    if (model != NULL)
        json_object_update_new(result, json_pack("{s:s, s:s, s:I, s:I, s:I, s:I, s:I, s:I}", "model", model->name, "sha256",
                                                 model->sha256, "params", (json_int_t)model->param_count, "states",
                                                 (json_int_t)model->state_count, "variants",
                                                 (json_int_t)model->variant_count, "times", (json_int_t)model->time_count,
                                                 "eliminations", (json_int_t)model->elimination_count, "claims",
                                                 (json_int_t)model->claim_count));
    json_object_set_new(result, "errors", json_integer((json_int_t)ttc_error_count(diagnostics)));
    json_object_set_new(result, "warnings", json_integer((json_int_t)ttc_warning_count(diagnostics)));
    json_t *problems = json_array();
    ttc_command_add_problems(problems, diagnostics);
    json_object_set_new(result, "problems", problems);
    return result;
}

static void tell(const char *path, const ttc_model *model, const ttc_diagnostics *diagnostics)
{
    ttc_diagnostics_print(diagnostics, stderr);
    if (model != NULL)
        printf("%s: model %s is well formed: parameters: %zu, states: %zu, claims (not proved): %zu, warnings: %zu\n", path,
               model->name, model->param_count, model->state_count, model->claim_count, ttc_warning_count(diagnostics));
    else
        fprintf(stderr, "%s: errors: %zu, warnings: %zu\n", path, ttc_error_count(diagnostics), ttc_warning_count(diagnostics));
}

int ttc_command_check(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    json_t *results = options->json ? json_array() : NULL;
    for (size_t i = 0; i < options->file_count; i++) {
        ttc_diagnostics *diagnostics = ttc_diagnostics_create();
        if (diagnostics == NULL) {
            fprintf(stderr, "ttc: out of memory\n");
            status = TTC_EXIT_MEMORY;
            break;
        }
        ttc_model *model = ttc_model_read(options->files[i], diagnostics);
        if (model == NULL) ttc_command_raise(&status, ttc_command_unread(diagnostics));
        if (options->json) json_array_append_new(results, describe(options->files[i], model, diagnostics));
        else tell(options->files[i], model, diagnostics);
        ttc_model_destroy(model);
        ttc_diagnostics_destroy(diagnostics);
    }
    if (options->json) {
        json_dumpf(results, stdout, JSON_INDENT(2));
        putchar('\n');
        json_decref(results);
    }
    return status;
}
