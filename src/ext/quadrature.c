#include "ext/quadrature.h"

#include "ext/gsl.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <math.h>

enum { SUBINTERVALS = 2000, FIRST = 200 };

typedef struct {
    jlt_quadrature_integrand integrand;
    void *context;
    jlt_status status; /* of the first evaluation that failed */
} call;

static double evaluate(double at, void *parameters)
{
    call *c = parameters;
    double value = 0.0;

    if (c->status != JLT_OK) return 0.0;
    c->status = c->integrand(c->context, &value, at);
    return c->status == JLT_OK ? value : 0.0;
}

jlt_status jlt_quadrature_integrate(double *integral, double *error, jlt_quadrature_integrand integrand, void *context,
                                    double low, double high, double absolute, double relative)
{
    call c = { integrand, context, JLT_OK };
    const gsl_function function = { evaluate, &c };
    gsl_integration_workspace *space;
    jlt_status st = JLT_ERR_NOMEM;
    double result = 0.0, estimate = 0.0;
    int gsl;

    jlt_gsl_quiet();
    space = gsl_integration_workspace_alloc(SUBINTERVALS);
    if (space == NULL) goto done;
    gsl = gsl_integration_qag(&function, low, high, absolute, relative, FIRST, GSL_INTEG_GAUSS31, space, &result, &estimate);
    if (gsl != GSL_SUCCESS && c.status == JLT_OK) {
        double extrapolated = 0.0, doubt = 0.0;
        const int again = gsl_integration_qags(&function, low, high, absolute, relative, SUBINTERVALS, space, &extrapolated,
                                               &doubt);
        if (again == GSL_SUCCESS || gsl != GSL_EROUND || doubt < estimate) gsl = again, result = extrapolated, estimate = doubt;
    }
    st = c.status;
    if (st != JLT_OK) goto done;
    /* GSL_EROUND: the remaining error is rounding, and the estimate includes it. */
    if (gsl != GSL_SUCCESS && gsl != GSL_EROUND) st = JLT_ERR_NO_CONVERGENCE;
    else if (!isfinite(result)) st = JLT_ERR_NONFINITE;
    if (st != JLT_OK) goto done;
    *integral = result;
    *error = estimate;
done:
    gsl_integration_workspace_free(space);
    return st;
}
