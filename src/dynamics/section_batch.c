#include "dynamics/section_batch.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "core/memory.h"
#include "core/spool.h"
#include "dynamics/section_flows.h"
#include "integrate/rest.h"

/* At most ROOM rows of an orbit, and BYTES of all orbits' rows, are in memory. A row has the states, t, the least value of the
 * model's conditions, and the index of that condition. */
enum { WATCHED = 2, COLUMNS_MAX = JLT_CHART_STATES_MAX + 1 + WATCHED, ROOM = 1024, BYTES = 1 << 28 };

/* An orbit, without its rows. */
typedef struct {
    size_t rows;
    unsigned lost;
    jlt_fate fate;         /* of the end */
    jlt_lane_end lane_end;
    bool has_lane_end, has_end, is_interrupted; /* has_end: the orbit ends after its rows, or was interrupted there */
    bool is_slow;          /* the lane's next return is left to the flow's own method */
} course;

struct jlt_section_batch {
    jlt_section_flows flows; /* their sections follow orbits alone; that of the first thread also reads them */
    jlt_batch_map map;       /* kernels NULL: no lanes */
    jlt_batch_watch watch;
    jlt_section_batch_options options;
    unsigned threads, columns, width; /* columns: of lanes, states, and t; width: of a row */
    double slow;        /* an orbit slower than this is left to the flow's own method (integrate/rest.h) */
    jlt_status *lifted; /* (count,): status of each start's lift */
    size_t *lane;       /* (count,): of each start that has a state */
    double *starts;     /* (lanes, columns) */
    size_t *flow_of;    /* (lanes,); behind them, in the same memory, */
    size_t *returns_of; /* (lanes,): how many each orbit makes; at most `returns` */
    course *courses;    /* (lanes,) */
    double *last, *end; /* (lanes, width): the last row; where the lane or the orbit ended */
    size_t count, lanes, returns;
    jlt_spool *rows;    /* of lanes; NULL: only last rows are kept */
    size_t made; /* returns of the run; changed atomically */
    int failure; /* of the spool; set atomically */
    struct {
        size_t lane;
        jlt_section *section; /* of its flow */
        bool is_done; /* all its rows have been read */
    } reading;
};

jlt_status jlt_section_batch_create(jlt_section_batch **out, const jlt_flow *flow, const jlt_kernel_batch *kernels,
                                    const jlt_section_batch_options *options)
{
    /* Below root_floor the flow's own method judges whether an orbit ends at a pole; few orbits that do not reach root_least. */
    static const double root_floor = 1e-9, root_least = 1e-12;
    static const jlt_section_batch_options defaults = { .threads = 0 };
    jlt_section_batch *self = NULL;

    *out = NULL;
    if (flow == NULL || flow->chart == NULL || flow->field == NULL || !jlt_section_flows_owns(flow, kernels)) return JLT_ERR_ARG;
    if (options == NULL) options = &defaults;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->options = *options;
    self->threads = options->threads > 1 ? options->threads : 1;
    self->columns = flow->chart->states + 1;
    self->width = self->columns + WATCHED;
    const double tolerance = flow->tolerance != 0 ? flow->tolerance : JLT_ORBIT_TOLERANCE;
    const size_t steps_max = jlt_batch_most_steps(tolerance);
    self->slow = jlt_rest_slow(tolerance);
    self->map = (jlt_batch_map){
        .kernels = jlt_section_flows_obstacle(flow, kernels) == NULL ? kernels : NULL, .dim = flow->chart->states, .clock = true,
        .column = flow->chart->column, .turn = flow->chart->turn, .direction = (int)flow->direction,
        .backwards = options->backwards, .root = flow->field->root, .root_floor = root_floor, .root_least = root_least,
        .root_rest = jlt_batch_rest(tolerance), .kept = flow->field->kept.words[0], .groups = &flow->field->groups,
        .angles = flow->field->angles.words[0], .tolerance = tolerance, .threads = options->threads, .interrupt = flow->interrupt,
        .domain = jlt_field_watches(flow->field) ? &flow->field->domain : NULL,
        .max_steps = flow->max_steps != 0 && flow->max_steps < steps_max ? flow->max_steps : steps_max,
        .project = options->project != NULL ? options->project->descriptor : NULL,
    };
    self->watch = (jlt_batch_watch){ .count = jlt_observed_conditions(flow->observed), .seeks_least = flow->seeks_least,
                                     .ends = flow->end_where_invalid };
    self->watch.until_lost = !flow->seeks_least && self->watch.count == 1; /* of several the least is named */
    if (self->map.kernels != NULL && self->watch.count > 0 && (options->watches || flow->end_where_invalid)) {
        self->watch.kernels = jlt_section_flows_watching(flow, kernels);
        self->map.watch = &self->watch;
    }
    const jlt_status st = jlt_section_flows_open(&self->flows, flow, options->project, self->threads);
    if (st == JLT_OK) *out = self;
    else jlt_section_batch_destroy(self);
    return st;
}

