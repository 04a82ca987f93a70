#include "algebra/solver.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

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

static ttc_solver_answer ask(ttc_question *q, const ttc_conditions *conditions, bool with_functions, char question[DIGEST_SIZE])
{
    ttc_question_state(q, conditions, with_functions);
    if (q->too_large) return TTC_SOLVER_SILENT;
    const char *text = Z3_solver_to_string(q->z3, q->solver);
    ttc_sha256(question, text, strlen(text));
    if (is_settled(question)) return TTC_SOLVER_NO_POINT;
    switch (Z3_solver_check(q->z3, q->solver)) {
    case Z3_L_FALSE: return TTC_SOLVER_NO_POINT;
    case Z3_L_TRUE: return ttc_question_read_point(q) ? TTC_SOLVER_POINT : TTC_SOLVER_SILENT;
    default: return TTC_SOLVER_SILENT;
    }
}

static void ignore_errors(Z3_context z3, Z3_error_code code) { (void)z3, (void)code; }

static void release(void *solver) { Z3_del_context(solver); }

/* One context for each ring: answers depend on questions about this ring alone. Creating one takes longer than most answers. */
static Z3_context context_of(ttc_ring *ring)
{
    if (ring->solver == NULL) {
        Z3_config config = Z3_mk_config();
        ring->solver = Z3_mk_context(config);
        ring->release = release;
        Z3_del_config(config);
        Z3_set_error_handler(ring->solver, ignore_errors);
    }
    return ring->solver;
}

/* How the solver searches: as it is made to; without using what it learns from conflicts until it has a point; with the variables
 * eliminated in an order of chance; in the order of the ring. */
typedef enum { AS_MADE, WITHOUT_LEARNING, IN_OTHER_ORDER, IN_GIVEN_ORDER } strategy;

/* One search, of at most so many of the solver's own units of work. */
static ttc_solver_answer ask_once(ttc_witness *point, const ttc_conditions *conditions, bool with_functions, strategy how,
                                  unsigned work, char question[DIGEST_SIZE])
{
    ttc_question q = { .point = point };
    q.variables = calloc(point->ring->variable_count + 1, sizeof(Z3_ast));
    if (q.variables == NULL) return TTC_SOLVER_SILENT;
    q.z3 = context_of(point->ring);
    /* As parameters of one solver, some versions of Z3 (4.13 is one) do not know them, and ask nothing then. */
    Z3_global_param_set("nlsat.randomize", how == AS_MADE ? "true" : "false");
    Z3_global_param_set("nlsat.lazy", how == WITHOUT_LEARNING ? "2" : "0");
    Z3_global_param_set("nlsat.reorder", how == IN_GIVEN_ORDER ? "false" : "true");
    Z3_global_param_set("nlsat.shuffle_vars", how == IN_OTHER_ORDER ? "true" : "false");
    Z3_global_param_set("nlsat.seed", how == IN_OTHER_ORDER ? "2" : "0");
    q.real = Z3_mk_real_sort(q.z3);
    q.solver = Z3_mk_solver_for_logic(q.z3, Z3_mk_string_symbol(q.z3, "QF_NRA"));
    Z3_solver_inc_ref(q.z3, q.solver);
    Z3_params params = Z3_mk_params(q.z3);
    Z3_params_inc_ref(q.z3, params);
    Z3_params_set_uint(q.z3, params, Z3_mk_string_symbol(q.z3, "rlimit"), work);
    /* Otherwise Z3 catches SIGINT while it works, and the program does not receive it. */
    Z3_params_set_bool(q.z3, params, Z3_mk_string_symbol(q.z3, "ctrl_c"), false);
    Z3_solver_set_params(q.z3, q.solver, params);
    ttc_solver_answer answer = ask(&q, conditions, with_functions, question);
    Z3_params_dec_ref(q.z3, params);
    Z3_solver_dec_ref(q.z3, q.solver);
    free(q.variables);
    return answer;
}

enum { LEAST_WORK = 250000, MUCH_WORK = 4000000, MOST_WORK = 30000000 };

/* The search that uses nothing learned. Where its units of work are short, it has more of them, some two seconds in all. */
static ttc_solver_answer ask_without_learning(ttc_witness *point, const ttc_conditions *conditions, bool with_functions,
                                              char question[DIGEST_SIZE])
{
    const clock_t begin = clock();
    const ttc_solver_answer answer = ask_once(point, conditions, with_functions, WITHOUT_LEARNING, LEAST_WORK, question);
    const double work = LEAST_WORK * 2.0 * CLOCKS_PER_SEC / (double)(clock() - begin + 1);

    if (answer != TTC_SOLVER_SILENT || work < 2 * LEAST_WORK) return answer;
    return ask_once(point, conditions, with_functions, WITHOUT_LEARNING, work < MOST_WORK ? (unsigned)work : MOST_WORK, question);
}

/* Some versions of Z3 (4.8.12 is one) lose points beside zeros of what they eliminate: where a polynomial in the next variable
 * has a double root, they may learn that it has none. That there is no point is believed only if another search agrees, and neither
 * that which does not use what was learned nor that in another order finds one. The given order decides if both take too long. */
ttc_solver_answer ttc_solver_ask(ttc_witness *point, const ttc_conditions *conditions, bool with_functions)
{
    char question[DIGEST_SIZE];
    ttc_solver_answer answer = ask_once(point, conditions, with_functions, AS_MADE, MUCH_WORK, question);
    if (answer != TTC_SOLVER_NO_POINT) return answer;
    const ttc_solver_answer second = ask_without_learning(point, conditions, with_functions, question);
    if (second == TTC_SOLVER_POINT) return second;
    answer = ask_once(point, conditions, with_functions, IN_OTHER_ORDER, MUCH_WORK / 4, question);
    if (answer == TTC_SOLVER_SILENT) answer = second;
    if (answer == TTC_SOLVER_SILENT) answer = ask_once(point, conditions, with_functions, IN_GIVEN_ORDER, MUCH_WORK, question);
    if (answer == TTC_SOLVER_NO_POINT) memcpy(settled[settled_count++ % SETTLED_MAX], question, DIGEST_SIZE);
    return answer;
}
