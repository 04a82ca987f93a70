#include "cli/merged.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "core/memory.h"

bool jlt_merged_known(jlt_merged_kind *kind, const char *path)
{
    static const struct {
        const char *ending;
        jlt_merged_kind kind;
    } known[] = { { ".csv", JLT_MERGED_CSV }, { ".npy", JLT_MERGED_NPY },
                  { ".sqlite", JLT_MERGED_SQLITE }, { ".db", JLT_MERGED_SQLITE } };
    const char *dot = strrchr(path, '.');

    *kind = JLT_MERGED_CSV;
    if (jlt_command_is_standard_output(path)) return true;
    for (size_t i = 0; dot != NULL && i < sizeof known / sizeof *known; i++)
        if (strcmp(known[i].ending, dot) == 0) {
            *kind = known[i].kind;
            return true;
        }
    return false;
}

static jlt_exit database_failed(const jlt_merged *self, char *message)
{
    jlt_exit code = JLT_EXIT_IO;

    if (message == NULL) code = jlt_command_no_memory();
    else (void)jlt_command_fail(code, "cannot write '%s': %s", self->path, message);
    free(message);
    return code;
}

static jlt_exit begin_file(jlt_merged *self)
{
    jlt_exit code = JLT_EXIT_DONE;

    if (jlt_command_is_standard_output(self->path)) {
        self->stream = stdout;
        return JLT_EXIT_DONE;
    }
    jlt_interrupt_hold();
    const jlt_status st = jlt_file_begin(&self->place, self->path);
    if (st == JLT_OK) jlt_interrupt_remember(&self->place);
    else code = st == JLT_ERR_IO ? jlt_command_cannot_write(self->path) : jlt_command_no_memory();
    jlt_interrupt_release();
    if (code != JLT_EXIT_DONE || self->kind != JLT_MERGED_CSV) return code;
    const int copy = dup(self->place.descriptor); /* fclose and jlt_file_end each close one */
    self->stream = copy >= 0 ? fdopen(copy, "w") : NULL;
    if (self->stream != NULL) return JLT_EXIT_DONE;
    if (copy >= 0) close(copy);
    return jlt_command_no_memory();
}

static void write_names(FILE *stream, const jlt_table_form *form, const char *header)
{
    fputs(header, stream);
    for (size_t i = 0; i < form->count; i++) fprintf(stream, "%s%s", i > 0 ? "," : "", form->columns[i].name);
    fputc('\n', stream);
}

static jlt_exit begin_array(jlt_merged *self, const jlt_table_form *form, const char *header)
{
    JLT_FREED char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    jlt_status st = stream != NULL ? JLT_OK : JLT_ERR_NOMEM;

    if (st == JLT_OK) write_names(stream, form, header);
    if (st == JLT_OK && fclose(stream) != 0) st = JLT_ERR_NOMEM;
    if (st == JLT_OK) st = jlt_npy_create(&self->array, &self->place);
    if (st == JLT_OK) st = jlt_npy_take(self->array, text, size);
    if (st == JLT_ERR_NOMEM) return jlt_command_no_memory();
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_command_cannot_write(self->path);
}

jlt_exit jlt_merged_open(jlt_merged *self, const char *path, const jlt_table_form *form, size_t over, const char *study,
                         const char *header)
{
    char *message = NULL;

    *self = (jlt_merged){ .path = path };
    (void)jlt_merged_known(&self->kind, path);
    JLT_PASS(begin_file(self));
    if (self->kind == JLT_MERGED_CSV) {
        write_names(self->stream, form, header);
        return JLT_EXIT_DONE;
    }
    if (self->place.temporary == NULL)
        return jlt_command_fail(JLT_EXIT_IO, "cannot write '%s': arrays and SQLite go to files alone", path);
    if (self->kind == JLT_MERGED_NPY) return begin_array(self, form, header);
    if (jlt_database_create(&self->database, &message, self->place.temporary, form, over, study) == JLT_OK) return JLT_EXIT_DONE;
    return database_failed(self, message);
}

bool jlt_merged_piece(jlt_merged *self, const jlt_shard_record *record)
{
    return self->database == NULL || jlt_database_piece(self->database, record) == JLT_OK;
}

bool jlt_merged_row(jlt_merged *self, const jlt_table_form *form, char *const *fields)
{
    switch (self->kind) {
    case JLT_MERGED_CSV:
        for (size_t i = 0; i < form->count; i++) {
            if (i > 0) fputc(',', self->stream);
            fputs(fields[i], self->stream);
        }
        fputc('\n', self->stream);
        break;
    case JLT_MERGED_NPY: return jlt_npy_row(self->array, fields) == JLT_OK;
    case JLT_MERGED_SQLITE: return jlt_database_row(self->database, fields) == JLT_OK;
    }
    return ferror(self->stream) == 0;
}

jlt_exit jlt_merged_close(jlt_merged *self)
{
    char *message = NULL;
    jlt_exit code = JLT_EXIT_DONE;

    if (self->database != NULL) {
        const jlt_status st = jlt_database_finish(self->database, &message);
        self->database = NULL;
        if (st != JLT_OK) return database_failed(self, message);
    } else if (self->array != NULL) {
        if (jlt_npy_flush(self->array) != JLT_OK) return jlt_command_cannot_write(self->path);
    } else {
        errno = 0;
        const bool failed = fflush(self->stream) != 0 || ferror(self->stream) != 0;
        if (failed && errno == 0) errno = EIO;
        if (failed) return jlt_command_cannot_write(self->path);
    }
    if (self->place.target == NULL) return JLT_EXIT_DONE;
    jlt_interrupt_hold();
    if (jlt_file_commit(&self->place) != JLT_OK) code = jlt_command_cannot_write(self->path);
    jlt_interrupt_release();
    return code;
}

void jlt_merged_discard(jlt_merged *self)
{
    jlt_database_destroy(self->database);
    if (self->stream != NULL && self->stream != stdout) fclose(self->stream);
    jlt_interrupt_hold();
    jlt_npy_destroy(self->array);
    jlt_interrupt_forget(&self->place);
    jlt_file_end(&self->place);
    jlt_interrupt_release();
    *self = (jlt_merged){ .path = self->path };
}
