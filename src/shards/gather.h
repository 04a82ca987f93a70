/** Gathers the pieces of a study from the files of its shards, and reads them in the order of the study. */
#ifndef JLT_SHARDS_GATHER_H
#define JLT_SHARDS_GATHER_H

#include "shards/shard.h"

typedef struct jlt_gather jlt_gather;

/** Look through all files, shape (count,), and check every record; files that are empty, or torn before their first record ends,
 *  have nothing. A piece that is there twice must be there with the same bytes. Out: *out, for jlt_gather_destroy; *message, what
 *  is wrong, whole lines, for the caller to free(), or NULL. Errors: IO, a file cannot be read; ARG, one is no shard's file, or of
 *  another study, or a piece is there in two versions; EMPTY, there is no study in any; NOMEM. Memory: 32 bytes a piece, and a
 *  descriptor a file.
 *  Cost: every byte is read once. */
JLT_CHECKED jlt_status jlt_gather_open(jlt_gather **out, char **message, const char *const *paths, size_t count);
void jlt_gather_destroy(jlt_gather *self); /* NULL is legal */

/** The study's JSON; how many pieces it has; how many of them are missing, and, in *first, the number of the first of these. */
const char *jlt_gather_study(const jlt_gather *self);
size_t jlt_gather_pieces(const jlt_gather *self);
size_t jlt_gather_missing(const jlt_gather *self, size_t *first);

/** Read a piece, which lives until the next call. Errors: EMPTY, it is missing; IO; NOMEM. */
JLT_CHECKED jlt_status jlt_gather_piece(jlt_gather *self, jlt_shard_record *record, size_t piece);

#endif
