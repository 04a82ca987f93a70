/* Coordinates of every tier: written whole, no further, and back to the state they came from. */
#include "unit/check.h"

#include "kernel/descriptor.h"
#include "kernel/observed.h"
#include "scene/tier.h"
#include "top/top.h"

enum { ROOM = 32 };

typedef struct {
    jlt_top top;
    double x[JLT_TOP_STATES];
} sample;

/* A balanced sphere, on either half of M^2, and two that are not. */
static const sample samples[] = {
    { { 1, 1, 1, 0, 0.4, 0.25 }, { 0.3, 0.5, 0.2, 0.3, 0.9 } },
    { { 1, 1, 1, 0, 0.25, 0.4 }, { 0.3, -1.5, 0.2, 0.3, 0.2 } },
    { { 1.3, 0.7, 9.81, -0.12, 0.29, 0.21 }, { 0.25, 0.8, -0.6, 1.1, -2.3 } },
    { { 1, 1, 1, 0.3, 0.7, 0 }, { 0.2, 0.6, 0.4, 1.3, -0.8 } },
};

static void poison(double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) values[i] = NAN;
}

/* Extraction divides by s > 0.9 and b > 0.05 after sums of up to six terms below 10: some 20 roundings of 200. */
static const double bound = 20 * 200 * 2.3e-16;

/* The track starts with the contact point at the origin, nu along alpha, and the axis in the plane of nu: so say the quantities
 * that the larger tables observe. */
static void check_track(const jlt_tier_view *view, const double *y, const double *x)
{
    static const jlt_units none = { 0 };
    static const char *const names[] = { "x_contact", "y_contact", "x_axis", "y_axis" };
    const double wanted[] = { 0, 0, sqrt(1 - x[JLT_TOP_GAMMA3] * x[JLT_TOP_GAMMA3]), 0 };
    double values[ROOM];
    jlt_observed *observed;

    assert_int_equal(jlt_observed_create(&observed, view->instance->descriptor, view->instance->params, &none), JLT_OK);
    assert_true(jlt_observed_count(observed) <= ROOM);
    jlt_observed_values(observed, values, y);
    for (unsigned k = 0; k < sizeof names / sizeof *names; k++) {
        unsigned i = 0;
        while (i < jlt_observed_count(observed) && strcmp(jlt_observed_quantities(observed)[i].name, names[k]) != 0) i++;
        assert_true(i < jlt_observed_count(observed));
        assert_near(values[i], wanted[k], bound);
    }
    jlt_observed_destroy(observed);
}

static unsigned check_tier(const jlt_tier *tier, const sample *s)
{
    const double params[] = { s->top.m, s->top.R, s->top.g, s->top.a3, s->top.I1, s->top.I3 };
    double y[JLT_WAY_VALUES_MAX], x[JLT_TOP_STATES];
    char refusal[JLT_TIER_TEXT_MAX];
    jlt_tier_view view;

    poison(y, ROOM);
    poison(x, JLT_TOP_STATES);
    if (tier->table == NULL || jlt_tier_open(&view, y, refusal, tier, params, s->x) != JLT_OK) return 0;
    const jlt_descriptor *kernel = view.instance->descriptor;
    for (unsigned i = 0; i < ROOM; i++)
        if (isfinite(y[i]) != (i < kernel->state_count)) fail_msg("%s: column %u is %g", tier->name, i, y[i]);
    jlt_tier_extract(&view, x, y);
    for (unsigned i = 0; i < JLT_TOP_STATES; i++) assert_near(x[i], s->x[i], bound);
    if (strcmp(tier->name, "track") == 0 || strcmp(tier->name, "full") == 0) check_track(&view, y, s->x);
    jlt_tier_close(&view);
    return 1;
}

static void every_tier_writes_all_its_columns_and_gives_the_state_back(void **unused)
{
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned count = jlt_tier_list(tiers, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL);

    (void)unused;
    assert_int_equal(count, 13);
    for (unsigned k = 0; k < count; k++) {
        unsigned checked = 0;
        for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) checked += check_tier(&tiers[k], &samples[i]);
        if (tiers[k].table != NULL && checked == 0) fail_msg("no sample for %s", tiers[k].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tier_writes_all_its_columns_and_gives_the_state_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
