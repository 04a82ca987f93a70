#include "shards/shard.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/sha256.h"

enum { LINE_MAX_BYTES = 160, SYNC_SECONDS = 10 };

void jlt_shard_key(char key[JLT_SHARD_KEY], const char *study)
{
    char digest[65];

    ttc_sha256(digest, study, strlen(study));
    memcpy(key, digest, JLT_SHARD_KEY - 1);
    key[JLT_SHARD_KEY - 1] = '\0';
}

/* ---- reading ---- */

static jlt_status read_bytes(const jlt_shard_reader *self, char *data, size_t size, off_t at)
{
    while (size > 0) {
        const ssize_t got = pread(self->descriptor, data, size, at);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return JLT_ERR_IO;
        data += got;
        size -= (size_t)got;
        at += (off_t)got;
    }
    return JLT_OK;
}

static unsigned long checksum(const char *line, size_t length, const char *data, size_t size)
{
    return crc32_z(crc32_z(0, (const unsigned char *)line, length), (const unsigned char *)data, size);
}

/* Read the record at offset `at`. Out: its `kind` and `key`; *next, the offset of the record after it. Errors: EMPTY, the file ends
 * before the record does; ARG, the line is malformed or the checksum does not fit; IO; NOMEM. */
static jlt_status read_record(jlt_shard_reader *self, jlt_shard_record *record, char kind[6], char key[JLT_SHARD_KEY], off_t *next,
                              off_t at)
{
    char line[LINE_MAX_BYTES + 1];
    const off_t left = self->size - at;
    size_t length = left > LINE_MAX_BYTES ? LINE_MAX_BYTES : (size_t)left;
    unsigned long sum;
    int used = 0;

    if (left <= 0) return JLT_ERR_EMPTY;
    JLT_PASS(read_bytes(self, line, length, at));
    line[length] = '\0';
    length = strcspn(line, "\n");
    if (line[length] != '\n') return (off_t)length == left ? JLT_ERR_EMPTY : JLT_ERR_ARG;
    line[length] = '\0';
    if (sscanf(line, "%5s %zu %d %zu %zu %16s%n %8lx", kind, &record->piece, &record->status, &record->rows_size,
               &record->words_size, key,
               &used, &sum) != 7)
        return JLT_ERR_ARG;
    const size_t room = (size_t)(left - (off_t)length - 1); /* bytes behind the line */
    if (record->rows_size >= room || record->words_size >= room - record->rows_size) return JLT_ERR_EMPTY;
    const size_t size = record->rows_size + record->words_size;
    if (size + 1 > self->room) {
        char *grown = realloc(self->data, size + 1);
        if (grown == NULL) return JLT_ERR_NOMEM;
        self->data = grown;
        self->room = size + 1;
    }
    JLT_PASS(read_bytes(self, self->data, size + 1, at + (off_t)length + 1));
    if (self->data[size] != '\n' || checksum(line, (size_t)used, self->data, size) != sum) return JLT_ERR_ARG;
    record->rows = self->data;
    record->words = self->data + record->rows_size;
    *next = at + (off_t)(length + 1 + size + 1);
    return JLT_OK;
}

/* Move *at to the next line that begins as the record of a piece does. Errors: EMPTY, there is none; IO. */
static jlt_status find_piece(const jlt_shard_reader *self, off_t *at)
{
    static const char begins[] = "\npiece ";
    const size_t length = sizeof begins - 1;
    char block[8192];

    for (off_t from = *at; self->size - from >= (off_t)length; from += (off_t)(sizeof block - length + 1)) {
        const size_t size = self->size - from < (off_t)sizeof block ? (size_t)(self->size - from) : sizeof block;
        JLT_PASS(read_bytes(self, block, size, from));
        for (size_t i = 0; i + length <= size; i++) {
            if (memcmp(block + i, begins, length) != 0) continue;
            *at = from + (off_t)i + 1;
            return JLT_OK;
        }
    }
    return JLT_ERR_EMPTY;
}

jlt_status jlt_shard_reader_open(jlt_shard_reader *self, char **study, int descriptor)
{
    jlt_shard_record record = { .piece = 0 };
    char kind[6] = "", key[JLT_SHARD_KEY] = "", start[7] = "";
    jlt_status st;

    *self = (jlt_shard_reader){ .descriptor = descriptor };
    *study = NULL;
    self->size = lseek(descriptor, 0, SEEK_END);
    if (self->size < 0) return JLT_ERR_IO;
    if (self->size == 0) return JLT_OK;
    const size_t known = self->size < 6 ? (size_t)self->size : 6;
    if (read_bytes(self, start, known, 0) != JLT_OK) return JLT_ERR_IO;
    if (strncmp(start, "study ", known) != 0) return JLT_ERR_ARG;
    st = read_record(self, &record, kind, key, &self->at, 0);
    if (st == JLT_ERR_EMPTY) {
        off_t behind = 0; /* a piece behind a first record that seems torn: what is damaged is that record's length */
        st = find_piece(self, &behind);
        return st == JLT_OK ? JLT_ERR_ARG : st == JLT_ERR_EMPTY ? JLT_OK : st;
    }
    if (st == JLT_OK && (*study = strndup(record.rows, record.rows_size)) == NULL) st = JLT_ERR_NOMEM;
    if (st != JLT_OK) return st;
    jlt_shard_key(self->key, *study);
    return strcmp(self->key, key) == 0 ? JLT_OK : JLT_ERR_ARG;
}

void jlt_shard_reader_close(jlt_shard_reader *self)
{
    free(self->data);
    *self = (jlt_shard_reader){ .descriptor = -1 };
}

