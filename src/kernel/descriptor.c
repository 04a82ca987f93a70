#include "kernel/descriptor.h"

#include "registry.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

size_t jlt_descriptor_count(void)
{
    return jlt_registry_count;
}

const jlt_descriptor *jlt_descriptor_at(size_t index)
{
    return index < jlt_registry_count ? jlt_registry[index] : NULL;
}

static bool same(const char *name, const char *asked)
{
    return strcmp(name, asked == NULL ? "" : asked) == 0;
}

const jlt_descriptor *jlt_descriptor_find(const char *model, const char *variant, const char *time,
                                          const char *elimination)
{
    for (size_t i = 0; i < jlt_registry_count; i++) {
        const jlt_descriptor *d = jlt_registry[i];
        if (same(d->model, model) && same(d->variant, variant) && same(d->time, time) &&
            same(d->elimination, elimination))
            return d;
    }
    return NULL;
}

static bool serves(const jlt_descriptor *descriptor, const double *params)
{
    double imposed[JLT_DESCRIPTOR_VALUES_MAX];

    if (descriptor->impose == NULL) return true;
    descriptor->impose(NULL, params, imposed);
    for (unsigned i = 0; i < descriptor->param_count; i++)
        if (imposed[i] != params[i] && !(isnan(imposed[i]) && isnan(params[i]))) return false;
    return true;
}

unsigned jlt_descriptor_operations(const jlt_operation_count *count)
{
    return count->add + count->multiply + count->fma + count->divide + count->root + count->elementary;
}

static bool more_special(const jlt_descriptor *a, const jlt_descriptor *b)
{
    if (a->integral_count != b->integral_count) return a->integral_count > b->integral_count;
    return jlt_descriptor_operations(&a->rhs_jacobian.optimized) < jlt_descriptor_operations(&b->rhs_jacobian.optimized);
}

const jlt_descriptor *jlt_descriptor_sibling(const jlt_descriptor *of, const char *variant, const char *time,
                                             const char *elimination)
{
    for (const jlt_descriptor *const *d = of->family; *d != NULL; d++)
        if (same((*d)->variant, variant) && same((*d)->time, time) && same((*d)->elimination, elimination)) return *d;
    return NULL;
}

const jlt_descriptor *jlt_descriptor_choose(const jlt_descriptor *of, const char *time, const char *elimination,
                                            const double *params)
{
    const jlt_descriptor *best = NULL;

    for (const jlt_descriptor *const *d = of->family; *d != NULL; d++) {
        if (!same((*d)->time, time) || !same((*d)->elimination, elimination)) continue;
        if (serves(*d, params) && (best == NULL || more_special(*d, best))) best = *d;
    }
    return best;
}

const jlt_claim *jlt_descriptor_claim(const jlt_descriptor *of, const char *kind, const char *name)
{
    for (const jlt_claim *claim = of->claims; claim->kind != NULL; claim++)
        if (strcmp(claim->kind, kind) == 0 && strcmp(claim->name, name) == 0) return claim;
    return NULL;
}

bool jlt_descriptor_proves(const jlt_descriptor *of, const char *kind, const char *name)
{
    const jlt_claim *claim = jlt_descriptor_claim(of, kind, name);

    return claim != NULL && claim->verdict == JLT_PROVED;
}

bool jlt_descriptor_has_poles(const jlt_descriptor *of)
{
    const jlt_descriptor *general = of->family[0];

    for (unsigned i = 0; i < general->pole_count; i++)
        if (!jlt_descriptor_proves(general, "pole", general->states[general->poles[i].state].name)) return false;
    return general->pole_count > 0;
}

int jlt_descriptor_pole_side(unsigned *state, const jlt_descriptor *of, const double *x)
{
    const jlt_descriptor *general = of->family[0];
    double nearest = INFINITY;
    int side = 0;

    for (unsigned i = 0; i < general->pole_count; i++) {
        const unsigned at = general->poles[i].state;
        const jlt_quantity *q = &general->states[at];
        const double below = fabs(x[at] - q->low) / (q->high - q->low), above = fabs(x[at] - q->high) / (q->high - q->low);
        if (!(fmin(below, above) < nearest)) continue;
        nearest = fmin(below, above);
        *state = at;
        side = above < below ? 1 : -1;
    }
    return side;
}

const jlt_claim *jlt_descriptor_doubted_field(const jlt_descriptor *of)
{
    const char *const made_by[][2] = { { "variant", of->variant }, { "time", of->time }, { "eliminate", of->elimination } };

    for (const jlt_claim *claim = of->claims; claim->kind != NULL; claim++) {
        bool needed = strcmp(claim->kind, "root") == 0 || strcmp(claim->kind, "log") == 0;
        for (unsigned i = 0; i < sizeof made_by / sizeof *made_by; i++)
            needed |= strcmp(claim->kind, made_by[i][0]) == 0 && strcmp(claim->name, made_by[i][1]) == 0;
        if (needed && claim->verdict != JLT_PROVED) return claim;
    }
    return NULL;
}

