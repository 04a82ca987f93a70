/* Ulam's operator on maps whose densities, eigenvalues and escape rates are known in closed form. */
#include "transfer_line.h"

#include <float.h>

/* The sum of a row and its losses is 1, whatever the map. */
static void check_rows(const jlt_transfer *t)
{
    for (size_t i = 0; i < t->count; i++) {
        double sum = 0;
        for (size_t e = t->row[i]; e < t->row[i + 1]; e++) {
            assert_true(t->weight[e] > 0 && t->to[e] < t->count && (e == t->row[i] || t->to[e] > t->to[e - 1]));
            sum += t->weight[e];
        }
        for (unsigned k = 0; k < t->losses; k++) sum += t->lost[i * t->losses + k];
        assert_near(sum, 1, 1e-12);
    }
}

/* The doubling map in another coordinate, x = 0.7 u + 0.3 u^2. */
static double bent(double x)
{
    double u = 2 * (sqrt(0.49 + 1.2 * x) - 0.7) / 0.6;

    u -= floor(u);
    return 0.7 * u + 0.3 * u * u;
}
static double bent_density(double x) { return 1 / sqrt(0.49 + 1.2 * x); }

/* Oracle: the doubling map leaves du unchanged. In total variation the error of Ulam's method is of order log(n)/n for expanding
 * maps (C. Bose, R. Murray, Discrete Contin. Dyn. Syst. 7, 2001): four times as many boxes make it 2.7 to 4 times smaller. Points
 * at random in strata add less than a tenth of it. */
static void density_converges_with_the_boxes(void **unused)
{
    const line l = { .image = bent, .density = bent_density };
    double before = 0;

    (void)unused;
    for (size_t count = 16; count <= 256; count *= 4) {
        jlt_transfer *t = make(&l, count, 8000, 0);
        jlt_transfer_spectrum s;
        check_rows(t);
        assert_ok(jlt_transfer_spectrum_compute(&s, t, 3, 1e-12, NULL));
        const double distance = jlt_transfer_distance(s.leading, t->known, t->count);
        assert_near(s.re[0], 1, 1e-12);
        assert_below(s.residual[0], 1e-11);
        assert_below(s.negative, 1e-12);
        if (before > 0) assert_below(distance, before / 2.5);
        before = distance;
        jlt_transfer_spectrum_clear(&s);
        jlt_transfer_destroy(t);
    }
    assert_below(before, 1 / 256.0);
}

static double gauss(double x) { return 1 / x - floor(1 / x); }
static double gauss_density(double x) { return 1 / (1 + x); }

/* Oracle: Gauss' density 1/((1 + x) ln 2), and Wirsing's constant, by which continued fractions forget how they began (E.
 * Wirsing, Acta Arith. 24, 1974). Both are off by less than a box's width. */
static void continued_fractions_forget_by_wirsings_constant(void **unused)
{
    const line l = { .image = gauss, .density = gauss_density };
    jlt_transfer *t = make(&l, 64, 4000, 0);
    jlt_transfer_spectrum s;

    (void)unused;
    assert_ok(jlt_transfer_spectrum_compute(&s, t, 2, 1e-12, NULL));
    assert_below(jlt_transfer_distance(s.leading, t->known, t->count), 1 / 64.0);
    assert_near(s.re[1], -0.3036630029, 1 / 64.0);
    assert_near(s.im[1], 0, 0);
    assert_null(s.second); /* a negative eigenvalue is no set that stays */
    jlt_transfer_spectrum_clear(&s);
    jlt_transfer_destroy(t);
}

static double doubling(double x) { return x < 0.25 ? NAN : 2 * x - floor(2 * x); }

/* Oracle: orbits that stay are the words of two letters without 00 (and those that begin with it are lost at once), whose number
 * grows by the golden ratio: the leading eigenvalue is half of it. Boxes are unions of the map's pieces, and strata of its
 * branches: no error. */
