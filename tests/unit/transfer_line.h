/* Maps of one coordinate, and their transfer operators by Ulam's method. */
#ifndef JLT_TESTS_TRANSFER_LINE_H
#define JLT_TESTS_TRANSFER_LINE_H

#include "unit/check.h"

#include "analysis/transfer_finding.h"

/* A map of one coordinate: image of x, or NaN for a point that is lost. */
typedef struct {
    double (*image)(double x);
    double (*density)(double x);
    double only_below, and_near; /* the domain is x < only_below and the points within 1e-9 of and_near; only_below 0: everything */
} line;

static inline bool line_holds(void *context, const double *q)
{
    const line *l = context;
    return l->only_below == 0 || q[0] < l->only_below || fabs(q[0] - l->and_near) < 1e-9;
}

static inline jlt_status line_images(void *context, double *images, unsigned *loss, double *time, const double *q, size_t count)
{
    const line *l = context;

    for (size_t i = 0; i < count; i++) {
        images[i] = l->image(q[i]);
        loss[i] = !line_holds(context, &q[i]) ? 2u : isnan(images[i]) ? 1u : 0u;
        time[i] = 2;
    }
    return JLT_OK;
}

static inline double line_density(void *context, const double *q) { return ((const line *)context)->density(q[0]); }

static const double none[] = { 0 };

static inline jlt_transfer *make(const line *l, size_t count, size_t strata, double noise)
{
    const jlt_boxes boxes = { .dim = 1, .low = { 0 }, .high = { 1 }, .count = { count } };
    const jlt_transfer_map map = { .context = (void *)l, .losses = 2, .holds = line_holds, .images = line_images,
                                   .density = l->density != NULL ? line_density : NULL };
    jlt_transfer *out;
    size_t points;

    assert_ok(jlt_transfer_build(&out, &points, &boxes, &map,
                                 &(jlt_transfer_options){ .strata = strata, .seed = 1, .noise = noise > 0 ? &noise : none,
                                                         .noise_count = 1 }));
    return out;
}

#endif
