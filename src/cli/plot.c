#include "cli/plot.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "kernel/units.h"
#include "report/letters.h"
#include "report/picture.h"
#include "report/symbol.h"

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
    *self = (jlt_plot){ .common = common, .own = common->look, .look = &self->own };
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
    const char *unit = "";
    size_t index;

    for (unsigned i = 0; i < model->observe_count; i++)
        if (strcmp(model->observes[i].name, name) == 0) unit = model->observes[i].unit;
    if (jlt_descriptor_param(model, name, &index)) unit = model->params[index].unit;
    if (jlt_descriptor_state(model, name, &index)) unit = model->states[index].unit;
    jlt_look_label(label, name, unit);
}

const char *jlt_plot_timed(const jlt_descriptor *model, const char *in_seconds, const char *without)
{
    return jlt_units_has_time(model) ? in_seconds : without;
}

/* The least margin beside stacked panels, in units of the font size; on the right, that of keys. Panels that are not stacked have
 * a title, labels and a key each, of the height LABELS. */
enum { MARGIN = 6, LABELS = 9 };

/* The number of panels, not always whole, from which jlt_look_axis finds the length of an axis: three fourths of the width, or 0.65
 * of the height, over this. */
static double panels_along(const jlt_plot *self, char axis)
{
    const double em = jlt_look_points(self->look) * 2.54 / 72, width = self->look->width / em, height = self->look->height / em;

    if (self->rows == 0 && (axis == 'y' || self->beside <= 0)) return 1;
    if (axis == 'y' && self->stacked) return self->rows;
    if (axis == 'y') {
        fflush(self->title.stream);
        const double title = 1.2 * jlt_look_lines(NULL, self->look, self->title.text, true);
        return fmax(1, 0.65 * height / fmax(1, (height - title) / self->rows - LABELS));
    }
    if (self->stacked || self->rows == 0) return 0.75 / (1 - (MARGIN + fmax(MARGIN, self->beside)) / width);
    /* to scale, the axes of a panel are as long as its shorter side */
    return self->to_scale ? fmax(self->columns, 0.75 * width * panels_along(self, 'y') / (0.65 * height)) : self->columns;
}

static void look_for_data(jlt_plot *self, char axis, jlt_extent data)
{
    const bool y = axis == 'y', apart = data.high < self->look->low[y] || data.low > self->look->high[y];

    self->apart[y] |= apart;
    self->met[y] |= !apart;
}

jlt_extent jlt_plot_axis(jlt_plot *self, char axis, const char *label, jlt_extent range, double period)
{
    double letters;

    look_for_data(self, axis, range);
    range = jlt_look_axis(self->stream, self->look, axis, label, range, period, panels_along(self, axis), &letters);
    if (axis == 'y') self->letters = fmax(self->letters, letters);
    return range;
}

void jlt_plot_log(jlt_plot *self, char axis, const char *label, jlt_extent range, int base)
{
    look_for_data(self, axis, range);
    jlt_look_log(self->stream, self->look, axis, label, range, base, panels_along(self, axis));
}

void jlt_plot_palette(jlt_plot *self, const char *label, jlt_extent values)
{
    self->beside = jlt_look_palette(self->stream, self->look, label, values);
}

double jlt_plot_height(const jlt_plot *self) { return self->look->height * 72 / 2.54 / jlt_look_points(self->look); }

double jlt_plot_drift(double drift)
{
    return isnan(drift) ? drift : fmax(drift, 1e-17);
}

/* What stacked panels need at least, in units of the font size: a line each of title and ticks, the label below, and for each panel
 * three lines and a gap. */
static double stack(unsigned count)
{
    return 4.95 + 4.15 * count;
}

/* The least size of letters that this program chooses for stacked panels. */
enum { POINTS_LEAST = 5 };

jlt_exit jlt_plot_check_stack(const jlt_common *common, unsigned count)
{
    const double points = common->look.points > 0 ? common->look.points : POINTS_LEAST;
    const double least = ceil(10 * stack(count) * points * 2.54 / 72) / 10;

    if (common->plot == NULL || common->look.height >= least) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_USAGE, "--size: %u panels below each other take a height of %.1f cm at least; or choose two "
                                            "columns by --axes", count, least);
}

