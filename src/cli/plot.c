#include "cli/plot.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "cli/grid.h"
#include "cli/interrupt.h"
#include "core/memory.h"
#include "ext/number.h"
#include "kernel/descriptor.h"
#include "report/picture.h"
#include "report/symbol.h"

enum { SIZE = 1200, FONT, XRANGE, YRANGE, TITLE, STYLE, AXES };

static const struct argp_option option_table[] = {
    { NULL, 0, NULL, 0, "The picture, beside --plot:", 13 },
    { "size", SIZE, "WIDTHxHEIGHT", 0,
      "Size of the picture in cm, or with mm or in after it in those units; default 18x13cm", 13 },
    { "font", FONT, "NAME[,POINTS]", 0,
      "Font of the picture and its size; default Helvetica, in a size that grows with the width: 8 points at 8 cm, 11 at 18 "
      "cm", 13 },
    { "xrange", XRANGE, "LOW:HIGH", 0,
      "Range of the x axis in all panels, such as -pi:pi; default: wide enough for all the data", 13 },
    { "yrange", YRANGE, "LOW:HIGH", 0, "Range of the y axis, likewise", 13 },
    { "title", TITLE, "TEXT", 0,
      "Text above the picture, exactly as typed; an empty one gives none. Default: model, and parameters and levels if "
      "there is room", 13 },
    { "style", STYLE, "WORD,...", 0,
      "grey (for print: black and greys, told apart by dashes and marks), dots (the smallest points possible), nokey (no "
      "key), points=FACTOR, lines=FACTOR (multiply the size of points, the width of lines)", 13 },
    { 0 },
};

static const struct argp_option axes_table[] = {
    { "axes", AXES, "NAME,NAME", 0, "The columns of the table on the picture's x and y axes", 13 },
    { 0 },
};

static bool number(double *value, const char *text, size_t length)
{
    return jlt_number_parse(value, text, length) == JLT_OK;
}

static void parse_size(jlt_look *look, const char *value, const struct argp_state *state)
{
    static const struct {
        const char *name;
        double cm;
    } units[] = { { "cm", 1 }, { "mm", 0.1 }, { "in", 2.54 } };
    const char *by = strchr(value, 'x');
    size_t length = strlen(value);
    double cm = 1;

    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (length > 2 && strcmp(value + length - 2, units[i].name) == 0) {
            cm = units[i].cm;
            length -= 2;
            break;
        }
    if (by == NULL || !number(&look->width, value, (size_t)(by - value))
        || !number(&look->height, by + 1, (size_t)(value + length - by) - 1))
        argp_error(state, "--size: '%s' is no size (write WIDTHxHEIGHT, such as 8x6cm)", value);
    look->width *= cm;
    look->height *= cm;
    if (!(look->width >= 3 && look->width <= 100 && look->height >= 3 && look->height <= 100))
        argp_error(state, "--size: '%s': width and height lie between 3 and 100 cm", value);
}

static void parse_font(jlt_look *look, const char *value, const struct argp_state *state)
{
    const size_t length = strcspn(value, ",");

    look->font = value;
    look->font_length = length;
    if (!jlt_look_font_fits(value, length))
        argp_error(state, "--font: '%s' is no name of a font, of letters, digits, blanks, '-', '.', ':' and '+'", value);
    if (value[length] == '\0') return;
    if (!number(&look->points, value + length + 1, strlen(value + length + 1)) || !(look->points >= 1 && look->points <= 100))
        argp_error(state, "--font: '%s' is no size of letters, from 1 to 100 points", value + length + 1);
}

static void parse_range(jlt_look *look, int axis, const char *value, const struct argp_state *state)
{
    const char *option = axis == 0 ? "--xrange" : "--yrange", *colon = strchr(value, ':');

    if (colon == NULL) argp_error(state, "%s: '%s' is no range (write LOW:HIGH)", option, value);
    else if (jlt_grid_number(&look->low[axis], value, (size_t)(colon - value), option) != JLT_EXIT_DONE
             || jlt_grid_number(&look->high[axis], colon + 1, strlen(colon + 1), option) != JLT_EXIT_DONE)
        exit((int)JLT_EXIT_USAGE);
    else if (!(look->low[axis] < look->high[axis])) argp_error(state, "%s: '%s': LOW lies below HIGH", option, value);
}

