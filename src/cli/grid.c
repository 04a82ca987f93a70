#include "cli/grid.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "core/digits.h"
#include "ext/number.h"
#include "kernel/descriptor.h"

static const size_t PART_MAX = (size_t)1 << 50, WANTED_MAX = 1000000000000; /* the latter are weeks of the fastest command */

enum { AXES_MAX = 16 }; /* that a caller may ask for at once */

jlt_exit jlt_grid_number(double *value, const char *text, size_t length, const char *option)
{
    return jlt_grid_judge(jlt_number_parse(value, text, length), text, length, option);
}

jlt_exit jlt_grid_judge(jlt_status parsed, const char *text, size_t length, const char *option)
{
    if (parsed == JLT_ERR_ARG)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%.*s' is no finite number (write 2, -0.51, 1e-3, 1/3, pi or 2*pi/3)", option,
                                (int)length, text);
    if (parsed == JLT_ERR_NONFINITE)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%.*s' is outside the range of doubles, 2.3e-308 to 1.8e308", option,
                                (int)length, text);
    return parsed == JLT_OK ? JLT_EXIT_DONE : jlt_command_fail(JLT_EXIT_NUMERICAL, "%s", jlt_status_text(parsed));
}

jlt_exit jlt_grid_count(size_t *value, const char *text, size_t low, size_t high, const char *option)
{
    char *end;
    unsigned long long number;

    errno = 0;
    number = strtoull(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 || number < low || number > high)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%s' is no whole number from %zu to %zu", option, text, low, high);
    *value = (size_t)number;
    return JLT_EXIT_DONE;
}

static jlt_exit count_part(size_t *value, const char *text, size_t length, const char *option)
{
    char copy[24];

    if (length >= sizeof copy) length = sizeof copy - 1;
    memcpy(copy, text, length);
    copy[length] = '\0';
    return jlt_grid_count(value, copy, 1, 1000000000, option);
}

jlt_exit jlt_grid_axis_parse(jlt_grid_axis *axis, const char *text, size_t length, const char *option)
{
    const char *equals = memchr(text, '=', length), *end = text + length, *first, *second;
    jlt_grid_axis read = { .count = 1 };
    jlt_exit code;

    if (equals != NULL) read.low_text = read.high_text = equals + 1;
    if (equals != NULL && (size_t)(equals - text) >= sizeof read.name)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: no table has the name '%.*s', of more than %zu letters", option,
                                (int)(equals - text), text, sizeof read.name - 1);
    if (equals == text) return jlt_command_fail(JLT_EXIT_USAGE, "%s: no name stands before '='", option);
    if (equals == NULL)
        return jlt_command_fail(JLT_EXIT_USAGE, "%s: '%.*s' is no range (write NAME=LOW:HIGH:COUNT)", option, (int)length,
                                text);
    memcpy(read.name, text, (size_t)(equals - text));
    first = memchr(equals, ':', (size_t)(end - equals));
    if (first == NULL) {
        code = jlt_grid_number(&read.low, equals + 1, (size_t)(end - equals) - 1, option);
        read.high = read.low;
        read.low_length = read.high_length = (size_t)(end - equals) - 1;
    } else {
        second = memchr(first + 1, ':', (size_t)(end - first) - 1);
        if (second == NULL)
            return jlt_command_fail(JLT_EXIT_USAGE, "%s: '%.*s' has no count (write NAME=LOW:HIGH:COUNT)", option,
                                    (int)length, text);
        read.high_text = first + 1;
        read.low_length = (size_t)(first - equals) - 1;
        read.high_length = (size_t)(second - first) - 1;
        code = jlt_grid_number(&read.low, read.low_text, read.low_length, option);
        if (code == JLT_EXIT_DONE) code = jlt_grid_number(&read.high, read.high_text, read.high_length, option);
        if (code == JLT_EXIT_DONE) code = count_part(&read.count, second + 1, (size_t)(end - second) - 1, option);
    }
    if (code == JLT_EXIT_DONE) *axis = read;
    return code;
}

