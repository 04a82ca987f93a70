/** A periodic orbit as columns of a table: period, coordinates, T, trace, det, multipliers, symmetric, type, residual. The
 *  first function writes their names, the second the values of one orbit; without a reversor symmetric is empty. */
#ifndef JLT_CLI_ORBIT_COLUMNS_H
#define JLT_CLI_ORBIT_COLUMNS_H

#include <stdio.h>

#include "dynamics/periodic.h"

void jlt_orbit_columns_names(FILE *file, const jlt_chart *chart);
void jlt_orbit_columns_write(FILE *file, const jlt_chart *chart, const jlt_periodic *orbit);

#endif
