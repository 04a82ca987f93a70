/* What each pass of the optimizer promises. Whatever it does, the values stay what the terms say: both are evaluated in exact
 * ratios, at points where roots are rational, and must be equal. */
#include "unit/check.h"

#include <stdlib.h>

#include "optimize/optimize.h"
#include "unit/exact_program.h"
#include "unit/optimizer_tables.h"

#define ALL_PAIRS UINT64_C(200000)

static void extraction_keeps_values_and_leaves_nothing_to_take(void **unused)
{
    (void)unused;
    for (int t = 0; t < TABLES; t++)
        for (uint64_t seed = 0; seed < 6; seed++) {
            subject s = read_table(tables[t]);
            ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, s.count);
            unsigned before = operations(check(&s, workspace));
            assert_true(ttc_workspace_extract(workspace, seed, ALL_PAIRS) > 0);
            assert_true(operations(check(&s, workspace)) < before);
            uint32_t variables = workspace->count;
            ttc_workspace_extract(workspace, 0, ALL_PAIRS);
            assert_int_equal(workspace->count, variables);
            ttc_workspace_destroy(workspace);
            forget(&s);
        }
}

/* With room for few pairs the search is another, the values are not. */
static void extraction_from_large_systems_keeps_values_and_saves_operations(void **unused)
{
    (void)unused;
    for (int t = 0; t < TABLES; t++)
        for (uint64_t pairs = 0; pairs < 40; pairs += 13) {
            subject s = read_table(tables[t]);
            ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, s.count);
            unsigned before = operations(check(&s, workspace));
            ttc_workspace_extract(workspace, 0, pairs);
            assert_true(operations(check(&s, workspace)) < before);
            ttc_workspace_destroy(workspace);
            forget(&s);
        }
}

static void extraction_takes_a_common_sum_once(void **unused)
{
    (void)unused;
    /* (x + y) z, (x + y) a and 2 (x + y): one sum and three products. */
    subject s = read_table(
        "model sums\nparam a > 0\nstate x\nstate y\nstate z\neq x = x*z + y*z\neq y = a*x + a*y\neq z = 2*x + 2*y\n");
    ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, 3);
    s.count = 3;
    ttc_workspace_extract(workspace, 0, ALL_PAIRS);
    ttc_count count = check(&s, workspace);
    assert_int_equal(count.add, 1);
    assert_int_equal(count.multiply, 3);
    ttc_workspace_destroy(workspace);
    forget(&s);
}

static void extraction_takes_a_common_product_once(void **unused)
{
    (void)unused;
    subject s = read_table("model products\nstate x\nstate y\nstate z\nstate w\neq x = x*y*z\neq y = y*z*w\neq z = x\neq w = y\n");
    ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, 4);
    s.count = 4;
    assert_int_equal(check(&s, workspace).multiply, 4);
    ttc_workspace_extract(workspace, 0, ALL_PAIRS);
    assert_int_equal(check(&s, workspace).multiply, 3);
    ttc_workspace_destroy(workspace);
    forget(&s);
}

static unsigned scaled_cubes(const ttc_workspace *workspace)
{
    unsigned count = 0;
    for (uint32_t v = 0; v < workspace->count; v++)
        for (uint32_t i = 0; i < workspace->variables[v].definition.count; i++)
            count += ttc_cube_cost(workspace, workspace->variables[v].definition.cubes + i);
    return count;
}

static void rescaling_keeps_values_and_never_adds_multiplications(void **unused)
{
    (void)unused;
    for (int t = 0; t < TABLES; t++) {
        subject s = read_table(tables[t]);
        ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, s.count);
        ttc_workspace_extract(workspace, 1, ALL_PAIRS);
        unsigned before = scaled_cubes(workspace);
        ttc_workspace_rescale(workspace);
        assert_true(scaled_cubes(workspace) <= before);
        check(&s, workspace);
        ttc_workspace_destroy(workspace);
        forget(&s);
    }
}

