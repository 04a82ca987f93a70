/* Verdicts that are wrong are contradicted by points, of every kind of claim; verdicts that are right are not. */
#include "prove_text.h"

#include "challenge/challenge.h"
#include "challenge/sample.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 40 };

/* Every claim is true; claims on open sets, and one condition of each sort. */
static const char true_claims[] =
    "model pendulum\nparam k > 0\nparam a\nstate q\nstate p\nstate z in (0, inf)\nstate w\nstate u\nroot r = sqrt(1 + p^2)\n"
    "angle c s = cos(q) sin(q)\neq q = p\neq p = -k*s + a*p\neq z = z*p/r\neq w = w*p\neq u = 0\n"
    "integral H = p^2/2 - k*c when a = 0\nrate power : p^2/2 - k*c = a*p^2\nrate of_root : r = p*(a*p - k*s)/r\n"
    "measure volume = 1/(z*w) when a = 0\nequal circle : c^2 + s^2 = 1\nequal on_level : p^2 = 2*k*c modulo H when a = 0\n"
    "invariant flat = w*(w^2 + 1)\nequal set : a*p = k when a = k/p\nintegral U = u\n"
    "equilibria down : q = 0, p = 0\ntrace down = a\nobstructs down\nleftnull down : U\n"
    "matrix down = 0, 1, 0, 0, 0; -k, a, 0, 0, 0; 0, z, 0, 0, 0; 0, w, 0, 0, 0; 0, 0, 0, 0, 0\n"
    "charpoly down = lambda^3*(lambda^2 - a*lambda + k)\n"
    "reversor p -> -p when a = 0\ntime t : 2 + s\nvariant v : k = 1 + a^2\nexp e = exp(a*w)\nobserve o = q/(w*r - p)\n"
    "observe grown = q/(e - 1)\nvalid ok : 1/u > 0\n";

/* Every claim is false, at points that random ones meet. */
static const char false_claims[] =
    "model pendulum\nparam k > 0\nparam a\nstate q\nstate p\nstate z in (0, 1)\nroot r = sqrt(1 + p)\n"
    "angle c s = cos(q) sin(q)\neq q = p\neq p = -k*s + a*p\neq z = z*p\n"
    "integral H = p^2/2 - k*c\nintegral vacuous = k*a\nintegral not_kept = z when p = 0\nrate power : p^2/2 - k*c = a*p\n"
    "measure volume = 1\nequal circle : c^2 - s^2 = 1\nequal on_level : p^2 = k*c modulo H\ninvariant left = z - p\n"
    "equilibria down : q = 0, p = 0, z = a\ntrace down = 2*a\nmatrix down = 0, 1, 0; k, a, 0; 0, a, 0\n"
    "charpoly down = lambda*(lambda^2 - a*lambda - k)\nequilibria up : q = 1, p = 0, z = 1/2\n"
    "reversor z -> -z\ntime t : s\ntime u : 1/2 + z - p^2\nvariant v : k = a\nvariant w : k = -1\n"
    "observe o = z/(r^2 - 1 - p)\nvalid ok : 1/((r^2 - 1 - p)*z) > 0\n";

/* One claim of each is false, at points alone that generic ones hardly ever are: where a level is singular, by its rate or by a
 * later derivative along the orbit; where several states are zero; where a sum is; where something divides by zero that cancels,
 * or that no equation uses. One is false of a given root, two are of what both
 * tables watch. */
