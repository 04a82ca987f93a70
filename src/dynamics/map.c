#include "dynamics/map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/chart_crossing.h"
#include "dynamics/jump.h"
#include "dynamics/linear.h"
#include "dynamics/map_return.h"
#include "dynamics/passage.h"
#include "dynamics/varied.h"
#include "integrate/rest.h"

/* An orbit whose lifted root is below this does not come back: orbits that only graze a pole stay far above it. */
static const double root_floor = 1e-13;

struct jlt_map {
    jlt_flow flow;
    jlt_varied varied;
    jlt_orbit *orbit;
    jlt_section *section; /* for returns without derivative */
    bool is_slow;         /* as `watch` found last */
    jlt_jump_watch jump;
    bool keeps;           /* jlt_passage_keep after every step */
    double most, least;   /* largest and smallest size of a tangent vector on the way; 1 is counted too */
    double swing;         /* largest |integral of the divergence| on the way, at least 1 */
    size_t steps;         /* of the stepper before the return */
    jlt_section_conditions watched; /* the model's conditions since jlt_map_watch */
    jlt_image image;      /* of the returns so far */
};

/* Called after every step. Returns 1 if the orbit never comes back to the section, as it falls into a pole or comes to rest, or if
 * tangent vectors are lost where a rate jumps. */
static int watch(void *context, jlt_orbit *orbit)
{
    enum { SLOW_STEPS = 64 };                 /* between two tests of slowness: some turns of a spiral */
    static const double surroundings = 1e-3; /* an orbit farther than this from any equilibrium comes back, however slow it is */
    jlt_map *self = context;
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    const int root = self->flow.field->root;

    for (unsigned k = 1; k <= self->flow.chart->dim; k++) {
        double size = 0;
        for (unsigned i = 0; i < self->flow.field->dim; i++) size = fmax(size, fabs(stepper->x[k * self->flow.field->dim + i]));
        self->most = fmax(self->most, size);
        self->least = fmin(self->least, size);
    }
    self->swing = fmax(self->swing, fabs(stepper->x[self->varied.field.dim - 1]));
    if (self->watched.observed != NULL) jlt_section_conditions_step(&self->watched, orbit);
    if (root >= 0 && fabs(stepper->x[root]) < root_floor) return 1;
    if (jlt_jump_is_behind(&self->jump, stepper, &self->varied)) return 1;
    if (self->keeps && jlt_passage_keep(orbit, &self->varied) != JLT_OK) return 1;
    if (stepper->steps % SLOW_STEPS != 0) return 0;
    if (jlt_rest_is_ahead(stepper, self->flow.chart->column, self->flow.chart->level)) return 0;
    const bool was_slow = self->is_slow;
    self->is_slow = jlt_rest_is_slower(self->flow.field, stepper->x, stepper->size, jlt_rest_slow(stepper->asked),
                                       stepper->direction)
                    && jlt_approach_is_near(self->flow.field, stepper->x, stepper->size, surroundings);
    return was_slow && self->is_slow;
}