static bool is_named_before(const char *list, const char *end, const char *name)
{
    const size_t length = strlen(name);

    for (const char *at = list; at < end; at += strcspn(at, ",") + 1)
        if (strncmp(at, name, length) == 0 && at[length] == '=') return true;
    return false;
}

static jlt_exit read_part(jlt_grid_axis *first, const char *text, const char *option)
{
    char copy[24] = "";
    const size_t length = strcspn(text, ":");
    jlt_exit code;

    if (text[length] == '\0' || length >= sizeof copy)
        return jlt_command_fail(JLT_EXIT_USAGE, "%s: '@%s' is no part of a grid (write @FIRST:COUNT)", option, text);
    memcpy(copy, text, length);
    code = jlt_grid_count(&first->first, copy, 0, PART_MAX, option);
    return code == JLT_EXIT_DONE ? jlt_grid_count(&first->part, text + length + 1, 1, PART_MAX, option) : code;
}

bool jlt_grid_ends(const char **text, char *name, size_t size, double *low, double *high)
{
    const char *const from = *text;
    const size_t named = strcspn(from, "=,"), first = strcspn(from + named, ":,@"), rest = strcspn(from + named + first, ",@");
    const char *const second = from + named + first + 1;

    if (*from == '\0') return false;
    snprintf(name, size, "%.*s", (int)named, from);
    if (first == 0 || jlt_number_parse(low, from + named + 1, first - 1) != JLT_OK) *low = NAN;
    if (rest == 0 || jlt_number_parse(high, second, strcspn(second, ":,@")) != JLT_OK) *high = NAN;
    *text += strcspn(from, ",");
    *text += **text == ',';
    return true;
}

jlt_exit jlt_grid_parse(jlt_grid_axis *axes, size_t *count, size_t room, const char *text, const char *option)
{
    jlt_exit code = JLT_EXIT_DONE;
    const bool named = *count == room;
    const char *const whole = text;
    size_t i = 0;

    if (strchr(text, '=') == NULL && *count > 0) {
        for (i = 0; code == JLT_EXIT_DONE && i < *count; i++) {
            const size_t length = strcspn(text, "x@");
            code = count_part(&axes[i].count, text, length, option);
            text += length;
            if ((i + 1 < *count) != (*text == 'x'))
                return jlt_command_fail(JLT_EXIT_USAGE, "%s: a grid is COUNTxCOUNT or NAME=LOW:HIGH:COUNT,...", option);
            if (*text == 'x') text++;
        }
        return code == JLT_EXIT_DONE && *text == '@' ? read_part(axes, text + 1, option) : code;
    }
    while (code == JLT_EXIT_DONE && *text != '\0' && *text != '@') {
        const size_t length = strcspn(text, ",@");
        jlt_grid_axis axis;
        size_t at = 0;
        code = jlt_grid_axis_parse(&axis, text, length, option);
        if (code != JLT_EXIT_DONE) break;
        if (is_named_before(whole, text, axis.name))
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%s' is given twice", option, axis.name);
        while (at < *count && strcmp(axes[at].name, axis.name) != 0) at++;
        if (at == *count && named)
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: there is no coordinate '%s' here", option, axis.name);
        if (at == *count && *count == room)
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: more than %zu names", option, room);
        if (at == *count) ++*count;
        axes[at] = axis;
        text += length;
        if (*text == ',') text++;
    }
    if (code == JLT_EXIT_DONE && *count == 0)
        return jlt_command_fail(JLT_EXIT_USAGE, "%s: no range is given (write NAME=LOW:HIGH:COUNT,...)", option);
    return code == JLT_EXIT_DONE && *text == '@' ? read_part(axes, text + 1, option) : code;
}

