/* Real points that meet conditions: found and checked, or excluded, and never one that is not there. */
#include "unit/check.h"

#include "algebra/search.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/time.h>

/* A table whose `let` records q0, q1, ... are the expressions of a test. */
typedef struct {
    ttc_diagnostics *diagnostics;
    ttc_model *model;
    ttc_valuation *valuation;
    ttc_conditions conditions;
} question;

static question ask(const char *quantities)
{
    question q = { .diagnostics = ttc_diagnostics_create() };
    char text[2048];
    snprintf(text, sizeof text, "model m\n%s\neq x = 1\neq y = 1\n", quantities);
    q.model = ttc_model_parse(text, strlen(text), "test.tt", q.diagnostics);
    if (q.model == NULL) ttc_diagnostics_print(q.diagnostics, stderr);
    assert_non_null(q.model);
    q.valuation = ttc_valuation_create(q.model, 0);
    assert_non_null(q.valuation);
    ttc_conditions_init(&q.conditions, q.valuation);
    return q;
}

static void require(question *q, const char *name, ttc_relation relation)
{
    uint32_t symbol;
    ttc_ratio value;
    assert_true(ttc_model_find_symbol(q->model, name, &symbol));
    ttc_ratio_init(ttc_valuation_ring(q->valuation), &value);
    ttc_evaluate(q->valuation, &value, q->model->symbols[symbol].node);
    ttc_conditions_add(&q->conditions, &value, relation);
    ttc_ratio_clear(ttc_valuation_ring(q->valuation), &value);
}

/* The answer; the question is at its end. */
static ttc_search_result answer(question *q)
{
    ttc_witness point;
    assert_true(ttc_witness_init(&point, q->valuation));
    ttc_search_result result = ttc_search_point(&point, &q->conditions);
    if (result == TTC_POINT_FOUND) assert_int_equal(ttc_witness_meets_all(&point, &q->conditions), TTC_HOLDS);
    ttc_witness_clear(&point);
    ttc_conditions_clear(&q->conditions);
    ttc_valuation_destroy(q->valuation);
    ttc_model_destroy(q->model);
    ttc_diagnostics_destroy(q->diagnostics);
    return result;
}

#define PLANE "param a > 0\nparam b >= 0\nstate x\nstate y\n"

static void signs_of_terms_decide_without_a_search(void **unused)
{
    (void)unused;
    question q = ask(PLANE "let f = a*x^2 + b + 1\n");
    require(&q, "f", TTC_IS_POSITIVE);
    assert_int_equal(q.conditions.count, 0); /* nothing that needs to be kept */
    require(&q, "f", TTC_IS_ZERO);
    assert_int_equal(answer(&q), TTC_POINT_IMPOSSIBLE);
}

/* b >= 0 may be zero, a > 0 may not. */
static void a_parameter_that_may_be_zero_is_not_taken_for_positive(void **unused)
{
    (void)unused;
    question q = ask(PLANE "let f = b\n");
    require(&q, "f", TTC_IS_ZERO);
    assert_int_equal(answer(&q), TTC_POINT_FOUND);
    q = ask(PLANE "let f = a\n");
    require(&q, "f", TTC_IS_ZERO);
    assert_int_equal(answer(&q), TTC_POINT_IMPOSSIBLE);
}

/* x^4 - x^3 y + y^4 + 1/8 is negative nowhere: no sign of a term says so, nor a complete square. */
static void the_solver_finds_what_signs_leave_open(void **unused)
{
    (void)unused;
    question q = ask(PLANE "let f = x^4 - x^3*y + y^4 + 1/8\nlet g = 1000001 - x\nlet h = x - 1000000\n");
    require(&q, "g", TTC_IS_POSITIVE);
    require(&q, "h", TTC_IS_POSITIVE);
    assert_int_equal(answer(&q), TTC_POINT_FOUND);
    q = ask(PLANE "let f = -(x^4 - x^3*y + y^4 + 1/8)\n");
    require(&q, "f", TTC_IS_POSITIVE);
    assert_int_equal(answer(&q), TTC_POINT_EXCLUDED);
}

/* x^2 = 2 has no rational point: what the solver names is irrational, and is not taken on trust. */
static void an_irrational_point_that_cannot_be_checked_is_no_point(void **unused)
{
    (void)unused;
    question q = ask(PLANE "let f = x^2 - 2\n");
    require(&q, "f", TTC_IS_ZERO);
    assert_int_equal(answer(&q), TTC_POINT_NOT_DECIDED);
}

