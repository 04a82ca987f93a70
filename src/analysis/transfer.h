/** Ulam's approximation of the transfer operator of a map: boxes, and the share of each box that the map sends to each other one.
 *
 *  Row i of the matrix P is that of box i: P_ij is the share of its points whose image lies in box j. Masses v of boxes go to v
 *  P. Only boxes that hold a point of the space are kept. Points that do not come back are a loss of their box, told apart by
 *  what became of them, so that the sum of a row and its losses is 1.
 *
 *  Where the matrix spreads mass over a whole box, the map may have spread it less: this diffusion, of a box's width each time,
 *  is the method's own, and hides a dissipation or a transport that is weaker. What is found is evidence, not proof.
 *  Source: S. M. Ulam, A Collection of Mathematical Problems, 1960, VI.4; M. Dellnitz, O. Junge, SIAM J. Numer. Anal. 36(2),
 *  1999. */
#ifndef JLT_ANALYSIS_TRANSFER_H
#define JLT_ANALYSIS_TRANSFER_H

#include "analysis/boxes.h"

#include <signal.h>

/* No box. */
#define JLT_TRANSFER_NONE UINT32_MAX

/** Plain data, owned; destroy with jlt_transfer_destroy. */
typedef struct {
    jlt_boxes boxes;
    size_t count;       /* of boxes kept */
    uint32_t *box;      /* (count,): which each is */
    uint32_t *kept;     /* (boxes,): the place of each box among those kept, or JLT_TRANSFER_NONE */
    double *share;      /* (count,): of the box's points, those in the space */
    size_t *row;        /* (count + 1,): entries row[i] .. row[i + 1] - 1 are those of box i */
    uint32_t *to;       /* (row[count],): j of each entry, the place of the box that the mass goes to; ascending in a row */
    double *weight;     /* (row[count],): P_ij > 0 */
    unsigned losses;    /* kinds of loss; 0 is an image outside the boxes */
    double *lost;       /* (count, losses): share of the box's points */
    double *time;       /* (count,): mean time of those that come back; NaN where none does */
    double *known;      /* (count,): masses of a density that is said to be invariant, of sum 1; NULL: none is */
} jlt_transfer;

/** What is known of a map. */
typedef struct {
    void *context;
    unsigned losses; /* kinds of loss, >= 1 */
    /* Whether q, shape (dim,), is a point of the space. */
    bool (*holds)(void *context, const double *q);
    /* Images of points q, shape (count, dim). Out: images, shape (count, dim); loss, shape (count,): 0 for an image, 1 to
     * losses - 1 for what became of the point, losses for a point that is none of the space; time, shape (count,), that the image
     * took. */
    jlt_status (*images)(void *context, double *images, unsigned *loss, double *time, const double *q, size_t count);
    /* A density, up to a factor, that is said to be invariant; NULL: none. */
    double (*density)(void *context, const double *q);
    const volatile sig_atomic_t *interrupt; /* NULL: nobody asks to stop */
} jlt_transfer_map;

typedef struct {
    size_t strata;       /* points of a box along each coordinate */
    uint64_t seed;       /* of their places, and of noise */
    const double *noise; /* (noise_count,): images are moved at random by up to this part of each coordinate's interval, both ways,
                            evenly; those that would leave the space stay. 0: they are not moved */
    size_t noise_count;  /* >= 1 */
    size_t block;        /* points whose images are asked for at once, at least; 0: 4096 */
    /* Told how many of how many points are done; NULL: nobody. */
    void (*progress)(void *context, size_t done, size_t all);
    void *progress_context;
} jlt_transfer_options;

/** The matrices of a map, one for each noise, from the same images. A box in which no stratified point is of the space, but into
 *  which an image falls, is kept too; the images are its points then, and its share is half the least that strata can see.
 *  Out: out, shape (noise_count,), NULL each on failure; *points, how many points were mapped.
 *  Errors: ARG; EMPTY, no box holds a point of the space; NO_CONVERGENCE, interrupted; NOMEM; as images of the map.
 *  Memory: 12 bytes an entry and 8 (losses + 4) a box for each noise, 4 a box; a row has strata^dim entries at most, mostly a few
 *  times the factor by which the map expands a box. */
JLT_CHECKED jlt_status jlt_transfer_build(jlt_transfer **out, size_t *points, const jlt_boxes *boxes, const jlt_transfer_map *map,
                                          const jlt_transfer_options *options);
void jlt_transfer_destroy(jlt_transfer *self); /* NULL is legal */

/** The matrix on boxes `factor` times wider, in which a box's mass lies on its parts by their shares. Out: *out, NULL on failure.
 *  Errors: ARG, as jlt_boxes_coarser; NOMEM. */
JLT_CHECKED jlt_status jlt_transfer_coarsen(jlt_transfer **out, const jlt_transfer *fine, size_t factor);

/** out = v P: what becomes of masses v. Both of shape (count,), not the same array. */
void jlt_transfer_push(const jlt_transfer *self, double *out, const double *v);

/** Half of the sum of |a - b|, shape (count,): of masses of sum 1 it is their distance in total variation, 0 to 1. */
double jlt_transfer_distance(const double *a, const double *b, size_t count);

#endif
