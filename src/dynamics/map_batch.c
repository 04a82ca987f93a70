#include "dynamics/map_batch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "dynamics/linear.h"
#include "dynamics/map_return.h"
#include "dynamics/section_flows.h"
#include "dynamics/varied.h"

enum { D = JLT_CHART_DIM_MAX };

/* A lane ends where its lifted root falls to root_floor, from where the flow's own method judges whether the orbit ends at a pole,
 * and where a return takes ten times the usual steps. */
static const double root_floor = 1e-9;
static const size_t most_steps = 1000;

/* What is asked for. returns: of the point with the most; flow_of, each, directions: flow, returns and direction of time of each
 * point, NULL where that is the first flow, `returns`, `direction` for all. */
typedef struct {
    size_t returns;
    const size_t *flow_of, *each;
    int direction;
    const int *directions;
    jlt_map_batch_observer observer; /* NULL: none */
    void *context;
} request;

/* What one thread works on: BLOCK points at a time, through all their returns. */
enum { BLOCK = 256 };
typedef struct {
    const jlt_map_batch *batch;
    const jlt_map_images *out;
    const request *wanted;
    int direction;         /* of time, being computed */
    jlt_map *alone;  /* for orbits that are followed alone, */
    size_t alone_of; /* of this flow */
    size_t *point;   /* in each lane, shape (BLOCK,) as the arrays below */
    size_t *case_of; /* the point's flow */
    double *starts;  /* (BLOCK, columns) */
    double *flux;    /* at the starts */
    enum { AWAY, BACK, ON_WAY, DOUBTED } *is; /* ON_WAY: a lane has ended before its return; its start is replaced by either.
                                               * DOUBTED: its steps err, or DP disagrees with flux and divergence, as at a jump */
} worker;

struct jlt_map_batch {
    jlt_flow *flows;       /* (flow_count,) */
    jlt_batch_case *cases; /* (flow_count,): of these */
    size_t flow_count;
    jlt_batch_map map;
    unsigned columns;
    worker *workers; /* (threads,) */
    unsigned threads;
};

bool jlt_map_batch_in_lanes(const jlt_map_batch *self) { return self->map.kernels != NULL; }

/* Whether lanes can follow the flow: t_max is not set, states and conditions are few enough. */
static bool serves(const jlt_flow *flow)
{
    const jlt_chart *chart = flow->chart;
    const jlt_batch_map map = { .dim = chart->states, .tangents = chart->dim };

    if (flow->t_max != 0 || flow->field->domain.conditions > JLT_BATCH_CONDITIONS_MAX) return false;
    return chart->states <= JLT_BATCH_STATES_MAX && jlt_batch_columns(&map) <= JLT_BATCH_COLUMNS_MAX;
}

static jlt_status hire(worker *out, const jlt_map_batch *batch)
{
    out->batch = batch;
    out->point = calloc(BLOCK, sizeof *out->point);
    out->starts = calloc((size_t)BLOCK * batch->columns, sizeof *out->starts);
    out->flux = calloc(BLOCK, sizeof *out->flux);
    out->is = calloc(BLOCK, sizeof *out->is);
    out->case_of = calloc(BLOCK, sizeof *out->case_of);
    const bool failed = out->point == NULL || out->starts == NULL || out->flux == NULL || out->is == NULL || out->case_of == NULL;
    return failed ? JLT_ERR_NOMEM : jlt_map_create(&out->alone, batch->flows);
}

static jlt_status append(jlt_map_batch *self, const jlt_flow *flow)
{
    if (!JLT_MEMORY_GROW(self->flows, self->flow_count) || !JLT_MEMORY_GROW(self->cases, self->flow_count)) return JLT_ERR_NOMEM;
    self->map.cases = self->cases;
    self->cases[self->flow_count] = (jlt_batch_case){ .p = flow->field->p, .level = flow->chart->level };
    self->flows[self->flow_count++] = *flow;
    return JLT_OK;
}

jlt_status jlt_map_batch_add(jlt_map_batch *self, size_t *index, const jlt_flow *flow)
{
    *index = self->flow_count;
    return jlt_section_flows_fit(self->flows, flow) ? append(self, flow) : JLT_ERR_ARG;
}

