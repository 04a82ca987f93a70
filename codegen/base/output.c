#define _DEFAULT_SOURCE /* flock */
#include "base/output.h"

#include "base/array.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

void ttc_output_clear(ttc_output *output)
{
    for (size_t i = 0; i < output->count; i++) {
        free(output->files[i].path);
        ttc_text_clear(&output->files[i].text);
    }
    free(output->files);
    *output = (ttc_output){ 0 };
}

/* Whether two paths are one, or differ only by '/' in place of '_', which makes names in C one. */
static bool is_one(const char *a, const char *b)
{
    while (*a != '\0' && (*a == *b || ((*a == '/' || *a == '_') && (*b == '/' || *b == '_')))) a++, b++;
    return *a == *b;
}

ttc_text *ttc_output_add(ttc_output *output, const char *path)
{
    for (size_t i = 0; i < output->count; i++)
        if (is_one(output->files[i].path, path)) {
            output->failed = true;
            output->taken = output->files[i].path;
            return NULL;
        }
    output->failed |= !TTC_ARRAY_GROW(output->files, output->count);
    if (output->failed) return NULL;
    size_t length = strlen(path) + 1;
    ttc_output_file *file = output->files + output->count;
    *file = (ttc_output_file){ .path = malloc(length) };
    output->failed |= file->path == NULL;
    if (file->path == NULL) return NULL;
    memcpy(file->path, path, length);
    output->count++;
    return &file->text;
}

/* FOLDER/PATH followed by a suffix, for the caller to free; NULL when memory is out. */
static char *join(const char *folder, const char *path, size_t path_length, const char *suffix)
{
    size_t length = strlen(folder) + path_length + strlen(suffix) + 2;
    char *joined = malloc(length);
    if (joined != NULL) snprintf(joined, length, "%s/%.*s%s", folder, (int)path_length, path, suffix);
    return joined;
}

/* Create a folder unless it exists. *made says whether it was created. Returns 0 or an errno. */
static int make_folder(const char *path, bool *made)
{
    *made = mkdir(path, 0777) == 0;
    if (*made) return 0;
    int error = errno;
    struct stat status;
    if (error == EEXIST && stat(path, &status) == 0) return S_ISDIR(status.st_mode) ? 0 : ENOTDIR;
    return error;
}

/* Wait until no other run writes below the folder: two at once would leave files of both. Only while it waits are the signals of
 * `before` unblocked: they may end this run, which has written nothing. Returns a descriptor that holds the lock until it is
 * closed, or without one where the file system has no locks; -1: the folder cannot be read, and is not locked. */
static int lock(const char *folder, const sigset_t *before)
{
    const int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    sigset_t blocked;
    if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return descriptor;
    pthread_sigmask(SIG_SETMASK, before, &blocked);
    while (flock(descriptor, LOCK_EX) != 0 && errno == EINTR) continue;
    pthread_sigmask(SIG_SETMASK, &blocked, NULL);
    return descriptor;
}

static int write_bytes(int descriptor, const ttc_text *text)
{
    size_t written = 0;
    while (written < text->length) {
        ssize_t n = write(descriptor, text->bytes + written, text->length - written);
        if (n < 0 && errno != EINTR) return errno;
        if (n > 0) written += (size_t)n;
    }
    return fsync(descriptor) == 0 ? 0 : errno;
}

static int write_file(const char *path, const ttc_text *text)
{
    int descriptor = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (descriptor < 0) return errno;
    int error = write_bytes(descriptor, text);
    if (close(descriptor) != 0 && error == 0) error = errno;
    return error;
}

/* Returns true if the file exists and has exactly this content. */
static bool is_unchanged(const char *path, const ttc_text *text)
{
    FILE *file = fopen(path, "rb");
    char buffer[4096];
    size_t at = 0, n = 0;
    bool same = file != NULL;
    while (same && (n = fread(buffer, 1, sizeof buffer, file)) > 0) {
        same = n <= text->length - at && memcmp(buffer, text->bytes + at, n) == 0;
        at += n;
    }
    same = same && !ferror(file) && at == text->length;
    if (file != NULL) fclose(file);
    return same;
}

/* The names and the progress of one file that is replaced. Its former content stays under `kept` until all files are in place. */
typedef struct {
    char *target, *staged, *kept, *parent;
    bool makes_parent, is_staged, is_kept, is_committed;
} passage;

