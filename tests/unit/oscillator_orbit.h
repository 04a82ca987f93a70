/* Orbits of the harmonic oscillator by every method; their crossings are known in closed form. */
#ifndef JLT_TESTS_OSCILLATOR_ORBIT_H
#define JLT_TESTS_OSCILLATOR_ORBIT_H

#include "unit/check.h"
#include "unit/sample_fields.h"

#include "integrate/orbit.h"

static const double pi = 3.14159265358979323846;
static const jlt_field oscillator_field = { .dim = 2, .call = oscillator, .root = -1 };
static const char *const methods[] = { "dop853", "gauss", "rk8pd", "rkf45", "msadams" };
enum { METHODS = sizeof methods / sizeof *methods };

static jlt_orbit *oscillator_orbit(const char *method, double tolerance, double phase, int direction)
{
    const double x[2] = { cos(phase), -sin(phase) };
    jlt_orbit *orbit = NULL;
    assert_ok(jlt_orbit_create(&orbit, jlt_method_find(method), &oscillator_field, &(jlt_options){ .tolerance = tolerance }));
    assert_ok(jlt_orbit_start(orbit, 0, x, direction));
    return orbit;
}

#endif
