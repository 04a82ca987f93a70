#include "ext/surd.h"

#include <flint/fmpq_vec.h>

#include <stdlib.h>

enum { FEW = sizeof(((jlt_surd *)0)->few) / sizeof(fmpq) };

static size_t size_of(unsigned level)
{
    return (size_t)1 << level;
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

static void init_at(jlt_surd *a, unsigned level)
{
    a->level = level;
    for (size_t i = 0; i < FEW; i++) fmpq_init(a->few + i);
    a->coordinates = size_of(level) <= FEW ? a->few : _fmpq_vec_init((slong)size_of(level));
}

void jlt_surd_init(jlt_surd *a)
{
    init_at(a, 0);
}

void jlt_surd_clear(jlt_surd *a)
{
    for (size_t i = 0; i < FEW; i++) fmpq_clear(a->few + i);
    if (a->coordinates != a->few) _fmpq_vec_clear(a->coordinates, (slong)size_of(a->level));
}

void jlt_surd_swap(jlt_surd *a, jlt_surd *b)
{
    const jlt_surd held = *a;

    *a = *b;
    *b = held;
    if (a->coordinates == b->few) a->coordinates = a->few;
    if (b->coordinates == a->few) b->coordinates = b->few;
}

/* Move `a` into out at its least level; `a` is cleared. */
static void give(jlt_surd *out, jlt_surd *a)
{
    unsigned level = a->level;
    jlt_surd least;

    while (level > 0 && all_zero(a->coordinates + size_of(level - 1), size_of(level - 1))) level--;
    if (level < a->level) {
        init_at(&least, level);
        for (size_t i = 0; i < size_of(level); i++) fmpq_swap(least.coordinates + i, a->coordinates + i);
        jlt_surd_swap(a, &least);
        jlt_surd_clear(&least);
    }
    jlt_surd_swap(out, a);
    jlt_surd_clear(a);
}

/* Initialize out to a, at a level not below that of a. */
static void raise_to(jlt_surd *out, const jlt_surd *a, unsigned level)
{
    init_at(out, level);
    copy(out->coordinates, a->coordinates, size_of(a->level));
}

void jlt_surd_set(jlt_surd *out, const jlt_surd *a)
{
    jlt_surd same;

    if (out == a) return;
    if (out->level + a->level == 0) {
        fmpq_set(out->coordinates, a->coordinates);
        return;
    }
    raise_to(&same, a, a->level);
    give(out, &same);
}

void jlt_surd_set_rational(jlt_surd *out, const fmpq_t value)
{
    if (out->level > 0) {
        jlt_surd_clear(out);
        jlt_surd_init(out);
    }
    fmpq_set(out->coordinates, value);
}

bool jlt_surd_is_zero(const jlt_surd *a)
{
    return all_zero(a->coordinates, size_of(a->level));
}

static void combine(jlt_surd *out, const jlt_surd *a, const jlt_surd *b, bool minus)
{
    jlt_surd sum;

    if (out->level + a->level + b->level == 0) {
        (minus ? fmpq_sub : fmpq_add)(out->coordinates, a->coordinates, b->coordinates);
        return;
    }
    raise_to(&sum, a, a->level > b->level ? a->level : b->level);
    for (size_t i = 0; i < size_of(b->level); i++)
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

static void add_multiple(fmpq *out, const fmpq *a, unsigned level, const jlt_surd *b, const jlt_surd_field *field);

/* Add a b to out, all at one level: (p + q t)(u + v t) = p u + q v t^2 + (p v + q u) t. */
static void add_product(fmpq *out, const fmpq *a, const fmpq *b, unsigned level, const jlt_surd_field *field)
{
    if (level == 0) {
        if (fmpq_is_zero(out)) fmpq_mul(out, a, b);
        else fmpq_addmul(out, a, b);
        return;
    }
    const size_t half = size_of(level - 1);
    const bool low[] = { !all_zero(a, half), !all_zero(b, half) };
    const bool high[] = { !all_zero(a + half, half), !all_zero(b + half, half) };
    if (low[0] && low[1]) add_product(out, a, b, level - 1, field);
    if (low[0] && high[1]) add_product(out + half, a, b + half, level - 1, field);
    if (high[0] && low[1]) add_product(out + half, a + half, b, level - 1, field);
    if (high[0] && high[1]) {
        jlt_surd product;
        init_at(&product, level - 1);
        add_product(product.coordinates, a + half, b + half, level - 1, field);
        add_multiple(out, product.coordinates, level - 1, &field->radicands[level - 1], field);
        jlt_surd_clear(&product);
    }
}

/* Add a b to out, which has the level of `a`; that of b is not above it. */
static void add_multiple(fmpq *out, const fmpq *a, unsigned level, const jlt_surd *b, const jlt_surd_field *field)
{
    for (size_t i = 0; i < size_of(level); i += size_of(b->level))
        add_product(out + i, a + i, b->coordinates, b->level, field);
}

void jlt_surd_multiply(jlt_surd *out, const jlt_surd *a, const jlt_surd *b, const jlt_surd_field *field)
{
    const jlt_surd *const low = a->level < b->level ? a : b, *const high = low == a ? b : a;
    jlt_surd product;

    if (low->level == 0 && fmpq_is_one(low->coordinates)) {
        jlt_surd_set(out, high);
        return;
    }
    if (out->level + high->level == 0) {
        fmpq_mul(out->coordinates, a->coordinates, b->coordinates);
        return;
    }
    init_at(&product, high->level);
    add_multiple(product.coordinates, high->coordinates, high->level, low, field);
    give(out, &product);
}

/* a = low + high t, where t is the last root in a. */
static void split(jlt_surd *low, jlt_surd *high, const jlt_surd *a)
{
    const size_t half = size_of(a->level - 1);
    jlt_surd part;

    for (int k = 0; k < 2; k++) {
        init_at(&part, a->level - 1);
        copy(part.coordinates, a->coordinates + (k == 0 ? 0 : half), half);
        give(k == 0 ? low : high, &part);
    }
}

/* low + high t, where t is root number `root`. */
static void join(jlt_surd *out, const jlt_surd *low, const jlt_surd *high, unsigned root)
{
    jlt_surd whole;

    raise_to(&whole, low, root + 1);
    copy(whole.coordinates + size_of(root), high->coordinates, size_of(high->level));
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
    const unsigned root = a->level - 1;

    if (jlt_surd_is_zero(a)) return false;
    if (a->level == 0) {
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

    if (a->level == 0) {
        arb_set_fmpq(out, a->coordinates, precision);
        return;
    }
    JLT_SCOPED(jlt_surd, low, high);
    JLT_SCOPED(arb, root, rest);
    split(low, high, a);
    jlt_surd_enclose(root, &field->radicands[a->level - 1], field, precision);
    arb_sqrt(root, root, precision);
    jlt_surd_enclose(rest, low, field, precision);
    jlt_surd_enclose(out, high, field, precision);
    arb_mul(out, out, root, precision);
    arb_add(out, out, rest, precision);
}

slong jlt_surd_height(const jlt_surd *a)
{
    slong most = 0;

    for (size_t i = 0; i < size_of(a->level); i++) {
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

static bool find_root(jlt_surd *out, const jlt_surd *a, unsigned level, const jlt_surd_field *field);

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

/* A square root of a, of either sign, in the field of the first `level` roots. Returns false if there is none. */
static bool find_root(jlt_surd *out, const jlt_surd *a, unsigned level, const jlt_surd_field *field)
{

    if (jlt_surd_is_zero(a)) {
        jlt_surd_set(out, a);
        return true;
    }
    if (level == 0) return rational_root(out, a->coordinates);
    if (a->level < level) return find_plain(out, a, level - 1, field);
    JLT_SCOPED(jlt_surd, low, high);
    split(low, high, a);
    return find_mixed(out, low, high, level - 1, field);
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
