#include "cli/eigen.h"
#include "cli/interrupt.h"

#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 1000000 };

jlt_exit jlt_eigen_parse_sweep(jlt_eigen_request *request, const char *text)
{
    jlt_exit code = jlt_grid_parse(request->axes, &request->axis_count, JLT_EIGEN_AXES_MAX, text, "--sweep");

    if (code == JLT_EXIT_DONE) code = jlt_grid_size(&request->points, request->axes, request->axis_count, text, "--sweep");
    if (code == JLT_EXIT_DONE && request->points > POINTS_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "--sweep: the grid has %zu points; %d at most", request->points, POINTS_MAX);
    return code;
}

/* Row `k` of the grid, the last axis fastest; its parameters and states are copies that it owns. */
static jlt_status compute_row(jlt_eigen_row *row, const jlt_eigen_request *r, size_t k)
{
    const jlt_descriptor *d = r->question.descriptor;
    double values[JLT_EIGEN_AXES_MAX];

    row->descriptor = d;
    row->params = malloc((d->param_count + 1) * sizeof *row->params);
    row->x = malloc(d->state_count * sizeof *row->x);
    if (row->params == NULL || row->x == NULL) return JLT_ERR_NOMEM;
    memcpy(row->params, r->params, d->param_count * sizeof *row->params);
    memcpy(row->x, r->x, d->state_count * sizeof *row->x);
    jlt_grid_point(values, r->axes, r->axis_count, k);
    for (size_t i = 0; i < r->axis_count; i++) (r->targets[i].is_state ? row->x : row->params)[r->targets[i].index] = values[i];
    jlt_equilibrium_compute(&row->found, &r->question, row->params, row->x);
    return JLT_OK;
}

jlt_exit jlt_eigen_sweep(const jlt_eigen_request *request)
{
    jlt_command_output output = { 0 };
    const volatile sig_atomic_t *const interrupt = jlt_interrupt_install();
    size_t count, computed = 0, refused = 0;
    jlt_eigen_row *rows;
    const jlt_eigen_row *first = NULL;
    char reason[JLT_EIGEN_REASON_MAX];
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st;

    count = request->points;
    rows = calloc(count, sizeof *rows);
    st = rows != NULL ? JLT_OK : JLT_ERR_NOMEM;
    for (; st == JLT_OK && computed < count && !*interrupt; computed++) st = compute_row(&rows[computed], request, computed);
    if (st == JLT_OK && computed < count) {
        code = jlt_command_fail(JLT_EXIT_NUMERICAL, "interrupted; nothing is saved, as only %zu of %zu rows are there", computed, count);
        goto done;
    }
    for (size_t k = 0; st == JLT_OK && k < count; k++)
        if (rows[k].found.status != JLT_OK && refused++ == 0) first = &rows[k];
    if (st == JLT_OK) st = jlt_command_open(&output);
    if (st == JLT_OK && request->json) st = jlt_eigen_write_json(output.stream, rows, count, true);
    else if (st == JLT_OK) jlt_eigen_write_csv(output.stream, request, rows, count);
    if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "%s", jlt_status_text(st));
    if (code == JLT_EXIT_DONE) code = jlt_stream_deliver(&output, request->common.output);
    if (code == JLT_EXIT_DONE && request->common.plot != NULL) code = jlt_eigen_draw(request, rows, count);
    if (code == JLT_EXIT_DONE && first != NULL) {
        jlt_eigen_reason(reason, first);
        code = jlt_command_fail(jlt_command_exit(first->found.status), "%zu of %zu points refused; the first: %s", refused,
                                count, reason);
    }
done:
    jlt_command_discard(&output);
    for (size_t k = 0; k < computed; k++) {
        free(rows[k].params);
        free(rows[k].x);
    }
    free(rows);
    return code;
}
