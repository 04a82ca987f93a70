/* Kernels of sections against each other, at random points of the coordinates: the lift has its state, its levels and its way
 * back; and the derivatives of the way back, after those of the lift, are the identity on the coordinates and nothing along levels.
 *
 * Tolerance: each of these sums up to a dozen terms of products of the entries of two matrices, with relative errors of some
 * dozen roundings an entry; 200 roundings, relative to the sum of the absolute terms. Points at which a region is within a tenth
 * of its value at the start of zero are left out, as lifts have no slope at its edge. */
#include "unit/check.h"

#include "base/random.h"
#include "registry.h"

#include <float.h>
#include <stdbool.h>

enum { MOST = 64, POINTS = 200 };
static const double tolerance = 200 * DBL_EPSILON;
static uint64_t random_state = 7;

static double draw(void)
{
    return (double)(ttc_random_bits(&random_state) >> 11) * 0x1p-53;
}

typedef struct {
    const jlt_descriptor *descriptor;
    const jlt_section_chart *section;
    double q[MOST], x[MOST], values[MOST], lift_slopes[MOST], back[MOST], back_slopes[MOST];
} place;

/* Around a start; false outside of the region. */
static bool draw_point(place *p, const double *start)
{
    const jlt_section_chart *s = p->section;
    double here[MOST], there[MOST];
    for (unsigned i = 0; i < s->coordinate_count; i++) {
        const jlt_quantity *c = s->coordinates + i;
        p->q[i] = c->period > 0 ? c->period * (draw() - 0.5) : start[i] + 0.2 * (draw() - 0.5);
        if (p->q[i] <= c->low || p->q[i] >= c->high) return false;
    }
    if (s->region == NULL) return true;
    s->region(p->q, p->values, here);
    s->region(start, p->values, there);
    for (unsigned i = 0; i < s->region_count; i++)
        if (!(here[i] > there[i] / 10)) return false;
    return true;
}

/* Derivative of coordinate i along a column of the slopes of the lift; *size: of its terms. */
static double chained(const place *p, unsigned i, unsigned column, double *size)
{
    const unsigned n = p->descriptor->state_count, columns = p->section->coordinate_count + p->section->level_count;
    const double sine = p->back[2 * i], cosine = p->back[2 * i + 1], square = sine * sine + cosine * cosine;
    double sum = 0;
    *size = 0;
    for (unsigned k = 0; k < n; k++) {
        const double sine_slope = p->back_slopes[2 * i * n + k], cosine_slope = p->back_slopes[(2 * i + 1) * n + k];
        const double slope = p->lift_slopes[k * columns + column];
        const double term = p->section->is_angle[i] ? (cosine * sine_slope - sine * cosine_slope) / square : sine_slope;
        sum += term * slope;
        *size += fabs(term * slope);
        if (p->section->is_angle[i]) *size += (fabs(cosine * sine_slope) + fabs(sine * cosine_slope)) / square * fabs(slope);
    }
    return sum;
}

static void check_point(place *p)
{
    const jlt_section_chart *s = p->section;
    double integrals[MOST], block[MOST * 8];
    s->lift(p->q, p->values, p->x);
    s->lift_slopes(p->q, p->values, p->lift_slopes);
    s->back(p->x, p->values, p->back);
    s->back_slopes(p->x, p->values, p->back_slopes);
    assert_near(p->x[s->column], s->level, tolerance * (1 + fabs(s->level)));
    for (unsigned i = 0; i < s->coordinate_count; i++) {
        const double back = s->is_angle[i] ? atan2(p->back[2 * i], p->back[2 * i + 1]) : p->back[2 * i];
        const double turns = s->is_angle[i] ? s->coordinates[i].period * round((back - p->q[i]) / s->coordinates[i].period) : 0;
        assert_near(back - turns, p->q[i], tolerance * (1 + fabs(p->q[i])));
        for (unsigned k = 0; k < s->coordinate_count + s->level_count; k++) {
            double size, slope = chained(p, i, k, &size);
            assert_near(slope, i == k ? 1 : 0, tolerance * (1 + size));
        }
    }
    p->descriptor->prepare(p->values, block);
    p->descriptor->integral_values.call(p->x, block, integrals);
    for (unsigned i = 0; i < s->level_count; i++) {
        const double level = p->values[p->descriptor->param_count + i];
        assert_near(integrals[s->integrals[i]], level, tolerance * (1 + 10 * fabs(level)));
    }
}

static void kernels_of_sections_agree(void **state)
{
    unsigned sections = 0, points = 0;
    (void)state;
    for (unsigned d = 0; d < jlt_registry_count; d++)
        for (unsigned i = 0; i < jlt_registry[d]->section_count; i++) {
            place p = { .descriptor = jlt_registry[d], .section = jlt_registry[d]->sections + i };
            const jlt_section_chart *s = p.section;
            for (unsigned k = 0; k < p.descriptor->param_count; k++) p.values[k] = p.descriptor->params[k].value;
            for (unsigned k = 0; k < s->level_count; k++) p.values[p.descriptor->param_count + k] = s->levels[k].value;
            assert_true(p.descriptor->state_count * 2 * (s->coordinate_count + s->level_count) <= MOST);
            assert_true(p.descriptor->prepared_count <= MOST * 8);
            for (unsigned k = 0; k < s->start_count * POINTS; k++) {
                if (!draw_point(&p, s->starts[k % s->start_count].point)) continue;
                check_point(&p);
                points++;
            }
            sections++;
        }
    print_message("%u sections, %u points\n", sections, points);
    assert_true(sections >= 2 && points >= POINTS);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(kernels_of_sections_agree) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
