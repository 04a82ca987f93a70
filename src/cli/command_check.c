/* `jellett check`: replays the proofs of certificates. */
#include "base/options.h"
#include "cli/certify_given.h"
#include "cli/common.h"
#include "cli/table.h"
#include "validated/certificate.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *model;
    char **files;
    size_t count;
} options;

static const struct argp_option option_table[] = {
    { "model", 'm', "FILE.tt", 0, "The table that the certificates are about, if it is not built in", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case 'm': o->model = value; return 0;
    case ARGP_KEY_ARGS:
        o->files = state->argv + state->next;
        o->count = (size_t)(state->argc - state->next);
        return 0;
    case ARGP_KEY_NO_ARGS: argp_error(state, "name a certificate"); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "CERTIFICATE...",
    "Replay certificates from their files alone: carry out the proofs again in ball arithmetic."
    "\vThe numbers of a certificate must follow from the replay, and its words from these numbers as they are written; it may "
    "have no members but those that are replayed. Exit status 1: a certificate does not prove what it says, or was changed "
    "after it was made. 3: the file is no certificate, or is about a table that is not here.\n\n"
    "Examples:\n"
    "  jellett check tools/certificates/sink.json",
    NULL, NULL, NULL,
};

/* Say it if a certificate is not about the table of --model, but about one that is built in. */
static void tell_other(const char *path, const json_t *certificate, const jlt_descriptor *own)
{
    const json_t *table = json_object_get(json_object_get(certificate, "given"), "table");
    const char *const name = json_string_value(json_object_get(table, "name"));

    if (own != NULL && strcmp(own->sha256, json_string_value(json_object_get(table, "sha256"))) != 0)
        fprintf(stderr, "jellett: %s is about %s as it is built in, not about the table of --model, %s\n", path, name,
                own->model);
}

static jlt_exit check(const char *path, const jlt_descriptor *own)
{
    json_error_t error;
    FILE *file = fopen(path, "r");
    json_auto_t *certificate = file != NULL ? json_loadf(file, JSON_REJECT_DUPLICATES, &error) : NULL;
    const bool is_read = file != NULL && ferror(file) == 0;
    jlt_certificate_report report;
    jlt_progress progress;
    jlt_step_watch watch;

    if (!is_read) (void)jlt_command_fail(JLT_EXIT_IO, "cannot read '%s': %s", path, strerror(errno));
    if (file != NULL) fclose(file);
    if (!is_read) return JLT_EXIT_IO;
    if (certificate == NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s:%d: %s (expected a certificate that 'jellett certify' wrote)", path, error.line,
                                error.text);
    watch = jlt_certify_watch(&progress);
    jlt_certificate_check(&report, certificate, own, &watch);
    jlt_progress_end(&progress);
    if (report.verdict == JLT_CERTIFICATE_GOOD) {
        const json_t *words = json_object_get(certificate, "theorem");
        printf("%s: proved\n", path);
        for (size_t i = 0; i < json_array_size(words); i++) printf("  %s\n", json_string_value(json_array_get(words, i)));
        tell_other(path, certificate, own);
    }
    switch (report.verdict) {
    case JLT_CERTIFICATE_GOOD: return JLT_EXIT_DONE;
    case JLT_CERTIFICATE_REFUSED: return jlt_command_fail(JLT_EXIT_FAILED, "%s: refused: %s", path, report.problem);
    case JLT_CERTIFICATE_MALFORMED: return jlt_command_fail(JLT_EXIT_INPUT, "%s: %s", path, report.problem);
    default: return jlt_command_fail(JLT_EXIT_NUMERICAL, "%s: the proof could not be carried out: %s", path, report.problem);
    }
}

static jlt_exit run(int argc, char **argv)
{
    const jlt_descriptor *own = NULL;
    bool has_said = true;
    jlt_exit code = JLT_EXIT_DONE;
    options o = { 0 };

    ttc_options_parse(&parser, argc, argv, &o);
    if (o.model != NULL) code = jlt_table_open(&own, &has_said, o.model, false);
    if (code != JLT_EXIT_DONE) return code;
    if (!has_said) jlt_command_warn_unproved(own);
    for (size_t i = 0; i < o.count; i++) {
        const jlt_exit one = check(o.files[i], own);
        if (one > code) code = one;
    }
    return code;
}

const jlt_command jlt_command_check = { "check", "CERTIFICATE... [OPTION...]", "Replay certificates", run, NULL, NULL };
