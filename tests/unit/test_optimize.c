/* What the optimizer does to the longest chain of operations, for an integration waits for each of its calls. */
#include "unit/check.h"

#include <stdlib.h>

#include "base/diagnostic.h"
#include "kernels/kernels.h"
#include "read/model.h"
#include "optimize/program.h"

/* 1/sqrt(x x + 1), with y y beside it: 1 + 1 + 5 + 4 multiplications one after another, whatever else is there. */
static void latency_is_that_of_the_longest_chain(void **unused)
{
    (void)unused;
    ttc_program *program = ttc_program_create();
    ttc_value x = ttc_program_input(program, 0), y = ttc_program_input(program, 1), one = ttc_program_integer(program, 1);
    ttc_value sum = ttc_program_add(program, ttc_program_multiply(program, x, x), one);
    ttc_program_output(program, ttc_program_multiply(program, y, y));
    assert_int_equal(ttc_program_latency(program), 2);
    ttc_program_output(program, ttc_program_divide(program, one, ttc_program_root(program, sum)));
    assert_false(ttc_program_failed(program));
    assert_int_equal(ttc_program_latency(program), 11);
    ttc_program_destroy(program);
}

/* Divisions that need, directly or through others, the value of a root. */
static unsigned divisions_after_roots(const ttc_program *program)
{
    size_t n = ttc_program_size(program);
    unsigned count = 0;
    unsigned char *is_after = calloc(n + 1, 1);
    assert_non_null(is_after);
    for (size_t k = 0; k < n; k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        for (unsigned j = 0; j < ttc_op_arity(i->op); j++) is_after[k] |= is_after[i->operands[j]];
        count += i->op == TTC_OP_DIVIDE && is_after[k];
        is_after[k] |= i->op == TTC_OP_ROOT;
    }
    free(is_after);
    return count;
}

/* The field divides by s = sqrt(1 - gamma3^2) and by polynomials. */
static void no_division_of_the_reduced_field_waits_for_its_root(void **unused)
{
    (void)unused;
    ttc_field *field = NULL;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_read(JLT_SOURCE_DIR "/codegen/models/spherical_top.tt", diagnostics);
    assert_non_null(model);
    assert_int_equal(ttc_field_create(&field, model, NULL, NULL, NULL), TTC_FIELD_OK);
    ttc_kernels *kernels = ttc_kernels_create(field, TTC_EFFORT_FULL);
    assert_non_null(kernels);
    for (int kind = TTC_KERNEL_RHS; kind <= TTC_KERNEL_DIVERGENCE; kind++) {
        const ttc_kernel *kernel = kernels->kernels + kind;
        assert_true(divisions_after_roots(kernel->naive) > 0);
        assert_int_equal(divisions_after_roots(kernel->optimized), 0);
        assert_int_equal(ttc_program_count(kernel->optimized).divide, 1);
        assert_int_equal(ttc_program_count(kernel->optimized).root, 1);
        assert_true(ttc_program_latency(kernel->optimized) < ttc_program_latency(kernel->naive));
    }
    ttc_kernels_destroy(kernels);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
}

/* In Taylor recurrences a division costs what a product costs. Where y is fast, 1/(1 + x^2) recovered by products from the
 * reciprocal of both denominators would have its roundings. */
static void recurrences_divide_by_each_denominator(void **unused)
{
    static const char text[] = "model two\nstate x\nstate y\neq x = y/(1 + x^2)\neq y = 1e12*x/(2 + y^2)\n";
    (void)unused;
    ttc_field *field = NULL;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(text, sizeof text - 1, "two.tt", diagnostics);
    assert_non_null(model);
    assert_int_equal(ttc_field_create(&field, model, NULL, NULL, NULL), TTC_FIELD_OK);
    ttc_kernels *kernels = ttc_kernels_create(field, TTC_EFFORT_QUICK);
    assert_non_null(kernels);
    const ttc_count step = ttc_program_count(kernels->kernels[TTC_KERNEL_RHS].optimized), jet = ttc_program_count(kernels->jet);
    assert_int_equal(step.divide, 1);
    assert_int_equal(jet.divide, 2);
    assert_true(jet.multiply + jet.divide < step.multiply + step.fma + step.divide);
    ttc_kernels_destroy(kernels);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(latency_is_that_of_the_longest_chain),
                                        cmocka_unit_test(no_division_of_the_reduced_field_waits_for_its_root),
                                        cmocka_unit_test(recurrences_divide_by_each_denominator) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
