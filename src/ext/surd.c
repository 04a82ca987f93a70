#include "ext/surd.h"

#include <flint/fmpq_vec.h>

#include <stdlib.h>

enum { FEW = sizeof(((jlt_surd *)0)->few) / sizeof(fmpq) };

static size_t size_of(unsigned roots)
{
    return (size_t)1 << roots;
}

static bool all_zero(const fmpq *a, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!fmpq_is_zero(a + i)) return false;
    return true;
}

static void copy(fmpq *out, const fmpq *a, size_t count)
{
    for (size_t i = 0; i < count; i++) fmpq_set(out + i, a + i);
}

jlt_surd_field *jlt_surd_field_create(void)
{
    return calloc(1, sizeof(jlt_surd_field));
}

void jlt_surd_field_destroy(jlt_surd_field *field)
{
    if (field == NULL) return;
    for (unsigned k = 0; k < field->count; k++) jlt_surd_clear(&field->radicands[k]);
    free(field);
}

static void init_at(jlt_surd *a, unsigned roots)
{
    a->roots = roots;
    for (size_t i = 0; i < FEW; i++) fmpq_init(a->few + i);
    a->coordinates = size_of(roots) <= FEW ? a->few : _fmpq_vec_init((slong)size_of(roots));
}

void jlt_surd_init(jlt_surd *a)
{
    init_at(a, 0);
}

void jlt_surd_clear(jlt_surd *a)
{
    for (size_t i = 0; i < FEW; i++) fmpq_clear(a->few + i);
    if (a->coordinates != a->few) _fmpq_vec_clear(a->coordinates, (slong)size_of(a->roots));
}

void jlt_surd_swap(jlt_surd *a, jlt_surd *b)
{
    const jlt_surd held = *a;

    *a = *b;
    *b = held;
    if (a->coordinates == b->few) a->coordinates = a->few;
    if (b->coordinates == a->few) b->coordinates = b->few;
}

/* Move `a` into out, with the fewest roots that it needs; `a` is cleared. */
static void give(jlt_surd *out, jlt_surd *a)
{
    unsigned roots = a->roots;
    jlt_surd least;

    while (roots > 0 && all_zero(a->coordinates + size_of(roots - 1), size_of(roots - 1))) roots--;
    if (roots < a->roots) {
        init_at(&least, roots);
        for (size_t i = 0; i < size_of(roots); i++) fmpq_swap(least.coordinates + i, a->coordinates + i);
        jlt_surd_swap(a, &least);
        jlt_surd_clear(&least);
    }
    jlt_surd_swap(out, a);
    jlt_surd_clear(a);
}

/* Initialize out to a, in the field of the first `roots` roots, which contains a. */
static void raise_to(jlt_surd *out, const jlt_surd *a, unsigned roots)
{
    init_at(out, roots);
    copy(out->coordinates, a->coordinates, size_of(a->roots));
}

void jlt_surd_set(jlt_surd *out, const jlt_surd *a)
{
    jlt_surd same;

    if (out == a) return;
    if (out->roots + a->roots == 0) {
        fmpq_set(out->coordinates, a->coordinates);
        return;
    }
    raise_to(&same, a, a->roots);
    give(out, &same);
}

void jlt_surd_set_rational(jlt_surd *out, const fmpq_t value)
{
    if (out->roots > 0) {
        jlt_surd_clear(out);
        jlt_surd_init(out);
    }
    fmpq_set(out->coordinates, value);
}

bool jlt_surd_is_zero(const jlt_surd *a)
{
    return all_zero(a->coordinates, size_of(a->roots));
}

static void combine(jlt_surd *out, const jlt_surd *a, const jlt_surd *b, bool minus)
{
    jlt_surd sum;

    if (out->roots + a->roots + b->roots == 0) {
        (minus ? fmpq_sub : fmpq_add)(out->coordinates, a->coordinates, b->coordinates);
        return;
    }
    raise_to(&sum, a, a->roots > b->roots ? a->roots : b->roots);
    for (size_t i = 0; i < size_of(b->roots); i++)
        (minus ? fmpq_sub : fmpq_add)(sum.coordinates + i, sum.coordinates + i, b->coordinates + i);
    give(out, &sum);
}

void jlt_surd_add(jlt_surd *out, const jlt_surd *a, const jlt_surd *b)
{
    combine(out, a, b, false);
}

void jlt_surd_subtract(jlt_surd *out, const jlt_surd *a, const jlt_surd *b)
{
    combine(out, a, b, true);
}

static void add_multiple(fmpq *out, const fmpq *a, unsigned roots, const jlt_surd *b, const jlt_surd_field *field);

