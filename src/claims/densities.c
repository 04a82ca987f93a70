/* Compares the invariant measures found numerically through the kernels with those that the table claims. */
#include "claims/verify.h"

#include "core/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 41, SAMPLES = 200, DRAWS_OF_PARAMS = 3, REDRAWS = 100 };

/* Set d->contradicted: whether the range of the density that was found contains an equilibrium that excludes it. */
static jlt_status contradict(jlt_verify_run *run, jlt_verify_density *d, jlt_instance *instance)
{
    const jlt_measure_attempt *a = &d->attempt;
    jlt_measure_finding finding = { .instance = instance };
    const jlt_status st = jlt_measure_obstruct(&finding, run->descriptor, d->params, NULL, &run->random);
    const double at = finding.x[a->along];

    d->contradicted = finding.obstructed && at >= a->points[0].at && at <= a->points[a->count - 1].at;
    return st;
}

static jlt_status attempt(jlt_verify_run *run, jlt_verify_density *d)
{
    double residual[JLT_MEASURE_CLAIMS_MAX];
    JLT_OWNED(jlt_instance) *instance = NULL;

    JLT_PASS(jlt_instance_create(&instance, d->descriptor, d->params));
    JLT_PASS(jlt_measure_try(&d->attempt, instance, POINTS, &run->random));
    JLT_PASS(jlt_density_residual(residual, instance, SAMPLES, &run->random));
    for (unsigned i = 0; i < d->descriptor->measure_count; i++) d->residual = fmax(d->residual, residual[i]);
    if (d->descriptor->measure_count == 0 && d->attempt.found && d->attempt.points != NULL)
        return contradict(run, d, instance);
    return JLT_OK;
}

/* Whether the parameters lie outside the table's domain, or hardly a random state lies in it at these parameters. */
static bool is_outside(const jlt_verify_density *d)
{
    const bool has_instance = d->attempt.count > 0;

    return d->status == JLT_ERR_NO_CONVERGENCE || (d->status == JLT_ERR_DOMAIN && !has_instance);
}

/* If the table claims a measure, it must be confirmed; if not, no density that contradicts an equilibrium may be found. */
static bool holds(const jlt_verify_density *d)
{
    const jlt_measure_attempt *a = &d->attempt;

    if (d->status != JLT_OK) return false;
    if (d->descriptor->measure_count > 0)
        return d->residual <= JLT_DENSITY_TOLERANCE && (a->closed_form == NULL || a->difference <= a->difference_bound);
    return !d->contradicted;
}

static jlt_status add(jlt_verify_run *run, const jlt_descriptor *descriptor, unsigned kind)
{
    const jlt_descriptor *general = run->descriptor;
    jlt_verify_density *d = &run->densities[run->density_count];
    JLT_FREED double *drawn = jlt_memory_array(general->param_count, sizeof *drawn);
    double zero[256] = { 0 };

    d->descriptor = descriptor;
    d->params = jlt_memory_array(general->param_count, sizeof *d->params);
    run->density_count++;
    if (drawn == NULL || d->params == NULL) return JLT_ERR_NOMEM;
    for (int draw = 0; draw == 0 || (draw < REDRAWS && is_outside(d)); draw++) {
        jlt_verify_draw_params(drawn, general, &run->random, draw == 0 ? kind : 1);
        memcpy(d->params, drawn, general->param_count * sizeof *drawn);
        if (descriptor->impose != NULL) descriptor->impose(zero, drawn, d->params);
        jlt_measure_clear(&d->attempt);
        d->status = attempt(run, d);
    }
    *(holds(d) ? &run->held : &run->failed) += 1;
    return d->status == JLT_ERR_NOMEM ? JLT_ERR_NOMEM : JLT_OK;
}

jlt_status jlt_verify_densities(jlt_verify_run *run)
{
    const jlt_descriptor *const *family = run->descriptor->family;
    size_t room = 0;
    jlt_status st = JLT_OK;

    if (run->descriptor->state_count > JLT_MEASURE_STATES_MAX) return JLT_OK;
    while (family[room] != NULL) room++;
    run->densities = calloc((room + 1) * DRAWS_OF_PARAMS, sizeof *run->densities);
    if (run->densities == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < room; i++) {
        const jlt_descriptor *d = family[i];
        if (d->time[0] != '\0' || d->elimination[0] != '\0' || d->measure_count > JLT_MEASURE_CLAIMS_MAX) continue;
        if (d != run->descriptor && d->measure_count == 0) continue;
        for (unsigned kind = 0; st == JLT_OK && kind < (d->measure_count > 0 ? DRAWS_OF_PARAMS : 1u); kind++)
            st = add(run, d, kind == 0 ? 0 : 1);
    }
    return st;
}
