/** Gathers the pieces of a study from the files of its shards, and reads them in the order of the study. */
#ifndef JLT_SHARDS_GATHER_H
#define JLT_SHARDS_GATHER_H

#include "shards/shard.h"

typedef struct jlt_gather jlt_gather;

/** Read all files, shape (count,), and check every record. A file that is empty, or torn within its first record, has no pieces; a
 *  later torn record ends its file. A piece in two files must have the same bytes in both. `paths` must outlive *out. Out: *out,
 *  for jlt_gather_destroy; *message, whole lines that say what is wrong, for the caller to free(), or NULL. Errors: IO, a file
 *  cannot be read; ARG, a file is not a shard or is of another study, or two copies of a piece differ; EMPTY, no file has a study;
 *  NOMEM. Memory: 32 bytes a piece, and a descriptor a file. Cost: every byte is read once. */
JLT_CHECKED jlt_status jlt_gather_open(jlt_gather **out, char **message, const char *const *paths, size_t count);
void jlt_gather_destroy(jlt_gather *self); /* NULL is legal */

/** The study's JSON; its number of pieces; the number of missing pieces, with the first of these in *first, which is unchanged when
 *  none is missing. */
const char *jlt_gather_study(const jlt_gather *self);
size_t jlt_gather_pieces(const jlt_gather *self);
size_t jlt_gather_missing(const jlt_gather *self, size_t *first);

/** The path of the file that a piece is read from; the piece is not missing. */
const char *jlt_gather_path(const jlt_gather *self, size_t piece);

/** Read a piece; the bytes of *record are valid until the next call. Errors: EMPTY, the piece is missing; IO, it cannot be
 *  read, or is not what it was in jlt_gather_open (errno: ESTALE); NOMEM. */
JLT_CHECKED jlt_status jlt_gather_piece(jlt_gather *self, jlt_shard_record *record, size_t piece);

#endif
