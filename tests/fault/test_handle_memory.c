/* Memory runs out at every single allocation behind a handle: each time that is the status, nothing is given out where nothing was
 * made, and what was made before goes on serving. */
#include "unit/check.h"

#include <fcntl.h>
#include <stdlib.h>

#include "fault/failing_memory.h"
#include "scene/handle.h"

static const char *const lorenz_names[] = { "rho" };
static const double lorenz_values[] = { 20 };

static jlt_status open_known(jlt_handle_section **out)
{
    return jlt_handle_section_known(out, "spherical_top", NULL, NULL, 0, 0);
}

static jlt_status open_plane(jlt_handle_section **out)
{
    return jlt_handle_section_plane(out, "lorenz", "z", 19, 1, lorenz_names, lorenz_values, 1, 0);
}

static jlt_status two_returns(jlt_handle_section *section, const double *start, size_t *done)
{
    double q[4], t[2];
    int fate;
    const jlt_status st = jlt_handle_section_start(section, start, 1);

    *done = 0;
    return st == JLT_OK ? jlt_handle_section_returns(section, q, t, NULL, done, &fate, 2) : st;
}

static void check_section(jlt_status (*open)(jlt_handle_section **out), const double *start)
{
    jlt_handle_section *section = NULL;
    jlt_status st = JLT_ERR_NOMEM;
    size_t done;
    long k;

    for (k = 0; st == JLT_ERR_NOMEM; k++) {
        failing = k;
        st = open(&section);
        failing = -1;
        if (st != JLT_OK) assert_null(section);
    }
    assert_int_equal(st, JLT_OK);
    assert_true(k > 4); /* the handle, the system, its instance and observer, the section */
    st = JLT_ERR_NOMEM;
    for (k = 0; st == JLT_ERR_NOMEM; k++) {
        failing = k;
        st = two_returns(section, start, &done);
        failing = -1;
    }
    assert_int_equal(st, JLT_OK);
    assert_int_equal(done, 2);
    jlt_handle_section_destroy(section);
}

static void every_allocation_of_a_section_may_fail(void **unused)
{
    (void)unused;
    check_section(open_known, (const double[]){ 0.1, -0.6 });
    check_section(open_plane, (const double[]){ 3, 1 });
}

static void every_allocation_of_a_motion_may_fail(void **unused)
{
    const double start[] = { 1, 2, 20 }, times[] = { 0.5, 1 };
    double x[6], t[2];
    jlt_handle_motion *motion = NULL;
    jlt_status st = JLT_ERR_NOMEM;
    size_t done = 0;
    int fate;
    long k;

    (void)unused;
    for (k = 0; st == JLT_ERR_NOMEM; k++) {
        failing = k;
        st = jlt_handle_motion_create(&motion, "lorenz", lorenz_names, lorenz_values, 1, 0);
        failing = -1;
        if (st != JLT_OK) assert_null(motion);
    }
    assert_int_equal(st, JLT_OK);
    assert_true(k > 2);
    st = JLT_ERR_NOMEM;
    for (k = 0; st == JLT_ERR_NOMEM; k++) {
        failing = k;
        st = jlt_handle_motion_start(motion, start);
        if (st == JLT_OK) st = jlt_handle_motion_states(motion, x, t, &done, &fate, times, 2);
        else assert_int_equal(jlt_handle_motion_states(motion, x, t, &done, &fate, times, 2), JLT_ERR_ARG);
        failing = -1;
    }
    assert_int_equal(st, JLT_OK);
    assert_true(k > 3);
    assert_int_equal(done, 2);
    jlt_handle_motion_destroy(motion);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_allocation_of_a_section_may_fail),
        cmocka_unit_test(every_allocation_of_a_motion_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
