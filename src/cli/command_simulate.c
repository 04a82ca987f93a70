/* `jellett simulate`: one orbit at given times, with drifts of integrals and observed quantities. */
#include "base/options.h"
#include "base/text.h"
#include "cli/simulate.h"

#include <math.h>
#include <string.h>

#include "cli/planned.h"
#include "cli/progress.h"
#include "cli/swept.h"
#include "core/memory.h"
#include "dynamics/section.h"
#include "kernel/descriptor.h"
#include "report/csv.h"

enum { TIMES = 2000, UNTIL, EVERY, TIER, COMPARE, TRACK, PROJECT };

static const struct argp_option option_table[] = {
    { "times", TIMES, "T,T,...", 0, "Rows at these times, in the table's unit: in order, of one sign; t = 0 is the start", 1 },
    { "until", UNTIL, "T", 0, "Rows from t = 0 to T, in the table's unit of time; a negative T goes backwards in time", 1 },
    { "every", EVERY, "DT", 0, "With --until: the time between rows; default a hundredth of T", 1 },
    { "tier", TIER, "TIER", 0, "Integrate this tier; default: the smallest that can answer (see jellett plan simulate ...)", 1 },
    { "compare", COMPARE, "TIER,...", 0, "Follow the orbit in these tiers too; each has a column of its largest difference", 1 },
    { "track", TRACK, NULL, 0, "Integrate a larger table, whose further states, such as attitude and track, get columns", 1 },
    { "project", PROJECT, NULL, 0, "After every step, put the orbit back onto the levels of all integrals at the start", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_session_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_simulate_request *r = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case TIMES: r->times_text = value; return 0;
    case UNTIL: jlt_common_number(&r->until, r->until_text = value, "--until"); return 0;
    case EVERY: jlt_common_positive(&r->every, r->every_text = value, "--every"); return 0;
    case TIER: r->tier = value; return 0;
    case COMPARE: r->compare = value; return 0;
    case TRACK: r->track = true; return 0;
    case PROJECT: r->project = true; return 0;
    case ARGP_KEY_END:
        if (r->times_text == NULL && isnan(r->until))
            jlt_common_incomplete(&r->session.common, state, "say when: --times, or --until with --every");
        if (r->times_text != NULL && !isnan(r->until)) argp_error(state, "--times and --until exclude each other");
        if (isnan(r->until) && !isnan(r->every)) argp_error(state, "--every goes with --until");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Integrate one orbit: its states at given times, drifts of integrals, observed quantities, and what ends it."
    "\vColumns:\n"
    "  t, STATE          time, and each state of the model\n"
    "  drift_NAME        drift of each integral F: |F - F(start)| over its size\n"
    "  QUANTITY          each quantity that the table observes; with --track also\n"
    "                    the larger table's other states and quantities, empty\n"
    "                    where another tier has taken over\n"
    "  difference_TIER   one for each tier of --compare\n"
    "  fate              whether the orbit goes on (below)\n\n"
    "The size of F is |F(start)|, or, where that is smaller, the least of 1 and of the amount by which F changes, to first "
    "order, when every state changes by as much as the largest state is, in units of the problem.\n\n"
    "Fates:\n"
    "  alive             the orbit goes on, and the model holds\n"
    "  lost_NAME         a condition of the model has been broken since the start;\n"
    "                    lost_contact: the plane would have had to pull the top\n"
    "  unknown_NAME      this condition has had no value, and none has been broken\n"
    "  pole+, pole-      the orbit ends there, and this row has the limits\n"
    "  left_domain       the tier's coordinates end before the orbit does; status 4\n"
    "  budget, nonfinite, no_convergence, no_progress: the method failed; status 4\n\n"
    "After the last three kinds there are no more rows. A field is a number, or empty where its value is not known or has no "
    "limit.\n\n"
    "Examples:\n"
    "  jellett simulate \\\n"
    "    --start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3 \\\n"
    "    --times 0,0.5,1\n"
    "  jellett simulate --set I3=0 \\\n"
    "    --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1.3,omega3=-0.8 \\\n"
    "    --until 10 --every 1/10 --compare five --plot rod.svg",
    children, NULL, NULL,
};

/* ---- the courses: the orbit asked for, then those of --compare ---- */

static jlt_exit open_course(jlt_simulate_request *r, const char *tier)
{
    const jlt_session *s = &r->session;
    const jlt_question question = { s->descriptor, s->params, s->x, r->track && r->course_count == 0, false, tier, &s->others };
    const jlt_course_options options = { .method = s->method, .tolerance = s->tolerance, .interrupt = s->interrupt,
                                         .t_last = r->times.last, .project = r->project && r->course_count == 0 };
    jlt_plan *plan = &r->plans[r->course_count];
    jlt_status st;

    st = jlt_plan_make(plan, &question);
    if (st == JLT_ERR_ARG || st == JLT_ERR_UNSUPPORTED) return jlt_planned_refuse(plan, &question, st, s->common.plan);
    if (st == JLT_OK && options.project) {
        const jlt_descriptor *field = plan->candidates[plan->chosen].descriptor;
        if (field == NULL) return jlt_command_fail(JLT_EXIT_USAGE, "--project: the tier %s takes no steps: leave out --project, or "
                                                   "take a --tier that does ('jellett plan simulate' lists them)",
                                                   jlt_plan_tier(plan));
        JLT_PASS(plan->candidates[plan->chosen].tier.way_count > 0 ? jlt_common_proved(field) : jlt_common_project(field));
        JLT_PASS(jlt_common_one_step(s->method));
    }
    if (st == JLT_OK) st = jlt_course_create(&r->courses[r->course_count], plan, &question, &options);
    if (st == JLT_ERR_UNSUPPORTED && options.project)
        return jlt_command_fail(JLT_EXIT_INPUT, "--project: not with the tier %s, which has more than %d integrals",
                                jlt_plan_tier(plan), JLT_INVARIANTS_MAX);
    if (st == JLT_ERR_UNSUPPORTED) return jlt_common_no_kernels(s->descriptor, s->method);
    if (st != JLT_OK) return jlt_session_fail(st, jlt_plan_tier(plan));
    r->course_count++;
    return JLT_EXIT_DONE;
}

/* Read the next name of --compare from *at, and move *at behind it. Returns false if there is none. */
static bool next_compared(char name[64], const char **at)
{
    if (*at == NULL || **at == '\0') return false;
    const size_t length = strcspn(*at, ",");
    snprintf(name, 64, "%.*s", (int)length, *at);
    *at += length + ((*at)[length] == ',');
    return true;
}

/* Whether there is a tier of this name, and no lift leads to its table: it is the table asked for, or a smaller one. */
static bool is_smaller(const jlt_session *s, const char *name)
{
    jlt_tier tier;

    if (!jlt_tier_find(&tier, s->descriptor, &s->others, name)) return false;
    for (unsigned i = 0; i < tier.way_count; i++)
        if (strcmp(tier.ways[i]->kind, "lift") == 0) return false;
    return true;
}

static bool asks_larger(const jlt_simulate_request *r)
{
    const char *at = r->compare;
    bool asks = r->track || r->session.common.plan || (r->tier != NULL && !is_smaller(&r->session, r->tier));
    char name[64];

    while (!asks && next_compared(name, &at)) asks = !is_smaller(&r->session, name);
    return asks;
}

static jlt_exit open_courses(jlt_simulate_request *r)
{
    jlt_exit code = open_course(r, r->tier);
    const char *at = r->compare;
    char name[64];

    while (code == JLT_EXIT_DONE && next_compared(name, &at)) {
        if (r->course_count == JLT_SIMULATE_COURSES_MAX)
            return jlt_command_fail(JLT_EXIT_INPUT, "--compare: %d tiers at most", JLT_SIMULATE_COURSES_MAX - 1);
        code = open_course(r, name);
    }
    return code;
}

/* ---- rows ---- */

/* List the unproved claims that the results rest on: those of the kernel, and the integrals whose drifts are shown; NULL: none. */
static const char *list_unproved(char *claims, size_t size, const jlt_simulate_request *r, const jlt_descriptor *told)
{
    snprintf(claims, size, "%s", told->unproved != NULL ? told->unproved : "");
    for (unsigned i = 0; i < jlt_course_integrals(r->courses[0]); i++)
        jlt_descriptor_add_unproved(claims, size, r->session.descriptor, "integral", jlt_course_integral(r->courses[0], i));
    return *claims != '\0' ? claims : NULL;
}

static jlt_exit read_times(jlt_simulate_request *r)
{
    if (r->times_text != NULL) return jlt_simulate_times_list(&r->times, r->times_text);
    return jlt_simulate_times_until(&r->times, r->until, r->until_text, r->every, r->every_text);
}

static void write_header(FILE *file, const jlt_simulate_request *r)
{
    const jlt_session *s = &r->session;
    const jlt_plan *plan = &r->plans[0];
    const jlt_instance *kernel = jlt_course_kernel(r->courses[0]);
    const jlt_quantity *observed, *more;
    const unsigned observes = jlt_course_observes(r->courses[0], &observed),
                   beside = jlt_course_tells_more(r->courses[0], &more, NULL);

    /* in a sweep the tier, and its levels as parameters, may change from point to point: name the table asked for */
    const jlt_descriptor *told = s->common.at_point ? s->descriptor : kernel->descriptor;
    char claims[512];
    JLT_FREED double *params = jlt_common_steady(&s->common, told, s->common.at_point ? s->params : kernel->params);
    if (params != NULL)
        jlt_csv_header(file, &(jlt_csv_settings){ .command = s->common.command,
                                                  .descriptor = told,
                                                  .params = params,
                                                  .method = s->method->name,
                                                  .tolerance = s->tolerance,
                                                  .unproved = list_unproved(claims, sizeof claims, r, told) });
    fprintf(file, "# tier %s: %s; method %s, tolerance %.3g%s; nothing is random, so there is no seed\n", jlt_plan_tier(plan),
            plan->candidates[plan->chosen].tier.meaning, s->method->name, s->tolerance, r->project ? ", projected" : "");
    jlt_csv_names names;
    FILE *line = jlt_csv_names_begin(&names, file);
    fputc('t', line);
    for (unsigned i = 0; i < s->descriptor->state_count; i++) fprintf(line, ",%s", s->descriptor->states[i].name);
    for (unsigned i = 0; i < jlt_course_integrals(r->courses[0]); i++)
        fprintf(line, ",drift_%s", jlt_course_integral(r->courses[0], i));
    for (unsigned i = 0; i < observes; i++) fprintf(line, ",%s", observed[i].name);
    for (unsigned i = 0; i < beside; i++) fprintf(line, ",%s", more[i].name);
    for (size_t k = 1; k < r->course_count; k++) fprintf(line, ",difference_%s", jlt_plan_tier(&r->plans[k]));
    fputs(",fate", line);
    jlt_csv_names_end(&names);
}

/* The largest difference between the states x at time t and those of course k; NaN if that course stopped before. */
static double difference(jlt_simulate_request *r, size_t k, const double *x, double t)
{
    jlt_course_row row;
    double worst = 0;

    if (r->broken[k] != JLT_OK) return NAN;
    r->broken[k] = jlt_course_to(r->courses[k], t, &row);
    if (r->broken[k] != JLT_OK) {
        jlt_command_fail(JLT_EXIT_NUMERICAL, "the tier %s gave up before t = %.10g: %s", jlt_plan_tier(&r->plans[k]), t,
                         jlt_status_text(r->broken[k]));
        return NAN;
    }
    if (row.end != JLT_END_TIME) return NAN;
    for (unsigned i = 0; i < r->session.descriptor->state_count; i++) worst = fmax(worst, fabs(row.x[i] - x[i]));
    return worst;
}

/* Write the last field, the orbit's fate. st: the status of the call that made the row. */
static void write_fate(FILE *file, const jlt_course_row *row, jlt_status st)
{
    jlt_fate failure;

    if (st != JLT_OK) fprintf(file, ",%s\n", jlt_section_fate_of(&failure, st) ? jlt_section_fate_name(failure) : "unknown");
    else if (row->end == JLT_END_POLE) fprintf(file, ",%s\n", jlt_section_fate_name(row->fate));
    else if (!isnan(row->lost_at)) fprintf(file, ",lost_%s\n", row->lost);
    else if (row->unknown != NULL) fprintf(file, ",unknown_%s\n", row->unknown);
    else fputs(",alive\n", file);
}

static void write_row(FILE *file, jlt_simulate_request *r, const jlt_course_row *row, jlt_status st)
{
    double values[1 + 2 * JLT_PLAN_STATES_MAX];
    size_t count = 0;

    values[count++] = row->t;
    for (unsigned i = 0; i < r->session.descriptor->state_count; i++) values[count++] = row->x[i];
    for (unsigned i = 0; i < jlt_course_integrals(r->courses[0]); i++) values[count++] = row->drift[i];
    jlt_csv_values(file, values, count);
    jlt_csv_more(file, row->observed, jlt_course_observes(r->courses[0], NULL));
    jlt_csv_more(file, row->more, jlt_course_tells_more(r->courses[0], NULL, NULL));
    count = 0;
    for (size_t k = 1; k < r->course_count; k++)
        values[count++] = row->end == JLT_END_TIME ? difference(r, k, row->x, row->t) : NAN;
    jlt_csv_more(file, values, count);
    write_fate(file, row, st);
    const bool ends = st != JLT_OK || row->end == JLT_END_POLE || r->rows + 1 == r->times.count;
    if (r->session.common.points != NULL) jlt_simulate_point(r, row, ends);
}

static const char too_stiff[] = ", in which no state moves by 1e-4 of its size: the motion is stiff, as rates limit steps that it "
                                "no longer shows, and no --method here is made for that; or a rate jumps there, as where dry "
                                "friction stops a body, which 'domain moving : u^2 + v^2 - 1e-12 > 0' would end before";

static jlt_exit cannot_go_on(const jlt_simulate_request *r, const jlt_course_row *row, jlt_status st)
{
    if (st == JLT_ERR_DOMAIN)
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "at t = %.10g %s%s", row->t, row->edge,
                                r->plans[0].forced && r->plans[0].count > 1 ? ": leave out --tier" : "");
    if (row->unbounded != NULL)
        return jlt_command_fail(jlt_command_exit(st), "%s seems to grow without bound towards t = %.10g: %s", row->unbounded,
                                row->t, jlt_status_text(st));
    if (st == JLT_ERR_BUDGET)
        return jlt_command_fail(jlt_command_exit(st),
                                "the orbit could not be followed beyond t = %.10g within the budget of steps: its steps take "
                                "%.3g of time%s", row->t, row->step, row->stiff ? too_stiff : "");
    return jlt_command_fail(jlt_command_exit(st), "the orbit could not be followed beyond t = %.10g: %s", row->t,
                            jlt_status_text(st));
}

