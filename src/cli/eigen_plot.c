#include "cli/eigen.h"

/* Values that stay the same over the picture, for its caption. */
static void write_caption(FILE *stream, const jlt_eigen_request *r)
{
    const jlt_descriptor *d = r->question.descriptor;

    fprintf(stream, "set title \"Eigenvalues at equilibria of %s\\n", d->model);
    for (unsigned i = 0; i < d->param_count + d->state_count; i++) {
        const bool state = i >= d->param_count;
        const unsigned index = state ? i - d->param_count : i;
        bool swept = false;
        for (size_t k = 0; k < r->axis_count; k++)
            swept = swept || (r->targets[k].is_state == state && r->targets[k].index == index);
        if (swept || (state && r->axis_count > 0 && !r->question.given[index])) continue;
        fprintf(stream, " %s=%.6g", state ? d->states[index].name : d->params[index].name,
                state ? r->x[index] : r->params[index]);
    }
    fputs("\" noenhanced\n", stream);
}

static void write_script(FILE *stream, const jlt_eigen_request *r, const jlt_eigen_row *rows, size_t count)
{
    const jlt_eigen_target *axis = r->axis_count > 0 ? &r->targets[0] : NULL;
    bool zeros = false; /* whether integrals force any */

    fputs("$values << EOD\n", stream);
    for (size_t k = 0; k < count; k++) {
        const jlt_eigen_row *row = &rows[k];
        if (row->found.status != JLT_OK) continue;
        for (size_t i = 0; i < row->found.result.n; i++) {
            const jlt_eigenvalue *value = &row->found.result.eigen.values[i];
            const double colour = axis == NULL ? 0.0 : axis->is_state ? row->x[axis->index] : row->params[axis->index];
            if (value->source < 0) fprintf(stream, "%.17g %.17g %.17g\n", value->re, value->im, colour);
            else zeros = true;
        }
    }
    fputs("EOD\n", stream);
    write_caption(stream, r);
    fputs("set xlabel 'Re {/Symbol l} [1/s]'\nset ylabel 'Im {/Symbol l} [1/s]'\nset grid\nset zeroaxis lt -1\n"
          "set key inside top right\n",
          stream);
    if (axis == NULL) {
        fputs("plot $values using 1:2 with points pt 7 ps 1 title 'eigenvalues'", stream);
    } else {
        fprintf(stream, "set cblabel '%s' noenhanced\nset palette defined (0 '#2166ac', 1 '#bbbbbb', 2 '#b2182b')\n", r->axes[0].name);
        fputs("plot $values using 1:2:3 with points pt 7 ps 0.5 palette notitle", stream);
    }
    fputs(zeros ? ", '-' using 1:2 with points pt 2 ps 1.5 lc black title 'zero, by the integrals'\n0 0\ne\n" : "\n", stream);
}

jlt_exit jlt_eigen_draw(const jlt_eigen_request *request, const jlt_eigen_row *rows, size_t count)
{
    jlt_command_output script;

    if (jlt_command_open(&script) != JLT_OK) return jlt_command_no_memory();
    write_script(script.stream, request, rows, count);
    return jlt_common_draw(&request->common, &script);
}