static const char *const rarely_false[] = {
    "model line\nstate x\nstate y\nstate z\ndomain beside : y^2 > 0\nroot r = sqrt(y^2)\neq x = 0\neq y = 0\neq z = 1 - y/r\n"
    "invariant sheet = x^2*y - z^4\n",
    "model line\nstate x\nstate y\nstate z\nstate s\ndomain beside : y^2 > 0\nroot r = sqrt(y^2)\neq x = 0\neq y = 0\neq z = 0\n"
    "eq s = 1 - y/r\ninvariant left = s modulo sheet\ninvariant sheet = x^2*y - z^4\n",
    "model handle\nstate x\nstate y\nstate z\nstate s\neq x = 0\neq y = 0\neq z = 0\neq s = 0\n"
    "invariant circle = (x + 2*y - 3)^2 + z^2\nequal zero : s = 0 modulo circle\n",
    "model density\nstate x\nstate y\neq x = 0\neq y = 0\nmeasure smooth = x^2 + y^4\n",
    "model left_out\nstate x\nroot r = sqrt(1/(x - 1)^2)\neq x = 1\nsymmetry wrong : x -> x + 1\n",
    "model squares\nstate x\neq x = x\nreduction wrong : onto with_root.tt with y = x^2\n",
    "model squares\nstate x\neq x = x\nembedding wrong : into with_angle.tt with y = x^2\n",
    "model moved\nstate x\nstate y\nstate z\neq x = y\neq y = 0\neq z = y\nintegral level = y^2/y\n"
    "section wrong : by of_speed.tt at x = 0 with z = z, V = level\n",
    "model moved\nstate x\nstate y\nstate z\nlet none = 1/y\neq x = y\neq y = 0\neq z = y\nintegral level = y\n"
    "section wrong : by of_speed.tt at x = 0 with z = z + 0*none, V = level\n",
    "model moved\nstate x\nstate y\nstate z\neq x = 1\neq y = 0\neq z = y\nintegral level = y^2/y\n"
    "section wrong : by of_speed.tt at x = 0 with z = z, V = level\n",
    "model moved\nstate x\nstate y\nstate z\neq x = 1\neq y = 0\neq z = y\nintegral level = y\n"
    "section wrong : by undefined.tt at x = 0 with z = z, V = level\n",
    "model rootless\nstate x\ndomain apart : x^2 > 0\neq x = x\nreduction wrong : onto rooted.tt with y = x, r = x\n",
    "model seen_otherwise\nstate x\neq x = x\nobserve seen = x\nreduction wrong : onto watched.tt with y = x\n",
    "model kept_otherwise\nstate x\neq x = x\nvalid kept : 2*x > 0\nembedding wrong : into watched.tt with y = x\n",
    "model anywhere\nstate x\nstate y\nstate z\neq x = y\neq y = -x\neq z = 0\nintegral level = z^2/z\n"
    "reduction wrong : by at_height.tt with q = x, p = y, h = level\n",
    "model anywhere\nstate x\nstate y\nstate z\ndomain other : z^2 > 0\neq x = y\neq y = -x\neq z = 0\n"
    "reduction wrong : by at_height.tt with q = x, p = y, h = z\n",
    "model small\nstate x\neq x = x\nlift wrong : into larger.tt with u = x, v = 0\n",
    "model moved\nstate x\nstate y\nstate z\nlet none = 1/(3*y - 1)\neq x = y\neq y = 0\neq z = y\nintegral level = y\n"
    "section wrong : by of_speed.tt at x = 0 with z = z + 0*none, V = level\n",
    "model third\nstate x\neq x = 0\npositive square : (3*x - 1)^2\n",
    "model turn\nstate x\nangle c s = cos(x) sin(x)\neq x = 0\npositive square : c^2\n",
    "model plane\nstate x\nstate y\nstate z\neq x = x\neq y = y\neq z = z\ninvariant sheet = x - y\n"
    "reduction wrong : onto growing.tt with u = x, v = y modulo sheet\n",
    "model plane\nstate x\nstate y\nstate z\neq x = x\neq y = y\neq z = z\n"
    "reduction wrong : onto growing.tt with u = x, v = x + y when y = x, z = x\n",
    "model plane\nstate x\nstate y\nstate z\neq x = x\neq y = y\neq z = z\ninvariant sheet = x - y\n"
    "embedding wrong : into growing.tt with u = x, v = y modulo sheet\n",
    "model kept\nstate x\neq x = 0\nreduction wrong : onto resting.tt with u = x, k = 2*x\n",
    "model origin\nstate x\nstate y\nstate z\neq x = 0\neq y = 0\neq z = 0\npositive square : x^2 + y^2 + z^2\n",
    "model apart\nstate x\nstate y\nangle c s = cos(x + y) sin(x + y)\neq x = 0\neq y = 0\n"
    "positive squares : (c + 3/4)^2 + (9*y^2 + 6*y - 26)^2\n",
};

/* The family is one of equilibria, and the trace is zero on it. */
static const char no_trace[] =
    "model turn\nstate x\nstate y\neq x = y\neq y = -x\nequilibria rest : x = 0, y = 0\nobstructs rest\n";

