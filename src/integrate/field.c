#include "integrate/field.h"

#include <float.h>
#include <math.h>

#include "integrate/signs.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"

bool jlt_field_restricts(const jlt_field *field)
{
    const jlt_domain *domain = &field->domain;
    bool restricts = domain->conditions > 0;

    for (unsigned i = 0; domain->intervals != NULL && i < domain->states; i++)
        restricts |= isfinite(domain->intervals[i].low) || isfinite(domain->intervals[i].high);
    return restricts;
}

bool jlt_field_watches(const jlt_field *field)
{
    return jlt_field_restricts(field) || field->groups.count > 0 || jlt_state_set_count(&field->kept) > 0;
}

double jlt_field_group_size(const jlt_field *field, const double *x, unsigned i)
{
    const jlt_state_groups *groups = &field->groups;
    double size = INFINITY;

    if (!jlt_state_set_has(&groups->any, i)) return size;
    for (unsigned g = 0; g < groups->count; g++) {
        double largest = 0;
        bool has = false;
        for (unsigned k = groups->first[g]; k < groups->first[g + 1]; k++) {
            largest = fmax(largest, fabs(x[groups->member[k]]));
            has = has || groups->member[k] == i;
        }
        if (has) size = fmin(size, largest);
    }
    return size;
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

/* The number of conditions that restrict orbits: 0 if all are on parameters alone. */
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
    jlt_signs_find(out, instance->states);
    find_angles(out, descriptor);
    return JLT_OK;
}
