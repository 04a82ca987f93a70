/* Random tables with random claims: proved, and every verdict challenged at random points.
 *
 *     fuzz_claims [COUNT [SEED]]      COUNT tables, of seeds SEED, SEED + 1, ...
 *     fuzz_claims show SEED           the table of a seed, and what is known of its claims
 *
 * A failure is: a claim that is false by construction and proved, one that is true and refuted, one that speaks of no point
 * and is settled, a verdict that a point contradicts, a table that cannot be read, or a process that ends by a fault. Exit
 * status 1 when there was one; each is printed with its seed, and the table. Claims that pass the limits of `ttc prove` are
 * given up, and are printed too: they are no failures, and how many there are depends on the machine. */
#include "challenge/challenge.h"
#include "command/command_guard.h"
#include "fuzz/random_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { DEFAULT_COUNT = 120, POINTS = 20 };

/* What a process found; sums of them. */
typedef struct {
    size_t tables, claims, proved, refuted, unsettled, late, out_of_memory, settled_as_known, points, contradictions, failures;
} tally;

static const char *const truth_names[] = { "open", "true", "false", "about no point" };

/* The tables of a seed stand for the files beside each other. */
static ttc_model *resolve(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    const made_table *made = context;
    const char *text = strcmp(target, "target.tt") == 0 ? made->target : made->text;
    (void)model;
    return ttc_model_parse(text, strlen(text), target, diagnostics);
}

static const made_claim *find(const made_table *made, const ttc_proof *proof)
{
    for (size_t i = 0; i < made->count; i++)
        if (strcmp(made->claims[i].kind, proof->kind) == 0 && strcmp(made->claims[i].name, proof->name) == 0)
            return &made->claims[i];
    return NULL;
}

static bool is_forbidden(claim_truth truth, ttc_proof_status status)
{
    switch (truth) {
    case CLAIM_TRUE: return status == TTC_REFUTED;
    case CLAIM_FALSE: return status == TTC_PROVED;
    case CLAIM_SILENT: return status == TTC_PROVED || status == TTC_REFUTED;
    case CLAIM_OPEN: break;
    }
    return false;
}

static void count_ending(uint64_t seed, const ttc_proof *proof, tally *sum)
{
    if (proof->ending == TTC_ENDED_BY_VERDICT) return;
    sum->late += proof->ending == TTC_ENDED_LATE;
    sum->out_of_memory += proof->ending == TTC_ENDED_OUT_OF_MEMORY || proof->ending == TTC_ENDED_BY_SYSTEM;
    sum->failures += proof->ending == TTC_ENDED_BY_FAULT;
    printf("seed %llu, line %u: the %s claim %s is given up: %s\n", (unsigned long long)seed, (unsigned)proof->place.line,
           proof->kind, proof->name, proof->remainder != NULL ? proof->remainder : "");
}

static void compare(uint64_t seed, const made_table *made, const ttc_proof_report *report, tally *sum)
{
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = &report->proofs[i];
        const made_claim *claim = find(made, proof);
        const claim_truth truth = claim != NULL ? claim->truth : CLAIM_OPEN;
        sum->claims++;
        sum->proved += proof->status == TTC_PROVED;
        sum->refuted += proof->status == TTC_REFUTED;
        sum->unsettled += proof->status != TTC_PROVED && proof->status != TTC_REFUTED;
        sum->settled_as_known += (truth == CLAIM_TRUE && proof->status == TTC_PROVED)
                                 || (truth == CLAIM_FALSE && proof->status == TTC_REFUTED);
        count_ending(seed, proof, sum);
        if (!is_forbidden(truth, proof->status)) continue;
        sum->failures++;
        printf("seed %llu, line %u: the %s claim %s is %s, and %s by construction: %s\n", (unsigned long long)seed,
               (unsigned)proof->place.line, proof->kind, proof->name, ttc_proof_status_name(proof->status), truth_names[truth],
               proof->remainder != NULL ? proof->remainder : "");
    }
}

