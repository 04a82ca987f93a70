/* Draws the eigenvalues of one equilibrium, or of a sweep, for `jellett eigen`. */
#include "cli/eigen.h"
#include "cli/plot.h"

/* Write the values that are constant over the picture into its caption. */
static void write_caption(jlt_plot *plot, const jlt_eigen_request *r)
{
    const jlt_descriptor *d = r->question.descriptor;

    jlt_plot_words(plot, "Eigenvalues at equilibria of %s\n", d->model);
    for (unsigned i = 0; i < d->param_count + d->state_count; i++) {
        const bool state = i >= d->param_count;
        const unsigned index = state ? i - d->param_count : i;
        bool swept = false;
        for (size_t k = 0; k < r->axis_count; k++)
            swept = swept || (r->targets[k].is_state == state && r->targets[k].index == index);
        if (swept || (state && r->axis_count > 0 && !r->question.given[index])) continue;
        jlt_plot_value(plot, state ? d->states[index].name : d->params[index].name, state ? r->x[index] : r->params[index]);
    }
}

static void write_script(jlt_plot *plot, const jlt_eigen_request *r, jlt_eigen_rows rows)
{
    const jlt_eigen_target *axis = r->axis_count > 0 ? &r->targets[0] : NULL;
    FILE *stream = plot->stream;
    char label[JLT_LOOK_LABEL_MAX];
    jlt_extent re = JLT_EXTENT_NONE, im = JLT_EXTENT_NONE;
    bool zeros = false; /* whether integrals force any */

    fputs("$VALUES << END\n", stream);
    for (size_t k = 0; k < rows.count; k++) {
        const jlt_eigen_row *row = jlt_eigen_row_at(rows, k);
        if (row->found.status != JLT_OK) continue;
        for (size_t i = 0; i < row->found.result.n; i++) {
            const jlt_eigenvalue *value = &row->found.result.eigen.values[i];
            const double at = axis == NULL ? 0.0 : axis->is_state ? row->x[axis->index] : row->params[axis->index];
            jlt_extent_add(&re, value->source < 0 ? value->re : 0);
            jlt_extent_add(&im, value->source < 0 ? value->im : 0);
            if (value->source < 0) jlt_look_row(stream, (const double[]){ value->re, value->im, at }, 3);
            else zeros = true;
        }
    }
    fputs("END\n", stream);
    write_caption(plot, r);
    if (axis != NULL) {
        jlt_plot_label(label, r->question.descriptor, r->axes[0].name);
        jlt_plot_palette(plot, label,
                         (jlt_extent){ fmin(r->axes[0].low, r->axes[0].high), fmax(r->axes[0].low, r->axes[0].high) });
    }
    jlt_plot_axis(plot, 'x', jlt_plot_timed(r->question.descriptor, "Re λ [1/s]", "Re λ"), jlt_extent_wider(re), 0);
    jlt_plot_axis(plot, 'y', jlt_plot_timed(r->question.descriptor, "Im λ [1/s]", "Im λ"), jlt_extent_wider(im), 0);
    fputs(JLT_LOOK_GRID "set zeroaxis lt -1\n", stream);
    if (axis == NULL) {
        fputs("plot $VALUES using 1:2 ", stream);
        jlt_look_pen(stream, plot->look, (jlt_pen){ "points", .colour = 2, .size = 1 });
        fputs(" title 'eigenvalues'", stream);
    } else {
        fprintf(stream, "plot $VALUES using 1:2:3 with points pt 7 ps %.3g lc palette notitle", 0.5 * plot->look->size);
    }
    if (zeros) {
        fputs(", '+' using (0):(0) every ::0::0 ", stream);
        jlt_look_pen(stream, plot->look, (jlt_pen){ "points", .mark = 7, .size = 1.5 });
        fputs(" title 'zero, by the integrals'", stream);
    }
    fputc('\n', stream);
}

jlt_exit jlt_eigen_draw(const jlt_eigen_request *request, jlt_eigen_rows rows)
{
    jlt_plot plot;

    if (jlt_plot_open(&plot, &request->common) != JLT_OK) return jlt_command_no_memory();
    write_script(&plot, request, rows);
    return jlt_plot_draw(&plot);
}