jlt_status jlt_section_batch_add(jlt_section_batch *self, size_t *index, const jlt_flow *flow, const jlt_instance *project)
{
    if (index != NULL) *index = self->flows.count;
    return jlt_section_flows_add(&self->flows, flow, project);
}

static void forget(jlt_section_batch *self)
{
    jlt_spool_destroy(self->rows);
    free(self->lifted);
    free(self->lane);
    free(self->starts);
    free(self->flow_of);
    free(self->courses);
    free(self->last);
    free(self->end);
    self->rows = NULL, self->lifted = NULL, self->courses = NULL;
    self->lane = self->flow_of = self->returns_of = NULL;
    self->starts = self->last = self->end = NULL;
    self->count = self->lanes = self->made = 0;
    self->failure = JLT_OK;
}

void jlt_section_batch_destroy(jlt_section_batch *self)
{
    if (self == NULL) return;
    forget(self);
    jlt_section_flows_clear(&self->flows);
    free(self);
}

static const jlt_flow *flow_of(const jlt_section_batch *self, size_t lane) { return &self->flows.all[self->flow_of[lane]].flow; }

/* Add a row, shape (width,), to an orbit. */
static jlt_status keep(jlt_section_batch *self, size_t lane, const double *row)
{
    const jlt_status st = self->rows != NULL ? jlt_spool_add(self->rows, lane, row) : JLT_OK;

    memcpy(self->last + lane * self->width, row, self->width * sizeof *row);
    self->courses[lane].rows++;
    const size_t made = __atomic_add_fetch(&self->made, 1, __ATOMIC_RELAXED);
    if (self->options.progress != NULL) self->options.progress(self->options.context, made);
    return st;
}

/* Make a row from what a lane reports. */
static void row_of(const jlt_section_batch *self, double *row, const double *x)
{
    memcpy(row, x, self->columns * sizeof *x);
    row[self->columns] = self->map.watch != NULL ? x[self->columns] : INFINITY;
    row[self->columns + 1] = self->map.watch != NULL ? x[self->columns + 1] : 0;
}

static int keep_row(void *context, size_t lane, size_t number, const double *x)
{
    jlt_section_batch *self = context;
    const jlt_field *field = flow_of(self, lane)->field;
    course *at = &self->courses[lane];
    double row[COLUMNS_MAX];

    (void)number;
    const double size = jlt_field_size_at(field, self->starts + lane * self->columns);
    at->is_slow |= jlt_rest_is_slower(field, x, size, self->slow, self->options.backwards ? -1 : 1);
    if (at->is_slow) return 0;
    row_of(self, row, x);
    const jlt_status st = keep(self, lane, row);
    if (st != JLT_OK) __atomic_store_n(&self->failure, (int)st, __ATOMIC_RELAXED);
    return st != JLT_OK;
}

