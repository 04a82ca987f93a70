/* `jellett merge`: makes one table of what the shards of a study have computed. */
#include <argp.h>
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/options.h"
#include "base/text.h"
#include "cli/column_map.h"
#include "cli/merged.h"
#include "cli/study.h"
#include "core/memory.h"
#include "report/file.h"
#include "report/json.h"
#include "shards/gather.h"

enum { OUTPUTS_MAX = 4, COLUMNS_MAX = JLT_COLUMN_MAP_MAX };

typedef struct {
    const char **places; /* files and folders, as typed */
    size_t place_count;
    const char *outputs[OUTPUTS_MAX];
    size_t output_count;
} options;

static const struct argp_option option_table[] = {
    { "output", 'o', "FILE", TTC_OPTIONS_REPEATED,
      "Write FILE.csv, FILE.npy (a structured array for numpy.load) or FILE.sqlite; may be repeated; default CSV on "
      "standard output", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case 'o':
        if (!jlt_merged_known(value)) argp_error(state, "--output: '%s' is no .csv, .npy or .sqlite", value);
        if (o->output_count == OUTPUTS_MAX) argp_error(state, "--output: %d files at most", OUTPUTS_MAX);
        o->outputs[o->output_count++] = value;
        return 0;
    case ARGP_KEY_ARG: o->places[o->place_count++] = value; return 0;
    case ARGP_KEY_NO_ARGS: argp_error(state, "which folder?"); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "FOLDER|FILE...",
    "Make one table of what the shards of a study have computed: its rows, as the command of the study prints them, behind columns "
    "with the values that the study varies."
    "\vRows are in the order of the study, and the same, byte for byte, however many shards there were and however often they "
    "were begun again. Every record is checked. Nothing is written, and the status is 1 or 3, where pieces are missing, or "
    "files belong to different studies, or differ about one piece. Files of shards that are still computing may be read at any "
    "time.\n\n"
    "A file of SQLite has three tables. rows has an index on every column that the study varies and on every column of text; "
    "pieces has how each piece ended, and the messages of its command; provenance has what computed the rows.\n\n"
    "Examples:\n"
    "  jellett merge study.shards > study.csv\n"
    "  jellett merge study.shards -o study.csv -o study.npy -o study.sqlite",
    NULL, NULL, NULL,
};

typedef struct {
    const options *o;
    jlt_gather *gather;
    json_t *study;
    jlt_grid_axis over[JLT_STUDY_OVER_MAX];
    size_t over_count, outer;
    jlt_table_form form;
    char *names;  /* the line that begins the first piece's rows; owned */
    char *here;   /* that of the first piece at the present value of what the study runs over; NULL: none has come; owned */
    size_t named; /* that piece */
    char *odd;    /* the line of the last piece with other columns than `names`; owned */
    jlt_merged outputs[OUTPUTS_MAX];
    size_t output_count;
    bool counts; /* the first column of the command's rows is the number of an orbit */
    size_t base; /* number of the piece's first orbit in the command's grid */
    size_t failed, first_failed, checked; /* pieces with a status other than 0 and 1; the first of them; pieces of status 1 */
} merge;

/* ---- files ---- */

typedef struct {
    char **paths; /* shape (count,) */
    size_t count;
} file_list;

static jlt_exit add_file(file_list *files, char *path)
{
    if (path == NULL || !JLT_MEMORY_GROW(files->paths, files->count)) {
        free(path);
        return jlt_command_no_memory();
    }
    files->paths[files->count++] = path;
    return JLT_EXIT_DONE;
}

static int is_shard(const struct dirent *entry)
{
    const char *dot = strrchr(entry->d_name, '.');

    return entry->d_name[0] != '.' && dot != NULL && strcmp(dot, ".shard") == 0;
}

static jlt_exit add_folder(file_list *files, const char *folder)
{
    struct dirent **entries;
    const int count = scandir(folder, &entries, is_shard, alphasort);
    jlt_exit code = JLT_EXIT_DONE;

    if (count < 0) return jlt_command_fail(JLT_EXIT_IO, "%s: %s", folder, strerror(errno));
    if (count == 0) code = jlt_command_fail(JLT_EXIT_INPUT, "%s: there are no files *.shard", folder);
    for (int i = 0; i < count; i++) {
        char *path = NULL;
        if (code == JLT_EXIT_DONE) code = add_file(files, asprintf(&path, "%s/%s", folder, entries[i]->d_name) < 0 ? NULL : path);
        free(entries[i]);
    }
    free(entries);
    return code;
}

static jlt_exit find_files(file_list *files, const options *o)
{
    struct stat about;
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t i = 0; code == JLT_EXIT_DONE && i < o->place_count; i++) {
        if (stat(o->places[i], &about) != 0) return jlt_command_fail(JLT_EXIT_IO, "%s: %s", o->places[i], strerror(errno));
        code = S_ISDIR(about.st_mode) ? add_folder(files, o->places[i]) : add_file(files, strdup(o->places[i]));
    }
    return code;
}

