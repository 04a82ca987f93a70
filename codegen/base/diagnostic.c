#include "base/diagnostic.h"

#include "base/array.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { MESSAGE_SIZE = 512, EXCERPT_WIDTH = 160 };

typedef struct {
    ttc_severity severity;
    uint32_t line, column;
    size_t source;  /* number of the call of ttc_diagnostics_source that began its source */
    char *file, *message;
    char *excerpt;  /* the line and the caret below it; NULL when there is no text */
} record;

struct ttc_diagnostics {
    record *records;
    size_t count;
    size_t kept_of_source;
    size_t errors, io_errors, memory_errors, warnings, dropped;
    size_t source;
    const char *file, *text;
    size_t length;
};

ttc_diagnostics *ttc_diagnostics_create(void) { return calloc(1, sizeof(ttc_diagnostics)); }

static void record_clear(record *r)
{
    free(r->file);
    free(r->message);
    free(r->excerpt);
}

void ttc_diagnostics_destroy(ttc_diagnostics *diagnostics)
{
    if (diagnostics == NULL) return;
    for (size_t i = 0; i < diagnostics->count; i++) record_clear(diagnostics->records + i);
    free(diagnostics->records);
    free(diagnostics);
}

void ttc_diagnostics_source(ttc_diagnostics *diagnostics, const char *file, const char *text, size_t length)
{
    diagnostics->source++;
    diagnostics->kept_of_source = 0;
    diagnostics->file = file;
    diagnostics->text = text;
    diagnostics->length = length;
}

static bool is_continuation_byte(char c) { return ((unsigned char)c & 0xC0u) == 0x80u; }

static bool is_control(char c) { return (unsigned char)c < 0x20u || c == 0x7f; }

/* Cut out the part of the line around the column, with control characters replaced, and put a caret below the column. Returns NULL
 * when the line does not exist or memory is out. */
static char *make_excerpt(const char *text, size_t length, uint32_t line, uint32_t column)
{
    const char *start = text, *end = text + length;
    for (uint32_t at = 1; at < line; at++) {
        start = memchr(start, '\n', (size_t)(end - start));
        if (start == NULL) return NULL;
        start++;
    }
    const char *stop = memchr(start, '\n', (size_t)(end - start));
    if (stop == NULL) stop = end;
    const char *mark = column - 1u <= (size_t)(stop - start) ? start + (column - 1u) : stop;
    if (mark - start > EXCERPT_WIDTH / 2) {
        start = mark - EXCERPT_WIDTH / 2;
        while (start < mark && is_continuation_byte(*start)) start++;
    }
    if (stop - start > EXCERPT_WIDTH) {
        stop = start + EXCERPT_WIDTH;
        while (stop > mark && is_continuation_byte(*stop)) stop--;
    }
    char *excerpt = malloc(2 * EXCERPT_WIDTH + 32);
    if (excerpt == NULL) return NULL;
    size_t n = 0;
    memcpy(excerpt, "    ", 4);
    n += 4;
    for (const char *c = start; c < stop; c++) excerpt[n++] = *c == '\t' ? ' ' : is_control(*c) ? '?' : *c;
    excerpt[n++] = '\n';
    memcpy(excerpt + n, "    ", 4);
    n += 4;
    for (const char *c = start; c < mark; c++)
        if (!is_continuation_byte(*c)) excerpt[n++] = ' ';
    excerpt[n++] = '^';
    excerpt[n] = '\0';
    return excerpt;
}

static void make_printable(char *message)
{
    for (char *c = message; *c != '\0'; c++)
        if (is_control(*c)) *c = '?';
}

static bool has_place(ttc_severity severity) { return severity == TTC_ERROR || severity == TTC_WARNING; }

static bool stands_before(const record *a, const record *b)
{
    if (a->source != b->source) return a->source < b->source;
    if (a->line != b->line) return a->line < b->line;
    return a->column < b->column;
}

