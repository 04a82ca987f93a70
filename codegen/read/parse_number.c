/* Conversion of decimal numbers, digits [. digits] [e [+-] digits], to exact rationals. */
#include "read/parser.h"

#include <stdlib.h>

static bool read_exponent(const char *text, size_t length, long *exponent)
{
    bool negative = length > 0 && *text == '-';
    size_t i = negative || (length > 0 && *text == '+') ? 1 : 0;
    long value = 0;
    for (; i < length && value <= TTC_DECIMAL_EXPONENT_LIMIT; i++) value = 10 * value + (text[i] - '0');
    *exponent = negative ? -value : value;
    return value <= TTC_DECIMAL_EXPONENT_LIMIT;
}

ttc_id ttc_parse_number(ttc_parser *parser, const ttc_token *token)
{
    char digits[TTC_DIGIT_LIMIT + 1];
    size_t count = 0, mantissa = 0;
    long fraction = 0, exponent = 0;
    bool after_point = false;
    if (token->length > TTC_DIGIT_LIMIT) {
        ttc_parse_error(parser, ttc_token_place(token), "a number of %u characters (expected at most %d)",
                        (unsigned)token->length, TTC_DIGIT_LIMIT);
        return TTC_NONE;
    }
    for (; mantissa < token->length && token->text[mantissa] != 'e' && token->text[mantissa] != 'E'; mantissa++) {
        if (token->text[mantissa] == '.') {
            after_point = true;
            continue;
        }
        digits[count++] = token->text[mantissa];
        fraction += after_point;
    }
    digits[count] = '\0';
    if (mantissa < token->length && !read_exponent(token->text + mantissa + 1, token->length - mantissa - 1, &exponent)) {
        ttc_parse_error(parser, ttc_token_place(token), "the decimal exponent is too large (expected at most %d)",
                        TTC_DECIMAL_EXPONENT_LIMIT);
        return TTC_NONE;
    }
    fmpq_t value, power;
    fmpq_init(value);
    fmpq_init(power);
    fmpz_set_str(fmpq_numref(value), digits, 10);
    fmpq_set_si(power, 10, 1);
    fmpq_pow_si(power, power, exponent - fraction);
    fmpq_mul(value, value, power);
    ttc_id id = ttc_number(parser->model->graph, value);
    fmpq_clear(power);
    fmpq_clear(value);
    return id == TTC_NONE ? ttc_parse_graph_error(parser, ttc_token_place(token)) : id;
}
