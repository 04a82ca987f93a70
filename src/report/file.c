#include "report/file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { LINKS_MAX = 40, NAMES_TRIED = 100, ENDING = 7, MODE = 07777 };

/* The length of a path up to and with its last slash; 0 if there is none. */
static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash == NULL ? 0 : (size_t)(slash - path) + 1;
}

/* Follow the symbolic links of a path, also to a file that does not exist. Returns the path at the end, for the caller to free;
 * NULL: errno says why. */
static char *follow(const char *path)
{
    char *at = strdup(path), link[PATH_MAX];

    for (int i = 0; at != NULL && i < LINKS_MAX; i++) {
        const ssize_t length = readlink(at, link, sizeof link - 1);
        if (length < 0) return at;
        link[length] = '\0';
        const size_t folder = link[0] == '/' ? 0 : folder_length(at);
        char *next = malloc(folder + (size_t)length + 1);
        if (next != NULL) snprintf(next, folder + (size_t)length + 1, "%.*s%s", (int)folder, at, link);
        free(at);
        at = next;
    }
    if (at != NULL) errno = ELOOP;
    free(at);
    return NULL;
}

/* Create a file beside the target under an unused name, the target's with an ending in place of what is too long, by open(), not
 * mkstemp(), so that the umask decides its mode. Returns its descriptor; -1: errno says why. */
static int make_temporary(jlt_file *self)
{
    const size_t room = strlen(self->target) + ENDING + 1, most = folder_length(self->target) + NAME_MAX - ENDING;
    struct timespec now = { 0 };
    int descriptor = -1;

    self->temporary = malloc(room);
    if (self->temporary == NULL) return -1;
    clock_gettime(CLOCK_REALTIME, &now);
    for (uint32_t i = 0; i < NAMES_TRIED; i++) {
        const uint32_t word = ((uint32_t)now.tv_nsec + (uint32_t)getpid() * 0x9e3779b1u + i) % 0x1000000u;
        snprintf(self->temporary, room, "%.*s.%06x", (int)most, self->target, (unsigned)word);
        descriptor = open(self->temporary, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) break;
    }
    if (descriptor < 0) {
        const int reason = errno;
        free(self->temporary);
        self->temporary = NULL;
        errno = reason;
    }
    return descriptor;
}

jlt_status jlt_file_begin(jlt_file *self, const char *path)
{
    struct stat about;
    const bool exists = stat(path, &about) == 0, is_device = exists && !S_ISREG(about.st_mode);

    /* Links of a device are not followed: where /dev/stdout is a pipe, they end at no name in a file system. */
    *self = (jlt_file){ .descriptor = -1, .target = is_device ? strdup(path) : follow(path) };
    if (self->target == NULL) return errno == ENOMEM ? JLT_ERR_NOMEM : JLT_ERR_IO;
    if (is_device) {
        self->descriptor = open(path, O_WRONLY | O_CLOEXEC); /* a folder is refused here */
    } else {
        self->descriptor = make_temporary(self);
        /* A failure is ignored: some file systems have no permissions. */
        if (self->descriptor >= 0 && exists) (void)!fchmod(self->descriptor, about.st_mode & MODE);
    }
    if (self->descriptor >= 0) return JLT_OK;
    const jlt_status st = errno == ENOMEM ? JLT_ERR_NOMEM : JLT_ERR_IO;
    jlt_file_end(self);
    return st;
}

static bool move(const jlt_file *self)
{
    return fsync(self->descriptor) == 0 && rename(self->temporary, self->target) == 0;
}

jlt_status jlt_file_put(const jlt_file *self, const char *data, size_t size, size_t offset)
{
    while (size > 0) {
        const ssize_t written = pwrite(self->descriptor, data, size, (off_t)offset);
        if (written < 0) {
            if (errno == EINTR) continue;
            return JLT_ERR_IO;
        }
        data += written;
        offset += (size_t)written;
        size -= (size_t)written;
    }
    return JLT_OK;
}

jlt_status jlt_file_get(const jlt_file *self, char *data, size_t size, size_t offset)
{
    ssize_t got;

    do got = pread(self->descriptor, data, size, (off_t)offset);
    while (got < 0 && errno == EINTR);
    if (got >= 0) errno = EIO;
    return got == (ssize_t)size ? JLT_OK : JLT_ERR_IO;
}

/* Cut a binary file to its whole bytes, and append its tail. */
static jlt_status put_tail(const jlt_file *self)
{
    if (self->whole == 0) return JLT_ERR_EMPTY;
    if (ftruncate(self->descriptor, (off_t)self->whole) != 0) return JLT_ERR_IO;
    return jlt_file_put(self, self->tail, self->tail_size, self->whole);
}

jlt_status jlt_file_commit(jlt_file *self)
{
    if (self->temporary == NULL) return JLT_OK;
    if (self->tail != NULL && put_tail(self) != JLT_OK) return JLT_ERR_IO;
    if (!move(self)) return JLT_ERR_IO;
    free(self->temporary);
    self->temporary = NULL;
    return JLT_OK;
}