/* Add a b to out, all with the same roots: (p + q t)(u + v t) = p u + q v t^2 + (p v + q u) t. */
static void add_product(fmpq *out, const fmpq *a, const fmpq *b, unsigned roots, const jlt_surd_field *field)
{
    if (roots == 0) {
        if (fmpq_is_zero(out)) fmpq_mul(out, a, b);
        else fmpq_addmul(out, a, b);
        return;
    }
    const size_t half = size_of(roots - 1);
    const bool low[] = { !all_zero(a, half), !all_zero(b, half) };
    const bool high[] = { !all_zero(a + half, half), !all_zero(b + half, half) };
    if (low[0] && low[1]) add_product(out, a, b, roots - 1, field);
    if (low[0] && high[1]) add_product(out + half, a, b + half, roots - 1, field);
    if (high[0] && low[1]) add_product(out + half, a + half, b, roots - 1, field);
    if (high[0] && high[1]) {
        jlt_surd product;
        init_at(&product, roots - 1);
        add_product(product.coordinates, a + half, b + half, roots - 1, field);
        add_multiple(out, product.coordinates, roots - 1, &field->radicands[roots - 1], field);
        jlt_surd_clear(&product);
    }
}

/* Add a b to out, which has as many roots as `a`; b has no more. */
static void add_multiple(fmpq *out, const fmpq *a, unsigned roots, const jlt_surd *b, const jlt_surd_field *field)
{
    for (size_t i = 0; i < size_of(roots); i += size_of(b->roots))
        add_product(out + i, a + i, b->coordinates, b->roots, field);
}

void jlt_surd_multiply(jlt_surd *out, const jlt_surd *a, const jlt_surd *b, const jlt_surd_field *field)
{
    const jlt_surd *const low = a->roots < b->roots ? a : b, *const high = low == a ? b : a;
    jlt_surd product;

    if (low->roots == 0 && fmpq_is_one(low->coordinates)) {
        jlt_surd_set(out, high);
        return;
    }
    if (out->roots + high->roots == 0) {
        fmpq_mul(out->coordinates, a->coordinates, b->coordinates);
        return;
    }
    init_at(&product, high->roots);
    add_multiple(product.coordinates, high->coordinates, high->roots, low, field);
    give(out, &product);
}

/* a = low + high t, where t is the last root in a. */
static void split(jlt_surd *low, jlt_surd *high, const jlt_surd *a)
{
    const size_t half = size_of(a->roots - 1);
    jlt_surd part;

    for (int k = 0; k < 2; k++) {
        init_at(&part, a->roots - 1);
        copy(part.coordinates, a->coordinates + (k == 0 ? 0 : half), half);
        give(k == 0 ? low : high, &part);
    }
}

/* low + high t, where t is root number `root`. */
static void join(jlt_surd *out, const jlt_surd *low, const jlt_surd *high, unsigned root)
{
    jlt_surd whole;

    raise_to(&whole, low, root + 1);
    copy(whole.coordinates + size_of(root), high->coordinates, size_of(high->roots));
    give(out, &whole);
}

/* low^2 - high^2 t^2 with t the root number `root`; it is zero only if low + high t is zero. */
static void norm(jlt_surd *out, const jlt_surd *low, const jlt_surd *high, unsigned root, const jlt_surd_field *field)
{
    JLT_SCOPED(jlt_surd, square);

    jlt_surd_multiply(square, high, high, field);
    jlt_surd_multiply(square, square, &field->radicands[root], field);
    jlt_surd_multiply(out, low, low, field);
    jlt_surd_subtract(out, out, square);
}

bool jlt_surd_invert(jlt_surd *out, const jlt_surd *a, const jlt_surd_field *field)
{
    const unsigned root = a->roots - 1;

    if (jlt_surd_is_zero(a)) return false;
    if (a->roots == 0) {
        jlt_surd_set(out, a);
        fmpq_inv(out->coordinates, out->coordinates);
        return true;
    }
    JLT_SCOPED(jlt_surd, low, high, scale, zero);
    split(low, high, a);
    norm(scale, low, high, root, field);
    (void)jlt_surd_invert(scale, scale, field);
    jlt_surd_subtract(high, zero, high);
    jlt_surd_multiply(low, low, scale, field);
    jlt_surd_multiply(high, high, scale, field);
    join(out, low, high, root);
    return true;
}

void jlt_surd_enclose(arb_t out, const jlt_surd *a, const jlt_surd_field *field, slong precision)
{

    if (a->roots == 0) {
        arb_set_fmpq(out, a->coordinates, precision);
        return;
    }
    JLT_SCOPED(jlt_surd, low, high);
    JLT_SCOPED(arb, root, rest);
    split(low, high, a);
    jlt_surd_enclose(root, &field->radicands[a->roots - 1], field, precision);
    arb_sqrt(root, root, precision);
    jlt_surd_enclose(rest, low, field, precision);
    jlt_surd_enclose(out, high, field, precision);
    arb_mul(out, out, root, precision);
    arb_add(out, out, rest, precision);
}

