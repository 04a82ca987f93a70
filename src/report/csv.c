#include "report/csv.h"

#include "core/digits.h"
#include "core/memory.h"
#include "report/bits.h"
#include "report/decimal.h"
#include "report/json.h"
#include "report/table.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* How many fields are formatted before they are written. */
enum { FIELDS = 32 };

static json_t *text_or_null(const char *text)
{
    /* json_string returns NULL for text that is not UTF-8, which file names may contain */
    json_t *string = text != NULL && text[0] != '\0' ? json_string(text) : NULL;
    return string != NULL ? string : json_null();
}

static const char *unproved(const jlt_csv_settings *s) { return s->unproved != NULL ? s->unproved : s->descriptor->unproved; }

static const jlt_quantity *quantities(const jlt_csv_settings *s)
{
    return s->quantities != NULL ? s->quantities : s->descriptor->params;
}

static size_t param_count(const jlt_csv_settings *s)
{
    return s->quantities != NULL ? s->param_count : s->descriptor->param_count;
}

static bool has_values(const jlt_csv_settings *s)
{
    size_t i = 0;

    while (i < param_count(s) && isnan(s->params[i])) i++;
    return i < param_count(s);
}

static void write_json(FILE *stream, const jlt_csv_settings *s)
{
    const jlt_descriptor *d = s->descriptor;
    json_t *params = json_object(), *levels = json_object(), *whole;

    for (size_t i = 0; i < param_count(s); i++)
        if (!isnan(s->params[i])) (void)json_object_set_new(params, quantities(s)[i].name, jlt_json_number(s->params[i]));
    for (size_t i = 0; i < s->level_count; i++)
        if (!isnan(s->levels[i])) (void)json_object_set_new(levels, s->level_names[i], jlt_json_number(s->levels[i]));
    whole = json_pack("{s:o, s:s, s:s, s:o, s:o, s:o, s:s, s:s, s:o, s:o, s:o, s:o}", "command", text_or_null(s->command),
                      "version", JLT_VERSION, "model", d->model, "variant", text_or_null(d->variant), "time", text_or_null(d->time),
                      "elimination", text_or_null(d->elimination), "table", d->sha256, "generator", d->generator, "parameters",
                      params, "levels", levels, "method", text_or_null(s->method), "tolerance",
                      s->method != NULL ? jlt_json_number(s->tolerance) : json_null());
    if (unproved(s) != NULL) (void)json_object_set_new(whole, "unproved", text_or_null(unproved(s)));
    JLT_FREED char *text = jlt_json_text(whole, JSON_COMPACT);
    if (text != NULL) fprintf(stream, "# %s\n", text);
}

void jlt_csv_header(FILE *stream, const jlt_csv_settings *settings)
{
    const jlt_descriptor *descriptor = settings->descriptor;

    if (settings->command != NULL) fprintf(stream, "# command: %s\n", settings->command);
    fprintf(stream, "# jellett %s, kernels of %s", JLT_VERSION, descriptor->model);
    if (descriptor->variant[0] != '\0') fprintf(stream, ", variant %s", descriptor->variant);
    if (descriptor->time[0] != '\0') fprintf(stream, ", time %s", descriptor->time);
    if (descriptor->elimination[0] != '\0') fprintf(stream, ", %s", descriptor->elimination);
    fprintf(stream, " (table %s, %s)\n", descriptor->sha256, descriptor->generator);
    if (unproved(settings) != NULL) fprintf(stream, "# these rest on claims that are not proved: %s\n", unproved(settings));
    if (has_values(settings)) {
        fputc('#', stream);
        jlt_decimal_write_named(stream, quantities(settings), settings->params, param_count(settings));
        fputc('\n', stream);
    }
    write_json(stream, settings);
}

FILE *jlt_csv_names_begin(jlt_csv_names *self, FILE *file)
{
    *self = (jlt_csv_names){ .file = file };
    self->line = open_memstream(&self->text, &self->size);
    return self->line != NULL ? self->line : file;
}

/* Write names, given with commas between them, each made distinct. Cuts `text` at its commas. */
static jlt_status write_names(FILE *file, char *text)
{
    const size_t count = jlt_table_cut(NULL, 0, text);
    JLT_FREED char **names = calloc(count, sizeof *names);
    jlt_table_form form = { .count = 0 };
    jlt_status st = names != NULL ? JLT_OK : JLT_ERR_NOMEM;

    for (size_t i = 0; st == JLT_OK && i < count; i++, text += strlen(text) + 1) names[i] = text;
    if (st == JLT_OK) st = jlt_table_form_open(&form, names, count, strcmp);
    for (size_t i = 0; st == JLT_OK && i < count; i++) fprintf(file, "%s%s", i > 0 ? "," : "", form.columns[i].name);
    jlt_table_form_close(&form);
    return st;
}

void jlt_csv_names_end(jlt_csv_names *self)
{
    if (self->line != NULL && fclose(self->line) == 0) {
        char *copy = strdup(self->text);
        if (copy == NULL || write_names(self->file, copy) != JLT_OK) fputs(self->text, self->file);
        free(copy);
    }
    fputc('\n', self->file);
    free(self->text);
    self->text = NULL;
}

void jlt_csv_value(FILE *stream, double value)
{
    jlt_csv_values(stream, &value, 1);
}

/* Format up to FIELDS numbers by `write`, which returns the end of its text, then write them in one call. more: put a comma before
 * the first number too. */
static inline void write_fields(FILE *stream, const double *values, size_t count, bool more, char *(*write)(char *, double))
{
    char text[FIELDS * JLT_DIGITS_SIZE], *at = text;

    *at = '\0'; /* what a lone value that is not finite leaves */
    for (size_t i = 0; i < count; i++) {
        if (more || i > 0) *at++ = ',';
        if (isfinite(values[i])) at = write(at, values[i] + 0.0); /* turns -0 into 0 */
        if (i % FIELDS < FIELDS - 1 && i + 1 < count) continue;
        fwrite(text, 1, (size_t)(at - text), stream);
        at = text;
    }
}

void jlt_csv_values(FILE *stream, const double *values, size_t count)
{
    write_fields(stream, values, count, false, jlt_digits_shortest);
}

void jlt_csv_bits(FILE *stream, const double *values, size_t count)
{
    write_fields(stream, values, count, false, jlt_bits_write);
}

void jlt_csv_more(FILE *stream, const double *values, size_t count)
{
    write_fields(stream, values, count, true, jlt_digits_shortest);
}

void jlt_csv_row(FILE *stream, const double *values, size_t count)
{
    jlt_csv_values(stream, values, count);
    fputc('\n', stream);
}
