/* Small claims against which provers fail, each with the verdict that it must get: tests/proof/claims/THEME.tt holds tables
 * one after another, and a line that holds a claim ends in
 *
 *     # VERDICT: why
 *
 * VERDICT being proved, "proved alone" (without the solver), refuted, unsettled, "not proved" or "not refuted". The last two
 * stand where a decision would be sound but is beyond what can be expected, or where it may be refused as well. A table NAME is
 * the target NAME.tt of the reductions in its file. Every table runs in a process of its own, under limits of processor time
 * and memory. */
#include "prove_text.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SECONDS = 60, MEBIBYTES = 2048, LEAST_CLAIMS = 150 };

typedef struct {
    const char *text, *file;
    size_t length;
    unsigned first_line; /* of the table in its file */
} table;

typedef struct {
    size_t claims, mismatches;
} tally;

static char *read_all(const char *path)
{
    FILE *file = fopen(path, "rb");
    long size;
    assert_non_null(file);
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    size = ftell(file);
    rewind(file);
    char *text = calloc((size_t)size + 1, 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, (size_t)size, file), size);
    fclose(file);
    return text;
}

/* The next line that opens a table, or the end of the text. */
static const char *next_table(const char *text)
{
    if (strncmp(text, "model ", 6) == 0) return text;
    const char *found = strstr(text, "\nmodel ");
    return found != NULL ? found + 1 : text + strlen(text);
}

static ttc_model *parse(const char *text, size_t length, const char *path, bool print)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(text, length, path, diagnostics);
    if (model == NULL && print) ttc_diagnostics_print(diagnostics, stderr);
    ttc_diagnostics_destroy(diagnostics);
    return model;
}

/* NAME.tt is the table of that name in the same file; context is the file's text. */
static ttc_model *resolve_in_file(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    size_t length = strlen(target) - strlen(".tt");
    const char *text = next_table(context);
    (void)diagnostics;
    while (*text != '\0') {
        const char *end = next_table(text + 1);
        if (strncmp(text + strlen("model "), target, length) == 0 && text[strlen("model ") + length] == '\n')
            return parse(text, (size_t)(end - text), model->file, true);
        text = end;
    }
    return NULL;
}

static bool agrees(const char *verdict, const ttc_proof *proof)
{
    const struct {
        const char *verdict;
        bool allowed[3]; /* by ttc_proof_status */
    } verdicts[] = {
        { "proved", { [TTC_PROVED] = true } },
        { "proved alone", { [TTC_PROVED] = !proof->relies_on_solver } },
        { "refuted", { [TTC_REFUTED] = true } },
        { "unsettled", { [TTC_UNSETTLED] = true } },
        { "not proved", { [TTC_REFUTED] = true, [TTC_UNSETTLED] = true } },
        { "not refuted", { [TTC_PROVED] = true, [TTC_UNSETTLED] = true } },
    };
    for (size_t i = 0; i < sizeof verdicts / sizeof *verdicts; i++)
        if (strcmp(verdict, verdicts[i].verdict) == 0) return verdicts[i].allowed[proof->status];
    fail_msg("'%s' is no verdict", verdict);
    return false;
}

/* The verdict and the reason that the line gives; false when it gives none. */
static bool read_mark(const table *t, uint32_t line, char verdict[32], char reason[256])
{
    const char *start = t->text, *end, *mark, *colon;
    for (uint32_t i = 1; i < line; i++) start = strchr(start, '\n') + 1;
    end = strchr(start, '\n');
    mark = memchr(start, '#', (size_t)(end - start));
    if (mark == NULL) return false;
    colon = memchr(mark, ':', (size_t)(end - mark));
    assert_non_null(colon);
    snprintf(verdict, 32, "%.*s", (int)(colon - mark - 2), mark + 2);
    snprintf(reason, 256, "%.*s", (int)(end - colon - 2), colon + 2);
    return true;
}

static size_t marks(const table *t)
{
    size_t count = 0;
    for (const char *line = t->text; line < t->text + t->length; line = strchr(line, '\n') + 1) {
        const char *mark = memchr(line, '#', (size_t)(strchr(line, '\n') - line));
        count += mark != NULL && mark > line;
    }
    return count;
}

