#include "report/look.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/digits.h"
#include "report/symbol.h"
#include "report/ticks.h"

/* The first colours are those of Okabe and Ito (2008), dark and light in turn. The greys, for areas, are chosen far apart. */
static const char *const colours[JLT_LOOK_SERIES] = { "#1a1a1a", "#d55e00", "#0072b2", "#e69f00", "#009e73",
                                                      "#cc79a7", "#56b4e9", "#808080", "#b0b0b0", "#8b4513" };
static const char *const greys[JLT_LOOK_SERIES] = { "#000000", "#909090", "#d0d0d0", "#606060", "#b0b0b0",
                                                    "#303030", "#c0c0c0", "#787878", "#a0a0a0", "#484848" };
static const int shapes[] = { 7, 4, 9, 6, 5, 8, 11, 2, 13, 1 };
static const char *const dashes[] = { "solid", "'-'", "'.'", "'-.'", "'_'", "'-..'" };

void jlt_look_default(jlt_look *self)
{
    *self = (jlt_look){ .width = 18, .height = 13, .font = "Helvetica", .font_length = strlen("Helvetica"), .low = { NAN, NAN },
                        .high = { NAN, NAN }, .size = 1, .line = 1 };
}

bool jlt_look_font_fits(const char *name, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (!isalnum((unsigned char)name[i]) && strchr(" -.:+", name[i]) == NULL) return false;
    return length > 0;
}

/* The scale of letters, marks and lines in a picture that is smaller than 8 x 6 cm, which they would cover otherwise. */
static double reduction(const jlt_look *self)
{
    return fmin(1, fmin(self->width / 8, self->height / 6));
}

double jlt_look_points(const jlt_look *self)
{
    const double usual = fmin(12, round(2 * (5.6 + 0.3 * fmax(8, self->width))) / 2);

    return self->points > 0 ? self->points : usual * reduction(self);
}

/* Write one line of text as a string in single quotes, between two texts of markup. Characters with a meaning to gnuplot become
 * octal escapes in a concatenated string: gnuplot 5.4 reads two single quotes at the start of a string as an empty string, and
 * expands macros next to double quotes. small: backslashes are markup as well. */
static void quote(FILE *stream, const char *before, const char *text, size_t length, const char *behind, bool small)
{
    const char *marks = small ? "'\"`@" : "'\"`@\\";

    fprintf(stream, "'%s", before);
    for (size_t i = 0; i < length; i++) {
        if (strchr(marks, text[i]) != NULL) fprintf(stream, "'.\"\\%03o\".'", (unsigned)text[i]);
        else fputc(text[i], stream);
    }
    fprintf(stream, "%s'", behind);
}

void jlt_look_quote(FILE *stream, const char *text)
{
    for (size_t length; length = strcspn(text, "\n"), quote(stream, "", text, length, "", false), text[length] != '\0';
         text += length + 1)
        fputs(".\"\\n\".", stream);
}

/* The approximate width of a UTF-8 byte's character in units of the font size, for DejaVu Sans: it replaces Helvetica where that is
 * not installed, and is wider. */
static double breadth(char first)
{
    if (((unsigned char)first & 0xc0) == 0x80) return 0; /* a continuation byte */
    if (strchr(" .,;:'|!/()[]ijltfI-", first) != NULL) return 0.34;
    if (strchr("mwMW%@=+<>", first) != NULL) return 0.86;
    return isupper((unsigned char)first) ? 0.72 : 0.63;
}

/* Whether the character at text[i] is a mark of enhanced text; behind a backslash it is a character like others. */
static bool is_mark(const char *text, size_t i)
{
    return strchr("_^{}\\", text[i]) != NULL && (i == 0 || text[i - 1] != '\\');
}

/* The size of letters behind a mark of enhanced text: braces enclose an index or a power. */
static double size_after(double size, char mark)
{
    return mark == '{' ? 0.8 : mark == '}' ? 1 : size;
}