/* The length of a file up to and with its last newline; 0 if there is none, or the file cannot be read. */
static off_t whole_lines(const char *path)
{
    char piece[4096];
    const int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    off_t end = descriptor < 0 ? 0 : lseek(descriptor, 0, SEEK_END);

    while (end > 0) {
        const off_t start = end > (off_t)sizeof piece ? end - (off_t)sizeof piece : 0;
        ssize_t size = lseek(descriptor, start, SEEK_SET) < 0 ? -1 : read(descriptor, piece, (size_t)(end - start));
        if (size != (ssize_t)(end - start)) break;
        while (size > 0 && piece[size - 1] != '\n') size--;
        end = start + (off_t)size;
        if (size > 0) {
            close(descriptor);
            return end;
        }
    }
    if (descriptor >= 0) close(descriptor);
    return 0;
}

bool jlt_file_has_row(const jlt_file *self)
{
    char piece[4096], before = '\n';
    bool is_comment = false;
    ssize_t size;
    int lines = 0;

    if (self->temporary == NULL) return false;
    if (self->tail != NULL) return self->whole > self->head;
    for (off_t at = 0; lines < 2 && (size = pread(self->descriptor, piece, sizeof piece, at)) > 0; at += size)
        for (ssize_t i = 0; i < size; before = piece[i++]) {
            if (before == '\n') is_comment = piece[i] == '#';
            lines += piece[i] == '\n' && !is_comment;
        }
    return lines >= 2;
}

jlt_status jlt_file_commit_lines(const jlt_file *self)
{
    if (!jlt_file_has_row(self)) return JLT_ERR_EMPTY;
    if (self->tail != NULL) {
        (void)put_tail(self); /* as much of it as the disk has room for */
        return move(self) ? JLT_OK : JLT_ERR_IO;
    }
    const off_t length = whole_lines(self->temporary);

    return length > 0 && ftruncate(self->descriptor, length) == 0 && move(self) ? JLT_OK : JLT_ERR_IO;
}

void jlt_file_end(jlt_file *self)
{
    const int reason = errno;

    if (self->target == NULL) return; /* zeroed: descriptor 0 is not its own */
    if (self->descriptor >= 0) close(self->descriptor);
    if (self->temporary != NULL) unlink(self->temporary);
    free(self->temporary);
    free(self->target);
    *self = (jlt_file){ .descriptor = -1 };
    errno = reason;
}

static bool write_all(int descriptor, const char *data, size_t size)
{
    while (size > 0) {
        const ssize_t written = write(descriptor, data, size);
        if (written < 0) {
            if (errno == EINTR) continue;
            return false;
        }
        data += written;
        size -= (size_t)written;
    }
    return true;
}

jlt_status jlt_file_write(const char *path, const char *data, size_t size)
{
    jlt_file file;

    JLT_PASS(jlt_file_begin(&file, path));
    const jlt_status st = write_all(file.descriptor, data, size) ? jlt_file_commit(&file) : JLT_ERR_IO;
    jlt_file_end(&file);
    return st;
}

/* The folder of a path, for the caller to free. */
static char *folder_of(const char *path)
{
    const size_t length = folder_length(path);
    return length == 0 ? strdup(".") : strndup(path, length);
}

jlt_status jlt_file_reachable(const char *path)
{
    char *target = follow(path), *folder = target == NULL ? NULL : folder_of(target);
    jlt_status st = folder != NULL ? JLT_OK : errno == ENOMEM ? JLT_ERR_NOMEM : JLT_ERR_IO;
    struct stat about;
    int reason;

    if (st == JLT_OK && stat(path, &about) == 0 && !S_ISREG(about.st_mode)) {
        if (access(path, W_OK) != 0) st = JLT_ERR_IO;
        if (S_ISDIR(about.st_mode)) {
            errno = EISDIR;
            st = JLT_ERR_IO;
        }
    } else if (st == JLT_OK && access(folder, W_OK | X_OK) != 0) {
        st = JLT_ERR_IO;
    }
    reason = errno;
    free(folder);
    free(target);
    errno = reason;
    return st;
}

bool jlt_file_ends(const char *path, const char *ending)
{
    const size_t length = strlen(path), part = strlen(ending);

    return length >= part && strcasecmp(path + length - part, ending) == 0;
}

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

bool jlt_file_same(const char *path, const char *other)
{
    char *a = follow(path), *b = follow(other), *a_folder = a == NULL ? NULL : folder_of(a);
    char *b_folder = b == NULL ? NULL : folder_of(b);
    struct stat of_a, of_b;
    bool same = false;

    if (a_folder != NULL && b_folder != NULL) {
        const bool has_a = stat(path, &of_a) == 0, has_b = stat(other, &of_b) == 0;
        if (has_a && has_b) same = S_ISREG(of_a.st_mode) && is_same(&of_a, &of_b);
        else if (!has_a && !has_b && stat(a_folder, &of_a) == 0 && stat(b_folder, &of_b) == 0)
            same = is_same(&of_a, &of_b) && strcmp(a + folder_length(a), b + folder_length(b)) == 0;
    }
    free(a_folder);
    free(b_folder);
    free(a);
    free(b);
    return same;
}
