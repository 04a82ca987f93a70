/** Adds comparisons of computed numbers with exact ones to a table of checks, each with a bound derived where it is made. */
#ifndef JLT_CLAIMS_CHECK_H
#define JLT_CLAIMS_CHECK_H

#include "claims/verify.h"

#include <float.h>

static const double jlt_roundoff = DBL_EPSILON / 2;

/* The factor by which other arithmetic may exceed the running error bound of the expression as written: the optimizer reassociates
 * and shares subexpressions, which costs a few more operations. */
static const double jlt_rearranged = 4.0;

/* The check of this name, made with this text on its bound if there is none. */
jlt_verify_check *jlt_check_named(jlt_verify_family *f, const char *name, const char *bound);

/* Add one comparison. value: the exact number, 0 where it is zero or not known to full precision; size: see jlt_verify_check. */
void jlt_check_add(jlt_verify_check *check, double error, double value, double size, double bound);

/* Running error of the expression, plus one rounding of the result in case the expression itself is free of rounding. */
double jlt_check_running(double rounding, const ttc_enclosure *exact);

/** Compare computed values of expressions with their enclosures, both of shape (count,). On a family without angles, kernels are as
 *  accurate as the expressions as written. Elsewhere they may lose what expanding one costs, x*(a - b) as x*a - x*b or cos(2a + b)
 *  in cosines and sines of a and b: a few times what rounding all values does. */
void jlt_check_enclosures(jlt_verify_family *f, const char *name, const double *computed, const ttc_enclosure *exact,
                               size_t count);

#endif