static int keep_end(void *context, size_t lane, jlt_lane_end end, size_t returns, const double *x)
{
    jlt_section_batch *self = context;

    course *at = &self->courses[lane];

    (void)returns;
    if (end == JLT_LANE_DOUBTED) {
        __atomic_fetch_sub(&self->made, at->rows, __ATOMIC_RELAXED);
        at->rows = 0;
        if (self->rows != NULL) jlt_spool_forget(self->rows, lane);
    }
    at->lane_end = end;
    at->has_lane_end = true;
    row_of(self, self->end + lane * self->width, x);
    return 0;
}

/* Convert a section's row to a row of shape (width,), in the units of lanes. */
static void from_section(const jlt_section_batch *self, double *row, const jlt_return *at, size_t lane)
{
    const jlt_flow *flow = flow_of(self, lane);
    const unsigned n = flow->chart->states;

    for (unsigned k = 0; k < n; k++) row[k] = ldexp(at->x[k], -flow->units.state[k]);
    row[n] = ldexp(at->t, -flow->units.time);
    row[self->columns] = at->least;
    row[self->columns + 1] = at->lost;
}

static jlt_status begin(const jlt_section_batch *self, jlt_section *section, jlt_return *row, size_t lane)
{
    const jlt_flow *flow = flow_of(self, lane);
    double x[JLT_CHART_STATES_MAX];

    for (unsigned k = 0; k < flow->chart->states; k++) x[k] = ldexp(self->starts[lane * self->columns + k], flow->units.state[k]);
    return jlt_section_start_state(section, row, x, self->options.backwards ? -1 : 1);
}

/* Let an orbit go on alone: near a pole and at the edge of the domain from where the lane ended, else from its last return, since a
 * lane that stalls may have gone astray. */
static void resume(const jlt_section_batch *self, jlt_section *section, size_t lane)
{
    const course *at = &self->courses[lane];
    const bool goes_on = at->has_lane_end && !at->is_slow && (at->lane_end == JLT_LANE_ROOT || at->lane_end == JLT_LANE_DOMAIN);
    double *from = (goes_on ? self->end : self->last) + lane * self->width;

    if (!goes_on && at->rows == 0) return;
    if (at->lane_end == JLT_LANE_ROOT && goes_on) from[self->map.root] = fabs(from[self->map.root]); /* an error may pass 0 */
    jlt_section_note(section, from[self->columns], (unsigned)from[self->columns + 1]);
    jlt_section_resume(section, at->rows, from[self->columns - 1], from);
}

/* Whether the orbit's lane has made all its returns. */
static bool is_done(const course *at) { return at->has_lane_end && at->lane_end == JLT_LANE_DONE && !at->is_slow; }

/* Make the returns of an orbit that its lane has not made, by the flow's own method. */
static jlt_status finish(jlt_section_batch *self, unsigned thread, size_t lane)
{
    course *at = &self->courses[lane];
    double kept[COLUMNS_MAX];
    jlt_section *section;
    jlt_return row;

    if (is_done(at)) return JLT_OK;
    JLT_PASS(jlt_section_flows_section(&self->flows, &section, thread, self->flow_of[lane]));
    JLT_PASS(begin(self, section, &row, lane));
    if (row.fate != JLT_FATE_ALIVE) return JLT_OK; /* readers see that it has ended at its start */
    resume(self, section, lane);
    while (row.fate == JLT_FATE_ALIVE && !row.interrupted && at->rows < self->returns_of[lane]) {
        JLT_PASS(jlt_section_next(section, &row));
        from_section(self, kept, &row, lane);
        if (row.fate == JLT_FATE_ALIVE && !row.interrupted) JLT_PASS(keep(self, lane, kept));
    }
    at->has_end = row.fate != JLT_FATE_ALIVE || row.interrupted;
    if (!at->has_end) return JLT_OK;
    at->fate = row.fate;
    at->lost = row.lost;
    at->is_interrupted = row.interrupted;
    memcpy(self->end + lane * self->width, kept, self->width * sizeof *kept);
    return JLT_OK;
}

