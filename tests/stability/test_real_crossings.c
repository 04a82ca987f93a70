/* Crossings are real: below the error of an orbit there is none. A start along the section leaves it once, and an orbit that decays
 * onto an equilibrium on the section crosses no more, however its rounding errors fall.
 * Oracle: the other methods; where all is noise, none of them can be right by chance. */
#include "unit/check.h"

#include "dynamics/section_batch.h"
#include "witness/top_section.h"

/* The first returns by one method, or batches (NULL). */
static size_t returns_of(jlt_return *rows, size_t most, const jlt_top_values *values, const jlt_method *method, double tolerance,
                         const double *q)
{
    /* An orbit that rests may be followed for all its steps: so many are enough to rest. */
    const jlt_flow flow = { .method = method, .tolerance = tolerance, .direction = JLT_BOTH, .max_steps = 5000 };
    jlt_section_batch *batch = NULL;
    jlt_section *section = NULL;
    jlt_system *system;
    jlt_return row;
    size_t made = 0;

    assert_ok(jlt_system_top(&system, values, &flow));
    if (method == NULL) {
        assert_ok(jlt_section_batch_create(&batch, &system->flow, system->field.batch, &(jlt_section_batch_options){ 0 }));
        assert_ok(jlt_section_batch_run(batch, q, 1, most));
        assert_ok(jlt_section_batch_start(batch, &row, 0));
    } else {
        assert_ok(jlt_section_create(&section, &system->flow));
        assert_ok(jlt_section_start(section, &row, q, 1));
    }
    while (made < most) {
        assert_ok(method == NULL ? jlt_section_batch_next(batch, &row) : jlt_section_next(section, &row));
        if (row.fate != JLT_FATE_ALIVE) break;
        rows[made++] = row;
    }
    jlt_section_batch_destroy(batch);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
    return made;
}

/* At d = 0 the start is along the section up to rounding, near the maximum of its omega_tau; at d it is off by a slope of d or so,
 * and off the section by d^2 before it is back. From an offset of 1e-3 on, that is well above ten tolerances, and the orbit does
 * cross; its time then is known to the tolerance over the slope, times its amplification of at most 10. */
static void a_start_along_the_section_leaves_it_once(void **unused)
{
    static const double offsets[] = { 0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9, 1e-7, -1e-7, 1e-3, -1e-3 };
    const jlt_top_values values = { .m = 1, .R = 1, .g = 1, .I1 = 0.411, .I3 = 0.482, .a3 = 0.703, .E = 2.037, .G = 0.085 };
    const double tolerance = 1e-12;
    size_t early = 0;

    (void)unused;
    for (size_t k = 0; k < sizeof offsets / sizeof *offsets; k++) {
        const double q[] = { 1.061, -0.911102813328396 + offsets[k] };
        jlt_return base[3], rows[3];
        assert_int_equal(returns_of(base, 3, &values, jlt_method_find("gauss"), tolerance, q), 3);
        if (fabs(offsets[k]) < 1e-3) assert_true(base[0].t > 1);
        else early += base[0].t < 0.1;
        for (size_t m = 1; m == 1 || jlt_method_at(m - 1) != NULL; m++) {
            const jlt_method *method = jlt_method_at(m);
            assert_int_equal(returns_of(rows, 3, &values, method, tolerance, q), 3);
            for (int i = 0; i < 3; i++) assert_near(rows[i].t, base[i].t, base[i].t < 0.1 ? 1e4 * tolerance : 100 * tolerance);
        }
    }
    assert_int_equal(early, 1); /* on one side of the tangency there are two crossings */
}

/* The balanced sphere's attracting node, with rates that differ: it is on the section, and the orbit on one side of it. */
static void an_orbit_that_decays_onto_a_node_crosses_no_more(void **unused)
{
    const jlt_top_values values = { .m = 3.10446, .R = 8.39041, .g = 0.0142125, .I1 = 30.9151, .I3 = 29.0063, .a3 = 0,
                                    .E = 0.00108775, .G = 0.422232 };
    const double q[] = { -1.562, -0.338 }, tolerances[] = { 1e-9, 1e-11, 1e-12 };

    (void)unused;
    for (size_t k = 0; k < sizeof tolerances / sizeof *tolerances; k++)
        for (size_t m = 0; m == 0 || jlt_method_at(m - 1) != NULL; m++) {
            jlt_return rows[8];
            assert_int_equal(returns_of(rows, 8, &values, jlt_method_at(m), tolerances[k], q), 1);
            assert_near(rows[0].t, 3.8302513634, 1e-4); /* nearly along the section: slope 4e-5 */
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_start_along_the_section_leaves_it_once),
        cmocka_unit_test(an_orbit_that_decays_onto_a_node_crosses_no_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
