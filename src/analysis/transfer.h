/** Ulam's approximation of the transfer operator of a map: a matrix of transition probabilities between boxes.
 *
 *  Entry P_ij of the matrix is the share of the points of box i whose image lies in box j; masses v of boxes are mapped to v P.
 *  Only boxes that contain a point of the space are kept. The share of points without an image in a kept box is a loss of box i,
 *  recorded by kind (what became of the point), so that a row and its losses sum to 1.
 *
 *  The matrix spreads mass over whole boxes. This numerical diffusion, of the width of a box per iteration, hides weaker
 *  dissipation and weaker transport of the map itself. Results are evidence, not proof.
 *  Source: S. M. Ulam, A Collection of Mathematical Problems, 1960, VI.4; M. Dellnitz, O. Junge, SIAM J. Numer. Anal. 36(2),
 *  1999. */
#ifndef JLT_ANALYSIS_TRANSFER_H
#define JLT_ANALYSIS_TRANSFER_H

#include "analysis/boxes.h"

#include <signal.h>

/* Marks a box that is not kept. */
#define JLT_TRANSFER_NONE UINT32_MAX

/** Plain data, owned; destroy with jlt_transfer_destroy. */
typedef struct {
    jlt_boxes boxes;
    size_t count;       /* number of kept boxes */
    uint32_t *box;      /* (count,): the number of each kept box */
    uint32_t *kept;     /* (boxes,): the index of each box among the kept ones, or JLT_TRANSFER_NONE */
    double *share;      /* (count,): the share of the box's points that are in the space */
    size_t *row;        /* (count + 1,): the entries of row i are row[i] .. row[i + 1] - 1 */
    uint32_t *to;       /* (row[count],): column j of each entry, an index among the kept boxes; ascending in a row */
    double *weight;     /* (row[count],): P_ij > 0 */
    unsigned losses;    /* number of kinds of loss; kind 0 is an image outside the boxes */
    double *lost;       /* (count, losses): shares of the box's points */
    double *time;       /* (count,): mean time of points with an image; NaN if there is none */
    double *known;      /* (count,): masses of a density that is claimed to be invariant, of sum 1; NULL if there is none */
} jlt_transfer;

/** A map, given by functions. */
typedef struct {
    void *context;
    unsigned losses; /* number of kinds of loss, >= 1 */
    /* Whether q, shape (dim,), is a point of the space. */
    bool (*holds)(void *context, const double *q);
    /* Images of points q, shape (count, dim). Out: images, shape (count, dim); loss, shape (count,): 0 for a point with an image,
     * 1 to losses - 1 for the kind of loss, `losses` for a point outside the space; time, shape (count,), to the image. */
    jlt_status (*images)(void *context, double *images, unsigned *loss, double *time, const double *q, size_t count);
    /* A density, up to a factor, that is claimed to be invariant; NULL if there is none. */
    double (*density)(void *context, const double *q);
    const volatile sig_atomic_t *interrupt; /* raised to stop; may be NULL */
} jlt_transfer_map;

typedef struct {
    size_t strata;       /* number of strata along each coordinate of a box */
    uint64_t seed;       /* of the random points and of the noise */
    const double *noise; /* shape (noise_count,): each coordinate of an image is shifted at random, uniformly within plus or minus
                          * this part of its interval; an image that would leave the space is not shifted. 0: no noise */
    size_t noise_count;  /* >= 1 */
    size_t block;        /* least number of points whose images are computed at once; 0: 4096 */
    /* Called with the number of points done and of all points; may be NULL. */
    void (*progress)(void *context, size_t done, size_t all);
    void *progress_context;
} jlt_transfer_options;

/** Build the matrices of a map, one for each noise, from the same images. A box without a stratified point in the space is kept
 *  too if an image falls into it: such images then serve as its points, and its share is half the least nonzero share of strata.
 *  Out: out, shape (noise_count,), each NULL on failure; *points, the number of points that were mapped.
 *  Errors: ARG; EMPTY, no box contains a point of the space; NO_CONVERGENCE, interrupted; NOMEM; those of map->images.
 *  Memory: for each noise, 12 bytes per entry, 8 (losses + 4) per kept box and 4 per box; a row has at most strata^dim entries,
 *  mostly a few times the factor by which the map expands a box. */
JLT_CHECKED jlt_status jlt_transfer_build(jlt_transfer **out, size_t *points, const jlt_boxes *boxes, const jlt_transfer_map *map,
                                          const jlt_transfer_options *options);
void jlt_transfer_destroy(jlt_transfer *self); /* NULL is legal */
JLT_OWNED_TYPE(jlt_transfer)

/** The matrix on boxes `factor` times wider, where the mass of a box is distributed over its fine boxes by their shares. Out:
 *  *out, NULL on failure. Errors: ARG, as jlt_boxes_coarser; NOMEM. */
JLT_CHECKED jlt_status jlt_transfer_coarsen(jlt_transfer **out, const jlt_transfer *fine, size_t factor);

/** out = v P, the image of masses v. Both have shape (count,), and must be different arrays. */
void jlt_transfer_push(const jlt_transfer *self, double *out, const double *v);

/** Half of the sum of |a - b|, shape (count,): the total variation distance, 0 to 1, of masses of sum 1. */
double jlt_transfer_distance(const double *a, const double *b, size_t count);

#endif