static jlt_status finish_all(jlt_section_batch *self)
{
    size_t left = 0, next = 0;
    int failure = JLT_OK;

    for (size_t lane = 0; lane < self->lanes; lane++) left += !is_done(&self->courses[lane]);
    const unsigned threads = left < self->threads ? (unsigned)left : self->threads;

#if defined(_OPENMP)
#pragma omp parallel for num_threads(threads > 1 ? (int)threads : 1) schedule(static, 1) reduction(max : failure)
#endif
    for (unsigned thread = 0; thread < threads; thread++) {
        jlt_status st = JLT_OK;
        while (st == JLT_OK) {
            const size_t lane = __atomic_fetch_add(&next, 1, __ATOMIC_RELAXED);
            if (lane >= self->lanes) break;
            st = finish(self, thread, lane);
        }
        if ((int)st > failure) failure = (int)st;
    }
    return (jlt_status)failure;
}

/* Number of rows of an orbit that are in memory: one at least. */
static size_t rows_in_memory(const jlt_section_batch *self, size_t count, size_t returns)
{
    const size_t each = BYTES / (self->width * sizeof(double)) / count, most = returns < ROOM ? returns : ROOM;

    if (each == 0) return 1;
    return each < most ? each : most;
}

/* Lift the starts, a lane for each that has a state, and allocate what the run fills. */
static jlt_status lift_starts(jlt_section_batch *self, const double *q, const size_t *flows, const size_t *each, size_t count)
{
    self->lifted = calloc(count, sizeof *self->lifted);
    self->lane = calloc(count, sizeof *self->lane);
    self->starts = calloc(count, self->columns * sizeof *self->starts);
    self->flow_of = calloc(2 * count, sizeof *self->flow_of);
    if (self->lifted == NULL || self->lane == NULL || self->starts == NULL || self->flow_of == NULL) return JLT_ERR_NOMEM;
    self->returns_of = self->flow_of + count;
    for (size_t i = 0; i < count; i++) {
        const size_t flow = flows != NULL ? flows[i] : 0, returns = each != NULL ? each[i] : self->returns;
        if (flow >= self->flows.count || returns == 0 || returns > self->returns) return JLT_ERR_ARG;
        self->flow_of[self->lanes] = flow, self->returns_of[self->lanes] = returns;
        const jlt_chart *chart = flow_of(self, self->lanes)->chart;
        self->lifted[i] = chart->lift(chart, self->starts + self->lanes * self->columns, NULL, q + i * chart->dim);
        if (self->lifted[i] == JLT_OK) self->lane[i] = self->lanes++;
    }
    self->count = count;
    if (self->lanes == 0) return JLT_OK;
    self->courses = calloc(self->lanes, sizeof *self->courses);
    self->last = calloc(self->lanes, self->width * sizeof *self->last);
    self->end = calloc(self->lanes, self->width * sizeof *self->end);
    if (self->courses == NULL || self->last == NULL || self->end == NULL) return JLT_ERR_NOMEM;
    if (self->options.last_only) return JLT_OK;
    return jlt_spool_create(&self->rows, self->width, self->lanes, rows_in_memory(self, self->lanes, self->returns));
}

static jlt_status follow_in_lanes(jlt_section_batch *self)
{
    jlt_batch_map map = self->map;
    JLT_FREED jlt_batch_case *cases = jlt_section_flows_cases(&self->flows, map.kernels, map.watch != NULL);

    if (cases == NULL) return JLT_ERR_NOMEM;
    map.cases = cases, map.case_of = self->flow_of, map.returns_of = self->returns_of;
    return jlt_batch_section(&map, self->starts, self->lanes, self->returns, keep_row, keep_end, self, NULL);
}

