#include "shards/database.h"

#include <sqlite3.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "core/memory.h"
#include "report/json.h"

struct jlt_database {
    sqlite3 *db;
    sqlite3_stmt *row, *piece;
    const jlt_table_form *form;
    jlt_table_form names; /* the columns' names, made distinct without regard to case, as SQL compares them */
    size_t over;
};

static jlt_status told(const jlt_database *self, char **message, int code)
{
    if (code == SQLITE_OK || code == SQLITE_DONE || code == SQLITE_ROW) return JLT_OK;
    if (message != NULL) *message = strdup(sqlite3_errmsg(self->db));
    return code == SQLITE_NOMEM ? JLT_ERR_NOMEM : JLT_ERR_IO;
}

static jlt_status execute(const jlt_database *self, char **message, const char *text)
{
    return told(self, message, sqlite3_exec(self->db, text, NULL, NULL, NULL));
}

static jlt_status find_names(jlt_database *self)
{
    JLT_FREED char **names = calloc(self->form->count + 1, sizeof *names);

    if (names == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < self->form->count; i++) names[i] = self->form->columns[i].name;
    return jlt_table_form_open(&self->names, names, self->form->count, strcasecmp);
}

/* Write the columns of CREATE TABLE: quoted names with their SQL types. */
static void write_columns(FILE *stream, const jlt_database *self)
{
    for (size_t i = 0; i < self->form->count; i++) {
        fprintf(stream, "%s\"%s\"", i > 0 ? ", " : "", self->names.columns[i].name);
        fputs(self->form->columns[i].is_text ? " TEXT" : " REAL", stream);
    }
}

static jlt_status make_tables(jlt_database *self, char **message)
{
    JLT_FREED char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);

    if (stream == NULL) return JLT_ERR_NOMEM;
    fputs("CREATE TABLE provenance (name TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID;"
          "CREATE TABLE pieces (piece INTEGER PRIMARY KEY, status INTEGER, words TEXT);"
          "CREATE TABLE rows (", stream);
    write_columns(stream, self);
    fputs(");", stream);
    if (fclose(stream) != 0) return JLT_ERR_NOMEM;
    return execute(self, message, text);
}

static jlt_status prepare(jlt_database *self, char **message)
{
    JLT_FREED char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    jlt_status st;

    if (stream == NULL) return JLT_ERR_NOMEM;
    fputs("INSERT INTO rows VALUES (", stream);
    for (size_t i = 0; i < self->form->count; i++) fputs(i > 0 ? ", ?" : "?", stream);
    fputc(')', stream);
    if (fclose(stream) != 0) return JLT_ERR_NOMEM;
    st = told(self, message, sqlite3_prepare_v2(self->db, text, -1, &self->row, NULL));
    return st != JLT_OK ? st : told(self, message, sqlite3_prepare_v2(self->db, "INSERT INTO pieces VALUES (?, ?, ?)", -1,
                                                                      &self->piece, NULL));
}

static jlt_status add_fact(const jlt_database *self, char **message, const char *name, const char *value)
{
    sqlite3_stmt *fact = NULL;
    jlt_status st = told(self, message, sqlite3_prepare_v2(self->db, "INSERT INTO provenance VALUES (?, ?)", -1, &fact, NULL));

    if (st == JLT_OK) {
        sqlite3_bind_text(fact, 1, name, -1, SQLITE_TRANSIENT);
        sqlite3_bind_text(fact, 2, value, -1, SQLITE_TRANSIENT);
        st = told(self, message, sqlite3_step(fact));
    }
    sqlite3_finalize(fact);
    return st;
}

