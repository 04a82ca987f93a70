/* Problems that differ by units of mass, length and time, powers of two, have solutions that differ by them: to the last bit, since
 * nothing is rounded by such a change. Random tops, also without gravity, as a rod, balanced, with the centre of mass outside, on
 * the level G = 0; all methods, batches, derivatives and tiers. */
#include "unit/check.h"

#include "core/random.h"
#include "dynamics/map.h"
#include "dynamics/section_batch.h"
#include "witness/top_section.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "scene/course.h"
#include "scene/course_more.h"
#include "top/top.h"

enum { TOPS = 24, SCALES = 2, RETURNS = 4 };

static int random_exponent(jlt_random *random)
{
    return (int)jlt_random_between(random, -30, 31);
}

static jlt_units random_units(jlt_random *random)
{
    return (jlt_units){ random_exponent(random), random_exponent(random), random_exponent(random) };
}

static double either(jlt_random *random, double rare, double usual)
{
    return jlt_random_between(random, 0, 1) < 0.2 ? rare : usual;
}

static double decades(jlt_random *random, double low, double high)
{
    return pow(10, jlt_random_between(random, low, high));
}

/* A top with states on its level, and the interval of gamma3 where they are. */
static jlt_top_values random_top(double *low, double *high, jlt_random *random)
{
    for (;;) {
        jlt_top_values v = { .m = decades(random, -1, 2), .R = decades(random, -1, 2) };
        jlt_chart_top chart;
        v.g = either(random, 0, decades(random, -3, 1));
        v.I1 = v.m * v.R * v.R * decades(random, -1.5, 0.5);
        v.I3 = either(random, 0, v.I1 * decades(random, -1, 0.3));
        v.a3 = either(random, 0, v.R * jlt_random_between(random, -1.3, 1.3));
        v.E = v.m * decades(random, -5, 2) - either(random, v.m * v.g * fabs(v.a3), 0);
        v.G = either(random, 0, v.R * sqrt(fabs(v.E) * v.I1) * jlt_random_between(random, -1, 1));
        jlt_chart_top_init(&chart, v.m, v.R, v.g, v.I1, v.I3, v.a3, v.E, v.G);
        if (jlt_chart_top_interval(&chart, low, high)) return v;
    }
}

static jlt_top_values scaled(const jlt_top_values *v, const jlt_units *u)
{
    const int m = u->mass, l = u->length, t = u->time;

    return (jlt_top_values){ .m = ldexp(v->m, m), .R = ldexp(v->R, l), .g = ldexp(v->g, l - 2 * t), .I1 = ldexp(v->I1, m + 2 * l),
                             .I3 = ldexp(v->I3, m + 2 * l), .a3 = ldexp(v->a3, l), .E = ldexp(v->E, m + 2 * l - 2 * t),
                             .G = ldexp(v->G, m + 3 * l - t) };
}

static void assert_same(double value, double base, int exponent)
{
    assert_near(value, ldexp(base, exponent), 0);
}

/* The states of the level's section. */
static void assert_same_states(const double *x, const double *base, const jlt_units *u)
{
    const int v = u->length - u->time, exponents[] = { 0, v, -u->time, v, 0 };

    for (unsigned i = 0; i < 5; i++) assert_same(x[i], base[i], exponents[i]);
}

static void assert_same_row(const jlt_return *row, const jlt_return *base, const jlt_units *u)
{
    assert_int_equal(row->fate, base->fate);
    assert_int_equal(row->direction, base->direction);
    for (unsigned k = 0; k < 2 && !isnan(base->q[k]); k++) assert_same(row->q[k], base->q[k], 0);
    assert_same_states(row->x, base->x, u);
    assert_same(row->t, base->t, u->time);
    if (isfinite(base->least)) assert_same(row->least, base->least, u->mass + u->length - 2 * u->time);
}

