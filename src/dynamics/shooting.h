/** One pass over the points of a periodic orbit: the returns' derivatives, and by how much each misses the next point. */
#ifndef JLT_DYNAMICS_SHOOTING_H
#define JLT_DYNAMICS_SHOOTING_H

#include "dynamics/map.h"

typedef struct {
    double *slopes, *miss; /* (period, d, d) and (period, d), in one block; owned. Scaled, as all here: jlt_chart_scaled */
    double residual, /* largest |miss| of a return */
        scale;       /* max(1, largest |DP| of a return) */
    double T,        /* [time] of all returns */
        expansion,   /* integral of the divergence over all returns */
        determinant, /* product of the returns' det DP */
        defect;      /* the returns' defect of largest modulus, see jlt_image */
} jlt_shooting;

/** Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_shooting_create(jlt_shooting *out, unsigned d, size_t period);
void jlt_shooting_clear(jlt_shooting *self); /* legal on a zeroed one */

/* Forget what was added. */
void jlt_shooting_reset(jlt_shooting *self);

/** Add return `index` of points (period, d): its image q, DP, and `measured`: T, expansion, determinant and defect of jlt_image. */
void jlt_shooting_add(jlt_shooting *self, const jlt_chart *chart, const double *points, size_t period, size_t index,
                      const double *q, const double *slope, const double measured[4]);

/** Fill all returns by a map. Errors: those of jlt_map_apply. */
JLT_CHECKED jlt_status jlt_shooting_of(jlt_shooting *out, jlt_map *map, const double *points, size_t period);

#endif
