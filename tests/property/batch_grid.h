/* The grids of reference returns in tests/reference/data on which batches of section maps are tested, and the model's
 * descriptor. */
#ifndef JLT_TESTS_BATCH_GRID_H
#define JLT_TESTS_BATCH_GRID_H

#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "integrate/batch.h"
#include "kernel/batch_isa.h"
#include "registry.h"

enum { ORBITS = 64, RETURNS = 10, STATES = 5 };

static const double I1 = 1.0 / 3, I3 = 1.0 / 3, a3 = 0.51, G = -0.56; /* (5.1), m = R = g = 1 */

typedef struct {
    double start[ORBITS][STATES];
    double expected[ORBITS][RETURNS][3]; /* gamma3, v_nu, omega3 */
} grid;

static inline void read_grid(const char *name, grid *g)
{
    char path[512], line[512];
    snprintf(path, sizeof path, "%s/tests/reference/data/%s", JLT_SOURCE_DIR, name);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file) != NULL) {
        int orbit, number;
        double t, gamma3, v_nu, omega_n, omega3;
        assert_int_equal(sscanf(line, "%d,%d,%lf,%lf,%lf,%lf,%lf", &orbit, &number, &t, &gamma3, &v_nu, &omega_n, &omega3), 7);
        double s = sqrt((1 - gamma3) * (1 + gamma3));
        if (number == 0)
            memcpy(g->start[orbit], (double[]){ gamma3, v_nu, 0, (a3 + gamma3) * omega_n + s * omega3, s }, sizeof g->start[0]);
        else
            memcpy(g->expected[orbit][number - 1], (double[]){ gamma3, v_nu, omega3 }, sizeof g->expected[0][0]);
    }
    fclose(file);
}

static inline const jlt_descriptor *level(void)
{
    for (unsigned i = 0; i < jlt_registry_count; i++) {
        const jlt_descriptor *d = jlt_registry[i];
        if (strcmp(d->model, "spherical_top_level") == 0 && *d->variant == '\0' && strcmp(d->time, "regular") == 0) return d;
    }
    fail();
    return NULL;
}

#endif