static void same_returns(const jlt_system *first, const jlt_system *second, const double *q, const jlt_units *u)
{
    jlt_section *a, *b;
    jlt_return row, base;
    jlt_status st;

    assert_ok(jlt_section_create(&a, &first->flow));
    assert_ok(jlt_section_create(&b, &second->flow));
    assert_ok(jlt_section_start(a, &base, q, 1));
    assert_ok(jlt_section_start(b, &row, q, 1));
    assert_same_row(&row, &base, u);
    for (int i = 0; i < RETURNS && base.fate == JLT_FATE_ALIVE; i++) {
        st = jlt_section_next(a, &base);
        assert_int_equal(jlt_section_next(b, &row), st);
        if (st != JLT_OK) break;
        assert_same_row(&row, &base, u);
    }
    jlt_section_destroy(a);
    jlt_section_destroy(b);
}

static void same_batches(const jlt_system *first, const jlt_system *second, const double *q, size_t count, const jlt_units *u)
{
    jlt_section_batch *a, *b;
    const jlt_section_batch_options options = { .threads = 1 };

    assert_ok(jlt_section_batch_create(&a, &first->flow, first->field.batch, &options));
    assert_ok(jlt_section_batch_create(&b, &second->flow, second->field.batch, &options));
    assert_ok(jlt_section_batch_run(a, q, count, RETURNS));
    assert_ok(jlt_section_batch_run(b, q, count, RETURNS));
    for (size_t i = 0; i < count; i++) {
        jlt_return row, base;
        assert_ok(jlt_section_batch_start(a, &base, i));
        assert_ok(jlt_section_batch_start(b, &row, i));
        assert_same_row(&row, &base, u);
        for (int k = 0; k < RETURNS && base.fate == JLT_FATE_ALIVE; k++) {
            const jlt_status st = jlt_section_batch_next(a, &base);
            assert_int_equal(jlt_section_batch_next(b, &row), st);
            if (st != JLT_OK) break;
            assert_same_row(&row, &base, u);
        }
    }
    jlt_section_batch_destroy(a);
    jlt_section_batch_destroy(b);
}

static void same_derivatives(const jlt_system *first, const jlt_system *second, const double *q, const jlt_units *u)
{
    jlt_map *a, *b;
    jlt_image image, base;
    jlt_status st;

    assert_ok(jlt_map_create(&a, &first->flow));
    assert_ok(jlt_map_create(&b, &second->flow));
    st = jlt_map_apply(a, &base, q, 1, 1);
    assert_int_equal(jlt_map_apply(b, &image, q, 1, 1), st);
    for (unsigned k = 0; st == JLT_OK && k < 4; k++) assert_same(image.slope[k], base.slope[k], 0);
    if (st == JLT_OK) assert_same_states(image.x, base.x, u);
    if (st == JLT_OK) assert_same(image.T, base.T, u->time);
    jlt_map_destroy(a);
    jlt_map_destroy(b);
}

static void scaled_sections_are_the_same(void **unused)
{
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 5);
    for (int i = 0; i < TOPS; i++) {
        enum { STARTS = 6 };
        double low, high, q[2 * STARTS];
        const jlt_top_values v = random_top(&low, &high, &random);
        for (int k = 0; k < STARTS; k++) {
            q[2 * k] = jlt_random_between(&random, -3.1, 3.1);
            q[2 * k + 1] = low + (high - low) * jlt_random_between(&random, 0.05, 0.95);
        }
        for (int n = 0; n < SCALES; n++) {
            const jlt_units u = random_units(&random);
            const jlt_top_values w = scaled(&v, &u);
            for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
                const jlt_flow options = {
                    .method = jlt_method_at(m), .direction = JLT_BOTH, .tolerance = 1e-9, .max_steps = 2000
                };
                jlt_system *first, *second;
                assert_ok(jlt_system_top(&first, &v, &options));
                assert_ok(jlt_system_top(&second, &w, &options));
                same_returns(first, second, q, &u);
                if (m == 0) same_batches(first, second, q, STARTS, &u);
                if (m < 2) same_derivatives(first, second, q, &u);
                jlt_system_destroy(first);
                jlt_system_destroy(second);
            }
        }
    }
}

/* The course of a tier from the state x to some times; -1 where the tier does not serve. Rows: t, states, drifts, force, track. */
enum { TIMES = 3, COLUMNS = 16 };

static const char *const track[] = { "x", "y", "x_contact", "y_contact" };

static double told(const jlt_course *course, const jlt_course_row *row, const char *name)
{
    const jlt_quantity *more;
    const unsigned count = jlt_course_tells_more(course, &more, NULL);

    for (unsigned i = 0; i < count; i++)
        if (strcmp(more[i].name, name) == 0) return row->more[i];
    return NAN;
}

