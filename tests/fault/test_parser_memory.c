/* Memory runs out at every single allocation of the front end, one after the other: nothing crashes, nothing leaks (under
 * the sanitizer), and an incomplete model is never handed out. FLINT's own allocations are left alone: it ends the program
 * when one fails. */
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "fault/failing_memory.h"
#include "read/model.h"
#include "show/print.h"

static char *read_table(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    char *text = malloc(1 << 20);
    assert_non_null(file);
    assert_non_null(text);
    *length = fread(text, 1, 1 << 20, file);
    fclose(file);
    return text;
}

/* Returns true when the table was read without meeting the failing allocation. */
static int survives(const char *text, size_t length, long allocation, const char *digest)
{
    FILE *sink = fopen("/dev/null", "w");
    assert_non_null(sink);
    failing = allocation;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    if (diagnostics != NULL) {
        ttc_model *model = ttc_model_parse(text, length, "t.tt", diagnostics);
        assert_true((model == NULL) == (ttc_error_count(diagnostics) > 0));
        if (model != NULL) {
            assert_string_equal(model->sha256, digest);
            for (size_t i = 0; i < model->state_count; i++) {
                ttc_id slope = ttc_model_partial(model, ttc_model_field(model, i), model->states[0]);
                if (slope != TTC_NONE) ttc_print(sink, model, slope, TTC_NOTATION_LATEX);
                ttc_model_expand(model, ttc_model_field(model, i));
            }
        }
        ttc_diagnostics_print(diagnostics, sink);
        ttc_model_destroy(model);
    }
    ttc_diagnostics_destroy(diagnostics);
    int met = failing < 0;
    failing = -1;
    fclose(sink);
    return !met;
}

static void runs_out_everywhere(const char *path, long least)
{
    size_t length;
    char *text = read_table(path, &length);
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(text, length, "t.tt", diagnostics);
    assert_non_null(model);
    long allocation = 0;
    while (!survives(text, length, allocation, model->sha256)) allocation++;
    assert_true(allocation > least); /* the test did reach into the parser */
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
    free(text);
}

static void a_table_of_every_record_survives_each_failure(void **unused)
{
    (void)unused;
    runs_out_everywhere(JLT_SOURCE_DIR "/tests/fuzz/corpus/parser/extensions.tt", 200);
}

static void a_real_model_survives_each_failure(void **unused)
{
    (void)unused;
    runs_out_everywhere(JLT_SOURCE_DIR "/codegen/models/chaplygin_sleigh.tt", 200);
}

static void a_wrong_table_survives_each_failure(void **unused)
{
    (void)unused;
    size_t length;
    char *text = read_table(JLT_SOURCE_DIR "/tests/fuzz/corpus/parser/broken.tt", &length);
    long allocation = 0;
    while (!survives(text, length, allocation, "")) allocation++;
    assert_true(allocation > 20);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_of_every_record_survives_each_failure),
        cmocka_unit_test(a_real_model_survives_each_failure),
        cmocka_unit_test(a_wrong_table_survives_each_failure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