static void rescaling_moves_a_scale_to_users_that_have_one(void **unused)
{
    (void)unused;
    /* h = a (x + y) in 3 h z and 5 h: the products with a go. */
    subject s = read_table("model scale\nparam a > 0\nstate x\nstate y\nlet h = a*x + a*y\neq x = 3*h*y\neq y = 5*h\n");
    s.count = 2;
    ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, 2);
    unsigned before = scaled_cubes(workspace);
    ttc_workspace_rescale(workspace);
    assert_true(scaled_cubes(workspace) < before);
    check(&s, workspace);
    ttc_workspace_destroy(workspace);
    forget(&s);
}

static void reciprocals_that_do_not_need_each_other_share_one_division(void **unused)
{
    (void)unused;
    for (int written_out = 0; written_out < 2; written_out++) {
        subject s = read_table(ratios);
        ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, s.count);
        assert_int_equal(check(&s, workspace).divide, 3);
        ttc_workspace_share_reciprocals(workspace, written_out);
        assert_int_equal(check(&s, workspace).divide, 1);
        ttc_workspace_destroy(workspace);
        forget(&s);
    }
}

/* Reciprocals whose operand is a root. */
static unsigned reciprocals_of_roots(const ttc_workspace *workspace)
{
    unsigned count = 0;
    for (uint32_t v = 0; v < workspace->count; v++)
        count += workspace->variables[v].kind == TTC_VARIABLE_RECIPROCAL
                 && workspace->variables[workspace->variables[v].operand].kind == TTC_VARIABLE_ROOT;
    return count;
}

static void divisions_by_radicands_need_no_root(void **unused)
{
    (void)unused;
    subject s = read_table(roots);
    ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, s.count);
    assert_true(reciprocals_of_roots(workspace) > 0);
    assert_true(ttc_workspace_divide_by_radicands(workspace));
    assert_int_equal(reciprocals_of_roots(workspace), 0);
    check(&s, workspace);
    assert_false(ttc_workspace_divide_by_radicands(workspace));
    ttc_workspace_destroy(workspace);
    forget(&s);
}

static void raised_reciprocals_keep_values(void **unused)
{
    (void)unused;
    subject s = read_table("model cubes\nstate x\nstate y\nroot r = sqrt(x^2 + y^2)\neq x = -x/r^3\neq y = -y/r^3\n");
    s.count = 2;
    ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, 2);
    ttc_workspace_write_out(workspace);
    ttc_workspace_raise_reciprocals(workspace);
    ttc_workspace_tidy(workspace);
    check(&s, workspace);
    ttc_workspace_destroy(workspace);
    forget(&s);
}

static uint32_t find_kind(const ttc_workspace *workspace, ttc_variable_kind kind)
{
    uint32_t v = 0;
    while (v < workspace->count && workspace->variables[v].kind != kind) v++;
    assert_true(v < workspace->count);
    return v;
}

/* A term times r (1/r), and one in which the radicand is written as r r, come back as they were. */
static void cancelling_removes_reciprocals_and_squares_of_roots(void **unused)
{
    (void)unused;
    subject s = read_table("model cancel\nstate x\nstate y\nroot r = sqrt(x^2 + y^2)\neq x = 1/r\neq y = r^2*x\n");
    s.count = 2;
    ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, 2);
    uint32_t root = find_kind(workspace, TTC_VARIABLE_ROOT), reciprocal = find_kind(workspace, TTC_VARIABLE_RECIPROCAL);
    ttc_cube *first = workspace->variables[workspace->outputs[0]].definition.cubes;
    ttc_cube *second = workspace->variables[workspace->outputs[1]].definition.cubes, a = *first, b = *second;
    assert_true(ttc_cube_multiply(first, root) && ttc_cube_multiply(first, reciprocal));
    ttc_cube_remove(second, workspace->variables[root].operand);
    assert_true(ttc_cube_multiply(second, root) && ttc_cube_multiply(second, root));
    check(&s, workspace);
    ttc_workspace_cancel(workspace);
    assert_true(ttc_cube_same_factors(&a, workspace->variables[workspace->outputs[0]].definition.cubes));
    assert_true(ttc_cube_same_factors(&b, workspace->variables[workspace->outputs[1]].definition.cubes));
    check(&s, workspace);
    ttc_workspace_destroy(workspace);
    forget(&s);
}