/* Tables to which others lead. */
static const struct {
    const char *file, *text;
} targets[] = {
    { "chart.tt", "model chart\nstate P\nstate Z\ndomain moving : P^2 > 0\nroot R = sqrt(P^2)\n"
                  "lift into crossing.tt with q = 0, p = R, z = Z\n" },
    { "of_speed.tt", "model of_speed\nparam V\nstate z\nlift into moved.tt with x = 0, y = V, z = z\n" },
    { "undefined.tt", "model undefined\nparam V\nstate z\nlet none = 1/z\nlift into moved.tt with x = 0, y = V, z = z + 0*none\n" },
    { "with_root.tt", "model with_root\nstate y\nroot r = sqrt(1/y)\neq y = 2*y\n" },
    { "with_angle.tt", "model with_angle\nstate y\nangle c s = cos(1/y) sin(1/y)\neq y = 2*y + 0*c\n" },
    { "rooted.tt", "model rooted\nstate y\ndomain apart : y^2 > 0\nroot r = sqrt(y^2)\neq y = y\n" },
    { "watched.tt", "model watched\nstate y\neq y = y\nobserve seen = y^2\nvalid kept : y > 0\n" },
    { "at_height.tt", "model at_height\nparam h\nstate q\nstate p\neq q = p\neq p = -q\n"
                      "embedding up : into anywhere.tt with x = q, y = p, z = h\n" },
    { "growing.tt", "model growing\nstate u\nstate v\neq u = u\neq v = v\n" },
    { "resting.tt", "model resting\nparam k\nstate u\neq u = 0*k\n" },
    { "larger.tt", "model larger\nstate u\nstate v\neq u = u\neq v = 0\ninvariant level = v^2/v - v\n"
                   "reduction back : onto small.tt with x = u modulo level\n" },
};

/* Where P < 0, the lift leads back to -P; no state is at such a point of the chart. */
static const char crossing[] =
    "model crossing\nstate q\nstate p\nstate z\ndomain moving : p^2 > 0\nroot r = sqrt(p^2)\neq q = p\neq p = -q\neq z = 0\n"
    "section up : by chart.tt at q = 0 with P = r, Z = z\n";

static ttc_model *resolve(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    (void)context;
    (void)model;
    for (size_t i = 0; i < sizeof targets / sizeof *targets; i++)
        if (strcmp(targets[i].file, target) == 0)
            return ttc_model_parse(targets[i].text, strlen(targets[i].text), target, diagnostics);
    return NULL;
}

static ttc_proof_report *prove(const char *text, ttc_model **model)
{
    ttc_proof_report *report = NULL;
    *model = parse_text(text);
    assert_true(ttc_prove(*model, resolve, NULL, TTC_PROVE_ALL, &report));
    return report;
}

static ttc_challenge_report *challenge_at(const char *text, ttc_proof_status status, size_t points)
{
    ttc_model *model;
    ttc_challenge_report *challenged = NULL;
    ttc_proof_report *report = prove(text, &model);
    for (size_t i = 0; i < report->proof_count; i++) {
        report->proofs[i].status = status;
        report->proofs[i].has_smooth_density |= strcmp(report->proofs[i].name, "smooth") == 0;
    }
    const ttc_challenge_extent extent = { .points = points };
    assert_true(ttc_challenge(model, report, resolve, NULL, &extent, &challenged));
    for (size_t i = 0; i < challenged->count; i++) challenged->results[i].name = NULL; /* the report's, which goes */
    ttc_proof_report_destroy(report);
    ttc_model_destroy(model);
    return challenged;
}

static ttc_challenge_report *challenge_as(const char *text, ttc_proof_status status) { return challenge_at(text, status, POINTS); }

static void print(const ttc_challenge_result *result)
{
    print_error("line %u, %s: %zu tried, %zu skipped, %s\n", (unsigned)result->place.line, result->kind, result->tried,
                result->skipped, result->text != NULL ? result->text : "not contradicted");
}

static void false_claims_called_proved_are_contradicted(void **state)
{
    (void)state;
    ttc_challenge_report *report = challenge_as(false_claims, TTC_PROVED);
    assert_true(report->count >= 21);
    for (size_t i = 0; i < report->count; i++)
        if (!report->results[i].contradicted) print(&report->results[i]);
    assert_int_equal(report->contradictions, report->count);
    ttc_challenge_report_destroy(report);
}

