/** How pictures look: what is asked of all of them alike, and the parts of a gnuplot script that obey it.
 *
 *  Text stands in a script in single quotes, in which gnuplot replaces nothing, so that no title and no name is ever a command.
 *  Markup is gnuplot's enhanced text, as of report/symbol.h. */
#ifndef JLT_REPORT_LOOK_H
#define JLT_REPORT_LOOK_H

#include "report/extent.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* A command: lines behind all curves. */
#define JLT_LOOK_GRID "set grid lc rgb '#d0d0d0' dt 1\n"

enum { JLT_LOOK_LABEL_MAX = 256, JLT_LOOK_SERIES = 10 };

typedef struct {
    double width, height;        /* [cm] */
    const char *font;            /* its name, which needs no quoting, as jlt_look_font_fits has it; not ended by '\0' */
    size_t font_length;
    double points;               /* of letters; 0: by the width */
    const char *title;           /* NULL: what the command says; "": none */
    double low[2], high[2];      /* of the x and the y axis; NaN: as the command has them */
    bool grey, dots, no_key;
    double size, line;           /* of points and lines, times what they are otherwise */
    bool asked;                  /* an option has set any of these */
} jlt_look;

/** Set the look of a picture for which no option is given. */
void jlt_look_default(jlt_look *self);

/** Whether this can be a font's name: letters, digits, blanks, '-', '.', ':', '+'. */
bool jlt_look_font_fits(const char *name, size_t length);

/** Whether this is UTF-8 without control characters but for ends of lines. */
bool jlt_look_text_fits(const char *text);

/** The size of letters, in points. */
double jlt_look_points(const jlt_look *self);

/** Write a string of gnuplot that stands for this text, to the letter. */
void jlt_look_quote(FILE *stream, const char *text);

/** The same, broken at blanks into lines that fit the picture's width. Returns how many lines. markup: the text has marks of
 *  gnuplot's enhanced text, which take no room. */
unsigned jlt_look_lines(FILE *stream, const jlt_look *self, const char *text, bool markup);

/** The label "SYMBOL [UNIT]" of an axis as markup; unit may be "". Out: label, shape (JLT_LOOK_LABEL_MAX,). */
void jlt_look_label(char *label, const char *name, const char *unit);

/** The distance of ticks in a range: about `room` of them or fewer, and two at least where the range is not empty. */
double jlt_look_step(jlt_extent range, double room);

/** Write the axis 'x' or 'y' with its label in markup, its range and as many ticks as fit. panels: how many of them stand side by
 *  side, or one above the other, in this direction. period: 2 pi for an angle, whose ticks are multiples of pi/2; else 0. Returns
 *  the range drawn, in which --xrange and --yrange win. */
jlt_extent jlt_look_axis(FILE *stream, const jlt_look *self, char axis, const char *label, jlt_extent range, double period,
                         unsigned panels);

/** Write "set key WHERE", or "unset key" with --style nokey. */
void jlt_look_key(FILE *stream, const jlt_look *self, const char *where);

/** How data are drawn. with: lines, points, linespoints, or bars of errors, as gnuplot calls them; colour, dash and mark are
 *  numbers in a list, which begins anew behind its last one. */
typedef struct {
    const char *with;
    unsigned colour, dash, mark;
    double size; /* of points; lines have twice the width where it is 0 */
} jlt_pen;

/** Write the "with ..." of `plot`. Colours are told apart by the colour-blind; in grey, dashes and marks tell series apart. */
void jlt_look_pen(FILE *stream, const jlt_look *self, jlt_pen pen);

/** The colour of areas and of clouds of points, #rrggbb. */
const char *jlt_look_colour(const jlt_look *self, unsigned series);

/** Write the palette for continuous values, whose lightness rises with them, with the box of colours beside the picture, its label
 *  and ticks for this range of values. */
void jlt_look_palette(FILE *stream, const jlt_look *self, const char *label, jlt_extent values);

/** Write the palette for the values 0 .. count - 1, each in its colour of areas (jlt_look_colour). */
void jlt_look_steps(FILE *stream, const jlt_look *self, unsigned count);

/** Write data: a number with the fewest digits that read back bit for bit; a row of them with blanks between. */
void jlt_look_value(FILE *stream, double value);
void jlt_look_row(FILE *stream, const double *values, size_t count);

#endif