jlt_status jlt_map_batch_create(jlt_map_batch **out, const jlt_flow *flow, const jlt_kernel_batch *kernels,
                                const struct jlt_batch_method *method, unsigned threads)
{
    jlt_map_batch *self = NULL;
    jlt_status st = JLT_OK;

    *out = NULL;
    if (flow == NULL || flow->chart == NULL || flow->field == NULL || flow->chart->states != flow->field->dim) return JLT_ERR_ARG;
    if (!jlt_section_flows_owns(flow, kernels)) return JLT_ERR_ARG;
    const jlt_batch_map map = {
        .kernels = kernels != NULL && serves(flow) ? kernels : NULL,
        .dim = flow->chart->states,
        .tangents = flow->chart->dim,
        .column = flow->chart->column, .turn = flow->chart->turn,
        .direction = (int)flow->direction,
        .root = flow->field->root,
        .kept = flow->field->kept.words[0], .groups = &flow->field->groups, .angles = flow->field->angles.words[0],
        .root_floor = root_floor,
        .domain = jlt_field_watches(flow->field) ? &flow->field->domain : NULL,
        .method = method,
        .tolerance = flow->tolerance != 0 ? flow->tolerance : JLT_ORBIT_TOLERANCE,
        .max_steps = flow->max_steps != 0 && flow->max_steps < most_steps ? flow->max_steps : most_steps,
        .interrupt = flow->interrupt,
    };
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->map = map;
    self->columns = jlt_batch_columns(&map);
    self->threads = threads > 1 ? threads : 1;
    self->workers = calloc(self->threads, sizeof *self->workers);
    st = self->workers == NULL ? JLT_ERR_NOMEM : append(self, flow);
    for (unsigned i = 0; st == JLT_OK && i < self->threads; i++) st = hire(&self->workers[i], self);
    if (st == JLT_OK) {
        *out = self;
        self = NULL; /* ownership moved to the caller */
    }
    jlt_map_batch_destroy(self);
    return st;
}

void jlt_map_batch_destroy(jlt_map_batch *self)
{
    if (self == NULL) return;
    for (unsigned i = 0; self->workers != NULL && i < self->threads; i++) {
        worker *w = &self->workers[i];
        jlt_map_destroy(w->alone);
        free(w->point);
        free(w->starts);
        free(w->flux);
        free(w->is);
        free(w->case_of);
    }
    free(self->workers);
    free(self->flows);
    free(self->cases);
    free(self);
}

static size_t flow_index(const worker *self, size_t point)
{
    return self->wanted->flow_of != NULL ? self->wanted->flow_of[point] : 0;
}

static const jlt_flow *flow_of(const worker *self, size_t point) { return &self->batch->flows[flow_index(self, point)]; }

/* Make self->alone the map of this point's flow. */
static jlt_status alone(worker *self, size_t point)
{
    const size_t flow = flow_index(self, point);

    if (self->alone != NULL && self->alone_of == flow) return JLT_OK;
    jlt_map_destroy(self->alone);
    self->alone_of = flow;
    return jlt_map_create(&self->alone, &self->batch->flows[flow]);
}

/* Multiply a return onto the results of its point, where the image q is set already. */
static void add(const worker *self, size_t point, const jlt_map_batch_return *made, double determinant, double defect, double bound)
{
    const jlt_map_images *out = self->out;
    const unsigned d = self->batch->flows->chart->dim;

    if (self->wanted->observer != NULL) self->wanted->observer(self->wanted->context, point, made);
    jlt_linear_multiply(out->slope + point * d * d, made->slope, out->slope + point * d * d, d);
    out->T[point] += made->T;
    out->expansion[point] += made->expansion;
    out->determinant[point] *= determinant;
    if (!(fabs(defect) >= fabs(out->defect[point]))) return;
    out->defect[point] = defect;
    if (out->bound != NULL) out->bound[point] = bound;
}

/* Store the return of a lane, whose start is replaced by it, after time t in the flow's unit. It becomes DOUBTED instead where
 * less than half of the digits asked for agree, or a bound is wanted and the least one does not hold, or jlt_varied_is_kept. */
static void arrive(const worker *self, size_t lane, double t)
{
    const double *varied = self->starts + lane * self->batch->columns;
    const jlt_map_images *out = self->out;
    const size_t point = self->point[lane];
    const jlt_flow *flow = flow_of(self, point);
    const unsigned n = flow->chart->states, d = flow->chart->dim;
    double q[D], slope[D * D];
    jlt_map_return arrival;

    out->status[point] = jlt_map_return_end(&arrival, q, slope, flow, varied, self->flux[lane]);
    if (out->status[point] != JLT_OK) return;
    const double defect = (fabs(arrival.determinant) - arrival.flux_determinant) / (arrival.size > 0 ? arrival.size : 1);
    const double tolerance = self->batch->map.tolerance;
    const double bound = out->bound == NULL ? INFINITY
                                            : jlt_map_return_bound(&arrival, &(jlt_map_return_steps){ tolerance, 1, 1, 0 }, flow,
                                                                   varied, slope);
    if (fabs(defect) > fmin(sqrt(tolerance), bound) || jlt_varied_is_kept(flow->field, varied)) self->is[lane] = DOUBTED;
    if (self->is[lane] == DOUBTED) return;
    memcpy(out->q + point * d, q, d * sizeof *q);
    jlt_map_return_restore(slope, flow->chart);
    add(self, point,
        &(jlt_map_batch_return){ out->q + point * d, slope, arrival.flux_determinant, ldexp(t, flow->units.time),
                                 varied[n * (1 + d)] },
        arrival.determinant, defect, bound);
}

