#include "cli/fates_crowd.h"

#include <stdlib.h>
#include <string.h>

#include "cli/fates_table.h"

/* For each thread: BLOCK, orbits followed together, so many that lanes rarely idle while the last ones end; PLACES, the most
 * systems that these belong to, about 20 kB each. */
enum { BLOCK = 4096, PLACES = 512 };

const char *jlt_fates_crowd_grid(const jlt_motion_options *motion, const jlt_system *system)
{
    return motion->grid != NULL ? motion->grid : motion->start_count > 0 || system->surface == NULL ? NULL : motion->other;
}

static jlt_fates_crowd_place *last_of(const jlt_fates_crowd *self) { return &self->places[self->place_count - 1]; }

/* Compare the integrals that are proved at both ends of the orbit from start i of the block. */
static jlt_status compare_levels(jlt_fates_crowd *self, size_t i, const double *q, const jlt_return *last)
{
    jlt_fates_crowd_place *place = &self->places[self->place_of[i]];
    jlt_section_levels *levels = &place->levels;
    const jlt_chart *chart = place->system->flow.chart;
    const double share = levels->worst.share;
    FILE *words;
    jlt_return start;

    if (levels->system == NULL) JLT_PASS(jlt_section_levels_open(levels, place->system, q));
    JLT_PASS(jlt_section_batch_start(self->batch, &start, i));
    (void)jlt_section_levels_note(levels, self->index[i], &start);
    if (!jlt_section_levels_note(levels, self->index[i], last)) return JLT_OK;
    self->strayed++;
    if (!(levels->worst.share > share)) return JLT_OK;
    if ((words = fmemopen(self->farthest, sizeof self->farthest, "w")) == NULL) return JLT_ERR_NOMEM;
    fprintf(words, "%s by %.2g from ", place->system->instance->descriptor->integrals[levels->worst.integral].name,
            levels->worst.change);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(words, "%s%s=%.10g", k > 0 ? "," : "", chart->names[k], q[k]);
    (void)fclose(words);
    return JLT_OK;
}

/* Count how the orbit from start i of the block ended, and write its row. */
static jlt_exit count_start(jlt_fates_crowd *self, size_t i)
{
    const jlt_motion_options *motion = self->motion;
    jlt_fates_crowd_place *place = &self->places[self->place_of[i]];
    const double *q = self->q + i * place->system->flow.chart->dim;
    jlt_return last;
    jlt_status st = jlt_section_batch_last(self->batch, &last, i);

    if ((self->done != NULL || self->index[i] >= motion->start_count) && (st == JLT_ERR_EMPTY || st == JLT_ERR_DOMAIN)) {
        place->sum.empty++;
        return JLT_EXIT_DONE;
    }
    if (st == JLT_OK && !last.interrupted) st = compare_levels(self, i, q, &last);
    if (st != JLT_OK)
        return jlt_motion_fail(st, place->system,
                               self->index[i] < motion->start_count ? motion->starts[self->index[i]] : "a start of the grid");
    if (last.interrupted) return JLT_EXIT_DONE;
    const jlt_fates_end end = jlt_fates_of(&last);
    jlt_shares_add(&place->sum, place->system, q, &end);
    if (self->rows != NULL) jlt_fates_table_row(self->rows, motion, place->system, q, &end);
    if (self->map != NULL) jlt_motion_map_add(self->map, q, (double)end.fate);
    return JLT_EXIT_DONE;
}

/* Create a batch for the last system alone. */
static jlt_exit open_batch(jlt_fates_crowd *self)
{
    jlt_section_batch_options batch = { .last_only = true };

    last_of(self)->flow = 0;
    return jlt_motion_many_open(&self->batch, &batch, self->motion, last_of(self)->system);
}

/* Report and destroy the systems before `end`, whose starts are all counted, and the batch. */
static void let_go(jlt_fates_crowd *self, size_t end)
{
    jlt_section_batch_destroy(self->batch);
    self->batch = NULL;
    for (size_t k = 0; k < end; k++) {
        self->done(self->context, &self->places[k]);
        jlt_section_levels_close(&self->places[k].levels);
        jlt_system_destroy(self->places[k].system);
    }
    self->place_count -= end;
    memmove(self->places, self->places + end, self->place_count * sizeof *self->places);
}

