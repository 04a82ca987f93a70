/** The picture of a command: the options that all have, and its script, from opening to drawing. */
#ifndef JLT_CLI_PLOT_H
#define JLT_CLI_PLOT_H

#include "cli/common.h"

/* Child parser of common.h, for a jlt_look; and one with a jlt_common for input, where a picture's axes are a choice: --axes. */
extern const struct argp jlt_plot_argp, jlt_plot_axes_argp;

/** A script. Data stand in it in full digits. */
typedef struct {
    const jlt_common *common;
    const jlt_look *look;
    FILE *stream;           /* commands and data */

    /* private */
    unsigned rows, columns; /* of panels; 0: one picture alone */
    bool stacked;
    jlt_command_output script, title;
    bool valued;
} jlt_plot;

/** To be drawn. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_plot_open(jlt_plot *self, const jlt_common *common);

/** The caption, which --title replaces: words, and values by name after them. A value that is NaN is left out. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void jlt_plot_words(jlt_plot *self, const char *format, ...);
void jlt_plot_value(jlt_plot *self, const char *name, double value);

/** $NAME, data in rows; rows may be NULL for none. */
void jlt_plot_block(jlt_plot *self, const char *name, const char *rows);

/** An axis as of jlt_look_axis, of the panel that is drawn next. Returns its range. */
jlt_extent jlt_plot_axis(jlt_plot *self, char axis, const char *label, jlt_extent range, double period);

/** After that: a logarithmic axis, with ticks at powers of ten, or of two as plain numbers. */
void jlt_plot_log(jlt_plot *self, char axis, int base);

/** So many panels in place of one picture: one below the other with the x axis in common, or side by side where there is room. */
void jlt_plot_panels(jlt_plot *self, unsigned count, bool stacked);

/** Before number `index` of panels one below the other: their x axis. */
void jlt_plot_panel(jlt_plot *self, unsigned index, const char *label, jlt_extent range);

/** While options are parsed: that what is asked for of these axes, "x" or "xy", can be logarithmic. Ends the program otherwise. */
void jlt_plot_check_log(const jlt_common *common, const char *axes, const struct argp_state *state);

/** What --axes names of these quantities, for x and y; unchanged where nothing is asked. Says what is wrong. */
jlt_exit jlt_plot_shown(unsigned shown[2], const jlt_common *common, const char *const *names, unsigned count);

/** Draw to --plot, keeping the script where asked, and close. To be called when the table is saved: says what is wrong, and that the
 *  table is there all the same. */
jlt_exit jlt_plot_draw(jlt_plot *self);

#endif