static jlt_exit open_gather(merge *self, const file_list *files)
{
    JLT_FREED char *message = NULL;
    size_t first = 0;
    const jlt_status st = jlt_gather_open(&self->gather, &message, (const char *const *)files->paths, files->count);

    if (message != NULL && *message != '\0') fprintf(stderr, "jellett: %s", message);
    if (st == JLT_ERR_EMPTY)
        return jlt_command_fail(JLT_EXIT_FAILED, "no file holds a study yet: run jellett sweep STUDY.scene first");
    if (st == JLT_ERR_NOMEM) return jlt_command_no_memory();
    if (st != JLT_OK) return jlt_command_exit(st);
    const size_t missing = jlt_gather_missing(self->gather, &first);
    if (missing == 0) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_FAILED, "%zu of %zu pieces are missing, the first of them number %zu: jellett sweep --resume "
                                             "computes them",
                            missing, jlt_gather_pieces(self->gather), first);
}

static jlt_exit read_study(merge *self)
{
    const char *over, *command;
    jlt_exit code = JLT_EXIT_DONE;

    self->study = json_loads(jlt_gather_study(self->gather), 0, NULL);
    over = json_string_value(json_object_get(self->study, "over"));
    command = json_string_value(json_object_get(self->study, "command"));
    self->counts = command != NULL && strcmp(command, "section") == 0;
    if (over != NULL) code = jlt_grid_parse(self->over, &self->over_count, JLT_STUDY_OVER_MAX, over, "over");
    return code == JLT_EXIT_DONE ? jlt_grid_size(&self->outer, self->over, self->over_count, over, "over") : code;
}

/* ---- rows ---- */

/* Set the columns: what the study runs over, then the column names of the first piece with rows. */
static jlt_exit begin_form(merge *self, const char *line)
{
    char *names[COLUMNS_MAX + JLT_STUDY_OVER_MAX], *copy = strdup(line);
    jlt_status st;

    self->names = strdup(line);
    if (copy == NULL || self->names == NULL) {
        free(copy);
        return jlt_command_no_memory();
    }
    for (size_t k = 0; k < self->over_count; k++) names[k] = self->over[k].name;
    const size_t count = jlt_table_cut(names + self->over_count, COLUMNS_MAX, copy);
    st = count > COLUMNS_MAX ? JLT_ERR_ARG : jlt_table_form_open(&self->form, names, self->over_count + count, strcmp);
    free(copy);
    if (st == JLT_ERR_NOMEM) return jlt_command_no_memory();
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_command_fail(JLT_EXIT_INPUT, "there are more than %d columns", COLUMNS_MAX);
}

/* Refuse a piece whose columns, or else the `count` fields of a row of it, are not those of its command's other pieces. */
static jlt_exit bad_piece(const merge *self, size_t piece, const char *columns, size_t count)
{
    const char *path = jlt_gather_path(self->gather, piece);

    if (strcmp(columns, self->here) == 0)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: a row of piece %zu has %zu fields for the columns %s: remove the file, and "
                                "run jellett sweep --resume", path, piece, count, columns);
    jlt_command_fail(JLT_EXIT_INPUT, "%s: piece %zu has the columns %s", path, piece, columns);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s: piece %zu has the columns %s: remove the file with the wrong ones, and run "
                            "jellett sweep --resume", jlt_gather_path(self->gather, self->named), self->named, self->here);
}

/* Take a row: the first pass learns the kinds of columns from it, the second writes it. */
static jlt_exit take_row(merge *self, char *const *fields, bool is_second)
{
    if (!is_second) jlt_table_form_see(&self->form, fields);
    for (size_t k = 0; is_second && k < self->output_count; k++)
        if (!jlt_merged_row(&self->outputs[k], &self->form, fields)) return jlt_command_cannot_write(self->outputs[k].path);
    return JLT_EXIT_DONE;
}

