#include "dynamics/surface.h"

#include <math.h>

#include "dynamics/section_points.h"

bool jlt_surface_nearest_level(const jlt_surface *surface, const double *values, double *level)
{
    enum { HALVINGS = 1000 };
    const double close = 1e-12; /* as a part of the level */
    const double given = values[surface->params];
    double arranged[JLT_CHART_VALUES_MAX], size = fmax(1e-3, fabs(given)), empty = given, full = NAN;
    jlt_chart_section chart;

    jlt_surface_arrange(arranged, surface, values);
    if (surface->count == surface->params || jlt_chart_section_init(&chart, surface->table, surface->section, arranged) != JLT_OK)
        return false;
    double *entry = &chart.values[surface->entries[surface->params]];
    for (int i = 0; i < 64 && isnan(full); i++) {
        *entry = given + (i % 2 == 0 ? size : -size);
        if (jlt_section_points_any(&chart)) full = *entry;
        if (i % 2 == 1) size *= 2;
    }
    if (isnan(full)) return false;
    for (int i = 0; i < HALVINGS && fabs(full - empty) > close * fabs(full); i++) {
        *entry = empty + (full - empty) / 2;
        if (jlt_section_points_any(&chart)) full = *entry;
        else empty = *entry;
    }
    *level = full;
    return true;
}
