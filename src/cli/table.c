#include "cli/table.h"

#include "base/sha256.h"
#include "base/source.h"
#include "cli/interrupt.h"
#include "cli/program.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "kernel/load.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { LOADED_MAX = 64 };

bool jlt_table_is_named(const char *path)
{
    const size_t length = strlen(path);

    return length > 3 && strcmp(path + length - 3, ".tt") == 0;
}

bool jlt_table_is_file(const char *model) { return strchr(model, '/') != NULL || jlt_table_is_named(model); }

static jlt_exit no_model(const char *model)
{
    fprintf(stderr, "jellett: there is no model '%s' built in; there are", model);
    for (size_t i = 0, shown = 0; i < jlt_descriptor_count(); i++) {
        const jlt_descriptor *d = jlt_descriptor_at(i);
        if (i > 0 && strcmp(d->model, jlt_descriptor_at(i - 1)->model) == 0) continue;
        fprintf(stderr, "%s %s", shown++ == 0 ? "" : ",", d->model);
    }
    fputs(" ('jellett models' tells more; a table of your own is named by its file, ./my.tt)\n", stderr);
    return JLT_EXIT_INPUT;
}

/* In the child: run the ttc beside this program, else the one in $PATH. */
static _Noreturn void run_ttc(const char *table, bool lanes, int output, int error)
{
    char path[PATH_MAX], option[] = "--lanes=0";
    const char *const arguments[] = { "ttc", "build", lanes ? option : "--", lanes ? "--" : table, lanes ? table : NULL, NULL };

    option[sizeof option - 2] = (char)('0' + jlt_batch_isa_lanes());
    dup2(output, STDOUT_FILENO);
    dup2(error, STDERR_FILENO);
    if (jlt_program_beside(path, sizeof path, "ttc")) execv(path, (char *const *)arguments);
    execvp("ttc", (char *const *)arguments);
    _exit(127);
}

/* Read the child's output to its end: one line, which is kept without its last newline, as folders may have newlines in names. */
static void read_line(char *line, size_t size, int from)
{
    size_t used = 0;
    ssize_t got = 1;

    while (got != 0 && used + 1 < size) {
        got = read(from, line + used, size - 1 - used);
        if (got < 0 && errno != EINTR) break;
        if (got > 0) used += (size_t)got;
    }
    if (used > 0 && line[used - 1] == '\n') used--;
    line[used] = '\0';
}

/* Pass on everything that the child writes to standard error. Returns whether it wrote anything. */
static bool pass_on(int from)
{
    char words[4096];
    bool has_said = false;
    ssize_t got = 1;

    while (got != 0) {
        got = read(from, words, sizeof words);
        if (got < 0 && errno != EINTR) break;
        if (got <= 0) continue;
        fwrite(words, 1, (size_t)got, stderr);
        has_said = true;
    }
    return has_said;
}

/* Run `ttc build`. Out: path, that of the shared object; *has_said: ttc wrote messages, such as which claims are not proved. */
static jlt_exit build(char *path, size_t size, bool *has_said, const char *table, bool lanes)
{
    int ends[2], words[2], status = 0;
    pid_t child;

    if (pipe2(ends, O_CLOEXEC) != 0) return jlt_command_fail(JLT_EXIT_IO, "no pipe to ttc: %s", strerror(errno));
    if (pipe2(words, O_CLOEXEC) != 0) {
        close(ends[0]);
        close(ends[1]);
        return jlt_command_fail(JLT_EXIT_IO, "no pipe to ttc: %s", strerror(errno));
    }
    child = jlt_interrupt_fork();
    if (child == 0) run_ttc(table, lanes, ends[1], words[1]);
    close(ends[1]);
    close(words[1]);
    *has_said = child > 0 && pass_on(words[0]);
    if (child > 0) read_line(path, size, ends[0]);
    close(ends[0]);
    close(words[0]);
    if (child < 0) return jlt_command_fail(JLT_EXIT_IO, "ttc cannot be started: %s", strerror(errno));
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    const int raised = jlt_interrupt_alone();
    if (raised != 0) {
        fprintf(stderr, "jellett: interrupted while %s was compiled; nothing was computed\n", table);
        jlt_interrupt_end(raised);
    }
    if (!WIFEXITED(status)) return jlt_command_fail(JLT_EXIT_NUMERICAL, "ttc was ended by signal %d", WTERMSIG(status));
    if (WEXITSTATUS(status) == 127)
        return jlt_command_fail(JLT_EXIT_IO, "ttc, which compiles tables, is neither beside this program nor in $PATH");
    return WEXITSTATUS(status) == 0 ? JLT_EXIT_DONE : (jlt_exit)WEXITSTATUS(status);
}

