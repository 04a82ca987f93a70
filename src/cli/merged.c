#include "cli/merged.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "cli/interrupt.h"

bool jlt_merged_is_database(const char *path)
{
    return !jlt_command_is_standard_output(path) && (jlt_file_ends(path, ".sqlite") || jlt_file_ends(path, ".db"));
}

bool jlt_merged_known(const char *path)
{
    return jlt_command_is_standard_output(path) || jlt_stream_is_array(path) || jlt_merged_is_database(path)
           || jlt_file_ends(path, ".csv");
}

static jlt_exit database_failed(const jlt_merged *self, char *message)
{
    jlt_exit code = JLT_EXIT_IO;

    if (message == NULL) code = jlt_command_no_memory();
    else (void)jlt_command_fail(code, "cannot write '%s': %s", self->path, message);
    free(message);
    return code;
}

static jlt_exit open_database(jlt_merged *self, const jlt_table_form *form, size_t over, const char *study)
{
    char *message = NULL;

    jlt_interrupt_hold();
    const jlt_status st = jlt_file_begin(&self->place, self->path);
    if (st == JLT_OK) jlt_interrupt_remember(&self->place);
    jlt_interrupt_release();
    if (st == JLT_ERR_IO) return jlt_command_cannot_write(self->path);
    if (st != JLT_OK) return jlt_command_no_memory();
    if (self->place.temporary == NULL)
        return jlt_command_fail(JLT_EXIT_IO, "cannot write '%s': SQLite goes to files alone", self->path);
    const char *const slash = strrchr(self->place.target, '/'), *const name = slash != NULL ? slash + 1 : self->place.target;
    if (strlen(name) + strlen("-wal") > NAME_MAX) { /* none who reads it could open the file beside it */
        errno = ENAMETOOLONG;
        return jlt_command_cannot_write(self->path);
    }
    if (jlt_database_create(&self->database, &message, self->place.temporary, form, over, study) == JLT_OK) return JLT_EXIT_DONE;
    return database_failed(self, message);
}

jlt_exit jlt_merged_open(jlt_merged *self, const char *path, const jlt_table_form *form, size_t over, const char *study,
                         const char *header)
{
    *self = (jlt_merged){ .path = path };
    if (jlt_merged_is_database(path)) return open_database(self, form, over, study);
    JLT_PASS(jlt_stream_open(&self->stream, path));
    fputs(header, self->stream.file);
    for (size_t i = 0; i < form->count; i++) fprintf(self->stream.file, "%s%s", i > 0 ? "," : "", form->columns[i].name);
    fputc('\n', self->stream.file);
    return JLT_EXIT_DONE;
}

bool jlt_merged_piece(jlt_merged *self, const jlt_shard_record *record)
{
    return self->database == NULL || jlt_database_piece(self->database, record) == JLT_OK;
}

bool jlt_merged_row(jlt_merged *self, const jlt_table_form *form, char *const *fields)
{
    if (self->database != NULL) return jlt_database_row(self->database, fields) == JLT_OK;
    for (size_t i = 0; i < form->count; i++) {
        if (i > 0) fputc(',', self->stream.file);
        fputs(fields[i], self->stream.file);
    }
    fputc('\n', self->stream.file);
    return ferror(self->stream.file) == 0;
}

/* A file of the half of a table is not kept, unlike that of jlt_stream_close. */
static jlt_exit close_stream(jlt_merged *self)
{
    errno = 0;
    if (fflush(self->stream.file) == 0 && ferror(self->stream.file) == 0) return jlt_stream_close(&self->stream);
    if (errno == 0) errno = EIO;
    return jlt_command_cannot_write(self->path);
}

jlt_exit jlt_merged_close(jlt_merged *self)
{
    char *message = NULL;
    jlt_exit code = JLT_EXIT_DONE;

    if (self->database == NULL) return close_stream(self);
    const jlt_status st = jlt_database_finish(self->database, &message);
    self->database = NULL;
    if (st != JLT_OK) return database_failed(self, message);
    jlt_interrupt_hold();
    if (jlt_file_commit(&self->place) != JLT_OK) code = jlt_command_cannot_write(self->path);
    jlt_interrupt_release();
    return code;
}

void jlt_merged_discard(jlt_merged *self)
{
    jlt_database_destroy(self->database);
    jlt_stream_discard(&self->stream);
    jlt_interrupt_hold();
    jlt_interrupt_forget(&self->place);
    jlt_file_end(&self->place);
    jlt_interrupt_release();
    *self = (jlt_merged){ .path = self->path };
}
