#include "cli/motion.h"

#include <stdlib.h>
#include <string.h>

#include "base/options.h"
#include "cli/interrupt.h"
#include "dynamics/scale.h"

enum { SECTION = 1100, SOLVE, MODULO, MIRROR, CONTACT, AT, MAX_STEPS };

static const struct argp_option option_table[] = {
    { "level", 'l', "LEVEL=VALUE,...", TTC_OPTIONS_REPEATED,
      "Values of integrals. On a section that tables describe, integrals not named here have the defaults of its tables. "
      "With --section STATE=VALUE: integrals that the table claims; --solve says which states they determine", 10 },
    { "section", SECTION, "STATE=VALUE|NAME", 0,
      "STATE=VALUE: the section where this state has this value; its coordinates are the other states. NAME: a section that "
      "the table describes, with coordinates of its own", 10 },
    { "solve", SOLVE, "STATE=GUESS,...", 0,
      "With --section and --level: the states that the levels determine, as many as there are levels, each with the guess "
      "from which Newton's method begins. The other states are the section's coordinates. Starts lie on the branch of "
      "solutions that the guess leads to; a return on another branch has its row, but no derivative", 10 },
    { "modulo", MODULO, "STATE=PERIOD,...", 0,
      "With --section: states that are angles, such as phi=2*pi, in addition to those that the table proves by 'periodic'; "
      "PERIOD 0 makes a state no angle. An angle is shown within half a period of 0, and points that differ by periods are "
      "the same. A section STATE=VALUE of an angle is crossed once a turn; if STATE is the phase of a forcing, once a "
      "period of the forcing", 10 },
    { "mirror", MIRROR, "STATE,...", 0,
      "With --section: the states whose signs a reversor changes, in place of the reversor that the table proves; an empty "
      "list for none", 10 },
    { "@level", AT, "LEVEL=VALUE,...", OPTION_HIDDEN, NULL, 10 },
    { "direction", 'd', "up|down|both", 0,
      "Which crossings count: those where the section's state rises (up, the default), falls (down), or both", 11 },
    { "max-steps", MAX_STEPS, "N", 0,
      "The most steps of the integrator for one return; default 100000, and 20000 for continue, orbits and charts of lyapunov. "
      "An orbit that needs more ends there", 11 },
    { 0 },
};

static const struct argp_option contact_table[] = {
    { "contact", CONTACT, "ignore|report|end", 0,
      "What to do with an orbit where a condition of the model breaks (`valid` in its table; for the spherical top, "
      "contact: the plane would have to pull). ignore (default): follow it, and report at the end how many orbits there "
      "were. report: also write a column with the condition's least value, to a millionth of it; beside a pole of the "
      "condition, a value that it falls below. end: end the orbit there, as lost_NAME", 11 },
    { 0 },
};

