#include "scene/course_more.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "kernel/units.h"

static const jlt_quantity *find(const jlt_quantity *quantities, unsigned count, const char *name)
{
    for (unsigned i = 0; i < count; i++)
        if (strcmp(quantities[i].name, name) == 0) return &quantities[i];
    return NULL;
}

/* The number of the table's own states, without the roots that a time lifts. */
static unsigned own_states(const jlt_descriptor *of)
{
    const jlt_descriptor *plain = jlt_descriptor_sibling(of, NULL, NULL, NULL);

    return plain != NULL ? plain->state_count : of->state_count;
}

bool jlt_course_more_is_told(const jlt_descriptor *table, const jlt_descriptor *asked)
{
    if (table != NULL && own_states(table) > own_states(asked)) return true;
    for (unsigned i = 0; table != NULL && i < table->observe_count; i++)
        if (find(asked->observes, asked->observe_count, table->observes[i].name) == NULL) return true;
    return false;
}

/* Append the quantities of `from` that are not in `but`. */
static void collect(jlt_course_more *self, const jlt_quantity *from, unsigned count, const jlt_quantity *but, unsigned but_count)
{
    for (unsigned i = 0; i < count; i++)
        if (find(but, but_count, from[i].name) == NULL) self->quantities[self->count++] = from[i];
}

static jlt_status choose(jlt_course_more *self, const jlt_descriptor *of, const jlt_descriptor *asked)
{
    self->quantities = calloc(of->state_count + of->observe_count + 1, sizeof *self->quantities);
    self->values = calloc(of->state_count + of->observe_count + 1, sizeof *self->values);
    if (self->quantities == NULL || self->values == NULL) return JLT_ERR_NOMEM;
    collect(self, of->states, own_states(of), asked->states, asked->state_count);
    self->states = self->count;
    collect(self, of->observes, of->observe_count, asked->observes, asked->observe_count);
    return JLT_OK;
}

jlt_status jlt_course_more_follow(jlt_course_more *self, const jlt_leg *leg, const jlt_descriptor *asked,
                                  const jlt_units *units)
{
    const jlt_descriptor *of = leg->view.instance->descriptor;
    double params[JLT_WAY_VALUES_MAX];
    JLT_OWNED(jlt_observed) *observed = NULL;

    if (self->quantities != NULL) {
        jlt_observed_destroy(self->observed);
        self->observed = NULL;
        return JLT_OK;
    }
    jlt_units_restore(params, leg->view.instance->counted, of->params, of->param_count, units);
    JLT_PASS(jlt_observed_create(&observed, of, params, units));
    self->seen = calloc(jlt_observed_count(observed) + 1, sizeof *self->seen);
    if (self->seen == NULL) return JLT_ERR_NOMEM;
    self->observed = observed;
    observed = NULL; /* ownership moved to self */
    self->units = units;
    return choose(self, jlt_descriptor_sibling(of, NULL, of->time, NULL), asked);
}

void jlt_course_more_close(jlt_course_more *self)
{
    jlt_observed_destroy(self->observed);
    free(self->quantities);
    free(self->values);
    free(self->seen);
    *self = (jlt_course_more){ 0 };
}

void jlt_course_more_fill(jlt_course_more *self, const jlt_leg *leg)
{
    const jlt_descriptor *of = leg->view.instance->descriptor;

    for (unsigned i = 0; i < self->count; i++) self->values[i] = NAN;
    if (self->observed == NULL) return;
    const jlt_quantity *told = jlt_observed_quantities(self->observed);
    jlt_observed_values(self->observed, self->seen, leg->y);
    for (unsigned i = 0; i < self->count; i++) {
        const jlt_quantity *state = find(of->states, of->state_count, self->quantities[i].name);
        const jlt_quantity *quantity = find(told, jlt_observed_count(self->observed), self->quantities[i].name);
        if (state != NULL) jlt_units_restore(&self->values[i], &leg->y[state - of->states], state, 1, self->units);
        else if (quantity != NULL) self->values[i] = self->seen[quantity - told];
    }
}