jlt_status jlt_map_create(jlt_map **out, const jlt_flow *flow)
{
    JLT_OWNED(jlt_map) *self = NULL;

    *out = NULL;
    if (flow == NULL || flow->chart == NULL || flow->field == NULL || flow->chart->states != flow->field->dim) return JLT_ERR_ARG;
    self = malloc(sizeof *self); /* sections of few coordinates leave most of it untouched */
    if (self == NULL) return JLT_ERR_NOMEM;
    self->orbit = NULL;
    self->section = NULL;
    self->jump = (jlt_jump_watch){ 0 };
    self->varied.spread = NULL;
    self->flow = *flow;
    if (self->flow.method == NULL) self->flow.method = jlt_method_find(NULL);
    if (self->flow.max_steps == 0) self->flow.max_steps = 100000;
    JLT_PASS(jlt_varied_make(&self->varied, self->flow.field, self->flow.rhs_jacobian, self->flow.chart->dim));
    /* The varied field has no jet. */
    JLT_PASS(jlt_orbit_create(&self->orbit, self->flow.method->needs_jet ? jlt_method_find(NULL) : self->flow.method,
                              &self->varied.field,
                              &(jlt_options){
                                  .tolerance = flow->tolerance, .max_steps = self->flow.max_steps, .interrupt = flow->interrupt }));
    jlt_orbit_observe(self->orbit, watch, self);
    jlt_map_watch(self, NULL);
    JLT_PASS(jlt_section_create(&self->section, &self->flow));
    *out = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

void jlt_map_destroy(jlt_map *self)
{
    if (self == NULL) return;
    jlt_orbit_destroy(self->orbit);
    jlt_section_destroy(self->section);
    jlt_varied_clear(&self->varied);
    free(self);
}

const jlt_flow *jlt_map_flow(const jlt_map *self)
{
    return &self->flow;
}

void jlt_map_watch(jlt_map *self, const jlt_observed *observed)
{
    self->watched = (jlt_section_conditions){ .observed = observed, .looks_within = true };
    jlt_section_conditions_begin(&self->watched);
}

jlt_section_least jlt_map_least(const jlt_map *self) { return self->watched.so_far; }

static jlt_status to_section(jlt_map *self, jlt_outcome *outcome, const double *start, int time_direction)
{
    jlt_event events[JLT_CHART_EVENTS_MAX];
    const unsigned count = jlt_chart_events(self->flow.chart, events, self->flow.direction);
    const jlt_crossing_search search = { self->flow.chart, self->flow.direction, events, count, count, self->varied.field.dim,
                                         self->flow.max_steps };
    const double t_max = self->flow.t_max == 0 ? INFINITY : ldexp(self->flow.t_max, -self->flow.units.time);

    jlt_varied_begin(&self->varied, start);
    JLT_PASS(jlt_orbit_start(self->orbit, 0, start, time_direction));
    if (self->keeps) JLT_PASS(jlt_passage_keep(self->orbit, &self->varied));
    jlt_section_conditions_turn(&self->watched);
    jlt_section_conditions_arrive(&self->watched, 0, start);
    self->is_slow = false;
    self->most = self->least = self->swing = 1;
    self->steps = jlt_orbit_stepper(self->orbit)->steps;
    JLT_PASS(jlt_chart_crossing_find(&search, self->orbit, time_direction * t_max, time_direction, outcome));
    if (outcome->end == JLT_END_EVENT) {
        jlt_section_conditions_arrive(&self->watched, outcome->crossing.theta, outcome->x);
        return JLT_OK;
    }
    if (outcome->end == JLT_END_TIME) return JLT_ERR_BUDGET;
    return outcome->end == JLT_END_OBSERVER ? JLT_ERR_DOMAIN : JLT_ERR_NO_CONVERGENCE;
}

/* Follow the orbit to the section; if tangent vectors were much longer on the way than at the end, do it again, so that they keep
 * digits. */
static jlt_status follow(jlt_map *self, jlt_outcome *outcome, const double *start, int time_direction)
{
    static const double far = 64; /* ordinary returns have ratios of 1 to 3, passages close to a singularity of 1e3 to 1e12 */
    const unsigned n = self->flow.field->dim;
    double left = 1;

    self->keeps = false;
    JLT_PASS(to_section(self, outcome, start, time_direction));
    for (unsigned i = n; i < n * (1 + self->flow.chart->dim); i++) left = fmax(left, fabs(outcome->x[i]));
    if (!(self->most > far * left)) return JLT_OK;
    self->keeps = true;
    if (to_section(self, outcome, start, time_direction) == JLT_OK) return JLT_OK;
    self->keeps = false;
    return to_section(self, outcome, start, time_direction);
}

/* Sizes on the way to the return whose varied orbit ends in `end`, for its bound. */
static jlt_map_return_steps steps_of(const jlt_map *self, const double *end)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(self->orbit);
    const unsigned n = self->flow.chart->states, c = self->flow.chart->column;
    double both[JLT_CHART_STATES_MAX * (1 + JLT_CHART_STATES_MAX)], gradient = 0;

    jlt_varied_linear(&self->varied, end, both);
    for (unsigned i = 0; i < n; i++) gradient += fabs(both[n + c * n + i]) * fmax(stepper->size, fabs(end[i]));
    return (jlt_map_return_steps){ stepper->asked * (double)(stepper->steps - self->steps), self->most / self->least, self->swing,
                                   gradient };
}

