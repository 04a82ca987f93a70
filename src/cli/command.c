#include "cli/command.h"

#include "cli/interrupt.h"
#include "kernel/descriptor.h"
#include "report/file.h"
#include "report/letters.h"
#include "scene/plan.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

jlt_exit jlt_command_fail(jlt_exit code, const char *format, ...)
{
    va_list arguments;

    fflush(stdout);
    fputs("jellett: ", stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return code;
}

static void warn_of(const jlt_descriptor *of)
{
    char claims[1024];

    if (of == NULL) return;
    if (jlt_descriptor_unproved(claims, sizeof claims, of))
        fprintf(stderr, "jellett: warning: kernels of %s rest on claims that are not proved: %s\n", of->model, claims);
    for (const jlt_claim *claim = of->claims; claim->kind != NULL; claim++) /* a section is among the above */
        if (claim->file != NULL && claim->verdict != JLT_PROVED && strcmp(claim->kind, "section") != 0)
            fprintf(stderr, "jellett: warning: the %s %s of %s is %s: %s and this table do not serve in place of each other\n",
                    claim->kind, claim->name, of->model, claim->verdict == JLT_REFUTED ? "refuted" : "not settled", claim->file);
}

void jlt_command_warn_unproved(const jlt_descriptor *descriptor)
{
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned count = jlt_tier_list(tiers, descriptor, NULL);

    warn_of(descriptor);
    for (unsigned i = 0; i < count; i++) /* warn for each table that may answer in its place */
        if (tiers[i].table != NULL && tiers[i].table != descriptor && !tiers[i].by_name) warn_of(tiers[i].table);
}

static bool lacked_memory;

bool jlt_command_lacked_memory(void) { return lacked_memory; }

jlt_exit jlt_command_no_memory(void)
{
    return jlt_command_fail(jlt_command_exit(JLT_ERR_NOMEM), "%s", jlt_status_text(JLT_ERR_NOMEM));
}

jlt_exit jlt_command_cannot_write(const char *path)
{
    if (jlt_command_is_standard_output(path))
        return jlt_command_fail(JLT_EXIT_IO, "cannot write to standard output: %s", strerror(errno));
    return jlt_command_fail(JLT_EXIT_IO, "cannot write '%s': %s (choose a folder that exists and has room)", path, strerror(errno));
}

jlt_exit jlt_command_exit(jlt_status status)
{
    switch (status) {
    case JLT_OK: return JLT_EXIT_DONE;
    case JLT_ERR_ARG:
    case JLT_ERR_DOMAIN:
    case JLT_ERR_EMPTY:
    case JLT_ERR_UNSUPPORTED: return JLT_EXIT_INPUT;
    case JLT_ERR_IO: return JLT_EXIT_IO;
    case JLT_ERR_NOMEM: lacked_memory = true; return JLT_EXIT_NUMERICAL;
    default: return JLT_EXIT_NUMERICAL;
    }
}

char *jlt_command_line(int argc, char **argv)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789=,.:/+-_@%";
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);

    if (stream == NULL) return NULL;
    for (int i = 0; i < argc; i++) {
        if (strncmp(argv[i], JLT_COMMAND_HIDDEN, strlen(JLT_COMMAND_HIDDEN)) == 0) continue;
        const bool bare = i == 0 || (argv[i][0] != '\0' && argv[i][strspn(argv[i], plain)] == '\0');
        /* bytes that are no text in one line: as \ooo in $'...' */
        const bool coded = !bare && (!jlt_letters_fit(argv[i]) || strchr(argv[i], '\n') != NULL);
        if (i > 0) fputc(' ', stream);
        if (!bare) fputs(coded ? "$'" : "'", stream);
        for (const char *c = argv[i]; *c != '\0'; c++) {
            if (coded && (*c < ' ' || *c > '~' || *c == '\'' || *c == '\\')) fprintf(stream, "\\%03o", (unsigned char)*c);
            else if (*c == '\'' && !bare) fputs("'\\''", stream);
            else fputc(*c, stream);
        }
        if (!bare) fputc('\'', stream);
    }
    if (fclose(stream) == 0) return text;
    free(text);
    return NULL;
}

void jlt_command_free(char **argv, int argc)
{
    for (int i = 0; argv != NULL && i < argc; i++) free(argv[i]);
    free(argv);
}

jlt_status jlt_command_open(jlt_command_output *output)
{
    *output = (jlt_command_output){ 0 };
    output->stream = open_memstream(&output->text, &output->size);
    return output->stream == NULL ? JLT_ERR_NOMEM : JLT_OK;
}

jlt_status jlt_command_close(jlt_command_output *output)
{
    const int failed = ferror(output->stream) | fclose(output->stream);

    output->stream = NULL;
    return failed ? JLT_ERR_NOMEM : JLT_OK;
}

bool jlt_command_is_standard_output(const char *path)
{
    return path == NULL || strcmp(path, "-") == 0;
}

static const char *name_of(const char *path)
{
    return jlt_command_is_standard_output(path) ? "/dev/stdout" : path;
}

jlt_exit jlt_command_distinct(const jlt_command_file *files, size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < i; k++) {
            if (jlt_command_is_standard_output(files[k].path) && jlt_command_is_standard_output(files[i].path))
                return jlt_command_fail(JLT_EXIT_USAGE, "two tables on standard output: name a file for %s", files[i].option);
            if (jlt_file_same(name_of(files[k].path), name_of(files[i].path)))
                return jlt_command_fail(JLT_EXIT_USAGE, "%s and %s are one file, %s: give each its own", files[k].option,
                                        files[i].option, files[i].path);
        }
    return JLT_EXIT_DONE;
}

jlt_exit jlt_command_check_output(const char *path)
{
    return jlt_command_is_standard_output(path) || jlt_file_reachable(path) == JLT_OK ? JLT_EXIT_DONE
                                                                                      : jlt_command_cannot_write(path);
}

jlt_exit jlt_command_write(const char *path, const char *data, size_t size)
{
    jlt_exit code = JLT_EXIT_DONE;

    jlt_interrupt_hold();
    switch (jlt_file_write(path, data, size)) {
    case JLT_OK: break;
    case JLT_ERR_NOMEM: code = jlt_command_no_memory(); break;
    default: code = jlt_command_cannot_write(path); break;
    }
    jlt_interrupt_release();
    return code;
}

jlt_exit jlt_command_deliver(jlt_command_output *output, const char *path)
{
    jlt_exit code = JLT_EXIT_DONE;

    if (jlt_command_close(output) != JLT_OK) {
        code = jlt_command_no_memory();
    } else if (jlt_command_is_standard_output(path)) {
        if (fwrite(output->text, 1, output->size, stdout) != output->size || fflush(stdout) != 0) {
            code = jlt_command_cannot_write(path);
            clearerr(stdout);
        }
    } else {
        code = jlt_command_write(path, output->text, output->size);
    }
    jlt_command_discard(output);
    return code;
}

void jlt_command_discard(jlt_command_output *output)
{
    if (output->stream != NULL) fclose(output->stream);
    free(output->text);
    *output = (jlt_command_output){ 0 };
}
