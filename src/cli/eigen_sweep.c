#include "cli/eigen.h"

#include "ext/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 1000000 };

static jlt_exit refuse(const char *text, size_t length)
{
    return jlt_command_fail(JLT_EXIT_USAGE, "--sweep: '%.*s' is no range (write NAME=FROM:TO:COUNT, COUNT from 1 to %d)",
                            (int)length, text, POINTS_MAX);
}

static jlt_exit parse_axis(jlt_eigen_axis *axis, const char *text, size_t length)
{
    const char *const end = text + length, *equals = memchr(text, '=', length), *first, *second;
    double count;

    if (equals == NULL || equals == text) return refuse(text, length);
    first = memchr(equals, ':', (size_t)(end - equals));
    second = first == NULL ? NULL : memchr(first + 1, ':', (size_t)(end - first - 1));
    if (second == NULL) return refuse(text, length);
    if (jlt_number_parse(&axis->from, equals + 1, (size_t)(first - equals - 1)) != JLT_OK ||
        jlt_number_parse(&axis->to, first + 1, (size_t)(second - first - 1)) != JLT_OK ||
        jlt_number_parse(&count, second + 1, (size_t)(end - second - 1)) != JLT_OK || !(count >= 1.0) ||
        count > POINTS_MAX || count != floor(count))
        return refuse(text, length);
    axis->count = (size_t)count;
    axis->name = strndup(text, (size_t)(equals - text));
    return axis->name == NULL ? jlt_command_no_memory() : JLT_EXIT_DONE;
}

jlt_exit jlt_eigen_parse_sweep(jlt_eigen_request *request, const char *text)
{
    double points = 1.0;

    while (*text != '\0') {
        const size_t length = strcspn(text, ",");
        jlt_eigen_axis *axes = realloc(request->axes, (request->axis_count + 1) * sizeof *axes);
        jlt_exit code;
        if (axes == NULL) return jlt_command_no_memory();
        request->axes = axes;
        axes[request->axis_count] = (jlt_eigen_axis){ 0 };
        code = parse_axis(&axes[request->axis_count], text, length);
        if (code != JLT_EXIT_DONE) return code;
        request->axis_count++;
        text += length;
        if (*text == ',') text++;
    }
    for (size_t i = 0; i < request->axis_count; i++) points *= (double)request->axes[i].count;
    if (points > POINTS_MAX)
        return jlt_command_fail(JLT_EXIT_USAGE, "--sweep: the grid has %.0f points; %d at most", points, POINTS_MAX);
    return JLT_EXIT_DONE;
}

static double point_of(const jlt_eigen_axis *axis, size_t k)
{
    const double part = axis->count == 1 ? 0.0 : (double)k / (double)(axis->count - 1);
    return axis->from * (1.0 - part) + axis->to * part;
}

/* Row `k` of the grid, the last axis fastest; its parameters and states are copies that it owns. */
static jlt_status compute_row(jlt_eigen_row *row, const jlt_eigen_request *r, size_t k)
{
    const jlt_descriptor *d = r->descriptor;
    double *params = malloc((d->param_count + 1) * sizeof *params), *x = malloc(d->state_count * sizeof *x);
    unsigned char given[JLT_LINEARIZATION_SIZE_MAX];

    row->params = params;
    row->x = x;
    if (params == NULL || x == NULL) return JLT_ERR_NOMEM;
    memcpy(params, r->params, d->param_count * sizeof *params);
    memcpy(x, r->x, d->state_count * sizeof *x);
    memcpy(given, r->given, sizeof given);
    for (size_t i = r->axis_count; i-- > 0;) {
        const jlt_eigen_axis *axis = &r->axes[i];
        const double value = point_of(axis, k % axis->count);
        k /= axis->count;
        if (axis->is_state) {
            x[axis->index] = value;
            given[axis->index] = 1;
        } else {
            params[axis->index] = value;
        }
    }
    jlt_eigen_compute(row, r, params, x, given);
    return JLT_OK;
}

static jlt_status write_rows(jlt_command_output *output, const jlt_eigen_request *r, const jlt_eigen_row *rows, size_t count)
{
    if (r->json) return jlt_eigen_write_json(output->stream, rows, count, true);
    jlt_eigen_write_csv_header(output->stream, r);
    for (size_t k = 0; k < count; k++) jlt_eigen_write_csv_row(output->stream, &rows[k]);
    return JLT_OK;
}

jlt_exit jlt_eigen_sweep(const jlt_eigen_request *request)
{
    jlt_command_output output = { 0 };
    size_t count = 1, refused = 0;
    jlt_eigen_row *rows;
    const jlt_eigen_row *first = NULL;
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st = JLT_OK;

    for (size_t i = 0; i < request->axis_count; i++) count *= request->axes[i].count;
    rows = calloc(count, sizeof *rows);
    if (rows == NULL) st = JLT_ERR_NOMEM;
    for (size_t k = 0; st == JLT_OK && k < count; k++) {
        st = compute_row(&rows[k], request, k);
        if (rows[k].status != JLT_OK && refused++ == 0) first = &rows[k];
    }
    if (st == JLT_OK) st = jlt_command_open(&output);
    if (st == JLT_OK) st = write_rows(&output, request, rows, count);
    if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "%s", jlt_status_text(st));
    if (code == JLT_EXIT_DONE && request->common.plot != NULL) code = jlt_eigen_draw(request, rows, count);
    if (code == JLT_EXIT_DONE) code = jlt_command_deliver(&output, request->common.output);
    if (code == JLT_EXIT_DONE && first != NULL)
        code = jlt_command_fail(jlt_command_exit(first->status), "%zu of %zu points refused; the first: %s", refused, count,
                                first->reason);
    jlt_command_discard(&output);
    for (size_t k = 0; rows != NULL && k < count; k++) {
        free(rows[k].params);
        free(rows[k].x);
    }
    free(rows);
    return code;
}