static bool begin(passage *p, const ttc_output_file *file, const char *folder)
{
    const char *slash = strchr(file->path, '/');
    size_t length = strlen(file->path);
    p->target = join(folder, file->path, length, "");
    p->staged = join(folder, file->path, length, ".new");
    p->kept = join(folder, file->path, length, ".old");
    if (slash != NULL) p->parent = join(folder, file->path, (size_t)(slash - file->path), "");
    return p->target != NULL && p->staged != NULL && p->kept != NULL && (slash == NULL || p->parent != NULL);
}

static int stage(passage *p, const ttc_output_file *file)
{
    struct stat status;
    int error = p->parent == NULL ? 0 : make_folder(p->parent, &p->makes_parent);
    if (error != 0) return error;
    if (stat(p->target, &status) == 0 && !S_ISREG(status.st_mode)) return S_ISDIR(status.st_mode) ? EISDIR : EEXIST;
    if (is_unchanged(p->target, &file->text)) return 0;
    p->is_staged = true;
    return write_file(p->staged, &file->text);
}

/* Move the new file into place. The old file first gets a second name by a hard link, so that `target` always names a file; where
 * the file system has no hard links, the old file is renamed instead. */
static int commit(passage *p)
{
    if (!p->is_staged) return 0;
    unlink(p->kept);
    p->is_kept = link(p->target, p->kept) == 0;
    if (!p->is_kept && errno != ENOENT) p->is_kept = rename(p->target, p->kept) == 0;
    if (!p->is_kept && errno != ENOENT) return errno;
    p->is_committed = rename(p->staged, p->target) == 0;
    return p->is_committed ? 0 : errno;
}

/* Undo what was done for this file. Returns false if the old content could not be put back. */
static bool roll_back(const passage *p)
{
    bool ok = true;
    if (p->is_kept) ok = rename(p->kept, p->target) == 0;
    else if (p->is_committed) ok = unlink(p->target) == 0;
    /* rename does nothing when both names are hard links to one file: `kept` must be removed. */
    if (p->is_kept) unlink(p->kept);
    if (p->is_staged) unlink(p->staged);
    return ok;
}

static void end(passage *p)
{
    free(p->target);
    free(p->staged);
    free(p->kept);
    free(p->parent);
}

static int write_all(const ttc_output *output, const char *folder, const sigset_t *before, passage *passages, const char **where,
                     bool *restored)
{
    bool makes_folder = false;
    *where = folder;
    int error = make_folder(folder, &makes_folder);
    const int held = error == 0 ? lock(folder, before) : -1;
    for (size_t i = 0; i < output->count && error == 0; i++) {
        *where = output->files[i].path;
        error = begin(passages + i, output->files + i, folder) ? stage(passages + i, output->files + i) : ENOMEM;
    }
    for (size_t i = 0; i < output->count && error == 0; i++) {
        *where = output->files[i].path;
        error = commit(passages + i);
    }
    for (size_t i = output->count; i-- > 0;) {
        if (passages[i].target == NULL) continue;
        if (error != 0) *restored &= roll_back(passages + i);
        else if (passages[i].is_kept) unlink(passages[i].kept);
        if (error != 0 && passages[i].makes_parent) rmdir(passages[i].parent);
    }
    if (error != 0 && makes_folder) rmdir(folder);
    if (held >= 0) close(held);
    return error;
}

int ttc_output_write(const ttc_output *output, const char *folder, const char **where, bool *restored)
{
    /* Block all signals until the files are consistent: none leaves temporary files, or a mix of two versions. */
    sigset_t all, before;
    sigfillset(&all);
    *where = folder;
    *restored = true;
    passage *passages = calloc(output->count + 1, sizeof *passages);
    if (passages == NULL) return ENOMEM;
    pthread_sigmask(SIG_BLOCK, &all, &before);
    int error = write_all(output, folder, &before, passages, where, restored);
    for (size_t i = 0; i < output->count; i++) end(passages + i);
    free(passages);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return error;
}

static struct {
    const char *program;
    int status;
} unwritten;

static void close_standard_output(void)
{
    const bool failed = ferror(stdout) != 0;
    if (fclose(stdout) == 0 && !failed) return;
    fprintf(stderr, "%s: cannot write to standard output: %s\n", unwritten.program, strerror(errno));
    _exit(unwritten.status);
}

bool ttc_output_standard(const char *program, int status)
{
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; descriptor++)
        if (fcntl(descriptor, F_GETFD) < 0
            && open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) return false;
    unwritten.program = program;
    unwritten.status = status;
    return atexit(close_standard_output) == 0;
}
