/* Validated integration against references that share nothing with it: quadruple-precision returns of the map of (5.1), a published
 * period, differences of solutions, closed forms. A start is a ball that holds the reference's rounding. */
#include "unit/check.h"

#include "kernel/descriptor.h"
#include "validated/symmetry.h"

#include <stdio.h>

enum { BITS = 256 };

/* A decimal that is right to half a unit of its place 10^-places. */
static void read_decimal(arb_t out, const char *text, int places)
{
    arb_t half;

    arb_init(half);
    assert_int_equal(arb_set_str(out, text, BITS), 0);
    arb_set_ui(half, 10);
    arb_pow_ui(half, half, (ulong)places, BITS);
    arb_inv(half, half, BITS);
    arb_add_error(out, half);
    arb_clear(half);
}

typedef struct {
    arb_struct t, gamma3, v_nu, v_tau;
} row;

/* v_tau = (a3 + gamma3) omega_n + s omega3, with R = 1 */
static void read_row(row *out, char *line)
{
    char *field[8], *save = NULL;
    arb_t s, product, a3;

    for (unsigned i = 0; i < 8; i++) assert_non_null(field[i] = strtok_r(i == 0 ? line : NULL, ",\n", &save));
    arb_init(&out->t);
    arb_init(&out->gamma3);
    arb_init(&out->v_nu);
    arb_init(&out->v_tau);
    arb_init(s);
    arb_init(product);
    arb_init(a3);
    read_decimal(&out->gamma3, field[3], 28);
    read_decimal(&out->t, field[4], 27);
    read_decimal(&out->v_nu, field[5], 28);
    arb_set_str(a3, "0.51", BITS);
    arb_add(&out->v_tau, &out->gamma3, a3, BITS);
    read_decimal(product, field[6], 27);
    arb_mul(&out->v_tau, &out->v_tau, product, BITS);
    arb_mul(s, &out->gamma3, &out->gamma3, BITS);
    arb_sub_ui(s, s, 1, BITS);
    arb_neg(s, s);
    arb_sqrt(s, s, BITS);
    read_decimal(product, field[7], 27);
    arb_addmul(&out->v_tau, s, product, BITS);
    arb_clear(s);
    arb_clear(product);
    arb_clear(a3);
}

static void clear_row(row *self)
{
    arb_clear(&self->t);
    arb_clear(&self->gamma3);
    arb_clear(&self->v_nu);
    arb_clear(&self->v_tau);
}

/* Parameters as exact fractions, by the table's order. */
static arb_ptr parameters(const jlt_descriptor *d, const char *const *names, const long (*values)[2], unsigned count)
{
    arb_ptr out = _arb_vec_init(d->param_count);

    for (unsigned i = 0; i < count; i++) {
        size_t k;
        assert_true(jlt_descriptor_param(d, names[i], &k));
        arb_set_si(out + k, values[i][0]);
        arb_div_si(out + k, out + k, values[i][1], BITS);
    }
    return out;
}

/* The first return, and the tenth, which the set reaches without being put in a box on the way. Errors grow by the condition of ten
 * returns, some 3e2, times the axes' own; remainders of 12 digits are below 2^-50. */
static void ten_returns_contain_the_quadruple_reference_and_stay_thin(void **unused)
{
    static const char *const names[] = { "m", "R", "g", "I1", "I3", "a3", "G" };
    static const long values[][2] = { { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 3 }, { 1, 3 }, { 51, 100 }, { -56, 100 } };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top_level", NULL, NULL, NULL);
    FILE *file = fopen(JLT_SOURCE_DIR "/tests/reference/data/returns_51.csv", "r");
    arb_ptr params = parameters(d, names, values, 7), x = _arb_vec_init(4);
    jlt_formulas *formulas;
    jlt_step *step;
    jlt_arrival arrival;
    arb_t level;
    arf_t instant;
    char line[512];
    unsigned returns = 0;

    (void)unused;
    assert_non_null(file);
    assert_int_equal(jlt_formulas_create(&formulas, d, NULL, 0, NULL, 0), JLT_OK);
    assert_int_equal(jlt_step_create(&step, formulas, params, jlt_step_accuracy_for(12), NULL), JLT_OK);
    jlt_arrival_init(&arrival, 4);
    arb_init(level);
    arf_init(instant);
    while (fgets(line, sizeof line, file) != NULL) {
        row r;
        if (line[0] != '1' || line[1] != ',') continue;
        read_row(&r, line);
        if (returns == 0) {
            arb_set(x, &r.gamma3);
            arb_set(x + 1, &r.v_nu);
            arb_set(x + 3, &r.v_tau);
        } else if (returns == 1 || returns == 10) {
            arf_set_round(instant, arb_midref(&r.t), 100, ARF_RND_DOWN);
            assert_int_equal(jlt_arrival_compute(&arrival, step, x, 2, level, instant, 1), JLT_OK);
            assert_true(arb_contains(arrival.x, &r.gamma3));
            assert_true(arb_contains(arrival.x + 1, &r.v_nu));
            assert_true(arb_contains(arrival.x + 3, &r.v_tau));
            assert_true(arb_contains(arrival.time, &r.t));
        }
        returns++;
        clear_row(&r);
    }
    assert_int_equal(returns, 11);
    for (unsigned i = 0; i < 4; i++) assert_true(mag_cmp_2exp_si(arb_radref(arrival.x + i), -34) < 0);
    fclose(file);
    jlt_arrival_clear(&arrival);
    jlt_step_destroy(step);
    jlt_formulas_destroy(formulas);
    arb_clear(level);
    arf_clear(instant);
    _arb_vec_clear(params, d->param_count);
    _arb_vec_clear(x, 4);
}

