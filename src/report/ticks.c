#include "report/ticks.h"

#include <math.h>
#include <stdlib.h>

/* How many multiples of the step lie in the range. */
static double count(jlt_extent range, double step)
{
    return floor(range.high / step + 1e-9) - ceil(range.low / step - 1e-9) + 1;
}

/* The distance between ticks, so that about `room` of them or fewer, but up to `fewest`, lie in the range, and at least two if it
 * is not empty. */
static double step_of(jlt_extent range, double room, double fewest)
{
    const double least = (range.high - range.low) / fmax(fewest, room), power = pow(10, floor(log10(least))),
                 part = least / power * (1 - 1e-9);

    const double round = part <= 1 ? 1 : part <= 2 ? 2 : part <= 5 ? 5 : 10;
    /* One tick gives no scale: take the largest step that puts two ticks into the range. */
    static const double shorter[] = { 10, 8, 6, 5, 4, 3, 2, 1.5, 1 };
    for (size_t i = 0; i < sizeof shorter / sizeof *shorter; i++)
        if (shorter[i] <= round && count(range, shorter[i] * power) >= 2) return shorter[i] * power;
    return round * power;
}

static double size_of(jlt_extent range)
{
    return fmax(fabs(range.low), fabs(range.high));
}

/* The value in the unit of the labels. In two factors, as 10^-power itself may be too large for a double. */
static double counted(double value, int power)
{
    return value * pow(10, -(power / 2)) * pow(10, -(power - power / 2));
}

static jlt_ticks with_step(jlt_extent range, double step)
{
    const double size = size_of(range);
    jlt_ticks ticks = { .step = step, .power = size >= 1e5 || size < 1e-2 * (1 - 1e-9) ? (int)floor(log10(size) + 1e-9) : 0 };

    for (double part = counted(step, ticks.power); fabs(part - round(part)) > 1e-6*part && ticks.decimals < 17; part *= 10)
        ticks.decimals++;
    for (int k = 0; k < 2; k++)
        ticks.letters = fmax(ticks.letters, snprintf(NULL, 0, "%.*f", (int)ticks.decimals,
                                                     counted(k == 0 ? range.low : range.high, ticks.power)));
    return ticks;
}

jlt_ticks jlt_ticks_choose(jlt_extent range, double room, bool across)
{
    const jlt_ticks ticks = with_step(range, step_of(range, room, 3));

    return across && ticks.letters > 6 ? with_step(range, step_of(range, room * 4 / ticks.letters, 2)) : ticks;
}

/* Whether gnuplot's own labels, of six digits, show the numbers. */
static bool is_plain(jlt_extent range, const jlt_ticks *ticks)
{
    return ticks->power == 0 && floor(log10(fmax(1, size_of(range)))) + 1 + ticks->decimals <= 6;
}

void jlt_ticks_list(FILE *stream, const char *axis, jlt_extent range, const jlt_ticks *ticks, bool labelled)
{
    const double first = ceil(range.low / ticks->step - 1e-9), all = count(range, ticks->step);

    fprintf(stream, "set %stics (", axis);
    for (double k = 0; k < all; k++) {
        const double at = (first + k) * ticks->step, shown = counted(at, ticks->power);
        fprintf(stream, k == 0 ? "'" : ", '");
        if (labelled) fprintf(stream, "%s%.*f", shown < 0 ? "−" : "", (int)ticks->decimals, fabs(shown));
        fprintf(stream, "' %.15g", at);
    }
    fputs(")\n", stream);
}

void jlt_ticks_write(FILE *stream, const char *axis, jlt_extent range, const jlt_ticks *ticks, bool labelled)
{
    if (is_plain(range, ticks)) fprintf(stream, "set %stics %.15g\n", axis, ticks->step);
    else jlt_ticks_list(stream, axis, range, ticks, labelled);
}

void jlt_ticks_angle(FILE *stream, const char *axis, jlt_extent range, double room)
{
    const double half = acos(0);
    const int first = (int)ceil(range.low / half - 1e-9), last = (int)floor(range.high / half + 1e-9);
    const int step = last - first <= room ? 1 : 2 * (int)ceil((last - first) / fmax(2, room) / 2);

    fprintf(stream, "set %stics (", axis);
    for (int i = first - first % step; i <= last; i += step) {
        const int multiple = abs(i % 2 == 0 ? i / 2 : i);
        fprintf(stream, "%s'%s", i == first - first % step ? "" : ", ", i < 0 ? "−" : "");
        if (multiple != 1) fprintf(stream, "%d", multiple);
        fprintf(stream, "%s%s' %d*pi/2", i == 0 ? "" : "π", i % 2 == 0 ? "" : "/2", i);
    }
    fputs(")\n", stream);
}

void jlt_ticks_decades(FILE *stream, const char *axis, jlt_extent *range, double room, bool widen)
{
    jlt_extent powers = { log10(range->low), log10(range->high) };

    if (widen) {
        powers = (jlt_extent){ floor(powers.low), ceil(powers.high) };
        *range = (jlt_extent){ pow(10, powers.low), pow(10, powers.high) };
    }
    const double step = fmax(1, floor(step_of(powers, room, 3))), first = ceil(powers.low / step - 1e-9);
    fprintf(stream, "set %stics (", axis);
    for (double k = first; k <= floor(powers.high / step + 1e-9); k++)
        fprintf(stream, "%s'10^{%s%.0f}' 1e%.0f", k > first ? ", " : "", k < 0 ? "−" : "", fabs(k * step), k * step);
    fputs(")\n", stream);
}
