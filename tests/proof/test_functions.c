/* What stands beside the kernels of a field, its families of equilibria, the coordinates of its sections and the ways to other
 * tables, is read back from the C that is emitted. Every function of the top's tables is proved; a text in which one operation,
 * operand or constant is another is not. */
#include "prove_text.h"

#include "readback/prove_functions.h"

#include <ctype.h>

typedef struct {
    ttc_model *model;
    ttc_catalogue catalogue;
    ttc_kernels *general; /* in the time in which its roots are states */
    ttc_text text;
} table;

static void open_table(table *t, const char *path)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    *t = (table){ .model = ttc_model_read(path, diagnostics) };
    assert_non_null(t->model);
    ttc_diagnostics_destroy(diagnostics);
    assert_true(ttc_catalogue_create(&t->catalogue, t->model, TTC_WITHOUT_ELIMINATIONS, TTC_EFFORT_QUICK));
    for (size_t i = 0; i < t->catalogue.count; i++)
        if (ttc_field_is_general(t->catalogue.fields[i].kernels->field)) t->general = t->catalogue.fields[i].kernels;
    assert_true(ttc_prove_functions_emit(&t->text, t->general));
}

static void close_table(table *t)
{
    ttc_text_clear(&t->text);
    ttc_catalogue_clear(&t->catalogue);
    ttc_model_destroy(t->model);
}

static void clear(ttc_proof_report *report)
{
    for (size_t i = 0; i < report->proof_count; i++) {
        free(report->proofs[i].name);
        free(report->proofs[i].remainder);
    }
    free(report->proofs);
}

static void every_function_computes_what_its_record_says(void **state)
{
    static const char *const names[] = { "spherical_top", "spherical_top_level", "spherical_top_balanced", "routh_sphere" };
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[512];
        table t;
        ttc_proof_report report = { 0 };
        snprintf(path, sizeof path, "%s/codegen/models/%s.tt", JLT_SOURCE_DIR, names[i]);
        open_table(&t, path);
        assert_true(ttc_prove_functions(&t.catalogue, &report));
        for (size_t k = 0; k < report.proof_count; k++)
            if (report.proofs[k].status != TTC_PROVED) print_error("%s: %s\n", report.proofs[k].name, report.proofs[k].remainder);
        assert_true(report.proof_count >= 7 && report.proved == report.proof_count);
        print_message("%s: %zu functions proved\n", names[i], report.proved);
        clear(&report);
        close_table(&t);
    }
}

static bool is_refuted(const table *t, const char *text)
{
    ttc_proof_report report = { 0 };
    assert_true(ttc_prove_functions_in(text, t->general, &report));
    const bool refuted = report.proved < report.proof_count;
    clear(&report);
    return refuted;
}

/* What another character at this place of a statement would be; 0: none that changes what is computed. */
static char exchanged(const char *text, const char *at)
{
    const char before = at > text ? at[-1] : '\n';
    if (*at == '+' && before == ' ') return '-';
    if (*at == '-' && before == ' ' && at[1] == ' ') return '+';
    if (*at == '*' && at[1] != '/' && before != '/') return '/';
    if (isdigit((unsigned char)*at) && before == '[' && at[1] == ']') return *at == '0' ? '1' : '0'; /* x[3], params[3], out[3] */
    if (isdigit((unsigned char)*at) && before == ' ' && at[1] == '.') return (char)(*at == '9' ? '8' : *at + 1); /* 2.0 */
    return 0;
}

/* Exchanges characters of functions whose name has `word` in turn, every stride-th that can be; returns how many. */
static size_t exchange(table *t, const char *word, size_t stride)
{
    char *text = t->text.bytes;
    size_t count = 0, seen = 0;
    bool inside = false, comment = false;
    for (char *at = text; *at != '\0'; at++) {
        if (at == text || at[-1] == '\n') {
            const size_t length = strcspn(at, "\n");
            const char *found = strstr(at, word);
            if (strncmp(at, "static ", 7) == 0)
                inside = strncmp(at, "static void ", 12) == 0 && found != NULL && found < at + length;
            if (*at == '}') inside = false;
            comment = strncmp(at, "static", 6) == 0;
        }
        if (strncmp(at, "/* ", 3) == 0) comment = true;
        const char other = inside && !comment ? exchanged(text, at) : 0;
        if (other == 0 || seen++ % stride != 0) continue;
        const char kept = *at;
        *at = other;
        const bool refuted = is_refuted(t, text);
        if (!refuted) print_error("%.60s: not noticed\n", at - 30 < text ? text : at - 30);
        *at = kept;
        assert_true(refuted);
        count++;
    }
    assert_false(is_refuted(t, text));
    return count;
}

static void a_text_with_one_change_is_refuted(void **state)
{
    table t;
    size_t count;
    (void)state;
    open_table(&t, JLT_SOURCE_DIR "/codegen/models/spherical_top_balanced.tt");
    count = exchange(&t, "way0_", 4);
    print_message("%zu changes of ways are noticed\n", count);
    assert_true(count > 30);
    close_table(&t);
    open_table(&t, JLT_SOURCE_DIR "/codegen/models/chaplygin_sleigh.tt");
    count = exchange(&t, "family0_", 1);
    print_message("%zu changes of families are noticed\n", count);
    assert_true(count > 20);
    close_table(&t);
    open_table(&t, JLT_SOURCE_DIR "/codegen/models/spherical_top_level.tt");
    count = exchange(&t, "section0_", 60);
    print_message("%zu changes of sections are noticed\n", count);
    assert_true(count > 5);
    close_table(&t);
}

/* A function that is not there, and one that is there twice, of which the compiler would take neither. */
static void a_text_without_a_function_is_refuted(void **state)
{
    table t;
    ttc_text twice = { 0 };
    (void)state;
    open_table(&t, JLT_SOURCE_DIR "/codegen/models/spherical_top_balanced.tt");
    assert_true(is_refuted(&t, ""));
    ttc_text_add(&twice, ttc_text_string(&t.text));
    ttc_text_add(&twice, ttc_text_string(&t.text));
    assert_true(is_refuted(&t, ttc_text_string(&twice)));
    ttc_text_clear(&twice);
    close_table(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_function_computes_what_its_record_says),
        cmocka_unit_test(a_text_with_one_change_is_refuted),
        cmocka_unit_test(a_text_without_a_function_is_refuted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
