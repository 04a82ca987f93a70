#include "dynamics/section_batch.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "core/spool.h"
#include "integrate/rest.h"

/* Of an orbit's rows so many are in memory, and of all orbits' so many bytes. */
enum { COLUMNS_MAX = JLT_CHART_STATES_MAX + 1, ROOM = 1024, BYTES = 1 << 28 };

struct jlt_section_batch {
    jlt_flow flow;
    jlt_batch_map map;
    jlt_section_batch_options options;
    jlt_section *section;
    unsigned columns; /* states, and t */
    jlt_status *lifted; /* (count,): what the chart says of the starts */
    size_t *lane;       /* (count,): of starts that have a state */
    size_t *orbit;      /* (lanes,): the other way round */
    double *starts;     /* (lanes, columns) */
    size_t count, lanes;
    jlt_spool *rows;
    size_t made; /* returns of the run; changed atomically */
    int failure; /* of the spool; set atomically */
    bool alone;  /* the orbit that is read goes on by itself */
};

/* Of one return. An orbit that creeps takes more, and explicit methods are at their limit of stability there, where their error is no
 * power of the step: 400 at a tolerance of 1e-12, where returns take some 40, and at looser ones fewer, 100 at least. */
static size_t most_steps(double tolerance)
{
    const double steps = 400 * pow(tolerance / 1e-12, -0.2);
    return steps > 400 ? 400 : steps < 100 ? 100 : (size_t)steps;
}

jlt_status jlt_section_batch_create(jlt_section_batch **out, const jlt_flow *flow, const jlt_kernel_batch *kernels,
                                    const jlt_section_batch_options *options)
{
    /* Where a lane is left to the method that can end at the pole: as far from it as that judges. */
    static const double root_floor = 1e-9;
    jlt_section_batch *self = NULL;
    jlt_status st = JLT_OK;

    *out = NULL;
    if (flow->chart == NULL || flow->field == NULL) return JLT_ERR_ARG;
    if (flow->chart->level != 0 || flow->chart->turn != 0) return JLT_ERR_UNSUPPORTED;
    if (flow->end_where_invalid || flow->t_max != 0) return JLT_ERR_UNSUPPORTED;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->flow = *flow;
    self->options = *options;
    self->columns = flow->chart->states + 1;
    const double tolerance = flow->tolerance != 0 ? flow->tolerance : 1e-12;
    const size_t steps_max = most_steps(tolerance);
    self->map = (jlt_batch_map){
        .kernels = kernels, .p = flow->field->p, .dim = flow->chart->states, .clock = true, .column = flow->chart->column,
        .direction = (int)flow->direction, .root = flow->field->root, .root_floor = root_floor,
        .domain = flow->field->domain,
        .tolerance = tolerance,
        .max_steps = flow->max_steps != 0 && flow->max_steps < steps_max ? flow->max_steps : steps_max, .threads = options->threads,
        .project = options->project, .interrupt = flow->interrupt,
    };
    JLT_TRY(jlt_section_create(&self->section, flow));
    *out = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_section_batch_destroy(self);
    return st;
}

static void forget(jlt_section_batch *self)
{
    jlt_spool_destroy(self->rows);
    free(self->lifted);
    free(self->lane);
    free(self->orbit);
    free(self->starts);
    self->rows = NULL;
    self->lifted = NULL;
    self->lane = self->orbit = NULL;
    self->starts = NULL;
    self->count = self->lanes = self->made = 0;
    self->failure = JLT_OK;
}

void jlt_section_batch_destroy(jlt_section_batch *self)
{
    if (self == NULL) return;
    forget(self);
    jlt_section_destroy(self->section);
    free(self);
}

