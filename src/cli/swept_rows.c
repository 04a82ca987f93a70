#include "cli/swept_rows.h"

#include <math.h>
#include <string.h>

#include "cli/column_map.h"
#include "cli/plot.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "kernel/units.h"
#include "report/csv.h"
#include "report/symbol.h"
#include "report/table.h"

/* The length of the line at the start of the text, without its newline. Out: *next, the line after it, NULL if there is none. */
static size_t line_at(const char *text, const char **next)
{
    const size_t length = strcspn(text, "\n");

    *next = text[length] == '\n' && text[length + 1] != '\0' ? text + length + 1 : NULL;
    return length;
}

static bool has_line(const char *text, const char *line, size_t length)
{
    for (const char *next; text != NULL && *text != '\0'; text = next)
        if (line_at(text, &next) == length && strncmp(text, line, length) == 0) return true;
    return false;
}

/* The comment lines before the column names, and if `with` is not NULL only those that it has too; for the caller to free. */
static char *comments(const char *text, const char *with)
{
    char *found = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&found, &size);

    for (const char *next; stream != NULL && text != NULL && *text == '#'; text = next) {
        const size_t length = line_at(text, &next);
        if (with == NULL || has_line(with, text, length)) fprintf(stream, "%.*s\n", (int)length, text);
    }
    if (stream == NULL || fclose(stream) == 0) return found;
    free(found);
    return NULL;
}

/* A row of the table without its newline, the point's values and the mapped fields; for the caller to free. */
static char *row_of(const jlt_column_map *map, const char *values, const char *row, size_t length)
{
    char *text = NULL, *line, *fields[JLT_COLUMN_MAP_MAX];
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);

    line = strndup(row, length);
    if (stream == NULL || line == NULL) {
        if (stream != NULL) fclose(stream);
        free(text);
        free(line);
        return NULL;
    }
    fprintf(stream, "%s%s", values, map->same ? line : "");
    const unsigned count = map->same ? 0 : jlt_column_map_cut(fields, line);
    for (unsigned i = 0; !map->same && i < map->count; i++)
        fprintf(stream, "%s%s", i > 0 ? "," : "", map->from[i] < count ? fields[map->from[i]] : "");
    free(line);
    if (fclose(stream) == 0) return text;
    free(text);
    return NULL;
}

/* Add a row to the picture's data if both of its columns have numbers. Cuts the row at its commas. */
static void draw_row(jlt_swept_rows *self, char *row)
{
    char *fields[JLT_COLUMN_MAP_MAX], *end;
    const unsigned count = jlt_column_map_cut(fields, row);
    double at[2] = { NAN, NAN };

    for (unsigned k = 0; k < 2; k++) {
        if (self->shown[k] >= count) continue;
        at[k] = strtod(fields[self->shown[k]], &end);
        if (end == fields[self->shown[k]] || *end != '\0') at[k] = NAN;
        self->has_numbers[k] |= isfinite(at[k]);
    }
    if (!isfinite(at[0]) || !isfinite(at[1])) return;
    for (unsigned k = 0; k < 2; k++) {
        if (!self->has_points) self->extent[k] = JLT_EXTENT_NONE;
        jlt_extent_add(&self->extent[k], at[k]);
    }
    self->has_points = true;
    jlt_look_row(self->common->points, at, 2);
}

/* Write the rows of a point, and its comments that are not in the header. names: the line of column names within text. */
static jlt_exit write_rows(jlt_swept_rows *self, size_t point, const char *text, const char *names)
{
    FILE *file = self->common->table.file;
    char values[JLT_GRID_PLACE_MAX] = "", where[JLT_GRID_PLACE_MAX];
    jlt_column_map map;
    JLT_FREED char *own = strndup(names, strcspn(names, "\n"));

    (void)jlt_grid_place(where, self->axes, self->count, point);
    if (own == NULL || !jlt_column_map_make(&map, &self->odd, where, self->names, own)) return jlt_command_no_memory();
    jlt_grid_fields(values, self->axes, self->count, point);
    for (const char *next; text != NULL && *text != '\0'; text = next) {
        const size_t length = line_at(text, &next);
        if (*text == '#' && !has_line(self->header, text, length))
            fprintf(file, "# at %s:%.*s\n", where, (int)length - 1, text + 1);
        if (*text == '#' || text == names) continue;
        char *row = row_of(&map, values, text, length);
        if (row == NULL) return jlt_command_no_memory();
        fprintf(file, "%s\n", row);
        if (self->common->points != NULL) draw_row(self, row);
        free(row);
    }
    fflush(file);
    return JLT_EXIT_DONE;
}