double jlt_look_breadth(const char *label)
{
    double width = 0, size = 1;

    for (size_t i = 0; label[i] != '\0'; i++) {
        if (!is_mark(label, i)) width += size * breadth(label[i]);
        else size = size_after(size, label[i]);
    }
    return width;
}

/* How many bytes of a text to put on a line with this room, in units of the font size: up to a newline or its end, or to the last
 * blank that fits. A first word that does not fit ends after its last underscore that does, in markup one that is not a mark, or
 * after a comma inside an index; a word without these stays whole. size: of its first letter. */
static size_t fitting(const char *text, double room, bool markup, double size)
{
    size_t last = 0, joint = 0, i;

    for (i = 0; text[i] != '\0' && text[i] != '\n'; i++) {
        if (text[i] == ' ') last = i;
        if (!markup || !is_mark(text, i)) room -= size * breadth(text[i]);
        else size = size_after(size, text[i]);
        if (room < 0 && last + joint > 0) return last > 0 ? last : joint;
        if (text[i] == '_' ? !markup || !is_mark(text, i) : text[i] == ',' && size < 1) joint = i + 1;
    }
    return i;
}

unsigned jlt_look_lines(FILE *stream, const jlt_look *self, const char *text, bool markup)
{
    /* a title is centred over the axes, up to three letters off the centre of the picture; a caption is small below its first
     * line */
    const double room = self->width * 72 / 2.54 / jlt_look_points(self) - 6.5;
    unsigned lines = 1;
    bool small = false;
    double size = 1;

    for (;; lines++) {
        const bool inside = size < 1; /* the line begins inside an index, which is opened anew */
        const size_t length = fitting(text, small ? room / 0.85 : room, markup, size);
        for (size_t i = 0; markup && i < length; i++)
            if (is_mark(text, i)) size = size_after(size, text[i]);
        if (stream != NULL) {
            const char *const index = inside ? "_{" : "", *const end = size < 1 ? "}" : "";
            char before[16], behind[4];
            snprintf(before, sizeof before, "%s%s", small ? "{/*0.85 " : "", index);
            snprintf(behind, sizeof behind, "%s%s", end, small ? "}" : "");
            quote(stream, before, text, length, behind, small);
        }
        if (text[length] == '\0') return lines;
        small = small || (markup && text[length] == '\n');
        text += length + (text[length] == ' ' || text[length] == '\n');
        if (stream != NULL) fputs(".\"\\n\".", stream);
    }
}

void jlt_look_label(char *label, const char *name, const char *unit)
{
    const bool counts = unit[0] != '\0' && strcmp(unit, "1") != 0;
    FILE *stream = fmemopen(label, JLT_LOOK_LABEL_MAX, "w");

    *label = '\0';
    if (stream == NULL) return;
    jlt_symbol_write(stream, name);
    if (counts || *name == '\0') {
        fputs(*name != '\0' ? " [" : "[", stream);
        jlt_symbol_unit(stream, counts ? unit : "1");
        fputc(']', stream);
    }
    fclose(stream);
    label[JLT_LOOK_LABEL_MAX - 1] = '\0';
}

/* Write the label of an axis whose ticks count in powers of ten, which becomes a part of the unit. */
static void write_label(FILE *stream, const char *axis, const char *label, int power)
{
    const char *unit = strrchr(label, '[');
    const size_t name = unit != NULL ? (size_t)(unit - label) : strlen(label);
    const char *sign = power < 0 ? "−" : "";
    char whole[JLT_LOOK_LABEL_MAX + 32];

    if (power == 0 || *label == '\0') snprintf(whole, sizeof whole, "%s", label);
    else if (unit == NULL) snprintf(whole, sizeof whole, "%s [10^{%s%d}]", label, sign, abs(power));
    else if (strcmp(unit, "[1]") == 0) snprintf(whole, sizeof whole, "%.*s[10^{%s%d}]", (int)name, label, sign, abs(power));
    else snprintf(whole, sizeof whole, "%.*s[10^{%s%d} %s", (int)name, label, sign, abs(power), unit + 1);
    fprintf(stream, "set %slabel ", axis);
    jlt_look_quote(stream, whole);
}

