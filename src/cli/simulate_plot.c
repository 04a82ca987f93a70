/* Draws the orbit of `jellett simulate`: columns against time, track and attitude, or two columns against each other. */
#include "cli/simulate.h"

#include <math.h>
#include <string.h>

#include "core/memory.h"
#include "report/symbol.h"

/* POINTS bounds the rows of a picture, so that neither memory nor gnuplot's time grows with those of the table. */
enum { PANELS_MAX = JLT_PLAN_STATES_MAX, POINTS = 100000 };

/* The first column of each kind: t, states, drifts, what the table observes, and with --track what the larger table adds. */
static unsigned first_drift(const jlt_simulate_request *r)
{
    return 1 + r->session.descriptor->state_count;
}

static unsigned first_observed(const jlt_simulate_request *r)
{
    return first_drift(r) + jlt_course_integrals(r->courses[0]);
}

static unsigned first_of_more(const jlt_simulate_request *r)
{
    return first_observed(r) + jlt_course_observes(r->courses[0], NULL);
}

static double value_of(const jlt_simulate_request *r, const jlt_course_row *row, unsigned column)
{
    const unsigned drift = first_drift(r), observed = first_observed(r), more = first_of_more(r);

    if (column == 0) return row->t;
    if (column < drift) return row->x[column - 1];
    if (column < observed) return jlt_plot_drift(row->drift[column - drift]);
    return column < more ? row->observed[column - observed] : row->more[column - more];
}

static unsigned columns(const jlt_simulate_request *r)
{
    return first_of_more(r) + jlt_course_tells_more(r->courses[0], NULL, NULL);
}

static void open_points(jlt_simulate_request *r)
{
    r->extents = malloc(columns(r) * sizeof *r->extents);
    r->points = malloc((POINTS + 1) * columns(r) * sizeof *r->points);
    r->spacing = 1;
    for (unsigned k = 0; r->extents != NULL && k < columns(r); k++) r->extents[k] = JLT_EXTENT_NONE;
}

void jlt_simulate_point(jlt_simulate_request *request, const jlt_course_row *row, bool ends)
{
    const unsigned count = columns(request);

    if (request->extents == NULL) open_points(request);
    if (request->extents == NULL || request->points == NULL) return;
    double *const points = request->points;
    if (request->held == POINTS && !ends) {
        for (size_t i = 0; i < POINTS / 2; i++) memmove(points + i * count, points + 2 * i * count, count * sizeof *points);
        request->held = POINTS / 2;
        request->spacing *= 2;
    }
    if (request->rows % request->spacing != 0 && !ends) return;
    for (unsigned k = 0; k < count; k++) {
        points[request->held * count + k] = value_of(request, row, k);
        jlt_extent_add(&request->extents[k], points[request->held * count + k]);
    }
    request->held++;
}

static void write_points(FILE *stream, const jlt_simulate_request *r)
{
    fputs("$ROWS << END\n", stream);
    for (size_t i = 0; i < r->held; i++) jlt_look_row(stream, r->points + i * columns(r), columns(r));
    fputs("END\n", stream);
}

static void caption(jlt_plot *plot, const jlt_simulate_request *r)
{
    const jlt_descriptor *d = r->session.descriptor;

    jlt_plot_words(plot, "Motion of %s\n", d->model);
    jlt_session_caption(plot, &r->session);
    jlt_plot_words(plot, d->param_count > 0 ? "; start " : "start ");
    for (unsigned i = 0; i < d->state_count; i++) jlt_plot_value(plot, d->states[i].name, r->session.x[i]);
    jlt_plot_words(plot, "; tier %s, ", jlt_plan_tier(&r->plans[0]));
    jlt_plot_value(plot, "tolerance", r->session.tolerance);
    if (r->spacing > 1) jlt_plot_words(plot, "; one row in %zu", r->spacing);
}

/* Write one curve of `plot`: a column against t, of which a single row is a point. series: the number of the curve in its panel. */
static void curve(jlt_plot *plot, const jlt_simulate_request *r, unsigned column, unsigned series, const char *name)
{
    jlt_pen pen = { "lines", .colour = series, .dash = series };

    if (r->extents[0].low == r->extents[0].high) pen = (jlt_pen){ "points", .colour = series, .mark = series, .size = 0.8 };
    fprintf(plot->stream, "%s$ROWS using 1:%u ", series == 0 ? "plot " : ", ", column);
    jlt_look_pen(plot->stream, plot->look, pen);
    fputs(" title '", plot->stream);
    jlt_symbol_write(plot->stream, name);
    fputc('\'', plot->stream);
}

/* Leave room for the keys of all panels, which name the states and the integrals; see jlt_plot_beside. */
static double room_beside(jlt_plot *plot, const jlt_simulate_request *r)
{
    const jlt_descriptor *d = r->session.descriptor;
    const unsigned drifts = jlt_course_integrals(r->courses[0]);
    char label[JLT_LOOK_LABEL_MAX];
    double width = 0;

    for (unsigned i = 0; i < d->state_count + drifts; i++) {
        jlt_look_label(label, i < d->state_count ? d->states[i].name : jlt_course_integral(r->courses[0], i - d->state_count), "");
        width = fmax(width, jlt_look_breadth(label));
    }
    return jlt_plot_beside(plot, width);
}

