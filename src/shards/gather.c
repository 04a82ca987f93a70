#include "shards/gather.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

#include "report/json.h"
#include "shards/manifest.h"

typedef struct {
    size_t file; /* 1 + its index; 0: the piece is missing */
    off_t at;
    size_t size;
    unsigned long sum; /* CRC-32 of rows_size, status and bytes, by which copies of a piece in two files are compared */
} place;

struct jlt_gather {
    const char *const *paths;
    jlt_shard_reader *readers; /* shape (count,) */
    size_t count, pieces;
    place *places; /* shape (pieces,) */
    char *study;
};

/* Raise the limit of open descriptors: all files stay open while pieces are read in the order of the study. */
static void allow_descriptors(size_t count)
{
    struct rlimit limit;

    if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= count + 64) return;
    limit.rlim_cur = limit.rlim_max < count + 64 ? limit.rlim_max : count + 64;
    (void)!setrlimit(RLIMIT_NOFILE, &limit);
}

/* Take the study of the first file, or check that a later file has the same one. Takes ownership of `study`. */
static jlt_status take_study(jlt_gather *self, FILE *words, char *study, const char *path)
{
    jlt_status st = JLT_OK;

    if (self->study == NULL) {
        json_t *json = json_loads(study, 0, NULL);
        const json_int_t pieces = json_integer_value(json_object_get(json, "pieces"));
        json_decref(json);
        self->study = study;
        self->pieces = pieces > 0 && (uint64_t)pieces < SIZE_MAX / sizeof *self->places ? (size_t)pieces : 0;
        self->places = calloc(self->pieces + 1, sizeof *self->places);
        if (self->places == NULL) return JLT_ERR_NOMEM;
        if (self->pieces > 0) return JLT_OK;
        fprintf(words, "%s: it does not say how many pieces its study has\n", path);
        return JLT_ERR_ARG;
    }
    if (strcmp(self->study, study) != 0) {
        fprintf(words, "%s is of another study than the files before it, which are 'there':\n", path);
        (void)jlt_manifest_difference(words, self->study, study);
        st = JLT_ERR_ARG;
    }
    free(study);
    return st;
}

/* The place of a record, at offset `at` of file number `file`. */
static place place_of(size_t file, off_t at, const jlt_shard_record *record)
{
    const unsigned char status = (unsigned char)record->status;
    const size_t size = record->rows_size + record->words_size;

    return (place){ file + 1, at, size,
                    crc32_z(crc32_z(record->rows_size % 0xffffffff, &status, 1), (const unsigned char *)record->rows, size) };
}

static bool is_alike(const place *a, const place *b) { return a->size == b->size && a->sum == b->sum; }

static jlt_status take_record(jlt_gather *self, FILE *words, size_t file, off_t at, const jlt_shard_record *record)
{
    const place here = place_of(file, at, record);
    place *before;

    if (record->piece >= self->pieces) {
        fprintf(words, "%s: there is no piece %zu\n", self->paths[file], record->piece);
        return JLT_ERR_ARG;
    }
    before = &self->places[record->piece];
    if (before->file == 0) *before = here;
    else if (!is_alike(before, &here)) {
        fprintf(words, "%s and %s: piece %zu differs: were they computed by one program, on processors of one kind?\n",
                self->paths[before->file - 1], self->paths[file], record->piece);
        return JLT_ERR_ARG;
    }
    return JLT_OK;
}

static jlt_status take_file(jlt_gather *self, FILE *words, size_t file)
{
    jlt_shard_reader *reader = &self->readers[file];
    jlt_shard_record record;
    char *study = NULL;
    const int descriptor = open(self->paths[file], O_RDONLY | O_CLOEXEC);
    jlt_status st;

    if (descriptor < 0) {
        fprintf(words, "%s: %s\n", self->paths[file], strerror(errno));
        return JLT_ERR_IO;
    }
    st = jlt_shard_reader_open(reader, &study, descriptor);
    if (st == JLT_ERR_ARG) fprintf(words, "%s is no shard of a study, or its beginning is damaged\n", self->paths[file]);
    if (st == JLT_ERR_ARG) free(study);
    if (st != JLT_OK || study == NULL) return st;
    st = take_study(self, words, study, self->paths[file]);
    while (st == JLT_OK && (st = jlt_shard_reader_next(reader, &record)) == JLT_OK)
        st = take_record(self, words, file, reader->from, &record);
    if (st == JLT_ERR_IO) fprintf(words, "%s: %s\n", self->paths[file], strerror(errno));
    return st == JLT_ERR_EMPTY ? JLT_OK : st;
}

jlt_status jlt_gather_open(jlt_gather **out, char **message, const char *const *paths, size_t count)
{
    jlt_gather *self = calloc(1, sizeof *self);
    size_t size = 0;
    FILE *words;
    jlt_status st = JLT_OK;

    *out = NULL;
    *message = NULL;
    words = open_memstream(message, &size);
    if (self == NULL || words == NULL) {
        st = JLT_ERR_NOMEM;
        goto done;
    }
    self->paths = paths;
    self->readers = calloc(count + 1, sizeof *self->readers);
    if (self->readers == NULL) st = JLT_ERR_NOMEM;
    for (size_t i = 0; st == JLT_OK && i < count; i++) self->readers[i].descriptor = -1;
    if (st == JLT_OK) self->count = count;
    allow_descriptors(count);
    for (size_t i = 0; st == JLT_OK && i < count; i++) st = take_file(self, words, i);
    if (st == JLT_OK && self->study == NULL) st = JLT_ERR_EMPTY;
    if (st != JLT_OK) goto done;
    *out = self;
    self = NULL;
done:
    if (words != NULL && fclose(words) != 0 && st == JLT_OK) st = JLT_ERR_NOMEM;
    jlt_gather_destroy(self);
    return st;
}

void jlt_gather_destroy(jlt_gather *self)
{
    if (self == NULL) return;
    for (size_t i = 0; i < self->count; i++) {
        if (self->readers[i].descriptor >= 0) close(self->readers[i].descriptor);
        jlt_shard_reader_close(&self->readers[i]);
    }
    free(self->readers);
    free(self->places);
    free(self->study);
    free(self);
}

const char *jlt_gather_study(const jlt_gather *self) { return self->study; }

size_t jlt_gather_pieces(const jlt_gather *self) { return self->pieces; }

size_t jlt_gather_missing(const jlt_gather *self, size_t *first)
{
    size_t missing = 0;

    for (size_t i = 0; i < self->pieces; i++)
        if (self->places[i].file == 0 && missing++ == 0) *first = i;
    return missing;
}

const char *jlt_gather_path(const jlt_gather *self, size_t piece) { return self->paths[self->places[piece].file - 1]; }

jlt_status jlt_gather_piece(jlt_gather *self, jlt_shard_record *record, size_t piece)
{
    const place *at = &self->places[piece];

    if (at->file == 0) return JLT_ERR_EMPTY;
    JLT_PASS(jlt_shard_reader_at(&self->readers[at->file - 1], record, at->at));
    const place now = place_of(at->file - 1, at->at, record);
    if (record->piece == piece && is_alike(at, &now)) return JLT_OK;
    errno = ESTALE; /* the file was begun anew meanwhile */
    return JLT_ERR_IO;
}