static int course_rows(double rows[TIMES][COLUMNS], const jlt_top_values *v, const double *x, double until, const jlt_tier *tier,
                       const jlt_method *method)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    const double params[] = { v->m, v->R, v->g, v->a3, v->I1, v->I3 };
    const jlt_question question = {
        .model = model, .params = params, .start = x, .more = jlt_course_more_is_told(tier->table, model), .tier = tier->name
    };
    const jlt_course_options options = { .method = method, .tolerance = 1e-9, .max_steps = 2000 };
    jlt_course *course;
    jlt_plan plan;
    int made = 0;

    if (jlt_plan_make(&plan, &question) != JLT_OK || jlt_course_create(&course, &plan, &question, &options) != JLT_OK) return -1;
    for (int i = 0; i < TIMES; i++) {
        jlt_course_row row;
        if (jlt_course_to(course, until * i / (TIMES - 1), &row) != JLT_OK) break;
        double *out = rows[made++];
        memset(out, 0, COLUMNS * sizeof *out);
        out[0] = row.t;
        memcpy(out + 1, row.x, JLT_TOP_STATES * sizeof *out);
        out[6] = row.observed[0];
        for (int k = 0; k < 4 && row.more != NULL; k++) out[7 + k] = told(course, &row, track[k]);
        memcpy(out + 11, row.drift, 2 * sizeof *out);
        out[13] = row.end;
        if (row.end != JLT_END_TIME) break;
    }
    jlt_course_destroy(course);
    return made;
}

static void scaled_courses_are_the_same(void **unused)
{
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned tier_count = jlt_tier_list(tiers, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL);
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 6);
    for (int i = 0; i < TOPS; i++) {
        double low, high;
        const jlt_top_values v = random_top(&low, &high, &random);
        const double speed = sqrt(fabs(v.E) / v.m), rate = speed / v.R;
        const double x[] = { jlt_random_between(&random, -0.9, 0.9), speed * jlt_random_between(&random, -1, 1),
                             rate * jlt_random_between(&random, -1, 1), rate * jlt_random_between(&random, -1, 1),
                             rate * jlt_random_between(&random, -1, 1) };
        const jlt_units u = random_units(&random);
        const int s = u.length - u.time,
                  exponents[COLUMNS] = { u.time,   0,        s,        -u.time, -u.time, -u.time, u.mass + u.length - 2 * u.time,
                                         u.length, u.length, u.length, u.length };
        const jlt_top_values w = scaled(&v, &u);
        double y[JLT_TOP_STATES];
        for (int k = 0; k < JLT_TOP_STATES; k++) y[k] = ldexp(x[k], exponents[1 + k]);
        for (unsigned n = 0; n < tier_count; n++)
            for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
                double base[TIMES][COLUMNS], rows[TIMES][COLUMNS];
                const int made = course_rows(base, &v, x, 2 / rate, &tiers[n], jlt_method_at(m));
                assert_int_equal(course_rows(rows, &w, y, ldexp(2 / rate, u.time), &tiers[n], jlt_method_at(m)), made);
                for (int k = 0; k < made; k++)
                    for (int c = 0; c < COLUMNS; c++)
                        if (isfinite(base[k][c])) assert_same(rows[k][c], base[k][c], exponents[c]);
            }
    }
}

/* The top's tables have a dimension in every term, in either time; Lorenz' numbers have none. */
static void a_field_scales_where_its_terms_have_dimensions(void **unused)
{
    static const char *const models[] = { "spherical_top", "spherical_top_level", "spherical_top_full" };

    (void)unused;
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        const jlt_descriptor *d = jlt_descriptor_find(models[i], NULL, NULL, NULL);
        assert_non_null(d);
        for (; d != NULL; d = d->time[0] == '\0' ? jlt_descriptor_sibling(d, NULL, "regular", NULL) : NULL)
            assert_int_equal(d->scales, 1);
    }
    assert_int_equal(jlt_descriptor_find("lorenz", NULL, NULL, NULL)->scales, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_field_scales_where_its_terms_have_dimensions),
        cmocka_unit_test(scaled_sections_are_the_same),
        cmocka_unit_test(scaled_courses_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