/* The tables that this process, or the one that forked it, has loaded. They make sure that one process and its children use one
 * text of a table, even if the file changes. */
static struct {
    char *table;
    bool lanes;
    const jlt_descriptor *descriptor;
} loaded[LOADED_MAX];
static size_t loaded_count;

/* Find a loaded table. Out: *descriptor, if it was loaded with the same `lanes`, else NULL. Returns it with any lanes, or NULL. */
static const jlt_descriptor *find_loaded(const jlt_descriptor **descriptor, const char *table, bool lanes)
{
    const jlt_descriptor *any = NULL;

    *descriptor = NULL;
    for (size_t i = 0; i < loaded_count; i++) {
        if (strcmp(loaded[i].table, table) != 0) continue;
        any = loaded[i].descriptor;
        if (loaded[i].lanes == lanes) *descriptor = any;
    }
    return any;
}

/* Whether both are of one text, whose records lead to the same texts: a table of coordinates has no descriptor of its own. */
static bool is_of_one_text(const jlt_descriptor *a, const jlt_descriptor *b)
{
    const jlt_claim *one = a->claims, *other = b->claims;

    if (strcmp(a->sha256, b->sha256) != 0) return false;
    for (; one->kind != NULL && other->kind != NULL; one++, other++)
        if (strcmp(one->target != NULL ? one->target : "", other->target != NULL ? other->target : "") != 0) return false;
    return one->kind == other->kind;
}

static jlt_exit was_edited(const char *table)
{
    return jlt_command_fail(JLT_EXIT_IO, "%s was edited after this computation had begun with it: begin again", table);
}

static jlt_exit load(const jlt_descriptor **descriptor, bool *has_said, const char *table, bool lanes)
{
    const jlt_descriptor *before = find_loaded(descriptor, table, lanes);
    char path[PATH_MAX];
    jlt_status st;

    if (*descriptor != NULL) return JLT_EXIT_DONE;
    JLT_PASS(build(path, sizeof path, has_said, table, lanes));
    st = jlt_load(descriptor, path);
    if (st == JLT_ERR_UNSUPPORTED)
        return jlt_command_fail(JLT_EXIT_IO, "the kernels of %s cannot be loaded from %s: ttc is of another version than this "
                                             "program", table, path);
    if (st != JLT_OK)
        return jlt_command_fail(JLT_EXIT_IO, "the kernels of %s cannot be loaded: %s (XDG_CACHE_HOME names another folder for "
                                             "them)", table, dlerror());
    if (before != NULL && !is_of_one_text(*descriptor, before)) return was_edited(table);
    char *name = loaded_count < LOADED_MAX ? strdup(table) : NULL;
    if (name != NULL) {
        loaded[loaded_count].table = name;
        loaded[loaded_count].lanes = lanes;
        loaded[loaded_count++].descriptor = *descriptor;
    }
    return JLT_EXIT_DONE;
}

jlt_exit jlt_table_open(const jlt_descriptor **descriptor, bool *has_said, const char *model, bool lanes)
{
    *descriptor = NULL;
    *has_said = false;
    if (jlt_table_is_file(model)) return load(descriptor, has_said, model, lanes);
    *descriptor = jlt_descriptor_find(model, NULL, NULL, NULL);
    return *descriptor != NULL ? JLT_EXIT_DONE : no_model(model);
}

/* The path of FILE in the folder of the table that names it. Returns false if the path is too long. */
static bool beside(char *path, size_t size, const char *table, const char *file)
{
    const char *slash = strrchr(table, '/');
    const int length = slash != NULL ? (int)(slash - table) + 1 : 0;
    const int used = snprintf(path, size, "%.*s%s", length, table, file);

    return used > 0 && (size_t)used < size;
}

/* The files that this process, or the one that forked it, has looked for beside tables, with their digests at that time; "": no
 * file. So one process and its children use one text of each table, also if it is built in, and of each table of coordinates. */
static struct {
    char *path, digest[65];
} seen[LOADED_MAX];
static size_t seen_count;

static void read_digest(char digest[65], const char *path)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    size_t length;
    char *text = diagnostics != NULL ? ttc_source_read(path, &length, diagnostics) : NULL;

    digest[0] = '\0';
    if (text != NULL) ttc_sha256(digest, text, length);
    free(text);
    ttc_diagnostics_destroy(diagnostics);
}

/* Whether there is a file of this name and digest beside the table `model`. */
static bool is_beside(const char *model, const char *file, const char *sha256)
{
    char path[PATH_MAX], digest[65];
    size_t i = 0;

    if (!beside(path, sizeof path, model, file)) return false;
    while (i < seen_count && strcmp(seen[i].path, path) != 0) i++;
    if (i < seen_count) return strcmp(seen[i].digest, sha256) == 0;
    read_digest(digest, path);
    if (seen_count < LOADED_MAX && (seen[seen_count].path = strdup(path)) != NULL)
        memcpy(seen[seen_count++].digest, digest, sizeof digest);
    return strcmp(digest, sha256) == 0;
}

