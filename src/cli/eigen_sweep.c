/* Computes the rows of a sweep of `jellett eigen` by several processes. */
#include "cli/eigen.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "core/digits.h"
#include "ext/number.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { POINTS_MAX = 1000000 };

jlt_exit jlt_eigen_parse_sweep(jlt_eigen_request *request, const char *text)
{
    jlt_exit code = jlt_grid_parse(request->axes, &request->axis_count, JLT_EIGEN_AXES_MAX, text, "--sweep");

    if (code == JLT_EXIT_DONE) code = jlt_grid_size(&request->points, request->axes, request->axis_count, text, "--sweep");
    if (code == JLT_EXIT_DONE && request->points > POINTS_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "--sweep: the grid has %zu points; %d at most", request->points, POINTS_MAX);
    return code;
}

/* Memory that the processes of a sweep share. Threads would not do: FLINT's numbers and ARPACK's state do not allow them. */
typedef struct {
    size_t next;            /* the next row to compute, changed atomically */
    size_t stride;          /* of rows */
    double *values;         /* shape (points, parameters and states), to which rows point */
    unsigned char *is_done; /* shape (points,): whether a row is computed */
    char rows[];            /* shape (points,); then values, then is_done */
} shared_rows;

static size_t numbers_of(const jlt_descriptor *d) { return d->param_count + d->state_count; }

static size_t stride_of(const jlt_eigen_request *r)
{
    const size_t n = r->question.descriptor->state_count;
    return r->json ? sizeof(jlt_eigen_row) : offsetof(jlt_eigen_row, found.result.eigen.values) + n * sizeof(jlt_eigenvalue);
}

static size_t bytes_of(const jlt_eigen_request *r)
{
    return sizeof(shared_rows) + r->points * (stride_of(r) + numbers_of(r->question.descriptor) * sizeof(double) + 1);
}

/* Compute row `k` of the grid, on which the last axis runs fastest, at exactly the decimals that it shows; where memory is out, at
 * their doubles. */
static void compute_row(shared_rows *all, const jlt_eigen_request *r, size_t k)
{
    const jlt_descriptor *d = r->question.descriptor;
    double *params = all->values + k * numbers_of(d), *x = params + d->param_count;
    double values[JLT_EIGEN_AXES_MAX];
    char *exact[JLT_EIGEN_AXES_MAX];
    jlt_equilibrium_question question = r->question;
    jlt_eigen_row row = { .descriptor = d, .params = params, .x = x };

    memcpy(params, r->params, d->param_count * sizeof *params);
    memcpy(x, r->x, d->state_count * sizeof *x);
    jlt_grid_point(values, r->axes, r->axis_count, k);
    for (size_t i = 0; i < r->axis_count; i++) {
        const jlt_eigen_target *target = &r->targets[i];
        char text[JLT_DIGITS_SIZE];
        const size_t length = (size_t)(jlt_digits_shortest(text, values[i]) - text);
        (target->is_state ? x : params)[target->index] = values[i];
        if (jlt_number_fraction(&exact[i], text, length) != JLT_OK) exact[i] = NULL;
        *(target->is_state ? &question.x[target->index] : &question.params[target->index]) = exact[i];
    }
    jlt_equilibrium_compute(&row.found, &question, params, x);
    for (size_t i = 0; i < r->axis_count; i++) free(exact[i]);
    memcpy(all->rows + k * all->stride, &row, all->stride);
    __atomic_store_n(&all->is_done[k], 1, __ATOMIC_RELEASE);
}

/* progress: NULL in all processes but one. */
static void compute_some(shared_rows *all, const jlt_eigen_request *r, const volatile sig_atomic_t *interrupt,
                         jlt_progress *progress)
{
    for (size_t k; *interrupt == 0 && (k = __atomic_fetch_add(&all->next, 1, __ATOMIC_RELAXED)) < r->points;) {
        compute_row(all, r, k);
        if (progress != NULL) jlt_progress_show(progress, k + 1, r->points);
    }
}

/* Compute the rows by several processes, this one among them, which at the end also computes rows that a killed process left
 * unfinished. Returns the number of rows before the first unfinished one: all, unless interrupted. */
