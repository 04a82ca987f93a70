/* Encloses the eigenvalues other than zero in balls: as roots of the characteristic polynomial, or as clusters of eigenvalues. */
#include "ext/ball_problem.h"

enum { ITERATIONS = 256 };

/* An exponent k such that 2^k is close to the modulus of the largest root, from M. Fujiwara's bound. */
static slong size_of(const arb_poly_t poly)
{
    const slong degree = arb_poly_degree(poly), lead = arf_abs_bound_lt_2exp_si(arb_midref(arb_poly_get_coeff_ptr(poly, degree)));
    slong most = 0;
    bool any = false;

    for (slong i = 1; i <= degree; i++) {
        arb_srcptr coefficient = arb_poly_get_coeff_ptr(poly, degree - i);
        if (arf_is_zero(arb_midref(coefficient))) continue;
        const slong size = (arf_abs_bound_lt_2exp_si(arb_midref(coefficient)) - lead) / i;
        most = any && most > size ? most : size;
        any = true;
    }
    return most;
}

/* Both roots of a real polynomial of degree 2, which must be simple and known to be real or not. */
static bool solve_quadratic(acb_ptr roots, const arb_poly_t poly, slong precision)
{
    arb_srcptr a = arb_poly_get_coeff_ptr(poly, 2), b = arb_poly_get_coeff_ptr(poly, 1), c = arb_poly_get_coeff_ptr(poly, 0);
    JLT_SCOPED(arb, product, discriminant, twice);

    arb_mul(product, a, c, precision);
    arb_mul_2exp_si(product, product, 2);
    arb_mul(discriminant, b, b, precision);
    arb_sub(discriminant, discriminant, product, precision);
    if (!arb_is_nonzero(discriminant)) return false;
    _acb_vec_zero(roots, 2);
    arb_mul_2exp_si(twice, a, 1);
    if (arb_is_negative(discriminant)) {
        arb_neg(discriminant, discriminant);
        arb_sqrt(discriminant, discriminant, precision);
        arb_div(acb_imagref(roots), discriminant, twice, precision);
        arb_div(acb_realref(roots), b, twice, precision);
        arb_neg(acb_realref(roots), acb_realref(roots));
        acb_conj(roots + 1, roots);
        return true;
    }
    arb_sqrt(discriminant, discriminant, precision);
    if (arf_sgn(arb_midref(b)) < 0) arb_neg(discriminant, discriminant);
    arb_add(product, b, discriminant, precision); /* without cancellation */
    arb_neg(product, product);
    arb_div(acb_realref(roots), product, twice, precision);
    arb_mul_2exp_si(discriminant, c, 1);
    arb_div(acb_realref(roots + 1), discriminant, product, precision);
    return true;
}

/* All roots of a real polynomial without the root 0; the imaginary parts of real roots are exactly zero. The roots are scaled by a
 * power of two to the order of 1, where the iterations begin. Returns false if the precision does not isolate them. */
static bool separate(acb_ptr roots, const arb_poly_t poly, slong precision)
{
    const slong degree = arb_poly_degree(poly), size = size_of(poly);
    bool good;
    JLT_SCOPED(acb_poly, scaled);

    if (degree == 2) return solve_quadratic(roots, poly, precision) && !acb_contains_zero(roots) && !acb_contains_zero(roots + 1);
    acb_poly_set_arb_poly(scaled, poly);
    for (slong k = 0; k < degree; k++)
        acb_mul_2exp_si(acb_poly_get_coeff_ptr(scaled, k), acb_poly_get_coeff_ptr(scaled, k), size * (k - degree));
    good = acb_poly_find_roots(roots, scaled, NULL, ITERATIONS, precision) == degree &&
           acb_poly_validate_real_roots(roots, scaled, precision);
    for (slong i = 0; good && i < degree; i++) {
        if (arb_contains_zero(acb_imagref(roots + i))) arb_zero(acb_imagref(roots + i));
        good = !acb_contains_zero(roots + i);
        acb_mul_2exp_si(roots + i, roots + i, size);
    }
    return good;
}

/* Both roots z of z^2 = square, where square is not zero, and has a known sign if it is real. */
static void set_pair(acb_ptr roots, const acb_t square, slong precision)
{
    if (acb_is_real(square) && arb_is_negative(acb_realref(square))) {
        acb_neg(roots, square);
        arb_sqrt(acb_imagref(roots), acb_realref(roots), precision);
        arb_zero(acb_realref(roots));
    } else {
        acb_sqrt(roots, square, precision);
    }
    acb_neg(roots + 1, roots);
}

static bool is_even(const arb_poly_t poly)
{
    for (slong k = 1; k <= arb_poly_degree(poly); k += 2)
        if (!arb_is_zero(arb_poly_get_coeff_ptr(poly, k))) return false;
    return arb_poly_degree(poly) % 2 == 0;
}

/* The roots of one factor; an even polynomial is solved for the squares of its roots. */
static bool find(acb_ptr roots, const arb_poly_t poly, slong precision)
{
    const slong half = arb_poly_degree(poly) / 2;
    bool good;

    if (!is_even(poly)) return separate(roots, poly, precision);
    JLT_SCOPED_VECTOR(acb, found, half);
    JLT_SCOPED(arb_poly, squares);
    for (slong k = half; k >= 0; k--) arb_poly_set_coeff_arb(squares, k, arb_poly_get_coeff_ptr(poly, 2 * k));
    good = separate(found, squares, precision);
    for (slong i = 0; good && i < half; i++) set_pair(roots + 2 * i, found + i, precision);
    return good;
}

