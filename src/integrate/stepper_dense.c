/* The last step as a polynomial. */
#include "integrate/method.h"

#include <string.h>

#include "integrate/gauss_coefficients.h"

/* Add gap (3 theta^2 - 2 theta^3) to the polynomial, so that it ends at the point exactly. */
static void meet_end(jlt_stepper *self)
{
    for (unsigned from = 0; from < self->stride; from += JLT_STEPPER_WIDTH) {
        double gap[JLT_STEPPER_WIDTH], *c = self->dense + from;
        for (unsigned i = 0; i < JLT_STEPPER_WIDTH; i++) gap[i] = self->x[from + i];
        for (unsigned k = 0; k <= self->dense_degree; k++)
            for (unsigned i = 0; i < JLT_STEPPER_WIDTH; i++) gap[i] -= c[k * (size_t)self->stride + i];
        for (unsigned i = 0; i < JLT_STEPPER_WIDTH; i++) {
            c[2 * self->stride + i] += 3 * gap[i];
            c[3 * self->stride + i] -= 2 * gap[i];
        }
    }
}

jlt_status jlt_stepper_dense(jlt_stepper *self)
{
    if (self->dense_ready) return JLT_OK;
    if (self->h == 0) {
        memcpy(self->dense, self->x, self->stride * sizeof *self->x);
        self->dense_degree = 0;
        self->dense_error = 0;
    } else {
        JLT_PASS(self->method->dense(self));
        meet_end(self);
    }
    self->dense_ready = true;
    return JLT_OK;
}

const double *jlt_stepper_nodes(const jlt_stepper *self)
{
    return self->method->nodes != NULL ? self->method->nodes(self) : NULL;
}

const double *jlt_stepper_between(const jlt_stepper *self)
{
    return self->method->between != NULL ? self->method->between(self) : NULL;
}

double jlt_stepper_value(const jlt_stepper *self, unsigned column, double theta)
{
    const double *c = self->dense + column;
    double sum = 0;
    for (unsigned k = self->dense_degree + 1; k-- > 0;) sum = sum * theta + c[k * (size_t)self->stride];
    return sum;
}

void jlt_stepper_values(const jlt_stepper *self, double theta, double *out)
{
    for (unsigned from = 0; from < self->columns; from += JLT_STEPPER_WIDTH) {
        const unsigned left = self->columns - from;
        double sum[JLT_STEPPER_WIDTH] = { 0 };
        for (unsigned k = self->dense_degree + 1; k-- > 0;) {
            const double *c = self->dense + k * (size_t)self->stride + from;
            for (unsigned i = 0; i < JLT_STEPPER_WIDTH; i++) sum[i] = sum[i] * theta + c[i];
        }
        memcpy(out + from, sum, (left < JLT_STEPPER_WIDTH ? left : JLT_STEPPER_WIDTH) * sizeof *sum);
    }
}
