/** The picture of a command: the options that all pictures share, and its gnuplot script. Call jlt_plot_open, write caption, data,
 *  axes and "plot ..." to it, then call jlt_plot_draw. */
#ifndef JLT_CLI_PLOT_H
#define JLT_CLI_PLOT_H

#include "cli/common.h"

/* Child parsers: of how pictures look, whose input is a jlt_look; and of --axes, for commands that let users choose what a picture
 * shows, whose input is a jlt_common. */
extern const struct argp jlt_plot_argp, jlt_plot_axes_argp;

/** A gnuplot script with its data, which have full digits. */
typedef struct {
    const jlt_common *common;
    const jlt_look *look;   /* what was asked for; letters may be smaller, so that panels fit */
    FILE *stream;           /* takes gnuplot commands; write errors show in jlt_plot_draw */

    /* private */
    jlt_look own;           /* where `look` points */
    unsigned rows, columns; /* of panels; 0: there is one picture without panels */
    bool stacked;           /* panels share the x axis */
    bool to_scale;          /* both axes of a panel have the same scale */
    double beside;          /* the room for a colour box, or the keys of stacked panels, in units of the font size */
    double letters;         /* in the longest label of a tick on a y axis */
    jlt_command_output script, title;
    bool valued;            /* the caption ends with NAME=VALUE */
    bool met[2], apart[2];  /* by axis: whether some ranges of data meet --xrange and --yrange, and some do not */
} jlt_plot;

/** Open a script; jlt_plot_draw closes it. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_plot_open(jlt_plot *self, const jlt_common *common);

/** Add to the caption, which --title replaces: text, formatted as by printf; NAME=VALUE, unless the value is NaN. */
JLT_PRINTF(2, 3) void jlt_plot_words(jlt_plot *self, const char *format, ...);
void jlt_plot_value(jlt_plot *self, const char *name, double value);

/** Write a block of data, $NAME for gnuplot. rows: lines of numbers; NULL: none. */
void jlt_plot_block(jlt_plot *self, const char *name, const char *rows);

/** The label of an axis for a quantity of this name, with its unit if the model has or observes it. Out: label, shape
 *  (JLT_LOOK_LABEL_MAX,). */
void jlt_plot_label(char *label, const jlt_descriptor *model, const char *name);

/** The label of a time or a rate: with its unit if the model's table has units of time, else without. */
const char *jlt_plot_timed(const jlt_descriptor *model, const char *in_seconds, const char *without);

/** Write the axis 'x' or 'y' of the panel that is drawn next, as jlt_look_axis does. Returns its range. */
jlt_extent jlt_plot_axis(jlt_plot *self, char axis, const char *label, jlt_extent range, double period);

/** The same for a logarithmic axis, as jlt_look_log does. */
void jlt_plot_log(jlt_plot *self, char axis, const char *label, jlt_extent range, int base);

/** Write the palette and the colour box of a picture without panels, as jlt_look_palette does. Call it before the axes, which have
 *  less room beside the box. */
void jlt_plot_palette(jlt_plot *self, const char *label, jlt_extent values);

/** The height of the picture, in units of the font size. */
double jlt_plot_height(const jlt_plot *self);

/** A drift as it is drawn on a logarithmic axis: at least 1e-17, also where nothing drifts; NaN where it is not known. */
double jlt_plot_drift(double drift);

/** Lay out `count` panels in place of one picture: if stacked, one below the other with a common x axis, else side by side in a
 *  picture that is not higher than wide. */
void jlt_plot_panels(jlt_plot *self, unsigned count, bool stacked);

/** Before anything is computed: refuse a --size with no room for `count` stacked panels in legible letters, or in those of
 *  --font. */
jlt_exit jlt_plot_check_stack(const jlt_common *common, unsigned count);

/** Give the panels that follow axes of the same scale and length. */
void jlt_plot_to_scale(jlt_plot *self);

/** Leave room beside stacked panels for keys whose widest label has this width (jlt_look_breadth), up to half of the picture.
 *  Returns the factor, at most 1, of the size of letters with which it fits. */
double jlt_plot_beside(jlt_plot *self, double width);

/** Begin panel number `index` of stacked panels; label and range are those of the common x axis. */
void jlt_plot_panel(jlt_plot *self, unsigned index, const char *label, jlt_extent range);

/** While options are parsed: check that --xrange and --yrange begin above 0 for the axes in `axes` ("x" or "xy"), which will be
 *  logarithmic. Ends the program with status 2 otherwise. */
void jlt_plot_check_log(const jlt_common *common, const char *axes, const struct argp_state *state);

/** Find the quantities that --axes names for x and y among names (count,). Out: shown, their indices; unchanged without --axes. */
jlt_exit jlt_plot_shown(unsigned shown[2], const jlt_common *common, const char *const *names, unsigned count);

/** Draw to --plot, keep the script if --keep asks for it, and close. Call it after the table was saved: on failure the message says
 *  that the table is there nevertheless. */
jlt_exit jlt_plot_draw(jlt_plot *self);

#endif