static void parse_style(jlt_look *look, const char *value, const struct argp_state *state)
{
    for (size_t length; *value != '\0'; value += length + (value[length] == ',')) {
        const struct {
            const char *name;
            bool *flag;
            double *factor;
        } words[] = { { "grey", &look->grey, NULL },    { "dots", &look->dots, NULL },    { "nokey", &look->no_key, NULL },
                      { "points=", NULL, &look->size }, { "lines=", NULL, &look->line } };
        bool known = false;
        length = strcspn(value, ",");
        for (size_t i = 0; i < sizeof words / sizeof *words && !known; i++) {
            const size_t name = strlen(words[i].name);
            if (length < name || strncmp(value, words[i].name, name) != 0) continue;
            if (words[i].flag != NULL) known = *words[i].flag = length == name;
            else known = number(words[i].factor, value + name, length - name) && *words[i].factor > 0 && *words[i].factor <= 100;
        }
        if (!known)
            argp_error(state, "--style: '%.*s' is none of grey, dots, nokey, points=FACTOR, lines=FACTOR (0 < FACTOR <= 100)",
                       (int)length, value);
    }
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_look *look = state->input;

    switch (key) {
    case SIZE: parse_size(look, value, state); break;
    case FONT: parse_font(look, value, state); break;
    case XRANGE:
    case YRANGE: parse_range(look, key == YRANGE, value, state); break;
    case TITLE:
        if (!jlt_look_text_fits(value))
            argp_error(state, "--title: this is no text in UTF-8, or there are control characters in it");
        look->title = value;
        break;
    case STYLE: parse_style(look, value, state); break;
    default: return ARGP_ERR_UNKNOWN;
    }
    look->asked = true;
    return 0;
}

static error_t parse_axes(int key, char *value, struct argp_state *state)
{
    jlt_common *common = state->input;

    if (key != AXES) return ARGP_ERR_UNKNOWN;
    if (strchr(value, ',') == NULL) argp_error(state, "--axes: '%s': two names, of the x and the y axis", value);
    common->axes = value;
    common->look.asked = true;
    return 0;
}

const struct argp jlt_plot_argp = { option_table, parse, NULL, NULL, NULL, NULL, NULL };
const struct argp jlt_plot_axes_argp = { axes_table, parse_axes, NULL, NULL, NULL, NULL, NULL };

void jlt_plot_check_log(const jlt_common *common, const char *axes, const struct argp_state *state)
{
    for (; *axes != '\0'; axes++)
        if (common->look.low[*axes == 'y'] <= 0)
            argp_error(state, "--%crange: this axis is logarithmic, so that LOW must be positive", *axes);
}

jlt_exit jlt_plot_shown(unsigned shown[2], const jlt_common *common, const char *const *names, unsigned count)
{
    const char *name = common->axes;
    char known[256] = "";
    size_t used = 0;

    for (unsigned axis = 0; name != NULL && axis < 2; axis++) {
        const size_t length = axis == 0 ? strcspn(name, ",") : strlen(name);
        unsigned i = 0;
        while (i < count && (strlen(names[i]) != length || strncmp(names[i], name, length) != 0)) i++;
        shown[axis] = i;
        if (i < count) {
            name += length + 1;
            continue;
        }
        for (i = 0; i < count && used < sizeof known; i++)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s%s", i == 0 ? "" : ", ", names[i]);
        return jlt_command_fail(JLT_EXIT_USAGE, "--axes: there is no '%.*s' to draw; there are %s", (int)length, name, known);
    }
    return JLT_EXIT_DONE;
}

static void close_both(jlt_plot *self)
{
    jlt_command_discard(&self->script);
    jlt_command_discard(&self->title);
}

jlt_status jlt_plot_open(jlt_plot *self, const jlt_common *common)
{
    jlt_interrupt_draw();
    *self = (jlt_plot){ .common = common, .look = &common->look };
    if (jlt_command_open(&self->script) == JLT_OK && jlt_command_open(&self->title) == JLT_OK) {
        self->stream = self->script.stream;
        /* gnuplot only guesses the width of texts: one more letter keeps the columns of the key apart */
        jlt_look_key(self->stream, self->look, "bmargin center horizontal Left reverse samplen 2 height 1 width 1");
        return JLT_OK;
    }
    close_both(self);
    return JLT_ERR_NOMEM;
}

