/* What Ulam's operator cannot be made of, and spectra that are not found. */
#include "transfer_line.h"

static double next_box(double x) { return x + 0.005 - floor(x + 0.005); }

static double stay(double x) { return x; }

/* A cycle of 200 boxes: its eigenvalues are all 200th roots of 1, of which a Krylov space of few vectors has none. */
static void eigenvalues_that_do_not_converge_are_no_answer(void **unused)
{
    const line l = { .image = next_box };
    jlt_transfer *t = make(&l, 200, 2, 0);
    jlt_transfer_spectrum s;

    (void)unused;
    assert_int_equal(t->row[200], 200);
    assert_int_equal(jlt_transfer_spectrum_compute(&s, t, 4, 1e-12, NULL), JLT_ERR_NO_CONVERGENCE);
    assert_null(s.leading);
    jlt_transfer_destroy(t);
}

static double upwards(double x) { return x + 0.3; }

/* No box in the space, an interrupt, a map that empties the boxes, a matrix too small: each is named, and nothing is
 * left behind. */
static void what_cannot_be_done_is_refused(void **unused)
{
    static const volatile sig_atomic_t raised = 1;
    const line l = { .image = stay, .only_below = -1, .and_near = -1 }, whole = { .image = stay };
    const jlt_boxes boxes = { .dim = 1, .low = { 0 }, .high = { 1 }, .count = { 8 } };
    jlt_boxes square = { .dim = 2, .high = { 1, 1 }, .count = { 2, 2 } };
    jlt_transfer_map map = { .context = (void *)&l, .losses = 2, .holds = line_holds, .images = line_images };
    jlt_transfer_options how = { .strata = 2, .noise = none, .noise_count = 1 };
    jlt_transfer *out;
    jlt_transfer_spectrum s;
    size_t points;

    (void)unused;
    assert_int_equal(jlt_transfer_build(&out, &points, &boxes, &map, &how), JLT_ERR_EMPTY);
    assert_null(out);
    map.context = (void *)&whole;
    map.interrupt = &raised;
    assert_int_equal(jlt_transfer_build(&out, &points, &boxes, &map, &how), JLT_ERR_NO_CONVERGENCE);
    assert_null(out);
    how.strata = 0;
    assert_int_equal(jlt_transfer_build(&out, &points, &boxes, &map, &how), JLT_ERR_ARG);
    how.strata = SIZE_MAX;
    assert_int_equal(jlt_transfer_build(&out, &points, &boxes, &map, &how), JLT_ERR_NOMEM);
    how.strata = (size_t)1 << 32; /* squared, it is 0 modulo 2^64 */
    assert_int_equal(jlt_transfer_build(&out, &points, &square, &map, &how), JLT_ERR_NOMEM);
    how.strata = 2;
    how.block = SIZE_MAX;
    assert_int_equal(jlt_transfer_build(&out, &points, &boxes, &map, &how), JLT_ERR_NOMEM);
    for (size_t k = 0; k < 2; k++) {
        square.period[1] = k == 0 ? NAN : INFINITY;
        assert_int_equal(jlt_boxes_count(&points, &square), JLT_ERR_ARG);
    }
    out = make(&whole, 2, 2, 0);
    assert_int_equal(jlt_transfer_spectrum_compute(&s, out, 1, 1e-12, NULL), JLT_ERR_ARG);
    jlt_transfer_destroy(out);
    out = make(&whole, 8, 2, 0);
    assert_int_equal(jlt_transfer_spectrum_compute(&s, out, 1, 1e-12, &raised), JLT_ERR_NO_CONVERGENCE);
    jlt_transfer_destroy(out);
    out = make(&(line){ .image = upwards }, 8, 2, 0);
    assert_int_equal(jlt_transfer_spectrum_compute(&s, out, 1, 1e-12, NULL), JLT_ERR_EMPTY);
    jlt_transfer_destroy(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eigenvalues_that_do_not_converge_are_no_answer),
        cmocka_unit_test(what_cannot_be_done_is_refused),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
