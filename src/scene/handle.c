#include "scene/handle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "kernel/descriptor.h"
#include "kernel/load.h"
#include "kernel/region.h"
#include "scene/course.h"
#include "dynamics/surface.h"

struct jlt_handle_section {
    jlt_system *system;
    jlt_section *section;
    bool started;
    jlt_return at; /* the last return */
};

struct jlt_handle_motion {
    const jlt_descriptor *model;
    double *params; /* (model->param_count,), owned */
    double tolerance;
    jlt_course *course; /* NULL: no orbit was started */
    jlt_fate fate;
    bool ended;
};

/* Find the model, and check that names and values are given, each name once. */
static jlt_status find_model(const jlt_descriptor **out, const char *model, const char *const *names, const double *values,
                             size_t count)
{
    if (model == NULL || (count > 0 && (names == NULL || values == NULL))) return JLT_ERR_ARG;
    for (size_t i = 0; i < count; i++) {
        if (names[i] == NULL) return JLT_ERR_ARG;
        for (size_t k = 0; k < i; k++)
            if (strcmp(names[i], names[k]) == 0) return JLT_ERR_ARG;
    }
    if (strchr(model, '/') != NULL) return jlt_load(out, model);
    *out = jlt_descriptor_find(model, NULL, NULL, NULL);
    return *out != NULL ? JLT_OK : JLT_ERR_ARG;
}

/* The table's default parameters, replaced by the given values, and checked; for the caller to free(). */
static jlt_status read_params(double **out, const jlt_descriptor *d, const char *const *names, const double *values, size_t count)
{
    JLT_FREED double *params = jlt_memory_array(d->param_count, sizeof *params);
    double value;
    const jlt_region *region;
    size_t index;

    if (params == NULL) return JLT_ERR_NOMEM;
    for (unsigned i = 0; i < d->param_count; i++) params[i] = d->params[i].value;
    for (size_t i = 0; i < count; i++) {
        if (!jlt_descriptor_param(d, names[i], &index)) return JLT_ERR_ARG;
        params[index] = values[i];
    }
    JLT_PASS(jlt_descriptor_check_params(d, params, &index));
    JLT_PASS(jlt_region_check(&region, &value, d, params, NULL));
    *out = params;
    params = NULL;
    return JLT_OK;
}

/* ---- returns to a section ---- */

/* Takes ownership of the system, also on failure. */
static jlt_status open_section(jlt_handle_section **out, jlt_system *system)
{
    jlt_handle_section *self = calloc(1, sizeof *self);
    jlt_status st = JLT_ERR_NOMEM;

    if (self == NULL) {
        jlt_system_destroy(system);
        return st;
    }
    self->system = system;
    JLT_TRY(jlt_section_create(&self->section, &system->flow));
    *out = self;
    self = NULL;
done:
    jlt_handle_section_destroy(self);
    return st;
}

jlt_status jlt_handle_section_known(jlt_handle_section **out, const char *model, const char *const *names, const double *values,
                                    size_t count, double tolerance)
{
    const jlt_flow options = { .tolerance = tolerance, .direction = JLT_RISING };
    const jlt_descriptor *d;
    const jlt_claim *broken;
    jlt_surface surface;
    double all[JLT_CHART_VALUES_MAX];
    jlt_system *system = NULL;

    if (out == NULL) return JLT_ERR_ARG;
    *out = NULL;
    JLT_PASS(find_model(&d, model, names, values, count));
    JLT_PASS(jlt_surface_find(&surface, &broken, d, NULL, NULL));
    if (broken != NULL) return JLT_ERR_UNSUPPORTED;
    memcpy(all, surface.defaults, surface.count * sizeof *all);
    for (size_t i = 0; i < count; i++) {
        const unsigned index = jlt_surface_value(&surface, names[i]);
        if (index == surface.count) return JLT_ERR_ARG;
        all[index] = values[i];
    }
    JLT_PASS(jlt_surface_system(&system, &surface, all, &options));
    return open_section(out, system);
}

/* Make the states angles that the table proves to be periodic. */
static jlt_status set_angles(jlt_system *system, const jlt_descriptor *d)
{
    double periods[JLT_CHART_STATES_MAX] = { 0 }; /* lifted roots have none */
    bool has_angles = false;
    unsigned state;

    for (unsigned i = 0; i < d->state_count; i++) {
        periods[i] = jlt_descriptor_proves(d, "periodic", d->states[i].name) ? d->states[i].period : 0;
        has_angles = has_angles || periods[i] != 0;
    }
    return has_angles ? jlt_system_angles(system, periods, &state) : JLT_OK;
}