static bool reserve(ttc_diagnostics *diagnostics)
{
    if (!TTC_ARRAY_GROW(diagnostics->records, diagnostics->count)) return false;
    return true;
}

void ttc_report(ttc_diagnostics *diagnostics, ttc_severity severity, uint32_t line, uint32_t column, const char *format,
                ...)
{
    if (severity == TTC_WARNING) diagnostics->warnings++;
    else diagnostics->errors++;
    if (severity == TTC_IO_ERROR) diagnostics->io_errors++;
    if (severity == TTC_MEMORY_ERROR) diagnostics->memory_errors++;
    if (diagnostics->kept_of_source >= TTC_DIAGNOSTIC_LIMIT || !reserve(diagnostics)) {
        diagnostics->dropped++;
        return;
    }
    record r = { .severity = severity, .line = line, .column = column, .source = diagnostics->source };
    const char *file = diagnostics->file == NULL ? "-" : diagnostics->file;
    r.file = malloc(strlen(file) + 1);
    r.message = malloc(MESSAGE_SIZE);
    if (r.file == NULL || r.message == NULL) {
        record_clear(&r);
        diagnostics->dropped++;
        return;
    }
    memcpy(r.file, file, strlen(file) + 1);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r.message, MESSAGE_SIZE, format, arguments);
    va_end(arguments);
    make_printable(r.message);
    if (has_place(severity) && diagnostics->text != NULL)
        r.excerpt = make_excerpt(diagnostics->text, diagnostics->length, line, column);
    size_t at = diagnostics->count++;
    for (; at > 0 && stands_before(&r, diagnostics->records + at - 1); at--)
        diagnostics->records[at] = diagnostics->records[at - 1];
    diagnostics->records[at] = r;
    diagnostics->kept_of_source++;
}

size_t ttc_error_count(const ttc_diagnostics *diagnostics) { return diagnostics->errors; }
size_t ttc_io_error_count(const ttc_diagnostics *diagnostics) { return diagnostics->io_errors; }
size_t ttc_memory_error_count(const ttc_diagnostics *diagnostics) { return diagnostics->memory_errors; }
size_t ttc_warning_count(const ttc_diagnostics *diagnostics) { return diagnostics->warnings; }
size_t ttc_diagnostics_size(const ttc_diagnostics *diagnostics) { return diagnostics->count; }

ttc_diagnostic ttc_diagnostics_at(const ttc_diagnostics *diagnostics, size_t index)
{
    const record *r = diagnostics->records + index;
    return (ttc_diagnostic){ r->severity, r->line, r->column, r->file, r->message };
}

void ttc_diagnostics_first_error(const ttc_diagnostics *diagnostics, char *out, size_t size)
{
    size_t i = 0;
    *out = '\0';
    while (i < diagnostics->count && diagnostics->records[i].severity == TTC_WARNING) i++;
    if (i == diagnostics->count) return;
    const record *r = diagnostics->records + i;
    if (!has_place(r->severity)) snprintf(out, size, "%s: %s", r->file, r->message);
    else snprintf(out, size, "%s:%u:%u: %s", r->file, (unsigned)r->line, (unsigned)r->column, r->message);
}

void ttc_diagnostics_print(const ttc_diagnostics *diagnostics, FILE *stream)
{
    for (size_t i = 0; i < diagnostics->count; i++) {
        const record *r = diagnostics->records + i;
        if (!has_place(r->severity)) fprintf(stream, "%s: error: %s\n", r->file, r->message);
        else
            fprintf(stream, "%s:%u:%u: %s: %s\n", r->file, (unsigned)r->line, (unsigned)r->column,
                    r->severity == TTC_ERROR ? "error" : "warning", r->message);
        if (r->excerpt != NULL) fprintf(stream, "%s\n", r->excerpt);
    }
    if (diagnostics->dropped > 0) fprintf(stream, "%zu more were found and are not shown\n", diagnostics->dropped);
}
