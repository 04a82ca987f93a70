#include "ext/ball_texts.h"

#include "ext/ball_problem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The decimal exponent of |x|, possibly off by one. */
static slong exponent_of(const arb_t x)
{
    JLT_SCOPED(arf, mantissa);
    JLT_SCOPED(fmpz, power);

    arf_frexp(mantissa, power, arb_midref(x));
    return (slong)floor(fmpz_get_d(power) * log10(2.0) + log10(fabs(arf_get_d(mantissa, ARF_RND_NEAR))));
}

/* |x| 10^(digits - 1 - exponent), rounded to the nearest integer. Returns false if numbers in the ball round differently. */
static bool scale(fmpz_t out, const arb_t x, slong digits, slong exponent)
{
    const slong shift = digits - 1 - exponent, precision = arb_bits(x) + 4 * digits + 64;
    bool sure;
    JLT_SCOPED(arb, value, power);

    arb_set_ui(power, 10);
    arb_pow_ui(power, power, (ulong)labs(shift), precision);
    arb_abs(value, x);
    if (shift >= 0) arb_mul(value, value, power, precision);
    else arb_div(value, value, power, precision);
    arb_set_d(power, 0.5);
    arb_add(value, value, power, precision);
    arb_floor(power, value, precision);
    sure = arb_get_unique_fmpz(out, power);
    if (!sure) arf_get_fmpz(out, arb_midref(value), ARF_RND_FLOOR);
    return sure;
}

static char *append(char *at, const char *digits, slong count)
{
    for (slong i = 0; i < count; i++) *at++ = *digits == '\0' ? '0' : *digits++;
    return at;
}

/* Lay out digits as [-]D.DDD or [-]0.000DDD, or with an exponent if it is below -5 or at least `most`. */
static char *lay_out(const char *digits, bool negative, slong exponent, slong most)
{
    const slong count = (slong)strlen(digits);
    char *text = malloc((size_t)(count + most) + 64), *at = text;

    if (text == NULL) return NULL;
    if (negative) *at++ = '-';
    if (exponent < -5 || exponent >= most) {
        at = append(at, digits, 1);
        if (count > 1) *at++ = '.';
        at = append(at, digits + 1, count - 1);
        snprintf(at, 32, "e%+03ld", (long)exponent);
        return text;
    }
    at = append(at, exponent < 0 ? "0" : digits, exponent < 0 ? 1 : exponent + 1);
    if (exponent < 0 || count > exponent + 1) *at++ = '.';
    if (exponent < 0) at = append(at, "", -exponent - 1);
    if (exponent < 0) at = append(at, digits, count);
    else if (count > exponent + 1) at = append(at, digits + exponent + 1, count - exponent - 1);
    *at = '\0';
    return text;
}

/* |x| as an integer of `digits` digits, and the decimal exponent of its first digit. Returns false as scale does. */
static bool nearest(fmpz_t value, slong *exponent, const arb_t x, slong digits)
{
    bool sure;
    JLT_SCOPED(fmpz, limit);

    fmpz_ui_pow_ui(limit, 10, (ulong)digits);
    *exponent = exponent_of(x) - 2;
    do sure = scale(value, x, digits, ++*exponent);
    while (fmpz_cmpabs(value, limit) >= 0);
    return sure;
}

/* The nearest decimal, without trailing zeros. If the ball contains numbers that round differently, *sure becomes false, and the
 * text is that of the midpoint, with no more digits than the ball determines. Returns NULL if memory is out. */
static char *decimal(bool *sure, const arb_t ball, slong digits)
{
    slong exponent;
    char *all, *text;

    if (arb_contains_zero(ball)) {
        *sure = *sure && arb_is_zero(ball);
        return strdup("0");
    }
    JLT_SCOPED(fmpz, value);
    if (!nearest(value, &exponent, ball, digits)) {
        const slong known = (slong)floor((double)arb_rel_accuracy_bits(ball) * log10(2.0));
        *sure = false;
        (void)nearest(value, &exponent, ball, known < 1 ? 1 : known < digits ? known : digits);
    }
    all = fmpz_get_str(NULL, 10, value);
    for (size_t end = strlen(all); end > 1 && all[end - 1] == '0'; end--) all[end - 1] = '\0';
    text = lay_out(all, arb_is_negative(ball), exponent, digits);
    flint_free(all);
    return text;
}

static char **list(bool *good, size_t count)
{
    char **texts = calloc(count + 1, sizeof *texts);

    *good = *good && texts != NULL;
    return texts;
}

static void add(char **text, bool *sure, bool *good, const arb_t ball, slong digits)
{
    if (!*good) return;
    *text = decimal(sure, ball, digits);
    *good = *text != NULL;
}

jlt_ball_texts *jlt_ball_texts_create(bool *sure, const jlt_ball_problem *p)
{
    const slong digits = p->question->digits, zeros = p->n - p->count;
    jlt_ball_texts *t = calloc(1, sizeof *t);
    bool good = t != NULL;

    if (!good) return NULL;
    JLT_SCOPED(arb, other);
    t->digits = digits;
    t->params = p->table->param_count;
    t->n = (size_t)p->n;
    t->param = list(&good, t->params);
    t->state = list(&good, t->n);
    t->jacobian = list(&good, t->n * t->n);
    t->charpoly = list(&good, t->n + 1);
    t->re = list(&good, t->n);
    t->im = list(&good, t->n);
    for (size_t i = 0; good && i < t->params; i++) add(&t->param[i], sure, &good, p->params + i, digits);
    for (slong i = 0; good && i < p->n; i++) add(&t->state[i], sure, &good, p->x + i, digits);
    for (slong i = 0; good && i < p->n * p->n; i++)
        add(&t->jacobian[i], sure, &good, arb_mat_entry(p->a, i / p->n, i % p->n), digits);
    for (slong k = 0; good && k <= p->n; k++)
        add(&t->charpoly[k], sure, &good, arb_poly_get_coeff_ptr(p->charpoly, p->n - k), digits);
    arb_neg(other, arb_poly_get_coeff_ptr(p->charpoly, p->n - 1));
    add(&t->trace, sure, &good, other, digits);
    arb_zero(other);
    for (slong i = 0; good && i < p->n; i++) {
        add(&t->re[i], sure, &good, i < zeros ? other : acb_realref(p->roots + i - zeros), digits);
        add(&t->im[i], sure, &good, i < zeros ? other : acb_imagref(p->roots + i - zeros), digits);
    }
    if (good) return t;
    jlt_ball_texts_destroy(t);
    return NULL;
}

static void destroy_list(char **texts, size_t count)
{
    for (size_t i = 0; texts != NULL && i < count; i++) free(texts[i]);
    free(texts);
}

void jlt_ball_texts_destroy(jlt_ball_texts *t)
{
    if (t == NULL) return;
    destroy_list(t->param, t->params);
    destroy_list(t->state, t->n);
    destroy_list(t->jacobian, t->n * t->n);
    destroy_list(t->charpoly, t->n + 1);
    destroy_list(t->re, t->n);
    destroy_list(t->im, t->n);
    free(t->trace);
    free(t);
}
