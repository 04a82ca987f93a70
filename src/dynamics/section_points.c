#include "dynamics/section_points.h"

#include <math.h>

enum { ANGLES = 4, HALVINGS = 60 };

static const double margin = 5e-10; /* distance kept from the ends of a coordinate's interval, as a part of its length */

bool jlt_section_points_any(const jlt_chart_section *chart)
{
    const size_t all = jlt_chart_section_probes(chart, ANGLES);
    double q[JLT_CHART_COORDINATES_MAX];

    for (size_t i = 0; i < all; i++) {
        jlt_chart_section_probe(chart, q, i, ANGLES);
        if (jlt_chart_section_holds(chart, q)) return true;
    }
    return false;
}

bool jlt_section_points_none(const jlt_chart_section *chart)
{
    for (unsigned k = 0; k < chart->base.dim; k++) {
        const jlt_quantity *q = &chart->section->coordinates[k];
        if (chart->base.period[k] == 0 && !(isfinite(q->low) && isfinite(q->high))) return false;
    }
    return !jlt_section_points_any(chart);
}

/* Whether the section has a point with this value of one coordinate; the others run over the grid. */
static bool holds_at(const jlt_chart_section *chart, unsigned coordinate, double value)
{
    const size_t places = jlt_chart_section_places(chart, coordinate, ANGLES),
                 others = jlt_chart_section_points(chart, ANGLES) / places;
    double q[JLT_CHART_COORDINATES_MAX];
    size_t stride = 1;

    for (unsigned k = 0; k < coordinate; k++) stride *= jlt_chart_section_places(chart, k, ANGLES);
    for (size_t i = 0; i < others; i++) {
        jlt_chart_section_point(chart, q, i / stride * stride * places + i % stride, ANGLES);
        q[coordinate] = value;
        if (jlt_chart_section_holds(chart, q)) return true;
    }
    return false;
}

/* The end of the interval around `inside` towards `outside`: by bisection between the two, or `outside` if that is still inside. */
static double edge(const jlt_chart_section *chart, unsigned coordinate, double inside, double outside)
{
    if (holds_at(chart, coordinate, outside)) return outside;
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = (inside + outside) / 2;
        if (holds_at(chart, coordinate, middle)) inside = middle;
        else outside = middle;
    }
    return inside;
}

bool jlt_section_points_interval(const jlt_chart_section *chart, unsigned coordinate, double *low, double *high)
{
    const jlt_quantity *bounds = &chart->section->coordinates[coordinate];
    const unsigned places = jlt_chart_section_places(chart, coordinate, ANGLES);
    const double width = bounds->high - bounds->low, off = margin * width;
    double start = 0, before = bounds->low;
    bool open = false, found = false;

    if (chart->base.period[coordinate] != 0 || !isfinite(width)) return false;
    for (unsigned i = 0; i <= places; i++) {
        const double at = bounds->low + width * (i + 0.5) / places;
        const bool inside = i < places && holds_at(chart, coordinate, at);
        if (inside && !open) start = edge(chart, coordinate, at, i == 0 ? bounds->low + off : before);
        if (!inside && open) {
            const double end = edge(chart, coordinate, before, i == places ? bounds->high - off : at);
            if (!found || end - start > *high - *low) *low = start, *high = end;
            found = true;
        }
        open = inside;
        before = at;
    }
    return found;
}