jlt_status jlt_shard_reader_next(jlt_shard_reader *self, jlt_shard_record *record)
{
    for (off_t at = self->at;;) {
        char kind[6] = "", key[JLT_SHARD_KEY] = "";
        off_t next = 0;
        const jlt_status st = read_record(self, record, kind, key, &next, at);
        if (st == JLT_OK && strcmp(kind, "piece") == 0 && strcmp(key, self->key) == 0) {
            self->skipped += at - self->at;
            self->from = at;
            self->at = next;
            return JLT_OK;
        }
        if (st != JLT_OK && st != JLT_ERR_ARG && st != JLT_ERR_EMPTY) return st;
        JLT_PASS(find_piece(self, &at));
    }
}

jlt_status jlt_shard_reader_at(jlt_shard_reader *self, jlt_shard_record *record, off_t at)
{
    char kind[6] = "", key[JLT_SHARD_KEY] = "";
    off_t next = 0;
    const jlt_status st = read_record(self, record, kind, key, &next, at);

    if (st != JLT_ERR_EMPTY && st != JLT_ERR_ARG && (st != JLT_OK || strcmp(key, self->key) == 0)) return st;
    errno = ESTALE;
    return JLT_ERR_IO;
}

/* ---- writing ---- */

jlt_status jlt_shard_open(jlt_shard *self, pid_t *holder, const char *path)
{
    struct flock lock = { .l_type = F_WRLCK, .l_whence = SEEK_SET };

    *holder = -1;
    *self = (jlt_shard){ .path = path, .descriptor = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666) };
    if (self->descriptor < 0) return JLT_ERR_IO;
    /* A POSIX record lock: the system releases it however the process ends, and NFS and Lustre enforce it between machines. */
    if (fcntl(self->descriptor, F_SETLK, &lock) == 0) return JLT_OK;
    const int reason = errno;
    if (reason == EACCES || reason == EAGAIN) {
        const bool known = fcntl(self->descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
        *holder = known ? lock.l_pid : 0;
    }
    jlt_shard_close(self);
    errno = reason;
    return JLT_ERR_IO;
}

void jlt_shard_close(jlt_shard *self)
{
    if (self->descriptor >= 0) close(self->descriptor);
    self->descriptor = -1;
}

static jlt_status write_bytes(const jlt_shard *self, const char *data, size_t size)
{
    off_t at = self->end;

    while (size > 0) {
        const ssize_t put = pwrite(self->descriptor, data, size, at);
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return JLT_ERR_IO;
        data += put;
        size -= (size_t)put;
        at += (off_t)put;
    }
    return JLT_OK;
}

static jlt_status add(jlt_shard *self, const char *kind, const jlt_shard_record *record)
{
    const size_t size = record->rows_size + record->words_size;
    char *const data = malloc(LINE_MAX_BYTES + size + 1);
    jlt_status st;

    if (data == NULL) return JLT_ERR_NOMEM;
    /* The line precedes the bytes, but its checksum depends on them: place the bytes first, then move the line in front of them. */
    char *const bytes = data + LINE_MAX_BYTES;
    if (record->rows_size > 0) memcpy(bytes, record->rows, record->rows_size);
    if (record->words_size > 0) memcpy(bytes + record->rows_size, record->words, record->words_size);
    bytes[size] = '\n';
    int length = snprintf(data, LINE_MAX_BYTES, "%s %zu %d %zu %zu %s", kind, record->piece, record->status, record->rows_size,
                          record->words_size, self->key);
    const unsigned long sum = checksum(data, (size_t)length, bytes, size);
    length += snprintf(data + length, LINE_MAX_BYTES - (size_t)length, " %08lx\n", sum);
    memmove(bytes - length, data, (size_t)length);
    const size_t whole = (size_t)length + size + 1;
    st = write_bytes(self, bytes - length, whole);
    if (st == JLT_OK) self->end += (off_t)whole;
    else {
        const int reason = errno;
        (void)!ftruncate(self->descriptor, self->end); /* should this fail, jlt_shard_resume cuts the torn record off */
        errno = reason;
    }
    free(data);
    return st;
}

jlt_status jlt_shard_begin(jlt_shard *self, const char *study)
{
    const jlt_shard_record record = { .rows = study, .rows_size = strlen(study) };

    jlt_shard_key(self->key, study);
    self->end = 0;
    if (ftruncate(self->descriptor, 0) != 0) return JLT_ERR_IO;
    const jlt_status st = add(self, "study", &record);
    return st == JLT_OK ? jlt_shard_sync(self) : st;
}

jlt_status jlt_shard_resume(jlt_shard *self, const char *study, off_t end)
{
    jlt_shard_key(self->key, study);
    self->end = end;
    return ftruncate(self->descriptor, end) == 0 ? jlt_shard_sync(self) : JLT_ERR_IO;
}

jlt_status jlt_shard_add(jlt_shard *self, const jlt_shard_record *record)
{
    const jlt_status st = add(self, "piece", record);
    struct timespec now;

    if (st != JLT_OK) return st;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec - self->synced.tv_sec < SYNC_SECONDS ? JLT_OK : jlt_shard_sync(self);
}

jlt_status jlt_shard_sync(jlt_shard *self)
{
    struct stat there, here;

    clock_gettime(CLOCK_MONOTONIC, &self->synced);
    if (fdatasync(self->descriptor) != 0 || fstat(self->descriptor, &here) != 0) return JLT_ERR_IO;
    if (stat(self->path, &there) == 0 && there.st_dev == here.st_dev && there.st_ino == here.st_ino) return JLT_OK;
    errno = ESTALE;
    return JLT_ERR_IO;
}