static void parse_direction(jlt_motion_options *o, const char *value, struct argp_state *state)
{
    if (strcmp(value, "up") == 0) o->flow.direction = JLT_RISING;
    else if (strcmp(value, "down") == 0) o->flow.direction = JLT_FALLING;
    else if (strcmp(value, "both") == 0) o->flow.direction = JLT_BOTH;
    else argp_error(state, "--direction is up, down or both, not '%s'", value);
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_motion_options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->common;
        state->child_inputs[1] = &o->accuracy;
        return 0;
    case 'l': jlt_common_list(&o->level, value, "--level"); return 0;
    case AT:
        o->common.at_point = true;
        jlt_common_replace(&o->level, value);
        return 0;
    case ARGP_KEY_END: jlt_common_not_swept(&o->common, &o->level, "--level"); return 0;
    case SECTION: o->section = value; return 0;
    case SOLVE: o->solve = value; return 0;
    case MODULO: o->modulo = value; return 0;
    case MIRROR: o->mirror = value; return 0;
    case 'd': parse_direction(o, value, state); return 0;
    case MAX_STEPS: jlt_common_count(&o->flow.max_steps, value, 1, 1000000000000, "--max-steps"); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse_contact(int key, char *value, struct argp_state *state)
{
    jlt_motion_options *o = state->input;

    if (key != CONTACT) return ARGP_ERR_UNKNOWN;
    if (strcmp(value, "ignore") != 0 && strcmp(value, "report") != 0 && strcmp(value, "end") != 0)
        argp_error(state, "--contact is ignore, report or end, not '%s'", value);
    o->contact = value;
    o->flow.end_where_invalid = strcmp(value, "end") == 0;
    o->flow.seeks_least = strcmp(value, "report") == 0;
    return 0;
}

static const struct argp_child children[] = { { &jlt_common_argp, 0, NULL, 0 }, { &jlt_accuracy_argp, 0, NULL, 0 }, { 0 } };
static const struct argp_child of_certificate[] = { { &jlt_common_certificate_argp, 0, NULL, 0 },
                                                    { &jlt_accuracy_argp, 0, NULL, 0 }, { 0 } };

const struct argp jlt_motion_argp = { option_table, parse, NULL, NULL, children, NULL, NULL };
const struct argp jlt_motion_certificate_argp = { option_table, parse, NULL, NULL, of_certificate, NULL, NULL };
const struct argp jlt_contact_argp = { contact_table, parse_contact, NULL, NULL, NULL, NULL, NULL };

void jlt_motion_begin(jlt_motion_options *options, int argc, char **argv)
{
    *options = (jlt_motion_options){ .contact = "ignore" };
    options->flow.direction = JLT_RISING;
    options->flow.tolerance = 1e-12;
    options->flow.method = jlt_method_find(NULL);
    options->flow.interrupt = jlt_interrupt_install();
    options->accuracy = (jlt_accuracy){ &options->flow.tolerance, &options->flow.method };
    options->starts = calloc((size_t)argc + 1, sizeof *options->starts);
    if (options->starts == NULL) exit((int)jlt_command_no_memory());
    jlt_common_begin(&options->common, argc, argv);
}

void jlt_motion_end(void *place)
{
    jlt_motion_options *options = place;

    jlt_common_end(&options->common);
    jlt_assign_clear(&options->level);
    free(options->starts);
}

bool jlt_motion_interrupted(const jlt_motion_options *options)
{
    return options->flow.interrupt != NULL && *options->flow.interrupt;
}

/* The interval of a coordinate in which the section can have points. Returns false if it is not known. */
static bool interval(const jlt_system *system, unsigned coordinate, double *low, double *high)
{
    return system->surface != NULL && jlt_surface_interval(system, coordinate, low, high);
}

static unsigned coordinate(const jlt_chart *chart, const char *name)
{
    unsigned k = 0;

    while (k < chart->dim && strcmp(chart->names[k], name) != 0) k++;
    return k;
}

jlt_exit jlt_motion_no_coordinate(const jlt_chart *chart, const char *option, const char *name, size_t length)
{
    fprintf(stderr, "jellett: %s: the section has no coordinate '%.*s'; it has", option, (int)length, name);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(stderr, "%s %s", k == 0 ? "" : ",", chart->names[k]);
    fputc('\n', stderr);
    return JLT_EXIT_INPUT;
}

/* The start that the section's tables call so; NULL: none. */
static const jlt_section_point *named_start(const jlt_system *system, const char *name)
{
    const jlt_section_chart *section = system->surface != NULL ? system->surface->section : NULL;

    for (unsigned i = 0; section != NULL && i < section->start_count; i++)
        if (strcmp(section->starts[i].name, name) == 0) return &section->starts[i];
    return NULL;
}

static jlt_exit no_start(const jlt_system *system, const char *text)
{
    const jlt_section_chart *section = system->surface != NULL ? system->surface->section : NULL;

    fprintf(stderr, "jellett: --start: '%s' is no start (write NAME=VALUE,...", text);
    for (unsigned i = 0; section != NULL && i < section->start_count; i++)
        fprintf(stderr, "%s%s", i == 0 ? " or one of " : ", ", section->starts[i].name);
    fputs(")\n", stderr);
    return JLT_EXIT_USAGE;
}

/* Refuse a start outside the domain, by the interval or condition that fails, also where something divides by zero. On a section
 * that tables describe, by an interval of its coordinates. */
static jlt_exit refuse_outside(const jlt_system *system, const char *start, const double *q)
{
    const jlt_region *region = NULL;
    const jlt_descriptor *d = system->instance->descriptor;
    const jlt_chart *chart = &system->chart.plane; /* in the table's units */
    double x[JLT_CHART_STATES_MAX], value;
    size_t index;

    if (system->surface != NULL) return jlt_motion_refuse_point(system->surface, q, start);
    const jlt_status st = chart->lift(chart, x, NULL, q);
    if (st != JLT_OK && st != JLT_ERR_DOMAIN) return JLT_EXIT_DONE;
    if (jlt_descriptor_check_state(d, x, &index) == JLT_ERR_DOMAIN) return jlt_assign_refuse_interval(start, &d->states[index]);
    return jlt_region_check(&region, &value, d, system->instance->params, x) == JLT_ERR_DOMAIN
               ? jlt_assign_refuse_region(start, d, region, value) : JLT_EXIT_DONE;
}

jlt_exit jlt_motion_start(double *q, const jlt_system *system, const char *text)
{
    const jlt_chart *chart = system->flow.chart;
    const jlt_section_point *named = named_start(system, text);
    jlt_grid_axis axes[JLT_CHART_DIM_MAX + 1];
    bool given[JLT_CHART_DIM_MAX] = { false };
    size_t count = 0;
    jlt_exit code = named != NULL ? JLT_EXIT_DONE : strchr(text, '=') == NULL || strchr(text, ':') != NULL
                        ? no_start(system, text)
                        : jlt_grid_parse(axes, &count, JLT_CHART_DIM_MAX + 1, text, "--start");

    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++) {
        const unsigned k = coordinate(chart, axes[i].name);
        if (k == chart->dim)
            return jlt_motion_no_coordinate(chart, "--start", axes[i].name, strlen(axes[i].name));
        q[k] = axes[i].low;
        given[k] = true;
    }
    for (unsigned k = 0; named != NULL && k < chart->dim; k++) q[k] = named->point[k];
    for (unsigned k = 0; named == NULL && code == JLT_EXIT_DONE && k < chart->dim; k++)
        if (!given[k]) code = jlt_command_fail(JLT_EXIT_INPUT, "--start: give %s as well", chart->names[k]);
    return code == JLT_EXIT_DONE ? refuse_outside(system, text, q) : code;
}

