#include "dynamics/section_flows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"

jlt_status jlt_section_flows_section(jlt_section_flows *self, jlt_section **section, unsigned thread, size_t flow)
{
    jlt_section_flows_thread *own = &self->own[thread];
    jlt_status st = JLT_OK;

    if (own->section == NULL || own->flow != flow) {
        jlt_section_destroy(own->section);
        st = jlt_section_create(&own->section, &self->all[flow].flow);
        own->flow = flow;
    }
    *section = own->section;
    return st;
}

static jlt_status append(jlt_section_flows *self, const jlt_flow *flow, const jlt_instance *project)
{
    if (!JLT_MEMORY_GROW(self->all, self->count)) return JLT_ERR_NOMEM;
    self->all[self->count++] = (jlt_section_flows_entry){ .flow = *flow, .project = project };
    return JLT_OK;
}

jlt_status jlt_section_flows_open(jlt_section_flows *out, const jlt_flow *flow, const jlt_instance *project, unsigned threads)
{
    jlt_section *section;
    jlt_status st = JLT_ERR_NOMEM;

    *out = (jlt_section_flows){ .own = calloc(threads, sizeof *out->own), .threads = threads };
    if (out->own == NULL) goto done;
    JLT_TRY(append(out, flow, project));
    for (unsigned i = 0; i < threads; i++) JLT_TRY(jlt_section_flows_section(out, &section, i, 0));
done:
    if (st != JLT_OK) jlt_section_flows_clear(out);
    return st;
}

void jlt_section_flows_clear(jlt_section_flows *self)
{
    for (unsigned i = 0; self->own != NULL && i < self->threads; i++) jlt_section_destroy(self->own[i].section);
    free(self->own);
    free(self->all);
    *self = (jlt_section_flows){ .all = NULL };
}

bool jlt_section_flows_owns(const jlt_flow *flow, const jlt_kernel_batch *kernels)
{
    const jlt_kernel_batch *own = flow->field->batch;

    if (kernels == NULL || own == NULL || kernels == own) return true;
    return kernels->lanes != own->lanes && kernels->prepared == own->prepared; /* a field has one for each number of lanes */
}

const char *jlt_section_flows_obstacle(const jlt_flow *flow, const jlt_kernel_batch *kernels)
{
    const unsigned conditions = jlt_observed_conditions(flow->observed);

    if (kernels == NULL) return "there are no kernels on vectors";
    if (flow->chart->states > JLT_BATCH_STATES_MAX) return "there are more states than lanes take";
    if (flow->t_max != 0) return "returns have an end in time";
    if (conditions > JLT_BATCH_CONDITIONS_MAX || flow->field->domain.conditions > JLT_BATCH_CONDITIONS_MAX)
        return "there are more conditions than lanes watch";
    if (conditions > 0 && jlt_section_flows_watching(flow, kernels) == NULL) return "its conditions have no kernels on vectors";
    return NULL;
}

const jlt_kernel_batch *jlt_section_flows_watching(const jlt_flow *flow, const jlt_kernel_batch *kernels)
{
    const double *p;
    const int *exponents;

    return jlt_observed_lanes(flow->observed, &p, &exponents, kernels->lanes);
}

/* Whether two domains have the same intervals, which lanes take from the first flow. */
static bool have_same_intervals(const jlt_domain *a, const jlt_domain *b)
{
    if (a->intervals == NULL || b->intervals == NULL) return a->intervals == b->intervals;
    for (unsigned i = 0; i < a->states; i++)
        if (!(a->intervals[i].low == b->intervals[i].low && a->intervals[i].high == b->intervals[i].high)) return false;
    return true;
}

bool jlt_section_flows_fit(const jlt_flow *first, const jlt_flow *flow)
{
    const jlt_chart *a = first->chart, *b = flow->chart;
    const jlt_field *f, *g;

    if (b == NULL || flow->field == NULL) return false;
    f = first->field;
    g = flow->field;
    return a->dim == b->dim && a->states == b->states && a->column == b->column && a->turn == b->turn && f->call == g->call
           && f->dim == g->dim && f->root == g->root && memcmp(&f->kept, &g->kept, sizeof f->kept) == 0
           && memcmp(&f->angles, &g->angles, sizeof f->angles) == 0 && memcmp(&f->groups, &g->groups, sizeof f->groups) == 0
           && jlt_field_watches(f) == jlt_field_watches(g)
           && f->domain.conditions == g->domain.conditions && have_same_intervals(&f->domain, &g->domain)
           && first->method == flow->method && first->tolerance == flow->tolerance && first->direction == flow->direction
           && first->max_steps == flow->max_steps && first->kept.count == flow->kept.count && first->t_max == flow->t_max
           && first->interrupt == flow->interrupt && first->end_where_invalid == flow->end_where_invalid
           && jlt_observed_conditions(first->observed) == jlt_observed_conditions(flow->observed);
}

jlt_status jlt_section_flows_add(jlt_section_flows *self, const jlt_flow *flow, const jlt_instance *project)
{
    const jlt_section_flows_entry *first = &self->all[0];

    if (!jlt_section_flows_fit(&first->flow, flow) || (first->project == NULL) != (project == NULL)) return JLT_ERR_ARG;
    return append(self, flow, project);
}

/* Set the prepared values of the flow's conditions, and the factors that convert states of lanes for them. */
static void set_watched(jlt_batch_case *out, jlt_section_flows_entry *entry, unsigned lanes)
{
    const int *exponents;

    if (jlt_observed_lanes(entry->flow.observed, &out->watched, &exponents, lanes) == NULL || exponents == NULL) return;
    for (unsigned i = 0; i < entry->flow.chart->states; i++) entry->unit[i] = ldexp(1, exponents[i]);
    out->unit = entry->unit;
}

jlt_batch_case *jlt_section_flows_cases(jlt_section_flows *self, const jlt_kernel_batch *kernels, bool watches)
{
    jlt_batch_case *cases = calloc(self->count, sizeof *cases);

    for (size_t i = 0; cases != NULL && i < self->count; i++) {
        jlt_section_flows_entry *entry = &self->all[i];
        cases[i] = (jlt_batch_case){ .p = entry->flow.field->p, .level = entry->flow.chart->level,
                                     .params = entry->project != NULL ? entry->project->counted : NULL };
        if (watches) set_watched(&cases[i], entry, kernels->lanes);
    }
    return cases;
}
