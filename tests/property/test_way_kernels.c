/* Kernels of ways between tables, at random points of every field that has one: the way leads to a point from which `back`
 * comes back, and the two fields move alike there; kernels of `lifted` and of tiers against closed forms.
 *
 * Tolerance: one relative unit roundoff in every state and parameter moves the point that is reached by what differences of
 * the kernels tell, and that in turn the point that is come back to; the rounding of up to 64 operations a value is 64
 * times as much. The motion is the difference of `back` along the other field, over a step h: its own error is h^2 and
 * eps/h, so that h = eps^(1/3); 1000 times h^2 bounds it, third derivatives being some hundreds at points of order one away
 * from poles. */
#include "unit/check.h"

#include "base/random.h"
#include "registry.h"

#include <float.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 32, POINTS = 200, OPERATIONS = 64 };
static uint64_t random_state = 11;

static double draw(double low, double high)
{
    return low + (high - low) * ((double)(ttc_random_bits(&random_state) >> 11) * 0x1p-53);
}

/* A point of a field, with its parameters; of the other one, after it, y and values. */
typedef struct {
    double x[MOST], params[MOST];
} place;

static const jlt_descriptor *other_field(const jlt_way *way)
{
    for (unsigned i = 0; i < jlt_registry_count; i++) {
        const jlt_descriptor *d = jlt_registry[i];
        if (strcmp(d->sha256, way->sha256) == 0 && strcmp(d->time, way->time) == 0 && *d->variant == '\0' &&
            *d->elimination == '\0')
            return d;
    }
    fail_msg("%s leads to a field that is not there", way->name);
    return NULL;
}

/* Where the way leads. */
static void lead(place *to, const jlt_way *way, const jlt_descriptor *other, const place *from)
{
    double pairs[2 * MOST], plain[MOST];
    way->coordinates(from->x, from->params, pairs);
    way->params(from->x, from->params, to->params);
    for (unsigned i = 0; i < way->param_count; i++)
        if (way->is_root[i]) to->params[i] = sqrt(to->params[i]);
    for (unsigned i = 0; i < way->coordinate_count; i++)
        plain[i] = way->is_angle[i] ? atan2(pairs[2 * i], pairs[2 * i + 1]) : pairs[2 * i];
    if (other->lifted != NULL) other->lifted(plain, to->params, to->x);
    else memcpy(to->x, plain, way->coordinate_count * sizeof *plain);
}

static bool draw_place(place *p, const jlt_descriptor *d, const jlt_way *way)
{
    double own[MOST], values[MOST];
    for (unsigned i = 0; i < d->param_count; i++)
        p->params[i] = d->params[i].sign == JLT_ANY_SIGN ? draw(-1, 1) : draw(0.2, 2);
    for (unsigned i = 0; i < d->state_count; i++) {
        const bool bounded = isfinite(d->states[i].low) && isfinite(d->states[i].high);
        own[i] = bounded ? draw(0.9 * d->states[i].low, 0.9 * d->states[i].high) : draw(-2, 2);
    }
    for (unsigned i = 0; way != NULL && i < way->condition_count; i++) {
        char name[64];
        double value;
        if (!way->conditions[i].is_zero) continue;
        assert_int_equal(sscanf(way->conditions[i].text, "%63s = %lf", name, &value), 2);
        for (unsigned k = 0; k < d->param_count; k++)
            if (strcmp(d->params[k].name, name) == 0) p->params[k] = value;
    }
    if (d->lifted != NULL) d->lifted(own, p->params, p->x);
    else memcpy(p->x, own, d->state_count * sizeof *own);
    if (way == NULL || way->condition_count == 0) return true;
    way->condition_values(p->x, p->params, values);
    for (unsigned i = 0; i < way->condition_count; i++)
        if (way->conditions[i].is_zero ? values[i] != 0 : !(values[i] > 0.01)) return false;
    return true;
}

/* What `call` does to its input's number k, of states and then of parameters, moved by a part of itself, in units of that
 * part. */
static void spread(double *out, unsigned count, void (*call)(double *out, const place *at, const void *context),
                   const void *context,
                   const place *at, unsigned k, unsigned states)
{
    const double part = 0x1p-20;
    place moved = *at;
    double here[2 * MOST], there[2 * MOST], *entry = k < states ? moved.x + k : moved.params + (k - states);
    *entry += part * fabs(*entry);
    call(here, at, context);
    call(there, &moved, context);
    for (unsigned i = 0; i < count; i++) out[i] = fabs(there[i] - here[i]) / part;
}

