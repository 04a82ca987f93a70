/** The chart of a section for a flow that counts states in other units than the table (kernel/units.h): it converts states, and
 *  leaves coordinates in the table's units. */
#ifndef JLT_DYNAMICS_CHART_COUNTED_H
#define JLT_DYNAMICS_CHART_COUNTED_H

#include "dynamics/chart.h"

typedef struct {
    jlt_chart base; /* the section in the flow's units */
    const jlt_chart *told; /* the section in the table's units */
    int unit[JLT_CHART_STATES_MAX]; /* the flow counts state i in 2^unit[i] */
} jlt_chart_counted;

/** Make the chart from `told`, kept by reference. unit: shape (told->states,), binary exponents of the flow's units of states, 0
 *  for angles; coordinate: shape (told->dim,), those of coordinates, for the chart's `unit` and its first `scale`. */
void jlt_chart_counted_init(jlt_chart_counted *out, const jlt_chart *told, const int *unit, const int *coordinate);

#endif