/* Find the picture's columns by --axes, before a second point is computed. */
static jlt_exit choose(jlt_swept_rows *self)
{
    JLT_FREED char *text = strdup(self->names);
    char *columns[JLT_COLUMN_MAP_MAX];
    const char *names[JLT_SWEPT_AXES_MAX + JLT_COLUMN_MAP_MAX];
    unsigned count = 0;
    jlt_exit code = JLT_EXIT_DONE;

    if (text == NULL) return jlt_command_no_memory();
    const unsigned own = jlt_column_map_cut(columns, text);
    for (size_t k = 0; k < self->count; k++) names[count++] = self->axes[k].name;
    self->shown[1] = count + (self->lead < own ? self->lead : own - 1);
    for (unsigned i = 0; i < own; i++) names[count++] = columns[i];
    if (self->common->plot != NULL) code = jlt_plot_shown(self->shown, self->common, names, count);
    return code;
}

/* The line of column names, the first that is not a comment; NULL: there is none. */
static const char *names_in(const char *text)
{
    for (const char *next; text != NULL && *text != '\0'; text = next) {
        (void)line_at(text, &next);
        if (*text != '#') return text;
    }
    return NULL;
}

jlt_exit jlt_swept_rows_finish(jlt_swept_rows *self)
{
    FILE *file = self->common->table.file;
    JLT_FREED char *held = self->held;
    jlt_csv_names names;

    if (held == NULL) return JLT_EXIT_DONE;
    self->held = NULL;
    fputs(self->header, file);
    FILE *line = jlt_csv_names_begin(&names, file);
    for (size_t k = 0; k < self->count; k++) fprintf(line, "%s,", self->axes[k].name);
    fputs(self->names, line);
    jlt_csv_names_end(&names);
    return write_rows(self, self->held_point, held, names_in(held));
}

jlt_exit jlt_swept_rows_take(jlt_swept_rows *self, size_t point, const char *text)
{
    const char *names = names_in(text);

    if (names == NULL) return JLT_EXIT_DONE;
    if (self->names == NULL) {
        self->names = strndup(names, strcspn(names, "\n"));
        self->header = comments(text, NULL);
        self->held = strdup(text);
        self->held_point = point;
        return self->names != NULL && self->header != NULL && self->held != NULL ? choose(self) : jlt_command_no_memory();
    }
    if (self->held != NULL) {
        char *common = comments(self->header, text);
        if (common == NULL) return jlt_command_no_memory();
        free(self->header);
        self->header = common;
        JLT_PASS(jlt_swept_rows_finish(self));
    }
    return write_rows(self, point, text, names);
}

static jlt_exit refuse_picture(const jlt_swept_rows *self, const char *x, const char *y)
{
    if (!self->has_numbers[0] || !self->has_numbers[1])
        return jlt_command_fail(JLT_EXIT_INPUT, "--plot: %s has no number in any row: nothing is drawn",
                                self->has_numbers[0] ? y : x);
    return jlt_command_fail(JLT_EXIT_INPUT, "--plot: no row has numbers of both %s and %s: nothing is drawn", x, y);
}

/* Whether this name is one of the strings that stand before it, one behind the other, from `first` on. */
static bool stands_before(const char *first, const char *name)
{
    for (const char *at = first; at < name; at += strlen(at) + 1)
        if (strcmp(at, name) == 0) return true;
    return false;
}

