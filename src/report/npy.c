#include "report/npy.h"

#include "core/digits.h"
#include "core/memory.h"
#include "report/bits.h"
#include "report/table.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { ALIGNMENT = 64, NUMBER = sizeof(uint64_t), BLOCK = 1 << 20 };

struct jlt_npy {
    jlt_file *place;
    FILE *notes;          /* collects comments into the file's tail */
    jlt_table_form form;  /* its `rows` counts the rows in the file */
    size_t head, width;   /* bytes before the rows; bytes of a row */
    char *begun;          /* a line whose end has not come yet */
    size_t begun_size, begun_room;
    char *block;          /* rows that are not in the file yet, `held` bytes of BLOCK */
    size_t held;
    jlt_status failed;    /* how jlt_npy_take failed; it takes nothing after that */
};

static size_t width_of(const jlt_table_column *column) { return column->is_text ? column->width : NUMBER; }

static void put_number(char *to, uint64_t value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++) to[i] = (char)(value >> 8 * i & 0xff);
}

/* Put a double as the eight bytes of <f8, by one instruction where the processor has them in that order. */
static inline void put_double(char *to, double value)
{
    uint64_t bits;

    memcpy(&bits, &value, sizeof bits);
    if (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__) bits = __builtin_bswap64(bits);
    memcpy(to, &bits, sizeof bits);
}

/* Make the header's Python dictionary for an array of this many rows. */
static jlt_status describe(char **text, size_t *size, const jlt_table_form *form, size_t rows)
{
    FILE *stream = open_memstream(text, size);

    if (stream == NULL) return JLT_ERR_NOMEM;
    fputs("{'descr': [", stream);
    for (size_t i = 0; i < form->count; i++) {
        const jlt_table_column *column = &form->columns[i];
        fprintf(stream, "%s('%s', '", i > 0 ? ", " : "", column->name);
        if (column->is_text) fprintf(stream, "|S%zu", column->width);
        else fputs("<f8", stream);
        fputs("')", stream);
    }
    fprintf(stream, "], 'fortran_order': False, 'shape': (%zu,), }", rows);
    return fclose(stream) == 0 ? JLT_OK : JLT_ERR_NOMEM;
}