/* A return is stored once its lane has ended: until then its steps may prove to err. */
static int keep_row(void *context, size_t lane, size_t number, const double *x)
{
    const worker *self = context;

    (void)number;
    memcpy(self->starts + lane * self->batch->columns, x, self->batch->columns * sizeof *x);
    self->is[lane] = BACK;
    return 0;
}

static int keep_end(void *context, size_t lane, jlt_lane_end end, size_t returns, const double *x)
{
    const worker *self = context;

    (void)returns;
    if (end == JLT_LANE_DONE) return 0;
    memcpy(self->starts + lane * self->batch->columns, x, self->batch->columns * sizeof *x);
    self->is[lane] = end == JLT_LANE_DOUBTED ? DOUBTED : ON_WAY;
    return 0;
}

/* Follow the orbit of a lane that ended early on to its return, alone. */
static void go_on(worker *self, size_t lane)
{
    double *varied = self->starts + lane * self->batch->columns, t = 0;
    jlt_status st = alone(self, self->point[lane]);

    if (st == JLT_OK) st = jlt_map_resume(self->alone, varied, &t, self->direction);
    self->out->status[self->point[lane]] = st;
    if (st == JLT_OK) arrive(self, lane, varied[self->batch->columns - 1] + t);
}

/* Make one return of a point alone, where lanes do not serve. */
static void go_alone(worker *self, size_t point)
{
    const jlt_map_images *out = self->out;
    const unsigned d = flow_of(self, point)->chart->dim;
    jlt_image image;

    out->status[point] = alone(self, point);
    if (out->status[point] == JLT_OK)
        out->status[point] = jlt_map_apply(self->alone, &image, out->q + point * d, 1, self->direction);
    if (out->status[point] != JLT_OK) return;
    memcpy(out->q + point * d, image.q, d * sizeof *image.q);
    add(self, point, &(jlt_map_batch_return){ out->q + point * d, image.slope, image.flux_determinant, image.T, image.expansion },
        image.determinant, image.defect, image.bound);
}

/* Whether a point goes in the direction being computed, and has more than `number` returns to make. */
static bool is_due(const worker *self, size_t point, size_t number)
{
    const request *wanted = self->wanted;

    if (wanted->directions != NULL && wanted->directions[point] != self->direction) return false;
    return number < (wanted->each != NULL ? wanted->each[point] : wanted->returns);
}

/* Fill lanes with the varied states of those of the points first .. first + count - 1 that are due; a point without a state gets
 * the lift's status. Returns the number of lanes. */
static size_t lift(const worker *self, size_t first, size_t count, size_t number)
{
    const jlt_map_images *out = self->out;
    const unsigned d = self->batch->flows->chart->dim, columns = self->batch->columns;
    size_t lanes = 0;

    for (size_t i = first; i < first + count; i++) {
        double *start = self->starts + lanes * columns;
        if (out->status[i] != JLT_OK || !is_due(self, i, number)) continue;
        out->status[i] = jlt_map_return_start(start, &self->flux[lanes], flow_of(self, i), out->q + i * d, self->direction);
        if (out->status[i] != JLT_OK) continue;
        start[columns - 1] = 0;
        self->is[lanes] = AWAY;
        self->case_of[lanes] = flow_index(self, i);
        self->point[lanes++] = i;
        out->status[i] = JLT_ERR_NO_CONVERGENCE; /* until it has its return */
    }
    return lanes;
}

