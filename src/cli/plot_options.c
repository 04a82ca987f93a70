/* The options that all pictures share. */
#include "cli/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/grid.h"
#include "ext/number.h"
#include "report/letters.h"

enum { SIZE = 1200, FONT, XRANGE, YRANGE, TITLE, STYLE, AXES };

static const struct argp_option option_table[] = {
    { NULL, 0, NULL, 0, "The picture, beside --plot:", 13 },
    { "size", SIZE, "WIDTHxHEIGHT", 0,
      "Size of the picture in cm, or with mm or in after it in those units; at least 5x4cm, default 18x13cm", 13 },
    { "font", FONT, "NAME[,POINTS]", 0,
      "Font of the picture and its size; default Helvetica, in a size that grows with the width: 8 points at 8 cm, 11 at 18 "
      "cm; less where panels would be too low", 13 },
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
    if (!(look->width >= 5 && look->width <= 100 && look->height >= 4 && look->height <= 100))
        argp_error(state, "--size: '%s': the width lies between 5 and 100 cm, the height between 4 and 100", value);
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
    else if (!isfinite(look->high[axis] - look->low[axis])) argp_error(state, "%s: '%s' is too long for doubles", option, value);
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

/* A line of title, labels and key leave axes four lines at least in the height; in the width the key has room for its longest
 * entry, or, where there is no key, a bar of colours for its labels. What this program chooses is smaller. */
static void check_points(const jlt_look *look, const struct argp_state *state)
{
    enum { LINES = 14 };
    const double letters = look->no_key ? 18 : 21;
    const double most = floor(10 * fmin(look->height / LINES, look->width / letters) * 72 / 2.54) / 10;

    if (look->points > most)
        argp_error(state, "--font: letters of %g points leave no room for axes in %gx%gcm: %g points at most, or another --size",
                   look->points, look->width, look->height, most);
}

/* The axes have no room any more where a title takes half of the height. */
static void check_title(const jlt_look *look, const struct argp_state *state)
{
    const unsigned lines = look->title == NULL ? 0 : jlt_look_lines(NULL, look, look->title, false);

    if (1.2 * lines * jlt_look_points(look) > look->height * 72 / 2.54 / 2)
        argp_error(state, "--title: %u lines are more than half of the height: shorten it, or choose another --size or --font",
                   lines);
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
        if (!jlt_letters_fit(value))
            argp_error(state, "--title: this is no text in UTF-8, or there are control characters in it");
        look->title = value;
        break;
    case STYLE: parse_style(look, value, state); break;
    case ARGP_KEY_END:
        check_points(look, state);
        check_title(look, state);
        return 0;
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
