#include "claims/sample.h"

#include "analysis/density.h"
#include "kernel/descriptor.h"
#include "kernel/kernel.h"
#include "kernel/region.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { REDRAWS = 1000 };

const ttc_claim *jlt_verify_claim(const jlt_verify_run *run, const jlt_equilibria *family)
{
    const ttc_model *model = run->oracle->model;

    for (size_t i = 0; i < model->claim_count; i++)
        if (model->claims[i].kind == TTC_CLAIM_EQUILIBRIA && strcmp(model->claims[i].name, family->name) == 0)
            return &model->claims[i];
    return NULL;
}

/* Set the oracle to a point of the family, which binds conditions and dependent states to expressions, all else to these values. */
static void place(jlt_verify_run *run, const ttc_claim *claim, const double *params, const double *x)
{
    ttc_ball *ball = run->oracle->ball;

    jlt_oracle_set_params(run->oracle, params, NULL);
    jlt_oracle_set_states(run->oracle, x, NULL);
    if (claim == NULL) return;
    for (size_t i = 0; i < claim->when.count; i++)
        ttc_ball_bind(ball, claim->when.items[i].symbol, claim->when.items[i].expression);
    for (size_t i = 0; i < claim->bindings.count; i++)
        ttc_ball_bind(ball, claim->bindings.items[i].symbol, claim->bindings.items[i].expression);
}

void jlt_verify_draw_params(double *params, const jlt_descriptor *descriptor, jlt_random *random, unsigned kind)
{
    for (unsigned i = 0; i < descriptor->param_count; i++) {
        const jlt_quantity *q = &descriptor->params[i];
        const double magnitude = kind == 2 ? jlt_random_magnitude(random, -8, 8) : jlt_random_magnitude(random, -1, 1);
        const uint64_t die = jlt_random_below(random, 16);
        if (kind == 0 && !isnan(q->value)) params[i] = q->value;
        else if (q->sign == JLT_POSITIVE) params[i] = magnitude;
        else if (q->sign == JLT_NONNEGATIVE) params[i] = die == 0 ? 0.0 : magnitude;
        else if (q->sign == JLT_NONZERO || die != 0) params[i] = die < 8 ? -magnitude : magnitude;
        else params[i] = 0.0;
    }
    /* Coincidences that are worth testing: two parameters equal, or one ulp apart. */
    if (kind != 0 && descriptor->param_count > 1 && jlt_random_below(random, 8) == 0) {
        const size_t from = (size_t)jlt_random_below(random, descriptor->param_count);
        const size_t to = (size_t)jlt_random_below(random, descriptor->param_count);
        const double value = jlt_random_below(random, 2) == 0 ? params[from] : nextafter(params[from], 2 * params[from]);
        if (value != 0.0 && (value > 0.0 || descriptor->params[to].sign == JLT_ANY_SIGN ||
                             descriptor->params[to].sign == JLT_NONZERO))
            params[to] = value;
    }
}

/* kind 2: unbounded states extreme in size; kind 3: bounded states within 1e-2 to 1e-12 of an end of their interval; else
 * moderate. Except for kind 0, an unbounded state is zero now and then. */
static void draw_states(double *x, const jlt_descriptor *d, jlt_random *random, unsigned kind)
{
    jlt_density_draw_state(x, d, NULL, random);
    for (unsigned i = 0; i < d->state_count; i++) {
        const jlt_quantity *q = &d->states[i];
        const bool limited = isfinite(q->low) && isfinite(q->high);
        if (kind == 2 && !limited) x[i] = copysign(jlt_random_magnitude(random, -8, 8), x[i]);
        if (kind == 3 && limited) {
            const double end = jlt_random_below(random, 2) == 0 ? q->low : q->high;
            x[i] = end - copysign(jlt_random_magnitude(random, -12, -2), end - (q->low / 2 + q->high / 2));
        }
        if (kind != 0 && !limited && jlt_random_below(random, 12) == 0) x[i] = 0.0;
    }
}

/* Take the point of the family with the free states of x and these parameters as far as its condition leaves them; on the whole
 * domain, x, and the parameters as far as a variant leaves them. */
