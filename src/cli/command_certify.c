#include "cli/certify_given.h"
#include "dynamics/periodic.h"
#include "report/json.h"
#include "validated/certificate.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    const char *kind, *start;
    size_t period, digits;
    double radius;
    jlt_assign_list spread;
} options;

enum { DIGITS = 2000, RADIUS, SPREAD };

static const struct argp_option option_table[] = {
    { "period", 'n', "N", 0, "The orbit closes after N returns, at most 64; default 1", 1 },
    { "start", 'a', "NAME=VALUE,...", 0, "Near a point of the orbit, as `jellett orbits` gives it", 1 },
    { "digits", DIGITS, "N", 0, "Decimals to compute with, 10 to 1000; default 20", 1 },
    { "radius", RADIUS, "R", 0, "Of the box, in units of the table's states; default 1e-10", 1 },
    { "spread", SPREAD, "NAME=RADIUS,...", 0, "Let parameters and levels have any value within this distance of theirs", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->motion;
        return 0;
    case 'n': jlt_common_count(&o->period, value, 1, JLT_PERIODIC_MAX, "--period"); return 0;
    case DIGITS: jlt_common_count(&o->digits, value, 10, JLT_GIVEN_DIGITS_MAX, "--digits"); return 0;
    case RADIUS: jlt_common_positive(&o->radius, value, "--radius"); return 0;
    case SPREAD: jlt_common_list(&o->spread, value, "--spread"); return 0;
    case 'a': o->start = value; return 0;
    case ARGP_KEY_ARG:
        if (o->kind != NULL) return ARGP_ERR_UNKNOWN;
        o->kind = value;
        if (strcmp(value, "sink") != 0 && strcmp(value, "cycle") != 0)
            argp_error(state, "'%s' is no kind of certificate: write sink or cycle", value);
        return 0;
    case ARGP_KEY_END:
        if (o->kind == NULL) argp_error(state, "say what to certify: sink or cycle");
        if (o->motion.common.plot != NULL) argp_error(state, "a certificate has no picture: leave out --plot");
        if (o->start == NULL) argp_error(state, "say near which orbit: --start, as `jellett orbits` gives it");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { 0 } };

static const struct argp parser = {
    option_table, parse, "cycle|sink [MODEL]",
    "Prove a periodic orbit in ball arithmetic, and write the certificate, from which `jellett check` replays the proof."
    "\vcycle: exactly one orbit goes through a box on the section; its period and its multipliers are enclosed. sink: besides, all "
    "multipliers are inside the unit circle, so that it attracts; its image under a reversor repels, and no invariant measure has "
    "a positive density near it. Values typed and defaults of tables are taken exactly. The orbit is "
    "found in doubles first.\n\n"
    "  jellett certify sink --set I1=0.591,I3=0.494,a3=0.548 \\\n"
    "    --level E=2.15,G=0.161 --start eta=2.84,gamma3=-0.959",
    children, NULL, NULL,
};

/* A point of the orbit in doubles, x, shape (states,), and the time to come back to it. */
static jlt_exit find(double *x, double *T, const options *o, const jlt_system *system)
{
    double q[JLT_CHART_DIM_MAX];
    jlt_map *map = NULL;
    jlt_periodic orbit;
    jlt_image image;
    jlt_exit code = jlt_motion_start(q, system, o->start);
    jlt_status st;

    if (code != JLT_EXIT_DONE) return code;
    st = jlt_map_create(&map, &system->flow);
    if (st == JLT_OK) st = jlt_periodic_find(map, &orbit, q, o->period, NULL);
    if (st == JLT_OK) st = jlt_map_apply(map, &image, orbit.points, orbit.period, 1);
    jlt_map_destroy(map);
    if (st != JLT_OK) return jlt_motion_no_orbit(st, system, o->start);
    memcpy(x, image.x, system->flow.chart->states * sizeof *x);
    *T = image.T;
    return JLT_EXIT_DONE;
}

static jlt_exit fail(const jlt_certificate_report *report)
{
    switch (report->verdict) {
    case JLT_CERTIFICATE_GOOD: return JLT_EXIT_DONE;
    case JLT_CERTIFICATE_REFUSED: return jlt_command_fail(JLT_EXIT_FAILED, "not proved: %s", report->problem);
    case JLT_CERTIFICATE_MALFORMED: return jlt_command_fail(JLT_EXIT_INPUT, "%s", report->problem);
    default: return jlt_command_fail(JLT_EXIT_NUMERICAL, "the proof could not be carried out: %s", report->problem);
    }
}

/* The question, with a box around the orbit, refined in balls. */
static jlt_exit ask(json_t **given, const jlt_descriptor **d, const options *o, const jlt_system *system)
{
    double x[JLT_CHART_STATES_MAX], T = 0;
    char problem[JLT_GIVEN_PROBLEM_MAX];
    jlt_given question;
    jlt_status st;
    jlt_exit code = find(x, &T, o, system);

    if (code == JLT_EXIT_DONE) code = jlt_certify_given(given, d, &o->motion, system, &o->spread, (unsigned)o->digits);
    if (code != JLT_EXIT_DONE) return code;
    if (!jlt_given_read(&question, *given, *d, problem)) code = jlt_command_fail(JLT_EXIT_INPUT, "%s", problem);
    else if ((st = jlt_given_make_box(&question, *given, x, T, o->radius)) != JLT_OK)
        code = jlt_command_fail(JLT_EXIT_NUMERICAL, "the orbit could not be refined with %zu digits: %s", o->digits,
                                jlt_status_text(st));
    jlt_given_clear(&question);
    return code;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .period = 1, .digits = 20, .radius = 1e-10 };
    jlt_common *common = &o.motion.common;
    jlt_system *system = NULL;
    const jlt_descriptor *d = NULL;
    json_t *given = NULL, *certificate = NULL;
    jlt_certificate_report report;
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.tolerance = 1e-13;
    argp_parse(&parser, argc, argv, 0, NULL, &o);
    o.motion.begins.starts = &o.start;
    o.motion.begins.start_count = 1;
    code = jlt_motion_system(&system, &o.motion);
    if (code == JLT_EXIT_DONE) code = jlt_common_write(common);
    if (code == JLT_EXIT_DONE) code = ask(&given, &d, &o, system);
    if (code != JLT_EXIT_DONE) goto done;
    certificate = jlt_certificate_make(&report, o.kind, given, d);
    code = fail(&report);
    if (code != JLT_EXIT_DONE) goto done;
    if (json_dumpf(certificate, common->table.file, JSON_INDENT(1)) != 0 || fputc('\n', common->table.file) == EOF)
        code = jlt_command_no_memory();
    if (code == JLT_EXIT_DONE) code = jlt_common_save(common);
done:
    json_decref(certificate);
    json_decref(given);
    jlt_assign_clear(&o.spread);
    jlt_system_destroy(system);
    jlt_motion_end(&o.motion);
    return code;
}

const jlt_command jlt_command_certify = {
    "certify", "cycle|sink [MODEL] [OPTION...]", "Prove a periodic orbit, and write the certificate", run, NULL
};