static void claims_that_are_false_at_special_points_are_contradicted(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof rarely_false / sizeof *rarely_false; k++) {
        size_t contradicted = 0;
        ttc_challenge_report *report = challenge_as(rarely_false[k], TTC_PROVED);
        for (size_t i = 0; i < report->count; i++) contradicted += report->results[i].contradicted;
        for (size_t i = 0; i < report->count && contradicted != 1; i++) print(&report->results[i]);
        assert_int_equal(contradicted, 1);
        ttc_challenge_report_destroy(report);
    }
}

static void coordinates_that_no_state_has_are_looked_at(void **state)
{
    (void)state;
    ttc_challenge_report *report = challenge_as(crossing, TTC_PROVED);
    assert_true(report->results[0].contradicted);
    assert_non_null(strstr(report->results[0].text, "at the point of chart with P = -"));
    ttc_challenge_report_destroy(report);
}

static void the_point_is_shown_that_was_drawn(void **state)
{
    (void)state;
    ttc_challenge_report *report = challenge_as("model edge\nstate x in (0, inf)\neq x = 0\nreversor x -> -x\n", TTC_PROVED);
    assert_true(report->results[0].contradicted);
    assert_null(strstr(report->results[0].text, "x = -"));
    ttc_challenge_report_destroy(report);
}

static void an_obstruction_without_a_trace_is_contradicted(void **state)
{
    (void)state;
    ttc_challenge_report *report = challenge_as(no_trace, TTC_PROVED);
    assert_int_equal(report->contradictions, 1);
    ttc_challenge_report_destroy(report);
}

static void true_claims_called_proved_stand(void **state)
{
    (void)state;
    ttc_challenge_report *report = challenge_as(true_claims, TTC_PROVED);
    assert_true(report->count >= 21);
    for (size_t i = 0; i < report->count; i++) {
        const ttc_challenge_result *result = &report->results[i];
        bool has_points = result->tried > POINTS / 2;
        if (result->contradicted || !has_points) print(result);
        assert_false(result->contradicted);
        assert_true(has_points);
    }
    ttc_challenge_report_destroy(report);
}

/* One special point in two has x = 0, from which each place that is looked at is another. */
static void what_divides_at_other_states_stands(void **state)
{
    enum { MANY = 20000 };
    (void)state;
    ttc_challenge_report *report = challenge_at("model pole\nstate x\neq x = 1\nobserve o = 1/x\n", TTC_PROVED, MANY);
    if (report->contradictions > 0) print(&report->results[0]);
    assert_int_equal(report->contradictions, 0);
    assert_int_equal(report->results[0].special, MANY);
    ttc_challenge_report_destroy(report);
}

/* Nothing is said of h = 0, where a condition divides by zero, of x = 0 and b = 0, nor of a family at a = 0. */
static void nothing_is_said_where_a_condition_divides_by_zero(void **state)
{
    static const char anywhere[] =
        "model anywhere\nstate x\nstate y\nstate z\neq x = y\neq y = -x\neq z = 0\nintegral level = z^2/z\n"
        "reduction right : by at_height.tt with q = x, p = y, h = level where z/z > 0\n";
    static const char *const tables[] = {
        anywhere,
        "model line\nparam a > 0\nparam b >= 0\nstate x\nlet none = 1/x\neq x = a*x\ntime right : x^4/x^2\n",
        "model line\nparam a > 0\nparam b >= 0\nstate x\nlet none = 1/x\neq x = a*x\ntime right : x^2 + 0*none\n",
        "model line\nparam a > 0\nparam b >= 0\nstate x\neq x = a*x\nvariant right : a = b^2/b\n",
        "model half_line\nparam a >= 0\nparam b\nstate x in (0, inf)\neq x = 0\nequilibria right : x = a when b = a/a\n",
    };
    (void)state;
    for (size_t k = 0; k < sizeof tables / sizeof *tables; k++) {
        ttc_challenge_report *report = challenge_as(tables[k], TTC_PROVED);
        if (report->contradictions > 0) print(&report->results[report->count - 1]);
        assert_int_equal(report->contradictions, 0);
        assert_true(report->results[report->count - 1].special > POINTS / 4);
        ttc_challenge_report_destroy(report);
    }
}

