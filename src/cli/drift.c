#include "cli/drift.h"

#include <math.h>
#include <stdlib.h>

#include "report/csv.h"

static void write_row(const jlt_drift *self, const jlt_method *method, const jlt_drift_row *row, jlt_drift_row *rows, size_t *count)
{
    rows[(*count)++] = *row;
    fprintf(self->file, "%s,%zu,", method->name, row->returns);
    jlt_csv_value(self->file, row->t);
    fprintf(self->file, ",%zu", row->evaluations);
    double point[1 + JLT_INVARIANTS_MAX] = { (double)row->returns };
    for (unsigned k = 0; k < self->count; k++) {
        fprintf(self->file, ",%.3g", row->drift[k]);
        point[1 + k] = row->drift[k];
    }
    fputc('\n', self->file);
    if (self->points != NULL) jlt_look_row(self->points, point, 1 + self->count);
}

jlt_status jlt_drift_note(jlt_drift *self, const jlt_method *method, jlt_drift_row *row, jlt_drift_row *rows, size_t *count,
                          const double *first, const double *sizes, const double *now)
{
    for (unsigned k = 0; k < self->count; k++) {
        const unsigned i = self->watched[k];
        const double drift = fabs(now[i] - first[i]) / sizes[i];
        if (!isfinite(drift)) return JLT_ERR_NONFINITE;
        row->drift[k] = fmax(row->drift[k], drift);
    }
    if ((row->returns & (row->returns - 1)) == 0 || row->returns == self->returns) write_row(self, method, row, rows, count);
    jlt_progress_show(&self->progress, row->returns, self->returns);
    return JLT_OK;
}

void jlt_drift_end_row(const jlt_drift *self, const jlt_method *method, const jlt_drift_row *row, jlt_drift_row *rows, size_t *count,
                       const jlt_drift_end *end)
{
    const size_t written = *count > 0 ? rows[*count - 1].returns : 0;
    if (end->name[0] != '\0' && row->returns > written) write_row(self, method, row, rows, count);
}

/* |F|, or 1 where that is 0, or no more than rounding of the terms that make it. */
static void set_sizes(double *sizes, const jlt_drift *self, const double *first, const double *gradients, const double *x)
{
    static const double rounding = 1e-14; /* of some forty terms, half a unit in the last place each */
    const unsigned states = self->system->instance->descriptor->state_count;

    for (unsigned k = 0; k < self->count; k++) {
        const unsigned i = self->watched[k];
        double terms = 0;
        for (unsigned j = 0; j < states; j++) terms += fabs(gradients[i * states + j] * x[j]);
        sizes[i] = fabs(first[i]) > rounding * terms ? fabs(first[i]) : 1;
    }
}

jlt_status jlt_drift_section(jlt_drift *self, jlt_drift_row *rows, size_t *count, jlt_drift_end *end, const jlt_method *method)
{
    const jlt_descriptor *d = self->system->instance->descriptor;
    const jlt_kernel_function integrals = d->integral_values.call;
    const double *block = self->system->field.p;
    double *room = malloc(d->integral_count * (3 + (size_t)d->state_count) * sizeof *room);
    double *first = room, *now = room + d->integral_count, *sizes = room + 2 * d->integral_count;
    jlt_flow flow = self->system->flow;
    jlt_section *section = NULL;
    jlt_return at;
    jlt_drift_row row = { .returns = 0 };
    jlt_status st = JLT_OK;

    *count = 0;
    *end = (jlt_drift_end){ .t = 0 };
    flow.method = method;
    st = JLT_ERR_NOMEM;
    if (room == NULL) goto done;
    JLT_TRY(jlt_section_create(&section, &flow));
    JLT_TRY(jlt_section_start(section, &at, self->q, 1));
    integrals(at.x, block, first);
    d->integral_gradients.call(at.x, block, sizes + d->integral_count);
    set_sizes(sizes, self, first, sizes + d->integral_count, at.x);
    for (size_t i = 1, steps; i <= self->returns && !ferror(self->file); i++) {
        JLT_TRY(jlt_section_next(section, &at));
        if (at.interrupted) break;
        if (jlt_section_failed(at.fate)) {
            st = jlt_section_fate_status(at.fate);
            goto done;
        }
        if (at.fate != JLT_FATE_ALIVE) {
            jlt_section_fate_text(end->name, self->system->observed, at.fate, at.lost);
            end->t = at.t;
            end->returns = i - 1;
            break;
        }
        integrals(at.x, block, now);
        row.returns = i;
        row.t = at.t;
        jlt_section_cost(section, &steps, &row.evaluations);
        JLT_TRY(jlt_drift_note(self, method, &row, rows, count, first, sizes, now));
    }
    jlt_drift_end_row(self, method, &row, rows, count, end);
done:
    jlt_section_destroy(section);
    free(room);
    return st;
}
