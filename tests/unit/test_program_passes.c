/* What the passes over programs promise: fusing, scheduling, trimming, renumbering, and all passes together. Whatever they do, the
 * values stay what the terms say: both are evaluated in exact ratios, at points where roots are rational, and must be equal. */
#include "unit/check.h"

#include <stdlib.h>

#include "optimize/optimize.h"
#include "unit/exact_program.h"
#include "unit/optimizer_tables.h"

#define ALL_PAIRS UINT64_C(200000)

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
                ttc_program *program = ttc_optimize(s.field, s.outputs, NULL, s.count, (ttc_purpose)purpose, (ttc_effort)effort,
                                                    &prepared);
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
        cmocka_unit_test(fusing_keeps_values_and_flops_and_saves_operations),
        cmocka_unit_test(scheduling_keeps_values_and_operations_and_holds_no_more_at_once),
        cmocka_unit_test(trimming_removes_what_no_output_needs_and_nothing_else),
        cmocka_unit_test(renumbering_reads_prepared_values_where_they_are_now),
        cmocka_unit_test(all_passes_together_keep_values_with_either_effort),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