/* How many ticks there is room for. Labels take a fourth of the width and a third of the height; a tick gets the room of six
 * letters in x, of 1.8 lines in y. */
static double tick_room(const jlt_look *self, char axis, double panels)
{
    const double letters = 72 / 2.54 / jlt_look_points(self) / panels;

    return axis == 'x' ? 0.75 * self->width * letters / (6 * 0.55) : 0.65 * self->height * letters / 1.8;
}

jlt_extent jlt_look_axis(FILE *stream, const jlt_look *self, char axis, const char *label, jlt_extent range, double period,
                         double panels, double *letters)
{
    const double two_pi = 4 * acos(0), room = tick_room(self, axis, panels);
    const int k = axis == 'y';
    const char name[] = { axis, '\0' };
    jlt_ticks ticks = { 0 };
    char ends[2][JLT_DIGITS_SIZE];

    if (!isnan(self->low[k])) range = (jlt_extent){ self->low[k], self->high[k] };
    if (range.high <= range.low) range = jlt_extent_wider(range);
    const bool known = range.high > range.low;
    const bool turns = known && fabs(period - two_pi) < 1e-9 && range.high - range.low > two_pi / 2.001
                       && range.high - range.low < 1000;
    if (known && !turns) ticks = jlt_ticks_choose(range, room, axis == 'x');
    const bool beside = axis == 'y' && panels > 1; /* a label without room for the power: that stands on the right */
    write_label(stream, name, label, beside ? 0 : ticks.power);
    if (beside) fputs("\nunset label", stream);
    if (beside && ticks.power != 0)
        fprintf(stream, "\nset label '{/*0.85 ×10^{%s%d}}' at graph 1,1 left offset 0.5,-0.3", ticks.power < 0 ? "−" : "",
                abs(ticks.power));
    fputs(axis == 'x' ? " offset 0,0.3\n" : "\n", stream);
    *letters = ticks.letters;
    if (!known) return range;
    jlt_digits_shortest(ends[0], range.low); /* in full: points may lie exactly at the ends of an angle's range */
    jlt_digits_shortest(ends[1], range.high);
    fprintf(stream, "set %crange [%s:%s]\n", axis, ends[0], ends[1]);
    if (turns) jlt_ticks_angle(stream, name, range, room);
    else jlt_ticks_write(stream, name, range, &ticks, *label != '\0');
    return range;
}

void jlt_look_log(FILE *stream, const jlt_look *self, char axis, const char *label, jlt_extent range, int base, double panels)
{
    const double room = tick_room(self, axis, panels);
    const char name[] = { axis, '\0' };
    const int k = axis == 'y';
    const bool typed = isnan(range.low) && !isnan(self->low[k]);
    jlt_ticks ticks = { 0 };

    if (typed) range = (jlt_extent){ self->low[k], self->high[k] };
    const bool short_range = typed && floor(log(range.high) / log(base) + 1e-9) < ceil(log(range.low) / log(base) - 1e-9) + 1;
    if (short_range) ticks = jlt_ticks_choose(range, room, axis == 'x');
    write_label(stream, name, label, ticks.power);
    fputs(axis == 'x' ? " offset 0,0.3\n" : "\n", stream);
    if (short_range) jlt_ticks_list(stream, name, range, &ticks, true);
    else if (range.high > range.low && base == 10) jlt_ticks_decades(stream, name, &range, room, !typed);
    else if (base == 10) fprintf(stream, "set %ctics autofreq\nset format %c '10^{%%T}'\n", axis, axis);
    if (range.high > range.low) fprintf(stream, "set %crange [%.15g:%.15g]\n", axis, range.low, range.high);
    fprintf(stream, "set logscale %c %d\n", axis, base); /* gnuplot warns if a range from before it is negative */
}

void jlt_look_key(FILE *stream, const jlt_look *self, const char *where)
{
    if (self->no_key) fputs("unset key\n", stream);
    else fprintf(stream, "set key %s\n", where);
}