static void challenge(uint64_t seed, const ttc_model *model, made_table *made, const ttc_proof_report *report, tally *sum)
{
    ttc_challenge_report *challenged = NULL;
    const ttc_challenge_extent extent = { .points = POINTS, .seed = seed };
    if (!ttc_challenge(model, report, resolve, made, &extent, &challenged)) {
        sum->failures++;
        return;
    }
    sum->points = challenged->tried + challenged->special;
    sum->contradictions = challenged->contradictions;
    sum->failures += challenged->contradictions;
    for (size_t i = 0; i < challenged->count; i++)
        if (challenged->results[i].contradicted)
            printf("seed %llu, line %u: the %s claim %s is %s, and a point contradicts it: %s\n", (unsigned long long)seed,
                   (unsigned)challenged->results[i].place.line, challenged->results[i].kind, challenged->results[i].name,
                   ttc_proof_status_name(challenged->results[i].status),
                   challenged->results[i].text != NULL ? challenged->results[i].text : "");
    ttc_challenge_report_destroy(challenged);
}

static tally examine(uint64_t seed, made_table *made)
{
    tally sum = { .tables = 1 };
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(made->text, strlen(made->text), "random.tt", diagnostics);
    ttc_proof_report *report = model != NULL ? ttc_prove_guarded(model, TTC_GUARD_SECONDS, resolve, made) : NULL;
    if (report == NULL) {
        ttc_diagnostics_print(diagnostics, stdout);
        sum.failures++;
    } else {
        compare(seed, made, report, &sum);
        challenge(seed, model, made, report, &sum);
    }
    ttc_proof_report_destroy(report);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
    return sum;
}

/* In a process of its own, so that a crash is a failure like any other. */
static bool run_apart(uint64_t seed, made_table *made, tally *found)
{
    int ends[2], status = 0;
    if (pipe(ends) != 0) return false;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        tally sum = examine(seed, made);
        fflush(NULL);
        _exit(write(ends[1], &sum, sizeof sum) == (ssize_t)sizeof sum ? 0 : 1);
    }
    close(ends[1]);
    bool told = child > 0 && read(ends[0], found, sizeof *found) == (ssize_t)sizeof *found;
    close(ends[0]);
    if (child < 0 || waitpid(child, &status, 0) != child) return false;
    if (told && WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
    printf("seed %llu: reading or challenging ends by %s %d\n", (unsigned long long)seed,
           WIFSIGNALED(status) ? "signal" : "exit status", WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
    *found = (tally){ .tables = 1, .failures = 1 };
    return true;
}

static void add(tally *sum, const tally *part)
{
    sum->tables += part->tables;
    sum->claims += part->claims;
    sum->proved += part->proved;
    sum->refuted += part->refuted;
    sum->unsettled += part->unsettled;
    sum->late += part->late;
    sum->out_of_memory += part->out_of_memory;
    sum->settled_as_known += part->settled_as_known;
    sum->points += part->points;
    sum->contradictions += part->contradictions;
    sum->failures += part->failures;
}

static int show(uint64_t seed)
{
    made_table made = table_make(seed);
    if (made.text == NULL) return 1;
    printf("%s\n# beside it, target.tt:\n%s\n", made.text, made.target);
    for (size_t i = 0; i < made.count; i++)
        printf("# %s %s: %s\n", made.claims[i].kind, made.claims[i].name, truth_names[made.claims[i].truth]);
    free(made.text);
    free(made.target);
    return 0;
}

static uint64_t number(const char *text, uint64_t otherwise) { return text != NULL ? strtoull(text, NULL, 10) : otherwise; }

int main(int argc, char **argv)
{
    tally sum = { 0 };
    if (argc > 2 && strcmp(argv[1], "show") == 0) return show(number(argv[2], 0));
    const uint64_t count = number(argc > 1 ? argv[1] : NULL, DEFAULT_COUNT), first = number(argc > 2 ? argv[2] : NULL, 1);
    for (uint64_t seed = first; seed < first + count; seed++) {
        tally found = { 0 };
        made_table made = table_make(seed);
        if (made.text == NULL || !run_apart(seed, &made, &found)) {
            printf("out of memory or processes\n");
            return 1;
        }
        if (found.failures > 0) printf("--- the table of seed %llu\n%s---\n", (unsigned long long)seed, made.text);
        add(&sum, &found);
        free(made.text);
        free(made.target);
    }
    printf("%zu tables, %zu claims: %zu proved, %zu refuted, %zu not settled, of which %zu given up late and %zu out of "
           "memory; %zu settled as constructed; %zu points, %zu contradictions, %zu failures\n", sum.tables, sum.claims,
           sum.proved, sum.refuted, sum.unsettled, sum.late, sum.out_of_memory, sum.settled_as_known, sum.points,
           sum.contradictions, sum.failures);
    return sum.failures > 0;
}
