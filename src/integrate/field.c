#include "integrate/field.h"

#include <float.h>
#include <math.h>

#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"

bool jlt_field_watches(const jlt_field *field)
{
    const jlt_domain *domain = &field->domain;
    bool watches = domain->conditions > 0;

    for (unsigned i = 0; domain->intervals != NULL && i < domain->states; i++)
        watches |= isfinite(domain->intervals[i].low) || isfinite(domain->intervals[i].high);
    return watches;
}

unsigned jlt_field_unbounded(const jlt_field *field, const double *x, double t)
{
    const double rate = jlt_field_time_rate(field, x);
    double f[JLT_FIELD_DIM_MAX], first = 1e5 * DBL_EPSILON * fabs(t);
    unsigned found = field->dim;

    field->call(x, field->p, f);
    for (unsigned i = 0; i < field->dim; i++) {
        const double doubles = fabs(x[i] * rate / f[i]);
        if (!(fabs(x[i]) > 1) || !(x[i] * (f[i] / rate) * t > 0) || !(doubles < first)) continue;
        first = doubles;
        found = i;
    }
    return found;
}

/* How many conditions restrict orbits: none where all are on parameters alone. */
static unsigned conditions_of(const jlt_descriptor *descriptor)
{
    for (unsigned i = 0; i < descriptor->domain_count; i++)
        if (!descriptor->domains[i].of_params) return descriptor->domain_count;
    return 0;
}

double jlt_field_size(double largest)
{
    static const double ordinary = 0x1p-6, least = 0x1p-400;

    return largest > 0 && largest < ordinary ? ldexp(1, ilogb(fmax(largest, least))) : 1;
}

bool jlt_field_keeps(const jlt_field *field, unsigned i)
{
    return jlt_state_set_has(&field->kept, i);
}

double jlt_field_scale(const jlt_field *field, unsigned i)
{
    if (field->scale != NULL) return field->scale[i];
    return (int)i == field->root || jlt_field_keeps(field, i) ? 0 : 1;
}

double jlt_field_small(const jlt_field *field, unsigned i, double size)
{
    const double scale = jlt_field_scale(field, i);

    return scale == 1 && i < field->sized ? size : scale;
}

double jlt_field_size_at(const jlt_field *field, const double *x)
{
    double largest = 0;

    for (unsigned i = 0; i < field->sized; i++)
        if (jlt_field_scale(field, i) == 1 || jlt_field_keeps(field, i)) largest = fmax(largest, fabs(x[i]));
    return jlt_field_size(largest);
}

/* The rate of state i where its value is `at`, and others are in the part `inside` of their intervals, or away from an end by
 * numbers whose ratios are no fractions at both parts: terms with simple factors do not cancel there. */
static double rate_at(const jlt_field *field, const jlt_quantity *states, unsigned i, double at, double inside)
{
    double x[JLT_DOMAIN_STATES_MAX], f[JLT_DOMAIN_STATES_MAX];

    for (unsigned j = 0; j < field->dim; j++) {
        const double low = states[j].low, high = states[j].high, away = sqrt(inside + 0.1 * j);
        x[j] = isfinite(low) ? isfinite(high) ? low + inside * (high - low) : low + away : isfinite(high) ? high - away : away;
    }
    x[i] = at;
    field->call(x, field->p, f);
    return f[i];
}

/* Whether the rate of state i goes to 0 with the state, about as fast: after sqrt(x) x comes to 0. A rate that is 0 beside 0 too
 * may be none of the state's own, as one that underflows far from its pulse, or one that cancels. */
static bool rests_at_zero(const jlt_field *field, const jlt_quantity *states, unsigned i, double inside)
{
    const double side = states[i].low < 0 ? -1 : 1;
    const double near = rate_at(field, states, i, side * 0x1p-40, inside);
    const double nearer = rate_at(field, states, i, side * 0x1p-80, inside);

    return rate_at(field, states, i, 0, inside) == 0 && nearer != 0 && fabs(nearer) * 0x1p40 <= 4 * fabs(near);
}

/* A root that is a state has a scale of its own. */
static void find_kept(jlt_field *field, const jlt_quantity *states)
{
    for (unsigned i = 0; i < field->dim; i++)
        if ((int)i != field->root && states[i].low <= 0 && states[i].high >= 0
            && rests_at_zero(field, states, i, 0.3) && rests_at_zero(field, states, i, 0.7))
            jlt_state_set_add(&field->kept, i);
}

static void find_angles(jlt_field *field, const jlt_descriptor *descriptor)
{
    for (unsigned i = 0; i < field->dim; i++)
        if (jlt_descriptor_proves(descriptor, "periodic", descriptor->states[i].name)) jlt_state_set_add(&field->angles, i);
}

jlt_status jlt_field_of(jlt_field *out, const jlt_instance *instance)
{
    if (out == NULL || instance == NULL) return JLT_ERR_ARG;
    const jlt_descriptor *descriptor = instance->descriptor;
    if (descriptor->rhs.call == NULL) return JLT_ERR_UNSUPPORTED;
    if (descriptor->state_count == 0 || descriptor->state_count > JLT_FIELD_DIM_MAX) return JLT_ERR_UNSUPPORTED;

    const unsigned last = descriptor->state_count - 1;
    const int has_root = descriptor->time_factor.call != NULL && descriptor->states[last].low == 0;
    *out = (jlt_field){
        .dim = descriptor->state_count,
        .call = descriptor->rhs.call,
        .p = instance->prepared,
        .time_rate = descriptor->time_factor.call,
        .jacobian = descriptor->jacobian.call,
        .jet = descriptor->jet,
        .batch = jlt_batch_isa_best(descriptor, 0),
        .domain = { .states = descriptor->state_count,
                    .intervals = descriptor->lifted_count == 0 ? instance->states : NULL,
                    .conditions = conditions_of(descriptor),
                    .values = descriptor->domain_values.call,
                    .gradients = descriptor->domain_gradients.call,
                    .p = instance->prepared },
        .root = has_root ? (int)last : -1,
        .sized = descriptor->state_count,
    };
    find_kept(out, instance->states);
    find_angles(out, descriptor);
    return JLT_OK;
}
