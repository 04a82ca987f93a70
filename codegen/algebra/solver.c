#include "algebra/solver.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "algebra/qepcad.h"
#include "algebra/solver_question.h"
#include "base/sha256.h"

enum { DIGEST_SIZE = 65, SETTLED_MAX = 64 };

/* Digests of the last questions of this process that have no point: many claims of a table ask the same of its domain. */
static char settled[SETTLED_MAX][DIGEST_SIZE];
static size_t settled_count;

static bool is_settled(const char *question)
{
    for (size_t i = 0; i < SETTLED_MAX; i++)
        if (strcmp(settled[i], question) == 0) return true;
    return false;
}

static void ignore_errors(Z3_context z3, Z3_error_code code) { (void)z3, (void)code; }

static void release(void *solver) { Z3_del_context(solver); }

/* One context for each ring: answers depend on questions about this ring alone. Creating one takes longer than most answers.
 * Returns NULL when memory is out. */
static Z3_context context_of(ttc_ring *ring)
{
    if (ring->solver == NULL) {
        Z3_config config = Z3_mk_config();
        if (config == NULL) return NULL;
        ring->solver = Z3_mk_context(config);
        Z3_del_config(config);
        if (ring->solver == NULL) return NULL;
        ring->release = release;
        Z3_set_error_handler(ring->solver, ignore_errors);
    }
    return ring->solver;
}

/* In Z3's own units, of which a second has some ten thousand to some million; in seconds. */
enum { WORK = 4000000, SECONDS_TO_FIND = 6, SECONDS_OF_QEPCAD = 3 };

/* A solver that gives up after WORK units, and after so many milliseconds unless that is 0. */
static Z3_solver make_solver(Z3_context z3, unsigned milliseconds)
{
    Z3_solver solver = Z3_mk_solver_for_logic(z3, Z3_mk_string_symbol(z3, "QF_NRA"));
    Z3_solver_inc_ref(z3, solver);
    Z3_params params = Z3_mk_params(z3);
    Z3_params_inc_ref(z3, params);
    Z3_params_set_uint(z3, params, Z3_mk_string_symbol(z3, "rlimit"), WORK);
    if (milliseconds > 0) Z3_params_set_uint(z3, params, Z3_mk_string_symbol(z3, "timeout"), milliseconds);
    /* Otherwise Z3 catches SIGINT while it works, and the program does not receive it. */
    Z3_params_set_bool(z3, params, Z3_mk_string_symbol(z3, "ctrl_c"), false);
    Z3_solver_set_params(z3, solver, params);
    Z3_params_dec_ref(z3, params);
    return solver;
}

static double seconds_now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

typedef struct {
    Z3_ast statement;
    size_t length;
} condition;

static int compare_lengths(const void *left, const void *right)
{
    const condition *a = left, *b = right;
    return (a->length > b->length) - (a->length < b->length);
}

static bool contradict(Z3_context z3, const condition *conditions, size_t count, unsigned milliseconds)
{
    Z3_solver solver = make_solver(z3, milliseconds);
    for (size_t i = 0; i < count; i++) Z3_solver_assert(z3, solver, conditions[i].statement);
    const bool none = Z3_solver_check(z3, solver) == Z3_L_FALSE;
    Z3_solver_dec_ref(z3, solver);
    return none;
}

/* Find conditions that contradict each other, and put them first. Conditions are sorted by length; the last one of the shortest
 * list, from the start, that is contradictory is needed, and is moved to the front; the search is repeated with those before it.
 * Returns the number of conditions that are kept: more than needed where time is up. */
static size_t find_contradiction(Z3_context z3, condition *conditions, size_t count, double seconds)
{
    const double end = seconds_now() + SECONDS_TO_FIND;
    const unsigned milliseconds = (unsigned)(50 + 2000 * seconds);
    qsort(conditions, count, sizeof *conditions, compare_lengths);
    for (size_t found = 0; found < count; found++) {
        size_t k = found;
        while (k < count && !contradict(z3, conditions, k, milliseconds)) k++;
        if (k == found && k > 0) return found;
        if (seconds_now() > end) break;
        const condition last = conditions[k - 1];
        memmove(conditions + found + 1, conditions + found, (k - 1 - found) * sizeof last);
        conditions[found] = last;
        count = k;
    }
    return count;
}

