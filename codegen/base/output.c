#include "base/output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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

ttc_text *ttc_output_add(ttc_output *output, const char *path)
{
    for (size_t i = 0; i < output->count; i++)
        if (strcmp(output->files[i].path, path) == 0) {
            output->failed = true;
            output->taken = output->files[i].path;
            return NULL;
        }
    if (output->count == output->capacity) {
        size_t capacity = output->capacity == 0 ? 16 : 2 * output->capacity;
        ttc_output_file *files = realloc(output->files, capacity * sizeof *files);
        output->failed |= files == NULL;
        if (files == NULL) return NULL;
        output->files = files;
        output->capacity = capacity;
    }
    size_t length = strlen(path) + 1;
    ttc_output_file *file = output->files + output->count;
    *file = (ttc_output_file){ .path = malloc(length) };
    output->failed |= file->path == NULL;
    if (file->path == NULL) return NULL;
    memcpy(file->path, path, length);
    output->count++;
    return &file->text;
}

/* FOLDER/PATH, with a suffix; to be freed. */
static char *join(const char *folder, const char *path, size_t path_length, const char *suffix)
{
    size_t length = strlen(folder) + path_length + strlen(suffix) + 2;
    char *joined = malloc(length);
    if (joined != NULL) snprintf(joined, length, "%s/%.*s%s", folder, (int)path_length, path, suffix);
    return joined;
}

static int make_folder(const char *path)
{
    if (mkdir(path, 0777) == 0) return 0;
    int error = errno;
    struct stat status;
    if (error == EEXIST && stat(path, &status) == 0) return S_ISDIR(status.st_mode) ? 0 : ENOTDIR;
    return error;
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

/* True when the file is there already with this content. */
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

typedef enum { STAGE, COMMIT, DISCARD } phase;

/* One phase for one file. An unchanged file has nothing staged, and is passed over. */
static int process(const ttc_output_file *file, const char *folder, phase what)
{
    const char *slash = strchr(file->path, '/');
    char *target = join(folder, file->path, strlen(file->path), "");
    char *staged = join(folder, file->path, strlen(file->path), ".new");
    char *parent = join(folder, file->path, slash == NULL ? 0 : (size_t)(slash - file->path), "");
    int error = target == NULL || staged == NULL || parent == NULL ? ENOMEM : 0;
    if (error == 0 && what == STAGE) {
        error = slash == NULL ? 0 : make_folder(parent);
        if (error == 0 && !is_unchanged(target, &file->text)) error = write_file(staged, &file->text);
    } else if (error == 0 && what == COMMIT) {
        if (!is_unchanged(target, &file->text) && rename(staged, target) != 0) error = errno;
    } else if (error == 0) {
        unlink(staged);
    }
    free(target);
    free(staged);
    free(parent);
    return error;
}

int ttc_output_write(const ttc_output *output, const char *folder, const char **where)
{
    /* Signals that end the program wait, so that none leaves staged files, or files of two versions. */
    sigset_t ending, before;
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    sigaddset(&ending, SIGHUP);
    sigprocmask(SIG_BLOCK, &ending, &before);
    *where = folder;
    int error = make_folder(folder);
    for (int what = STAGE; what <= COMMIT && error == 0; what++)
        for (size_t i = 0; i < output->count && error == 0; i++) {
            *where = output->files[i].path;
            error = process(output->files + i, folder, (phase)what);
        }
    if (error != 0)
        for (size_t i = 0; i < output->count; i++) process(output->files + i, folder, DISCARD);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return error;
}
