/** Equal boxes that cover a part of a space of few coordinates, angles among them. Boxes are numbered with the first coordinate
 *  running fastest. */
#ifndef JLT_ANALYSIS_BOXES_H
#define JLT_ANALYSIS_BOXES_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { JLT_BOXES_DIM_MAX = 8 };

/* More boxes than this are refused: their numbers are kept in 32 bits. */
#define JLT_BOXES_MAX ((size_t)1 << 28)

/** Plain data. Coordinate k runs from low[k] to high[k], low < high, in count[k] >= 1 boxes; period[k] is that of an angle, which
 *  high - low does not exceed, or 0. */
typedef struct {
    unsigned dim;
    double low[JLT_BOXES_DIM_MAX], high[JLT_BOXES_DIM_MAX], period[JLT_BOXES_DIM_MAX];
    size_t count[JLT_BOXES_DIM_MAX];
} jlt_boxes;

/** How many boxes there are. Errors: ARG, dim is 0 or above JLT_BOXES_DIM_MAX, an interval is empty, not finite or longer than
 *  its period, a count is 0, or there are more than JLT_BOXES_MAX boxes. */
JLT_CHECKED jlt_status jlt_boxes_count(size_t *all, const jlt_boxes *boxes);

/** Find the box that holds the point q, shape (dim,): *index. False: none does. Angles are taken modulo their period. A point
 *  that lies beyond an end by less than 1e-6 of a box's width belongs to the box at that end: ends are known up to rounding. */
bool jlt_boxes_find(const jlt_boxes *boxes, size_t *index, const double *q);

/** The centre of a box, and its volume, the same for all. Out: q, shape (dim,). */
void jlt_boxes_centre(const jlt_boxes *boxes, double *q, size_t index);
double jlt_boxes_volume(const jlt_boxes *boxes);

/** How many points jlt_boxes_sample makes: strata^dim. */
size_t jlt_boxes_samples(const jlt_boxes *boxes, size_t strata);

/** Stratified points of a box: strata^dim equal cells, with one point at random in each. They depend on seed and index alone.
 *  Out: q, shape (strata^dim, dim). */
void jlt_boxes_sample(const jlt_boxes *boxes, double *q, size_t index, size_t strata, uint64_t seed);

/** Boxes `factor` times wider. Errors: ARG, factor is 0, or a count above 1 is no multiple of it. Coordinates with one box stay as
 *  they are. */
JLT_CHECKED jlt_status jlt_boxes_coarser(jlt_boxes *out, const jlt_boxes *fine, size_t factor);

/** The coarser box in which a fine one lies. */
size_t jlt_boxes_parent(const jlt_boxes *fine, const jlt_boxes *coarse, size_t index);

/** The neighbours of a box, those that share a corner with it; across the ends of an angle that is covered whole, too.
 *  Out: neighbours, shape (3^dim,). Returns how many; the box itself is not among them. */
size_t jlt_boxes_neighbours(const jlt_boxes *boxes, size_t *neighbours, size_t index);

#endif
