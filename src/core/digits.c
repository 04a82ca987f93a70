#include "core/digits.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST = DBL_DIG, MOST = DBL_DECIMAL_DIG };

/* What printf and strtod do follows the locale, which belongs to the program that calls: the thread's is "C" meanwhile. */
static locale_t enter_plain_locale(void)
{
    return uselocale(newlocale(LC_ALL_MASK, "C", (locale_t)0));
}

static void leave_plain_locale(locale_t before)
{
    locale_t plain = uselocale(before);
    if (plain != before) freelocale(plain);
}

static bool reads_back(const char *text, double value)
{
    const double read = strtod(text, NULL);
    return !(read < value) && !(read > value);
}

static bool try_digits(char *text, int digits, double value)
{
    snprintf(text, JLT_DIGITS_SIZE, "%.*g", digits, value);
    return reads_back(text, value);
}

/* How far, in units of the seventeenth digit, a decimal may be from a normal double and still read back: half a unit of the
 * double's last place, 2^-54 of it divided by its mantissa, known to 1e-3 from four leading digits. Below a power of two, whose
 * mantissa is 1/2, it is half of that. */
static double reach_of(const char *leading, double mantissa)
{
    int digits = 0;
    for (int count = 0; count < 4; leading++) {
        if (*leading == '.') continue;
        digits = 10 * digits + *leading - '0';
        count++;
    }
    return 0x1p-54 / mantissa * digits * 1e13;
}

/* What is known without reading back of a decimal that lies so many units off seventeen digits, themselves rounded by half a
 * unit. */
static bool is_surely_within(double distance, double reach) { return distance + 0.5 < 0.998 * reach; }
static bool may_be_within(double distance, double reach) { return distance - 0.5 < 1.002 * reach; }

/* Sixteen digits from seventeen with a point among them, the last of which stands before `end`. */
static bool drop_last(char *shorter, const char *text, size_t end, double reach, double value)
{
    const char last = text[end - 1], before = text[end - 2];
    const int distance = last < '5' ? last - '0' : '9' + 1 - last;
    if (!may_be_within(distance, reach)) return false;
    if (last == '5' || (last > '5' && before == '9') || before == '.') return try_digits(shorter, MOST - 1, value);
    if (last < '5' && before == '0') return false; /* fifteen digits, or fewer */
    memcpy(shorter, text, end - 1);
    shorter[end - 2] = (char)(before + (last > '5'));
    memcpy(shorter + end - 1, text + end, strlen(text + end) + 1);
    return is_surely_within(distance, reach) || reads_back(shorter, value);
}

/* Few doubles are as near to fifteen digits as that. */
static bool drop_two(char *shorter, const char *text, size_t end, double reach, double value)
{
    const int tail = text[end - 2] == '.' ? 0 : 10 * (text[end - 2] - '0') + text[end - 1] - '0';
    return may_be_within(tail < 50 ? tail : 100 - tail, reach) && try_digits(shorter, LEAST, value);
}

void jlt_digits_shortest(char *text, double value)
{
    char shorter[JLT_DIGITS_SIZE];
    locale_t before = enter_plain_locale();
    snprintf(text, JLT_DIGITS_SIZE, "%.*g", MOST, value);
    int exponent;
    const double mantissa = fabs(frexp(value, &exponent));
    const size_t end = strcspn(text, "e"), first = strcspn(text, "123456789"), point = strcspn(text, ".");
    if (point < end && end - first - (point > first) == MOST && isnormal(value) && mantissa > 0.5) {
        const double reach = reach_of(text + first, mantissa);
        if (drop_two(shorter, text, end, reach, value) || drop_last(shorter, text, end, reach, value))
            memcpy(text, shorter, strlen(shorter) + 1);
    } else {
        for (int digits = LEAST; digits <= MOST && !try_digits(text, digits, value);) digits++;
    }
    leave_plain_locale(before);
}
