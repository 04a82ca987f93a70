/* Memory runs out in the prover, at one allocation after the other: nothing crashes, and a verdict is the right one or is missing
 * by name. FLINT's own allocations are left alone: it ends the program when one fails. */
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "fault/failing_memory.h"
#include "base/text.h"
#include "prove/prove.h"
#include "read/model.h"

/* A variant, a time of its own with a root lifted, an elimination, a family, a measure; and claims that are false. */
static const char table[] =
    "model t\nparam a > 0\nparam k\nstate x in (-1, 1)\nstate y\nroot s = sqrt(1 - x^2)\nlet d = a + k^2*s^2\n"
    "eq x = s*y\neq y = -x*y/s + a*x*s/d - a*x*s/d\n"
    "integral P = y/s\nintegral wrong = y + k*x\ninvariant line = y\nmeasure rho = 1/s^2\nequilibria rest : y = 0\n  trace rest = "
    "0\n"
    "reversor y -> -y\nvariant plain : k = 0\ntime u : s lifting s\neliminate c : y by P = L\ndefault a = 1\n";

/* Angles, logarithms and exponentials that depend on each other: what is not known of them must not be taken for independence. */
static const char dependent[] =
    "model t\nstate x in (0, inf)\nstate q\nangle c s = cos(q) sin(q)\nangle c2 s2 = cos(2*q) sin(2*q)\n"
    "log l = log(x)\nlog l2 = log(x^2)\nexp e = exp(q)\nexp e2 = exp(2*q)\neq x = 0\neq q = 0\n"
    "equal doubled : c2 = 2*c^2 - 1\nequal squared : l2 = 2*l\nequal powered : e2 = e^2\n";

static ttc_model *read_table(const char *text)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(text, strlen(text), "t.tt", diagnostics);
    ttc_diagnostics_print(diagnostics, stderr);
    ttc_diagnostics_destroy(diagnostics);
    assert_non_null(model);
    return model;
}

/* All that is proved, as text; true when memory was enough. */
static bool proofs(ttc_text *out, const ttc_model *model)
{
    ttc_proof_report *report = NULL;
    const bool done = ttc_prove(model, ttc_resolve_beside, NULL, TTC_PROVE_ALL, &report);
    for (size_t i = 0; done && i < report->proof_count; i++)
        ttc_text_format(out, "%s %s: %s\n", report->proofs[i].kind, report->proofs[i].name,
                        ttc_proof_status_name(report->proofs[i].status));
    ttc_proof_report_destroy(report);
    return done;
}

/* Whether every verdict is the right one, or there is none. */
static void verdicts_agree(const char *found, const char *right, long allocation)
{
    for (; *found != '\0' && *right != '\0'; found = strchr(found, '\n') + 1, right = strchr(right, '\n') + 1) {
        const size_t length = (size_t)(strchr(found, '\n') - found), missing = strlen("not settled");
        if (strncmp(found, right, length + 1) != 0 && memcmp(found + length - missing, "not settled", missing) != 0)
            fail_msg("allocation %ld: '%.*s'", allocation, (int)length, found);
    }
    assert_int_equal(*found, *right);
}

/* A new model every time, for its graph grows. */
static void run_out(const char *text_of_table, long stride)
{
    ttc_text whole = { 0 };
    ttc_model *model = read_table(text_of_table);
    bool met = true;
    long allocation = 0;

    assert_true(proofs(&whole, model));
    assert_false(whole.failed);
    ttc_model_destroy(model);
    for (; met; allocation += stride) {
        ttc_text text = { 0 };
        model = read_table(text_of_table);
        failing = allocation;
        const bool done = proofs(&text, model);
        met = failing < 0;
        failing = -1;
        if (done && !text.failed) verdicts_agree(ttc_text_string(&text), ttc_text_string(&whole), allocation);
        if (!met) assert_string_equal(ttc_text_string(&text), ttc_text_string(&whole));
        ttc_text_clear(&text);
        ttc_model_destroy(model);
    }
    ttc_text_clear(&whole);
    assert_true(allocation > 100);
}

/* Strides that have no factor in common with what loops allocate. */
static void verdicts_are_right_or_missing(void **unused)
{
    (void)unused;
    run_out(table, 17);
    run_out(dependent, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_are_right_or_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
