/* Numbers with square roots, polynomials over them, and factors of characteristic polynomials, exactly. */
#include "unit/check.h"

#include "ext/exact_matrix.h"

static void set(jlt_surd *a, slong up, ulong down)
{
    fmpq_t value;

    fmpq_init(value);
    fmpq_set_si(value, up, down);
    jlt_surd_set_rational(a, value);
    fmpq_clear(value);
}

/* To as many digits as a double has, in a ball of 200 bits. */
static bool holds(const jlt_surd *a, const jlt_surd_field *field, double value)
{
    arb_t ball;
    bool near;

    arb_init(ball);
    jlt_surd_enclose(ball, a, field, 200);
    near = fabs(arf_get_d(arb_midref(ball), ARF_RND_NEAR) - value) < 1e-14 * fabs(value) && arb_rel_accuracy_bits(ball) > 150;
    arb_clear(ball);
    return near;
}

/* Oracle: identities among nested roots, by hand. Each root is one of the field already where it can be, so that the difference of
 * both sides is zero in all its coordinates. */
static void roots_that_are_there_already_are_not_adjoined(void **unused)
{
    jlt_surd_field *field = jlt_surd_field_create();
    jlt_surd a, b, two, three;

    (void)unused;
    assert_non_null(field);
    for (int k = 0; k < 4; k++) jlt_surd_init((jlt_surd *[]){ &a, &b, &two, &three }[k]);
    set(&two, 2, 1);
    set(&three, 3, 1);
    set(&a, 9, 16);
    assert_true(jlt_surd_root(&a, &a, field));
    set(&b, 3, 4);
    jlt_surd_subtract(&a, &a, &b);
    assert_true(jlt_surd_is_zero(&a) && field->count == 0);
    assert_true(jlt_surd_root(&a, &two, field));
    assert_true(jlt_surd_root(&b, &three, field));
    assert_int_equal(field->count, 2);
    /* sqrt(6) = sqrt(2) sqrt(3) */
    jlt_surd_multiply(&a, &a, &b, field);
    set(&b, 6, 1);
    assert_true(jlt_surd_root(&b, &b, field));
    jlt_surd_subtract(&a, &a, &b);
    assert_true(jlt_surd_is_zero(&a));
    /* sqrt(5 + 2 sqrt(6)) = sqrt(2) + sqrt(3) */
    jlt_surd_multiply(&b, &b, &two, field);
    set(&a, 5, 1);
    jlt_surd_add(&b, &b, &a);
    assert_true(jlt_surd_root(&a, &b, field));
    assert_int_equal(field->count, 2);
    assert_true(holds(&a, field, sqrt(2.0) + sqrt(3.0)));
    /* sqrt(3 - 2 sqrt(2)) = sqrt(2) - 1, the positive one */
    assert_true(jlt_surd_root(&b, &two, field));
    jlt_surd_multiply(&b, &b, &two, field);
    jlt_surd_subtract(&b, &three, &b);
    assert_true(jlt_surd_root(&b, &b, field));
    assert_int_equal(field->count, 2);
    assert_true(holds(&b, field, sqrt(2.0) - 1.0));
    /* sqrt(1 + sqrt(2)) is of a field of its own */
    assert_true(jlt_surd_root(&b, &two, field));
    set(&a, 1, 1);
    jlt_surd_add(&b, &b, &a);
    assert_true(jlt_surd_root(&b, &b, field));
    assert_int_equal(field->count, 3);
    assert_true(holds(&b, field, sqrt(1.0 + sqrt(2.0))));
    for (int k = 0; k < 4; k++) jlt_surd_clear((jlt_surd *[]){ &a, &b, &two, &three }[k]);
    jlt_surd_field_destroy(field);
}