/* Set the width of a row, and the size of the header so that it has room for any number of rows. */
static jlt_status measure(jlt_npy *self)
{
    JLT_FREED char *text = NULL;
    size_t size = 0;

    JLT_PASS(describe(&text, &size, &self->form, SIZE_MAX));
    self->width = 0;
    for (size_t i = 0; i < self->form.count; i++) self->width += width_of(&self->form.columns[i]);
    self->head = (12 + size + 1 + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    return self->width <= BLOCK / 2 ? JLT_OK : JLT_ERR_ARG;
}

static jlt_status write_head(jlt_npy *self)
{
    JLT_FREED char *text = NULL, *head = malloc(self->head);
    size_t size = 0;
    const unsigned version = self->head - 10 <= UINT16_MAX ? 1 : 2, lead = version == 1 ? 10 : 12;

    if (head == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(describe(&text, &size, &self->form, self->form.rows));
    memset(head, ' ', self->head);
    memcpy(head, "\x93NUMPY", 6);
    head[6] = (char)version;
    head[7] = 0;
    put_number(head + 8, self->head - lead, lead - 8);
    memcpy(head + lead, text, size);
    head[self->head - 1] = '\n';
    return jlt_file_put(self->place, head, self->head, 0);
}

jlt_status jlt_npy_create(jlt_npy **out, jlt_file *place)
{
    jlt_npy *self;

    *out = NULL;
    if (place->temporary == NULL) return JLT_ERR_UNSUPPORTED;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->place = place;
    self->block = malloc(BLOCK);
    self->notes = open_memstream(&place->tail, &place->tail_size);
    if (self->block == NULL || self->notes == NULL) {
        jlt_npy_destroy(self);
        return JLT_ERR_NOMEM;
    }
    *out = self;
    return JLT_OK;
}

void jlt_npy_destroy(jlt_npy *self)
{
    if (self == NULL) return;
    if (self->notes != NULL) fclose(self->notes);
    free(self->place->tail);
    self->place->tail = NULL;
    jlt_table_form_close(&self->form);
    free(self->begun);
    free(self->block);
    free(self);
}

/* Move the rows that are held to the file; on a full disk as many as fit, in ever smaller pieces. errno says why not all. */
static jlt_status put_rows(jlt_npy *self)
{
    const char *from = self->block;
    int reason = 0;

    for (size_t left = self->held / self->width, piece = left; piece > 0; piece = piece < left ? piece : left) {
        if (jlt_file_put(self->place, from, piece * self->width, self->head + self->form.rows * self->width) != JLT_OK) {
            reason = errno;
            piece /= 2;
            continue;
        }
        from += piece * self->width;
        left -= piece;
        self->form.rows += piece;
    }
    self->held = 0;
    errno = reason;
    return reason == 0 ? JLT_OK : JLT_ERR_IO;
}

/* Write the rows first, then the header, so that the header never counts a row that is not in the file. */
static jlt_status flush(jlt_npy *self)
{
    if (self->form.count == 0) return JLT_ERR_ARG; /* there is no table */
    if (fflush(self->notes) != 0) return JLT_ERR_NOMEM;
    const jlt_status st = put_rows(self);
    const int reason = errno;
    JLT_PASS(write_head(self));
    self->place->head = self->head;
    self->place->whole = self->head + self->form.rows * self->width;
    errno = reason;
    return st;
}

/* Write a field's old bytes, a text of another width or a number, as text of this width. */
static void put_text(char *to, size_t width, const char *from, bool was_text, size_t was_width)
{
    char text[JLT_DIGITS_SIZE] = "";
    uint64_t bits = 0;
    double value;

    memset(to, 0, width);
    if (was_text) {
        memcpy(to, from, was_width);
        return;
    }
    for (unsigned i = 0; i < sizeof bits; i++) bits |= (uint64_t)(unsigned char)from[i] << 8 * i;
    memcpy(&value, &bits, sizeof value);
    if (!isnan(value)) jlt_digits_shortest(text, value);
    memcpy(to, text, strlen(text));
}

/* Make a column one of texts at least `width` bytes long. Rows do not become shorter, so moving the last row first overwrites no
 * other. If a row cannot be moved, the rows that moved ones have not overwritten are kept as they were. */
static jlt_status widen(jlt_npy *self, size_t index, size_t width)
{
    jlt_table_column *column = &self->form.columns[index];
    const jlt_table_column was = *column;
    const size_t was_head = self->head, was_row = self->width, was_width = width_of(column);
    size_t before = 0;
    jlt_status st = JLT_OK;
    int reason = 0;

    JLT_PASS(flush(self));
    for (size_t i = 0; i < index; i++) before += width_of(&self->form.columns[i]);
    column->width = (width + NUMBER - 1) / NUMBER * NUMBER;
    if (!was.is_text && self->form.rows > 0 && column->width < JLT_DIGITS_SIZE) column->width = JLT_DIGITS_SIZE;
    column->is_text = true;
    JLT_PASS(measure(self));
    self->place->whole = 0;
    char *const from = self->block, *const to = self->block + BLOCK / 2; /* both free: all rows are in the file */
    for (size_t i = self->form.rows; st == JLT_OK && i-- > 0;) {
        const size_t at = self->head + i * self->width;
        JLT_PASS(jlt_file_get(self->place, from, was_row, was_head + i * was_row));
        memcpy(to, from, before);
        put_text(to + before, column->width, from + before, was.is_text, was_width);
        memcpy(to + before + column->width, from + before + was_width, was_row - before - was_width);
        st = jlt_file_put(self->place, to, self->width, at);
        if (st == JLT_OK) continue;
        reason = errno;
        *column = was;
        if ((at - was_head) / was_row < self->form.rows) self->form.rows = (at - was_head) / was_row;
        JLT_PASS(measure(self));
    }
    JLT_PASS(flush(self));
    errno = reason;
    return st;
}

/* Returns 0, or the width that the column needs where it holds numbers and the field is a text, or the field is too long for it. */
static size_t put_field(char *to, const jlt_table_column *column, const char *field, const char *end)
{
    char digits[JLT_DIGITS_SIZE];
    double value;

    if (jlt_bits_are_at(field, end)) {
        value = jlt_bits_read(field);
        if (column->is_text) end = jlt_digits_shortest(digits, value), field = digits;
    } else if (!column->is_text && !jlt_table_number(&value, field, end)) return (size_t)(end - field);
    if (column->is_text) {
        const size_t size = (size_t)(end - field);
        if (size > column->width) return size;
        memset(to, 0, column->width);
        memcpy(to, field, size);
        return 0;
    }
    put_double(to, value);
    return 0;
}

/* Add a row to the block from the line of CSV that ends at `stop`. When a field does not fit its column, widen the column and begin
 * the row again. */
static jlt_status put_row(jlt_npy *self, const char *line, const char *stop)
{
    const char *field = line;
    char *to;

    if (self->held + self->width > BLOCK) JLT_PASS(flush(self));
    to = self->block + self->held;
    for (size_t i = 0; i < self->form.count; i++) {
        const jlt_table_column *column = &self->form.columns[i];
        const char *end = jlt_bits_are_at(field, stop) ? field + JLT_BITS_SIZE : jlt_table_field_end(field);
        if ((*end == ',') != (i + 1 < self->form.count)) return JLT_ERR_ARG;
        const size_t width = put_field(to, column, field, end);
        if (width > 0) {
            JLT_PASS(widen(self, i, width));
            return put_row(self, line, stop);
        }
        to += width_of(column);
        field = end + 1;
    }
    self->held += self->width;
    return JLT_OK;
}

/* Take the line of column names. All columns hold numbers until a field is a text. */
static jlt_status take_names(jlt_npy *self, char *line)
{
    const size_t count = jlt_table_cut(NULL, 0, line);
    JLT_FREED char **names = calloc(count, sizeof *names);

    if (names == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < count; i++, line += strlen(line) + 1) names[i] = line;
    JLT_PASS(jlt_table_form_open(&self->form, names, count, strcmp));
    return measure(self);
}

static jlt_status take_line(jlt_npy *self, char *line, const char *stop)
{
    if (*line == '#') return fprintf(self->notes, "%s\n", line) >= 0 ? JLT_OK : JLT_ERR_NOMEM;
    if (self->form.count == 0) return take_names(self, line);
    return put_row(self, line, stop);
}

jlt_status jlt_npy_take(jlt_npy *self, const char *text, size_t size)
{
    char *line, *end;
    jlt_status st = self->failed;

    if (st != JLT_OK) return st;
    if (self->begun_size + size > self->begun_room) {
        char *more = realloc(self->begun, self->begun_size + size);
        if (more == NULL) return JLT_ERR_NOMEM;
        self->begun = more;
        self->begun_room = self->begun_size + size;
    }
    memcpy(self->begun + self->begun_size, text, size);
    self->begun_size += size;
    for (line = self->begun; (end = memchr(line, '\n', self->begun_size - (size_t)(line - self->begun))) != NULL; line = end + 1) {
        *end = '\0';
        JLT_TRY(take_line(self, line, end));
    }
    self->begun_size -= (size_t)(line - self->begun);
    memmove(self->begun, line, self->begun_size);
    if (self->form.count > 0) st = flush(self);
done:
    if (st == JLT_ERR_ARG) self->place->whole = 0; /* not a table: committing fails, so that no other file is replaced */
    self->failed = st;
    return st;
}