static jlt_exit follow(jlt_simulate_request *r)
{
    FILE *file = r->session.common.table.file;
    jlt_progress progress;
    jlt_exit code = JLT_EXIT_DONE;
    jlt_course_row *row = &r->last;

    jlt_progress_start(&progress, "rows");
    for (size_t i = 0; i < r->times.count; i++) {
        const jlt_status st = jlt_course_to(r->courses[0], jlt_simulate_times_at(&r->times, i), row);
        if (st != JLT_OK && row->x == NULL) return jlt_session_fail(st, "the start");
        if (st == JLT_OK && row->end == JLT_END_INTERRUPT) break;
        write_row(file, r, row, st);
        r->rows++;
        if (st != JLT_OK) {
            code = cannot_go_on(r, row, st);
            break;
        }
        if (ferror(file) || row->end == JLT_END_POLE || jlt_session_interrupted(&r->session)) break;
        jlt_progress_show(&progress, i + 1, r->times.count);
    }
    jlt_progress_end(&progress);
    return code;
}

static const jlt_swept_form swept = { &jlt_command_simulate, false, 1 };

static jlt_exit run(int argc, char **argv)
{
    jlt_simulate_request r = { .until = NAN, .every = NAN };
    jlt_common *common = &r.session.common;
    jlt_exit code;

    jlt_session_begin(&r.session, argc, argv);
    ttc_options_parse(&parser, argc, argv, &r);
    if (jlt_swept_done(&code, &swept, &r.session.common)) goto done;
    code = jlt_session_open(&r.session);
    if (code == JLT_EXIT_DONE && asks_larger(&r)) code = jlt_session_look_at_larger(&r.session);
    if (code == JLT_EXIT_DONE) code = jlt_session_start(&r.session);
    if (code == JLT_EXIT_DONE) code = read_times(&r);
    if (code == JLT_EXIT_DONE) code = open_courses(&r);
    if (code == JLT_EXIT_DONE) code = jlt_simulate_axes(&r);
    if (code == JLT_EXIT_DONE && r.session.common.plan) {
        jlt_planned_show(&r.plans[0], NULL);
        for (size_t k = 1; k < r.course_count; k++) jlt_planned_chosen(&r.plans[k]); /* of --compare */
        printf("  one orbit, at %zu time%s; method %s, tolerance %.3g\n", r.times.count, ttc_text_plural(r.times.count),
               r.session.method->name, r.session.tolerance);
        code = JLT_EXIT_PLANNED;
    }
    if (code == JLT_EXIT_DONE) code = jlt_common_write(common);
    if (code != JLT_EXIT_DONE) goto done;
    write_header(common->table.file, &r);
    code = follow(&r);
    /* rows computed before a failure are good, and are saved nevertheless */
    const jlt_exit saved = jlt_common_save(common);
    if (saved != JLT_EXIT_DONE) code = saved;
    else jlt_simulate_closing_words(&r);
    if (code == JLT_EXIT_DONE && common->plot != NULL) code = jlt_simulate_draw(&r);
done:
    for (size_t k = 0; k < JLT_SIMULATE_COURSES_MAX; k++) jlt_course_destroy(r.courses[k]);
    free(r.extents);
    free(r.points);
    jlt_simulate_times_clear(&r.times);
    jlt_session_end(&r.session);
    return code;
}

const jlt_command jlt_command_simulate = {
    "simulate", "[MODEL] --start ... --times ...|--until ... [OPTION...]",
    "One orbit at given times: states, drifts, observed quantities", run, &parser, NULL
};