/* The --direction in which the orbit crosses the section at a start, if that is not the one that counts; else NULL. */
static const char *other_direction(const jlt_system *system, const char *start)
{
    const jlt_chart *chart = system->flow.chart;
    double q[JLT_CHART_DIM_MAX], x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX];

    if (jlt_motion_start(q, system, start) != JLT_EXIT_DONE || chart->lift(chart, x, NULL, q) != JLT_OK) return NULL;
    system->instance->descriptor->rhs.call(x, system->instance->prepared, f);
    if (!(f[chart->column] * (int)system->flow.direction < 0)) return NULL;
    return system->flow.direction == JLT_RISING ? "down" : "up";
}

jlt_exit jlt_motion_no_orbit(jlt_status status, const jlt_system *system, const char *start)
{
    if (status != JLT_ERR_NO_CONVERGENCE || (system->flow.interrupt != NULL && *system->flow.interrupt))
        return jlt_motion_fail(status, system, start);
    const char *other = other_direction(system, start);
    if (other != NULL)
        return jlt_command_fail(JLT_EXIT_NUMERICAL,
                                "Newton's method finds no periodic orbit from %s, where the section is crossed the other way: "
                                "try --direction %s, or another --start", start, other);
    return jlt_command_fail(JLT_EXIT_NUMERICAL,
                            "Newton's method finds no periodic orbit from %s%s: try another --start or --period", start,
                            system->flow.chart->solved_count > 0 ? ", or a return left the branch of --solve" : "");
}

jlt_exit jlt_motion_check_starts(const jlt_system *system, const char *const *starts, size_t count)
{
    jlt_section *section = NULL;
    double q[JLT_CHART_DIM_MAX];
    jlt_status st = jlt_section_create(&section, &system->flow);
    jlt_exit code = st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "section");

    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++) {
        code = jlt_motion_start(q, system, starts[i]);
        if (code == JLT_EXIT_DONE) st = jlt_section_start(section, NULL, q, 1);
        if (code == JLT_EXIT_DONE && st != JLT_OK) code = jlt_motion_fail(st, system, starts[i]);
    }
    jlt_section_destroy(section);
    return code;
}

void jlt_motion_typed(const char *grid, const char *option)
{
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    size_t count;
    const jlt_exit code = jlt_grid_read(axes, &count, JLT_CHART_DIM_MAX, grid, option);

    if (code != JLT_EXIT_DONE) exit((int)code);
}

jlt_exit jlt_motion_axes(jlt_grid_axis *axes, const jlt_system *system, const char *text, const char *option)
{
    const jlt_chart *chart = system->flow.chart;
    size_t count = chart->dim;
    bool runs[JLT_CHART_DIM_MAX]; /* its default range is known */

    for (unsigned k = 0; k < chart->dim; k++) {
        axes[k] = (jlt_grid_axis){ .low = -1, .high = 1, .count = 1 };
        snprintf(axes[k].name, sizeof axes[k].name, "%s", chart->names[k]);
        if (chart->period[k] != 0) axes[k].low = -chart->period[k] / 2, axes[k].high = chart->period[k] / 2;
    }
    for (unsigned k = 0; k < chart->dim; k++) {
        double low, high;
        runs[k] = chart->period[k] != 0 || interval(system, k, &low, &high);
        if (!runs[k] || chart->period[k] != 0) continue;
        /* stay 1/200 of the interval off its ends, where an angle beside this coordinate may be undefined */
        axes[k].low = low + (high - low) / 200;
        axes[k].high = high - (high - low) / 200;
    }
    jlt_exit code = text != NULL ? jlt_grid_parse(axes, &count, chart->dim, text, option) : JLT_EXIT_DONE;
    const bool named = text != NULL && strchr(text, '=') != NULL;
    if (code == JLT_EXIT_DONE) code = jlt_grid_size(&(size_t){ 0 }, axes, chart->dim, text, option);
    for (unsigned k = 0; code == JLT_EXIT_DONE && k < chart->dim; k++)
        if (axes[k].low_text == NULL && (named || (text != NULL && !runs[k])))
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: %s has no range: add %s=LOW:HIGH:COUNT, or %s=VALUE", option,
                                    chart->names[k], chart->names[k], chart->names[k]);
    return code;
}

