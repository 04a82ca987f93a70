/* GSL's own handler ends the program on an error. Whichever of our functions calls GSL first has switched it off before. */
#include "unit/check.h"

#include <gsl/gsl_errno.h>

#include <stdbool.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ext/eigen.h"
#include "ext/gsl_ode.h"
#include "ext/quadrature.h"

static void trap(const char *reason, const char *file, int line, int code)
{
    (void)reason;
    (void)file;
    (void)line;
    (void)code;
}

static jlt_status one(void *context, double *value, double at)
{
    (void)context;
    (void)at;
    *value = 1.0;
    return JLT_OK;
}

static void rest(void *context, const double *x, double *f)
{
    (void)context;
    (void)x;
    f[0] = 0.0;
}

static bool roots(void)
{
    double re[2], im[2];
    return jlt_eigen_polynomial_roots(re, im, (const double[]){ 1, 0, -2 }, 2) == JLT_OK;
}

static bool least_squares(void)
{
    double z[1];
    return jlt_eigen_least_squares(z, (const double[]){ 1, 2 }, (const double[]){ 2, 4 }, 2, 1, 1e-10) == JLT_OK && z[0] > 1.9;
}

static bool quadrature(void)
{
    double integral, error;
    return jlt_quadrature_integrate(&integral, &error, one, NULL, 0, 2, 0, 1e-12) == JLT_OK && integral > 1.9;
}

static bool integrator(void)
{
    const double scale = 1.0;
    jlt_gsl_ode *ode;
    jlt_status st = jlt_gsl_ode_create(&ode, JLT_GSL_RK8PD, 1, rest, NULL, 1e-9);
    if (st == JLT_OK) st = jlt_gsl_ode_reset(ode, &scale);
    jlt_gsl_ode_destroy(ode);
    return st == JLT_OK;
}

/* In a process of its own, where nobody has called before. */
static void every_caller_switches_the_handler_off(void **unused)
{
    bool (*const callers[])(void) = { roots, least_squares, quadrature, integrator };

    (void)unused;
    for (size_t i = 0; i < sizeof callers / sizeof *callers; i++) {
        const pid_t child = fork();
        int status;
        assert_true(child >= 0);
        if (child == 0) {
            gsl_set_error_handler(&trap);
            const bool done = callers[i]();
            _exit(done && gsl_set_error_handler(NULL) != &trap ? 0 : 1);
        }
        assert_int_equal(waitpid(child, &status, 0), child);
        if (status != 0) fail_msg("caller %zu leaves GSL's handler on, or fails", i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(every_caller_switches_the_handler_off) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