const jlt_claim *jlt_descriptor_doubted_integral(const jlt_descriptor *of)
{
    for (unsigned i = 0; i < of->integral_count; i++) {
        const jlt_claim *claim = jlt_descriptor_claim(of, "integral", of->integrals[i].name);
        if (claim->verdict != JLT_PROVED) return claim;
    }
    return NULL;
}

bool jlt_descriptor_lists(const jlt_descriptor *of, const char *integral)
{
    for (unsigned i = 0; i < of->integral_count; i++)
        if (strcmp(of->integrals[i].name, integral) == 0) return true;
    return false;
}

bool jlt_descriptor_follows(const jlt_descriptor *of, const char *integral)
{
    for (const jlt_descriptor *const *d = of->family; *d != NULL; d++)
        if (jlt_descriptor_lists(*d, integral)) return true;
    return false;
}

/* Append the claims of `more` that are not yet in `claims`; both are lists joined with ", ". */
static void join_claims(char *claims, size_t size, const char *more)
{
    while (*more != '\0') {
        const size_t length = strcspn(more, ",");
        bool known = false;
        for (const char *c = claims; *c != '\0' && !known; c += strspn(c, ", ")) {
            known = strcspn(c, ",") == length && strncmp(c, more, length) == 0;
            c += strcspn(c, ",");
        }
        const size_t used = strlen(claims);
        if (!known) snprintf(claims + used, size - used, "%s%.*s", used > 0 ? ", " : "", (int)length, more);
        more += length;
        more += strspn(more, ", ");
    }
}

bool jlt_descriptor_unproved(char *claims, size_t size, const jlt_descriptor *of)
{
    claims[0] = '\0';
    for (const jlt_descriptor *const *d = of->family; *d != NULL; d++)
        if ((*d)->unproved != NULL) join_claims(claims, size, (*d)->unproved);
    return claims[0] != '\0';
}

void jlt_descriptor_add_unproved(char *claims, size_t size, const jlt_descriptor *of, const char *kind, const char *name)
{
    const jlt_claim *claim = jlt_descriptor_claim(of, kind, name);
    char one[256];

    if (claim == NULL || claim->verdict == JLT_PROVED) return;
    snprintf(one, sizeof one, "%s %s", kind, name);
    join_claims(claims, size, one);
}

static bool position(const jlt_quantity *quantities, unsigned count, const char *name, size_t *index)
{
    for (unsigned i = 0; i < count; i++)
        if (strcmp(quantities[i].name, name) == 0) {
            *index = i;
            return true;
        }
    return false;
}

bool jlt_descriptor_state(const jlt_descriptor *descriptor, const char *name, size_t *index)
{
    return descriptor != NULL && position(descriptor->states, descriptor->state_count, name, index);
}

bool jlt_descriptor_param(const jlt_descriptor *descriptor, const char *name, size_t *index)
{
    return descriptor != NULL && position(descriptor->params, descriptor->param_count, name, index);
}

jlt_status jlt_descriptor_check_state(const jlt_descriptor *descriptor, const double *x, size_t *index)
{
    if (descriptor == NULL) return JLT_ERR_ARG;
    for (unsigned i = 0; i < descriptor->state_count; i++) {
        const jlt_quantity *q = &descriptor->states[i];
        *index = i;
        if (!isfinite(x[i])) return JLT_ERR_NONFINITE;
        if (x[i] <= q->low || x[i] >= q->high) return JLT_ERR_DOMAIN;
    }
    return JLT_OK;
}

const char *jlt_descriptor_condition(const jlt_quantity *param)
{
    static const char *const conditions[] = {
        [JLT_ANY_SIGN] = "", [JLT_POSITIVE] = " > 0", [JLT_NONNEGATIVE] = " >= 0", [JLT_NONZERO] = " != 0"
    };

    return conditions[param->sign];
}

bool jlt_descriptor_allows(const jlt_quantity *param, double value)
{
    return param->sign == JLT_ANY_SIGN || value > 0.0 || (param->sign == JLT_NONNEGATIVE && value == 0.0)
           || (param->sign == JLT_NONZERO && value != 0.0);
}

jlt_status jlt_descriptor_check_params(const jlt_descriptor *descriptor, const double *params, size_t *index)
{
    if (descriptor == NULL) return JLT_ERR_ARG;
    for (unsigned i = 0; i < descriptor->param_count; i++) {
        *index = i;
        if (!isfinite(params[i])) return JLT_ERR_NONFINITE;
        if (!jlt_descriptor_allows(&descriptor->params[i], params[i])) return JLT_ERR_DOMAIN;
    }
    return JLT_OK;
}
