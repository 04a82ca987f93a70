/* Proofs under guard: a claim whose proof is late, out of memory or at fault is not settled, says which of the three it was,
 * and takes no other claim with it. What goes wrong here goes wrong where a reduction's target is read, in the worker. */
#include "unit/check.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <flint/flint.h>

#include "command/command_guard.h"

enum { SHORT = 2 }; /* seconds of processor time a claim; a machine may take as many to fill the memory */

static const char table[] = "model guarded\nstate x\nstate y\neq x = y\neq y = -x\nreduction other : onto other.tt with x = x\n"
                            "integral E = x^2 + y^2\n";

typedef void (*misfortune)(void);

static ttc_model *resolve(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    (void)model;
    (void)target;
    (void)diagnostics;
    (*(misfortune *)context)();
    return NULL;
}

#ifndef JLT_SANITIZED /* the sanitizer makes an exit of its own of signals */
static void crash(void)
{
    signal(SIGSEGV, SIG_DFL); /* cmocka's own handler is in the worker too */
    raise(SIGSEGV);
}
static void give_up_itself(void) { abort(); }
#endif
static void be_killed(void) { raise(SIGKILL); }
static void run_out_of_time(void)
{
    setrlimit(RLIMIT_CPU, &(struct rlimit){ 1, 2 });
    for (;;) raise(0);
}
static void leave(void) { exit(3); }
static void outgrow(void)
{
    for (size_t i = 0; i < 4096; i++) memset(flint_malloc(1 << 20), 1, 1 << 20); /* flint aborts at the limit */
}
static void hang(void)
{
    for (;;) raise(0);
}

static void doze(void) { sleep(SHORT + 1); }

/* Another table each time that one is asked for: the witness reads one that contradicts what is proved of the first. */
static ttc_model *resolve_otherwise(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    static const char *const tables[] = { "model a\nstate x\neq x = -x\n", "model a\nstate x\neq x = x\n" };
    const char *text = tables[*(int *)context];
    (void)model;
    *(int *)context = 1;
    return ttc_model_parse(text, strlen(text), target, diagnostics);
}

static ttc_proof_report *prove(const char *text, int seconds, ttc_resolver resolver, void *context)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(text, strlen(text), "guarded.tt", diagnostics);
    assert_non_null(model);
    ttc_proof_report *report = ttc_prove_guarded(model, seconds, resolver, context);
    assert_non_null(report);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
    return report;
}

static void a_proof_that_a_point_contradicts_is_none(void **unused)
{
    static const char doubted[] = "model guarded\nstate x\neq x = -x\nreduction a : onto a.tt with x = x\nrate d : x = -x\n";
    int asked = 0;
    (void)unused;
    ttc_proof_report *report = prove(doubted, TTC_GUARD_SECONDS, resolve_otherwise, &asked);
    assert_int_equal(report->proofs[0].status, TTC_UNSETTLED);
    assert_int_equal(report->proofs[0].ending, TTC_ENDED_BY_FAULT);
    assert_non_null(strstr(report->proofs[0].remainder, "a point contradicts its proof"));
    assert_int_equal(report->proofs[1].status, TTC_PROVED);
    ttc_proof_report_destroy(report);
}

static void late_claims_leave_time_for_others(void **unused)
{
    static const char late[] = "model guarded\nstate x\neq x = -x\nreduction a : onto a.tt with x = x\n"
                               "reduction b : onto a.tt with x = x\nreduction c : onto a.tt with x = x\nrate d : x = -x\n";
    misfortune what = hang;
    (void)unused;
    ttc_proof_report *report = prove(late, SHORT, resolve, &what);
    for (size_t i = 0; i < 3; i++) assert_int_equal(report->proofs[i].ending, TTC_ENDED_LATE);
    assert_int_equal(report->proofs[3].status, TTC_PROVED);
    ttc_proof_report_destroy(report);
}

