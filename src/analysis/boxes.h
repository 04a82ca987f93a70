/** Equal boxes that partition a rectangular region of a space of few coordinates, some of which may be angles. Boxes are numbered
 *  with the first coordinate varying fastest. */
#ifndef JLT_ANALYSIS_BOXES_H
#define JLT_ANALYSIS_BOXES_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { JLT_BOXES_DIM_MAX = 8 };

/* The most boxes: their numbers are kept in 32 bits. */
#define JLT_BOXES_MAX ((size_t)1 << 28)

/** Plain data. Coordinate k runs from low[k] to high[k], low < high, in count[k] >= 1 boxes. period[k] is the period of an angle,
 *  at least high[k] - low[k], or 0. */
typedef struct {
    unsigned dim;
    double low[JLT_BOXES_DIM_MAX], high[JLT_BOXES_DIM_MAX], period[JLT_BOXES_DIM_MAX];
    size_t count[JLT_BOXES_DIM_MAX];
} jlt_boxes;

/** Compute the number of boxes. Errors: ARG, dim is 0 or above JLT_BOXES_DIM_MAX, an interval is empty, not finite or longer than
 *  its period, a period is not finite, a count is 0, or there are more than JLT_BOXES_MAX boxes. */
JLT_CHECKED jlt_status jlt_boxes_count(size_t *all, const jlt_boxes *boxes);

/** Find the box *index that contains the point q, shape (dim,). Returns false if none does. Angles are taken modulo their period.
 *  Since ends are known up to rounding, a point beyond an end by less than 1e-6 of a box's width belongs to the box at that end. */
bool jlt_boxes_find(const jlt_boxes *boxes, size_t *index, const double *q);

/** The centre of a box, q, shape (dim,); and the volume of a box, the same for all. */
void jlt_boxes_centre(const jlt_boxes *boxes, double *q, size_t index);
double jlt_boxes_volume(const jlt_boxes *boxes);

/** The number of points that jlt_boxes_sample makes: strata^dim; SIZE_MAX if there are more. */
size_t jlt_boxes_samples(const jlt_boxes *boxes, size_t strata);

/** Stratified random points of a box: one in each of strata^dim equal cells. They depend on seed and index alone.
 *  Out: q, shape (strata^dim, dim). */
void jlt_boxes_sample(const jlt_boxes *boxes, double *q, size_t index, size_t strata, uint64_t seed);

/** Make boxes `factor` times wider; coordinates with one box stay as they are. Errors: ARG, factor is 0, or does not divide a
 *  count above 1. */
JLT_CHECKED jlt_status jlt_boxes_coarser(jlt_boxes *out, const jlt_boxes *fine, size_t factor);

/** The number of the coarse box that contains a fine one. */
size_t jlt_boxes_parent(const jlt_boxes *fine, const jlt_boxes *coarse, size_t index);

/** The neighbours of a box: those that share a corner with it, also across the ends of an angle whose whole period is covered.
 *  Out: neighbours, shape (3^dim,). Returns their number; the box itself is not among them. */
size_t jlt_boxes_neighbours(const jlt_boxes *boxes, size_t *neighbours, size_t index);

#endif