jlt_status jlt_section_batch_run(jlt_section_batch *self, const double *q, size_t count, size_t returns)
{
    return jlt_section_batch_run_each(self, q, NULL, NULL, count, returns);
}

jlt_status jlt_section_batch_run_each(jlt_section_batch *self, const double *q, const size_t *flow_of, const size_t *each,
                                      size_t count, size_t returns)
{
    jlt_status st = JLT_OK;

    if (count == 0 || returns == 0) return JLT_ERR_ARG;
    forget(self);
    self->returns = returns;
    JLT_TRY(lift_starts(self, q, flow_of, each, count));
    if (self->lanes > 0 && self->map.kernels != NULL) JLT_TRY(follow_in_lanes(self));
    st = self->failure != JLT_OK ? (jlt_status)self->failure : finish_all(self);
done:
    if (st != JLT_OK) forget(self);
    return st;
}

size_t jlt_section_batch_begun(const jlt_section_batch *self)
{
    size_t begun = self->count;

    if (self->map.interrupt == NULL || !*self->map.interrupt) return begun;
    while (begun > 0 && (self->lifted[begun - 1] != JLT_OK || self->courses[self->lane[begun - 1]].rows == 0)) begun--;
    return begun;
}

jlt_status jlt_section_batch_start(jlt_section_batch *self, jlt_return *row, size_t orbit)
{
    if (orbit >= self->count) return JLT_ERR_ARG;
    if (self->lifted[orbit] != JLT_OK) return self->lifted[orbit];
    self->reading.lane = self->lane[orbit];
    self->reading.is_done = false;
    if (self->rows != NULL) jlt_spool_rewind(self->rows, self->reading.lane);
    const jlt_status st = jlt_section_flows_section(&self->flows, &self->reading.section, 0, self->flow_of[self->reading.lane]);
    return st != JLT_OK ? st : begin(self, self->reading.section, row, self->reading.lane);
}

static void read_end(jlt_section_batch *self, jlt_return *row)
{
    const course *at = &self->courses[self->reading.lane];
    const double *x = self->end + self->reading.lane * self->width;

    jlt_section_note(self->reading.section, x[self->columns], (unsigned)x[self->columns + 1]);
    jlt_section_end(self->reading.section, row, x[self->columns - 1], x, at->fate, at->lost);
    row->interrupted = at->is_interrupted;
}

static void read_row(jlt_section_batch *self, jlt_return *row, const double *x)
{
    jlt_section_note(self->reading.section, x[self->columns], (unsigned)x[self->columns + 1]);
    jlt_section_accept(self->reading.section, row, x[self->columns - 1], x);
}

jlt_status jlt_section_batch_next(jlt_section_batch *self, jlt_return *row)
{
    double x[COLUMNS_MAX];

    if (self->reading.is_done) return jlt_section_next(self->reading.section, row);
    const jlt_status st = self->rows != NULL ? jlt_spool_read(self->rows, x) : JLT_ERR_ARG;
    if (st == JLT_OK) read_row(self, row, x);
    if (st != JLT_ERR_EMPTY) return st;
    self->reading.is_done = true;
    if (!self->courses[self->reading.lane].has_end) return jlt_section_next(self->reading.section, row);
    read_end(self, row);
    return JLT_OK;
}

jlt_status jlt_section_batch_last(jlt_section_batch *self, jlt_return *row, size_t orbit)
{
    const jlt_status st = jlt_section_batch_start(self, row, orbit);

    if (st != JLT_OK || row->fate != JLT_FATE_ALIVE) return st;
    const course *at = &self->courses[self->reading.lane];
    const double *last = self->last + self->reading.lane * self->width;
    if (at->rows > 0) {
        jlt_section_resume(self->reading.section, at->rows - 1, last[self->columns - 1], last);
        read_row(self, row, last);
    }
    if (at->has_end) read_end(self, row);
    return JLT_OK;
}
