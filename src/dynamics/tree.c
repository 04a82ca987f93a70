#include "dynamics/tree.h"

#include <math.h>
#include <stdlib.h>

#include "core/memory.h"
#include "dynamics/continuation_step.h"

/* A bifurcation. */
typedef struct {
    jlt_continuation_point point;
    size_t branch, generation; /* on which it lies */
    bool followed; /* the branch that begins there has come up as the end of another */
} node;

typedef struct {
    const jlt_chart *chart;
    const jlt_family *family;
    const jlt_continuation_options *options;
    const jlt_tree_sink *sink;
    node *nodes; /* in order */
    size_t count;
    size_t branch, generation; /* under way */
    jlt_tree_end end;          /* of that branch */
} tree;

static jlt_status keep_node(tree *self, const jlt_continuation_point *point)
{
    if (!JLT_MEMORY_GROW(self->nodes, self->count)) return JLT_ERR_NOMEM;
    self->nodes[self->count++] = (node){ *point, self->branch, self->generation, false };
    return JLT_OK;
}

/* Whether two points are the same bifurcation, whichever point of the orbit each begins with. */
static bool same_bifurcation(const tree *self, const jlt_continuation_point *a, const jlt_continuation_point *b)
{
    return a->kind == b->kind && fabs(a->value - b->value) < 1e-7 * fmax(self->options->scale, fabs(a->value)) &&
           jlt_periodic_same(self->chart, &a->orbit, &b->orbit, 1e-5);
}

/* A branch that ends at a period doubling of another branch is the one that begins there: mark that doubling as followed. */
static void mark_followed(tree *self, const jlt_continuation_point *end)
{
    for (size_t i = 0; i < self->count; i++) {
        node *l = &self->nodes[i];
        if (l->point.kind == JLT_BIFURCATION_DOUBLING && 2 * l->point.orbit.period == end->orbit.period &&
            fabs(l->point.value - end->value) < 1e-4 * fmax(self->options->scale, fabs(end->value)) &&
            jlt_chart_distance(self->chart, l->point.orbit.points, end->orbit.points) < 1e-2)
            l->followed = true;
    }
}

static jlt_status take(void *context, const jlt_continuation_point *point)
{
    tree *self = context;

    for (size_t i = 0; point->kind != JLT_BIFURCATION_NONE && i < self->count; i++)
        if (self->nodes[i].branch != self->branch && same_bifurcation(self, &self->nodes[i].point, point)) {
            self->end.is_known = true;
            self->end.known = self->nodes[i].branch;
            return JLT_ERR_EMPTY; /* ends the run */
        }
    const jlt_status st = self->sink->point(self->sink->context, self->branch, point);
    return st != JLT_OK || point->kind == JLT_BIFURCATION_NONE ? st : keep_node(self, point);
}

/* Follow one branch from its first point to its end. */
static jlt_status run_branch(tree *self, const jlt_continuation_point *first, int direction,
                             const jlt_continuation_point *origin)
{
    jlt_tree_end *end = &self->end;

    *end = (jlt_tree_end){ .found = true, .branch = self->branch, .origin = origin };
    end->status = jlt_continuation_run(&end->end, self->family, first, direction, self->options, take, self);
    if (end->status == JLT_ERR_NOMEM || end->status == JLT_ERR_IO) return end->status;
    if (origin == NULL && end->status != JLT_OK) return end->status;
    self->sink->end(self->sink->context, end);
    if (end->status == JLT_OK && end->end == JLT_CONTINUATION_HALVED) mark_followed(self, &self->nodes[self->count - 1].point);
    return JLT_OK;
}

/* Whether another branch begins at the bifurcation. */
static bool begins(const node *l)
{
    return l->point.kind == JLT_BIFURCATION_BRANCH || l->point.kind == JLT_BIFURCATION_DOUBLING;
}

static bool too_long(const node *l)
{
    return l->point.kind == JLT_BIFURCATION_DOUBLING && 2 * l->point.orbit.period > JLT_PERIODIC_MAX;
}

/* Follow the branches that begin at a bifurcation: both sides of a branch point, and one side of a period doubling, since the other
 * has the same orbits, begun half a period later. */
static jlt_status follow_branches(tree *self, size_t from)
{
    const jlt_continuation_point origin = self->nodes[from].point;
    const jlt_continuation_options *options = self->options;
    const bool doubling = origin.kind == JLT_BIFURCATION_DOUBLING;
    jlt_continuation_point first;
    jlt_status st = JLT_OK;

    if (!begins(&self->nodes[from]) || too_long(&self->nodes[from])) return JLT_OK;
    self->generation = self->nodes[from].generation + 1;
    for (int side = 1; st == JLT_OK && side >= (doubling ? 1 : -1) && !self->nodes[from].followed; side -= 2) {
        if (options->interrupt != NULL && *options->interrupt) return JLT_OK;
        st = jlt_continuation_switch(&first, self->family, &origin, side, options->step, options);
        if (st == JLT_ERR_NOMEM) return st;
        if (st != JLT_OK) {
            self->sink->end(self->sink->context, &(jlt_tree_end){ .origin = &origin, .side = side, .status = st });
            st = JLT_OK;
            continue;
        }
        self->branch++;
        st = run_branch(self, &first, 1, &origin);
    }
    return st;
}

jlt_status jlt_tree_grow(jlt_tree_left *left, const jlt_chart *chart, const jlt_family *family,
                         const jlt_continuation_point *first, int direction, size_t generations,
                         const jlt_continuation_options *options, const jlt_tree_sink *sink)
{
    const jlt_continuation_options all = jlt_continuation_step_defaults(options);
    tree self = { .chart = chart, .family = family, .options = &all, .sink = sink };
    jlt_status st = run_branch(&self, first, direction, NULL);

    *left = (jlt_tree_left){ 0 };
    for (size_t i = 0; st == JLT_OK && i < self.count; i++)
        if (self.nodes[i].generation < generations) st = follow_branches(&self, i);
    for (size_t i = 0; i < self.count; i++) {
        const node *l = &self.nodes[i];
        left->longer += !l->followed && too_long(l);
        left->last += l->generation == generations && !l->followed && begins(l) && !too_long(l);
    }
    free(self.nodes);
    return st;
}