jlt_status jlt_handle_section_plane(jlt_handle_section **out, const char *model, const char *state, double level, int direction,
                                    const char *const *names, const double *values, size_t count, double tolerance)
{
    const jlt_flow options = { .tolerance = tolerance,
                               .direction = direction > 0 ? JLT_RISING : direction < 0 ? JLT_FALLING : JLT_BOTH };
    const jlt_descriptor *d;
    JLT_FREED double *params = NULL;
    JLT_OWNED(jlt_system) *system = NULL;
    size_t column;

    if (out == NULL) return JLT_ERR_ARG;
    *out = NULL;
    JLT_PASS(find_model(&d, model, names, values, count));
    if (direction < -1 || direction > 1 || state == NULL || !jlt_descriptor_state(d, state, &column)) return JLT_ERR_ARG;
    if (!(level > d->states[column].low && level < d->states[column].high)) return isfinite(level) ? JLT_ERR_DOMAIN : JLT_ERR_ARG;
    JLT_PASS(read_params(&params, d, names, values, count));
    JLT_PASS(jlt_system_plane(&system, jlt_system_regular(d), params, (unsigned)column, level, NULL, &options));
    JLT_PASS(set_angles(system, d));
    const jlt_status st = open_section(out, system);
    system = NULL;
    return st;
}

void jlt_handle_section_destroy(jlt_handle_section *self)
{
    if (self == NULL) return;
    jlt_section_destroy(self->section);
    jlt_system_destroy(self->system);
    free(self);
}

unsigned jlt_handle_section_dim(const jlt_handle_section *self)
{
    return self != NULL ? self->system->flow.chart->dim : 0;
}

const char *jlt_handle_section_coordinate(const jlt_handle_section *self, unsigned index)
{
    return index < jlt_handle_section_dim(self) ? self->system->flow.chart->names[index] : NULL;
}

unsigned jlt_handle_section_columns(const jlt_handle_section *self)
{
    return self != NULL && self->system->surface != NULL ? self->system->surface->section->beside_count : 0;
}

const char *jlt_handle_section_column(const jlt_handle_section *self, unsigned index)
{
    return index < jlt_handle_section_columns(self) ? self->system->surface->section->beside[index].name : NULL;
}

/* Choose the units of the problem for a start at q, and make the section in them. */
static jlt_status count(jlt_handle_section *self, const double *q)
{
    const jlt_chart *chart = self->system->flow.chart;
    double sizes[JLT_CHART_STATES_MAX] = { 0 };

    for (unsigned i = 0; i < chart->states; i++)
        if (jlt_chart_is_coordinate(chart, i)) sizes[i] = fabs(*q++);
    sizes[chart->column] = fabs(self->system->chart.plane.level);
    jlt_section_destroy(self->section);
    self->section = NULL;
    JLT_PASS(jlt_system_count(self->system, sizes));
    return jlt_section_create(&self->section, &self->system->flow);
}

jlt_status jlt_handle_section_start(jlt_handle_section *self, const double *q, int time_direction)
{
    if (self == NULL || q == NULL) return JLT_ERR_ARG;
    self->started = false;
    if (self->system->surface == NULL) JLT_PASS(count(self, q));
    JLT_PASS(jlt_section_start(self->section, &self->at, q, time_direction));
    self->started = true;
    return JLT_OK;
}

/* Write the last return into arrays; columns may be NULL. */
static void tell_row(const jlt_handle_section *self, double *q, double *t, double *columns)
{
    double off[JLT_CHART_DIM_MAX];

    *t = self->at.t;
    memcpy(q, self->at.q, jlt_handle_section_dim(self) * sizeof *q);
    if (self->system->surface == NULL) return;
    jlt_surface_off_section(off, self->system, self->at.x);
    for (unsigned k = 0; k < jlt_handle_section_dim(self); k++)
        if (isnan(q[k])) q[k] = off[k];
    if (columns != NULL) jlt_surface_beside(columns, self->system, self->at.x);
}

jlt_status jlt_handle_section_returns(jlt_handle_section *self, double *q, double *t, double *columns, size_t *done, int *fate,
                                      size_t count)
{
    const size_t dim = jlt_handle_section_dim(self), width = jlt_handle_section_columns(self);

    if (done == NULL || fate == NULL) return JLT_ERR_ARG;
    *done = 0;
    if (self == NULL || !self->started || (count > 0 && (q == NULL || t == NULL))) return JLT_ERR_ARG;
    while (*done < count && self->at.fate == JLT_FATE_ALIVE) {
        JLT_PASS(jlt_section_next(self->section, &self->at));
        tell_row(self, q + *done * dim, t + *done, columns != NULL ? columns + *done * width : NULL);
        ++*done;
    }
    *fate = (int)self->at.fate;
    return JLT_OK;
}

