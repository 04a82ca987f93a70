/* What `jellett simulate` says on standard error once its rows are written. */
#include "cli/simulate.h"

#include "kernel/descriptor.h"

#include <math.h>
#include <string.h>

/* Print at which pole the orbit ended, and the limits of the states there. */
static void tell_pole(const jlt_simulate_request *r)
{
    const jlt_descriptor *d = r->session.descriptor;
    const jlt_course_row *row = &r->last;
    const char *untold[JLT_PLAN_STATES_MAX], *first = "";
    unsigned count = 0;

    if (row->fate == JLT_FATE_LEFT_DOMAIN) {
        fprintf(stderr, "jellett: at t = %.17g the orbit ends at a pole of the tier; %s names none (record 'pole'); of %zu times "
                        "%zu lie before it\n", row->t, d->model, r->times.count, r->rows - 1);
        return;
    }
    fprintf(stderr, "jellett: the orbit reaches the pole %s = %+.10g at t = %.17g and ends there, with the limits ",
            d->states[row->pole].name, row->x[row->pole], row->t);
    for (unsigned i = 0; i < d->state_count; i++) {
        if (i == row->pole) continue;
        if (!isfinite(row->x[i])) untold[count++] = d->states[i].name;
        if (!isfinite(row->x[i])) continue;
        fprintf(stderr, "%s%s = %.10g", first, d->states[i].name, row->x[i]);
        first = ", ";
    }
    for (unsigned i = 0; i < count; i++)
        fprintf(stderr, "%s%s%s", i == 0 ? " (there the tier does not tell " : ", ", untold[i], i + 1 == count ? ")" : "");
    fprintf(stderr, "; of %zu times %zu lie before it\n", r->times.count, r->rows - 1);
}

/* Name the proved integrals whose drifts have no column. */
static void tell_untracked(const jlt_descriptor *d)
{
    for (const jlt_claim *claim = d->claims; claim->kind != NULL; claim++) {
        if (strcmp(claim->kind, "integral") != 0 || claim->verdict != JLT_PROVED) continue;
        if (jlt_descriptor_follows(d, claim->name)) continue;
        fprintf(stderr, "jellett: %s is an integral ", claim->name);
        if (claim->condition[0] == '\0')
            fputs("on zero levels of other claims alone ('modulo'); its drift has no column\n", stderr);
        else fprintf(stderr, "where %s; its drift has a column there once a 'variant' sets this, unless it holds on zero levels "
                             "of other claims alone ('modulo')\n", claim->condition);
    }
}

/* Name the integrals that come out as no number where the states are numbers. */
static void tell_unvalued(const jlt_simulate_request *r)
{
    const jlt_course_row *row = &r->last;

    if (row->x == NULL) return; /* there is no row */
    for (unsigned i = 0; i < r->session.descriptor->state_count; i++)
        if (!isfinite(row->x[i])) return;
    for (unsigned i = 0; i < jlt_course_integrals(r->courses[0]); i++)
        if (isnan(row->drift[i]))
            fprintf(stderr, "jellett: %s has no value by t = %.10g (it is not a number): its drift is empty\n",
                    jlt_course_integral(r->courses[0], i), row->t);
}

void jlt_simulate_closing_words(const jlt_simulate_request *r)
{
    const jlt_course_row *row = &r->last;

    if (jlt_session_interrupted(&r->session))
        fprintf(stderr, "jellett: interrupted; %zu whole rows of %zu are saved in %s\n", r->rows, r->times.count,
                r->session.common.table.path);
    else if (row->end == JLT_END_POLE) tell_pole(r);
    for (unsigned i = 0; i < jlt_course_changes(r->courses[0]); i++) {
        const char *from, *to, *why;
        double t;
        jlt_course_change(r->courses[0], i, &t, &from, &to, &why);
        fprintf(stderr, "jellett: from t = %.10g on the tier %s in place of %s: %s\n", t, to, from, why);
    }
    if (!isnan(row->lost_at)) {
        fprintf(stderr, "jellett: %s is lost at t = %.10g", row->lost, row->lost_at);
        if (r->session.descriptor->family[0]->valid_count == 1) fprintf(stderr, " (least value %.6g)", row->least);
        fputs(": from there on the model does not hold\n", stderr);
    }
    if (row->unwatched)
        fprintf(stderr, "jellett: beside the quadratures the orbit could not be followed beyond t = %.10g: whether %s holds from "
                        "there on is not known\n", row->unknown_at, row->unknown);
    else if (row->unknown != NULL)
        fprintf(stderr, "jellett: %s has no value by t = %.10g (it is not a number): whether the model holds there is not known\n",
                row->unknown, row->unknown_at);
    tell_unvalued(r);
    tell_untracked(r->session.descriptor);
}