/* Place the key beside a panel, one of `panels`; in a low panel its lines are closer together, or even smaller. narrow: the factor
 * of room_beside. */
static void key(jlt_plot *plot, unsigned entries, unsigned panels, double narrow)
{
    const double letter = jlt_look_points(plot->look), height = 0.6 * plot->look->height * 72 / 2.54 / panels / letter;
    const double spacing = fmin(1, height / 1.8 / entries), size = fmin(1, fmax(0.7, spacing / 0.85));
    char where[160];

    /* at a point: "outside" would place it by the width of its texts, which gnuplot only guesses */
    snprintf(where, sizeof where,
             "at graph 1,graph 0.5 left center horizontal maxcols 1 Left reverse samplen 1.5 spacing %.2f font ',%.3g'",
             fmax(0.85, spacing), letter * fmin(size, narrow));
    jlt_look_key(plot->stream, plot->look, where);
}

/* The units of the states, one for each panel. Returns how many there are. */
static unsigned list_units(const char *units[PANELS_MAX], const jlt_descriptor *d)
{
    unsigned panels = 0;

    for (unsigned i = 0; i < d->state_count; i++) {
        unsigned k = 0;
        while (k < panels && strcmp(units[k], d->states[i].unit) != 0) k++;
        if (k == panels) units[panels++] = d->states[i].unit;
    }
    return panels;
}

/* Draw states against t, those of the same unit in one panel, and drifts, if any has a value, in another. */
static void draw_states(jlt_plot *plot, const jlt_simulate_request *r)
{
    const jlt_descriptor *d = r->session.descriptor;
    const char *units[PANELS_MAX], *const time = jlt_plot_timed(d, "t [s]", "t");
    const unsigned drifts = jlt_course_integrals(r->courses[0]), panels = list_units(units, d);
    jlt_extent drift = JLT_EXTENT_NONE;

    for (unsigned i = 0; i < drifts; i++) {
        jlt_extent_add(&drift, r->extents[first_drift(r) + i].low);
        jlt_extent_add(&drift, r->extents[first_drift(r) + i].high);
    }
    const bool drifting = drift.low <= drift.high;
    jlt_plot_panels(plot, panels + drifting, true);
    const double narrow = room_beside(plot, r);
    for (unsigned k = 0; k < panels; k++) {
        unsigned series = 0, entries = 0;
        jlt_extent range = JLT_EXTENT_NONE;
        char label[JLT_LOOK_LABEL_MAX];
        jlt_look_label(label, "", units[k]);
        for (unsigned i = 0; i < d->state_count; i++) {
            if (strcmp(units[k], d->states[i].unit) != 0) continue;
            jlt_extent_add(&range, r->extents[1 + i].low);
            jlt_extent_add(&range, r->extents[1 + i].high);
            entries++;
        }
        key(plot, entries, panels + drifting, narrow);
        jlt_plot_panel(plot, k, time, r->extents[0]);
        jlt_plot_axis(plot, 'y', label, jlt_extent_wider(range), 0);
        for (unsigned i = 0; i < d->state_count; i++)
            if (strcmp(units[k], d->states[i].unit) == 0) curve(plot, r, i + 2, series++, d->states[i].name);
        fputc('\n', plot->stream);
    }
    if (!drifting) return;
    key(plot, drifts, panels + 1, narrow);
    jlt_plot_panel(plot, panels, time, r->extents[0]);
    fputs("unset label\n", plot->stream);
    const bool has_room = jlt_plot_height(plot) > 7 * plot->rows; /* the longer label is six and a half high */
    const char *const label = drift.low > jlt_plot_drift(0) || !has_room ? "drift" : "drift ≥ 10^{−17}";
    jlt_plot_log(plot, 'y', label, (jlt_extent){ drift.low / 1.01, drift.high * 1.01 }, 10);
    for (unsigned i = 0; i < drifts; i++) curve(plot, r, first_drift(r) + 1 + i, i, jlt_course_integral(r->courses[0], i));
    fputc('\n', plot->stream);
}

static void curve_in_plane(jlt_plot *plot, unsigned x, unsigned y)
{
    fprintf(plot->stream, "$ROWS using %u:%u ", x, y);
    jlt_look_pen(plot->stream, plot->look, (jlt_pen){ "lines", .size = 0.1 });
    fprintf(plot->stream, " notitle, $ROWS using %u:%u every ::0::0 ", x, y);
    jlt_look_pen(plot->stream, plot->look, (jlt_pen){ "points", .colour = 1, .size = 0.8 });
    fputs(" title 'start'\n", plot->stream);
}

