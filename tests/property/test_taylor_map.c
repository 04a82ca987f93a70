/* Series whose starts are polynomials against the flow's own law, phi_t(phi_u(x)) = phi_(t+u)(x); the normal form of a map of
 * the plane against Henon's closed form, in its own coordinates and in others. */
#include "unit/check.h"

#include "kernel/descriptor.h"
#include "validated/jets.h"
#include "validated/normal_form.h"

enum { BITS = 200, ORDER = 8, DEGREE = 3, TERMS = 10 };

/* Coefficients of the integral at the polynomial starts x, which are on one orbit: all but the first vanish. */
static void integral_is_kept(const jlt_descriptor *d, const char *name, arb_srcptr params, arb_srcptr x)
{
    jlt_formulas *formulas;
    jlt_jets *jets;

    assert_int_equal(jlt_formulas_create(&formulas, d, NULL, 0, &name, 1), JLT_OK);
    assert_int_equal(jlt_jets_create(&jets, formulas, formulas->levels, 0, DEGREE), JLT_OK);
    for (unsigned twice = 0; twice < 2; twice++) jlt_jets_run(jets, x, params, BITS); /* what a run leaves does not count */
    for (unsigned term = 1; term < TERMS; term++) {
        assert_true(arb_contains_zero(jlt_jets_output(jets, 0) + term));
        assert_true(mag_cmp_2exp_si(arb_radref(jlt_jets_output(jets, 0) + term), -100) < 0);
    }
    jlt_jets_destroy(jets);
    jlt_formulas_destroy(formulas);
}

/* x(u, v) = phi_(u + 2 v)(x) to degree 3 has the coefficients c_n binomial(n, j) 2^j, n = i + j, of u^i v^j, with c_n those in
 * time; and its series in time c_(k+n) binomial(k + n, k) of that. Parameters are 3/4, states from 1/3 on, where all tables here
 * are defined. */
static void flow_law(const char *model, const char *integral)
{
    const jlt_descriptor *d = jlt_descriptor_find(model, NULL, NULL, NULL);
    jlt_jets *plain, *full;
    jlt_formulas *formulas;
    arb_ptr params, x;
    arb_t wanted;

    assert_non_null(d);
    params = _arb_vec_init(d->param_count + 1);
    x = _arb_vec_init(d->state_count * TERMS);
    arb_init(wanted);
    for (unsigned i = 0; i < d->param_count; i++) arb_set_d(params + i, 0.75);
    assert_int_equal(jlt_formulas_create(&formulas, d, NULL, 0, NULL, 0), JLT_OK);
    assert_int_equal(jlt_jets_create(&plain, formulas, formulas->motion, ORDER, 0), JLT_OK);
    assert_int_equal(jlt_jets_create(&full, formulas, formulas->motion, ORDER, DEGREE), JLT_OK);
    for (unsigned i = 0; i < d->state_count; i++) {
        arb_set_ui(x + i, i + 2);
        arb_div_ui(x + i, x + i, 2 * i + 6, BITS);
    }
    jlt_jets_run(plain, x, params, BITS);
    for (unsigned i = 0; i < d->state_count; i++)
        for (unsigned n = 0; n <= DEGREE; n++)
            for (unsigned j = 0; j <= n; j++) {
                arb_bin_uiui(wanted, n, j, BITS);
                arb_mul_2exp_si(wanted, wanted, (slong)j);
                arb_mul(x + i * TERMS + n * (n + 1) / 2 + j, wanted, jlt_jets_state(plain, i) + n, BITS);
            }
    if (integral != NULL) integral_is_kept(d, integral, params, x);
    jlt_jets_run(full, x, params, BITS);
    for (unsigned i = 0; i < d->state_count; i++)
        for (unsigned n = 0; n <= DEGREE; n++)
            for (unsigned j = 0; j <= n; j++)
                for (unsigned k = 0; k + n <= ORDER; k++) {
                    arb_srcptr found = jlt_jets_state(full, i) + (n * (n + 1) / 2 + j) * (ORDER + 1) + k;
                    arb_t factor;
                    arb_init(factor);
                    arb_bin_uiui(wanted, k + n, k, BITS);
                    arb_bin_uiui(factor, n, j, BITS);
                    arb_mul(wanted, wanted, factor, BITS);
                    arb_mul_2exp_si(wanted, wanted, (slong)j);
                    arb_mul(wanted, wanted, jlt_jets_state(plain, i) + k + n, BITS);
                    assert_true(arb_overlaps(found, wanted));
                    assert_true(mag_cmp_2exp_si(arb_radref(found), -100) < 0);
                    arb_clear(factor);
                }
    jlt_jets_destroy(plain);
    jlt_jets_destroy(full);
    jlt_formulas_destroy(formulas);
    arb_clear(wanted);
    _arb_vec_clear(params, d->param_count + 1);
    _arb_vec_clear(x, d->state_count * TERMS);
}

static void series_of_polynomials_obey_the_flow_law(void **unused)
{
    (void)unused;
    flow_law("spherical_top_level", "E"); /* roots, quotients */
    flow_law("spherical_top_track", NULL); /* cosine, sine */
    flow_law("toda", "H");                 /* exponentials */
    flow_law("lotka_volterra", "H");       /* logarithms, in its integral */
}

