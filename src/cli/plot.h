/** The picture of a command: the options that all pictures have, and its gnuplot script, from opening to drawing. Call _open, write
 *  caption, data, axes and "plot ..." to it, then _draw. */
#ifndef JLT_CLI_PLOT_H
#define JLT_CLI_PLOT_H

#include "cli/common.h"

/* Parsers to be named as children: of how pictures look, with a jlt_look for input; and of --axes, for commands that let users
 * choose what a picture shows, with a jlt_common. */
extern const struct argp jlt_plot_argp, jlt_plot_axes_argp;

/** A gnuplot script with its data, which have full digits. */
typedef struct {
    const jlt_common *common;
    const jlt_look *look;
    FILE *stream;           /* takes commands of gnuplot; errors show when it is drawn */

    /* private */
    unsigned rows, columns; /* of panels; 0: one picture alone */
    bool stacked;
    jlt_command_output script, title;
    bool valued;
} jlt_plot;

/** Open a script; jlt_plot_draw closes it. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_plot_open(jlt_plot *self, const jlt_common *common);

/** Add to the caption, which --title replaces: words, formatted as by printf, and behind them NAME=VALUE. A NaN is left out. */
JLT_PRINTF(2, 3) void jlt_plot_words(jlt_plot *self, const char *format, ...);
void jlt_plot_value(jlt_plot *self, const char *name, double value);

/** Write a block of data, $NAME for gnuplot. rows: lines of numbers; NULL: none. */
void jlt_plot_block(jlt_plot *self, const char *name, const char *rows);

/** The label of an axis for what has this name, with the unit of the model's parameter or state, if it is one. Out: label, shape
 *  (JLT_LOOK_LABEL_MAX,). */
void jlt_plot_label(char *label, const jlt_descriptor *model, const char *name);

/** Write the axis 'x' or 'y' of the panel that is drawn next, as jlt_look_axis does. Returns its range. */
jlt_extent jlt_plot_axis(jlt_plot *self, char axis, const char *label, jlt_extent range, double period);

/** Make this axis logarithmic, after jlt_plot_axis. base: 10, ticks at powers of ten; 2, ticks at powers of two as plain
 *  numbers. */
void jlt_plot_log(jlt_plot *self, char axis, int base);

/** Draw `count` panels in place of one picture: stacked, one below the other with a common x axis; else side by side where there is
 *  room. */
void jlt_plot_panels(jlt_plot *self, unsigned count, bool stacked);

/** Begin panel number `index` of stacked ones; label and range are those of the common x axis. */
void jlt_plot_panel(jlt_plot *self, unsigned index, const char *label, jlt_extent range);

/** While options are parsed, check that --xrange or --yrange of each axis in `axes`, "x" or "xy", which will be logarithmic, begins
 *  above 0. Ends the program with status 2 otherwise. */
void jlt_plot_check_log(const jlt_common *common, const char *axes, const struct argp_state *state);

/** Choose the quantities, of names (count,), that --axes names for x and y. Out: shown, their numbers; unchanged without --axes. */
jlt_exit jlt_plot_shown(unsigned shown[2], const jlt_common *common, const char *const *names, unsigned count);

/** Draw to --plot, keeping the script where asked, and close. To be called when the table is saved: says what is wrong, and that
 *  the table is there all the same. */
jlt_exit jlt_plot_draw(jlt_plot *self);

#endif