/* Append the roots of a factor to p, each repeated by its multiplicity, and update the flags that depend on real parts. */
static void take(jlt_ball_spectrum *s, jlt_ball_problem *p, acb_srcptr roots, slong degree, jlt_ball_root kind)
{
    for (slong i = 0; i < degree; i++) {
        arb_srcptr re = acb_realref(roots + i);
        const bool on_axis = arb_is_zero(re);
        if (arb_is_positive(re)) s->expelling = 1;
        if (arb_is_positive(re) || (on_axis && !kind.semisimple)) s->growing = 1;
        if (!arb_is_negative(re)) s->decaying = 0;
        p->settled = p->settled && (on_axis || !arb_contains_zero(re));
        for (size_t k = 0; k < kind.multiplicity && p->count < p->n; k++) {
            p->kinds[p->count] = kind;
            acb_set(p->roots + p->count++, roots + i);
        }
    }
}

static bool follows(const acb_t a, const acb_t b)
{
    const double left = arf_get_d(arb_midref(acb_realref(a)), ARF_RND_NEAR);
    const double right = arf_get_d(arb_midref(acb_realref(b)), ARF_RND_NEAR);

    return left > right || (!(left < right) && arf_cmp(arb_midref(acb_imagref(a)), arb_midref(acb_imagref(b))) > 0);
}

static void sort(jlt_ball_problem *p)
{
    for (slong i = 1; i < p->count; i++)
        for (slong at = i; at > 0 && follows(p->roots + at - 1, p->roots + at); at--) {
            const jlt_ball_root held = p->kinds[at];
            acb_swap(p->roots + at - 1, p->roots + at);
            p->kinds[at] = p->kinds[at - 1];
            p->kinds[at - 1] = held;
        }
}

static bool overlaps_another(acb_srcptr values, slong count, slong which)
{
    for (slong i = 0; i < count; i++)
        if (i != which && acb_overlaps(values + i, values + which)) return true;
    return false;
}

static void widen(acb_t value, const mag_t error, ulong times)
{
    JLT_SCOPED(mag, more);

    mag_mul_ui(more, error, times);
    arb_add_error_mag(acb_realref(value), more);
    arb_add_error_mag(acb_imagref(value), more);
}

/* Disks of one radius about n approximate eigenvalues contain all eigenvalues, and every connected component of their union
 * contains as many eigenvalues as disks. A disk widened by 2 n radii, and some more, contains the whole component of its centre.
 * So a widened disk that overlaps no other contains exactly one eigenvalue, which is simple, and is real if its centre is within
 * two radii of the real axis, since its conjugate would lie in the same disk. Of eigenvalues in overlapping disks it is not known
 * whether they are simple or real. Returns false if the number of disks that contain zero is not s->zeros. */
static bool find_clusters(jlt_ball_spectrum *s, jlt_ball_problem *p)
{
    JLT_SCOPED_VECTOR(acb, values, p->n);
    JLT_SCOPED_VECTOR(acb, narrow, p->n);
    size_t zeros = 0;
    bool good;
    JLT_SCOPED_MATRIX(acb, p->n, p->n, a, vectors);
    JLT_SCOPED(mag, radius);

    acb_mat_set_arb_mat(a, p->a);
    acb_mat_approx_eig_qr(values, NULL, vectors, a, NULL, 0, p->precision);
    acb_mat_eig_global_enclosure(radius, a, values, vectors, p->precision);
    good = !mag_is_inf(radius);
    for (slong i = 0; good && i < p->n; i++) {
        acb_get_mid(values + i, values + i);
        acb_set(narrow + i, values + i);
        widen(narrow + i, radius, 2);
        widen(values + i, radius, 2 * (ulong)p->n + 8);
    }
    p->count = 0;
    p->settled = true;
    for (slong i = 0; good && i < p->n; i++) {
        const bool shared = overlaps_another(values, p->n, i);
        if (acb_contains_zero(values + i)) {
            zeros++;
            continue;
        }
        if (!shared && arb_contains_zero(acb_imagref(narrow + i))) arb_zero(acb_imagref(values + i));
        take(s, p, values + i, 1, (jlt_ball_root){ 1, true });
        p->kinds[p->count - 1].multiplicity += shared;
    }
    return good && zeros == s->zeros;
}

bool jlt_ball_problem_roots(jlt_ball_spectrum *s, jlt_ball_problem *p)
{
    jlt_exact_matrix *exact = p->question->exact;
    const size_t factors = exact == NULL ? p->n > (slong)s->zeros : exact->factor_count;
    JLT_SCOPED_VECTOR(acb, roots, p->n);
    bool good = s->counted; /* dropping low coefficients that may differ from zero would change the roots */

    s->decaying = p->n > (slong)s->zeros;
    s->expelling = s->growing = 0;
    p->count = 0;
    p->settled = true;
    JLT_SCOPED(arb_poly, poly);
    for (size_t i = 0; good && i < factors; i++) {
        jlt_ball_root kind = { 1, true };
        arb_poly_set(poly, p->rest);
        if (exact != NULL) {
            jlt_exact_poly_enclose(poly, &exact->factors[i].poly, exact->field, p->precision);
            kind = (jlt_ball_root){ exact->factors[i].multiplicity, exact->factors[i].semisimple };
        }
        good = find(roots, poly, p->precision);
        if (good) take(s, p, roots, arb_poly_degree(poly), kind);
    }
    if (!good && p->late && exact == NULL) good = p->clustered = find_clusters(s, p);
    sort(p);
    return good;
}