typedef struct {
    const jlt_descriptor *d;
    arb_ptr params;
    arb_t section;
    jlt_cycle_question question;
} lorenz;

static void open_lorenz(lorenz *self, unsigned digits)
{
    static const char *const names[] = { "sigma", "rho", "beta" };
    static const long values[][2] = { { 10, 1 }, { 28, 1 }, { 8, 3 } };

    self->d = jlt_descriptor_find("lorenz", NULL, NULL, NULL);
    self->params = parameters(self->d, names, values, 3);
    arb_init(self->section);
    arb_set_ui(self->section, 27);
    self->question = (jlt_cycle_question){ .descriptor = self->d, .params = self->params, .column = 2, .section = self->section,
                                           .direction = 1, .digits = digits };
}

static void close_lorenz(lorenz *self)
{
    _arb_vec_clear(self->params, self->d->param_count);
    arb_clear(self->section);
}

/* Oracle: the period of Lorenz's orbit AB, D. Viswanath, Physica D 190 (2004) 115-128; and det = e^(div f T), div f = -(sigma + 1 +
 * beta). */
static void orbit_ab_has_its_published_period(void **unused)
{
    const unsigned kept[] = { 0, 1 };
    jlt_cycle_result result;
    arb_ptr box = _arb_vec_init(2);
    jlt_cycle *cycle;
    arb_t instant;
    lorenz l;
    arb_t published, closed;

    (void)unused;
    open_lorenz(&l, 20);
    arb_init(instant);
    arb_init(published);
    arb_init(closed);
    arb_set_d(box, -13.763610682134205);
    arb_set_d(box + 1, -19.57875194245181);
    arb_set_d(instant, 1.558652210716174);
    assert_int_equal(jlt_cycle_create(&cycle, &l.question), JLT_OK);
    assert_int_equal(jlt_cycle_refine(cycle, box, instant, 1, kept), JLT_OK);
    for (unsigned i = 0; i < 2; i++) mag_set_d(arb_radref(box + i), 1e-10);
    jlt_cycle_result_init(&result, cycle, 1);
    assert_int_equal(jlt_cycle_prove(cycle, &result, box, instant, kept), JLT_OK);
    assert_int_equal(result.verdict, JLT_CYCLE_PROVED);
    assert_false(result.sink);
    assert_int_equal(arb_set_str(published, "1.5586522107161747275678702092126960705284805489972", BITS), 0);
    assert_true(arb_contains(result.period, published));
    assert_true(mag_cmp_2exp_si(arb_radref(result.period), -56) < 0);
    arb_set_si(closed, -41);
    arb_div_ui(closed, closed, 3, BITS);
    arb_mul(closed, closed, result.period, BITS);
    arb_exp(closed, closed, BITS);
    assert_true(arb_overlaps(closed, result.determinant));
    assert_true(arb_overlaps(closed, result.matrix_determinant));
    /* a box beside the orbit holds none */
    arb_add_error_2exp_si(box, -60);
    arb_set_d(published, 1e-9);
    arb_add(box, box, published, BITS);
    assert_int_equal(jlt_cycle_prove(cycle, &result, box, instant, kept), JLT_OK);
    assert_int_equal(result.verdict, JLT_CYCLE_UNSHOWN);
    jlt_cycle_result_clear(&result);
    jlt_cycle_destroy(cycle);
    close_lorenz(&l);
    arb_clear(instant);
    arb_clear(published);
    arb_clear(closed);
    _arb_vec_clear(box, 2);
}

/* Mean value: the difference of two arrivals from a box is in its derivative times the difference of the starts. The starts are
 * corners, each followed alone. Parameters that are intervals are columns as well. */