/* Returns true if QEPCAD finds that the contradictory conditions alone have no point. They have few variables in nearly all cases,
 * as QEPCAD needs. */
static bool qepcad_agrees(const ttc_question *q, double seconds)
{
    Z3_ast_vector stated = Z3_solver_get_assertions(q->z3, q->solver);
    Z3_ast_vector_inc_ref(q->z3, stated);
    size_t count = Z3_ast_vector_size(q->z3, stated);
    condition *conditions = calloc(count + 1, sizeof *conditions);
    Z3_ast *kept = calloc(count + 1, sizeof *kept);
    bool none = conditions != NULL && kept != NULL;
    for (size_t i = 0; none && i < count; i++) {
        conditions[i].statement = Z3_ast_vector_get(q->z3, stated, (unsigned)i);
        conditions[i].length = strlen(Z3_ast_to_string(q->z3, conditions[i].statement));
    }
    if (none) {
        count = find_contradiction(q->z3, conditions, count, seconds);
        for (size_t i = 0; i < count; i++) kept[i] = conditions[i].statement;
        none = ttc_qepcad_finds_none(q->z3, q->point->ring, kept, count, SECONDS_OF_QEPCAD);
    }
    free(kept);
    free(conditions);
    Z3_ast_vector_dec_ref(q->z3, stated);
    return none;
}

/* Returns false if the question has no text, as where memory is out: all such questions would have one digest. */
static bool digest_of(char digest[DIGEST_SIZE], const ttc_question *q)
{
    const char *text = Z3_solver_to_string(q->z3, q->solver);
    if (Z3_get_error_code(q->z3) != Z3_OK) return false;
    ttc_sha256(digest, text, strlen(text));
    return true;
}

static ttc_solver_answer check(ttc_question *q)
{
    char question[DIGEST_SIZE];
    if (!digest_of(question, q)) return TTC_SOLVER_SILENT;
    if (is_settled(question)) return TTC_SOLVER_NO_POINT;
    const double begin = seconds_now();
    const Z3_lbool answer = Z3_solver_check(q->z3, q->solver);
    if (answer == Z3_L_TRUE && ttc_question_read_point(q)) return TTC_SOLVER_POINT;
    if (answer != Z3_L_FALSE || !qepcad_agrees(q, seconds_now() - begin)) return TTC_SOLVER_SILENT;
    memcpy(settled[settled_count++ % SETTLED_MAX], question, DIGEST_SIZE);
    return TTC_SOLVER_NO_POINT;
}

/* Returns false if memory is out. */
static bool begin(ttc_question *q, ttc_witness *point, const ttc_conditions *conditions, bool with_functions)
{
    *q = (ttc_question){ .point = point, .z3 = context_of(point->ring) };
    if (q->z3 == NULL) return false;
    q->variables = calloc(point->ring->variable_count + 1, sizeof(Z3_ast));
    if (q->variables == NULL) return false;
    q->real = Z3_mk_real_sort(q->z3);
    q->solver = make_solver(q->z3, 0);
    ttc_question_state(q, conditions, with_functions);
    return true;
}

static void end(ttc_question *q)
{
    Z3_solver_dec_ref(q->z3, q->solver);
    free(q->variables);
}

/* Some versions of Z3 (4.8.12 is one) lose points near zeros of what they eliminate: where a polynomial in the next variable
 * has a double root, they may learn that it has none. Hence that there is no point is believed only if QEPCAD finds the same. */
ttc_solver_answer ttc_solver_ask(ttc_witness *point, const ttc_conditions *conditions, bool with_functions)
{
    ttc_question q;
    if (!begin(&q, point, conditions, with_functions)) return TTC_SOLVER_SILENT;
    const ttc_solver_answer answer = q.too_large ? TTC_SOLVER_SILENT : check(&q);
    end(&q);
    return answer;
}

bool ttc_solver_has_excluded(ttc_witness *point, const ttc_conditions *conditions)
{
    char question[DIGEST_SIZE];
    ttc_question q;
    if (settled_count == 0 || !begin(&q, point, conditions, false)) return false;
    const bool excluded = !q.too_large && digest_of(question, &q) && is_settled(question);
    end(&q);
    return excluded;
}