void jlt_plot_panels(jlt_plot *self, unsigned count, bool stacked)
{
    self->stacked = stacked;
    self->columns = stacked || self->look->width < self->look->height ? 1 : count;
    self->rows = count / self->columns;
    if (stacked && self->own.points == 0)
        self->own.points = fmin(jlt_look_points(self->look), self->own.height * 72 / 2.54 / stack(count));
}

void jlt_plot_to_scale(jlt_plot *self)
{
    self->to_scale = true;
    fputs("set size ratio -1\n", self->stream);
}

double jlt_plot_beside(jlt_plot *self, double width)
{
    const double letters = self->look->width * 72 / 2.54 / jlt_look_points(self->look), sample = 4;

    if (self->look->no_key) return 1;
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

/* Cut the caption to its first line if stacked panels would otherwise be too low, or others lower than a fourth of what they
 * share. */
static void shorten_title(jlt_plot *self)
{
    const double letters = jlt_plot_height(self), rows = fmax(1, self->rows);
    const double title = 1.2 * jlt_look_lines(NULL, self->look, self->title.text, true);

    if (self->stacked ? letters - title - 5 < 3.8 * rows : letters - title - LABELS * rows < letters / 4)
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

/* Open and make the whole script; names_output: with `set output`, for --keep. */
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
    return JLT_OK;
}

static void warn_of_letters(const jlt_plot *self)
{
    const char *title = self->look->title;
    size_t length;

    if (title == NULL || !jlt_picture_has_fonts(self->common->plot)) return;
    const char *missing = jlt_letters_missing(title, &length);
    if (missing != NULL)
        fprintf(stderr, "jellett: warning: --title: no font here has '%.*s', and the box in its place may cover the picture: "
                        "install a font, or draw .svg\n", (int)length, missing);
}

jlt_exit jlt_plot_draw(jlt_plot *self)
{
    const jlt_common *common = self->common;
    jlt_command_output whole = { 0 }, kept = { 0 };
    JLT_FREED char *picture = NULL;
    size_t size = 0;
    jlt_progress progress;
    jlt_exit code = JLT_EXIT_DONE;
    int reason = 0;
    jlt_status st = jlt_command_close(&self->script);

    if (jlt_command_close(&self->title) != JLT_OK) st = JLT_ERR_NOMEM;
    else shorten_title(self);
    if (st == JLT_OK && common->keep != NULL) {
        st = write_script(&kept, self, true);
        if (st == JLT_OK) code = jlt_command_deliver(&kept, common->keep);
    }
    if (st == JLT_OK && code == JLT_EXIT_DONE) st = write_script(&whole, self, false);
    if (st == JLT_OK && code == JLT_EXIT_DONE) st = jlt_command_close(&whole);
    if (st == JLT_OK && code == JLT_EXIT_DONE) {
        jlt_progress_start(&progress, "");
        jlt_progress_say(&progress, "the picture is being drawn");
        st = jlt_picture_draw(&picture, &size, whole.text, whole.size);
        reason = errno;
        jlt_progress_end(&progress);
    }
    if (st == JLT_ERR_UNSUPPORTED)
        code = jlt_command_fail(JLT_EXIT_IO, "--plot: no gnuplot to be found: install gnuplot to draw pictures");
    else if (st == JLT_ERR_EMPTY)
        code = jlt_command_fail(JLT_EXIT_INPUT, "--plot: nothing that could be drawn %s",
                                isnan(self->look->low[0]) && isnan(self->look->low[1]) ? "came out: is every point refused?"
                                                                                       : "lies within --xrange and --yrange");
    else if (st == JLT_ERR_IO)
        code = jlt_command_fail(JLT_EXIT_IO, "--plot: gnuplot could not draw '%s' (%s)", common->plot,
                                reason != 0 ? strerror(reason) : "what it says is above");
    else if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "--plot: %s", jlt_status_text(st));
    else if (code == JLT_EXIT_DONE) code = jlt_command_write(common->plot, picture, size);
    for (int y = 0; y < 2 && code == JLT_EXIT_DONE; y++)
        if (self->apart[y] && !self->met[y])
            fprintf(stderr, "jellett: warning: --plot: the picture is empty, as nothing lies within --%crange\n", "xy"[y]);
    if (code == JLT_EXIT_DONE) warn_of_letters(self);
    else if (!jlt_command_is_standard_output(common->output))
        fprintf(stderr, "jellett: the table is saved in %s\n", common->output);
    jlt_command_discard(&whole);
    jlt_command_discard(&kept);
    close_both(self);
    return code;
}
