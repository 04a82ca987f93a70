#define _XOPEN_SOURCE 700 /* nftw */
#define _DEFAULT_SOURCE  /* flock */
#include "build/cache.h"
#include "base/sha256.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* Returns true if the user owns the file and nobody else may write to it. */
static bool is_private(const struct stat *found) { return found->st_uid == geteuid() && (found->st_mode & 022) == 0; }

/* Part of the name of every file and folder that is not yet an entry. */
#define UNFINISHED ".part"

static char *base_folder(ttc_text *message)
{
    const char *xdg = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    if (xdg != NULL && *xdg == '/') return strdup(xdg);
    if (home != NULL && *home == '/') return ttc_text_path(home, ".cache", "");
    ttc_text_add(message, "there is no place for compiled tables (expected HOME or XDG_CACHE_HOME to name a folder)");
    return NULL;
}

bool ttc_cache_open(ttc_cache *cache, ttc_text *message)
{
    struct stat found;
    *cache = (ttc_cache){ .lock = -1 };
    char *base = base_folder(message);
    if (base == NULL) return false;
    cache->folder = ttc_text_path(base, "jellett", "");
    /* Only the last two folders are created, so that a misspelt path above them is an error. */
    if (mkdir(base, 0700) != 0 && errno != EEXIST) goto failed;
    if (cache->folder == NULL || (mkdir(cache->folder, 0700) != 0 && errno != EEXIST)) goto failed;
    if (lstat(cache->folder, &found) != 0) goto failed;
    free(base);
    if (S_ISDIR(found.st_mode) && is_private(&found)) return true;
    ttc_text_format(message,
                    "the cache %s is not yours alone, so that nothing is loaded from it (expected a folder of your own that "
                    "no group and nobody else may write to: chmod go-w, or another XDG_CACHE_HOME)",
                    cache->folder);
    return false;
failed:
    ttc_text_format(message,
                    "cannot make the cache %s/jellett: %s (expected a folder that you may write to: XDG_CACHE_HOME names another)",
                    base, strerror(errno));
    free(base);
    return false;
}

void ttc_cache_close(ttc_cache *cache)
{
    if (cache->folder != NULL && cache->lock >= 0) close(cache->lock);
    free(cache->folder);
    *cache = (ttc_cache){ .lock = -1 };
}

char *ttc_cache_path(const ttc_cache *cache, const char *key) { return ttc_text_path(cache->folder, key, ".so"); }

enum { SEAL = 64 }; /* hexadecimal digits of SHA-256, at the end of the file, where the dynamic loader does not look */

/* Read a whole file into memory that the caller frees, with room for a key behind it. Returns NULL on failure. */
static char *read_all(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    struct stat found;
    char *bytes = NULL;
    if (file == NULL) return NULL;
    if (fstat(fileno(file), &found) == 0 && found.st_size > 0) bytes = malloc((size_t)found.st_size + SEAL);
    if (bytes != NULL) *length = fread(bytes, 1, (size_t)found.st_size, file);
    fclose(file);
    return bytes;
}

/* The digest of an object's content and its key, which is written behind the content. */
static void digest_of(char digest[SEAL + 1], char *bytes, size_t length, const char *key)
{
    memcpy(bytes + length, key, SEAL);
    ttc_sha256(digest, bytes, length + SEAL);
}

/* Append the digest to an object. */
static bool seal(const char *path, const char *key)
{
    char digest[SEAL + 1];
    size_t length = 0;
    char *bytes = read_all(path, &length);
    FILE *file = bytes == NULL ? NULL : fopen(path, "ab");
    if (bytes != NULL) digest_of(digest, bytes, length, key);
    free(bytes);
    if (file == NULL) return false;
    const bool written = fwrite(digest, 1, SEAL, file) == SEAL;
    return fclose(file) == 0 && written;
}

static bool is_whole(const char *path, const char *key)
{
    char digest[SEAL + 1], sealed[SEAL];
    size_t length = 0;
    char *bytes = read_all(path, &length);
    bool whole = bytes != NULL && length > SEAL;
    if (whole) {
        memcpy(sealed, bytes + length - SEAL, SEAL);
        digest_of(digest, bytes, length - SEAL, key);
        whole = memcmp(digest, sealed, SEAL) == 0;
    }
    free(bytes);
    return whole;
}

