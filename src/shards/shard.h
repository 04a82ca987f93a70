/** The file of one shard: a record with the study, then one for each finished piece, each with its length, a checksum and the
 *  study's key. Records are only appended. If a crash leaves the last one incomplete, it is cut off when the shard is resumed.
 *
 *  A record begins with one of the lines
 *
 *      study 0 0 LENGTH 0 KEY CHECKSUM
 *      piece NUMBER STATUS ROWS WORDS KEY CHECKSUM
 *
 *  Then come LENGTH bytes, the study in JSON; or ROWS bytes, the line of column names and the rows in CSV, and WORDS bytes, what
 *  the command wrote to standard error; and a newline.
 *
 *  KEY is the first 16 digits of the SHA-256 of the study's JSON. CHECKSUM is zlib's CRC-32 of the line up to KEY and of the bytes
 *  that follow the line, without the newline. */
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
    int status;       /* exit status of the command */
    const char *rows; /* shape (rows_size,), not ended by a NUL */
    size_t rows_size;
    const char *words;
    size_t words_size;
} jlt_shard_record;

/** Reads a shard's file, from its beginning. */
typedef struct {
    int descriptor;
    off_t at, size; /* offset of the next record to read; size of the file */
    off_t from;     /* offset of the last record that was read */
    off_t skipped;  /* bytes before `at` that are no whole record of a piece of this study */
    char *data;     /* the bytes of the last record that was read, shape (room,); owned */
    size_t room;
    char key[JLT_SHARD_KEY];
} jlt_shard_reader;

/** Open a reader on a descriptor, which the caller closes. Out: *study, the study's JSON, for the caller to free(), also on
 *  failure; NULL if the file is empty or torn within its first record. Errors: ARG, the file is not a shard, or its first record is
 *  damaged; NOMEM; IO. */
JLT_CHECKED jlt_status jlt_shard_reader_open(jlt_shard_reader *self, char **study, int descriptor);
void jlt_shard_reader_close(jlt_shard_reader *self); /* legal when zeroed */

/** Read the next record that is whole and of this study, whose bytes are valid until the next call. Errors: EMPTY, none follows;
 *  NOMEM; IO. */
JLT_CHECKED jlt_status jlt_shard_reader_next(jlt_shard_reader *self, jlt_shard_record *record);

/** Read the record at offset `at` again. Errors: IO, it cannot be read or has changed; NOMEM. */
JLT_CHECKED jlt_status jlt_shard_reader_at(jlt_shard_reader *self, jlt_shard_record *record, off_t at);

/** A shard's file to which this process alone writes. */
typedef struct {
    const char *path;
    int descriptor;
    off_t end;
    char key[JLT_SHARD_KEY];
    struct timespec synced;
} jlt_shard;

/** The key of a study, from its JSON. */
void jlt_shard_key(char key[JLT_SHARD_KEY], const char *study);

/** Open the file, or create it, and lock it against other processes that use this function. `path` must outlive *self. Out:
 *  *holder, the process that holds the lock, or 0 if its number is unknown; -1 if no other process does. Errors: IO (errno says
 *  why; ENOLCK and the like where the file system has no locks). */
JLT_CHECKED jlt_status jlt_shard_open(jlt_shard *self, pid_t *holder, const char *path);

/** Close, and give up the lock. Legal when the descriptor is -1. */
void jlt_shard_close(jlt_shard *self);

/** Begin: replace the file's content by the record of the study. Resume: keep the first `end` bytes, which a whole record of this
 *  study ends, cut off the rest, and append there. Errors: IO (errno says why), NOMEM. */
JLT_CHECKED jlt_status jlt_shard_begin(jlt_shard *self, const char *study);
JLT_CHECKED jlt_status jlt_shard_resume(jlt_shard *self, const char *study, off_t end);

/** Append the record of a piece; flush all records to the disk. _add calls _sync once the last flush is ten seconds old.
 *  Where _add cannot write, it cuts the file back to its whole records. Errors: IO (errno says why; ESTALE, `path` does not lead to
 *  this file any more), NOMEM. */
JLT_CHECKED jlt_status jlt_shard_add(jlt_shard *self, const jlt_shard_record *record);
JLT_CHECKED jlt_status jlt_shard_sync(jlt_shard *self);

#endif
