/* What every test program needs: cmocka with its prerequisites, and comparison of numbers. */
#ifndef JLT_TESTS_CHECK_H
#define JLT_TESTS_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define assert_ok(call) assert_int_equal((call), 0)

#define assert_near(value, expected, tolerance)                                                                     \
    do {                                                                                                            \
        const double near_v = (value), near_e = (expected), near_t = (tolerance);                                   \
        if (!(fabs(near_v - near_e) <= near_t))                                                                     \
            fail_msg("%s = %.17g, expected %.17g within %.3g, off by %.3g", #value, near_v, near_e, near_t,         \
                     near_v - near_e);                                                                              \
    } while (0)

#define assert_below(value, bound)                                                              \
    do {                                                                                        \
        const double below_v = (value), below_b = (bound);                                      \
        if (!(below_v <= below_b)) fail_msg("%s = %.6g, expected at most %.6g", #value, below_v, below_b); \
    } while (0)

#endif