/* Whether a built-in table may stand for its copy beside `model`: the tables that its records lead to, and theirs, and so on, are
 * beside `model` with the digests of which the records were proved. Embeddings lead back to larger tables, and rest on none. */
static bool stands_for(const jlt_descriptor *built_in, const char *model)
{
    const jlt_descriptor *reached[JLT_WAY_TABLES_MAX] = { built_in };
    unsigned count = 1, k;

    for (unsigned done = 0; done < count; done++)
        for (const jlt_claim *claim = reached[done]->claims; claim->kind != NULL; claim++) {
            if (claim->target == NULL || strcmp(claim->kind, "embedding") == 0) continue;
            if (!is_beside(model, claim->file, claim->target)) return false;
            const jlt_descriptor *next = jlt_way_target(&(jlt_way){ .sha256 = claim->target }, NULL);
            for (k = 0; k < count && reached[k] != next; k++) { }
            if (next == NULL || k < count) continue;
            if (count == JLT_WAY_TABLES_MAX) return false;
            reached[count++] = next;
        }
    return true;
}

/* Whether a built-in table may be used as a claim's target: the way that the claim defines holds, if it defines one, which for a
 * larger table includes its reduction to `from` itself, and the table's own records hold beside `model` too. */
static bool may_stay(const jlt_descriptor *from, const jlt_claim *claim, const jlt_way *way, const char *model)
{
    const jlt_descriptor *built_in = jlt_way_target(&(jlt_way){ .sha256 = claim->target }, NULL);
    const jlt_claim *broken;

    return built_in != NULL && (way == NULL || jlt_way_holds(&broken, from, way, built_in)) && stands_for(built_in, model);
}

/* Whether a proved claim leads to a table that may serve: by a way, or, where reductions are asked for, by a reduction onto it that
 * has no condition. Out: *way, NULL if it defines none. */
static bool leads(const jlt_way **way, const jlt_descriptor *from, const jlt_claim *claim, const char *kind)
{
    *way = jlt_way_of(from, claim);
    if (claim->target == NULL || claim->verdict != JLT_PROVED || (kind != NULL && strcmp(claim->kind, kind) != 0)) return false;
    return *way != NULL || (kind != NULL && claim->condition[0] == '\0');
}

jlt_exit jlt_table_others(jlt_way_tables *others, const jlt_descriptor *of, const char *model, const char *kind, bool lanes)
{
    const jlt_descriptor *next = of;

    *others = (jlt_way_tables){ .count = 0 };
    for (unsigned done = 0; jlt_table_is_file(model) && next != NULL; next = done < others->count ? others->tables[done++] : NULL)
        for (const jlt_claim *claim = next->claims; claim->kind != NULL && others->count < JLT_WAY_TABLES_MAX; claim++) {
            const jlt_way *way;
            char path[PATH_MAX];
            bool has_said = true; /* of a table that was loaded before */
            if (!leads(&way, next, claim, kind) || jlt_way_among(others, claim->target) != NULL) continue;
            if (may_stay(next, claim, way, model)) continue;
            if (!beside(path, sizeof path, model, claim->file))
                return jlt_command_fail(JLT_EXIT_IO, "%s: the path is too long", claim->file);
            JLT_PASS(load(&others->tables[others->count], &has_said, path, lanes));
            if (strcmp(others->tables[others->count]->sha256, claim->target) != 0) return was_edited(path);
            if (!has_said) jlt_command_warn_unproved(others->tables[others->count]);
            others->count++;
        }
    return JLT_EXIT_DONE;
}

jlt_status jlt_table_of(const jlt_descriptor **out, jlt_way_tables *others, const char *model)
{
    *out = NULL;
    if (!jlt_table_is_file(model)) {
        *out = jlt_descriptor_find(model, NULL, NULL, NULL);
        return *out != NULL ? JLT_OK : JLT_ERR_EMPTY;
    }
    jlt_exit code = jlt_table_open(out, &(bool){ false }, model, false);
    if (code == JLT_EXIT_DONE) code = jlt_table_others(others, *out, model, "reduction", false);
    switch (code) {
    case JLT_EXIT_DONE: return JLT_OK;
    case JLT_EXIT_IO: return JLT_ERR_IO;
    case JLT_EXIT_NUMERICAL: return JLT_ERR_NO_CONVERGENCE; /* not NOMEM, which the scene would report as its own */
    default: return JLT_ERR_ARG;
    }
}