jlt_exit jlt_motion_cells(jlt_grid_axis *axes, const jlt_system *system, const char *text, const char *option)
{
    const jlt_chart *chart = system->flow.chart;
    jlt_exit code = jlt_motion_axes(axes, system, text, option);

    if (code == JLT_EXIT_DONE) code = jlt_grid_whole(axes, option);
    for (unsigned k = 0; code == JLT_EXIT_DONE && k < chart->dim; k++) {
        const double period = chart->period[k];
        if (axes[k].low_text == NULL && period == 0) (void)interval(system, k, &axes[k].low, &axes[k].high);
        const double low = fmin(axes[k].low, axes[k].high), high = fmax(axes[k].low, axes[k].high);
        axes[k].low = low;
        axes[k].high = high;
        if (!(high > low))
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: %s has no width (write %s=LOW:HIGH:COUNT)", option, chart->names[k],
                                    chart->names[k]);
        if (period != 0 && high - low > period * (1 + 1e-12))
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: the range of the angle %s is longer than its period, %.10g: shorten it",
                                    option, chart->names[k], period);
    }
    return code;
}

size_t jlt_motion_grid_size(const jlt_grid_axis *axes, const jlt_system *system)
{
    size_t all = 1;

    for (unsigned k = 0; k < system->flow.chart->dim; k++) all *= axes[k].count;
    return axes[0].part > 0 ? axes[0].part : all;
}

void jlt_motion_grid_point(double *q, const jlt_grid_axis *axes, const jlt_system *system, size_t index)
{
    index += axes[0].first;
    for (unsigned k = 0; k < system->flow.chart->dim; k++) {
        q[k] = jlt_grid_value(&axes[k], index % axes[k].count, system->flow.chart->period[k]);
        index /= axes[k].count;
    }
}

jlt_exit jlt_motion_check_grid(const jlt_grid_axis *axes, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    const size_t count = jlt_motion_grid_size(axes, system);
    double q[JLT_CHART_DIM_MAX], x[JLT_CHART_STATES_MAX];

    if (axes[0].part != 0 || count == 0) return JLT_EXIT_DONE;
    for (size_t i = 0; i < count; i++) {
        jlt_motion_grid_point(q, axes, system, i);
        if (chart->lift(chart, x, NULL, q) != JLT_ERR_EMPTY) return JLT_EXIT_DONE;
    }
    return jlt_motion_fail(JLT_ERR_EMPTY, system, "--grid");
}

jlt_exit jlt_motion_scale(jlt_system *system, const double *q, const jlt_grid_axis *axes)
{
    enum { STARTS = 32 }; /* the most points of a grid to look at */
    const unsigned dim = system->flow.chart->dim;
    const size_t all = axes != NULL ? jlt_motion_grid_size(axes, system) : 1, count = all < STARTS ? all : STARTS;
    double starts[STARTS * JLT_CHART_DIM_MAX], extents[JLT_CHART_DIM_MAX];
    jlt_status st;

    for (size_t i = 0; axes != NULL && i < count; i++)
        jlt_motion_grid_point(starts + i * dim, axes, system, (2 * i + 1) * all / (2 * count));
    for (unsigned k = 0; axes != NULL && k < dim; k++) extents[k] = axes[k].count > 1 ? (axes[k].high - axes[k].low) / 2 : 0;
    st = axes != NULL ? jlt_scale_find(system, starts, count, extents) : jlt_scale_find(system, q, 1, NULL);
    /* near an unstable equilibrium all moves are small, but an angle counts in radians */
    if (st == JLT_OK && axes == NULL) st = jlt_scale_for_tangents(system, q);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "the map");
}

void jlt_motion_one_start(jlt_motion_options *options, const char *text)
{
    options->starts[0] = text;
    options->start_count = 1;
}

jlt_exit jlt_motion_any_start(double *q, const jlt_motion_options *options, const jlt_grid_axis *axes, const jlt_system *system,
                              size_t index)
{
    if (index < options->start_count) return jlt_motion_start(q, system, options->starts[index]);
    jlt_motion_grid_point(q, axes, system, index - options->start_count);
    return JLT_EXIT_DONE;
}