static jlt_status settle(jlt_sample *out, const jlt_equilibria *family, const jlt_descriptor *variant, const double *x,
                         const double *params)
{
    const jlt_descriptor *d = variant->family[0];
    const jlt_kernel_function impose = family != NULL ? family->impose : variant->impose;

    memcpy(out->params, params, d->param_count * sizeof *params);
    memcpy(out->x, x, d->state_count * sizeof *x);
    if (impose != NULL)
        JLT_PASS(jlt_kernel_eval_function(out->params, impose, d->param_count, x, d->state_count, params, d->param_count));
    if (family == NULL) return JLT_OK;
    return jlt_kernel_eval_function(out->x, family->point, d->state_count, x, d->state_count, out->params, d->param_count);
}

/* The variant of the table's own field, the general one among them, that comes at this number. */
static const jlt_descriptor *variant_at(const jlt_descriptor *general, size_t number)
{
    size_t count = 0;

    for (size_t i = 0;; i = general->family[i + 1] == NULL ? 0 : i + 1) {
        const jlt_descriptor *d = general->family[i];
        if (d->time[0] == '\0' && d->elimination[0] == '\0' && count++ == number) return d;
    }
}

bool jlt_sample_draw(jlt_sample *sample, jlt_verify_run *run, const jlt_sample_subject *subject, size_t number)
{
    const jlt_descriptor *d = run->descriptor, *variant = variant_at(d, number / 4);

    for (int attempt = 0; attempt < REDRAWS; attempt++) {
        const unsigned kind = attempt < REDRAWS / 2 ? (unsigned)(number % 4) : 1;
        double params[JLT_SAMPLE_PARAMS_MAX], x[JLT_SAMPLE_STATES_MAX], value;
        const jlt_region *region;
        size_t index;
        jlt_verify_draw_params(params, d, &run->random, kind);
        draw_states(x, d, &run->random, kind);
        if (jlt_descriptor_check_state(d, x, &index) != JLT_OK) continue;
        if (settle(sample, subject->family, variant, x, params) == JLT_OK &&
            jlt_descriptor_check_params(d, sample->params, &index) == JLT_OK &&
            jlt_descriptor_check_state(d, sample->x, &index) == JLT_OK &&
            jlt_region_check(&region, &value, d, sample->params, sample->x) == JLT_OK)
            return true;
    }
    return false;
}

jlt_status jlt_sample_enclose(jlt_sample *sample, jlt_verify_run *run, const jlt_sample_subject *subject)
{
    const size_t n = run->descriptor->state_count;
    jlt_oracle *o = run->oracle;

    place(run, subject->claim, sample->params, sample->x);
    JLT_PASS(jlt_oracle_estimate(o, sample->jacobian, o->jacobian, n * n));
    JLT_PASS(jlt_oracle_estimate(o, &sample->trace, &o->trace, 1));
    if (subject->family != NULL)
        JLT_PASS(jlt_oracle_estimate(o, sample->gradient, subject->gradients, subject->family->left_null_count * n));
    JLT_PASS(jlt_oracle_estimate(o, sample->field, o->field, n));
    for (size_t i = 0; i < n * n; i++)
        sample->majorant[i] = fmax(fabs(sample->jacobian[i].value), sample->jacobian[i].rounding / (DBL_EPSILON / 2));
    return JLT_OK;
}

jlt_status jlt_sample_subject_init(jlt_sample_subject *subject, const jlt_verify_run *run, const jlt_equilibria *family)
{
    const size_t n = run->descriptor->state_count;

    *subject = (jlt_sample_subject){ .family = family };
    if (family == NULL) return JLT_OK;
    subject->claim = jlt_verify_claim(run, family);
    if (subject->claim == NULL) return JLT_ERR_UNSUPPORTED;
    subject->gradients = calloc(family->left_null_count * n + 1, sizeof *subject->gradients);
    if (subject->gradients == NULL) return JLT_ERR_NOMEM;
    for (size_t k = 0; k < family->left_null_count; k++) {
        const ttc_id *gradient = jlt_oracle_gradient(run->oracle, family->left_null[k].name);
        if (gradient == NULL) return JLT_ERR_UNSUPPORTED;
        memcpy(subject->gradients + k * n, gradient, n * sizeof *gradient);
    }
    return JLT_OK;
}

void jlt_sample_subject_clear(jlt_sample_subject *subject)
{
    free(subject->gradients);
    *subject = (jlt_sample_subject){ 0 };
}