/* Kinds whose failures may be too thin to be met are only noted. */
static void true_identities_called_refuted_are_contradicted(void **state)
{
    static const char *const identities[] = { "integral", "rate", "measure", "trace", "matrix", "leftnull", "obstructs" };
    (void)state;
    ttc_challenge_report *report = challenge_as(true_claims, TTC_REFUTED);
    for (size_t k = 0; k < sizeof identities / sizeof *identities; k++) {
        bool met = false;
        for (size_t i = 0; i < report->count; i++) {
            if (strcmp(report->results[i].kind, identities[k]) != 0) continue;
            met = true;
            if (!report->results[i].contradicted) print(&report->results[i]);
            assert_true(report->results[i].contradicted);
        }
        assert_true(met);
    }
    ttc_challenge_report_destroy(report);
}

static void false_claims_called_refuted_stand(void **state)
{
    (void)state;
    ttc_challenge_report *report = challenge_as(false_claims, TTC_REFUTED);
    for (size_t i = 0; i < report->count; i++) {
        if (strcmp(report->results[i].kind, "integral") == 0 && report->results[i].contradicted)
            continue; /* the vacuous one holds everywhere */
        if (report->results[i].contradicted) print(&report->results[i]);
        assert_false(report->results[i].contradicted);
    }
    ttc_challenge_report_destroy(report);
}

static void the_same_seed_gives_the_same_points(void **state)
{
    (void)state;
    ttc_challenge_report *first = challenge_as(false_claims, TTC_PROVED), *second = challenge_as(false_claims, TTC_PROVED);
    assert_int_equal(first->count, second->count);
    for (size_t i = 0; i < first->count; i++) assert_string_equal(first->results[i].text, second->results[i].text);
    ttc_challenge_report_destroy(second);
    ttc_challenge_report_destroy(first);
}

/* Of 4000 numbers a sixteenth are 0, and 7 of 16 of either sign; tails of ten standard deviations, 32 at most each. */
static void sampled_numbers_have_the_signs_and_ranges_that_are_said(void **state)
{
    (void)state;
    enum { COUNT = 4000 };
    for (ttc_sample_range range = TTC_SAMPLE_WIDE; range <= TTC_SAMPLE_MODERATE; range++) {
        ttc_random random = { 1 };
        int zeros = 0, negative = 0;
        double least = 1, most = 1;
        fmpq_t value;
        fmpq_init(value);
        for (int i = 0; i < COUNT; i++) {
            ttc_sample_any(value, &random, range);
            zeros += fmpq_is_zero(value);
            negative += fmpq_sgn(value) < 0;
            ttc_sample_positive(value, &random, range);
            assert_true(fmpq_sgn(value) > 0);
            const double size = fmpq_get_d(value);
            least = fmin(least, size);
            most = fmax(most, size);
            ttc_sample_unit(value, &random, range);
            assert_true(fmpq_sgn(value) > 0 && fmpq_cmp_si(value, 1) < 0);
        }
        assert_true(abs(zeros - COUNT / 16) < 160 && abs(negative - COUNT * 7 / 16) < 320);
        if (range == TTC_SAMPLE_MODERATE) assert_true(least >= 1e-3 && most <= 1e3);
        else assert_true(least < 1e-12 && least > ldexp(1e-3, -40) && most > 1e12 && most < ldexp(1e3, 40));
        fmpq_clear(value);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(false_claims_called_proved_are_contradicted),
        cmocka_unit_test(claims_that_are_false_at_special_points_are_contradicted),
        cmocka_unit_test(coordinates_that_no_state_has_are_looked_at),
        cmocka_unit_test(the_point_is_shown_that_was_drawn),
        cmocka_unit_test(an_obstruction_without_a_trace_is_contradicted),
        cmocka_unit_test(true_claims_called_proved_stand),
        cmocka_unit_test(what_divides_at_other_states_stands),
        cmocka_unit_test(nothing_is_said_where_a_condition_divides_by_zero),
        cmocka_unit_test(true_identities_called_refuted_are_contradicted),
        cmocka_unit_test(false_claims_called_refuted_stand),
        cmocka_unit_test(the_same_seed_gives_the_same_points),
        cmocka_unit_test(sampled_numbers_have_the_signs_and_ranges_that_are_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
