#include "validated/numerals.h"

#include <string.h>

enum { EXPONENT_DIGITS_MAX = 6 };

/* The text after at least one digit; NULL if there is none. */
static const char *skip_digits(const char *text)
{
    const size_t count = text == NULL ? 0 : strspn(text, "0123456789");

    return count == 0 ? NULL : text + count;
}

static const char *skip_exponent(const char *text)
{
    const char *digits = text + 1, *end;

    if (digits[0] == '+' || digits[0] == '-') digits++;
    end = skip_digits(digits);
    return end == NULL || end - digits > EXPONENT_DIGITS_MAX ? NULL : end;
}

typedef enum { NO_NUMBER, WHOLE, FRACTION, DECIMAL } form;

static form form_of(const char *text)
{
    const char *end = text == NULL ? NULL : skip_digits(text + (text[0] == '-'));
    form found = WHOLE;

    if (end != NULL && end[0] == '/') {
        found = FRACTION;
        end = skip_digits(end + 1);
    } else if (end != NULL) {
        if (end[0] == '.') {
            found = DECIMAL;
            end = skip_digits(end + 1);
        }
        if (end != NULL && (end[0] == 'e' || end[0] == 'E')) {
            found = DECIMAL;
            end = skip_exponent(end);
        }
    }
    return end != NULL && end[0] == '\0' && end - text < JLT_NUMERALS_LENGTH_MAX ? found : NO_NUMBER;
}

bool jlt_numerals_fraction(fmpq_t out, const char *text)
{
    const form found = form_of(text);
    const bool good = (found == WHOLE || found == FRACTION) && fmpq_set_str(out, text, 10) == 0
                      && !fmpz_is_zero(fmpq_denref(out));

    if (good) fmpq_canonicalise(out);
    return good;
}

bool jlt_numerals_read(arb_t out, const char *text, slong bits)
{
    bool good;

    if (form_of(text) == DECIMAL) return arb_set_str(out, text, bits) == 0 && arb_is_finite(out);
    JLT_SCOPED(fmpq, fraction);
    good = jlt_numerals_fraction(fraction, text);
    if (good) arb_set_fmpq(out, fraction, bits);
    return good;
}

/* Read middle and radius as written, each rounded outwards. */
static bool read_parts(arb_t middle, arb_t radius, const json_t *ball, slong bits)
{
    return json_object_size(ball) == 2 && jlt_numerals_read(middle, json_string_value(json_object_get(ball, "middle")), bits)
           && jlt_numerals_read(radius, json_string_value(json_object_get(ball, "radius")), bits) && !arb_is_negative(radius);
}

bool jlt_numerals_ball(arb_t out, const json_t *ball, slong bits)
{
    bool good;
    JLT_SCOPED(arb, radius);

    good = read_parts(out, radius, ball, bits);
    if (good) arb_add_error(out, radius);
    return good;
}

bool jlt_numerals_is_ball(const json_t *ball)
{
    JLT_SCOPED(arb, value);

    return jlt_numerals_ball(value, ball, 64);
}

bool jlt_numerals_hold(const json_t *ball, const arb_t value, slong bits)
{
    bool good;
    JLT_SCOPED(arb, middle, radius);
    JLT_SCOPED(arf, reach, room);

    good = read_parts(middle, radius, ball, bits);
    if (good) {
        arb_sub(middle, value, middle, bits);
        arb_get_abs_ubound_arf(reach, middle, bits);
        arb_get_lbound_arf(room, radius, bits);
        good = arf_cmp(reach, room) <= 0;
    }
    return good;
}