bool ttc_cache_has(const char *path, const char *key)
{
    struct stat found;
    if (lstat(path, &found) != 0 || !S_ISREG(found.st_mode) || !is_private(&found) || !is_whole(path, key)) return false;
    utimensat(AT_FDCWD, path, NULL, 0);
    return true;
}

/* There is one lock file for each first digit of a key, sixteen in all, so that they do not pile up. */
bool ttc_cache_lock(ttc_cache *cache, const char *key)
{
    char name[] = "lock-0";
    name[5] = *key;
    char *path = ttc_text_path(cache->folder, name, "");
    if (path == NULL) return false;
    cache->lock = open(path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    free(path);
    if (cache->lock < 0) return false;
    int result;
    do result = flock(cache->lock, LOCK_EX);
    while (result != 0 && errno == EINTR);
    return result == 0;
}

static int remove_entry(const char *path, const struct stat *found, int flag, struct FTW *walk)
{
    (void)found, (void)flag, (void)walk;
    return remove(path);
}

static void remove_tree(const char *path) { nftw(path, remove_entry, 16, FTW_DEPTH | FTW_PHYS); }

/* Remove unfinished work under all keys with this first digit: killed runs left it, as the caller holds the lock of these keys. */
static void clear_unfinished(const ttc_cache *cache, const char *key)
{
    DIR *open = opendir(cache->folder);
    for (struct dirent *entry; open != NULL && (entry = readdir(open)) != NULL;) {
        if (entry->d_name[0] != *key || strstr(entry->d_name, UNFINISHED) == NULL) continue;
        char *path = ttc_text_path(cache->folder, entry->d_name, "");
        if (path != NULL) remove_tree(path);
        free(path);
    }
    if (open != NULL) closedir(open);
}

/* The name is new every time, so that a compiler that outlives its run does not write into the folder of another run. */
char *ttc_cache_workshop(const ttc_cache *cache, const char *key)
{
    clear_unfinished(cache, key);
    char *path = ttc_text_path(cache->folder, key, UNFINISHED "-XXXXXX");
    if (path != NULL && mkdtemp(path) != NULL) return path;
    free(path);
    return NULL;
}

void ttc_cache_clear_workshop(char *workshop)
{
    if (workshop != NULL) remove_tree(workshop);
    free(workshop);
}

/* Flush a file to disk; done before it is renamed, so that an entry's name never leads to half an object. */
static bool flush(const char *path)
{
    const int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
    if (descriptor >= 0) close(descriptor);
    return flushed;
}

/* The object gets its final name last, when the temporary folder is gone: a run killed after that leaves nothing behind. */
bool ttc_cache_publish(const ttc_cache *cache, const char *key, const char *object, char *workshop)
{
    char *whole = ttc_text_path(cache->folder, key, UNFINISHED), *path = ttc_cache_path(cache, key);
    bool good = whole != NULL && path != NULL && seal(object, key) && chmod(object, 0700) == 0 && flush(object)
                && rename(object, whole) == 0;
    const int reason = errno;
    ttc_cache_clear_workshop(workshop);
    if (good) good = rename(whole, path) == 0;
    else errno = reason;
    free(whole);
    free(path);
    return good;
}

void ttc_cache_prune(const ttc_cache *cache, unsigned days)
{
    const time_t oldest = time(NULL) - (time_t)days * 24 * 60 * 60;
    DIR *open = opendir(cache->folder);
    for (struct dirent *entry; open != NULL && (entry = readdir(open)) != NULL;) {
        const size_t length = strlen(entry->d_name);
        struct stat found;
        if (length < 3 || strcmp(entry->d_name + length - 3, ".so") != 0) continue;
        char *path = ttc_text_path(cache->folder, entry->d_name, "");
        if (path != NULL && lstat(path, &found) == 0 && found.st_mtime < oldest) remove(path);
        free(path);
    }
    if (open != NULL) closedir(open);
}
