/** The chart of a section for a flow that counts states in other units than the chart does (kernel/units.h): its coordinates stay
 *  those of the chart, and states are converted on the way. */
#ifndef JLT_DYNAMICS_CHART_COUNTED_H
#define JLT_DYNAMICS_CHART_COUNTED_H

#include "dynamics/chart.h"

typedef struct {
    jlt_chart base; /* the section in the flow's units */
    const jlt_chart *told;
    int unit[JLT_CHART_STATES_MAX]; /* the flow counts state i in 2^unit[i] */
} jlt_chart_counted;

/** Make the chart from `told`, kept by reference, of a section whose angles have the unit 2^0; unit: shape (told->states,), of
 *  states; coordinate: shape (told->dim,), of coordinates, in which their sizes are counted. */
void jlt_chart_counted_init(jlt_chart_counted *out, const jlt_chart *told, const int *unit, const int *coordinate);

#endif