/* Add each member of the study's JSON object, the whole JSON as `study`, and the shard key (jlt_shard_key) as `key`. */
static jlt_status add_provenance(const jlt_database *self, char **message, const char *study)
{
    json_auto_t *json = json_loads(study, 0, NULL);
    json_t *value;
    char key[JLT_SHARD_KEY];
    const char *name;
    jlt_status st;

    jlt_shard_key(key, study);
    st = add_fact(self, message, "key", key);
    if (st == JLT_OK) st = add_fact(self, message, "study", study);
    json_object_foreach(json, name, value) {
        char *text = json_is_string(value) ? strdup(json_string_value(value)) : json_dumps(value, JSON_ENCODE_ANY | JSON_COMPACT);
        if (st == JLT_OK) st = text == NULL ? JLT_ERR_NOMEM : add_fact(self, message, name, text);
        free(text);
    }
    return st;
}

jlt_status jlt_database_create(jlt_database **out, char **message, const char *path, const jlt_table_form *form, size_t over,
                               const char *study)
{
    JLT_OWNED(jlt_database) *self = calloc(1, sizeof *self);

    *out = NULL;
    *message = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->form = form;
    self->over = over;
    JLT_PASS(find_names(self));
    JLT_PASS(told(self, message, sqlite3_open(path, &self->db)));
    /* No other process sees the file before it is finished, so no journal is needed for a rollback. */
    JLT_PASS(execute(self, message, "PRAGMA page_size = 4096; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; BEGIN"));
    JLT_PASS(make_tables(self, message));
    JLT_PASS(add_provenance(self, message, study));
    JLT_PASS(prepare(self, message));
    *out = self;
    self = NULL;
    return JLT_OK;
}

jlt_status jlt_database_piece(jlt_database *self, const jlt_shard_record *record)
{
    sqlite3_bind_int64(self->piece, 1, (sqlite3_int64)record->piece);
    sqlite3_bind_int(self->piece, 2, record->status);
    sqlite3_bind_text64(self->piece, 3, record->words_size > 0 ? record->words : "", record->words_size, SQLITE_TRANSIENT,
                        SQLITE_UTF8);
    const jlt_status st = told(self, NULL, sqlite3_step(self->piece));
    sqlite3_reset(self->piece);
    return st;
}

jlt_status jlt_database_row(jlt_database *self, char *const *fields)
{
    for (size_t i = 0; i < self->form->count; i++) {
        const int at = (int)i + 1;
        double value;
        if (fields[i][0] == '\0') sqlite3_bind_null(self->row, at);
        else if (self->form->columns[i].is_text) sqlite3_bind_text(self->row, at, fields[i], -1, SQLITE_STATIC);
        else if (jlt_table_number(&value, fields[i], jlt_table_field_end(fields[i]))) sqlite3_bind_double(self->row, at, value);
    }
    const jlt_status st = told(self, NULL, sqlite3_step(self->row));
    sqlite3_reset(self->row);
    return st;
}

static jlt_status make_indexes(const jlt_database *self, char **message)
{
    jlt_status st = JLT_OK;

    for (size_t i = 0; st == JLT_OK && i < self->form->count; i++) {
        const char *name = self->names.columns[i].name;
        if (i >= self->over && !self->form->columns[i].is_text) continue;
        char *text = sqlite3_mprintf("CREATE INDEX \"rows_by_%w\" ON rows (\"%w\")", name, name);
        st = text == NULL ? JLT_ERR_NOMEM : execute(self, message, text);
        sqlite3_free(text);
    }
    return st;
}

jlt_status jlt_database_finish(jlt_database *self, char **message)
{
    jlt_status st;

    *message = NULL;
    JLT_TRY(make_indexes(self, message));
    JLT_TRY(execute(self, message, "COMMIT"));
    sqlite3_finalize(self->row);
    sqlite3_finalize(self->piece);
    self->row = self->piece = NULL;
    JLT_TRY(execute(self, message, "PRAGMA journal_mode = WAL"));
    JLT_TRY(told(self, message, sqlite3_close(self->db)));
    self->db = NULL;
done:
    jlt_database_destroy(self);
    return st;
}

void jlt_database_destroy(jlt_database *self)
{
    if (self == NULL) return;
    sqlite3_finalize(self->row);
    sqlite3_finalize(self->piece);
    sqlite3_close(self->db);
    jlt_table_form_close(&self->names);
    free(self);
}
