#include "stability/random_tops/oracle.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#if LDBL_MANT_DIG == 113
typedef long double quad;
#else
__extension__ typedef __float128 quad;
#endif

enum { STEPS_MAX = 4000 };
static const long double still = 1e-16L; /* slower than this an orbit is at rest */

#define REAL quad
#define NAME(name) name##_quad
#define ORDER 24
#define PART 1e-21L
#define EPSILON 1e-30L
#include "stability/random_tops/oracle_real.inc"
#undef REAL
#undef NAME
#undef ORDER
#undef PART
#undef EPSILON

#define REAL long double
#define NAME(name) name##_long
#define ORDER 18
#define PART 1e-18L
#define EPSILON 1e-18L
#include "stability/random_tops/oracle_real.inc"

void oracle_follow(oracle_orbit *out, const oracle_question *question, oracle_noise noise, jlt_random *random)
{
    if (noise == ORACLE_EXACT) follow_quad(out, question, noise, random);
    else follow_long(out, question, noise, random);
}