void jlt_plot_words(jlt_plot *self, const char *format, ...)
{
    char text[512];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    jlt_symbol_plain(self->title.stream, text, strlen(text));
    self->valued = false;
}

void jlt_plot_value(jlt_plot *self, const char *name, double value)
{
    if (isnan(value)) return;
    if (self->valued) fputs(", ", self->title.stream);
    jlt_symbol_write(self->title.stream, name);
    fputc('=', self->title.stream);
    jlt_symbol_number(self->title.stream, value);
    self->valued = true;
}

void jlt_plot_block(jlt_plot *self, const char *name, const char *rows)
{
    fprintf(self->stream, "$%s << END\n%sEND\n", name, rows != NULL ? rows : "");
}

void jlt_plot_label(char *label, const jlt_descriptor *model, const char *name)
{
    size_t index;

    jlt_look_label(label, name,
                   jlt_descriptor_param(model, name, &index)   ? model->params[index].unit
                   : jlt_descriptor_state(model, name, &index) ? model->states[index].unit
                                                               : "");
}

/* The least margin beside stacked panels, in units of the font size; on the right, that of keys. */
enum { MARGIN = 6 };

/* How many panels share the picture in the direction of an axis, for jlt_look_axis, which gives axes three fourths of a width and
 * 0.65 of a height. Panels that are not stacked have a title, labels and a key each, nine lines high. */
static double panels_along(const jlt_plot *self, char axis)
{
    const double em = jlt_look_points(self->look) * 2.54 / 72, width = self->look->width / em, height = self->look->height / em;

    if (self->rows == 0) return 1;
    if (axis == 'y' && self->stacked) return self->rows;
    if (axis == 'y') {
        fflush(self->title.stream);
        const double title = 1.2 * jlt_look_lines(NULL, self->look, self->title.text, true);
        return fmax(1, 0.65 * height / fmax(1, (height - title) / self->rows - 9));
    }
    return self->stacked ? 0.75 / (1 - (MARGIN + fmax(MARGIN, self->beside)) / width) : self->columns;
}

jlt_extent jlt_plot_axis(jlt_plot *self, char axis, const char *label, jlt_extent range, double period)
{
    double letters;

    range = jlt_look_axis(self->stream, self->look, axis, label, range, period, panels_along(self, axis), &letters);
    if (axis == 'y') self->letters = fmax(self->letters, letters);
    return range;
}

void jlt_plot_log(jlt_plot *self, char axis, const char *label, jlt_extent range, int base)
{
    jlt_look_log(self->stream, self->look, axis, label, range, base, panels_along(self, axis));
}

double jlt_plot_drift(double drift)
{
    return isnan(drift) ? drift : fmax(drift, 1e-17);
}

void jlt_plot_panels(jlt_plot *self, unsigned count, bool stacked)
{
    self->stacked = stacked;
    self->columns = stacked || self->look->width < 1.2 * self->look->height ? 1 : count;
    self->rows = count / self->columns;
}

double jlt_plot_beside(jlt_plot *self, double width)
{
    const double letters = self->look->width * 72 / 2.54 / jlt_look_points(self->look), sample = 4;

    self->beside = fmin(sample + width, letters / 2);
    return fmin(1, self->beside / (sample + width));
}

void jlt_plot_panel(jlt_plot *self, unsigned index, const char *label, jlt_extent range)
{
    const bool last = index + 1 == self->rows;

    jlt_plot_axis(self, 'x', last ? label : "", range, 0);
    fputs(last ? "set format x '% h'\n" : "set format x ''\n", self->stream);
}

/* Write the string of "title ..." or "set title ...": --title, or the caption. Returns its number of lines. */
static unsigned write_title(FILE *stream, const jlt_plot *self)
{
    const char *text = self->look->title;
    const unsigned lines = jlt_look_lines(stream, self->look, text != NULL ? text : self->title.text, text == NULL);

    if (text != NULL) fputs(" noenhanced", stream);
    return text != NULL && *text == '\0' ? 0 : lines;
}

