/* Verdicts on random identities between exponentials, logarithms and angles, against ball arithmetic: what is proved holds at every
 * point, what is refuted fails at some point. About half of the identities are true by the functional equations. */
#include "unit/check.h"

#include "ball/ball.h"
#include "base/random.h"
#include "prove/prove.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TABLES = 150, CLAIMS = 3, POINTS = 4 };

static uint64_t random_state = 2026;

static unsigned draw(unsigned below)
{
    return (unsigned)(ttc_random_bits(&random_state) >> 33) % below;
}

typedef struct {
    int x, y, number; /* coefficients of an exponent or angle, powers in an argument; number: of 1, of pi/2, of the factor 2 */
} vector;

static vector draw_vector(void) { return (vector){ (int)draw(5) - 2, (int)draw(5) - 2, (int)draw(5) - 2 }; }

static bool is_zero(vector a) { return a.x == 0 && a.y == 0 && a.number == 0; }

/* a + b, or another vector half of the time. */
static vector sum_or_not(vector a, vector b)
{
    vector sum = { a.x + b.x, a.y + b.y, a.number + b.number };
    if (draw(2) == 0) return sum;
    switch (draw(3)) {
    case 0: sum.x++; break;
    case 1: sum.y--; break;
    default: sum.number++; break;
    }
    return sum;
}

static void draw_triple(vector *v)
{
    do {
        v[0] = draw_vector();
        v[1] = draw_vector();
        v[2] = sum_or_not(v[0], v[1]);
    } while (is_zero(v[0]) || is_zero(v[1]) || is_zero(v[2]) || memcmp(v, v + 1, sizeof *v) == 0 || memcmp(v, v + 2, sizeof *v) == 0
             || memcmp(v + 1, v + 2, sizeof *v) == 0);
}

static void write_table(char *text, size_t size)
{
    vector e[3], l[3], a[3];
    int length;
    draw_triple(e);
    draw_triple(l);
    draw_triple(a);
    length = snprintf(text, size, "model random\nstate x in (0, inf)\nstate y in (0, inf)\neq x = x\neq y = y\n");
    for (int i = 0; i < 3; i++)
        length += snprintf(text + length, size - (size_t)length,
                           "exp e%d = exp(%d*x*y + (%d)*y + (%d))\nlog l%d = log(x^(%d)*(x + y)^(%d)*2^(%d))\n"
                           "angle c%d s%d = cos(%d*x + (%d)*y + (%d)*pi/2) sin(%d*x + (%d)*y + (%d)*pi/2)\n",
                           i, e[i].x, e[i].y, e[i].number, i, l[i].x, l[i].y, l[i].number, i, i, a[i].x, a[i].y, a[i].number,
                           a[i].x, a[i].y, a[i].number);
    snprintf(text + length, size - (size_t)length,
             "equal exponentials : e0*e1 = e2\nequal logarithms : l0 + l1 = l2\nequal angles : c0*c1 - s0*s1 = c2\n");
}

/* How many of the points, dyadic and so exact, the two sides differ at; those where a difference is not seen in 2048 bits agree. */
static unsigned differing_points(const ttc_model *model, const ttc_claim *claim)
{
    unsigned count = 0;
    ttc_ball *ball = ttc_ball_create(model);
    assert_non_null(ball);
    ttc_id difference = ttc_subtract(model->graph, claim->expression, claim->other);
    for (int point = 0; point < POINTS; point++) {
        bool excludes_zero = false;
        for (size_t i = 0; i < model->state_count; i++)
            assert_true(ttc_ball_set(ball, model->states[i], (1 + draw(1000)) * 0x1p-8));
        char *value = ttc_ball_text(ball, difference, 10, &excludes_zero);
        assert_non_null(value);
        free(value);
        count += excludes_zero;
    }
    ttc_ball_destroy(ball);
    return count;
}

static void verdicts_agree_with_balls_at_random_points(void **unused)
{
    unsigned proved = 0, refuted = 0, open = 0;
    (void)unused;
    for (int i = 0; i < TABLES; i++) {
        char text[2048];
        ttc_proof_report *report = NULL;
        ttc_diagnostics *diagnostics = ttc_diagnostics_create();
        write_table(text, sizeof text);
        ttc_model *model = ttc_model_parse(text, strlen(text), "random.tt", diagnostics);
        ttc_diagnostics_destroy(diagnostics);
        if (model == NULL) continue; /* a triple in which two definitions are one, or a number */
        assert_true(ttc_prove(model, NULL, NULL, TTC_PROVE_ALL, &report));
        for (size_t k = 0; k < CLAIMS; k++) {
            ttc_proof_status status = report->proofs[k].status;
            unsigned differing = differing_points(model, &model->claims[k]);
            if ((status == TTC_PROVED) != (differing == 0) && status != TTC_UNSETTLED)
                print_error("%s%s: %s, but different at %u points\n", text, model->claims[k].name, ttc_proof_status_name(status),
                            differing);
            if (status == TTC_PROVED) assert_int_equal(differing, 0);
            if (status == TTC_REFUTED) assert_true(differing > 0);
            proved += status == TTC_PROVED;
            refuted += status == TTC_REFUTED;
            open += status == TTC_UNSETTLED;
        }
        ttc_proof_report_destroy(report);
        ttc_model_destroy(model);
    }
    print_message("%u proved, %u refuted, %u not settled\n", proved, refuted, open);
    assert_true(proved > TABLES && refuted > TABLES / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(verdicts_agree_with_balls_at_random_points) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
