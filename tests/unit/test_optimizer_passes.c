/* What each pass of the optimizer promises. Whatever it does, the values stay what the terms say: both are evaluated in exact
 * ratios, at points where roots are rational, and must be equal. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "optimize/optimize.h"
#include "unit/exact_program.h"

#define ALL_PAIRS UINT64_C(200000)

static const char polynomials[] =
    "model polynomials\nparam a > 0\nparam b\nstate x\nstate y\nstate z\n"
    "eq x =\n    + a*x*y*z\n    + b*x*y\n    + 2*x*z^2\n    - 3/7*y^3*z\n"
    "eq y =\n    + a*x*y*z^2\n    + b*x*y*z\n    - x*z^3\n    + x^2*y^2\n"
    "eq z =\n    + (x + y)*(a*z + b*x)\n    - (x + y)^2*z\n    + 5*x*y*z\n";
static const char ratios[] =
    "model ratios\nparam a > 0\nparam b > 0\nstate x\nstate y\nstate z\n"
    "eq x = y/(x^2 + a) + z/(y^2 + b)\neq y = x/(x^2 + a) - z/((x^2 + a)*(y^2 + b))\neq z = x*y/(z^2 + a*b)\n";
static const char roots[] =
    "model roots\nparam a > 0\nstate x\nstate y\nstate z\nroot r = sqrt(x^2 + y^2)\n"
    "eq x = -a*x/r^3 + y/r\neq y = -a*y/r^3 - x/r\neq z = z*r + r^2*x\n";
static const char *const tables[] = { polynomials, ratios, roots };
enum { TABLES = sizeof tables / sizeof *tables };

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
    subject s = read_table("model sums\nparam a > 0\nstate x\nstate y\nstate z\neq x = x*z + y*z\neq y = a*x + a*y\neq z = 2*x + 2*y\n");
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
    subject s = read_table("model signs\nstate x\nstate y\nstate z\nlet h = -x - y*z\neq x = h*x + z\neq y = h*z - x\neq z = h^2\n");
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

/* The program of a table before its operations are fused. */
static ttc_program *lowered(subject *s, ttc_prepared *prepared)
{
    ttc_workspace *workspace = ttc_workspace_create(s->field, s->outputs, s->count);
    ttc_workspace_extract(workspace, 0, ALL_PAIRS);
    ttc_workspace_tidy(workspace);
    ttc_program *program = ttc_workspace_lower(workspace, prepared);
    ttc_workspace_destroy(workspace);
    assert_non_null(program);
    return program;
}

static void fusing_keeps_values_and_flops_and_saves_operations(void **unused)
{
    (void)unused;
    for (int t = 0; t < TABLES; t++) {
        subject s = read_table(tables[t]);
        ttc_prepared prepared = { .field = s.field };
        ttc_program *program = lowered(&s, &prepared), *fused = ttc_program_fuse(program);
        assert_non_null(fused);
        same_values(&s, fused, &prepared);
        ttc_count before = ttc_program_count(program), after = ttc_program_count(fused);
        assert_true(after.fma > 0);
        assert_true(ttc_count_flops(after) <= ttc_count_flops(before));
        assert_true(operations(after) + after.fma < operations(before));
        /* Once more changes nothing, operations of three operands included. */
        ttc_program *again = ttc_program_fuse(fused);
        assert_non_null(again);
        same_values(&s, again, &prepared);
        assert_int_equal(operations(ttc_program_count(again)), operations(after));
        ttc_program_destroy(again);
        ttc_program_destroy(fused);
        ttc_program_destroy(program);
        ttc_prepared_clear(&prepared);
        forget(&s);
    }
}

static void scheduling_keeps_values_and_operations_and_holds_no_more_at_once(void **unused)
{
    (void)unused;
    for (int t = 0; t < TABLES; t++) {
        subject s = read_table(tables[t]);
        ttc_prepared prepared = { .field = s.field };
        ttc_program *program = lowered(&s, &prepared), *scheduled = ttc_program_schedule(program);
        assert_non_null(scheduled);
        same_values(&s, scheduled, &prepared);
        ttc_count before = ttc_program_count(program), after = ttc_program_count(scheduled);
        assert_int_equal(operations(after), operations(before));
        assert_int_equal(after.fma, before.fma);
        assert_true(after.live <= before.live);
        ttc_program_destroy(scheduled);
        ttc_program_destroy(program);
        ttc_prepared_clear(&prepared);
        forget(&s);
    }
}