static void escape_through_a_hole_of_the_doubling_map_is_golden(void **unused)
{
    const line l = { .image = doubling };
    jlt_transfer *t = make(&l, 16, 4, 0), *coarse;
    jlt_transfer_spectrum s;
    double lost[2];

    (void)unused;
    check_rows(t);
    assert_ok(jlt_transfer_coarsen(&coarse, t, 2));
    check_rows(coarse);
    for (int k = 0; k < 2; k++) {
        const jlt_transfer *of = k == 0 ? t : coarse;
        assert_ok(jlt_transfer_spectrum_compute(&s, of, 2, 1e-12, NULL));
        assert_near(s.re[s.leading_index], (1 + sqrt(5)) / 4, 1e-12);
        assert_near(jlt_transfer_spectrum_losses(lost, of, s.leading), 1 - (1 + sqrt(5)) / 4, 1e-12);
        assert_near(lost[0], 0, 0);
        assert_near(jlt_transfer_spectrum_time(of, s.leading), 2, 1e-12);
        jlt_transfer_spectrum_clear(&s);
    }
    jlt_transfer_destroy(coarse);
    jlt_transfer_destroy(t);
}

static double whole_doubling(double x) { return 2 * x - floor(2 * x); }

/* Oracle: after six steps the doubling map has spread the mass of any of 64 boxes evenly, P^6 = J/64, so that all eigenvalues but 1
 * are
 * 0. Blocks of up to six make them as large as 1e-16^(1/6) = 2e-3, at residuals of rounding; none of that is told. */
static void eigenvalues_that_are_rounding_are_not_told(void **unused)
{
    const line l = { .image = whole_doubling };
    jlt_transfer *t = make(&l, 64, 8, 0);
    jlt_transfer_spectrum s;

    (void)unused;
    assert_ok(jlt_transfer_spectrum_compute(&s, t, 6, 1e-12, NULL));
    assert_near(s.re[0], 1, 1e-12);
    assert_below(s.spread[0], 1e-12);
    assert_int_equal(s.told, 1);
    assert_true(s.count > 1);
    assert_below(s.residual[1], 1e-9);
    assert_null(s.second);
    jlt_transfer_spectrum_clear(&s);
    jlt_transfer_destroy(t);
}

/* Each half of the line is mapped over itself 15 times, and over the other half once. */
static double two_halves(double x)
{
    const double half = x < 0.5 ? 0 : 0.5, y = 32 * (x - half), piece = floor(y);
    return (piece == 0 ? 0.5 - half : half) + (y - piece) / 2;
}

/* Oracle: the chain of two states that are left with probability 1/16: eigenvalues 1 and 7/8; all others are 0. */
static void two_sets_that_mix_slowly_are_told_by_signs(void **unused)
{
    const line l = { .image = two_halves };
    jlt_transfer *t = make(&l, 32, 16, 0);
    jlt_transfer_spectrum s;

    (void)unused;
    assert_ok(jlt_transfer_spectrum_compute(&s, t, 2, 1e-12, NULL));
    assert_near(s.re[0], 1, 1e-12);
    assert_near(s.re[1], 0.875, 1e-12);
    assert_int_equal(s.second_index, 1);
    assert_int_equal(jlt_transfer_spectrum_multiplicity(&s, 1e-8), 1);
    assert_int_equal(jlt_transfer_spectrum_multiplicity(&s, 0.13), 2);
    for (int sign = -1; sign <= 1; sign += 2) {
        double mass, kept;
        jlt_transfer_spectrum_set(&mass, &kept, t, s.leading, s.second, sign);
        assert_near(mass, 0.5, 1e-12);
        assert_near(kept, 0.9375, 1e-12);
    }
    for (size_t i = 0; i < 32; i++) assert_true((s.second[i] > 0) == (s.second[i < 16 ? 0 : 31] > 0));
    jlt_transfer_spectrum_clear(&s);
    jlt_transfer_destroy(t);
}

static double apart(double x) { return (floor(8 * x) + 32 * x - floor(32 * x)) / 8; }

/* Eight parts that nothing leads between: eigenvalue 1 is eightfold, and what is called the density that stays does, and is
 * positive. */
static void of_many_densities_one_is_shown(void **unused)
{
    const line l = { .image = apart };
    jlt_transfer *t = make(&l, 32, 4, 0);
    jlt_transfer_spectrum s;
    double image[32];

    (void)unused;
    assert_ok(jlt_transfer_spectrum_compute(&s, t, 8, 1e-12, NULL));
    assert_int_equal(jlt_transfer_spectrum_multiplicity(&s, 1e-8), 8);
    jlt_transfer_push(t, image, s.leading);
    assert_below(jlt_transfer_distance(image, s.leading, 32), 1e-9);
    for (size_t i = 0; i < 32; i++) assert_true(s.leading[i] > -1e-9);
    jlt_transfer_spectrum_clear(&s);
    jlt_transfer_destroy(t);
}