static void quotients_are_exact_and_what_is_not_positive_has_no_root(void **unused)
{
    jlt_surd_field *field = jlt_surd_field_create();
    jlt_surd a, b, c;

    (void)unused;
    assert_non_null(field);
    jlt_surd_init(&a);
    jlt_surd_init(&b);
    jlt_surd_init(&c);
    assert_false(jlt_surd_invert(&b, &a, field));
    assert_false(jlt_surd_root(&b, &a, field));
    set(&c, -2, 1);
    assert_false(jlt_surd_root(&b, &c, field));
    for (slong k = 2; k <= 5; k += 1 + (k == 3)) { /* sqrt(2) + sqrt(3) + sqrt(5), and its inverse */
        set(&b, k, 1);
        assert_true(jlt_surd_root(&b, &b, field));
        jlt_surd_add(&a, &a, &b);
    }
    assert_true(jlt_surd_invert(&b, &a, field));
    assert_true(holds(&b, field, 1.0 / (sqrt(2.0) + sqrt(3.0) + sqrt(5.0))));
    jlt_surd_multiply(&b, &b, &a, field);
    set(&c, 1, 1);
    jlt_surd_subtract(&b, &b, &c);
    assert_true(jlt_surd_is_zero(&b));
    set(&c, 7, 1);
    assert_true(jlt_surd_root(&c, &c, field));
    set(&c, 11, 1);
    assert_false(jlt_surd_root(&c, &c, field)); /* one root too many */
    jlt_surd_clear(&c);
    jlt_surd_clear(&b);
    jlt_surd_clear(&a);
    jlt_surd_field_destroy(field);
}

/* Entries of n rows, as many as are not zero: row, column, value; the square root of 2 times that where `rooted`. */
typedef struct {
    int row, column, value;
    bool rooted;
} entry;

static jlt_exact_matrix *matrix_of(size_t n, const entry *entries, size_t count)
{
    jlt_exact_matrix *m = jlt_exact_matrix_create(n);
    jlt_surd two;

    assert_non_null(m);
    jlt_surd_init(&two);
    set(&two, 2, 1);
    assert_true(jlt_surd_root(&two, &two, m->field));
    for (size_t k = 0; k < count; k++) {
        jlt_surd *at = &m->entries[(size_t)entries[k].row * n + (size_t)entries[k].column];
        set(at, entries[k].value, 1);
        if (entries[k].rooted) jlt_surd_multiply(at, at, &two, m->field);
    }
    jlt_surd_clear(&two);
    jlt_exact_matrix_analyse(m);
    jlt_exact_matrix_split(m);
    return m;
}

static void has_factor(const jlt_exact_matrix *m, size_t which, size_t degree, size_t multiplicity, bool even, bool semisimple)
{
    assert_true(which < m->factor_count);
    const jlt_exact_factor *f = &m->factors[which];
    assert_int_equal(f->poly.length, degree + 1);
    assert_int_equal(f->multiplicity, multiplicity);
    assert_int_equal(f->even, even);
    assert_int_equal(f->semisimple, semisimple);
}

/* Oracle: matrices in blocks, by hand. lambda^2 = -sqrt(2), twice, without and with a coupling that makes a Jordan block of it. */
static void pairs_on_the_axis_are_even_factors_that_know_their_eigenvectors(void **unused)
{
    static const entry blocks[] = { { 0, 1, 1, false }, { 1, 0, -1, true }, { 2, 3, 1, false }, { 3, 2, -1, true },
                                    { 0, 2, 1, false } };

    (void)unused;
    for (size_t coupled = 0; coupled < 2; coupled++) {
        jlt_exact_matrix *m = matrix_of(4, blocks, 4 + coupled);
        assert_int_equal(m->zeros, 0);
        assert_int_equal(m->factor_count, 1);
        has_factor(m, 0, 2, 2, true, coupled == 0);
        jlt_exact_matrix_destroy(m);
    }
}