static size_t compute_all(shared_rows *all, const jlt_eigen_request *r, const volatile sig_atomic_t *interrupt)
{
    const size_t wanted = r->processes > 0 ? r->processes : jlt_common_processors();
    const size_t others = (r->points < wanted ? r->points : wanted) - 1;
    const pid_t self = getpid();
    pid_t *made = calloc(others + 1, sizeof *made);
    jlt_progress progress;
    size_t done = 0;

    for (size_t i = 0; made != NULL && i < others; i++) {
        made[i] = fork();
        if (made[i] != 0) continue;
        prctl(PR_SET_PDEATHSIG, SIGTERM); /* end also if the parent is killed */
        if (getppid() != self) _exit(0);  /* it was killed before prctl */
        compute_some(all, r, interrupt, NULL);
        _exit(0);
    }
    jlt_progress_start(&progress, "rows");
    compute_some(all, r, interrupt, &progress);
    jlt_progress_end(&progress);
    for (size_t i = 0; made != NULL && i < others; i++) {
        if (made[i] < 0) continue; /* fork failed: there is one process fewer */
        if (*interrupt != 0) kill(made[i], SIGTERM);
        while (waitpid(made[i], NULL, 0) < 0 && errno == EINTR) {}
    }
    free(made);
    for (; done < r->points; done++) {
        if (all->is_done[done] == 0 && *interrupt == 0) compute_row(all, r, done);
        if (all->is_done[done] == 0) break;
    }
    return done;
}

jlt_exit jlt_eigen_sweep(const jlt_eigen_request *request)
{
    jlt_command_output output = { 0 };
    const volatile sig_atomic_t *const interrupt = jlt_interrupt_install();
    size_t refused = 0, failed = 0;
    const jlt_eigen_row *first = NULL;
    char reason[JLT_EIGEN_REASON_MAX];
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st;

    const int kind = MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE;
    shared_rows *const all = mmap(NULL, bytes_of(request), PROT_READ | PROT_WRITE, kind, -1, 0);
    if (all == MAP_FAILED) return jlt_command_no_memory();
    all->stride = stride_of(request);
    all->values = (void *)(all->rows + request->points * all->stride);
    all->is_done = (unsigned char *)all + bytes_of(request) - request->points;
    const size_t count = compute_all(all, request, interrupt);
    const jlt_eigen_rows rows = { all->rows, all->stride, count };
    jlt_interrupt_draw(); /* a million rows take some seconds to write */
    for (size_t k = 0; k < count; k++) {
        const jlt_eigen_row *row = jlt_eigen_row_at(rows, k);
        if (row->found.status == JLT_OK) continue;
        if (refused++ == 0) first = row;
        failed += jlt_command_exit(row->found.status) == JLT_EXIT_NUMERICAL;
    }
    st = jlt_command_open(&output);
    if (st == JLT_OK && request->json) st = jlt_eigen_write_json(output.stream, rows, true);
    else if (st == JLT_OK) jlt_eigen_write_csv(output.stream, request, rows);
    if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "%s", jlt_status_text(st));
    if (code == JLT_EXIT_DONE) code = jlt_stream_deliver(&output, request->common.output);
    if (code == JLT_EXIT_DONE && count < request->points)
        fprintf(stderr, "jellett: interrupted; the first %zu of %zu rows are saved in %s\n", count, request->points,
                request->common.output == NULL ? "standard output" : request->common.output);
    if (code == JLT_EXIT_DONE && request->common.plot != NULL) code = jlt_eigen_draw(request, rows);
    if (code == JLT_EXIT_DONE && first != NULL) {
        jlt_eigen_reason(reason, first);
        fprintf(stderr, "jellett: %zu of %zu points refused; the first: %s\n", refused, count, reason);
        if (failed > 0) code = JLT_EXIT_NUMERICAL;
        else if (refused == count && request->axes[0].part == 0) code = JLT_EXIT_INPUT; /* of a part, other parts may have rows */
    }
    jlt_command_discard(&output);
    munmap(all, bytes_of(request));
    return code;
}
