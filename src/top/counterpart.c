#include "top/counterpart.h"

#include <stdio.h>
#include <string.h>

#include "kernel/descriptor.h"

static const jlt_descriptor *known_top(void) { return jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL); }

const char *jlt_counterpart_other_state(const jlt_descriptor *model)
{
    const jlt_descriptor *known = known_top();
    size_t index;

    for (unsigned i = 0; known != NULL && i < JLT_TOP_STATES; i++)
        if (!jlt_descriptor_state(model, known->states[i].name, &index)) return known->states[i].name;
    for (unsigned i = 0; known != NULL && i < model->state_count; i++)
        if (!jlt_descriptor_state(known, model->states[i].name, &index)) return model->states[i].name;
    return NULL;
}

const jlt_claim *jlt_counterpart_unproved(const jlt_descriptor *model, const char *shared)
{
    const jlt_descriptor *table = jlt_descriptor_find(shared, NULL, NULL, NULL);

    for (const jlt_claim *claim = model->claims; claim->kind != NULL; claim++) {
        const bool is_read = claim->target != NULL;
        if (strcmp(claim->kind, "reduction") != 0 || claim->verdict == JLT_PROVED) continue;
        const jlt_descriptor *to = is_read ? jlt_way_target(&(jlt_way){ .sha256 = claim->target }, NULL) : NULL;
        if (to == NULL || to == table) return claim;
    }
    return NULL;
}

jlt_status jlt_counterpart_open(jlt_counterpart *out, const jlt_claim **broken, const jlt_descriptor *model, const char *shared,
                                const double *params, const double *x)
{
    const jlt_descriptor *known = known_top(), *table = jlt_descriptor_find(shared, NULL, NULL, NULL);
    jlt_counterpart found = { .way = NULL };
    double other[JLT_WAY_VALUES_MAX];

    *broken = NULL;
    if (known == NULL || table == NULL || jlt_top_way(shared) == NULL || jlt_counterpart_other_state(model) != NULL)
        return JLT_ERR_UNSUPPORTED;
    for (unsigned i = 0; i < JLT_TOP_STATES; i++) (void)jlt_descriptor_state(model, known->states[i].name, &found.place[i]);
    if (model->family != known->family) {
        found.way = jlt_way_to(broken, model, table, x, params);
        if (found.way == NULL || found.way->param_count > JLT_WAY_VALUES_MAX) return JLT_ERR_UNSUPPORTED;
        jlt_way_params(found.way, other, x, params);
        model = table;
        params = other;
    }
    const jlt_status st = jlt_top_read(&found.top, model, params);
    if (st == JLT_OK) *out = found;
    return st;
}

void jlt_counterpart_look(const jlt_counterpart *self, double *of_top, const double *x)
{
    for (unsigned i = 0; i < JLT_TOP_STATES; i++) of_top[i] = x[self->place[i]];
}

void jlt_counterpart_return(const jlt_counterpart *self, double *x, const double *of_top)
{
    for (unsigned i = 0; i < JLT_TOP_STATES; i++) x[self->place[i]] = of_top[i];
}

const jlt_way_condition *jlt_counterpart_condition(const jlt_descriptor *model, const char *shared, const double *params)
{
    const jlt_descriptor *table = jlt_descriptor_find(shared, NULL, NULL, NULL);
    const jlt_way_condition *broken = NULL;

    for (unsigned i = 0; table != NULL && broken == NULL && i < model->way_count; i++)
        if (strcmp(model->ways[i].sha256, table->sha256) == 0) broken = jlt_way_broken(&model->ways[i], NULL, params);
    return broken;
}

void jlt_counterpart_record(char *text, size_t size, const char *shared)
{
    const jlt_descriptor *table = jlt_descriptor_find(shared, NULL, NULL, NULL);
    int used = snprintf(text, size, "reduction NAME : by %s.tt with", shared);

    for (unsigned i = 0; table != NULL && i < table->state_count && used > 0 && (size_t)used < size; i++)
        used += snprintf(text + used, size - (size_t)used, "%s %s = ...", i > 0 ? "," : "", table->states[i].name);
}
