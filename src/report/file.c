#include "report/file.h"

#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

static jlt_status write_device(const char *path, const char *data, size_t size)
{
    const int descriptor = open(path, O_WRONLY);
    bool good;

    if (descriptor < 0) return JLT_ERR_IO;
    good = write_all(descriptor, data, size);
    good = close(descriptor) == 0 && good;
    return good ? JLT_OK : JLT_ERR_IO;
}

/* On failure the temporary file is gone and errno is that of the failure. */
static jlt_status replace(const char *path, char *temporary, const char *data, size_t size)
{
    const mode_t mask = umask(0);
    const int descriptor = mkstemp(temporary);
    bool good;
    int reason;

    umask(mask);
    if (descriptor < 0) return JLT_ERR_IO;
    good = write_all(descriptor, data, size) && fchmod(descriptor, 0666 & ~mask) == 0 && fsync(descriptor) == 0;
    reason = errno;
    if (close(descriptor) != 0 && good) {
        good = false;
        reason = errno;
    }
    if (good && rename(temporary, path) == 0) return JLT_OK;
    if (good) reason = errno;
    unlink(temporary);
    errno = reason;
    return JLT_ERR_IO;
}

typedef enum { PLACE_FILE, PLACE_DEVICE, PLACE_FOLDER } place;

/* What stands at a path; a file that is not there yet is one. errno is set for a folder. */
static place place_of(const char *path)
{
    struct stat about;

    if (stat(path, &about) != 0 || S_ISREG(about.st_mode)) return PLACE_FILE;
    if (!S_ISDIR(about.st_mode)) return PLACE_DEVICE;
    errno = EISDIR;
    return PLACE_FOLDER;
}

jlt_status jlt_file_write(const char *path, const char *data, size_t size)
{
    static const char suffix[] = ".XXXXXX";
    const size_t length = strlen(path);
    const place at = place_of(path);
    sigset_t ending, before;
    char *temporary;
    jlt_status st;

    if (at == PLACE_FOLDER) return JLT_ERR_IO;
    if (at == PLACE_DEVICE) return write_device(path, data, size);
    temporary = malloc(length + sizeof suffix);
    if (temporary == NULL) return JLT_ERR_NOMEM;
    memcpy(temporary, path, length);
    memcpy(temporary + length, suffix, sizeof suffix);
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    sigaddset(&ending, SIGHUP);
    sigprocmask(SIG_BLOCK, &ending, &before);
    st = replace(path, temporary, data, size);
    {
        const int reason = errno;
        sigprocmask(SIG_SETMASK, &before, NULL);
        free(temporary);
        errno = reason;
    }
    return st;
}

jlt_status jlt_file_reachable(const char *path)
{
    const place at = place_of(path);

    if (at == PLACE_FOLDER) return JLT_ERR_IO;
    if (at == PLACE_DEVICE) return access(path, W_OK) == 0 ? JLT_OK : JLT_ERR_IO;
    char *copy = strdup(path);
    if (copy == NULL) return JLT_ERR_NOMEM;
    const bool good = access(dirname(copy), W_OK | X_OK) == 0;
    const int reason = errno;
    free(copy);
    errno = reason;
    return good ? JLT_OK : JLT_ERR_IO;
}