static void derivative_encloses_differences(void **unused)
{
    const double middle[] = { -13.763, -19.578 }, side = 0x1p-30;
    const unsigned free_params[] = { 1 };
    arb_ptr x = _arb_vec_init(4);
    jlt_arrival corners[2], box;
    jlt_formulas *formulas;
    jlt_step *step;
    arf_t instant;
    arb_t difference, predicted, level;
    lorenz l;

    (void)unused;
    open_lorenz(&l, 15);
    arf_init(instant);
    arf_set_d(instant, 1.5586);
    arb_init(difference);
    arb_init(predicted);
    arb_init(level);
    assert_int_equal(jlt_formulas_create(&formulas, l.d, free_params, 1, NULL, 0), JLT_OK);
    assert_int_equal(jlt_step_create(&step, formulas, l.params, jlt_step_accuracy_for(15), NULL), JLT_OK);
    jlt_arrival_init(&box, 4);
    for (unsigned which = 0; which < 3; which++) {
        jlt_arrival *out = which < 2 ? &corners[which] : &box;
        const double sign = which == 0 ? -1 : which == 1 ? 1 : 0;
        for (unsigned i = 0; i < 2; i++) arb_set_d(x + i, middle[i] + sign * side);
        arb_set_ui(x + 2, 27);
        arb_set_d(x + 3, 28 + sign * side);
        for (unsigned i = 0; which == 2 && i < 4; i++)
            if (i != 2) mag_set_d(arb_radref(x + i), side);
        if (which < 2) jlt_arrival_init(out, 4);
        arb_set(level, l.section);
        for (unsigned time = 0; time < 3; time++) { /* the better the instant, the thinner what arrives */
            assert_int_equal(jlt_arrival_compute(out, step, x, 2, level, instant, 1), JLT_OK);
            arf_set_round(instant, arb_midref(out->time), 64, ARF_RND_DOWN);
        }
    }
    for (unsigned i = 0; i < 2; i++) {
        arb_sub(difference, corners[1].x + i, corners[0].x + i, BITS);
        arb_zero(predicted);
        for (unsigned k = 0; k < 4; k++)
            if (k != 2) arb_add(predicted, predicted, arb_mat_entry(box.slope, i, k), BITS);
        arb_mul_2exp_si(predicted, predicted, -29);
        assert_true(arb_contains(predicted, difference));
        assert_true(arb_contains(box.x + i, corners[0].x + i) && arb_contains(box.x + i, corners[1].x + i));
        assert_true(arb_rel_accuracy_bits(predicted) > 4);
    }
    for (unsigned which = 0; which < 2; which++) jlt_arrival_clear(&corners[which]);
    jlt_arrival_clear(&box);
    jlt_step_destroy(step);
    jlt_formulas_destroy(formulas);
    close_lorenz(&l);
    arf_clear(instant);
    arb_clear(difference);
    arb_clear(predicted);
    arb_clear(level);
    _arb_vec_clear(x, 4);
}

/* G = I1 R s omega_n - I3 b omega3 is odd where omega_n and omega3 are flipped, neither where omega_n alone is; E, a sum of squares
 * and of m g a3 gamma3, is even but where gamma3 is flipped. The reversor of the table keeps both. */
static void signs_keep_levels_of_even_integrals_and_zeros_of_odd_ones(void **unused)
{
    static const char *const names[] = { "m", "R", "g", "I1", "I3", "a3" }, *const levels[] = { "E", "G" };
    static const long values[][2] = { { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 3 }, { 1, 3 }, { 51, 100 } };
    static const struct {
        signed char signs[5]; /* gamma3, v_nu, omega_tau, omega_n, omega3 */
        int G, section;
        bool keeps;
    } cases[] = {
        { { 1, -1, -1, 1, 1 }, 1, 0, true },    { { 1, -1, -1, 1, 1 }, 1, 1, false },  { { 1, -1, 1, 1, 1 }, 1, 0, false },
        { { 1, 1, -1, -1, -1 }, 0, 0, true },   { { 1, 1, -1, -1, -1 }, 1, 0, false }, { { 1, 1, -1, -1, 1 }, 0, 0, false },
        { { -1, -1, -1, 1, 1 }, 1, 0, false },
    };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    arb_ptr params = parameters(d, names, values, 6), level_values = _arb_vec_init(2);
    arb_t section;

    (void)unused;
    arb_init(section);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const jlt_cycle_question question = { .descriptor = d, .params = params, .column = 2, .section = section, .direction = 1,
                                              .level_count = 2, .levels = levels, .level_values = level_values, .digits = 10 };
        jlt_cycle *cycle;
        arb_set_si(section, cases[i].section);
        arb_set_si(level_values, 2);
        arb_set_si(level_values + 1, cases[i].G);
        assert_int_equal(jlt_cycle_create(&cycle, &question), JLT_OK);
        assert_int_equal(jlt_symmetry_keeps(cycle, cases[i].signs), cases[i].keeps);
        jlt_cycle_destroy(cycle);
    }
    _arb_vec_clear(params, d->param_count);
    _arb_vec_clear(level_values, 2);
    arb_clear(section);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ten_returns_contain_the_quadruple_reference_and_stay_thin),
        cmocka_unit_test(orbit_ab_has_its_published_period),
        cmocka_unit_test(derivative_encloses_differences),
        cmocka_unit_test(signs_keep_levels_of_even_integrals_and_zeros_of_odd_ones),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