/* Replace the number of an orbit within its piece by that within the command's whole grid. */
static void renumber(const merge *self, char **field, char number[24], size_t *next)
{
    const size_t orbit = self->base + strtoull(*field, NULL, 10);

    snprintf(number, 24, "%zu", orbit);
    *field = number;
    *next = orbit + 1;
}

/* Take the rows of a piece. text: its lines, and over: the values that the study runs over; both are cut into fields. */
static jlt_exit take_rows(merge *self, char *text, char *over, size_t piece, bool is_second)
{
    char *fields[COLUMNS_MAX], *row[COLUMNS_MAX + JLT_STUDY_OVER_MAX], number[24], place[JLT_GRID_PLACE_MAX], none[] = "";
    const char *columns = strsep(&text, "\n");
    const size_t before = self->over_count;
    size_t next = self->base;
    jlt_column_map map;
    jlt_exit code = self->names == NULL ? begin_form(self, columns) : JLT_EXIT_DONE;

    (void)jlt_grid_place(place, self->over, before, piece / (jlt_gather_pieces(self->gather) / self->outer));
    if (code != JLT_EXIT_DONE) return code;
    if (self->here == NULL) {
        self->named = piece;
        self->here = strdup(columns);
        if (self->here == NULL) return jlt_command_no_memory();
    }
    if (strcmp(columns, self->here) != 0) return bad_piece(self, piece, columns, 0);
    if (!jlt_column_map_make(&map, &self->odd, place, self->names, columns)) return jlt_command_no_memory();
    if (before > 0) (void)jlt_table_cut(row, before, over);
    for (char *line; code == JLT_EXIT_DONE && (line = strsep(&text, "\n")) != NULL && *line != '\0';) {
        const size_t count = jlt_table_cut(fields, COLUMNS_MAX, line);
        if (count != map.own) return bad_piece(self, piece, columns, count);
        if (self->counts) renumber(self, &fields[0], number, &next);
        for (unsigned i = 0; i < map.count; i++) row[before + i] = map.from[i] < count ? fields[map.from[i]] : none;
        code = take_row(self, row, is_second);
    }
    self->base = next;
    return code;
}

static void note(merge *self, const jlt_shard_record *record)
{
    if (record->status == JLT_EXIT_FAILED) self->checked++;
    else if (record->status != JLT_EXIT_DONE && self->failed++ == 0) self->first_failed = record->piece;
}

static jlt_exit pass(merge *self, bool is_second)
{
    const size_t pieces = jlt_gather_pieces(self->gather), each = pieces / self->outer;
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t i = 0; code == JLT_EXIT_DONE && i < pieces; i++) {
        char over[JLT_GRID_PLACE_MAX], *text;
        jlt_shard_record record;
        const jlt_status st = jlt_gather_piece(self->gather, &record, i);
        if (st != JLT_OK) return jlt_command_fail(jlt_command_exit(st), "piece %zu cannot be read again: %s", i,
                                                  jlt_status_text(st));
        if (i % each == 0) {
            self->base = 0;
            free(self->here);
            self->here = NULL;
        }
        for (size_t k = 0; is_second && k < self->output_count; k++)
            if (!jlt_merged_piece(&self->outputs[k], &record)) return jlt_command_cannot_write(self->outputs[k].path);
        if (!is_second) note(self, &record);
        if (record.rows_size == 0) continue;
        jlt_grid_fields(over, self->over, self->over_count, i / each);
        text = strndup(record.rows, record.rows_size);
        if (text == NULL) return jlt_command_no_memory();
        code = take_rows(self, text, over, i, is_second);
        free(text);
    }
    return code;
}

/* ---- outputs ---- */

