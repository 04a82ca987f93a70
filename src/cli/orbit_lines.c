#include "cli/orbit_lines.h"

#include <math.h>

#include "dynamics/surface.h"

size_t jlt_orbit_lines_whole(jlt_symmetric_line lines[2], const jlt_system *system, size_t samples)
{
    const jlt_chart *chart = system->flow.chart;
    unsigned angle = 0;

    while (angle < chart->dim && !(chart->mirror[angle] < 0 && chart->period[angle] != 0)) angle++;
    for (unsigned k = 0; chart->reversible && angle < chart->dim && k < chart->dim; k++) {
        if (k == angle || !jlt_surface_interval(system, k, &lines[0].low, &lines[0].high)) continue;
        lines[0].free = k;
        lines[0].samples = samples;
        lines[1] = lines[0];
        lines[1].base[angle] = chart->period[angle] / 2;
        return 2;
    }
    return 0;
}

size_t jlt_orbit_lines_of_grid(jlt_symmetric_line lines[2], const jlt_chart *chart, const jlt_grid_axis *axes, size_t samples)
{
    const unsigned mirrored = chart->mirror[0] < 0 ? 0 : 1, free = 1 - mirrored;

    if (!chart->reversible || chart->dim != 2 || !(chart->mirror[mirrored] < 0 && chart->mirror[free] > 0)) return 0;
    if (!(axes[free].low < axes[free].high)) return 0;
    lines[0].free = free;
    lines[0].low = axes[free].low, lines[0].high = axes[free].high;
    lines[0].samples = samples;
    lines[1] = lines[0];
    lines[1].base[mirrored] = chart->period[mirrored] / 2;
    return chart->period[mirrored] != 0 ? 2 : 1;
}

jlt_exit jlt_orbit_lines_check(const jlt_symmetric_line *line, const jlt_chart *chart)
{
    static const double same_point = 1e-7; /* as orbits are compared, dynamics/periodic.h */
    double off[JLT_CHART_DIM_MAX];

    if (!chart->reversible) return JLT_EXIT_DONE;
    jlt_chart_mirror(chart, off, line->base);
    jlt_chart_difference(chart, off, off, line->base);
    jlt_chart_scaled(chart, off, off);
    for (unsigned k = 0; k < chart->dim; k++)
        if (k != line->free && fabs(off[k]) > same_point)
            return jlt_command_fail(JLT_EXIT_INPUT, "--line: a point with %s = %.10g is not its own mirror image: take 0%s in "
                                    "--start", chart->names[k], line->base[k], chart->period[k] != 0 ? ", or half a period," : "");
    return JLT_EXIT_DONE;
}
