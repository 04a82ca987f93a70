/* Which flows may share the lanes of a batch: those of one field under other parameters, as long as intervals of states are the
 * same, for lanes watch those of the first flow. */
#include "unit/check.h"

#include "dynamics/section_batch.h"
#include "dynamics/system.h"
#include "kernel/descriptor.h"

static const jlt_flow rising = { .tolerance = 1e-11, .direction = JLT_RISING };

/* The plane z = 27 of Lorenz's system. */
static jlt_system *lorenz(double rho)
{
    jlt_system *system;

    assert_ok(jlt_system_plane(&system, jlt_descriptor_find("lorenz", NULL, NULL, NULL), (const double[]){ 10, rho, 8. / 3 }, 2, 27,
                               NULL, &rising));
    return system;
}

static void parameters_may_differ(void **unused)
{
    enum { FLOWS = 3 };
    const double q[2 * FLOWS] = { 9, 5, 9, 5, 9, 5 };
    const size_t flow_of[FLOWS] = { 0, 1, 2 };
    jlt_system *systems[FLOWS] = { lorenz(28), lorenz(28.5), lorenz(29) };
    const jlt_kernel_batch *kernels = systems[0]->flow.field->batch;
    jlt_section_batch *together, *alone;
    jlt_return row, own;
    size_t index;

    (void)unused;
    assert_ok(jlt_section_batch_create(&together, &systems[0]->flow, kernels, NULL));
    for (size_t k = 1; k < FLOWS; k++) {
        assert_ok(jlt_section_batch_add(together, &index, &systems[k]->flow, NULL));
        assert_int_equal(index, k);
    }
    assert_ok(jlt_section_batch_run_each(together, q, flow_of, NULL, FLOWS, 10));
    for (size_t k = 0; k < FLOWS; k++) {
        assert_ok(jlt_section_batch_create(&alone, &systems[k]->flow, kernels, NULL));
        assert_ok(jlt_section_batch_run(alone, q, 1, 10));
        assert_ok(jlt_section_batch_last(together, &row, k));
        assert_ok(jlt_section_batch_last(alone, &own, 0));
        assert_int_equal(own.number, 10);
        assert_int_equal(row.number, own.number);
        assert_memory_equal(row.q, own.q, 2 * sizeof *row.q);
        assert_memory_equal(&row.t, &own.t, sizeof row.t);
        jlt_section_batch_destroy(alone);
    }
    jlt_section_batch_destroy(together);
    for (size_t k = 0; k < FLOWS; k++) jlt_system_destroy(systems[k]);
}

static void intervals_may_not_differ(void **unused)
{
    jlt_system *first = lorenz(28), *second = lorenz(28);
    jlt_section_batch *batch;

    (void)unused;
    second->instance->states[0].high = 50;
    assert_ok(jlt_section_batch_create(&batch, &first->flow, first->flow.field->batch, NULL));
    assert_int_equal(jlt_section_batch_add(batch, NULL, &second->flow, NULL), JLT_ERR_ARG);
    jlt_section_batch_destroy(batch);
    jlt_system_destroy(first);
    jlt_system_destroy(second);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parameters_may_differ),
        cmocka_unit_test(intervals_may_not_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
