/* A batched section map asks for the same memory however many rows go by, and a section's batch for a bounded one. */
#include "unit/check.h"

#include <stdlib.h>

#include "fault/wrapped_memory.h"
#include "dynamics/section_batch.h"
#include "witness/top_section.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"

static size_t asked; /* bytes, by all threads */

static void count(size_t size)
{
    __atomic_fetch_add(&asked, size, __ATOMIC_RELAXED);
}

void *__wrap_malloc(size_t size)
{
    count(size);
    return __real_malloc(size);
}

void *__wrap_calloc(size_t number, size_t size)
{
    count(number * size);
    return __real_calloc(number, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    count(size);
    return __real_realloc(old, size);
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    count(size);
    return __real_aligned_alloc(alignment, size);
}

enum { ORBITS = 64, STATES = 5 };

static int ignore_row(void *rows, size_t orbit, size_t number, const double *x)
{
    (void)orbit, (void)number, (void)x;
    __atomic_fetch_add((size_t *)rows, 1, __ATOMIC_RELAXED);
    return 0;
}

static int ignore_end(void *rows, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)rows, (void)orbit, (void)end, (void)returns, (void)x;
    return 0;
}

static size_t asked_for(const jlt_batch_map *map, const double *starts, size_t returns)
{
    size_t rows = 0;

    asked = 0;
    assert_int_equal(jlt_batch_section(map, starts, ORBITS, returns, ignore_row, ignore_end, &rows, NULL), JLT_OK);
    assert_int_equal(rows, ORBITS * returns);
    return asked;
}

static void a_hundred_times_the_rows_ask_for_the_same_memory(void **unused)
{
    /* (5.1), m = R = g = 1, and a start inside the regular island: gamma3, v_nu, omega_tau, v_tau, s. */
    static const double params[] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, -0.56 };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top_level", NULL, "regular", NULL);
    double block[256], starts[ORBITS][STATES];

    (void)unused;
    assert_non_null(d);
    assert_true(d->prepared_count <= 256);
    d->prepare(params, block);
    for (int i = 0; i < ORBITS; i++) {
        const double start[STATES] = { -0.635, 0.71925991434627578, 0, 1.368961034630924, 0.7725121358270043 };
        for (int k = 0; k < STATES; k++) starts[i][k] = start[k];
    }
    for (unsigned threads = 1; threads <= 2; threads++) {
        const jlt_batch_map map = { .kernels = jlt_batch_isa_best(d, 0),
                                    .cases = &(jlt_batch_case){ .p = block },
                                    .dim = STATES,
                                    .column = 2,
                                    .direction = 1,
                                    .root = 4,
                                    .root_floor = 1e-9,
                                    .tolerance = 1e-8,
                                    .max_steps = 1000000,
                                    .threads = threads };
        const size_t few = asked_for(&map, starts[0], 20);
        assert_true(few > 0);
        assert_int_equal(asked_for(&map, starts[0], 2000), few);
    }
}

/* Rows in memory are 256 MiB of all orbits together; beside them stand some 100 bytes an orbit. Their starts, gamma3 = 2, have
 * no state, so that none is followed. */
static void rows_of_many_orbits_ask_for_bounded_memory(void **unused)
{
    const jlt_top_values values = jlt_system_top_defaults();
    const size_t orbits = 1024 * 256;
    double *q = malloc(2 * orbits * sizeof *q);
    jlt_section_batch *batch;
    jlt_system *system;

    (void)unused;
    assert_non_null(q);
    for (size_t i = 0; i < 2 * orbits; i++) q[i] = 2;
    assert_int_equal(jlt_system_top(&system, &values, NULL), JLT_OK);
    assert_int_equal(jlt_section_batch_create(&batch, &system->flow, jlt_batch_isa_best(system->instance->descriptor, 0),
                                              &(jlt_section_batch_options){ .threads = 1 }), JLT_OK);
    asked = 0;
    assert_int_equal(jlt_section_batch_run(batch, q, orbits, 1024), JLT_OK);
    assert_in_range(asked, 1, ((size_t)1 << 28) + 200 * orbits);
    jlt_section_batch_destroy(batch);
    jlt_system_destroy(system);
    free(q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hundred_times_the_rows_ask_for_the_same_memory),
        cmocka_unit_test(rows_of_many_orbits_ask_for_bounded_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
