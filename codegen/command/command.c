/* What several commands have in common. */
#include "command/command.h"

#include "command/command_guard.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { MESSAGE_SIZE = 512 };

void ttc_command_raise(int *status, int to)
{
    if (*status < to) *status = to;
}

static void tell_no_memory(int *status)
{
    fprintf(stderr, "ttc: out of memory\n");
    ttc_command_raise(status, TTC_EXIT_MEMORY);
}

json_t *ttc_command_string(const char *bytes)
{
    json_t *string = json_string(bytes);
    if (string != NULL) return string;
    char *plain = malloc(strlen(bytes) + 1);
    if (plain == NULL) return NULL;
    for (size_t i = 0; i <= strlen(bytes); i++) plain[i] = (unsigned char)bytes[i] > 126 ? '?' : bytes[i];
    string = json_string(plain);
    free(plain);
    return string;
}

void ttc_command_add_problems(json_t *array, const ttc_diagnostics *diagnostics)
{
    for (size_t i = 0; i < ttc_diagnostics_size(diagnostics); i++) {
        ttc_diagnostic d = ttc_diagnostics_at(diagnostics, i);
        json_array_append_new(array, json_pack("{s:s, s:o, s:i, s:i, s:o}", "severity",
                                               d.severity == TTC_WARNING ? "warning" : "error", "file", ttc_command_string(d.file),
                                               "line", (int)d.line, "column", (int)d.column, "message",
                                               ttc_command_string(d.message)));
    }
}

json_t *ttc_command_failure(const char *path, json_t *problems)
{
    return json_pack("{s:o, s:b, s:o}", "file", ttc_command_string(path), "ok", 0, "problems", problems);
}

int ttc_command_unread(const ttc_diagnostics *diagnostics)
{
    if (ttc_io_error_count(diagnostics) > 0) return TTC_EXIT_IO;
    return ttc_memory_error_count(diagnostics) > 0 ? TTC_EXIT_MEMORY : TTC_EXIT_BAD_TABLE;
}

ttc_model *ttc_command_read(const char *path, int *status, json_t *problems)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    if (diagnostics == NULL) {
        tell_no_memory(status);
        return NULL;
    }
    ttc_model *model = ttc_model_read(path, diagnostics);
    ttc_diagnostics_print(diagnostics, stderr);
    if (problems != NULL) ttc_command_add_problems(problems, diagnostics);
    if (model == NULL)
        ttc_command_raise(status, ttc_command_unread(diagnostics));
    ttc_diagnostics_destroy(diagnostics);
    return model;
}

static void tell(ttc_severity severity, const ttc_model *model, ttc_place place, json_t *problems, const char *format,
                 va_list arguments)
{
    char message[MESSAGE_SIZE];
    vsnprintf(message, sizeof message, format, arguments);
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    if (diagnostics == NULL) {
        fprintf(stderr, "%s:%u:%u: %s\n", model->file, (unsigned)place.line, (unsigned)place.column, message);
        return;
    }
    ttc_diagnostics_source(diagnostics, model->file, model->text, strlen(model->text));
    ttc_report(diagnostics, severity, place.line, place.column, "%s", message);
    ttc_diagnostics_print(diagnostics, stderr);
    if (problems != NULL) ttc_command_add_problems(problems, diagnostics);
    ttc_diagnostics_destroy(diagnostics);
}

void ttc_command_complain(const ttc_model *model, ttc_place place, json_t *problems, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tell(TTC_ERROR, model, place, problems, format, arguments);
    va_end(arguments);
}

void ttc_command_warn(const ttc_model *model, ttc_place place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tell(TTC_WARNING, model, place, NULL, format, arguments);
    va_end(arguments);
}

bool ttc_command_passes_over(const ttc_model *model, const ttc_options *options)
{
    return model->lift.file != NULL && options->file_count > 1;
}

bool ttc_command_catalogue(ttc_catalogue *catalogue, const ttc_model *model, const ttc_options *options, int *status,
                           json_t *problems)
{
    if (model->lift.file != NULL) {
        ttc_command_complain(model, model->lift.place, problems,
                             "the coordinates of a section have no kernels of their own (expected "
                             "%s, with whose kernels theirs are written)",
                             model->lift.file);
        ttc_command_raise(status, TTC_EXIT_BAD_TABLE);
        return false;
    }
    if (ttc_catalogue_create(catalogue, model, options->extent, options->effort)) return true;
    ttc_command_complain(model, catalogue->failed_at, problems, "the kernels asked for here cannot be made: %s",
                         catalogue->failure);
    ttc_command_raise(status, catalogue->memory_is_out ? TTC_EXIT_MEMORY : TTC_EXIT_BAD_TABLE);
    return false;
}

/* Read the tables that claims lead to, so that this process goes by the texts of them that its workers do. */
static void read_targets(const ttc_model *model)
{
    ttc_diagnostics *ignored = ttc_diagnostics_create();
    for (size_t i = 0; i < model->claim_count && ignored != NULL; i++)
        if (model->claims[i].target != NULL)
            ttc_model_destroy(ttc_resolve_beside(NULL, model, model->claims[i].target, ignored));
    ttc_diagnostics_destroy(ignored);
}

ttc_proof_report *ttc_command_prove_guarded(const ttc_model *model, const ttc_options *options, int *status)
{
    const int seconds = options->effort == TTC_EFFORT_FULL ? TTC_GUARD_SECONDS_FULL : TTC_GUARD_SECONDS;
    read_targets(model);
    ttc_proof_report *report = ttc_prove_guarded(model, seconds, ttc_resolve_beside, NULL);
    if (report == NULL) {
        fprintf(stderr, "ttc: no process can be made that proves claims: %s\n", strerror(errno));
        ttc_command_raise(status, TTC_EXIT_MEMORY);
    }
    return report;
}