/* Boxes above their neighbours and the mean, the densest first, and no more than asked for. */
static void peaks_are_boxes_above_their_neighbours(void **unused)
{
    const line l = { .image = bent };
    const double mass[10] = { 3, 1, 1, 2, 5, 4, 6, 0, 0, 1 }; /* mean 2.3 */
    jlt_transfer *t = make(&l, 10, 4, 0);
    size_t places[4], count;

    (void)unused;
    assert_ok(jlt_transfer_finding_peaks(places, &count, 4, t, mass));
    assert_int_equal(count, 3);
    assert_int_equal(places[0], 6);
    assert_int_equal(places[1], 4);
    assert_int_equal(places[2], 0);
    assert_near(jlt_transfer_finding_density(t, mass, 6), 60, 1e-12);
    assert_ok(jlt_transfer_finding_peaks(places, &count, 2, t, mass));
    assert_int_equal(count, 2);
    assert_int_equal(places[0], 6);
    assert_int_equal(places[1], 4);
    jlt_transfer_destroy(t);
}

static double to_speck(double x) { return x < 0.5 ? 0.777 : x - 0.577; }

/* The speck is met by no stratified point, but by images: its box is kept all the same, and nothing is lost. */
static void boxes_that_only_images_meet_are_kept(void **unused)
{
    const line l = { .image = to_speck, .only_below = 0.5, .and_near = 0.777 };
    jlt_transfer *t = make(&l, 10, 4, 0);

    (void)unused;
    assert_int_equal(t->count, 6);
    assert_int_equal(t->box[5], 7);
    assert_near(t->share[5], 0.125, 0);
    check_rows(t);
    for (size_t i = 0; i < t->count; i++) {
        assert_near(t->lost[2 * i] + t->lost[2 * i + 1], 0, 0);
        assert_int_equal(t->row[i + 1] - t->row[i], 1);
        assert_int_equal(t->to[t->row[i]], i < 5 ? 5 : 2);
    }
    jlt_transfer_destroy(t);
}

static double stay(double x) { return x; }

/* Noise of a tenth moves mass by up to two boxes of a twentieth, and none of it out of the space. */
static void noise_moves_images_within_the_space(void **unused)
{
    const line l = { .image = stay, .only_below = 1 };
    jlt_transfer *t = make(&l, 20, 100, 0.1);
    size_t widest = 0;

    (void)unused;
    check_rows(t);
    for (size_t i = 0; i < t->count; i++) {
        for (size_t e = t->row[i]; e < t->row[i + 1]; e++) {
            const size_t off = t->to[e] > i ? t->to[e] - i : i - t->to[e];
            if (off > widest) widest = off;
        }
        if (i > 2) assert_near(t->lost[2 * i], 0, 0);
    }
    assert_true(t->lost[0] > 0); /* below 0 lies the space, which l.only_below does not end, but no box */
    assert_int_equal(widest, 2);
    jlt_transfer_destroy(t);
}

/* Wider boxes have the masses of their parts, after a step too: coarsening commutes with the step of even mass. */
static void coarsening_keeps_masses(void **unused)
{
    const line l = { .image = gauss, .density = gauss_density };
    jlt_transfer *t = make(&l, 96, 50, 0), *coarse;
    double v[96], pushed[96], wide[32] = { 0 }, out[32];

    (void)unused;
    assert_ok(jlt_transfer_coarsen(&coarse, t, 3));
    assert_int_equal(coarse->count, 32);
    for (size_t i = 0; i < 96; i++) v[i] = 1 / 96.0 * (double)(1 + i / 3); /* even in each wide box */
    for (size_t i = 0; i < 96; i++) wide[i / 3] += v[i];
    jlt_transfer_push(t, pushed, v);
    jlt_transfer_push(coarse, out, wide);
    for (size_t i = 0; i < 32; i++) {
        assert_near(out[i], pushed[3 * i] + pushed[3 * i + 1] + pushed[3 * i + 2], 1e-13);
        assert_near(coarse->known[i], t->known[3 * i] + t->known[3 * i + 1] + t->known[3 * i + 2], 1e-15);
        assert_near(coarse->share[i], 1, 0);
    }
    jlt_transfer *refused;
    assert_int_equal(jlt_transfer_coarsen(&refused, t, 7), JLT_ERR_ARG);
    assert_null(refused);
    jlt_transfer_destroy(coarse);
    jlt_transfer_destroy(t);
}

