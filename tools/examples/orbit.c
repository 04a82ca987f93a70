/* One orbit of Lorenz's system, at four times. */
#include <jellett.h>
#include <stdio.h>

int main(void)
{
    const double params[] = { 10, 28, 8. / 3 }, start[] = { 1, 2, 20 }, times[] = { 0.5, 1, 1.5, 2 };
    const jlt_descriptor *lorenz = jlt_descriptor_find("lorenz", NULL, NULL, NULL);
    const jlt_options options = { .tolerance = 1e-13 };
    double x[4][3];
    jlt_instance *instance = NULL;
    jlt_orbit *orbit = NULL;
    jlt_field field;
    size_t rows = 0;
    jlt_status st;

    JLT_TRY(jlt_instance_create(&instance, lorenz, params));
    JLT_TRY(jlt_field_of(&field, instance));
    JLT_TRY(jlt_orbit_create(&orbit, NULL, &field, &options)); /* NULL: the default method */
    JLT_TRY(jlt_orbit_start(orbit, 0, start, +1));
    JLT_TRY(jlt_orbit_sample(orbit, x[0], &rows, times, 4));
    for (size_t i = 0; i < rows; i++) printf("%g,%.15g,%.15g,%.15g\n", times[i], x[i][0], x[i][1], x[i][2]);
done:
    if (st != JLT_OK) fprintf(stderr, "orbit: %s\n", jlt_status_text(st));
    jlt_orbit_destroy(orbit);
    jlt_instance_destroy(instance);
    return st != JLT_OK;
}