/* The comment lines of CSV and NumPy files: the command, what the study runs over, and the study in JSON; for free(). */
static char *make_header(const merge *self)
{
    const char *name, *over = json_string_value(json_object_get(self->study, "over"));
    char *text = NULL;
    size_t size = 0;
    json_t *value;
    FILE *stream = open_memstream(&text, &size);

    if (stream == NULL) return NULL;
    fprintf(stream, "# jellett " JLT_VERSION " merge, rows of: jellett %s %s",
            json_string_value(json_object_get(self->study, "command")), json_string_value(json_object_get(self->study, "model")));
    json_object_foreach(json_object_get(self->study, "options"), name, value) {
        const char *said = json_string_value(value);
        fprintf(stream, " --%s%s%s", name, said != NULL ? "=" : "", said != NULL ? said : "");
    }
    if (over != NULL) fprintf(stream, "\n# over %s", over);
    fprintf(stream, "\n# %s\n", jlt_gather_study(self->gather));
    if (fclose(stream) == 0) return text;
    free(text);
    return NULL;
}

static jlt_exit write_all(merge *self)
{
    const char *standard[] = { "-" }, *const *paths = self->o->output_count > 0 ? self->o->outputs : standard;
    const size_t count = self->o->output_count > 0 ? self->o->output_count : 1;
    JLT_FREED char *header = make_header(self);
    jlt_exit code = header != NULL ? JLT_EXIT_DONE : jlt_command_no_memory();

    for (size_t k = 0; code == JLT_EXIT_DONE && k < count; k++) {
        code = jlt_merged_open(&self->outputs[k], paths[k], &self->form, self->over_count, jlt_gather_study(self->gather), header);
        self->output_count++;
    }
    if (code == JLT_EXIT_DONE) code = pass(self, true);
    for (size_t k = 0; code == JLT_EXIT_DONE && k < self->output_count; k++) code = jlt_merged_close(&self->outputs[k]);
    for (size_t k = 0; k < self->output_count; k++) jlt_merged_discard(&self->outputs[k]);
    return code;
}

static jlt_exit merge_files(merge *self, const file_list *files)
{
    JLT_PASS(open_gather(self, files));
    JLT_PASS(read_study(self));
    JLT_PASS(pass(self, false));
    if (self->names == NULL) return jlt_command_fail(JLT_EXIT_INPUT, "no piece has rows: jellett sweep says why");
    JLT_PASS(write_all(self));
    if (self->failed > 0)
        fprintf(stderr, "jellett: %zu of %zu pieces ended with another status than 0, the first of them number %zu: their rows "
                        "tell, and table pieces of SQLite\n", self->failed, jlt_gather_pieces(self->gather), self->first_failed);
    if (self->checked == 0) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_FAILED, "the checks of %zu piece%s failed", self->checked, ttc_text_plural(self->checked));
}

static jlt_exit check_outputs(const options *o)
{
    jlt_command_file files[OUTPUTS_MAX];
    jlt_exit code;

    for (size_t i = 0; i < o->output_count; i++) files[i] = (jlt_command_file){ "--output", o->outputs[i] };
    code = jlt_command_distinct(files, o->output_count);
    for (size_t i = 0; code == JLT_EXIT_DONE && i < o->output_count; i++) code = jlt_command_check_output(o->outputs[i]);
    return code;
}

/* No shard is written over. */
static jlt_exit check_inputs(const options *o, const file_list *files)
{
    for (size_t i = 0; i < o->output_count; i++)
        for (size_t k = 0; k < files->count; k++)
            if (jlt_file_same(o->outputs[i], files->paths[k]))
                return jlt_command_fail(JLT_EXIT_USAGE, "--output: %s is a shard that is merged: name another file", o->outputs[i]);
    return JLT_EXIT_DONE;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .places = calloc((size_t)argc + 1, sizeof *o.places) };
    merge self = { .o = &o, .outer = 1 };
    file_list files = { .count = 0 };
    jlt_exit code;

    if (o.places == NULL) return jlt_command_no_memory();
    ttc_options_parse(&parser, argc, argv, &o);
    code = check_outputs(&o);
    if (code == JLT_EXIT_DONE) code = find_files(&files, &o);
    if (code == JLT_EXIT_DONE) code = check_inputs(&o, &files);
    if (code == JLT_EXIT_DONE) code = merge_files(&self, &files);
    jlt_gather_destroy(self.gather);
    jlt_table_form_close(&self.form);
    json_decref(self.study);
    for (size_t i = 0; i < files.count; i++) free(files.paths[i]);
    free(files.paths);
    free(self.names);
    free(self.here);
    free(self.odd);
    free(o.places);
    return code;
}

const jlt_command jlt_command_merge = {
    "merge", "FOLDER|FILE... [-o FILE]", "Make one table of what the shards of a study have computed", run, NULL, NULL
};
