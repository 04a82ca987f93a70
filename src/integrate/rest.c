#include "integrate/rest.h"

#include <math.h>

#include "ext/eigen.h"
#include "integrate/locate.h"
#include "integrate/step_control.h"

enum { SLOW_STEPS = 64 /* some turns of a spiral */, LOOK_STEPS = 1024 };

double jlt_rest_slow(double tolerance)
{
    return jlt_larger(JLT_REST_STILL, jlt_smaller(1e3 * tolerance, 1e-6));
}

/* Whether state i grows, and is known however small it is: one that is kept. */
static bool grows(const jlt_field *field, unsigned i, double f, double x, double direction)
{
    return jlt_field_keeps(field, i) && x != 0 && (f * direction > 0) == (x > 0);
}

/* Whether states that are 0 only together are not slower than `speed`, relative to the largest of them, and move away from 0: their
 * part of the Jacobian has an eigenvalue of positive real part, as time goes. */
static bool group_grows(const jlt_field *field, unsigned group, const double *f, const double *x, const double *jacobian,
                        double speed, double direction)
{
    double part[JLT_JACOBIAN_DIM_MAX * JLT_JACOBIAN_DIM_MAX], re[JLT_JACOBIAN_DIM_MAX], im[JLT_JACOBIAN_DIM_MAX];
    double fastest = 0, growth = 0, largest = 0, rate = 0;
    unsigned members[JLT_JACOBIAN_DIM_MAX], n = 0;

    for (unsigned k = field->groups.first[group]; k < field->groups.first[group + 1]; k++) {
        const unsigned i = field->groups.member[k];
        members[n++] = i;
        largest = fmax(largest, fabs(x[i]));
        rate = fmax(rate, fabs(f[i]));
    }
    if (!(rate > speed * largest)) return false;
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++) part[i * n + j] = jacobian[members[i] * field->dim + members[j]];
    if (jlt_eigen_values(re, im, part, n) != JLT_OK) return false;
    for (unsigned i = 0; i < n; i++) {
        fastest = fmax(fastest, hypot(re[i], im[i]));
        growth = fmax(growth, re[i] * direction);
    }
    return growth > 1e-8 * fastest; /* less may be a defective 0 */
}

static bool any_group_grows(const jlt_field *field, const double *f, const double *x, double speed, double direction)
{
    double jacobian[JLT_JACOBIAN_DIM_MAX * JLT_JACOBIAN_DIM_MAX];

    if (field->groups.count == 0 || field->jacobian == NULL || field->dim > JLT_JACOBIAN_DIM_MAX) return false;
    field->jacobian(x, field->p, jacobian);
    for (unsigned group = 0; group < field->groups.count; group++)
        if (group_grows(field, group, f, x, jacobian, speed, direction)) return true;
    return false;
}

static bool slower(const jlt_field *field, const double *f, const double *x, double size, double speed, double direction)
{
    for (unsigned i = 0; i < field->dim; i++) {
        const double own = grows(field, i, f[i], x[i], direction) ? fabs(x[i]) : jlt_larger(fabs(x[i]), size);
        if (!(fabs(f[i]) < speed * own)) return false;
    }
    return !any_group_grows(field, f, x, speed, direction);
}

bool jlt_rest_is_slower(const jlt_field *field, const double *x, double size, double speed, double direction)
{
    double f[JLT_FIELD_DIM_MAX];

    field->call(x, field->p, f);
    return slower(field, f, x, size, speed * jlt_field_time_rate(field, x), direction);
}

bool jlt_rest_is_still(const jlt_field *field, const double *x, double direction)
{
    const double size = jlt_field_size_at(field, x);

    return jlt_rest_is_slower(field, x, size, JLT_REST_STILL, direction) && jlt_approach_is_near(field, x, size, JLT_REST_STILL);
}

static double pace(const jlt_stepper *stepper)
{
    return stepper->columns > stepper->field->dim ? stepper->f[stepper->field->dim] : 1;
}

static bool stepper_slower(const jlt_stepper *stepper, double speed)
{
    return slower(stepper->field, stepper->f, stepper->x, stepper->size, speed * pace(stepper), stepper->direction);
}

bool jlt_rest_is_ahead(const jlt_stepper *stepper, unsigned column, double level)
{
    const double x = stepper->x[column], f = stepper->f[column];

    if (level == 0 || !(fabs(x) > fabs(level)) || !jlt_field_keeps(stepper->field, column)) return false;
    return (f * stepper->direction > 0) != (x > 0) && fabs(f) > JLT_REST_STILL * pace(stepper) * fabs(x);
}

/* Whether the orbit decays onto a known equilibrium; limit gets it. A root that goes to 0 leads to a pole, another kind of end. */
static bool decays_to(jlt_approach *approach, const jlt_stepper *stepper, double *limit)
{
    static const double weakest = 1e-5; /* a rate below this part of the fastest may be 0 */
    const int root = stepper->field->root;

    if (jlt_approach_judge(approach, stepper) != JLT_OK || !jlt_approach_is_known(approach, stepper)
        || !(approach->slowest > weakest * approach->fastest)) return false;
    for (unsigned i = 0; i < stepper->field->dim; i++) limit[i] = stepper->x[i] - approach->left[i];
    return root < 0 || limit[root] - approach->root_left_out > 0.5 * stepper->x[root];
}

bool jlt_rest_ends(const jlt_stepper *stepper, double *limit)
{
    jlt_approach approach;

    if (decays_to(&approach, stepper, limit)) return true;
    if (!stepper_slower(stepper, JLT_REST_STILL)) return false;
    if (!jlt_approach_is_near(stepper->field, stepper->x, stepper->size, JLT_REST_STILL)) return false;
    for (unsigned i = 0; i < stepper->field->dim; i++) limit[i] = stepper->x[i];
    return true;
}

/* Whether the remaining displacement is less than jlt_locate_noise, so that no crossing can follow. */
static bool is_near(const jlt_stepper *stepper, double *limit)
{
    jlt_approach approach;

    return decays_to(&approach, stepper, limit) && approach.longest <= jlt_locate_noise(stepper->asked);
}

bool jlt_rest_watch_step(jlt_rest_watch *self, const jlt_stepper *stepper, double *limit)
{
    if (!stepper_slower(stepper, jlt_rest_slow(stepper->asked))) self->slow_steps = 0;
    if (++self->slow_steps > SLOW_STEPS && jlt_rest_ends(stepper, limit)) return true;
    return ++self->steps % LOOK_STEPS == 0 && is_near(stepper, limit);
}
