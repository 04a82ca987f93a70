#include "cli/simulate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PANELS_MAX = 4 };

/* Columns: t, states, drifts, and with --track the contact point and the axis seen from above. */
void jlt_simulate_point(jlt_simulate_request *request, const jlt_course_row *row)
{
    fprintf(request->points, "%.9g", row->t);
    for (unsigned i = 0; i < request->session.descriptor->state_count; i++) fprintf(request->points, " %.9g", row->x[i]);
    for (unsigned i = 0; i < jlt_course_integrals(request->courses[0]); i++)
        fprintf(request->points, " %.3g", fmax(row->drift[i], 1e-17));
    if (request->track)
        fprintf(request->points, " %.9g %.9g %.9g %.9g", row->attitude.contact[0], row->attitude.contact[1],
                row->attitude.axes[0][2], row->attitude.axes[1][2]);
    fputc('\n', request->points);
}

static void title(FILE *stream, const jlt_simulate_request *r)
{
    fprintf(stream, "\"%s: ", r->session.descriptor->model);
    jlt_session_caption(stream, &r->session);
    fputs("\\nstart ", stream);
    for (unsigned i = 0; i < r->session.descriptor->state_count; i++)
        fprintf(stream, "%s%s=%.6g", i == 0 ? "" : ", ", r->session.descriptor->states[i].name, r->session.x[i]);
    fprintf(stream, "; tier %s, tolerance %.3g\" noenhanced\n", jlt_plan_tier(&r->plans[0]), r->session.tolerance);
}

/* States of the same unit share a panel. */
static void draw_states(FILE *stream, const jlt_simulate_request *r)
{
    const jlt_descriptor *d = r->session.descriptor;
    const char *units[PANELS_MAX];
    const unsigned drifts = jlt_course_integrals(r->courses[0]);
    unsigned panels = 0;

    for (unsigned i = 0; i < d->state_count; i++) {
        unsigned k = 0;
        while (k < panels && strcmp(units[k], d->states[i].unit) != 0) k++;
        if (k == panels && panels < PANELS_MAX) units[panels++] = d->states[i].unit;
    }
    fprintf(stream, "set multiplot layout %u,1 title ", panels + (drifts > 0));
    title(stream, r);
    fputs("set key outside right center\nset lmargin 11\nset rmargin 19\nset ytics nomirror font ',10'\n", stream);
    for (unsigned k = 0; k < panels; k++) {
        if (k + 1 == panels && drifts == 0) fputs("set xlabel 't [s]'\n", stream);
        fprintf(stream, "set ylabel '[%s]' noenhanced\nplot", units[k][0] != '\0' ? units[k] : "1");
        for (unsigned i = 0; i < d->state_count; i++) {
            const bool here = strcmp(units[k], d->states[i].unit) == 0;
            if (here) fprintf(stream, " $ROWS using 1:%u with lines title '%s' noenhanced,", i + 2, d->states[i].name);
        }
        fputs("\n", stream);
    }
    if (drifts == 0) return;
    fputs("set xlabel 't [s]'\nset logscale y\nset format y '10^{%T}'\nset ylabel 'relative drift'\nplot", stream);
    for (unsigned i = 0; i < drifts; i++)
        fprintf(stream, " $ROWS using 1:%u with lines title '%s' noenhanced,", d->state_count + 2 + i,
                jlt_course_integral(r->courses[0], i));
    fputs("\n", stream);
}

static void draw_track(FILE *stream, const jlt_simulate_request *r)
{
    const unsigned first = r->session.descriptor->state_count + 2 + jlt_course_integrals(r->courses[0]);

    fputs("set multiplot layout 1,2 title ", stream);
    title(stream, r);
    fprintf(stream,
            "set size ratio -1\nset title 'track of the contact point'\nset xlabel 'x [m]'\nset ylabel 'y [m]'\n"
            "plot $ROWS using %u:%u with lines lc rgb '#202060' notitle, $ROWS using %u:%u every ::0::0 with points pt 7 "
            "lc rgb '#b2182b' title 'start'\n",
            first, first + 1, first, first + 1);
    fprintf(stream,
            "set title 'symmetry axis seen from above'\nset xlabel '(e_3, {/Symbol a})'\nset ylabel '(e_3, {/Symbol b})'\n"
            "set xrange [-1.05:1.05]\nset yrange [-1.05:1.05]\nset parametric\nset trange [0:2*pi]\n"
            "plot cos(t),sin(t) with lines lc rgb '#bbbbbb' notitle, $ROWS using %u:%u with lines lc rgb '#202060' notitle, "
            "$ROWS using %u:%u every ::0::0 with points pt 7 lc rgb '#b2182b' title 'start'\n",
            first + 2, first + 3, first + 2, first + 3);
}

jlt_exit jlt_simulate_draw(const jlt_simulate_request *request)
{
    jlt_command_output script;
    FILE *stream;

    if (jlt_command_open(&script) != JLT_OK) return jlt_command_no_memory();
    stream = script.stream;
    fputs("set encoding utf8\nset grid\n$ROWS << END\n", stream);
    fputs(request->points_text, stream);
    fputs("END\n", stream);
    if (request->track) draw_track(stream, request);
    else draw_states(stream, request);
    fputs("unset multiplot\n", stream);
    return jlt_common_draw(&request->session.common, &script);
}