static double processor_time(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void work_a_while(void)
{
    const double end = processor_time() + 0.65 * SHORT;
    while (processor_time() < end) continue;
}

/* Half of the time that is left when a claim begins is its own, however many are open. */
static void time_that_others_took_is_not_kept_for_them(void **unused)
{
    enum { SHORT_CLAIMS = 60, SIZE = 4096 };
    char many[SIZE] = "model guarded\nstate x\neq x = -x\nreduction a : onto a.tt with x = x\n"
                      "reduction b : onto a.tt with x = x\n";
    misfortune what = work_a_while;
    (void)unused;
    for (int i = 0; i < SHORT_CLAIMS; i++) {
        const size_t length = strlen(many);
        snprintf(many + length, SIZE - length, "rate d%d : x = -x\n", i);
    }
    ttc_proof_report *report = prove(many, SHORT, resolve, &what);
    for (size_t i = 0; i < 2; i++) assert_int_equal(report->proofs[i].ending, TTC_ENDED_BY_VERDICT);
    for (size_t i = 2; i < report->proof_count; i++) assert_int_equal(report->proofs[i].status, TTC_PROVED);
    ttc_proof_report_destroy(report);
}

static void expect(misfortune what, int seconds, ttc_proof_ending ending, const char *reason)
{
    ttc_proof_report *report = prove(table, seconds, resolve, &what);
    assert_string_equal(report->proofs[0].kind, "reduction");
    assert_int_equal(report->proofs[0].status, TTC_UNSETTLED);
    if (report->proofs[0].ending != ending) print_error("%s\n", report->proofs[0].remainder);
    assert_int_equal(report->proofs[0].ending, ending);
    assert_non_null(strstr(report->proofs[0].remainder, reason));
    assert_int_equal(report->proofs[1].status, TTC_PROVED);
    assert_int_equal(report->proofs[1].ending, TTC_ENDED_BY_VERDICT);
    ttc_proof_report_destroy(report);
}

static void a_fault_is_no_bound(void **unused)
{
    (void)unused;
#ifndef JLT_SANITIZED
    expect(crash, TTC_GUARD_SECONDS, TTC_ENDED_BY_FAULT, "its proof fails, by signal 11");
    expect(give_up_itself, TTC_GUARD_SECONDS, TTC_ENDED_BY_FAULT, "its proof fails, by signal 6");
#endif
    expect(leave, TTC_GUARD_SECONDS, TTC_ENDED_BY_FAULT, "its proof fails, by exit status 3");
}

static void memory_is_bounded(void **unused)
{
    (void)unused;
#ifdef JLT_SANITIZED
    skip(); /* the sanitizer maps more than any limit */
#endif
    expect(outgrow, TTC_GUARD_SECONDS, TTC_ENDED_OUT_OF_MEMORY, "passes the limit of 1536 MiB");
}

/* Whoever calls the program may bound it more narrowly. */
static void the_system_has_bounds_of_its_own(void **unused)
{
    (void)unused;
    expect(be_killed, TTC_GUARD_SECONDS, TTC_ENDED_BY_SYSTEM, "by the system, where memory or processor time is out");
    expect(run_out_of_time, TTC_GUARD_SECONDS, TTC_ENDED_BY_SYSTEM, "by the system, where memory or processor time is out");
}

/* What else runs takes the clock's time, not the proof's. */
static void a_claim_that_waits_is_not_late(void **unused)
{
    (void)unused;
    expect(doze, SHORT, TTC_ENDED_BY_VERDICT, "could not be read");
}

static void time_is_bounded(void **unused)
{
    (void)unused;
    expect(hang, SHORT, TTC_ENDED_LATE, "passes the limit of 2 s of processor time a claim, or of 5 s a table");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fault_is_no_bound),
        cmocka_unit_test(a_proof_that_a_point_contradicts_is_none),
        cmocka_unit_test(memory_is_bounded),
        cmocka_unit_test(the_system_has_bounds_of_its_own),
        cmocka_unit_test(time_is_bounded),
        cmocka_unit_test(late_claims_leave_time_for_others),
        cmocka_unit_test(time_that_others_took_is_not_kept_for_them),
        cmocka_unit_test(a_claim_that_waits_is_not_late),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