static void trimming_removes_what_no_output_needs_and_nothing_else(void **unused)
{
    (void)unused;
    subject s = read_table(polynomials);
    ttc_prepared prepared = { .field = s.field };
    ttc_program *program = lowered(&s, &prepared);
    size_t size = ttc_program_size(program);
    ttc_value x = ttc_program_input(program, 0), sum = ttc_program_add(program, x, ttc_program_integer(program, 4711));
    ttc_program_multiply(program, sum, sum);
    assert_int_equal(ttc_program_size(program), size + 3);
    ttc_program *trimmed = ttc_program_trim(program);
    assert_non_null(trimmed);
    assert_int_equal(ttc_program_size(trimmed), size);
    same_values(&s, trimmed, &prepared);
    ttc_program_destroy(trimmed);
    ttc_program_destroy(program);
    ttc_prepared_clear(&prepared);
    forget(&s);
}

static void renumbering_reads_prepared_values_where_they_are_now(void **unused)
{
    (void)unused;
    unsigned moves = 0;
    for (int t = 0; t < TABLES; t++) {
        subject s = read_table(tables[t]);
        ttc_prepared prepared = { .field = s.field }, turned = { .field = s.field };
        ttc_program *program = lowered(&s, &prepared);
        const size_t params = s.field->param_count, size = ttc_prepared_size(&prepared);
        uint32_t *numbers = calloc(size + 1, sizeof *numbers);
        assert_non_null(numbers);
        for (size_t i = size; i-- > params;) numbers[i] = ttc_prepared_index(&turned, prepared.entries[i - params]);
        for (size_t i = 0; i < params; i++) numbers[i] = (uint32_t)i;
        if (prepared.count > 1 && turned.entries[0] != prepared.entries[0]) moves++;
        ttc_program *moved = ttc_program_renumber(program, numbers);
        assert_non_null(moved);
        same_values(&s, moved, &turned);
        ttc_program_destroy(moved);
        /* Every operation without operands is copied, pi too, of which the exact evaluation above knows nothing. */
        ttc_program_pi(program);
        moved = ttc_program_renumber(program, numbers);
        assert_non_null(moved);
        assert_int_equal(ttc_program_size(moved), ttc_program_size(program));
        ttc_program_destroy(moved);
        ttc_program_destroy(program);
        free(numbers);
        ttc_prepared_clear(&turned);
        ttc_prepared_clear(&prepared);
        forget(&s);
    }
    assert_true(moves > 1);
}

static void all_passes_together_keep_values_with_either_effort(void **unused)
{
    (void)unused;
    for (int t = 0; t < TABLES; t++)
        for (int effort = TTC_EFFORT_QUICK; effort <= TTC_EFFORT_FULL; effort++)
            for (int purpose = TTC_FOR_STEPS; purpose <= TTC_FOR_JETS; purpose++) {
                subject s = read_table(tables[t]);
                ttc_prepared prepared = { .field = s.field };
                size_t count = s.count;
                if (effort == TTC_EFFORT_FULL) s.count = s.field->state_count; /* the field alone: full effort takes its time */
                ttc_program *program = ttc_optimize(s.field, s.outputs, NULL, s.count, (ttc_purpose)purpose, (ttc_effort)effort, &prepared);
                assert_non_null(program);
                assert_true(s.count <= count);
                same_values(&s, program, &prepared);
                ttc_program_destroy(program);
                ttc_prepared_clear(&prepared);
                forget(&s);
            }
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
        cmocka_unit_test(fusing_keeps_values_and_flops_and_saves_operations),
        cmocka_unit_test(scheduling_keeps_values_and_operations_and_holds_no_more_at_once),
        cmocka_unit_test(trimming_removes_what_no_output_needs_and_nothing_else),
        cmocka_unit_test(renumbering_reads_prepared_values_where_they_are_now),
        cmocka_unit_test(all_passes_together_keep_values_with_either_effort),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