const char *jlt_look_colour(const jlt_look *self, unsigned series)
{
    return (self->grey ? greys : colours)[series % JLT_LOOK_SERIES];
}

void jlt_look_pen(FILE *stream, const jlt_look *self, jlt_pen pen)
{
    const bool lines = strstr(pen.with, "line") != NULL, points = strcmp(pen.with, "lines") != 0;
    const bool dots = self->dots && strcmp(pen.with, "points") == 0;
    const bool cloud = !lines && pen.size < 0.3; /* points too small for marks to distinguish series */
    const unsigned count = sizeof dashes / sizeof *dashes;
    const bool black = (pen.colour + pen.dash / count) % 2 == 0; /* where dashes begin anew, black and grey change places */
    const char *colour = cloud || !self->grey ? jlt_look_colour(self, pen.colour) : black ? "#000000" : "#808080";

    fprintf(stream, "with %s lc rgb '%s'", dots ? "dots" : pen.with, colour);
    if (lines)
        fprintf(stream, " dt %s lw %.3g", dashes[pen.dash % count],
                (pen.size == 0 ? 2 : 1.2) * self->line * reduction(self));
    if (points && !dots)
        fprintf(stream, " pt %d ps %.3g", shapes[pen.mark % (sizeof shapes / sizeof *shapes)],
                pen.size * self->size * reduction(self));
}

double jlt_look_palette(FILE *stream, const jlt_look *self, const char *label, jlt_extent values)
{
    if (values.high == values.low) {
        values = jlt_extent_wider(values);
        fprintf(stream, "set cbrange [%.15g:%.15g]\n", values.low, values.high);
    }
    const bool known = values.high > values.low;
    const jlt_ticks ticks = known ? jlt_ticks_choose(values, 6, false) : (jlt_ticks){ 0 };
    const double margin = 5.2 + 0.8 * ticks.letters;

    write_label(stream, "cb", label, ticks.power);
    fputs(" offset 1.2,0\n", stream); /* gnuplot puts it so near that it touches labels of two letters */
    if (known) {
        jlt_ticks_write(stream, "cb", values, &ticks, true);
        /* set the margin: gnuplot leaves the same room for the colour box however long its tick labels are */
        fprintf(stream, "set rmargin %.1f\n", margin);
    }
    fputs(self->grey ? "set palette defined (0 '#202020', 1 '#d8d8d8')\n"
                     : "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n",
          stream);
    return margin;
}

void jlt_look_steps(FILE *stream, const jlt_look *self, unsigned count)
{
    fputs("set palette defined (", stream);
    for (unsigned k = 0; k < count; k++)
        fprintf(stream, "%s%g '%s', %g '%s'", k == 0 ? "" : ", ", k - 0.5, jlt_look_colour(self, k), k + 0.5,
                jlt_look_colour(self, k));
    fprintf(stream, ")\nset cbrange [-0.5:%g]\nunset colorbox\n", count - 0.5);
}

void jlt_look_row(FILE *stream, const double *values, size_t count)
{
    char text[JLT_DIGITS_SIZE];

    for (size_t i = 0; i < count; i++) {
        jlt_digits_shortest(text, values[i]);
        fputs(isnan(values[i]) ? "NaN" : text, stream);
        fputc(i + 1 < count ? ' ' : '\n', stream);
    }
}

void jlt_look_line(FILE *stream, const double *from, const double *to, size_t count, const double *period)
{
    double before[4], beyond[4]; /* from and to, by the other's side */
    bool turns = false;

    memcpy(before, from, count * sizeof *from);
    memcpy(beyond, to, count * sizeof *to);
    for (unsigned k = 0; k < 2; k++) {
        const double turn = period[k] == 0 ? 0 : period[k] * round((to[k] - from[k]) / period[k]);
        before[k] += turn;
        beyond[k] -= turn;
        turns |= turn != 0;
    }
    if (turns) {
        jlt_look_row(stream, beyond, count);
        fputc('\n', stream);
        jlt_look_row(stream, before, count);
    }
    jlt_look_row(stream, to, count);
}
