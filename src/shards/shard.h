/** The file of one shard: the study that it is of, and the pieces that are done, each a record with its length, a checksum and the
 *  study's key. A record is added at the end, and nothing is ever changed. What a crash leaves of the last one is cut when the file
 *  is opened again.
 *
 *      study 0 0 LENGTH 0 KEY CHECKSUM
 *      piece NUMBER STATUS ROWS WORDS KEY CHECKSUM
 *
 *  are the lines that records begin with. So many bytes follow, and a newline: of the first the study in JSON; of a piece a line of
 *  the columns' names with rows in CSV, and what the command said.
 *
 *  KEY is the first 16 digits of the SHA-256 of the study's JSON, CHECKSUM zlib's CRC-32 of the line up to it and of the bytes that
 *  follow. */
#ifndef JLT_SHARDS_SHARD_H
#define JLT_SHARDS_SHARD_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>
#include <time.h>

#include "core/status.h"

enum { JLT_SHARD_KEY = 17 }; /* bytes, with the NUL */

typedef struct {
    size_t piece;
    int status;       /* of the command */
    const char *rows; /* shape (rows_size,), not ended by a NUL */
    size_t rows_size;
    const char *words;
    size_t words_size;
} jlt_shard_record;

/** Reads a shard's file, from its beginning. */
typedef struct {
    int descriptor;
    off_t at, size; /* behind the last record that was read; of the file */
    char *data;     /* of that record; owned */
    size_t room;
    char key[JLT_SHARD_KEY];
} jlt_shard_reader;

/** Begin to read a file from its beginning, by a descriptor that stays the caller's. Out: *study, the study's JSON, for the caller
 *  to free(); NULL where the file ends before its first record does. Errors: ARG, this is no shard's file, or its first record is
 *  not what was written; NOMEM; IO. */
JLT_CHECKED jlt_status jlt_shard_reader_open(jlt_shard_reader *self, char **study, int descriptor);
void jlt_shard_reader_close(jlt_shard_reader *self); /* legal when zeroed */

/** Read the next record, which lives until the next call. Errors: EMPTY, there is no further whole one: the file ends at `at`, or
 *  is torn there; NOMEM; IO. */
JLT_CHECKED jlt_status jlt_shard_reader_next(jlt_shard_reader *self, jlt_shard_record *record);

/** Read the record at this place again. Errors: IO, it is not there any more; NOMEM. */
JLT_CHECKED jlt_status jlt_shard_reader_at(jlt_shard_reader *self, jlt_shard_record *record, off_t at);

/** A shard's file that is written, by this process alone. */
typedef struct {
    const char *path;
    int descriptor;
    off_t end;
    char key[JLT_SHARD_KEY];
    struct timespec synced;
} jlt_shard;

/** The key of a study, from its JSON. */
void jlt_shard_key(char key[JLT_SHARD_KEY], const char *study);

/** Open the file, or make it, and lock it, so that no other process writes to it. The path stays the caller's, who keeps it. Out:
 *  *holder, where another process has the file: its number, 0 where that is not known; else -1, also after other failures.
 *  Errors: IO (errno says why; ENOLCK and the like where the file system knows no locks). */
JLT_CHECKED jlt_status jlt_shard_open(jlt_shard *self, pid_t *holder, const char *path);

/** Close, and give up the lock. Legal when the descriptor is -1. */
void jlt_shard_close(jlt_shard *self);

/** Begin the file with its study, in place of whatever is in it; or go on behind what is whole, `end`, and cut the rest.
 *  Errors: IO (errno says why), NOMEM. */
JLT_CHECKED jlt_status jlt_shard_begin(jlt_shard *self, const char *study);
JLT_CHECKED jlt_status jlt_shard_resume(jlt_shard *self, const char *study, off_t end);

/** Add a record. It is on the disk after ten seconds, or after jlt_shard_sync. On failure the file ends with the record before.
 *  Errors: IO (errno says why; ESTALE, the path leads to this file no more), NOMEM. */
JLT_CHECKED jlt_status jlt_shard_add(jlt_shard *self, const jlt_shard_record *record);
JLT_CHECKED jlt_status jlt_shard_sync(jlt_shard *self);

#endif