/* Roots are real and positive at a point, whether or not a condition speaks of that. */
static void roots_and_functions_have_their_own_values(void **unused)
{
    (void)unused;
    question q = ask(PLANE "root r = sqrt(1 - x^2)\nlet f = r + 1/2\nlet g = x - 2\n");
    require(&q, "f", TTC_IS_POSITIVE);
    uint32_t r;
    ttc_ratio value;
    assert_true(ttc_model_find_symbol(q.model, "r", &r));
    ttc_ratio_init(ttc_valuation_ring(q.valuation), &value);
    ttc_evaluate(q.valuation, &value, q.model->symbols[r].node);
    ttc_ratio_clear(ttc_valuation_ring(q.valuation), &value);
    require(&q, "g", TTC_IS_POSITIVE);
    assert_int_not_equal(answer(&q), TTC_POINT_FOUND);
    q = ask(PLANE "angle c s = cos(x) sin(x)\nlet f = c - 1 + x^2/2\nlet g = 1 - x^2\n"); /* cos x > 1 - x^2/2 */
    require(&q, "f", TTC_IS_POSITIVE);
    require(&q, "g", TTC_IS_POSITIVE);
    assert_int_equal(answer(&q), TTC_POINT_FOUND);
    q = ask(PLANE "exp e = exp(x)\nlet f = 1 + x - e\n"); /* e^x >= 1 + x, as the solver is told */
    require(&q, "f", TTC_IS_POSITIVE);
    assert_int_equal(answer(&q), TTC_POINT_EXCLUDED);
    q = ask(PLANE "exp e = exp(x)\nlet f = 2*x - e\n"); /* e^x > 2 x: the solver cannot know, and says nothing */
    require(&q, "f", TTC_IS_POSITIVE);
    assert_int_equal(answer(&q), TTC_POINT_NOT_DECIDED);
}

static volatile sig_atomic_t looks, strangers;

static void ours(int signal_number) { (void)signal_number; }

static void look(int signal_number)
{
    struct sigaction now;
    (void)signal_number;
    looks = looks + 1;
    if (sigaction(SIGINT, NULL, &now) == 0 && now.sa_handler != ours) strangers = strangers + 1;
}

/* Whoever interrupts a proof means the program: the solver takes no signal for its own. */
static void signals_stay_with_the_program(void **unused)
{
    (void)unused;
    struct sigaction keep = { .sa_handler = ours }, watch = { .sa_handler = look, .sa_flags = SA_RESTART };
    sigaction(SIGINT, &keep, NULL);
    sigaction(SIGPROF, &watch, NULL);
    setitimer(ITIMER_PROF, &(struct itimerval){ { 0, 1000 }, { 0, 1000 } }, NULL);
    for (int i = 0; i < 1000 && looks < 20; i++) {
        question q = ask(PLANE "let f = 3*x^2*y^2 - x^4*y^2 - x^2*y^4 - 1 - b\n"); /* Motzkin's polynomial is nowhere negative */
        require(&q, "f", TTC_IS_POSITIVE);
        assert_int_not_equal(answer(&q), TTC_POINT_FOUND);
    }
    setitimer(ITIMER_PROF, &(struct itimerval){ { 0, 0 }, { 0, 0 } }, NULL);
    signal(SIGINT, SIG_DFL);
    assert_int_equal(strangers, 0);
}

/* Points near ends of intervals are tried, but not in so many attempts that of many states one is always near an end. */
static void points_of_many_states_are_not_all_near_ends(void **unused)
{
    enum { STATES = 10, LEAST = 200 };
    char text[1024] = "state x in (0, 1)\nstate y in (0, 1)\n";
    unsigned attempt = 0, inside = 0, found = 0;
    ttc_witness point;
    (void)unused;
    for (int i = 0; i < STATES; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "state z%d in (0, 1)\neq z%d = 0\n", i, i);
    strcat(text, "let f = x + y");
    for (int i = 0; i < STATES; i++) snprintf(text + strlen(text), sizeof text - strlen(text), " + z%d", i);
    question q = ask(text);
    require(&q, "f", TTC_IS_POSITIVE);
    assert_true(ttc_witness_init(&point, q.valuation));
    for (; ttc_search_next(&point, &q.conditions, &attempt); found++) {
        bool is_near = false; /* others are sixteenths */
        for (slong v = 0; v < (slong)point.ring->variable_count; v++) {
            const size_t symbol = ttc_valuation_symbol(q.valuation, v);
            const bool is_state = symbol < q.model->symbol_count && q.model->symbols[symbol].kind == TTC_STATE;
            is_near |= is_state && fmpz_cmp_si(fmpq_denref(point.values + v), 16) > 0;
        }
        inside += !is_near;
    }
    assert_true(inside >= LEAST);
    assert_true(found - inside >= LEAST);
    ttc_witness_clear(&point);
    ttc_conditions_clear(&q.conditions);
    ttc_valuation_destroy(q.valuation);
    ttc_model_destroy(q.model);
    ttc_diagnostics_destroy(q.diagnostics);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signs_of_terms_decide_without_a_search),
        cmocka_unit_test(a_parameter_that_may_be_zero_is_not_taken_for_positive),
        cmocka_unit_test(the_solver_finds_what_signs_leave_open),
        cmocka_unit_test(an_irrational_point_that_cannot_be_checked_is_no_point),
        cmocka_unit_test(roots_and_functions_have_their_own_values),
        cmocka_unit_test(points_of_many_states_are_not_all_near_ends),
        cmocka_unit_test(signals_stay_with_the_program),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
