/* A hand-written field: Kepler's problem with eccentricity 0.6, and the times of its returns to the pericentre. */
#include <jellett.h>
#include <math.h>
#include <stdio.h>

static void kepler(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double r2 = x[0] * x[0] + x[1] * x[1], c = -p[0] / (r2 * sqrt(r2));
    out[0] = x[2], out[1] = x[3], out[2] = c * x[0], out[3] = c * x[1];
}

int main(void)
{
    const double mu = 1, start[] = { 0.4, 0, 0, 2 };
    const jlt_field field = { .dim = 4, .call = kepler, .p = &mu, .root = -1 };
    const jlt_event pericentre = { .column = 1, .level = 0, .direction = JLT_RISING }; /* y = 0, upwards */
    jlt_orbit *orbit = NULL;
    jlt_outcome at;
    jlt_status st;
    JLT_TRY(jlt_orbit_create(&orbit, jlt_method_find("dop853"), &field, &(jlt_options){ .tolerance = 1e-14 }));
    JLT_TRY(jlt_orbit_start(orbit, 0, start, +1));
    for (int k = 0; k < 3; k++) {
        JLT_TRY(jlt_orbit_next(orbit, INFINITY, &pericentre, 1, &at));
        printf("%.15g,%.15g\n", at.t, at.x[0]);
    }
done:
    jlt_orbit_destroy(orbit);
    return st != JLT_OK;
}