static jlt_status one_return(worker *self, size_t first, size_t count, size_t number)
{
    jlt_batch_map map = self->batch->map;

    map.backwards = self->direction < 0;
    map.case_of = self->case_of;
    for (size_t i = first; map.kernels == NULL && i < first + count; i++)
        if (self->out->status[i] == JLT_OK && is_due(self, i, number)) go_alone(self, i);
    if (map.kernels == NULL) return JLT_OK;
    const size_t lanes = lift(self, first, count, number);
    if (lanes == 0) return JLT_OK;
    const jlt_status st = jlt_batch_section(&map, self->starts, lanes, 1, keep_row, keep_end, self, NULL);
    for (size_t lane = 0; st == JLT_OK && lane < lanes; lane++) {
        if (self->is[lane] == BACK) arrive(self, lane, self->starts[(lane + 1) * self->batch->columns - 1]);
        if (self->is[lane] == ON_WAY) go_on(self, lane);
        if (self->is[lane] == DOUBTED) go_alone(self, self->point[lane]);
    }
    return st;
}

/* Make all returns of a block in one direction of time. */
static jlt_status follow(worker *self, size_t first, size_t count, int direction)
{
    jlt_status st = JLT_OK;

    self->direction = direction;
    for (size_t number = 0; number < self->wanted->returns && st == JLT_OK; number++) st = one_return(self, first, count, number);
    return st;
}

/* Take blocks of points until *next, shared by the threads, has passed the last point. */
static jlt_status work(worker *self, size_t count, size_t block, size_t *next)
{
    jlt_status st = JLT_OK;

    for (;;) {
        const size_t first = __atomic_fetch_add(next, block, __ATOMIC_RELAXED),
                     size = count - first < block ? count - first : block;
        if (first >= count || st != JLT_OK) return st;
        for (int way = 1; way >= -1 && st == JLT_OK; way -= 2)
            if (self->wanted->directions != NULL || way == self->wanted->direction) st = follow(self, first, size, way);
    }
}

const jlt_flow *jlt_map_batch_flow(const jlt_map_batch *self) { return self->flows; }

double jlt_map_batch_tolerance(const jlt_map_batch *self) { return self->map.tolerance; }

static jlt_status apply(jlt_map_batch *self, const jlt_map_images *out, const double *q, size_t count, const request *wanted)
{
    const unsigned d = self->flows->chart->dim;
    const unsigned threads = count < self->threads ? (unsigned)count : self->threads;
    const size_t share = (count + self->threads - 1) / self->threads, block = share < BLOCK ? share : BLOCK;
    size_t next = 0;
    int failure = JLT_OK;

    for (size_t i = 0; i < count; i++) {
        const int way = wanted->directions != NULL ? wanted->directions[i] : wanted->direction;
        if ((way != 1 && way != -1) || (wanted->flow_of != NULL && wanted->flow_of[i] >= self->flow_count)) return JLT_ERR_ARG;
    }
    if (count == 0) return JLT_OK;
    memmove(out->q, q, count * d * sizeof *q);
    for (size_t i = 0; i < count; i++) {
        for (unsigned k = 0; k < d * d; k++) out->slope[i * d * d + k] = k % (d + 1) == 0;
        out->T[i] = out->expansion[i] = out->defect[i] = 0;
        out->determinant[i] = 1;
        out->status[i] = JLT_OK;
    }
#if defined(_OPENMP)
#pragma omp parallel for num_threads((int)threads) schedule(static, 1) reduction(max : failure)
#endif
    for (unsigned thread = 0; thread < threads; thread++) {
        worker *w = &self->workers[thread];
        w->out = out;
        w->wanted = wanted;
        const int st = (int)work(w, count, block, &next);
        if (st > failure) failure = st;
    }
    return (jlt_status)failure;
}

jlt_status jlt_map_batch_apply(jlt_map_batch *self, const jlt_map_images *out, const double *q, size_t count, size_t returns,
                               int time_direction)
{
    return returns == 0 ? JLT_ERR_ARG : apply(self, out, q, count, &(request){ .returns = returns, .direction = time_direction });
}

jlt_status jlt_map_batch_apply_each(jlt_map_batch *self, const jlt_map_images *out, const double *q, size_t count,
                                    const size_t *returns, const int *time_direction)
{
    size_t most = 0;

    for (size_t i = 0; i < count; i++)
        if (returns[i] > most) most = returns[i];
    return apply(self, out, q, count, &(request){ .returns = most, .each = returns, .directions = time_direction });
}

jlt_status jlt_map_batch_apply_flows(jlt_map_batch *self, const jlt_map_images *out, const double *q, const size_t *flow_of,
                                     size_t count, size_t returns, jlt_map_batch_observer observer, void *context)
{
    return returns == 0 ? JLT_ERR_ARG
                        : apply(self, out, q, count, &(request){ returns, flow_of, NULL, 1, NULL, observer, context });
}
