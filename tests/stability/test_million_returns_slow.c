/* A million returns without a missed or a doubled crossing.
 *
 * Around the elliptic orbit of period 2 at (5.1) the orbit alternates sides, eta < 0, eta > 0, ..., and crosses the section
 * upwards and downwards in turn: one crossing too few or too many breaks one of the two, wherever it happens. Times between
 * crossings stay in a narrow band besides. */
#include "unit/check.h"

#include <stdio.h>

#include "dynamics/section.h"
#include "witness/top_section.h"

enum { RETURNS = 1000000 };

static void crossings_alternate_in_direction_and_side(void **unused)
{
    const jlt_flow options = { .tolerance = 1e-12, .direction = JLT_BOTH };
    const jlt_top_values values = jlt_system_top_defaults();
    const double q[2] = { 0.43, -0.62 };
    double last_t = 0, shortest = 1e9, longest = 0, energy = 0;
    int last_direction = 0, last_side = 0;
    jlt_section *section;
    jlt_system *system;
    jlt_return row;
    size_t up = 0;

    (void)unused;
    assert_ok(jlt_system_top(&system, &values, &options));
    assert_ok(jlt_section_create(&section, &system->flow));
    assert_ok(jlt_section_start(section, &row, q, 1));
    last_side = 1;
    while (up < RETURNS) {
        assert_ok(jlt_section_next(section, &row));
        assert_int_equal(row.fate, JLT_FATE_ALIVE);
        assert_true(fabs(row.residual) < 1e-13);
        if (last_direction != 0) assert_int_equal(row.direction, -last_direction);
        last_direction = row.direction;
        if (row.direction > 0) {
            const int side = row.q[0] > 0 ? 1 : -1;
            assert_int_equal(side, -last_side);
            last_side = side;
            up++;
        }
        shortest = fmin(shortest, row.t - last_t);
        longest = fmax(longest, row.t - last_t);
        last_t = row.t;
        energy = fmax(energy, fabs(jlt_chart_top_energy(jlt_system_top_chart(system), row.x) - values.E) / values.E);
    }
    printf("%d returns, t = %.10g; times between crossings %.6g .. %.6g; relative drift of E %.2g\n", RETURNS, last_t,
           shortest, longest, energy);
    assert_true(shortest > 0.5 && longest < 5);
    assert_true(energy < 1e-6); /* tolerance times steps */
    jlt_section_destroy(section);
    jlt_system_destroy(system);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(crossings_alternate_in_direction_and_side) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
