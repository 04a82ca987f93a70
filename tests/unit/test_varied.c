/* The variational equations on vectors: by every instruction set that runs here, what they are one point at a time. */
#include "unit/check.h"

#include <math.h>

#include "dynamics/varied.h"
#include "integrate/gauss_batch.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"

enum { NODES = JLT_GAUSS_BATCH_NODES, ROWS_MAX = 64 };

static jlt_varied varied;

/* Each entry is a few dozen operations; what cancels in them is not much larger than the largest of all, at these points. */
static void compare(unsigned isa, double (*scalar)[NODES], const double *lanes, unsigned rows)
{
    double largest = 0;

    for (unsigned i = 0; i < rows; i++)
        for (unsigned k = 0; k < NODES; k++) largest = fmax(largest, fabs(scalar[i][k]));
    for (unsigned i = 0; i < rows; i++)
        for (unsigned k = 0; k < NODES; k++)
            if (!(fabs(lanes[i * NODES + k] - scalar[i][k]) <= 1e-13 * largest))
                fail_msg("instruction set %u, row %u, node %u: %.17g, not %.17g", isa, i, k, lanes[i * NODES + k], scalar[i][k]);
}

static void check_model(const char *name, const char *time, unsigned tangents)
{
    _Alignas(64) double x[ROWS_MAX * NODES], f[ROWS_MAX * NODES], scalar[ROWS_MAX][NODES], at[ROWS_MAX], rates[ROWS_MAX],
        clock[NODES], params[16];
    const jlt_descriptor *d = jlt_descriptor_find(name, NULL, time, NULL);
    jlt_instance *instance;
    jlt_field plain;
    unsigned tried = 0;

    assert_non_null(d);
    for (unsigned i = 0; i < d->param_count; i++) params[i] = isfinite(d->params[i].value) ? d->params[i].value : 0.5;
    assert_ok(jlt_instance_create(&instance, d, params));
    assert_ok(jlt_field_of(&plain, instance));
    for (unsigned isa = 0; isa < JLT_ISA_COUNT; isa++) {
        if (!jlt_batch_isa_runs(d->batches[isa])) continue;
        plain.batch = d->batches[isa];
        assert_ok(jlt_varied_make(&varied, &plain, d->rhs_jacobian.call, tangents));
        const unsigned rows = varied.field.dim;
        assert_true(rows <= ROWS_MAX);
        assert_non_null(varied.field.batch);
        for (unsigned i = 0; i < rows; i++)
            for (unsigned k = 0; k < NODES; k++) x[i * NODES + k] = 0.3 + 0.4 * sin(1 + i + 0.37 * k * (i + 2));
        for (unsigned k = 0; k < NODES; k++) {
            for (unsigned i = 0; i < rows; i++) at[i] = x[i * NODES + k];
            varied.field.call(at, varied.field.p, rates);
            for (unsigned i = 0; i < rows; i++) scalar[i][k] = rates[i];
        }
        for (unsigned k = 0; k < NODES; k += varied.batch.lanes) varied.batch.rhs(x + k, varied.field.p, f + k, NODES);
        compare(isa, scalar, f, rows);
        if (varied.field.time_rate != NULL) {
            for (unsigned k = 0; k < NODES; k++) {
                for (unsigned i = 0; i < rows; i++) at[i] = x[i * NODES + k];
                varied.field.time_rate(at, varied.field.p, scalar[0] + k);
            }
            for (unsigned k = 0; k < NODES; k += varied.batch.lanes)
                varied.batch.time_factor(x + k, varied.field.p, clock + k, NODES);
            compare(isa, scalar, clock, 1);
        }
        jlt_varied_clear(&varied);
        tried++;
    }
    assert_true(tried > 0);
    jlt_instance_destroy(instance);
}

static void vectors_do_what_single_points_do(void **unused)
{
    (void)unused;
    check_model("roessler", NULL, 2);
    check_model("spherical_top_level", "regular", 2);
    check_model("spherical_top", "regular", 3);
    check_model("toda", NULL, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(vectors_do_what_single_points_do) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
