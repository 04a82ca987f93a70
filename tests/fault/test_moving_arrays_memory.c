/* Arrays that grow move each time, and what they leave is overwritten at once: whoever keeps a pointer into one across a call that
 * lets it grow reads nonsense, with or without a sanitizer. */
#include "unit/check.h"

#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>

#include <flint/fmpz.h>

#include "fault/wrapped_memory.h"
#include "fields/field.h"
#include "optimize/program.h"
#include "read/model.h"

void *__wrap_malloc(size_t size) { return __real_malloc(size); }
void *__wrap_calloc(size_t count, size_t size) { return __real_calloc(count, size); }
void *__wrap_aligned_alloc(size_t alignment, size_t size) { return __real_aligned_alloc(alignment, size); }

void *__wrap_realloc(void *old, size_t size)
{
    void *moved = __real_malloc(size);
    if (moved == NULL || old == NULL) return moved;
    size_t held = malloc_usable_size(old);
    memcpy(moved, old, held < size ? held : size);
    memset(old, 0x55, held);
    free(old);
    return moved;
}

enum { UNITS = 200 }; /* more than a field has room for when it is made */

/* Each unit is a sum over the one before, so that all their derivatives come into being while that of the last is asked for. */
static ttc_model *chain(ttc_diagnostics *diagnostics, const char *function)
{
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    assert_non_null(stream);
    fprintf(stream, "model chain\nstate x\nlet u0 = x^2 + x\n");
    for (int i = 1; i < UNITS; i++) fprintf(stream, "let u%d = u%d/2 + x^2\n", i, i - 1);
    fprintf(stream, "%s\neq x = C\n", function);
    assert_int_equal(fclose(stream), 0);
    ttc_model *model = ttc_model_parse(text, length, "chain.tt", diagnostics);
    free(text);
    return model;
}

static void derivatives_survive_the_symbols_that_they_add(void **unused)
{
    (void)unused;
    static const char *const functions[] = { "angle C S = cos(u199) sin(u199)", "exp C = exp(u199)", "root C = sqrt(u199)",
                                             "log C = log(u199)", "let C = u199*x + 1" };
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        ttc_diagnostics *diagnostics = ttc_diagnostics_create();
        ttc_model *model = chain(diagnostics, functions[i]);
        ttc_field *field = NULL;
        if (model == NULL) ttc_diagnostics_print(diagnostics, stderr);
        assert_non_null(model);
        assert_int_equal(ttc_field_create(&field, model, NULL, NULL, NULL), TTC_FIELD_OK);
        ttc_id slope = ttc_field_partial(field, field->rhs[0], 0);
        assert_true(slope != TTC_NONE && field->symbol_count > model->symbol_count + UNITS - 2);
        /* The outer derivative times a unit: of a cosine with its sign. */
        if (i == 0) {
            assert_int_equal(ttc_part_count(field->graph, slope), 2);
            assert_true(fmpq_cmp_si(ttc_coefficient(field->graph, slope), -1) == 0);
        }
        ttc_field_destroy(field);
        ttc_model_destroy(model);
        ttc_diagnostics_destroy(diagnostics);
    }
}

static void constants_are_folded_while_the_program_grows(void **unused)
{
    (void)unused;
    for (long count = 0; count < 200; count++) {
        ttc_program *program = ttc_program_create();
        fmpq_t large;
        fmpq_init(large);
        for (long i = 2; i < count + 2; i++) assert_true(ttc_program_integer(program, i) != TTC_NO_VALUE);
        /* One that lives in the heap: a number of two words. */
        fmpz_set_ui(fmpq_numref(large), 3);
        fmpz_pow_ui(fmpq_numref(large), fmpq_numref(large), 70);
        ttc_value negated = ttc_program_negate(program, ttc_program_constant(program, large));
        assert_false(ttc_program_failed(program));
        fmpq_neg(large, large);
        assert_int_equal(negated, ttc_program_constant(program, large));
        fmpq_clear(large);
        ttc_program_destroy(program);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_survive_the_symbols_that_they_add),
        cmocka_unit_test(constants_are_folded_while_the_program_grows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
