#include "core/spool.h"

#include "core/memory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

/* The file consists of blocks of equal length: the number of the sequence's next block, then `room` records. The number of the
 * next block is reserved when a block is written, so nothing in memory grows with the number of blocks. */
typedef struct {
    size_t held;    /* records in memory */
    size_t blocks;  /* of this sequence in the file */
    uint64_t first; /* number of its first block; defined when blocks > 0 */
    uint64_t next;  /* number reserved for the block that the records in memory will become; likewise */
} sequence;

struct jlt_spool {
    size_t width, room;
    sequence *of;
    double *recent; /* (sequences, room, width) */
    double *block;  /* (room, width), read from the file */
    int file;       /* descriptor; -1 before the file is opened; set atomically */
    uint64_t places; /* block numbers handed out; changed atomically */
    struct {
        size_t sequence, blocks, at; /* blocks read; records read of the current block */
        uint64_t next;
    } reading;
};

jlt_status jlt_spool_create(jlt_spool **out, size_t width, size_t sequences, size_t room)
{
    jlt_spool *self;

    *out = NULL;
    if (width == 0 || sequences == 0 || room == 0 || room > SIZE_MAX / sizeof(double) / width) return JLT_ERR_ARG;
    if (sequences > SIZE_MAX / (room * width * sizeof(double))) return JLT_ERR_NOMEM;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    *self = (jlt_spool){ .width = width, .room = room, .file = -1 };
    self->of = calloc(sequences, sizeof *self->of);
    self->recent = malloc(sequences * room * width * sizeof *self->recent);
    self->block = malloc(room * width * sizeof *self->block);
    if (self->of != NULL && self->recent != NULL && self->block != NULL) {
        *out = self;
        return JLT_OK;
    }
    jlt_spool_destroy(self);
    return JLT_ERR_NOMEM;
}

void jlt_spool_destroy(jlt_spool *self)
{
    if (self == NULL) return;
    if (self->file >= 0) close(self->file);
    free(self->of);
    free(self->recent);
    free(self->block);
    free(self);
}

/* Returns the descriptor of the file, -1 on failure; the first thread that needs the file creates it. */
static int open_file(jlt_spool *self)
{
    static const char name[] = "/jellett.XXXXXX";
    const char *folder = getenv("TMPDIR");
    int file = __atomic_load_n(&self->file, __ATOMIC_ACQUIRE), none = -1;

    if (file >= 0) return file;
    if (folder == NULL || *folder == '\0') folder = "/tmp";
    JLT_FREED char *path = malloc(strlen(folder) + sizeof name);
    if (path == NULL) return -1;
    strcpy(path, folder);
    strcat(path, name);
    file = mkstemp(path);
    if (file >= 0) unlink(path);
    if (file >= 0 && fcntl(file, F_SETFD, FD_CLOEXEC) != 0) {
        close(file);
        return -1;
    }
    if (file < 0 || __atomic_compare_exchange_n(&self->file, &none, file, false, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE)) return file;
    close(file); /* another thread was faster */
    return none;
}

/* Write, or else read, all bytes at offset `place`; returns false on failure. */
static bool carry(int file, bool writes, void *bytes, size_t size, uint64_t place)
{
    for (size_t done = 0; done < size;) {
        char *const rest = (char *)bytes + done;
        const off_t at = (off_t)(place + done);
        const ssize_t part = writes ? pwrite(file, rest, size - done, at) : pread(file, rest, size - done, at);
        if (part < 0 && errno == EINTR) continue;
        if (part <= 0) return false;
        done += (size_t)part;
    }
    return true;
}

static size_t block_bytes(const jlt_spool *self) { return self->room * self->width * sizeof *self->block; }

static uint64_t place_of(const jlt_spool *self, uint64_t block) { return block * (sizeof(uint64_t) + block_bytes(self)); }

static double *recent_of(const jlt_spool *self, size_t index) { return self->recent + index * self->room * self->width; }

static uint64_t reserve(jlt_spool *self) { return __atomic_fetch_add(&self->places, 1, __ATOMIC_RELAXED); }

/* Write the records of a sequence that are in memory to the file, as one block. */
static jlt_status move_out(jlt_spool *self, size_t index)
{
    sequence *s = &self->of[index];
    const int file = open_file(self);

    if (file < 0) return JLT_ERR_IO;
    if (s->blocks == 0) s->first = s->next = reserve(self);
    const uint64_t here = place_of(self, s->next);
    uint64_t next = reserve(self);
    if (!carry(file, true, &next, sizeof next, here)
        || !carry(file, true, recent_of(self, index), block_bytes(self), here + sizeof next))
        return JLT_ERR_IO;
    s->next = next;
    s->blocks++;
    s->held = 0;
    return JLT_OK;
}

jlt_status jlt_spool_add(jlt_spool *self, size_t index, const double *record)
{
    sequence *s = &self->of[index];

    if (s->held == self->room) JLT_PASS(move_out(self, index));
    memcpy(recent_of(self, index) + s->held++ * self->width, record, self->width * sizeof *record);
    return JLT_OK;
}

void jlt_spool_forget(jlt_spool *self, size_t index) { self->of[index] = (sequence){ 0 }; }

void jlt_spool_rewind(jlt_spool *self, size_t index)
{
    self->reading.sequence = index;
    self->reading.blocks = 0;
    self->reading.at = self->room; /* the next record begins a block */
    self->reading.next = self->of[index].first;
}

jlt_status jlt_spool_read(jlt_spool *self, double *record)
{
    const sequence *s = &self->of[self->reading.sequence];

    if (self->reading.at == self->room && self->reading.blocks <= s->blocks) {
        self->reading.at = 0;
        if (self->reading.blocks++ < s->blocks) {
            const uint64_t here = place_of(self, self->reading.next);
            if (!carry(self->file, false, &self->reading.next, sizeof self->reading.next, here) ||
                !carry(self->file, false, self->block, block_bytes(self), here + sizeof self->reading.next))
                return JLT_ERR_IO;
        }
    }
    const bool in_file = self->reading.blocks <= s->blocks;
    if (self->reading.at >= (in_file ? self->room : s->held)) return JLT_ERR_EMPTY;
    const double *from = in_file ? self->block : recent_of(self, self->reading.sequence);
    memcpy(record, from + self->reading.at++ * self->width, self->width * sizeof *record);
    return JLT_OK;
}
