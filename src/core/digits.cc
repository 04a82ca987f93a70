/* The only C++ of the library: std::to_chars, which finds the shortest digits, has no counterpart in C. */
extern "C" {
#include "core/digits.h"
}

#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

namespace {

/* A number as std::to_chars writes it, d.ddde-XX: its digits without the point, and the decimal exponent. */
struct decimal {
    bool negative;
    int count, exponent;
    char digits[JLT_DIGITS_SIZE];
};

decimal read_scientific(const char *text, const char *end)
{
    decimal out = {};

    out.negative = *text == '-';
    for (text += out.negative; text < end && *text != 'e'; text++)
        if (*text != '.') out.digits[out.count++] = *text;
    text += 1 + (text[1] == '+'); /* from_chars accepts no plus sign */
    std::from_chars(text, end, out.exponent);
    return out;
}

char *put(char *to, char c, int count)
{
    std::memset(to, c, static_cast<std::size_t>(count));
    return to + count;
}

char *put(char *to, const char *from, int count)
{
    std::memcpy(to, from, static_cast<std::size_t>(count));
    return to + count;
}

char *write_fixed(char *text, const decimal &d)
{
    const int whole = d.exponent + 1; /* digits before the point */

    if (d.negative) *text++ = '-';
    if (whole <= 0) {
        text = put(text, "0.", 2);
        text = put(text, '0', -whole);
        text = put(text, d.digits, d.count);
    } else if (d.count <= whole) {
        text = put(text, d.digits, d.count);
        text = put(text, '0', whole - d.count);
    } else {
        text = put(text, d.digits, whole);
        *text++ = '.';
        text = put(text, d.digits + whole, d.count - whole);
    }
    return text;
}

/* Chooses between fixed and scientific form as printf's %g does with a precision of at least 15 digits. */
char *write_shortest(char *text, double value)
{
    char *const end = text + JLT_DIGITS_SIZE - 1;
    const double size = std::fabs(value);

    if (size == 0 || (size >= 1e-4 && size < 1e15)) return std::to_chars(text, end, value, std::chars_format::fixed).ptr;
    char *at = std::to_chars(text, end, value, std::chars_format::scientific).ptr;
    if (!(value - value == 0)) return at; /* nan, inf */
    const decimal d = read_scientific(text, at);
    return d.exponent >= -4 && d.exponent < d.count ? write_fixed(text, d) : at;
}

} // namespace

extern "C" char *jlt_digits_shortest(char *text, double value)
{
    char *end = write_shortest(text, value);

    *end = '\0';
    return end;
}

extern "C" bool jlt_digits_read(double *value, const char *text, const char *end)
{
    double number = 0;
    const std::from_chars_result read = std::from_chars(text, end, number);

    if (read.ec != std::errc() || read.ptr != end) return false;
    *value = number;
    return true;
}