/* Of ten points in a box, 3 are lost and 7 have images outside. Each share is a quotient of counts, rounded once; boxes made
 * from three lose the same, but for three roundings. */
static double out_or_lost(double x) { return fmod(960 * x, 10) < 3 ? NAN : 5; }
static void shares_are_rounded_once(void **unused)
{
    const line l = { .image = out_or_lost };
    jlt_transfer *t = make(&l, 96, 10, 0), *coarse;

    (void)unused;
    assert_ok(jlt_transfer_coarsen(&coarse, t, 3));
    for (size_t i = 0; i < 96; i++) {
        assert_near(t->lost[2 * i], 0.7, 0);
        assert_near(t->lost[2 * i + 1], 0.3, 0);
    }
    for (size_t i = 0; i < 64; i++) assert_near(coarse->lost[i], i % 2 == 0 ? 0.7 : 0.3, DBL_EPSILON);
    jlt_transfer_destroy(coarse);
    jlt_transfer_destroy(t);
}

/* Points of a box are found in it, angles beyond their period too; neighbours of a box at the end of a whole angle lie at both. */
static void boxes_know_their_points_and_neighbours(void **unused)
{
    const double turn = 6.283185307179586;
    const jlt_boxes b = { .dim = 3, .low = { -turn / 2, 0, 1 }, .high = { turn / 2, 1, 2 }, .period = { turn, 0, turn },
                         .count = { 5, 4, 3 } };
    double q[3 * 8];
    size_t all, found, neighbours[27];

    (void)unused;
    assert_ok(jlt_boxes_count(&all, &b));
    assert_int_equal(all, 60);
    for (size_t box = 0; box < all; box++) {
        jlt_boxes_sample(&b, q, box, 2, 7);
        for (size_t i = 0; i < 8; i++) {
            assert_true(jlt_boxes_find(&b, &found, q + 3 * i));
            assert_int_equal(found, box);
            q[3 * i] += 2 * turn, q[3 * i + 2] -= turn;
            assert_true(jlt_boxes_find(&b, &found, q + 3 * i));
            assert_int_equal(found, box);
        }
    }
    assert_false(jlt_boxes_find(&b, &found, (double[]){ 0, 1.1, 1.5 }));
    assert_false(jlt_boxes_find(&b, &found, (double[]){ 0, 0.5, 2.5 }));
    assert_false(jlt_boxes_find(&b, &found, (double[]){ 0, NAN, 1.5 }));
    assert_int_equal(jlt_boxes_neighbours(&b, neighbours, 0), 3 * 2 * 2 - 1);
    assert_int_equal(jlt_boxes_neighbours(&b, neighbours, 0 + 5 * (1 + 4 * 1)), 26);
    jlt_boxes refused = b;
    refused.count[1] = 0;
    assert_int_equal(jlt_boxes_count(&all, &refused), JLT_ERR_ARG);
    refused = b, refused.high[0] = 4;
    assert_int_equal(jlt_boxes_count(&all, &refused), JLT_ERR_ARG);
    refused = b, refused.count[0] = refused.count[1] = refused.count[2] = 1 << 20;
    assert_int_equal(jlt_boxes_count(&all, &refused), JLT_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(density_converges_with_the_boxes),
        cmocka_unit_test(continued_fractions_forget_by_wirsings_constant),
        cmocka_unit_test(escape_through_a_hole_of_the_doubling_map_is_golden),
        cmocka_unit_test(eigenvalues_that_are_rounding_are_not_told),
        cmocka_unit_test(two_sets_that_mix_slowly_are_told_by_signs),
        cmocka_unit_test(of_many_densities_one_is_shown),
        cmocka_unit_test(peaks_are_boxes_above_their_neighbours),
        cmocka_unit_test(boxes_that_only_images_meet_are_kept),
        cmocka_unit_test(noise_moves_images_within_the_space),
        cmocka_unit_test(coarsening_keeps_masses),
        cmocka_unit_test(shares_are_rounded_once),
        cmocka_unit_test(boxes_know_their_points_and_neighbours),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
