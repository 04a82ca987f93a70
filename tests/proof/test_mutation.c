/* Every term of every shipped table matters to some claim: with its sign flipped, or dropped, a claim is refuted. A mutant
 * that the reader refuses is no table, and counts neither way. The 202 of spherical_top_full.tt take longer than all others
 * together, and are a slow test of their own: mutation_of_full_slow.sh. */
#include "prove_text.h"

#include "prove/mutate.h"

/* Mutants that no claim of a table refutes. */
static size_t survivors(const char *path)
{
    if (strstr(path, "/spherical_top_full.tt") != NULL) return 0;
    ttc_mutation_report *report = NULL;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_read(path, diagnostics);
    assert_non_null(model);
    assert_true(ttc_mutate(model, ttc_resolve_beside, NULL, &report));
    for (size_t i = 0; i < report->count; i++)
        if (report->mutants[i].fate == TTC_MUTANT_SURVIVED)
            print_error("%s:%u:%u: survived: '%.*s' %s\n", path, (unsigned)report->mutants[i].place.line,
                        (unsigned)report->mutants[i].place.column, (int)report->mutants[i].term_length,
                        report->mutants[i].term, report->mutants[i].dropped ? "dropped" : "flipped");
    print_message("%s: %zu of %zu mutants refuted, %zu refused by the reader\n", model->name, report->refuted,
                  report->count - report->unreadable, report->unreadable);
    assert_true(report->count >= 2 * model->state_count);
    const size_t survived = report->survived;
    ttc_mutation_report_destroy(report);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
    return survived;
}

static void every_mutant_of_the_shipped_tables_is_refuted(void **state)
{
    (void)state;
    assert_int_equal(check_tables(JLT_SOURCE_DIR "/codegen/models", survivors), 0);
}

/* x' = y, y' = -x + c x with no claim that sees c. */
static void a_term_that_no_claim_sees_survives(void **state)
{
    (void)state;
    ttc_mutation_report *report = NULL;
    ttc_model *model = parse_text("model blind\nparam c\nstate x\nstate y\neq x = y\neq y =\n - x\n + c*x\n"
                                  "measure volume = 1\nreversor y -> -y\n");
    assert_true(ttc_mutate(model, NULL, NULL, &report));
    assert_int_equal(report->count, 6);
    assert_int_equal(report->survived, 6);
    ttc_mutation_report_destroy(report);
    ttc_model_destroy(model);
}

/* A rate that is 0 has no term to flip or drop: such a mutant would be the table itself, and survive whatever is claimed. */
static void the_term_0_gives_no_mutant(void **state)
{
    (void)state;
    ttc_mutation_report *report = NULL;
    ttc_model *model = parse_text("model rest\nstate x\nstate y\neq x = 0\neq y =\n + 0\n + x\n"
                                  "integral X = x\nrate Y : y = x\n");
    assert_true(ttc_mutate(model, NULL, NULL, &report));
    assert_int_equal(report->count, 2);
    assert_int_equal(report->refuted, 2);
    ttc_mutation_report_destroy(report);
    ttc_model_destroy(model);
}

/* x' = y, y' = -x keeps no x^2: every mutant would fail this claim as the table itself does, although nothing else sees y. */
static void a_claim_that_the_table_fails_judges_no_mutant(void **state)
{
    (void)state;
    ttc_mutation_report *report = NULL;
    ttc_model *model = parse_text("model broken\nstate x\nstate y\neq x = y\neq y =\n - x\nintegral wrong = x^2\n");
    assert_true(ttc_mutate(model, NULL, NULL, &report));
    assert_string_equal(report->broken, "wrong");
    assert_int_equal(report->count, 0);
    assert_int_equal(report->refuted, 0);
    ttc_mutation_report_destroy(report);
    ttc_model_destroy(model);
}

/* Terms: y; -x; +x^3/(1 + c), its sum 1 + c; in the let 2*c alone. */
static void every_term_gives_two_mutants(void **state)
{
    (void)state;
    ttc_mutation_report *report = NULL;
    ttc_model *model = parse_text("model count\nparam c\nlet d = 2*c\nstate x\nstate y\neq x = y\neq y =\n - x\n"
                                  " + x^(-3)/(1 + d)\nintegral E = y^2/2 + x^2/2 + x^(-2)/(2*(1 + 2*c))\n");
    assert_true(ttc_mutate(model, NULL, NULL, &report));
    assert_int_equal(report->count, 2 * 6);
    assert_int_equal(report->refuted, report->count);
    ttc_mutation_report_destroy(report);
    ttc_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_mutant_of_the_shipped_tables_is_refuted),
        cmocka_unit_test(a_term_that_no_claim_sees_survives),
        cmocka_unit_test(every_term_gives_two_mutants),
        cmocka_unit_test(the_term_0_gives_no_mutant),
        cmocka_unit_test(a_claim_that_the_table_fails_judges_no_mutant),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