/* Make one return with derivative, and multiply it onto what `image` holds. */
static jlt_status advance(jlt_map *self, jlt_image *image, int time_direction)
{
    const unsigned n = self->flow.chart->states, d = self->flow.chart->dim;
    double start[JLT_VARIED_DIM_MAX], slope[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX], flux;
    jlt_map_return arrival;
    jlt_outcome outcome;

    JLT_PASS(jlt_map_return_start(start, &flux, &self->flow, image->q, time_direction));
    JLT_PASS(follow(self, &outcome, start, time_direction));
    JLT_PASS(jlt_map_return_end(&arrival, image->q, slope, &self->flow, outcome.x, flux));
    const double size = arrival.size > 0 ? arrival.size : 1; /* a DP that is 0 in doubles has no defect */
    const double defect = (fabs(arrival.determinant) - arrival.flux_determinant) / size;
    const jlt_map_return_steps steps = steps_of(self, outcome.x);
    const double bound = jlt_map_return_bound(&arrival, &steps, &self->flow, outcome.x, slope);
    if (image->bound == 0 || fabs(defect) * image->bound > fabs(image->defect) * bound) {
        image->defect = defect;
        image->bound = bound;
    }
    jlt_map_return_restore(slope, self->flow.chart);
    jlt_linear_multiply(image->slope, slope, image->slope, d);
    image->T += ldexp(outcome.t, self->flow.units.time);
    image->expansion += outcome.x[n * (1 + d)];
    image->determinant *= arrival.determinant;
    image->flux_determinant *= arrival.flux_determinant;
    for (unsigned i = 0; i < n; i++) image->x[i] = ldexp(outcome.x[i], self->flow.units.state[i]);
    return JLT_OK;
}

jlt_status jlt_map_resume(jlt_map *self, double *x, double *t, int time_direction)
{
    jlt_outcome outcome;

    JLT_PASS(follow(self, &outcome, x, time_direction));
    memcpy(x, outcome.x, self->varied.field.dim * sizeof *x);
    *t = outcome.t;
    return JLT_OK;
}

/* Copy the part of an image that is in use: it has room for many coordinates. */
static void copy_image(jlt_image *out, const jlt_image *image, const jlt_chart *chart)
{
    const unsigned d = chart->dim;

    memcpy(out->q, image->q, d * sizeof *out->q);
    memcpy(out->slope, image->slope, (size_t)d * d * sizeof *out->slope);
    memcpy(out->x, image->x, chart->states * sizeof *out->x);
    out->T = image->T;
    out->determinant = image->determinant;
    out->flux_determinant = image->flux_determinant;
    out->expansion = image->expansion;
    out->defect = image->defect;
    out->bound = image->bound;
}

jlt_status jlt_map_apply(jlt_map *self, jlt_image *out, const double *q, size_t count, int time_direction)
{
    const unsigned d = self->flow.chart->dim;
    jlt_image *image = &self->image;

    if (count == 0) return JLT_ERR_ARG;
    memcpy(image->q, q, d * sizeof *q);
    for (size_t i = 0; i < (size_t)d * d; i++) image->slope[i] = i % (d + 1) == 0;
    image->T = image->expansion = image->defect = image->bound = 0;
    image->determinant = image->flux_determinant = 1;
    for (size_t i = 0; i < count; i++) JLT_PASS(advance(self, image, time_direction));
    copy_image(out, image, self->flow.chart);
    return JLT_OK;
}

jlt_status jlt_map_point(jlt_map *self, jlt_image *out, const double *q, size_t count, int time_direction)
{
    const unsigned d = self->flow.chart->dim;
    jlt_return row;

    if (count == 0) return JLT_ERR_ARG;
    JLT_PASS(jlt_section_start(self->section, &row, q, time_direction));
    for (size_t i = 0; i < count; i++) {
        JLT_PASS(jlt_section_next(self->section, &row));
        if (row.interrupted) return JLT_ERR_NO_CONVERGENCE;
        JLT_PASS(jlt_section_fate_status(row.fate));
    }
    memcpy(out->q, row.q, d * sizeof *q);
    memcpy(out->x, row.x, self->flow.chart->states * sizeof *out->x);
    out->T = row.t;
    for (size_t i = 0; i < (size_t)d * d; i++) out->slope[i] = NAN;
    out->determinant = out->flux_determinant = out->expansion = out->defect = out->bound = NAN;
    return JLT_OK;
}
