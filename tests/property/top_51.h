/* The system of (5.1) of Kilin and Ivanova (2023) on its section, on which these tests follow orbits. */
#ifndef JLT_TESTS_TOP_51_H
#define JLT_TESTS_TOP_51_H

#include "unit/check.h"
#include "witness/top_section.h"

static jlt_system *top_51(double tolerance)
{
    const jlt_flow options = { .tolerance = tolerance, .direction = JLT_RISING };
    const jlt_top_values values = jlt_system_top_defaults();
    jlt_system *system;

    assert_ok(jlt_system_top(&system, &values, &options));
    return system;
}

#endif
