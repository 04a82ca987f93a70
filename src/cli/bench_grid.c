#include "cli/bench.h"

#include <stdio.h>
#include <stdlib.h>

void jlt_bench_clear(jlt_bench_grid *grid)
{
    free(grid->start);
    free(grid->expected);
    *grid = (jlt_bench_grid){ 0 };
}

/* One pass over the file: counts when the arrays are not there yet, fills them when they are. */
static jlt_status pass(jlt_bench_grid *grid, FILE *file)
{
    char line[1024];
    size_t orbits = 0, last = 0;

    rewind(file);
    while (fgets(line, sizeof line, file) != NULL) {
        size_t orbit, number;
        double t, point[4];
        if (line[0] == '#' || line[0] == 'o') continue;
        if (sscanf(line, "%zu,%zu,%lf,%lf,%lf,%lf,%lf", &orbit, &number, &t, &point[0], &point[1], &point[2], &point[3]) != 7)
            return JLT_ERR_ARG;
        if (number == 0 ? orbit != orbits : orbit + 1 != orbits || number != last + 1) return JLT_ERR_ARG;
        if (number == 0) orbits++;
        last = number;
        if (grid->start == NULL) {
            if (orbit == 0) grid->checked = number;
            if (number > grid->checked) return JLT_ERR_ARG;
            continue;
        }
        double *to = number == 0 ? grid->start[orbit] : grid->expected[orbit * grid->checked + number - 1];
        for (int i = 0; i < 4; i++) to[i] = point[i];
    }
    grid->orbits = orbits;
    return ferror(file) ? JLT_ERR_IO : orbits == 0 || last != grid->checked ? JLT_ERR_ARG : JLT_OK;
}

jlt_status jlt_bench_read(jlt_bench_grid *grid, const char *path)
{
    jlt_status st = JLT_OK;
    FILE *file = fopen(path, "r");

    *grid = (jlt_bench_grid){ 0 };
    if (file == NULL) return JLT_ERR_IO;
    JLT_TRY(pass(grid, file));
    grid->start = calloc(grid->orbits, sizeof *grid->start);
    grid->expected = calloc(grid->orbits * grid->checked + 1, sizeof *grid->expected);
    if (grid->start == NULL || grid->expected == NULL) st = JLT_ERR_NOMEM;
    else st = pass(grid, file);
done:
    fclose(file);
    if (st != JLT_OK) jlt_bench_clear(grid);
    return st;
}