/* out = sum of f_ij g_1^i g_2^j, cut off, of one polynomial f; g, shape (2, TERMS), has no constant coefficients. */
static void compose(arb_ptr out, arb_srcptr f, arb_srcptr g)
{
    arb_ptr power = _arb_vec_init(TERMS), next = _arb_vec_init(TERMS);

    _arb_vec_zero(out, TERMS);
    for (unsigned n = 1; n <= DEGREE; n++)
        for (unsigned j = 0; j <= n; j++) {
            _arb_vec_zero(power, TERMS);
            arb_one(power);
            for (unsigned k = 0; k < n; k++) {
                arb_srcptr by = g + (k < j ? TERMS : 0);
                _arb_vec_zero(next, TERMS);
                for (unsigned a = 0; a <= DEGREE; a++)
                    for (unsigned b = 1; a + b <= DEGREE; b++)
                        for (unsigned i = 0; i <= a; i++)
                            for (unsigned l = 0; l <= b; l++)
                                arb_addmul(next + (a + b) * (a + b + 1) / 2 + i + l, power + a * (a + 1) / 2 + i,
                                           by + b * (b + 1) / 2 + l, BITS);
                _arb_vec_swap(power, next, TERMS);
            }
            _arb_vec_scalar_addmul(out, power, TERMS, f + n * (n + 1) / 2 + j, BITS);
        }
    _arb_vec_clear(power, TERMS);
    _arb_vec_clear(next, TERMS);
}

static void compose_maps(arb_ptr out, arb_srcptr f, arb_srcptr g)
{
    compose(out, f, g);
    compose(out + TERMS, f + TERMS, g);
}

static void expect(arb_srcptr map, const arb_t trace, const arb_t twist)
{
    jlt_normal_form form;

    jlt_normal_form_init(&form);
    jlt_normal_form_compute(&form, map, trace, BITS);
    assert_true(arb_overlaps(form.twist, twist));
    assert_true(arb_contains_zero(form.growth));
    assert_true(mag_cmp_2exp_si(arb_radref(form.twist), -150) < 0 && mag_cmp_2exp_si(arb_radref(form.growth), -150) < 0);
    jlt_normal_form_clear(&form);
}

/* z -> lambda (z - i (Re z)^2), lambda = exp(i alpha), which keeps areas, turns by alpha - (3 cot(alpha/2) + cot(3 alpha/2))
 * |z|^2/16 (the map of M. Henon, Quart. Appl. Math. 27, 1969). In coordinates p = x + 2 y + x^2 - x y, q = 3 y it does not keep
 * them; p = Re((1 - 2i) z) to first order, so that the twist by the square of its amplitude is a fifth. x = p - 2 q/3 - x (x -
 * q/3) gives the way back. */
static void henon_map_twists_as_its_closed_form_says(void **unused)
{
    arb_ptr map = _arb_vec_init(2 * TERMS), there = _arb_vec_init(2 * TERMS), back = _arb_vec_init(2 * TERMS);
    arb_ptr part = _arb_vec_init(2 * TERMS), other = _arb_vec_init(2 * TERMS);
    arb_t alpha, sine, cosine, twist, angle, trace;

    (void)unused;
    arb_init(alpha);
    arb_init(sine);
    arb_init(cosine);
    arb_init(twist);
    arb_init(angle);
    arb_init(trace);
    for (unsigned tenths = 3; tenths < 30; tenths += 5) {
        arb_set_ui(alpha, tenths);
        arb_div_ui(alpha, alpha, 10, BITS);
        arb_sin_cos(sine, cosine, alpha, BITS);
        arb_mul_2exp_si(trace, cosine, 1);
        arb_mul_2exp_si(angle, alpha, -1);
        arb_cot(twist, angle, BITS);
        arb_mul_ui(twist, twist, 3, BITS);
        arb_mul_ui(angle, angle, 3, BITS);
        arb_cot(angle, angle, BITS);
        arb_add(twist, twist, angle, BITS);
        arb_div_si(twist, twist, -16, BITS);
        _arb_vec_zero(map, 2 * TERMS); /* x cos - (y - x^2) sin, x sin + (y - x^2) cos */
        arb_set(map + 1, cosine);
        arb_neg(map + 2, sine);
        arb_set(map + 3, sine);
        arb_set(map + TERMS + 1, sine);
        arb_set(map + TERMS + 2, cosine);
        arb_neg(map + TERMS + 3, cosine);
        expect(map, trace, twist);
        _arb_vec_zero(there, 2 * TERMS);
        arb_one(there + 1);
        arb_set_ui(there + 2, 2);
        arb_one(there + 3);
        arb_set_si(there + 4, -1);
        arb_set_ui(there + TERMS + 2, 3);
        _arb_vec_zero(back, 2 * TERMS);
        arb_one(back + TERMS + 2);
        arb_div_ui(back + TERMS + 2, back + TERMS + 2, 3, BITS);
        arb_one(back + 1);
        arb_mul_si(back + 2, back + TERMS + 2, -2, BITS);
        for (unsigned degree = 2; degree <= DEGREE; degree++) { /* x = (p - 2 y) - (x^2 - x y) */
            _arb_vec_zero(part, TERMS);
            arb_set_si(part + 3, -1);
            arb_one(part + 4);
            compose(other, part, back);
            _arb_vec_zero(back, TERMS);
            arb_one(back + 1);
            arb_mul_si(back + 2, back + TERMS + 2, -2, BITS);
            _arb_vec_add(back, back, other, TERMS, BITS);
        }
        compose_maps(part, map, back);
        compose_maps(other, there, part);
        arb_div_ui(twist, twist, 5, BITS);
        expect(other, trace, twist);
    }
    _arb_vec_clear(map, 2 * TERMS);
    _arb_vec_clear(there, 2 * TERMS);
    _arb_vec_clear(back, 2 * TERMS);
    _arb_vec_clear(part, 2 * TERMS);
    _arb_vec_clear(other, 2 * TERMS);
    arb_clear(alpha);
    arb_clear(sine);
    arb_clear(cosine);
    arb_clear(twist);
    arb_clear(angle);
    arb_clear(trace);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(series_of_polynomials_obey_the_flow_law),
        cmocka_unit_test(henon_map_twists_as_its_closed_form_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
