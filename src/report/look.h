/** How pictures look: the options that all pictures share, and writers for the parts of a gnuplot script that depend on them.
 *
 *  The writers quote all text so that gnuplot substitutes nothing in it: a title or a name is never executed as a command. "Markup"
 *  is gnuplot's enhanced text, as report/symbol.h writes it. */
#ifndef JLT_REPORT_LOOK_H
#define JLT_REPORT_LOOK_H

#include "report/extent.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* A gnuplot command: grid lines behind all curves. */
#define JLT_LOOK_GRID "set grid lc rgb '#d0d0d0' dt 1\n"

enum { JLT_LOOK_LABEL_MAX = 256, JLT_LOOK_SERIES = 10 };

typedef struct {
    double width, height;        /* [cm] */
    const char *font;            /* its name, which jlt_look_font_fits accepts; shape (font_length,), without a NUL */
    size_t font_length;
    double points;               /* size of letters; 0: chosen by the width */
    const char *title;           /* NULL: the command's own caption; "": none */
    double low[2], high[2];      /* ranges of the x and the y axis; NaN: chosen by the command */
    bool grey, dots, no_key;
    double size, line;           /* factors of the size of points and the width of lines */
    bool asked;                  /* an option has set one of these members */
} jlt_look;

/** Set the look of a picture for which no option is given. */
void jlt_look_default(jlt_look *self);

/** Whether this can be a font's name, which is then safe inside quotes: letters, digits, blanks, '-', '.', ':', '+'. */
bool jlt_look_font_fits(const char *name, size_t length);

/** The size of letters, in points. */
double jlt_look_points(const jlt_look *self);

/** Write a gnuplot string expression whose value is exactly this text. */
void jlt_look_quote(FILE *stream, const char *text);

/** The same, with the text broken at blanks into lines that fit the picture's width, and a name longer than that after an
 *  underscore of it. stream: NULL to count only. Returns the number of lines. markup: the text is gnuplot's enhanced text, whose
 *  marks take no room; lines behind its first newline are smaller. */
unsigned jlt_look_lines(FILE *stream, const jlt_look *self, const char *text, bool markup);

/** The approximate width of a label in markup, in units of the font size. */
double jlt_look_breadth(const char *label);

/** The label "SYMBOL [UNIT]" of an axis as markup, without the unit where that is "" or "1"; "[UNIT]" where the name is "". Out:
 *  label, shape (JLT_LOOK_LABEL_MAX,). */
void jlt_look_label(char *label, const char *name, const char *unit);

/** Write the axis 'x' or 'y' with its label in markup, its range and as many ticks as fit. panels: how many panels share the
 *  picture in the direction of this axis; not whole where margins differ. period: 2 pi for an angle, whose ticks are multiples of
 *  pi/2 where the range is long; else 0. Very large or small numbers are counted in a power of ten, which the label tells. Out:
 *  letters, in the longest label of a tick, 0 for an angle. Returns the range drawn: that of --xrange or --yrange where given. */
jlt_extent jlt_look_axis(FILE *stream, const jlt_look *self, char axis, const char *label, jlt_extent range, double period,
                         double panels, double *letters);

/** The same for a logarithmic axis of this base, 10 or 2. range: made longer up to powers of ten; OPEN: that of
 *  --xrange or --yrange, or else left to gnuplot. */
void jlt_look_log(FILE *stream, const jlt_look *self, char axis, const char *label, jlt_extent range, int base, double panels);

/** Write "set key WHERE", or "unset key" with --style nokey. */
void jlt_look_key(FILE *stream, const jlt_look *self, const char *where);

/** How data are drawn. with: gnuplot's name of the style: lines, points, linespoints, yerrorbars, ...; colour, dash and mark index
 *  lists, modulo their lengths. */
typedef struct {
    const char *with;
    unsigned colour, dash, mark;
    double size; /* of points; 0: no points, and wider lines */
} jlt_pen;

/** Write the "with ..." of `plot`. Colour-blind readers can distinguish the colours; in grey, dashes and marks distinguish
 *  series. */
void jlt_look_pen(FILE *stream, const jlt_look *self, jlt_pen pen);

/** The colour of areas and of clouds of points, #rrggbb. */
const char *jlt_look_colour(const jlt_look *self, unsigned series);

/** Write a palette for continuous values, whose lightness increases with the value, and the colour box's label and ticks for this
 *  range of values. Returns the width that it takes beside the axes, in units of the font size. */
double jlt_look_palette(FILE *stream, const jlt_look *self, const char *label, jlt_extent values);

/** Write a palette that gives each of the values 0 .. count - 1 its colour (jlt_look_colour), without a colour box. */
void jlt_look_steps(FILE *stream, const jlt_look *self, unsigned count);

/** Write a line of data, values (count,), each with the fewest digits that read back bit for bit, with blanks between them. */
void jlt_look_row(FILE *stream, const double *values, size_t count);

/** Write `to`, shape (count,), as the next point of the line that is at `from`; x and y are the first two values. Where the shorter
 *  way leads over the end of a period, the line leaves the picture on one side and comes back on the other. period: shape (2,),
 *  those of angles, else 0. count: at most 4. */
void jlt_look_line(FILE *stream, const double *from, const double *to, size_t count, const double *period);

#endif