static void tidying_keeps_values_and_every_variable_is_used(void **unused)
{
    (void)unused;
    for (int t = 0; t < TABLES; t++) {
        subject s = read_table(tables[t]);
        ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, s.count);
        ttc_workspace_extract(workspace, 3, ALL_PAIRS);
        unsigned before = operations(check(&s, workspace));
        /* One that nobody uses, and one that it alone uses. */
        uint32_t inner = ttc_workspace_add_variable(workspace, TTC_VARIABLE_UNIT, 0);
        uint32_t outer = ttc_workspace_add_variable(workspace, TTC_VARIABLE_UNIT, 0);
        ttc_cube cube = ttc_cube_one(workspace);
        ttc_polynomial_add(workspace, &workspace->variables[inner].definition, &cube);
        assert_true(ttc_cube_multiply(&cube, find_kind(workspace, TTC_VARIABLE_INPUT)));
        ttc_polynomial_add(workspace, &workspace->variables[inner].definition, &cube);
        cube = ttc_cube_one(workspace);
        assert_true(ttc_cube_multiply(&cube, inner) && ttc_cube_multiply(&cube, inner));
        ttc_polynomial_add(workspace, &workspace->variables[outer].definition, &cube);
        ttc_workspace_tidy(workspace);
        assert_true(operations(check(&s, workspace)) <= before);
        unsigned char *is_used = calloc(workspace->count + 1, 1);
        assert_non_null(is_used);
        for (uint32_t v = 0; v < workspace->count; v++) {
            if (workspace->variables[v].is_output) is_used[v] = 1;
            if (workspace->variables[v].kind > TTC_VARIABLE_UNIT) is_used[workspace->variables[v].operand] = 1;
            for (uint32_t i = 0; i < workspace->variables[v].definition.count; i++)
                for (unsigned j = 0; j < workspace->variables[v].definition.cubes[i].count; j++)
                    is_used[workspace->variables[v].definition.cubes[i].factors[j]] = 1;
        }
        for (uint32_t v = 0; v < workspace->count; v++) assert_true(is_used[v]);
        free(is_used);
        ttc_workspace_destroy(workspace);
        forget(&s);
    }
}

static void tidying_turns_the_sign_of_a_sum_of_negative_terms(void **unused)
{
    (void)unused;
    subject s = read_table(
        "model signs\nstate x\nstate y\nstate z\nlet h = -x - y*z\neq x = h*x + z\neq y = h*z - x\neq z = h^2\n");
    ttc_workspace *workspace = ttc_workspace_create(s.field, s.outputs, 3);
    s.count = 3;
    ttc_workspace_tidy(workspace);
    check(&s, workspace);
    for (uint32_t v = 0; v < workspace->count; v++) {
        const ttc_polynomial *p = &workspace->variables[v].definition;
        bool has_positive = p->count == 0 || workspace->variables[v].is_output;
        for (uint32_t i = 0; i < p->count; i++) has_positive |= p->cubes[i].sign > 0;
        assert_true(has_positive);
    }
    ttc_workspace_destroy(workspace);
    forget(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extraction_keeps_values_and_leaves_nothing_to_take),
        cmocka_unit_test(extraction_from_large_systems_keeps_values_and_saves_operations),
        cmocka_unit_test(extraction_takes_a_common_sum_once),
        cmocka_unit_test(extraction_takes_a_common_product_once),
        cmocka_unit_test(rescaling_keeps_values_and_never_adds_multiplications),
        cmocka_unit_test(rescaling_moves_a_scale_to_users_that_have_one),
        cmocka_unit_test(reciprocals_that_do_not_need_each_other_share_one_division),
        cmocka_unit_test(divisions_by_radicands_need_no_root),
        cmocka_unit_test(raised_reciprocals_keep_values),
        cmocka_unit_test(cancelling_removes_reciprocals_and_squares_of_roots),
        cmocka_unit_test(tidying_keeps_values_and_every_variable_is_used),
        cmocka_unit_test(tidying_turns_the_sign_of_a_sum_of_negative_terms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