/* Cut the caption to its first line if stacked panels would otherwise be too low, or others lower than a fourth of what they share:
 * six lines of each are labels and key. */
static void shorten_title(jlt_plot *self)
{
    const double letters = self->look->height * 72 / 2.54 / jlt_look_points(self->look), rows = fmax(1, self->rows);
    const double title = 1.2 * jlt_look_lines(NULL, self->look, self->title.text, true);

    if (self->stacked ? letters - 10 < 3.8 * rows : letters - title - 6 * rows < letters / 4)
        self->title.text[strcspn(self->title.text, "\n")] = '\0';
}

/* Begin the panels; stacked ones get margins for labels on the left and the key on the right. */
static void write_panels(FILE *stream, const jlt_plot *self)
{
    const double em = jlt_look_points(self->look) * 2.54 / 72, x = em / self->look->width, y = em / self->look->height;

    fprintf(stream, "set multiplot layout %u,%u title ", self->rows, self->columns);
    const unsigned lines = write_title(stream, self);
    if (self->stacked)
        fprintf(stream, " margins %.4f,%.4f,%.4f,%.4f spacing 0,%.4f", fmax(MARGIN, 3 + 0.6 * self->letters) * x,
                1 - fmax(MARGIN, self->beside) * x, 3.8 * y, 1 - (1.1 + 1.2 * lines) * y, 1.15 * y);
    fputc('\n', stream);
}

/* Make the whole script; names_output: with `set output`, for --keep. */
static jlt_status write_script(jlt_command_output *whole, const jlt_plot *self, bool names_output)
{
    JLT_PASS(jlt_command_open(whole));
    jlt_picture_terminal(whole->stream, self->common->plot, self->look);
    if (names_output) {
        fputs("set output ", whole->stream);
        jlt_look_quote(whole->stream, self->common->plot);
        fputc('\n', whole->stream);
    }
    if (self->rows > 0) write_panels(whole->stream, self);
    else if (fputs("set title ", whole->stream) >= 0) {
        write_title(whole->stream, self);
        fputc('\n', whole->stream);
    }
    fwrite(self->script.text, 1, self->script.size, whole->stream);
    if (self->rows > 0) fputs("unset multiplot\n", whole->stream);
    return jlt_command_close(whole);
}

jlt_exit jlt_plot_draw(jlt_plot *self)
{
    const jlt_common *common = self->common;
    jlt_command_output whole = { 0 }, kept = { 0 };
    JLT_FREED char *picture = NULL;
    size_t size = 0;
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st = jlt_command_close(&self->script);

    if (jlt_command_close(&self->title) != JLT_OK) st = JLT_ERR_NOMEM;
    else shorten_title(self);
    if (st == JLT_OK && common->keep != NULL) {
        st = write_script(&kept, self, true);
        if (st == JLT_OK) code = jlt_command_write(common->keep, kept.text, kept.size);
    }
    if (st == JLT_OK && code == JLT_EXIT_DONE) st = write_script(&whole, self, false);
    if (st == JLT_OK && code == JLT_EXIT_DONE) st = jlt_picture_draw(&picture, &size, whole.text, whole.size);
    if (st == JLT_ERR_UNSUPPORTED)
        code = jlt_command_fail(JLT_EXIT_IO, "--plot: no gnuplot to be found: install gnuplot to draw pictures");
    else if (st == JLT_ERR_EMPTY)
        code = jlt_command_fail(JLT_EXIT_INPUT, "--plot: nothing that could be drawn %s",
                                isnan(self->look->low[0]) && isnan(self->look->low[1]) ? "came out: is every point refused?"
                                                                                       : "lies within --xrange and --yrange");
    else if (st == JLT_ERR_IO)
        code = jlt_command_fail(JLT_EXIT_IO, "--plot: gnuplot could not draw '%s' (what it says is above)", common->plot);
    else if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "--plot: %s", jlt_status_text(st));
    else if (code == JLT_EXIT_DONE) code = jlt_command_write(common->plot, picture, size);
    if (code != JLT_EXIT_DONE && !jlt_command_is_standard_output(common->output))
        fprintf(stderr, "jellett: the table is saved in %s\n", common->output);
    jlt_command_discard(&whole);
    jlt_command_discard(&kept);
    close_both(self);
    return code;
}
