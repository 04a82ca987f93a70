#include "ext/exact_matrix.h"

#include <stdlib.h>

/* An array of zeros. FLINT ends the program if memory is out. */
static jlt_surd *create_numbers(size_t count)
{
    jlt_surd *numbers = flint_malloc((count + 1) * sizeof *numbers);

    for (size_t i = 0; i < count; i++) jlt_surd_init(&numbers[i]);
    return numbers;
}

static void destroy_numbers(jlt_surd *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) jlt_surd_clear(&numbers[i]);
    flint_free(numbers);
}

jlt_exact_matrix *jlt_exact_matrix_create(size_t n)
{
    jlt_exact_matrix *m = calloc(1, sizeof *m);

    if (m == NULL) return NULL;
    m->n = n;
    m->field = jlt_surd_field_create();
    if (m->field == NULL) {
        free(m);
        return NULL;
    }
    m->point = create_numbers(n);
    m->entries = create_numbers(n * n);
    jlt_exact_poly_init(&m->charpoly);
    return m;
}

static void drop_factors(jlt_exact_matrix *m)
{
    for (size_t i = 0; i < m->factor_count; i++) jlt_exact_poly_clear(&m->factors[i].poly);
    m->factor_count = 0;
}

void jlt_exact_matrix_destroy(jlt_exact_matrix *m)
{
    if (m == NULL) return;
    drop_factors(m);
    jlt_exact_poly_clear(&m->charpoly);
    destroy_numbers(m->entries, m->n * m->n);
    destroy_numbers(m->point, m->n);
    jlt_surd_field_destroy(m->field);
    free(m);
}

/* out -= a b */
static void take(jlt_surd *out, const jlt_surd *a, const jlt_surd *b, const jlt_surd_field *field)
{

    if (jlt_surd_is_zero(a) || jlt_surd_is_zero(b)) return;
    JLT_SCOPED(jlt_surd, product);
    jlt_surd_multiply(product, a, b, field);
    jlt_surd_subtract(out, out, product);
}

/* Replace h by a similar upper Hessenberg matrix. */
static void reduce(jlt_surd *h, size_t n, const jlt_surd_field *field)
{
    JLT_SCOPED(jlt_surd, factor, minus, zero);

    for (size_t m = 1; m + 1 < n; m++) {
        size_t pivot = m;
        while (pivot < n && jlt_surd_is_zero(&h[pivot * n + m - 1])) pivot++;
        if (pivot == n) continue;
        for (size_t j = 0; pivot != m && j < n; j++) jlt_surd_swap(&h[pivot * n + j], &h[m * n + j]);
        for (size_t j = 0; pivot != m && j < n; j++) jlt_surd_swap(&h[j * n + pivot], &h[j * n + m]);
        for (size_t i = m + 1; i < n; i++) {
            if (jlt_surd_is_zero(&h[i * n + m - 1])) continue;
            (void)jlt_surd_invert(factor, &h[m * n + m - 1], field);
            jlt_surd_multiply(factor, factor, &h[i * n + m - 1], field);
            for (size_t j = m - 1; j < n; j++) take(&h[i * n + j], factor, &h[m * n + j], field);
            jlt_surd_subtract(minus, zero, factor);
            for (size_t j = 0; j < n; j++) take(&h[j * n + m], minus, &h[j * n + i], field);
        }
    }
}

/* Characteristic polynomial of a Hessenberg matrix: p_m = (x - h_mm) p_(m-1) - sum over i < m of h_(m-i,m) times the product of
 * the i subdiagonal entries between, times p_(m-i-1). */
static void expand(jlt_surd *coefficients, const jlt_surd *h, size_t n, const jlt_surd_field *field)
{
    jlt_surd *p = create_numbers((n + 1) * (n + 1)); /* row m: the characteristic polynomial of the leading m x m block */

    JLT_SCOPED(jlt_surd, factor);
    fmpq_one(p[0].coordinates);
    for (size_t m = 1; m <= n; m++) {
        const jlt_surd *const before = p + (m - 1) * (n + 1);
        jlt_surd *const row = p + m * (n + 1);
        for (size_t k = 0; k < m; k++) jlt_surd_set(&row[k + 1], &before[k]);
        for (size_t k = 0; k < m; k++) take(&row[k], &h[(m - 1) * n + m - 1], &before[k], field);
        JLT_SCOPED(jlt_surd, between);
        fmpq_one(between->coordinates);
        for (size_t i = 1; i < m; i++) {
            jlt_surd_multiply(between, between, &h[(m - i) * n + m - i - 1], field);
            jlt_surd_multiply(factor, between, &h[(m - i - 1) * n + m - 1], field);
            for (size_t k = 0; k + i < m; k++) take(&row[k], factor, &p[(m - i - 1) * (n + 1) + k], field);
        }
    }
    for (size_t k = 0; k <= n; k++) jlt_surd_set(&coefficients[k], &p[n * (n + 1) + k]);
    destroy_numbers(p, (n + 1) * (n + 1));
}