/* In a process of its own. Returns how many claims got another verdict than they must. */
static size_t check_table(const table *t, char *file_text)
{
    ttc_proof_report *report = NULL;
    size_t wrong = 0, seen = 0;
    ttc_model *model = parse(t->text, t->length, t->file, true);
    if (model == NULL) fprintf(stderr, "%s:%u: the table from this line on cannot be read\n", t->file, t->first_line);
    if (model == NULL) return marks(t);
    if (!ttc_prove(model, resolve_in_file, file_text, TTC_PROVE_ALL, &report)) return marks(t);
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = &report->proofs[i];
        char verdict[32], reason[256];
        if (!read_mark(t, proof->place.line, verdict, reason)) continue;
        seen++;
        if (agrees(verdict, proof)) continue;
        wrong++;
        fprintf(stderr, "%s:%u: %s %s: %s, but it is %s: %s\n    (%s)\n", t->file, t->first_line + proof->place.line - 1,
                proof->kind, proof->name, ttc_proof_status_name(proof->status), verdict, reason,
                proof->remainder != NULL ? proof->remainder : "no remainder");
    }
    if (seen != marks(t))
        fprintf(stderr, "%s:%u: %zu verdicts stand on lines without a claim\n", t->file, t->first_line, marks(t) - seen);
    return wrong + marks(t) - seen;
}

static tally check_apart(const table *t, char *file_text)
{
    tally result = { .claims = marks(t) };
    int status = 0, ends[2];
    assert_int_equal(pipe(ends), 0);
    fflush(NULL);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        const struct rlimit memory = { (rlim_t)MEBIBYTES << 20, (rlim_t)MEBIBYTES << 20 };
#ifndef JLT_SANITIZED
        setrlimit(RLIMIT_AS, &memory); /* the sanitizer maps more than any limit */
#else
        (void)memory;
#endif
        setrlimit(RLIMIT_CPU, &(struct rlimit){ SECONDS, SECONDS }); /* a busy machine fails no table */
        size_t wrong = check_table(t, file_text);
        _exit(write(ends[1], &wrong, sizeof wrong) == sizeof wrong ? 0 : 1);
    }
    close(ends[1]);
    bool told = read(ends[0], &result.mismatches, sizeof result.mismatches) == sizeof result.mismatches;
    close(ends[0]);
    assert_int_equal(waitpid(child, &status, 0), child);
    if (!told || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        print_error("%s:%u: the table did not end under %d s of a processor and %d MiB (status %d)\n", t->file, t->first_line,
                    SECONDS, MEBIBYTES, status);
        result.mismatches = result.claims;
    }
    return result;
}

static tally check_file(const char *path)
{
    tally sum = { 0 };
    unsigned line = 1;
    char *text = read_all(path);
    const char *at = text;
    for (const char *start = next_table(text); *start != '\0';) {
        const char *end = next_table(start + 1);
        for (; at < start; at++) line += *at == '\n';
        const table t = { start, path, (size_t)(end - start), line };
        tally one = check_apart(&t, text);
        sum.claims += one.claims;
        sum.mismatches += one.mismatches;
        start = end;
    }
    free(text);
    print_message("%s: %zu claims, %zu mismatches\n", strrchr(path, '/') + 1, sum.claims, sum.mismatches);
    return sum;
}

static int compare_names(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

static void every_claim_gets_the_verdict_that_it_must(void **state)
{
    char *names[256], path[4096];
    size_t count = 0;
    tally sum = { 0 };
    DIR *folder = opendir(JLT_SOURCE_DIR "/tests/proof/claims");
    (void)state;
    assert_non_null(folder);
    for (struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder))
        if (strstr(entry->d_name, ".tt") != NULL && count < sizeof names / sizeof *names) names[count++] = strdup(entry->d_name);
    closedir(folder);
    qsort(names, count, sizeof *names, compare_names);
    for (size_t i = 0; i < count; i++) {
        snprintf(path, sizeof path, "%s/%s", JLT_SOURCE_DIR "/tests/proof/claims", names[i]);
        tally one = check_file(path);
        sum.claims += one.claims;
        sum.mismatches += one.mismatches;
        free(names[i]);
    }
    print_message("%zu claims, %zu mismatches\n", sum.claims, sum.mismatches);
    assert_true(sum.claims >= LEAST_CLAIMS);
    assert_int_equal(sum.mismatches, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(every_claim_gets_the_verdict_that_it_must) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