/* Write the parameters and levels that all points share into the caption: the assignments NAME=VALUE in the header's lines that
 * begin with one, each name once. */
static void caption(jlt_plot *plot, const jlt_swept_rows *self)
{
    JLT_FREED char *text = strdup(self->header != NULL ? self->header : "");
    char *lines = NULL, *words = NULL;

    for (char *line = text == NULL ? NULL : strtok_r(text, "\n", &lines); line != NULL; line = strtok_r(NULL, "\n", &lines)) {
        const char *levels = "# levels ";
        char *start = strncmp(line, levels, strlen(levels)) == 0 ? line + strlen(levels) : line + 2;
        if (strncmp(line, "# ", 2) != 0 || strcspn(start, "=") > strcspn(start, " :{")) continue;
        start[-1] = '\0'; /* what is before is another string */
        for (char *word = strtok_r(start, " ", &words); word != NULL; word = strtok_r(NULL, " ", &words)) {
            char *equals = strchr(word, '=');
            if (equals == NULL) break;
            *equals = '\0';
            if (!stands_before(text, word)) jlt_plot_value(plot, word, strtod(equals + 1, NULL));
        }
    }
}

/* The label of a column, as jlt_plot_label; columns of commands have the units that the commands' own pictures give. */
static void column_label(char *label, const jlt_swept_rows *self, const char *name)
{
    static const char *const units[][2] = { { "t", "s" }, { "T", "s" }, { "time", "s" }, { "divergence", "1/s" } };
    const char *digits = strncmp(name, "lambda", 6) == 0 ? name + 6 : "";
    size_t index;

    jlt_plot_label(label, self->model, name);
    if (jlt_descriptor_param(self->model, name, &index) || jlt_descriptor_state(self->model, name, &index)) return;
    if (!jlt_units_has_time(self->model)) return;
    if (*digits != '\0' && digits[strspn(digits, "0123456789")] == '\0') jlt_look_label(label, name, "1/s");
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(name, units[i][0]) == 0) jlt_look_label(label, name, units[i][1]);
}

jlt_exit jlt_swept_rows_draw(const jlt_swept_rows *self)
{
    char label[JLT_LOOK_LABEL_MAX], *text = strdup(self->names), *columns[JLT_COLUMN_MAP_MAX];
    const char *names[2];
    jlt_plot plot;

    if (text == NULL) return jlt_command_no_memory();
    (void)jlt_column_map_cut(columns, text);
    for (unsigned k = 0; k < 2; k++)
        names[k] = self->shown[k] < self->count ? self->axes[self->shown[k]].name : columns[self->shown[k] - self->count];
    if (!self->has_points || jlt_plot_open(&plot, self->common) != JLT_OK) {
        const jlt_exit code = self->has_points ? jlt_command_no_memory() : refuse_picture(self, names[0], names[1]);
        free(text);
        return code;
    }
    jlt_plot_block(&plot, "POINTS", self->common->drawn);
    jlt_plot_words(&plot, "%s: jellett %s at each ", self->model->model, self->what);
    for (size_t i = 0; i < self->count; i++) {
        if (i > 0) jlt_plot_words(&plot, ", ");
        jlt_symbol_write(plot.title.stream, self->axes[i].name);
    }
    jlt_plot_words(&plot, "\n");
    caption(&plot, self);
    for (unsigned k = 0; k < 2; k++) {
        column_label(label, self, names[k]);
        jlt_plot_axis(&plot, k == 0 ? 'x' : 'y', label, jlt_extent_wider(self->extent[k]), 0);
    }
    fputs(JLT_LOOK_GRID "plot $POINTS using 1:2 ", plot.stream);
    jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "points", .colour = 0, .size = 0.3 });
    fputs(" notitle\n", plot.stream);
    free(text);
    return jlt_plot_draw(&plot);
}

void jlt_swept_rows_clear(jlt_swept_rows *self)
{
    free(self->header);
    free(self->names);
    free(self->held);
    free(self->odd);
}
