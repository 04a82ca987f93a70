#include "cli/orbit_columns.h"

#include "report/csv.h"

void jlt_orbit_columns_names(FILE *file, const jlt_chart *chart)
{
    fputs("period", file);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(file, ",%s", chart->names[k]);
    fputs(",T,trace,det", file);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(file, ",mu%u_re,mu%u_im", k + 1, k + 1);
    fputs(",symmetric,type,residual", file);
}

void jlt_orbit_columns_write(FILE *file, const jlt_chart *chart, const jlt_periodic *orbit)
{
    fprintf(file, "%zu,", orbit->period);
    jlt_csv_values(file, orbit->points, chart->dim);
    fputc(',', file);
    jlt_csv_values(file, (const double[]){ orbit->T, orbit->trace, orbit->determinant }, 3);
    for (unsigned k = 0; k < chart->dim; k++) {
        fputc(',', file);
        jlt_csv_values(file, (const double[]){ orbit->re[k], orbit->im[k] }, 2);
    }
    const char *symmetric = !chart->reversible ? "" : orbit->symmetric ? "yes" : "no";
    fprintf(file, ",%s,%s,%.3g", symmetric, jlt_periodic_type_name(orbit->type), orbit->residual);
}