/* The rank, by elimination in place, which destroys the matrix. */
static size_t rank_of(jlt_surd *a, size_t n, const jlt_surd_field *field)
{
    size_t rank = 0;
    JLT_SCOPED(jlt_surd, factor);

    for (size_t column = 0; column < n; column++) {
        size_t pivot = rank;
        while (pivot < n && jlt_surd_is_zero(&a[pivot * n + column])) pivot++;
        if (pivot == n) continue;
        for (size_t j = 0; pivot != rank && j < n; j++) jlt_surd_swap(&a[pivot * n + j], &a[rank * n + j]);
        for (size_t i = rank + 1; i < n; i++) {
            if (jlt_surd_is_zero(&a[i * n + column])) continue;
            (void)jlt_surd_invert(factor, &a[rank * n + column], field);
            jlt_surd_multiply(factor, factor, &a[i * n + column], field);
            for (size_t j = column; j < n; j++) take(&a[i * n + j], factor, &a[rank * n + j], field);
        }
        rank++;
    }
    return rank;
}

/* Whether the roots of `poly`, eigenvalues of this multiplicity, are semisimple: the null space of poly(A) has full dimension. */
static bool is_semisimple(const jlt_exact_matrix *m, const jlt_exact_poly *poly, size_t multiplicity)
{
    const size_t n = m->n;
    jlt_surd *value, *next;
    bool whole;

    if (multiplicity == 1) return true;
    value = create_numbers(n * n);
    next = create_numbers(n * n);
    JLT_SCOPED(jlt_surd, product);
    for (size_t k = poly->length; k-- > 0;) { /* Horner's scheme */
        for (size_t i = 0; i < n * n; i++) {
            jlt_surd_subtract(&next[i], &next[i], &next[i]);
            for (size_t j = 0; j < n; j++) {
                if (jlt_surd_is_zero(&value[i / n * n + j]) || jlt_surd_is_zero(&m->entries[j * n + i % n])) continue;
                jlt_surd_multiply(product, &value[i / n * n + j], &m->entries[j * n + i % n], m->field);
                jlt_surd_add(&next[i], &next[i], product);
            }
        }
        for (size_t i = 0; i < n * n; i++) jlt_surd_swap(&value[i], &next[i]);
        for (size_t i = 0; i < n; i++) jlt_surd_add(&value[i * n + i], &value[i * n + i], &poly->coefficients[k]);
    }
    whole = n - rank_of(value, n, m->field) == (poly->length - 1) * multiplicity;
    destroy_numbers(next, n * n);
    destroy_numbers(value, n * n);
    return whole;
}

/* Append the factor `poly`, unless it is constant. */
static void add_factor(jlt_exact_matrix *m, jlt_exact_poly *poly, size_t multiplicity)
{
    jlt_exact_factor *factor = &m->factors[m->factor_count];

    if (poly->length < 2 || m->factor_count == JLT_EXACT_FACTORS_MAX) return;
    jlt_exact_poly_init(&factor->poly);
    jlt_exact_poly_set(&factor->poly, poly->coefficients, poly->length);
    factor->multiplicity = multiplicity;
    factor->even = jlt_exact_poly_is_even(poly);
    factor->semisimple = is_semisimple(m, poly, multiplicity);
    m->factor_count++;
}

void jlt_exact_matrix_analyse(jlt_exact_matrix *m)
{
    const size_t n = m->n;
    jlt_surd *h = create_numbers(n * n), *coefficients = create_numbers(n + 1);

    for (size_t i = 0; i < n * n; i++) jlt_surd_set(&h[i], &m->entries[i]);
    reduce(h, n, m->field);
    expand(coefficients, h, n, m->field);
    jlt_exact_poly_set(&m->charpoly, coefficients, n + 1);
    for (m->zeros = 0; jlt_surd_is_zero(&coefficients[m->zeros]); m->zeros++) continue;
    for (size_t i = 0; i < n * n; i++) jlt_surd_set(&h[i], &m->entries[i]);
    m->zero_semisimple = n - rank_of(h, n, m->field) == m->zeros;
    JLT_SCOPED(jlt_exact_poly, rest);
    jlt_exact_poly_shift(rest, &m->charpoly, m->zeros);
    add_factor(m, rest, 1);
    destroy_numbers(coefficients, n + 1);
    destroy_numbers(h, n * n);
}

/* Split a polynomial without multiple roots into its roots z for which -z is a root too, and the others; append both factors. */
static void add_parts(jlt_exact_matrix *m, const jlt_exact_poly *poly, size_t multiplicity)
{
    JLT_SCOPED(jlt_exact_poly, even, other);

    jlt_exact_poly_reflect(other, poly);
    jlt_exact_poly_gcd(even, poly, other, m->field);
    jlt_exact_poly_divide(other, NULL, poly, even, m->field);
    add_factor(m, even, multiplicity);
    add_factor(m, other, multiplicity);
}

void jlt_exact_matrix_split(jlt_exact_matrix *m)
{
    if (m->split) return;
    JLT_SCOPED(jlt_exact_poly, whole, slope, common, b, c, d);
    jlt_exact_poly_shift(whole, &m->charpoly, m->zeros);
    drop_factors(m);
    jlt_exact_poly_derive(slope, whole);
    jlt_exact_poly_gcd(common, whole, slope, m->field);
    jlt_exact_poly_divide(b, NULL, whole, common, m->field);
    jlt_exact_poly_divide(c, NULL, slope, common, m->field);
    for (size_t multiplicity = 1; b->length > 1; multiplicity++) {
        jlt_exact_poly_derive(d, b);
        jlt_exact_poly_subtract(d, c, d);
        jlt_exact_poly_gcd(common, b, d, m->field); /* its roots are those of this multiplicity */
        add_parts(m, common, multiplicity);
        jlt_exact_poly_divide(b, NULL, b, common, m->field);
        jlt_exact_poly_divide(c, NULL, d, common, m->field);
    }
    m->split = true;
}
