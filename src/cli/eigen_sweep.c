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
static jlt_status compute_row(jlt_eigen_row *row, const jlt_eigen_request *r, const jlt_equilibrium_question *question, size_t k)
{
    const jlt_descriptor *d = question->descriptor;
    double values[JLT_EIGEN_AXES_MAX];

    row->descriptor = d;
    row->params = malloc((d->param_count + 1) * sizeof *row->params);
    row->x = malloc(d->state_count * sizeof *row->x);
    if (row->params == NULL || row->x == NULL) return JLT_ERR_NOMEM;
    memcpy(row->params, r->params, d->param_count * sizeof *row->params);
    memcpy(row->x, r->x, d->state_count * sizeof *row->x);
    jlt_grid_point(values, r->axes, r->axis_count, k);
    for (size_t i = 0; i < r->axis_count; i++) (r->targets[i].is_state ? row->x : row->params)[r->targets[i].index] = values[i];
    jlt_equilibrium_compute(&row->found, question, row->params, row->x);
    return JLT_OK;
}

/* The rows of a sweep, and which of them is next. */
typedef struct {
    const jlt_eigen_request *request;
    jlt_eigen_row *rows;
    size_t count, next, computed; /* next and computed are changed atomically */
    const volatile sig_atomic_t *interrupt;
} sweep;

/* What one thread does of them, with an oracle of its own: the graph of one is not for two. */
static jlt_status work(sweep *self, jlt_oracle *oracle)
{
    jlt_equilibrium_question question = self->request->question;
    jlt_status st = JLT_OK;

    question.oracle = oracle;
    while (st == JLT_OK && !*self->interrupt) {
        const size_t k = __atomic_fetch_add(&self->next, 1, __ATOMIC_RELAXED);
        if (k >= self->count) break;
        st = compute_row(&self->rows[k], self->request, &question, k);
        __atomic_add_fetch(&self->computed, 1, __ATOMIC_RELAXED);
    }
    return st;
}

static jlt_status compute(sweep *self)
{
    const size_t threads = self->request->threads < self->count ? self->request->threads : self->count;
    jlt_oracle **oracles = calloc(threads, sizeof(jlt_oracle *));
    int failure = JLT_OK;

    if (oracles == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < threads && failure == JLT_OK; i++)
        failure = (int)jlt_oracle_create(&oracles[i], self->request->question.descriptor);
#if defined(_OPENMP)
#pragma omp parallel for num_threads((int)threads) schedule(static, 1) reduction(max : failure)
#endif
    for (size_t i = 0; i < threads; i++) {
        const int st = failure == JLT_OK ? (int)work(self, oracles[i]) : JLT_OK;
        if (st > failure) failure = st;
    }
    for (size_t i = 0; i < threads; i++) jlt_oracle_destroy(oracles[i]);
    free(oracles);
    return (jlt_status)failure;
}

jlt_exit jlt_eigen_sweep(const jlt_eigen_request *request)
{
    jlt_command_output output = { 0 };
    const volatile sig_atomic_t *const interrupt = jlt_interrupt_install();
    size_t count, refused = 0;
    jlt_eigen_row *rows;
    const jlt_eigen_row *first = NULL;
    char reason[JLT_EIGEN_REASON_MAX];
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st;

    count = request->points;
    rows = calloc(count, sizeof *rows);
    sweep self = { .request = request, .rows = rows, .count = count, .interrupt = interrupt };
    st = rows != NULL ? compute(&self) : JLT_ERR_NOMEM;
    if (st == JLT_OK && self.computed < count) {
        code = jlt_command_fail(JLT_EXIT_NUMERICAL, "interrupted; nothing is saved, as only %zu of %zu rows are there", self.computed, count);
        goto done;
    }
    for (size_t k = 0; st == JLT_OK && k < count; k++)
        if (rows[k].found.status != JLT_OK && refused++ == 0) first = &rows[k];
    if (st == JLT_OK) st = jlt_command_open(&output);
    if (st == JLT_OK && request->json) st = jlt_eigen_write_json(output.stream, rows, count, true);
    else if (st == JLT_OK) jlt_eigen_write_csv(output.stream, request, rows, count);
    if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "%s", jlt_status_text(st));
    if (code == JLT_EXIT_DONE) code = jlt_command_deliver(&output, request->common.output);
    if (code == JLT_EXIT_DONE && request->common.plot != NULL) code = jlt_eigen_draw(request, rows, count);
    if (code == JLT_EXIT_DONE && first != NULL) {
        jlt_eigen_reason(reason, first);
        code = jlt_command_fail(jlt_command_exit(first->found.status), "%zu of %zu points refused; the first: %s", refused,
                                count, reason);
    }
done:
    jlt_command_discard(&output);
    for (size_t k = 0; rows != NULL && k < count; k++) {
        free(rows[k].params);
        free(rows[k].x);
    }
    free(rows);
    return code;
}
