/* ttc build: makes a shared object of a table's kernels, or finds it in the cache. */
#include "build/cache.h"
#include "build/compile.h"
#include "base/executable.h"
#include "base/sha256.h"
#include "command/command.h"
#include "command/command_guard.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { DAYS_UNUSED = 90 };

/* Append what identifies a file without reading it; NULL: there is none. */
static void add_identity(ttc_text *key, const char *path)
{
    struct stat found;
    if (path != NULL && stat(path, &found) == 0)
        ttc_text_format(key, "%s %lld %lld.%09ld\n", path, (long long)found.st_size, (long long)found.st_mtim.tv_sec,
                        found.st_mtim.tv_nsec);
}

/* A digest of all that determines the object: ttc, QEPCAD and the limits of proofs, on which verdicts depend, the compiler, flags,
 * the table, its file's name, by which others lead back to it, and the tables that its claims lead to. Returns false if one of the
 * latter is wrong: its errors must be reported again. */
static bool make_key(char digest[65], const ttc_model *model, const char *compiler, unsigned lanes)
{
    bool good = true;
    char *qepcad = ttc_executable_find("qepcad");
    ttc_text key = { 0 };
    ttc_text_format(&key, "ttc %s\n%s\n%s\n%u MiB, %u s\n", JLT_VERSION, ttc_model_base_name(model), model->sha256,
                    ttc_guard_memory(), ttc_guard_processor(TTC_GUARD_SECONDS));
    ttc_compiler_add_flags(&key, lanes);
    add_identity(&key, "/proc/self/exe");
    add_identity(&key, qepcad);
    add_identity(&key, compiler);
    /* Arb's headers, where Debian has them: without them there are no kernels on balls. */
    add_identity(&key, "/usr/include/arb.h");
    add_identity(&key, "/usr/include/flint/arb.h");
    for (size_t i = 0; i < model->claim_count; i++) {
        if (model->claims[i].target == NULL) continue;
        ttc_diagnostics *diagnostics = ttc_diagnostics_create();
        ttc_model *target = diagnostics == NULL ? NULL : ttc_resolve_beside(NULL, model, model->claims[i].target, diagnostics);
        const bool is_broken = diagnostics == NULL || ttc_error_count(diagnostics) > ttc_io_error_count(diagnostics);
        ttc_text_format(&key, "%s\n", target != NULL ? target->sha256 : is_broken ? "broken" : "none");
        good &= !is_broken;
        ttc_model_destroy(target);
        ttc_diagnostics_destroy(diagnostics);
    }
    ttc_sha256(digest, ttc_text_string(&key), key.length);
    ttc_text_clear(&key);
    free(qepcad);
    return good;
}

static int fail(int code, const char *format, const char *what)
{
    fputs("ttc: ", stderr);
    fprintf(stderr, format, what);
    fputc('\n', stderr);
    return code;
}

static int cannot(const ttc_cache *cache, const char *what)
{
    fprintf(stderr, "ttc: cannot %s the cache %s: %s (expected a folder of your own with room: XDG_CACHE_HOME names another)\n",
            what, cache->folder, strerror(errno));
    return TTC_EXIT_IO;
}

/* Change the key to one that no other run looks for, with the same first digit, whose lock is held. */
static void make_passing(char key[65])
{
    const char first = key[0];
    ttc_text text = { 0 };
    struct timespec now = { 0 };
    clock_gettime(CLOCK_REALTIME, &now);
    ttc_text_format(&text, "%s %lld.%09ld %ld", key, (long long)now.tv_sec, now.tv_nsec, (long)getpid());
    ttc_sha256(key, ttc_text_string(&text), text.length);
    ttc_text_clear(&text);
    key[0] = first;
}

/* Make the object in a folder of its own, and publish it: where the system ended a proof, for this run alone. In/out: key, path,
 * those under which it is. */
static int make(ttc_cache *cache, char key[65], char **path, ttc_model *model, const char *compiler, const ttc_options *options)
{
    bool passing = false;
    ttc_options generate = *options;
    ttc_text object = { 0 };
    char *workshop = ttc_cache_workshop(cache, key);
    if (workshop == NULL) return cannot(cache, "write to");
    ttc_text_format(&object, "%s/kernels.so", workshop);
    generate.out = workshop;
    generate.unproved = true;
    generate.extent = TTC_WITHOUT_ELIMINATIONS;
    int status = object.failed ? TTC_EXIT_MEMORY : ttc_command_generate_models(&model, 1, &generate, &passing);
    if (status == TTC_EXIT_DONE && !ttc_compile_folder(compiler, workshop, options->lanes, object.bytes))
        status = fail(TTC_EXIT_IO, "the C compiler %s makes no shared object; what it says of it, if anything, is above", compiler);
    if (status == TTC_EXIT_DONE && passing) {
        make_passing(key);
        free(*path);
        *path = ttc_cache_path(cache, key);
        if (*path == NULL) status = TTC_EXIT_MEMORY;
    }
    if (status != TTC_EXIT_DONE) ttc_cache_clear_workshop(workshop);
    else if (!ttc_cache_publish(cache, key, object.bytes, workshop))
        status = cannot(cache, "write to");
    ttc_text_clear(&object);
    ttc_cache_prune(cache, DAYS_UNUSED);
    return status;
}

/* *path: that of the object, for the caller to free. */
static int find_or_make(ttc_cache *cache, ttc_model *model, const char *compiler, const ttc_options *options, char **path)
{
    char key[65];
    const bool is_known = make_key(key, model, compiler, options->lanes);
    *path = ttc_cache_path(cache, key);
    if (*path == NULL) return TTC_EXIT_MEMORY;
    if (is_known && ttc_cache_has(*path, key)) return TTC_EXIT_DONE;
    if (!ttc_cache_lock(cache, key)) return cannot(cache, "lock");
    if (is_known && ttc_cache_has(*path, key)) return TTC_EXIT_DONE; /* another run made it while this one waited */
    return make(cache, key, path, model, compiler, options);
}

int ttc_command_build(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    ttc_cache cache = { .lock = -1 };
    ttc_text message = { 0 };
    char *compiler = NULL, *path = NULL;
    if (options->file_count != 1) return fail(TTC_EXIT_USAGE, "build takes one table, not '%s' as well", options->files[1]);
    ttc_model *model = ttc_command_read(options->files[0], &status, NULL);
    if (model == NULL) return status;
    compiler = ttc_compiler_find();
    if (compiler == NULL)
        status = fail(TTC_EXIT_IO, "there is no C compiler '%s' to compile kernels with: install gcc or clang, or name one by "
                                   "CC, without options",
                      getenv("CC") != NULL ? getenv("CC") : "cc");
    else if (!ttc_cache_open(&cache, &message)) status = fail(TTC_EXIT_IO, "%s", ttc_text_string(&message));
    else status = find_or_make(&cache, model, compiler, options, &path);
    if (status == TTC_EXIT_DONE) puts(path);
    else if (status == TTC_EXIT_MEMORY) fputs("ttc: out of memory\n", stderr);
    free(path);
    free(compiler);
    ttc_text_clear(&message);
    ttc_cache_close(&cache);
    ttc_model_destroy(model);
    return status;
}