jlt_exit jlt_grid_read(jlt_grid_axis *axes, size_t *count, size_t room, const char *text, const char *option)
{
    *count = 0;
    if (strchr(text, '=') == NULL) { /* COUNTxCOUNT */
        *count = 1;
        for (const char *c = text; *c != '\0' && *count < room; c++) *count += *c == 'x';
    }
    return jlt_grid_parse(axes, count, room, text, option);
}

double jlt_grid_value(const jlt_grid_axis *axis, size_t index, double period)
{
    size_t parts = axis->count > 1 ? axis->count - 1 : 1;
    double value;

    if (period != 0 && fabs(axis->high - axis->low - period) < 1e-9) parts = axis->count;
    if (index == 0) return axis->low;
    if (index == parts) return axis->high;
    if (axis->low_text != NULL
        && jlt_number_between(&value, axis->low_text, axis->low_length, axis->high_text, axis->high_length, index, parts) == JLT_OK)
        return value;
    return (axis->low * (double)(parts - index) + axis->high * (double)index) / (double)parts; /* the ends were not typed */
}

jlt_exit jlt_grid_size(size_t *all, const jlt_grid_axis *axes, size_t count, const char *text, const char *option)
{
    *all = 1;
    for (size_t k = 0; k < count; k++)
        if (__builtin_mul_overflow(*all, axes[k].count, all))
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%s' has more points than can be counted", option, text);
    if (count > 0 && axes[0].part > 0) {
        if (axes[0].first + axes[0].part > *all)
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%s' asks for points beyond the last of %zu", option, text, *all);
        *all = axes[0].part;
    }
    if (*all > WANTED_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%s' has %zu points; at most %zu are computed", option, text, *all,
                                WANTED_MAX);
    return JLT_EXIT_DONE;
}

jlt_exit jlt_grid_whole(const jlt_grid_axis *axes, const char *option)
{
    if (axes[0].part == 0) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_USAGE, "%s: the whole grid is needed here: leave out @%zu:%zu", option, axes[0].first,
                            axes[0].part);
}

void jlt_grid_point(double *values, const jlt_grid_axis *axes, size_t count, size_t index)
{
    if (count > 0) index += axes[0].first;
    for (size_t k = count; k-- > 0;) {
        values[k] = jlt_grid_value(&axes[k], index % axes[k].count, 0);
        index /= axes[k].count;
    }
}

size_t jlt_grid_place(char *text, const jlt_grid_axis *axes, size_t count, size_t index)
{
    double values[AXES_MAX];
    size_t used = 0;

    jlt_grid_point(values, axes, count, index);
    text[0] = '\0';
    for (size_t k = 0; k < count && used < JLT_GRID_PLACE_MAX; k++)
        used += (size_t)snprintf(text + used, JLT_GRID_PLACE_MAX - used, "%s%s=%.10g", k > 0 ? ", " : "", axes[k].name, values[k]);
    return used;
}

void jlt_grid_fields(char *text, const jlt_grid_axis *axes, size_t count, size_t index)
{
    double values[AXES_MAX];

    jlt_grid_point(values, axes, count, index);
    for (size_t k = 0; k < count; k++) {
        text = jlt_digits_shortest(text, values[k]);
        *text++ = ',';
    }
    *text = '\0';
}

char *jlt_grid_assignments(const char *option, const jlt_grid_axis *axes, size_t count, size_t index, const jlt_descriptor *model,
                           bool params)
{
    double values[AXES_MAX];
    char digits[JLT_DIGITS_SIZE], *text = NULL;
    size_t size = 0;
    bool first = true;
    FILE *stream = open_memstream(&text, &size);

    if (stream == NULL) return NULL;
    jlt_grid_point(values, axes, count, index);
    for (size_t k = 0; k < count; k++) {
        if (jlt_descriptor_param(model, axes[k].name, &(size_t){ 0 }) != params) continue;
        jlt_digits_shortest(digits, values[k]);
        fprintf(stream, "%s%s%s=%s", first ? option : "", first ? "=" : ",", axes[k].name, digits);
        first = false;
    }
    if (fclose(stream) == 0) return text;
    free(text);
    return NULL;
}
