#include "cli/writer.h"

#include <stdlib.h>
#include <string.h>

/* Rows that a thread formats at a time. */
enum { PIECE = 64 };

jlt_status jlt_writer_open(jlt_writer *self, FILE *stream, jlt_writer_text text, void *context, size_t width, size_t room,
                           unsigned threads)
{
    *self = (jlt_writer){ .stream = stream, .text = text, .context = context, .width = width, .room = room, .threads = threads };
    self->rows = calloc(room, width);
    return self->rows != NULL ? JLT_OK : JLT_ERR_NOMEM;
}

void jlt_writer_close(jlt_writer *self)
{
    free(self->rows);
    self->rows = NULL;
}

typedef struct {
    char *text; /* NULL: memory is out */
    size_t size;
} piece;

static piece write_piece(const jlt_writer *self, size_t first)
{
    const size_t end = first + PIECE < self->count ? first + PIECE : self->count;
    piece out = { NULL, 0 };
    FILE *stream = open_memstream(&out.text, &out.size);

    if (stream == NULL) return (piece){ NULL, 0 };
    for (size_t i = first; i < end; i++) self->text(stream, self->context, self->rows + i * self->width);
    if (fclose(stream) == 0) return out;
    free(out.text);
    return (piece){ NULL, 0 };
}

jlt_status jlt_writer_flush(jlt_writer *self)
{
    piece *pieces;
    jlt_status st = JLT_OK;

    if (self->count > 0 && self->complete != NULL) JLT_PASS(self->complete(self->context, self->rows, &self->count));
    const size_t count = (self->count + PIECE - 1) / PIECE;
    if (count == 0) return ferror(self->stream) ? JLT_ERR_IO : JLT_OK;
    pieces = calloc(count, sizeof *pieces);
    if (pieces == NULL) return JLT_ERR_NOMEM;
#if defined(_OPENMP)
#pragma omp parallel for schedule(dynamic) num_threads(count < self->threads ? (int)count : (int)self->threads)
#endif
    for (size_t i = 0; i < count; i++) pieces[i] = write_piece(self, i * PIECE);
    for (size_t i = 0; i < count; i++) {
        if (pieces[i].text == NULL) st = JLT_ERR_NOMEM;
        if (st == JLT_OK) fwrite(pieces[i].text, 1, pieces[i].size, self->stream);
        free(pieces[i].text);
    }
    free(pieces);
    self->count = 0;
    if (st == JLT_OK && ferror(self->stream)) st = JLT_ERR_IO;
    return st;
}

jlt_status jlt_writer_put(jlt_writer *self, const void *row)
{
    memcpy(self->rows + self->count++ * self->width, row, self->width);
    if (self->room == 1) {
        size_t count = 1;
        self->count = 0;
        if (self->complete != NULL) JLT_PASS(self->complete(self->context, self->rows, &count));
        if (count > 0) self->text(self->stream, self->context, self->rows);
        return ferror(self->stream) ? JLT_ERR_IO : JLT_OK;
    }
    return self->count == self->room ? jlt_writer_flush(self) : JLT_OK;
}
