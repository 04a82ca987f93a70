/* Tables of the project, and tables that were written from the description of the language alone: in those a line that ends
 * in `# refuted` or `# error` holds a claim that is false or says nothing, known so from the literature or by hand. */
#include "prove_text.h"

static bool line_says(const ttc_model *model, uint32_t line, const char *mark)
{
    const char *start = model->text;
    for (uint32_t i = 1; i < line; i++) start = strchr(start, '\n') + 1;
    const char *end = strchr(start, '\n'), *found = strstr(start, mark);
    return found != NULL && (end == NULL || found < end);
}

static ttc_proof_status expected(const ttc_model *model, const ttc_proof *proof)
{
    if (line_says(model, proof->place.line, "# refuted")) return TTC_REFUTED;
    if (line_says(model, proof->place.line, "# error")) return TTC_UNSETTLED;
    return TTC_PROVED;
}

static size_t check_table(const char *path)
{
    ttc_proof_report *report = NULL;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_read(path, diagnostics);
    if (model == NULL) ttc_diagnostics_print(diagnostics, stderr);
    assert_non_null(model);
    assert_true(ttc_prove(model, ttc_resolve_beside, NULL, TTC_PROVE_ALL, &report));
    size_t wrong = 0;
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = &report->proofs[i];
        if (proof->status == expected(model, proof)) continue;
        wrong++;
        print_error("%s:%u: %s %s: %s: %s\n", path, (unsigned)proof->place.line, proof->kind, proof->name,
                    ttc_proof_status_name(proof->status), proof->remainder != NULL ? proof->remainder : "");
    }
    print_message("%s: %zu proved, %zu refuted, %zu not settled\n", report->model, report->proved, report->refuted,
                  report->unsettled);
    size_t count = report->proof_count;
    assert_int_equal(wrong, 0);
    ttc_proof_report_destroy(report);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
    return count;
}

static void every_claim_of_the_shipped_tables_is_proved(void **state)
{
    (void)state;
    assert_true(check_tables(JLT_SOURCE_DIR "/codegen/models", check_table) > 80);
}

static void unseen_tables_are_proved_and_refuted_as_known(void **state)
{
    (void)state;
    assert_true(check_tables(JLT_SOURCE_DIR "/tests/proof/models", check_table) > 90);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_claim_of_the_shipped_tables_is_proved),
        cmocka_unit_test(unseen_tables_are_proved_and_refuted_as_known),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