/* (lambda - 1)(lambda + 1) is even, with no root on the axis; lambda - 3, twice, with one eigenvector; lambda, twice, with two. */
static void factors_are_told_apart_by_sign_and_multiplicity(void **unused)
{
    static const entry entries[] = { { 0, 0, 1, false }, { 1, 1, -1, false }, { 0, 1, 5, true }, { 2, 2, 3, false },
                                     { 3, 3, 3, false }, { 2, 3, 7, false }, { 1, 3, 2, true } };
    jlt_exact_matrix *m = matrix_of(6, entries, sizeof entries / sizeof *entries);

    (void)unused;
    assert_int_equal(m->zeros, 2);
    assert_true(m->zero_semisimple);
    assert_int_equal(m->factor_count, 2);
    has_factor(m, 0, 2, 1, true, true);
    has_factor(m, 1, 1, 2, false, false);
    jlt_exact_matrix_destroy(m);
}

static void a_defective_zero_is_one(void **unused)
{
    static const entry entries[] = { { 0, 1, 1, true }, { 2, 2, -4, false } };
    jlt_exact_matrix *m = matrix_of(3, entries, 2);

    (void)unused;
    assert_int_equal(m->zeros, 2);
    assert_false(m->zero_semisimple);
    has_factor(m, 0, 1, 1, false, true);
    jlt_exact_matrix_destroy(m);
}

/* lambda^2 + 4 and lambda^2 - 9 beside lambda - 2: the roots that come in pairs of either sign are taken out of one factor. */
static void roots_in_pairs_are_parted_from_others(void **unused)
{
    static const entry entries[] = { { 0, 1, 4, false }, { 1, 0, -1, false }, { 2, 3, 9, false }, { 3, 2, 1, false },
                                     { 4, 4, 2, false }, { 1, 4, 6, true } };
    jlt_exact_matrix *m = matrix_of(5, entries, sizeof entries / sizeof *entries);

    (void)unused;
    assert_int_equal(m->factor_count, 2);
    has_factor(m, 0, 4, 1, true, true);
    has_factor(m, 1, 1, 1, false, true);
    jlt_exact_matrix_destroy(m);
}

/* Oracle: SymPy's polynomial of the matrix, lambda^4 - 13 lambda^3 + (24 - 54 r) lambda^2 + (80 r - 92) lambda + 960 - 504 r, where
 * r^2 = 2. */
static void a_full_matrix_has_the_polynomial_that_others_find(void **unused)
{
    static const int rows[4][4] = { { 1, 2, 3, 4 }, { 5, 6, 7, 8 }, { 2, 6, 4, 8 }, { 3, 1, 1, 2 } };
    static const int expected[5][2] = { { 960, -504 }, { -92, 80 }, { 24, -54 }, { -13, 0 }, { 1, 0 } };
    entry entries[16];
    jlt_exact_matrix *m;

    (void)unused;
    for (int k = 0; k < 16; k++) entries[k] = (entry){ k / 4, k % 4, rows[k / 4][k % 4], k == 3 || k == 9 };
    m = matrix_of(4, entries, 16);
    assert_int_equal(m->charpoly.length, 5);
    for (size_t k = 0; k < 5; k++) {
        const jlt_surd *c = &m->charpoly.coefficients[k];
        assert_int_equal(c->roots, expected[k][1] != 0);
        for (size_t i = 0; i <= c->roots; i++) assert_true(fmpq_cmp_si(c->coordinates + i, expected[k][i]) == 0);
    }
    jlt_exact_matrix_destroy(m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(roots_that_are_there_already_are_not_adjoined),
        cmocka_unit_test(quotients_are_exact_and_what_is_not_positive_has_no_root),
        cmocka_unit_test(pairs_on_the_axis_are_even_factors_that_know_their_eigenvectors),
        cmocka_unit_test(factors_are_told_apart_by_sign_and_multiplicity),
        cmocka_unit_test(a_defective_zero_is_one),
        cmocka_unit_test(roots_in_pairs_are_parted_from_others),
        cmocka_unit_test(a_full_matrix_has_the_polynomial_that_others_find),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