/* ---- states at times ---- */

jlt_status jlt_handle_motion_create(jlt_handle_motion **out, const char *model, const char *const *names, const double *values,
                                    size_t count, double tolerance)
{
    jlt_handle_motion *self = NULL;
    jlt_status st = JLT_ERR_NOMEM;

    if (out == NULL) return JLT_ERR_ARG;
    *out = NULL;
    self = calloc(1, sizeof *self);
    if (self == NULL) return st;
    self->tolerance = tolerance;
    st = JLT_ERR_ARG;
    if (!(tolerance >= 0 && tolerance < 1)) goto done;
    JLT_TRY(find_model(&self->model, model, names, values, count));
    st = JLT_ERR_UNSUPPORTED;
    if (self->model->state_count > JLT_PLAN_STATES_MAX || self->model->param_count > JLT_PLAN_PARAMS_MAX) goto done;
    JLT_TRY(read_params(&self->params, self->model, names, values, count));
    *out = self;
    self = NULL;
done:
    jlt_handle_motion_destroy(self);
    return st;
}

void jlt_handle_motion_destroy(jlt_handle_motion *self)
{
    if (self == NULL) return;
    jlt_course_destroy(self->course);
    free(self->params);
    free(self);
}

unsigned jlt_handle_motion_dim(const jlt_handle_motion *self)
{
    return self != NULL ? self->model->state_count : 0;
}

const char *jlt_handle_motion_state(const jlt_handle_motion *self, unsigned index)
{
    return index < jlt_handle_motion_dim(self) ? self->model->states[index].name : NULL;
}

jlt_status jlt_handle_motion_start(jlt_handle_motion *self, const double *x)
{
    const jlt_region *region;
    jlt_plan plan;
    double value;
    size_t index;

    if (self == NULL || x == NULL) return JLT_ERR_ARG;
    const jlt_question question = { .model = self->model, .params = self->params, .start = x };
    const jlt_course_options options = { .tolerance = self->tolerance };
    jlt_course_destroy(self->course);
    self->course = NULL;
    self->ended = false;
    self->fate = JLT_FATE_ALIVE;
    JLT_PASS(jlt_descriptor_check_state(self->model, x, &index));
    JLT_PASS(jlt_region_check(&region, &value, self->model, self->params, x));
    JLT_PASS(jlt_plan_make(&plan, &question));
    return jlt_course_create(&self->course, &plan, &question, &options);
}

/* Set the orbit's fate from a row. st: the status of the call that made the row. Returns false if st is an error of the call and
 * not a fate of the orbit. */
static bool note_fate(jlt_handle_motion *self, const jlt_course_row *row, jlt_status st)
{
    jlt_fate failure;

    if (st != JLT_OK && (row->x == NULL || !jlt_section_fate_of(&failure, st))) return false;
    self->ended = st != JLT_OK || row->end == JLT_END_POLE;
    if (st != JLT_OK) self->fate = failure;
    else if (self->ended) self->fate = row->fate;
    else self->fate = isnan(row->lost_at) ? JLT_FATE_ALIVE : JLT_FATE_INVALID;
    return true;
}

jlt_status jlt_handle_motion_states(jlt_handle_motion *self, double *x, double *t, size_t *done, int *fate, const double *times,
                                    size_t count)
{
    const size_t dim = jlt_handle_motion_dim(self);
    jlt_course_row row;
    jlt_status st = JLT_OK;

    if (done == NULL || fate == NULL) return JLT_ERR_ARG;
    *done = 0;
    if (self == NULL || self->course == NULL || (count > 0 && (x == NULL || t == NULL || times == NULL))) return JLT_ERR_ARG;
    while (*done < count && !self->ended && st == JLT_OK) {
        st = isfinite(times[*done]) ? jlt_course_to(self->course, times[*done], &row) : JLT_ERR_NONFINITE;
        if (!isfinite(times[*done]) || !note_fate(self, &row, st)) break;
        st = JLT_OK;
        memcpy(x + *done * dim, row.x, dim * sizeof *x);
        t[*done] = row.t;
        ++*done;
    }
    *fate = (int)self->fate;
    return st;
}