/* Follow the starts of the block and count them. is_complete: the last system has no further starts. */
static jlt_exit follow_block(jlt_fates_crowd *self, bool is_complete)
{
    jlt_exit code = JLT_EXIT_DONE;

    if (self->count > 0) {
        for (size_t i = 0; i < self->count; i++) self->flow_of[i] = self->places[self->place_of[i]].flow;
        const jlt_status st = jlt_section_batch_run_each(self->batch, self->q, self->flow_of, NULL, self->count, self->returns);
        if (st != JLT_OK) return jlt_motion_fail(st, last_of(self)->system, "section");
    }
    for (size_t i = 0; code == JLT_EXIT_DONE && i < self->count; i++) code = count_start(self, i);
    self->followed += self->count;
    self->count = 0;
    jlt_progress_show(self->progress, self->followed, self->whole * self->each);
    if (code != JLT_EXIT_DONE || self->done == NULL || jlt_motion_interrupted(self->motion)) return code;
    let_go(self, is_complete ? self->place_count : self->place_count - 1);
    return self->place_count > 0 ? open_batch(self) : JLT_EXIT_DONE;
}

static jlt_exit make_room(jlt_fates_crowd *self, unsigned dim)
{
    self->room = BLOCK * self->motion->threads;
    self->place_room = PLACES * self->motion->threads;
    if (self->places == NULL) self->places = malloc(self->place_room * sizeof *self->places);
    if (self->place_of == NULL) self->place_of = malloc(3 * self->room * sizeof *self->place_of);
    if (self->q == NULL && dim > 0) self->q = malloc(self->room * dim * sizeof *self->q);
    if (self->places == NULL || self->place_of == NULL || (self->q == NULL && dim > 0)) return jlt_command_no_memory();
    self->index = self->place_of + self->room;
    self->flow_of = self->index + self->room;
    return JLT_EXIT_DONE;
}

/* Add the last system to the batch. If its kernels differ from the batch's, follow the starts of the others first. */
static jlt_exit join(jlt_fates_crowd *self)
{
    jlt_fates_crowd_place *place = last_of(self);

    if (self->batch == NULL) return open_batch(self);
    const jlt_status st = jlt_section_batch_add(self->batch, &place->flow, &place->system->flow, NULL);
    if (st == JLT_OK) return JLT_EXIT_DONE;
    return st == JLT_ERR_ARG ? follow_block(self, false) : jlt_motion_fail(st, place->system, "section");
}

jlt_exit jlt_fates_crowd_follow(jlt_fates_crowd *self, jlt_system *system, const double *values, size_t count)
{
    const jlt_motion_options *motion = self->motion;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    const unsigned dim = system != NULL ? system->flow.chart->dim : 0;
    jlt_exit code = make_room(self, dim);

    if (code == JLT_EXIT_DONE && self->place_count == self->place_room) code = follow_block(self, true);
    if (code != JLT_EXIT_DONE || jlt_motion_interrupted(motion)) {
        if (self->done != NULL) jlt_system_destroy(system);
        return code;
    }
    self->places[self->place_count++] = (jlt_fates_crowd_place){ .system = system };
    for (size_t k = 0; k < count; k++) last_of(self)->values[k] = values[k];
    if (system == NULL) return JLT_EXIT_DONE;
    const char *grid = jlt_fates_crowd_grid(motion, system);
    code = jlt_motion_axes(axes, system, grid, "--grid");
    if (code == JLT_EXIT_DONE) code = join(self);
    self->each = motion->start_count + (grid != NULL && code == JLT_EXIT_DONE ? jlt_motion_grid_size(axes, system) : 0);
    for (size_t i = 0; code == JLT_EXIT_DONE && i < self->each; i++) {
        if (self->count == self->room) code = follow_block(self, false);
        if (code != JLT_EXIT_DONE || jlt_motion_interrupted(motion)) break;
        self->place_of[self->count] = self->place_count - 1;
        self->index[self->count] = i;
        code = jlt_motion_any_start(self->q + self->count * dim, motion, axes, system, i);
        if (code == JLT_EXIT_DONE) self->count++;
    }
    return code;
}

jlt_exit jlt_fates_crowd_finish(jlt_fates_crowd *self)
{
    return self->place_count > 0 ? follow_block(self, true) : JLT_EXIT_DONE;
}

const jlt_shares *jlt_fates_crowd_sum(const jlt_fates_crowd *self) { return &last_of(self)->sum; }

void jlt_fates_crowd_tell(const jlt_fates_crowd *self, size_t starts)
{
    if (self->strayed == 0) return;
    fprintf(stderr, "jellett: on %zu of %zu orbits a proved integral changes by more than errors of one tolerance a step explain "
            "(a pass close to a singularity?), as %s: their fates may be others at a smaller --tol\n", self->strayed, starts,
            self->farthest);
}

void jlt_fates_crowd_close(jlt_fates_crowd *self)
{
    jlt_section_batch_destroy(self->batch);
    for (size_t k = 0; k < self->place_count; k++) {
        jlt_section_levels_close(&self->places[k].levels);
        if (self->done != NULL) jlt_system_destroy(self->places[k].system);
    }
    free(self->places);
    free(self->q);
    free(self->place_of);
}