static int keep_row(void *context, size_t lane, size_t number, const double *x)
{
    jlt_section_batch *self = context;
    const jlt_status st = jlt_spool_add(self->rows, self->orbit[lane], x);

    (void)number;
    if (st != JLT_OK) __atomic_store_n(&self->failure, (int)st, __ATOMIC_RELAXED);
    const size_t made = __atomic_add_fetch(&self->made, 1, __ATOMIC_RELAXED);
    if (self->options.progress != NULL) self->options.progress(self->options.context, made);
    return st != JLT_OK;
}

/* Rows of an orbit that are in memory: one at least. */
static size_t rows_in_memory(const jlt_section_batch *self, size_t count, size_t returns)
{
    const size_t each = BYTES / (self->columns * sizeof(double)) / count, most = returns < ROOM ? returns : ROOM;

    if (each == 0) return 1;
    return each < most ? each : most;
}

/* Rows tell enough: whoever reads beyond them goes on from the last. */
static int ignore_end(void *context, size_t lane, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)lane, (void)end, (void)returns, (void)x;
    return 0;
}

jlt_status jlt_section_batch_run(jlt_section_batch *self, const double *q, size_t count, size_t returns)
{
    const jlt_chart *chart = self->flow.chart;
    jlt_status st = JLT_ERR_NOMEM;

    if (count == 0 || returns == 0) return JLT_ERR_ARG;
    forget(self);
    self->lifted = calloc(count, sizeof *self->lifted);
    self->lane = calloc(count, sizeof *self->lane);
    self->orbit = calloc(count, sizeof *self->orbit);
    self->starts = calloc(count, self->columns * sizeof *self->starts);
    if (self->lifted == NULL || self->lane == NULL || self->orbit == NULL || self->starts == NULL) goto done;
    JLT_TRY(jlt_spool_create(&self->rows, self->columns, count, rows_in_memory(self, count, returns)));
    for (size_t i = 0; i < count; i++) {
        self->lifted[i] = chart->lift(chart, self->starts + self->lanes * self->columns, NULL, q + i * chart->dim);
        if (self->lifted[i] != JLT_OK) continue;
        self->lane[i] = self->lanes;
        self->orbit[self->lanes++] = i;
    }
    self->count = count;
    if (self->lanes > 0)
        JLT_TRY(jlt_batch_section(&self->map, self->starts, self->lanes, returns, keep_row, ignore_end, self, NULL));
    st = (jlt_status)self->failure;
done:
    if (st != JLT_OK) forget(self);
    return st;
}

size_t jlt_section_batch_begun(const jlt_section_batch *self)
{
    size_t begun = self->count;

    if (self->flow.interrupt == NULL || !*self->flow.interrupt) return begun;
    while (begun > 0 && jlt_spool_count(self->rows, begun - 1) == 0) begun--;
    return begun;
}

jlt_status jlt_section_batch_start(jlt_section_batch *self, jlt_return *row, size_t orbit)
{
    const double *start = self->starts + self->lane[orbit] * self->columns;
    double x[JLT_CHART_STATES_MAX];

    if (self->lifted[orbit] != JLT_OK) return self->lifted[orbit];
    for (unsigned k = 0; k < self->flow.chart->states; k++) x[k] = ldexp(start[k], self->flow.units.state[k]);
    self->alone = false;
    jlt_spool_rewind(self->rows, orbit);
    return jlt_section_start_state(self->section, row, x, 1);
}

jlt_status jlt_section_batch_next(jlt_section_batch *self, jlt_return *row)
{
    const double slow = jlt_rest_slow(self->map.tolerance);
    double x[COLUMNS_MAX];
    const jlt_status st = self->alone ? JLT_ERR_EMPTY : jlt_spool_read(self->rows, x);

    if (st == JLT_OK && !jlt_rest_is_slower(self->flow.field, x, slow)) {
        jlt_section_accept(self->section, row, x[self->columns - 1], x);
        return JLT_OK;
    }
    if (st != JLT_OK && st != JLT_ERR_EMPTY) return st;
    self->alone = true;
    return jlt_section_next(self->section, row);
}