typedef struct {
    const jlt_way *way;
    const jlt_descriptor *own, *other;
} link_of;

static void call_lead(double *out, const place *at, const void *context)
{
    const link_of *l = context;
    place to;
    lead(&to, l->way, l->other, at);
    memcpy(out, to.x, l->way->state_count * sizeof *out);
    memcpy(out + l->way->state_count, to.params, l->way->param_count * sizeof *out);
}

static void call_back(double *out, const place *at, const void *context)
{
    const link_of *l = context;
    l->way->back(at->x, at->params, out);
}

static void comes_back(const link_of *l, const place *from, const place *to)
{
    const unsigned n = l->own->state_count, m = l->way->state_count, inputs = n + l->own->param_count;
    double there[2 * MOST] = { 0 }, back[MOST] = { 0 }, moved[2 * MOST], x[MOST];
    for (unsigned k = 0; k < inputs; k++) {
        spread(moved, m + l->way->param_count, call_lead, l, from, k, n);
        for (unsigned i = 0; i < m + l->way->param_count; i++) there[i] += moved[i];
    }
    for (unsigned k = 0; k < m + l->way->param_count; k++) {
        const double size = fabs(k < m ? to->x[k] : to->params[k - m]);
        spread(moved, n, call_back, l, to, k, m);
        for (unsigned i = 0; i < n; i++) back[i] += moved[i] * (1 + (size > 0 ? there[k] / size : 0));
    }
    l->way->back(to->x, to->params, x);
    for (unsigned i = 0; i < n; i++)
        assert_near(x[i], from->x[i], OPERATIONS * DBL_EPSILON * (fabs(from->x[i]) + back[i]) + OPERATIONS * DBL_EPSILON);
}

static void moves_alike(const link_of *l, const place *from, const place *to)
{
    const double h = 0x1p-17; /* eps^(1/3) */
    double block[40 * MOST], own[MOST], other[MOST], ahead[MOST], behind[MOST], y[MOST], factor = 1;
    assert_true(l->own->prepared_count <= 40 * MOST && l->other->prepared_count <= 40 * MOST);
    l->other->prepare(to->params, block);
    l->other->rhs.call(to->x, block, other);
    l->own->prepare(from->params, block);
    l->own->rhs.call(from->x, block, own);
    if (strcmp(l->own->time, l->way->time) != 0) l->own->time_factor.call(from->x, block, &factor);
    for (unsigned i = 0; i < l->way->state_count; i++) y[i] = to->x[i] + h * other[i];
    l->way->back(y, to->params, ahead);
    for (unsigned i = 0; i < l->way->state_count; i++) y[i] = to->x[i] - h * other[i];
    l->way->back(y, to->params, behind);
    for (unsigned i = 0; i < l->own->state_count; i++) {
        const double rate = (ahead[i] - behind[i]) / (2 * h), size = 1 + fabs(rate) + fabs(own[i] / factor);
        assert_near(rate, own[i] / factor, 1000 * h * h * size * size * size);
    }
}

static void ways_lead_there_and_back(void **state)
{
    unsigned ways = 0, points = 0;
    (void)state;
    for (unsigned d = 0; d < jlt_registry_count; d++)
        for (unsigned i = 0; i < jlt_registry[d]->way_count; i++) {
            const link_of l = { jlt_registry[d]->ways + i, jlt_registry[d], other_field(jlt_registry[d]->ways + i) };
            assert_true(l.way->state_count == l.other->state_count && l.way->param_count == l.other->param_count);
            assert_true(l.way->state_count <= MOST && l.way->param_count <= MOST);
            assert_int_equal(l.own->claims[l.way->claim].verdict, JLT_PROVED);
            assert_string_equal(l.own->claims[l.way->claim].name, l.way->name);
            assert_string_equal(l.own->claims[l.way->claim].target, l.way->sha256);
            for (unsigned k = 0; k < POINTS; k++) {
                place from, to;
                if (!draw_place(&from, l.own, l.way)) continue;
                lead(&to, l.way, l.other, &from);
                comes_back(&l, &from, &to);
                moves_alike(&l, &from, &to);
                points++;
            }
            ways++;
        }
    print_message("%u ways, %u points\n", ways, points);
    assert_true(ways >= 10 && points >= ways * POINTS / 4);
}

