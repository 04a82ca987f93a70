/* Measures the drift of integrals in batches, over any number of returns. */
#ifndef JLT_TESTS_DRIFT_BATCH_H
#define JLT_TESTS_DRIFT_BATCH_H

#include "drift.h"

#include "integrate/batch.h"
#include "kernel/batch_isa.h"

typedef struct {
    jlt_chart_top chart;
    double worst[DRIFT_ORBITS], early[DRIFT_ORBITS], E[DRIFT_ORBITS];
    size_t returns;
    const char *name;
    FILE *table;
} drift_batch;

static inline int drift_batch_row(void *context, size_t orbit, size_t number, const double *x)
{
    drift_batch *w = context;
    w->worst[orbit] = fmax(w->worst[orbit], fabs(jlt_chart_top_energy(&w->chart, x) - w->E[orbit]) / w->E[orbit]);
    if (number == w->returns / 100) w->early[orbit] = w->worst[orbit];
    size_t leading = number;
    while (leading % 10 == 0) leading /= 10;
    if (leading == 1 || leading == 2 || leading == 5)
        table_row(w->table, "%s,level,%s,1e-12,%zu,%.3e", drift_orbits[orbit].name, w->name, number, w->worst[orbit]);
    return 0;
}

static inline int drift_batch_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)orbit, (void)returns, (void)x;
    assert_int_equal(end, JLT_LANE_DONE);
    return 0;
}

/* Compute `worst` and `early` of all orbits, at tolerance 1e-12. */
static inline void drift_batch_follow(drift_batch *w, bool project)
{
    const double params[] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, -0.56 };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top_level", NULL, "regular", NULL);
    double starts[DRIFT_ORBITS][5];
    jlt_instance *instance = NULL;

    jlt_chart_top_init(&w->chart, 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, 2.15, -0.56);
    for (int i = 0; i < DRIFT_ORBITS; i++) {
        assert_ok(w->chart.base.lift(&w->chart.base, starts[i], NULL, drift_orbits[i].q));
        w->E[i] = jlt_chart_top_energy(&w->chart, starts[i]);
    }
    assert_ok(jlt_instance_create(&instance, d, params));
    const jlt_batch_map map = { .kernels = jlt_batch_isa_best(d, 0),
                                .dim = 5,
                                .column = 2,
                                .direction = 1,
                                .cases = &(jlt_batch_case){ .p = instance->prepared, .params = instance->params },
                                .root = 4,
                                .root_floor = 1e-10,
                                .tolerance = 1e-12,
                                .max_steps = SIZE_MAX,
                                .project = project ? d : NULL };
    assert_ok(jlt_batch_section(&map, starts[0], DRIFT_ORBITS, w->returns, drift_batch_row, drift_batch_end, w, NULL));
    jlt_instance_destroy(instance);
}

/* Check that the drift of a projected batch stays below one tolerance, however many returns there were. The energy is evaluated at
 * crossings, which lie at most one return after a projection, so that its error is at most that of one return. */
static inline void drift_batch_stays(size_t returns, FILE *table)
{
    drift_batch w = { .returns = returns, .name = "batch projected", .table = table };

    drift_batch_follow(&w, true);
    for (int i = 0; i < DRIFT_ORBITS; i++) {
        print_message("%-8s batch projected, %zu returns: %.1e after %zu, %.1e at the end\n", drift_orbits[i].name, returns,
                      w.early[i], returns / 100, w.worst[i]);
        assert_below(w.worst[i], 1e-12);
    }
}

#endif