slong jlt_surd_height(const jlt_surd *a)
{
    slong most = 0;

    for (size_t i = 0; i < size_of(a->roots); i++) {
        const slong bits = (slong)fmpq_height_bits(a->coordinates + i);
        if (bits > most) most = bits;
    }
    return most;
}

/* The sign of a number that is not zero, from balls of increasing precision. */
static int sign_of(const jlt_surd *a, const jlt_surd_field *field)
{
    int sign = 0;
    JLT_SCOPED(arb, ball);

    for (slong precision = 64; sign == 0; precision *= 2) {
        jlt_surd_enclose(ball, a, field, precision);
        sign = arb_sgn_nonzero(ball);
    }
    return sign;
}

static bool rational_root(jlt_surd *out, const fmpq_t a)
{

    if (fmpq_sgn(a) < 0 || !fmpz_is_square(fmpq_numref(a)) || !fmpz_is_square(fmpq_denref(a))) return false;
    JLT_SCOPED(fmpq, root);
    fmpz_sqrt(fmpq_numref(root), fmpq_numref(a));
    fmpz_sqrt(fmpq_denref(root), fmpq_denref(a));
    jlt_surd_set_rational(out, root);
    return true;
}

static bool find_root(jlt_surd *out, const jlt_surd *a, unsigned roots, const jlt_surd_field *field);

/* A square root of a, which does not contain t, the root number `root`: either x without t, or y t with y^2 = a/t^2. */
static bool find_plain(jlt_surd *out, const jlt_surd *a, unsigned root, const jlt_surd_field *field)
{
    bool found = find_root(out, a, root, field);

    if (found) return true;
    JLT_SCOPED(jlt_surd, y, none);
    (void)jlt_surd_invert(y, &field->radicands[root], field);
    jlt_surd_multiply(y, y, a, field);
    found = find_root(y, y, root, field);
    if (found) join(out, none, y, root);
    return found;
}

/* A square root x + y t of low + high t: x^2 = (low +- n)/2, n^2 = low^2 - high^2 t^2, y = high/(2 x). */
static bool find_mixed(jlt_surd *out, const jlt_surd *low, const jlt_surd *high, unsigned root, const jlt_surd_field *field)
{
    bool found;
    JLT_SCOPED(jlt_surd, n, x, half);

    fmpq_set_si(half->coordinates, 1, 2);
    norm(n, low, high, root, field);
    found = find_root(n, n, root, field);
    if (found) {
        jlt_surd_add(x, low, n);
        jlt_surd_multiply(x, x, half, field);
        found = find_root(x, x, root, field);
        if (!found) {
            jlt_surd_subtract(x, low, n);
            jlt_surd_multiply(x, x, half, field);
            found = find_root(x, x, root, field);
        }
    }
    if (found) {
        (void)jlt_surd_invert(n, x, field);
        jlt_surd_multiply(n, n, half, field);
        jlt_surd_multiply(n, n, high, field);
        join(out, x, n, root);
    }
    return found;
}

/* A square root of a, of either sign, in the field of the first roots. Returns false if there is none. */
static bool find_root(jlt_surd *out, const jlt_surd *a, unsigned roots, const jlt_surd_field *field)
{

    if (jlt_surd_is_zero(a)) {
        jlt_surd_set(out, a);
        return true;
    }
    if (roots == 0) return rational_root(out, a->coordinates);
    if (a->roots < roots) return find_plain(out, a, roots - 1, field);
    JLT_SCOPED(jlt_surd, low, high);
    split(low, high, a);
    return find_mixed(out, low, high, roots - 1, field);
}

bool jlt_surd_root(jlt_surd *out, const jlt_surd *a, jlt_surd_field *field)
{
    bool found;

    if (jlt_surd_is_zero(a) || sign_of(a, field) < 0) return false;
    JLT_SCOPED(jlt_surd, root, none);
    found = find_root(root, a, field->count, field);
    if (found) {
        if (sign_of(root, field) < 0) jlt_surd_subtract(root, none, root);
    } else if (field->count < JLT_SURD_ROOTS_MAX) {
        jlt_surd_init(&field->radicands[field->count]);
        jlt_surd_set(&field->radicands[field->count], a);
        fmpq_one(root->coordinates);
        join(root, none, root, field->count++);
        found = true;
    }
    if (found) jlt_surd_swap(out, root);
    return found;
}
