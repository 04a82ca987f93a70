#include "ext/number.h"

#include "ext/scoped.h"

#include <flint/fmpq.h>

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Read one unsigned decimal at *at as digits * 10^exponent, and move *at past it. Returns false if there is none. */
static bool read_decimal(fmpz_t digits, long *exponent, const char **at, const char *end)
{
    char buffer[JLT_NUMBER_LENGTH_MAX + 1];
    size_t count = 0;
    long shift = 0, written = 0;
    bool negative = false;

    while (*at < end && is_digit(**at)) buffer[count++] = *(*at)++;
    if (*at < end && **at == '.') {
        ++*at;
        while (*at < end && is_digit(**at)) {
            buffer[count++] = *(*at)++;
            shift--;
        }
    }
    if (count == 0) return false;
    buffer[count] = '\0';
    if (fmpz_set_str(digits, buffer, 10) != 0) return false;
    if (*at < end && (**at == 'e' || **at == 'E')) {
        ++*at;
        if (*at < end && (**at == '+' || **at == '-')) negative = *(*at)++ == '-';
        if (*at == end || !is_digit(**at)) return false;
        while (*at < end && is_digit(**at)) {
            written = 10 * written + (*(*at)++ - '0');
            if (written > JLT_NUMBER_EXPONENT_MAX) return false;
        }
    }
    *exponent = shift + (negative ? -written : written);
    return true;
}

static bool read_plain(fmpq_t value, const char *text, size_t length)
{
    const char *at = text, *const end = text + length;
    long up = 0, down = 0;
    bool good = false, negative = false;

    if (length == 0 || length > JLT_NUMBER_LENGTH_MAX) return false;
    JLT_SCOPED(fmpz, denominator, power);
    fmpz_one(denominator);
    if (*at == '+' || *at == '-') negative = *at++ == '-';
    fmpz_set_ui(fmpq_denref(value), 1);
    good = read_decimal(fmpq_numref(value), &up, &at, end);
    if (good && at < end && *at == '/') {
        at++;
        good = read_decimal(denominator, &down, &at, end) && !fmpz_is_zero(denominator);
    }
    good = good && at == end;
    if (good) {
        const long exponent = up - down;
        fmpz_set_ui(power, 10);
        fmpz_pow_ui(power, power, (unsigned long)labs(exponent));
        fmpz_mul(exponent < 0 ? denominator : fmpq_numref(value), exponent < 0 ? denominator : fmpq_numref(value), power);
        if (negative) fmpz_neg(fmpq_numref(value), fmpq_numref(value));
        fmpz_set(fmpq_denref(value), denominator);
        fmpq_canonicalise(value);
    }
    return good;
}

static double nearest(const fmpz_t numerator, const fmpz_t denominator)
{
    JLT_SCOPED(arf, quotient);

    (void)arf_fmpz_div_fmpz(quotient, numerator, denominator, 53, ARF_RND_NEAR);
    return arf_get_d(quotient, ARF_RND_NEAR);
}

static jlt_status round_nearest(double *result, const fmpq_t value)
{
    const double rounded = nearest(fmpq_numref(value), fmpq_denref(value));

    if (!fmpq_is_zero(value) && !isnormal(rounded)) return JLT_ERR_NONFINITE;
    *result = rounded;
    return JLT_OK;
}

static void set_double(fmpq_t out, double value)
{
    JLT_SCOPED(arf, exact);

    arf_set_d(exact, value);
    arf_get_fmpq(out, exact);
}

/* Read pi, -pi, 2*pi, 2*pi/3, pi/2 and the like; out is the double that double arithmetic gives. */
static jlt_status read_multiple_of_pi(fmpq_t out, const char *text, size_t length)
{
    static const double pi = 3.14159265358979323846;
    const char *const end = text + length, *at = text;
    double factor = 1, divisor = 1;
    jlt_status st = JLT_OK, below = JLT_OK;
    bool good;

    while (end - at >= 2 && strncmp(at, "pi", 2) != 0) at++;
    if (end - at < 2) return JLT_ERR_ARG;
    const size_t before = (size_t)(at - text), after = (size_t)(end - at) - 2;
    if (before <= 1) {
        good = before == 0 || *text == '-' || *text == '+';
        if (before == 1 && *text == '-') factor = -1;
    } else {
        good = at[-1] == '*' && read_plain(out, text, before - 1);
        if (good) st = round_nearest(&factor, out);
    }
    if (good && after > 0) {
        good = after > 1 && at[2] == '/' && at[3] != '+' && at[3] != '-' && memchr(at + 3, '/', after - 1) == NULL
            && read_plain(out, at + 3, after - 1) && !fmpq_is_zero(out);
        if (good) below = round_nearest(&divisor, out);
    }
    if (!good) return JLT_ERR_ARG;
    const double value = factor * pi / divisor;
    if (st != JLT_OK || below != JLT_OK || (value != 0 && !isnormal(value))) return JLT_ERR_NONFINITE;
    set_double(out, value);
    return JLT_OK;
}

static jlt_status read_fraction(fmpq_t value, const char *text, size_t length)
{
    return read_plain(value, text, length) ? JLT_OK : read_multiple_of_pi(value, text, length);
}

jlt_status jlt_number_parse(double *value, const char *text, size_t length)
{
    jlt_status st;
    JLT_SCOPED(fmpq, exact);

    st = read_fraction(exact, text, length);
    if (st == JLT_OK) st = round_nearest(value, exact);
    return st;
}

jlt_status jlt_number_between(double *value, const char *low, size_t low_length, const char *high, size_t high_length,
                              size_t index, size_t parts)
{
    jlt_status st = index <= parts && parts > 0 ? JLT_OK : JLT_ERR_ARG;
    JLT_SCOPED(fmpq, first, last);
    JLT_SCOPED(fmpz, weight);

    if (st == JLT_OK) st = read_fraction(first, low, low_length);
    if (st == JLT_OK) st = read_fraction(last, high, high_length);
    if (st == JLT_OK) {
        fmpq_sub(last, last, first);
        fmpz_set_ui(weight, index);
        fmpq_mul_fmpz(last, last, weight);
        fmpz_set_ui(weight, parts);
        fmpq_div_fmpz(last, last, weight);
        fmpq_add(first, first, last);
        st = round_nearest(value, first);
    }
    return st;
}

jlt_status jlt_number_multiples(double *values, const char *text, size_t length, size_t parts, size_t first,
                                size_t count)
{
    JLT_SCOPED(fmpq, part);
    JLT_SCOPED(fmpz, multiple);
    const jlt_status st = parts > 0 ? read_fraction(part, text, length) : JLT_ERR_ARG;

    if (st != JLT_OK) return st;
    fmpz_set_ui(multiple, parts);
    fmpq_div_fmpz(part, part, multiple);
    for (size_t k = 0; k < count; k++) {
        fmpz_mul_ui(multiple, fmpq_numref(part), first + k);
        values[k] = nearest(multiple, fmpq_denref(part));
    }
    return JLT_OK;
}

jlt_status jlt_number_fraction(char **fraction, const char *text, size_t length)
{
    char *written = NULL;
    jlt_status st;

    *fraction = NULL;
    JLT_SCOPED(fmpq, exact);
    st = read_fraction(exact, text, length);
    if (st == JLT_OK) {
        written = fmpq_get_str(NULL, 10, exact);
        *fraction = written == NULL ? NULL : strdup(written);
        st = *fraction == NULL ? JLT_ERR_NOMEM : JLT_OK;
        flint_free(written);
    }
    return st;
}