static const jlt_descriptor *field(const char *model, const char *time)
{
    for (unsigned i = 0; i < jlt_registry_count; i++) {
        const jlt_descriptor *d = jlt_registry[i];
        if (strcmp(d->model, model) == 0 && strcmp(d->time, time) == 0 && *d->variant == '\0' &&
            *d->elimination == '\0') return d;
    }
    fail_msg("%s is not there", model);
    return NULL;
}

/* Every time of the project's tables lifts s = sqrt((1 - gamma3) (1 + gamma3)), after the states that the field has in its
 * own. */
static void lifted_adds_the_root(void **state)
{
    unsigned fields = 0;
    (void)state;
    for (unsigned i = 0; i < jlt_registry_count; i++) {
        const jlt_descriptor *d = jlt_registry[i];
        assert_true(d->lifted == NULL || *d->time != '\0');
        if (strncmp(d->model, "spherical_top", 13) != 0 || *d->time == '\0') continue;
        assert_non_null(d->lifted);
        for (unsigned k = 0; k < POINTS; k++) {
            double own[MOST], x[MOST], params[MOST];
            const unsigned n = d->state_count - 1;
            for (unsigned j = 0; j < n; j++) own[j] = draw(-2, 2);
            for (unsigned j = 0; j < d->param_count; j++) params[j] = draw(0.2, 2);
            own[0] = k == 0 ? -1 : k % 2 ? 1 - exp(draw(-36, 0)) : draw(-1, 1);
            d->lifted(own, params, x);
            assert_memory_equal(x, own, n * sizeof *x);
            const double s = sqrt((1 - own[0]) * (1 + own[0]));
            assert_near(x[n], s, 2 * DBL_EPSILON * s); /* by factors, next to a pole as well */
        }
        fields++;
    }
    assert_true(fields >= 20);
}

/* 50 m I1^2 v_slip^2 is more than |F0|; v_slip by `back` into the table in which it is a state. */
static void tier_of_the_plane_tells_its_digits(void **state)
{
    static const char *const times[] = { "", "regular" };
    unsigned points = 0;
    (void)state;
    for (unsigned t = 0; t < 2; t++) {
        const jlt_descriptor *plane = field("spherical_top_plane", times[t]), *whole = field("spherical_top_balanced",
                                                                                             times[t]);
        assert_string_equal(plane->tier, "plane");
        assert_int_equal(plane->tier_condition_count, 2);
        assert_string_equal(plane->tier_conditions[1].text, "50*m*I1^2*v_slip^2 + F0 > 0");
        for (unsigned k = 0; k < POINTS; k++) {
            place from, to;
            double values[2], x[MOST];
            if (!draw_place(&from, whole, whole->ways)) continue;
            lead(&to, whole->ways, plane, &from);
            whole->ways->back(to.x, to.params, x);
            plane->tier_values(to.x, to.params, values);
            const double size = 50 * to.params[0] * to.params[2] * to.params[2] * x[1] * x[1], level = to.params[6];
            assert_near(values[0], size - level, 8 * DBL_EPSILON * (size + fabs(level)));
            assert_near(values[1], size + level, 8 * DBL_EPSILON * (size + fabs(level)));
            points++;
        }
    }
    assert_true(points >= POINTS / 2);
}

static void tier_of_the_full_system_ends_near_a_pole(void **state)
{
    const jlt_descriptor *full = field("spherical_top_full", "");
    double x[MOST] = { 0 }, params[MOST] = { 1, 1, 1, 0, 1, 1 }, value;
    (void)state;
    assert_string_equal(full->tier, "full");
    x[0] = 0x1p-18;
    full->tier_values(x, params, &value);
    assert_true(value == 0); /* 2^-36 is both, exactly */
    x[1] = 0x1p-20;
    full->tier_values(x, params, &value);
    assert_true(value == 0x1p-40);
    assert_null(field("spherical_top_track", "")->tier_values);
    assert_null(field("lorenz", "")->tier);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ways_lead_there_and_back),
        cmocka_unit_test(lifted_adds_the_root),
        cmocka_unit_test(tier_of_the_plane_tells_its_digits),
        cmocka_unit_test(tier_of_the_full_system_ends_near_a_pole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