/* The quantity in a column that is not a drift: t, a state, or what one of the tables observes. */
static jlt_quantity quantity_of(const jlt_simulate_request *r, unsigned column)
{
    const jlt_quantity *observed, *more;

    jlt_course_observes(r->courses[0], &observed);
    jlt_course_tells_more(r->courses[0], &more, NULL);
    if (column == 0) return (jlt_quantity){ .name = "t", .unit = jlt_plot_timed(r->session.descriptor, "s", "") };
    if (column < first_drift(r)) return r->session.descriptor->states[column - 1];
    return column < first_of_more(r) ? observed[column - first_observed(r)] : more[column - first_of_more(r)];
}

static bool has_values(const jlt_simulate_request *r, unsigned column) { return r->extents[column].low <= r->extents[column].high; }

/* Draw one column against another. to_scale: both axes have the same scale and length. The axis of a column without values is left
 * to gnuplot. */
static void draw_pair(jlt_plot *plot, const jlt_simulate_request *r, const unsigned columns[2], bool to_scale)
{
    double length = 0;
    char label[JLT_LOOK_LABEL_MAX];

    for (unsigned k = 0; to_scale && k < 2; k++) length = fmax(length, r->extents[columns[k]].high - r->extents[columns[k]].low);
    for (unsigned k = 0; k < 2; k++) {
        const jlt_quantity shown = quantity_of(r, columns[k]);
        jlt_extent range = r->extents[columns[k]];
        const double missing = fmax(0, length - (range.high - range.low));
        if (has_values(r, columns[k])) range = (jlt_extent){ range.low - missing / 2, range.high + missing / 2 };
        jlt_look_label(label, shown.name, shown.unit);
        jlt_plot_axis(plot, k == 0 ? 'x' : 'y', label, jlt_extent_wider(range), 0);
    }
    fputs("plot ", plot->stream);
    curve_in_plane(plot, columns[0] + 1, columns[1] + 1);
}

/* Draw what the larger table observes: its first and second quantity against each other, and its third and fourth, each pair only
 * if both have values; else its first quantity with values against t; else the states. */
static void draw_more(jlt_plot *plot, const jlt_simulate_request *r)
{
    unsigned states, pairs[2], count = 0, k = 0;
    const unsigned observed = jlt_course_tells_more(r->courses[0], NULL, &states) - states, first = first_of_more(r) + states;

    for (unsigned i = first; i + 1 < first + observed && i < first + 4; i += 2)
        if (has_values(r, i) && has_values(r, i + 1)) pairs[count++] = i;
    while (k < observed && !has_values(r, first + k)) k++;
    if (k == observed) {
        draw_states(plot, r);
        return;
    }
    jlt_plot_panels(plot, count < 2 ? 1 : 2, false);
    if (count == 0) draw_pair(plot, r, (unsigned[]){ 0, first + k }, false);
    else jlt_plot_to_scale(plot);
    for (unsigned i = 0; i < count; i++) draw_pair(plot, r, (unsigned[]){ pairs[i], pairs[i] + 1 }, true);
}

/* --axes may name all columns except drifts. */
jlt_exit jlt_simulate_axes(jlt_simulate_request *request)
{
    const unsigned drift = first_drift(request), drifts = first_observed(request) - drift;
    const char *units[PANELS_MAX];
    const unsigned count = first_of_more(request) - drifts + jlt_course_tells_more(request->courses[0], NULL, NULL);
    JLT_FREED const char **names = calloc(count, sizeof *names);

    if (names == NULL) return jlt_command_no_memory();
    if (request->session.common.axes == NULL && !request->track)
        JLT_PASS(jlt_plot_check_stack(&request->session.common, list_units(units, request->session.descriptor) + (drifts > 0)));
    for (unsigned i = 0; i < count; i++) names[i] = quantity_of(request, i < drift ? i : i + drifts).name;
    JLT_PASS(jlt_plot_shown(request->shown, &request->session.common, names, count));
    for (unsigned k = 0; k < 2; k++)
        if (request->shown[k] >= drift) request->shown[k] += drifts;
    return JLT_EXIT_DONE;
}

static jlt_exit check_shown(const jlt_simulate_request *r)
{
    for (unsigned k = 0; r->session.common.axes != NULL && k < 2; k++)
        if (!has_values(r, r->shown[k]))
            return jlt_command_fail(JLT_EXIT_INPUT, "--axes: %s has no value in any row: nothing is drawn",
                                    quantity_of(r, r->shown[k]).name);
    return JLT_EXIT_DONE;
}

jlt_exit jlt_simulate_draw(const jlt_simulate_request *request)
{
    jlt_plot plot;

    JLT_PASS(request->extents == NULL || request->points == NULL ? jlt_command_no_memory() : check_shown(request));
    if (jlt_plot_open(&plot, &request->session.common) != JLT_OK) return jlt_command_no_memory();
    fputs(JLT_LOOK_GRID, plot.stream);
    write_points(plot.stream, request);
    caption(&plot, request);
    if (request->session.common.axes != NULL) draw_pair(&plot, request, request->shown, false);
    else if (request->track) draw_more(&plot, request);
    else draw_states(&plot, request);
    return jlt_plot_draw(&plot);
}
