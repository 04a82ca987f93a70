/* Invariant densities: proof of div(rho f) = 0, and a note on where rho is positive and smooth. */
#include "prove/domain.h"
#include "prove/signs.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct {
    FILE *stream;
    bool only_positive; /* zeros, poles and negative values are excluded so far */
} description;

/* Add `what` to the description unless an expression stands in this relation to zero at every point of the leaf. */
static void describe(ttc_task *task, description *d, ttc_id id, ttc_relation relation, const char *what)
{
    char *point = NULL;
    ttc_ratio value;
    if (ttc_signs_tell(task, task->field, id, relation)) return;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, id);
    if (relation == TTC_IS_NONNEGATIVE) ttc_ratio_scale(task->ring, &value, &value, task->ring->minus_one);
    ttc_search_result result =
        ttc_task_search(task, &value, relation == TTC_IS_NONNEGATIVE ? TTC_IS_POSITIVE : TTC_IS_ZERO, &point);
    if (result == TTC_POINT_NOT_DECIDED && relation == TTC_IS_NONZERO && (point = ttc_task_zero_of(task, &value)) != NULL)
        result = TTC_POINT_FOUND;
    if (result == TTC_POINT_FOUND || result == TTC_POINT_NOT_DECIDED) {
        if (!d->only_positive) fputs("; ", d->stream);
        d->only_positive = false;
        fprintf(d->stream, "%s%s", result == TTC_POINT_FOUND ? "" : "not excluded: ", what);
        if (point != NULL) fprintf(d->stream, " at %s", point);
    }
    free(point);
    ttc_ratio_clear(task->ring, &value);
}

/* Describe poles: points where the field is defined, and the density, or a definition that it alone uses, divides by zero. */
static void describe_poles(ttc_task *task, description *d)
{
    const ttc_model *model = task->model;
    unsigned char *of_claim = ttc_domain_divisors_of_claim(task);
    ttc_conditions whole = task->domain;
    if (of_claim == NULL) {
        ttc_task_unsettle(task, "out of memory");
        return;
    }
    ttc_conditions_init(&task->domain, task->field);
    ttc_domain_add(task, &task->domain, TTC_DOMAIN_WITHOUT_CLAIM);
    for (size_t i = 0; i < model->divisor_count; i++)
        if (of_claim[i] && ttc_task_open(task)) describe(task, d, model->divisors[i].divisor, TTC_IS_NONZERO, "a pole");
    ttc_conditions_clear(&task->domain);
    task->domain = whole;
    free(of_claim);
}

/* Say so unless the density is the same where an angle of the table has grown by its period. */
static void describe_turns(ttc_task *task, description *d)
{
    if (ttc_prove_turns(task->model, task->claim->expression, &task->claim->when)) return;
    if (!d->only_positive) fputs("; ", d->stream);
    d->only_positive = false;
    fputs("not shown to be the same a period on", d->stream);
}

static void describe_density(ttc_task *task)
{
    size_t size = 0;
    char *text = NULL;
    description d = { open_memstream(&text, &size), true };
    if (d.stream == NULL) {
        ttc_task_unsettle(task, "out of memory");
        return;
    }
    describe_poles(task, &d);
    describe(task, &d, task->claim->expression, TTC_IS_NONNEGATIVE, "negative");
    describe(task, &d, task->claim->expression, TTC_IS_NONZERO, "zero");
    describe_turns(task, &d);
    if (d.only_positive) fputs("positive and smooth on the domain", d.stream);
    bool is_first = task->note == NULL, is_worse = !is_first && task->has_smooth_density && !d.only_positive;
    if (fclose(d.stream) != 0 || !(is_first || is_worse)) {
        free(text);
        return;
    }
    /* The note is that of the first leaf on which the density is not positive and smooth, if there is one. */
    free(task->note);
    task->note = text;
    task->has_smooth_density = d.only_positive;
}

/* The density is zero on the whole leaf: on all of the domain, or, where the sign of a root was chosen, on a part of it. */
static void say_where_zero(ttc_task *task)
{
    char *point = NULL;
    const ttc_search_result result = ttc_task_search(task, NULL, TTC_IS_ZERO, &point);
    const bool of_part = task->ring->choice_count > 0, has_point = of_part && point != NULL;
    if (result == TTC_POINT_FOUND || result == TTC_POINT_NOT_DECIDED)
        ttc_task_unsettle(task, "the density %s is zero%s%s%s", task->claim->name, of_part ? " on a whole part of the domain" : "",
                          has_point ? ", as at " : "", has_point ? point : "");
    free(point);
}

/* div(rho f) = grad(rho) . f + rho div f */
static ttc_id divergence_of(const ttc_model *model, ttc_id density)
{
    ttc_id trace = ttc_integer(model->graph, 0);
    for (size_t i = 0; i < model->state_count; i++)
        trace = ttc_add(model->graph, trace, ttc_derive_state(model, ttc_model_field(model, i), i));
    return ttc_add(model->graph, ttc_derive_field(model, density), ttc_multiply(model->graph, density, trace));
}

void ttc_prove_measure(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    ttc_ratio density;
    char what[160];
    if (ttc_task_restricts_states(task) || task->claim->modulo_count > 0) {
        ttc_task_unsettle(task, "a density needs an open set of states");
        return;
    }
    ttc_ratio_init(task->ring, &density);
    ttc_evaluate(task->field, &density, claim->expression);
    if (ttc_task_open(task) && ttc_ratio_is_zero(task->ring, &density)) say_where_zero(task);
    ttc_ratio_clear(task->ring, &density);
    snprintf(what, sizeof what, "div(%s f)", claim->name);
    ttc_task_require_identity(task, divergence_of(task->model, claim->expression), ttc_integer(task->model->graph, 0), what);
    if (ttc_task_open(task)) describe_density(task);
}
