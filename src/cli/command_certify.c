/* `jellett certify`: proves an orbit, or what a family of equilibria excludes, and writes the certificate. */
#include "base/options.h"
#include "cli/certify_orbit.h"
#include "cli/certify_family.h"
#include "cli/certify_given.h"
#include "cli/certify_pole.h"
#include "core/memory.h"
#include "dynamics/periodic.h"
#include "validated/certificate.h"
#include "validated/given_family.h"
#include "validated/given_homoclinic.h"
#include "validated/symmetry.h"
#include "validated/theorem.h"

#include <string.h>

typedef struct {
    jlt_motion_options motion;
    const char *kind;
    size_t period, digits, which, limit;
    double radius, distance;
    jlt_assign_list spread;
    const char *family, *box;
    unsigned long long typed; /* bit i: own_options[i] was typed */
    jlt_step_watch watch;
} options;

#define KINDS "cycle, elliptic, equilibria, homoclinic, obstruction, pole, sink or symmetric"

static const double tolerance = 1e-13; /* for finding the orbit in doubles */

enum { DIGITS = 2000, RADIUS, SPREAD, DISTANCE, ORBIT, FAMILY, BOX, LIMIT };

static const struct argp_option option_table[] = {
    { "period", 'n', "N", 0, "The orbit closes after N returns, at most 64; default 1", 1 },
    { "start", 'a', "NAME=VALUE,...", 0,
      "A point near the orbit: a value for every coordinate of the section, as `jellett orbits` gives it; for a pole, a "
      "value for every state where the motions begin", 1 },
    { "digits", DIGITS, "N", 0, "Decimals to compute with, 10 to 1000; default 20", 1 },
    { "radius", RADIUS, "R", 0,
      "Radius of the box, in units of the table's states; default 1e-10 in units of the problem, or of coordinates far larger, "
      "or all far smaller, than 1; with --spread, as far as orbits spread", 1 },
    { "distance", DISTANCE, "VALUE", 0,
      "How far from the saddle a homoclinic orbit begins, relative to the size of the section; default 1e-7", 1 },
    { "orbit", ORBIT, "N", 0, "Which homoclinic orbit: the Nth that is found, in order of returns; default 1", 1 },
    { "family", FAMILY, "NAME", 0, "The family of equilibria, where the table has more than one", 1 },
    { "box", BOX, "NAME=LOW:HIGH|VALUE,...", 0,
      "Ranges, or values, of the parameters and of all states that the family leaves free", 1 },
    { "limit", LIMIT, "N", 0, "Cut the box of a family into at most N parts; default 100000", 1 },
    { "spread", SPREAD, "NAME=RADIUS,...", TTC_OPTIONS_REPEATED,
      "Prove it for all values of these parameters and levels, and of states where motions to a pole begin, that are within "
      "RADIUS of the given ones", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_certificate_argp, 0, NULL, 0 }, { 0 } };

/* Options that only some kinds take, and these kinds, which are looked up with strstr: no kind's name contains another's. */
static const struct {
    int key;
    const char *option, *kinds;
} own_options[] = {
    { 'n', "--period", "cycle, elliptic, obstruction, sink and symmetric" },
    { 'a', "--start", "cycle, elliptic, homoclinic, obstruction, pole, sink and symmetric" },
    { RADIUS, "--radius", "cycle, elliptic, homoclinic, obstruction, sink and symmetric" },
    { SPREAD, "--spread", "cycle, elliptic, homoclinic, obstruction, pole, sink and symmetric" },
    { DISTANCE, "--distance", "homoclinic" },
    { ORBIT, "--orbit", "homoclinic" },
    { FAMILY, "--family", "equilibria" },
    { BOX, "--box", "equilibria" },
    { LIMIT, "--limit", "equilibria" },
};

static const unsigned own_option_count = sizeof own_options / sizeof *own_options;

static void note_typed(options *o, int key)
{
    for (unsigned i = 0; i < own_option_count; i++)
        if (own_options[i].key == key) o->typed |= 1ull << i;
}

static bool has_section(const char *kind) { return strcmp(kind, "equilibria") != 0 && strcmp(kind, "pole") != 0; }

/* Refuse options that this kind does not take, which would otherwise have no effect. */
static void check_typed(const options *o, const struct argp_state *state)
{
    const jlt_motion_options *m = &o->motion;
    const char *of_section = m->section != NULL                     ? "--section"
                             : m->level.count > 0                   ? "--level"
                             : m->solve != NULL                     ? "--solve"
                             : m->modulo != NULL                    ? "--modulo"
                             : m->mirror != NULL                    ? "--mirror"
                             : m->flow.direction != JLT_RISING      ? "--direction"
                             : m->flow.tolerance != tolerance       ? "--tol"
                             : m->flow.method != jlt_method_find(NULL) ? "--method"
                             : m->flow.max_steps != 0               ? "--max-steps"
                                                                    : NULL;

    for (unsigned i = 0; i < own_option_count; i++)
        if ((o->typed >> i & 1) != 0 && strstr(own_options[i].kinds, o->kind) == NULL)
            argp_error(state, "%s is an option of %s, not of %s: leave it out", own_options[i].option, own_options[i].kinds,
                       o->kind);
    if (!has_section(o->kind) && of_section != NULL)
        argp_error(state, "%s is an option of orbits on sections, not of %s: leave it out", of_section, o->kind);
    if (m->flow.direction == JLT_BOTH) argp_error(state, "--direction: a certificate counts crossings one way, up or down");
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    note_typed(o, key);
    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'n': jlt_common_count(&o->period, value, 1, JLT_PERIODIC_MAX, "--period"); return 0;
    case DIGITS: jlt_common_count(&o->digits, value, 10, JLT_GIVEN_DIGITS_MAX, "--digits"); return 0;
    case RADIUS: jlt_common_positive(&o->radius, value, "--radius"); return 0;
    case DISTANCE: jlt_common_positive(&o->distance, value, "--distance"); return 0;
    case ORBIT: jlt_common_count(&o->which, value, 1, 1000, "--orbit"); return 0;
    case FAMILY: o->family = value; return 0;
    case BOX: o->box = value; return 0;
    case LIMIT: jlt_common_count(&o->limit, value, 1, JLT_GIVEN_FAMILY_LIMIT_MAX, "--limit"); return 0;
    case SPREAD: jlt_common_list(&o->spread, value, "--spread"); return 0;
    case 'a': jlt_motion_one_start(&o->motion, value); return 0;
    case ARGP_KEY_ARG:
        if (o->kind != NULL) return ARGP_ERR_UNKNOWN;
        o->kind = value;
        if (!jlt_theorem_is_kind(value))
            argp_error(state, "'%s' is no kind of certificate: write " KINDS, value);
        return 0;
    case ARGP_KEY_END:
        if (o->kind == NULL) argp_error(state, "say what to certify: " KINDS);
        jlt_common_no_table(&o->motion.common, state, "a certificate");
        check_typed(o, state);
        if (strcmp(o->kind, "equilibria") == 0) return 0;
        if (o->motion.starts[0] == NULL && !has_section(o->kind))
            jlt_common_incomplete(&o->motion.common, state,
                                  "say where the motions begin: --start, every state, and how far around, --spread");
        if (o->motion.starts[0] == NULL)
            jlt_common_incomplete(&o->motion.common, state, "say near which orbit: --start, as `jellett orbits` gives it");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "cycle|elliptic|equilibria|homoclinic|obstruction|pole|sink|symmetric [MODEL]",
    "Prove a periodic or homoclinic orbit, what a family of equilibria excludes, or that motions end at a pole, in ball "
    "arithmetic, and write the certificate, from which `jellett check` replays the proof."
    "\vKinds:\n"
    "cycle: through a box on the section exactly one orbit closes after a time near one that is given; its period and its "
    "multipliers are enclosed.\n"
    "obstruction: a cycle, and the product of its multipliers is not 1, so that no invariant measure has a continuous positive "
    "density at it.\n"
    "sink: a cycle, and all multipliers lie inside the unit circle, so that it attracts; its image under a reversor repels, and "
    "no invariant measure has a positive density near it.\n"
    "symmetric: the orbit is its own mirror image under a proved reversor, so that the product of its multipliers is 1 exactly, "
    "and its trace tells its type; the rotation number is enclosed where it is elliptic.\n"
    "elliptic: symmetric and elliptic, without a resonance up to order 4, and with a twist coefficient that is not 0: the orbit is "
    "stable on its levels, surrounded by invariant tori.\n"
    "homoclinic: the orbit is a saddle and its own mirror image, and its unstable and stable manifolds cross transversally at a "
    "point that a reversor keeps, the table's first one that serves.\n"
    "equilibria: at all points of a family that the table claims, in a whole box of parameters and states, the trace of the "
    "linearization has one sign, so that no invariant measure has a continuous positive density near any of them; the box is cut "
    "in halves as far as needed.\n"
    "pole: all motions that begin in a box of states end at one end of a state's interval, which the table claims to be a pole, "
    "after a finite time that is enclosed: a spherical top turns over, or comes down.\n\n"
    "Values typed and defaults of tables are taken exactly. Orbits are found in doubles first. An orbit of a forced system, or "
    "around an angle, closes up to whole numbers of periods that the table proves (`periodic`), and is the only one that does with "
    "these numbers; for such orbits there are cycle, obstruction and sink.\n\n"
    "Examples:\n"
    "  jellett certify equilibria --family spin \\\n"
    "    --box I1=0.2:1,I3=0.2:1,gamma3=0.05:0.9,v_nu=0.1:2,omega3=-3:3\n"
    "  jellett certify sink --set I1=0.591,I3=0.494,a3=0.548 \\\n"
    "    --level E=2.15,G=0.161 --start eta=2.84,gamma3=-0.959\n"
    "  jellett certify pole \\\n"
    "    --start gamma3=-0.78,v_nu=0.8,omega_tau=2.5,omega_n=-1,omega3=-2.7 \\\n"
    "    --spread gamma3=5e-4,omega_n=5e-4",
    children, NULL, NULL,
};

static jlt_exit fail(const jlt_certificate_report *report)
{
    switch (report->verdict) {
    case JLT_CERTIFICATE_GOOD: return JLT_EXIT_DONE;
    case JLT_CERTIFICATE_REFUSED: return jlt_command_fail(JLT_EXIT_FAILED, "not proved: %s", report->problem);
    case JLT_CERTIFICATE_MALFORMED: return jlt_command_fail(JLT_EXIT_INPUT, "%s", report->problem);
    default: return jlt_command_fail(JLT_EXIT_NUMERICAL, "the proof could not be carried out: %s", report->problem);
    }
}

static const char unshown[] = "not proved: the orbit near %s is not shown, with %zu digits, to stay in the domain of %s: it "
                              "leaves it, or comes so near its edge that these cannot be told apart (more digits, or less "
                              "--spread, may do)";

/* Rounding moves a multiplier 1 that stands in a Jordan block by its square or cube root. */
static const double jordan = 1e-4;
/* An orbit whose points miss their images by more of their size is not its own: doubles tell them to much less, unless the orbit is
 * so unstable that no proof succeeds. */
static const double far = 1e-4;
static const char in_family[] = "the orbit could not be refined with %zu digits: a multiplier is 1 to within %.1g, as where orbits "
                                "come in families, of which no box holds exactly one (choose one by --level of an integral that "
                                "differs along the family; leave what a symmetry moves out of the table)";

/* For one reversor: find an orbit homoclinic to search->saddle in doubles, then refine it in balls. x: room for its points. */
static jlt_status find_homoclinic(json_t *given, double *x, const jlt_given *question, const jlt_reversor *reversor,
                                  const jlt_system *system, jlt_certify_search *search)
{
    double T[JLT_CERTIFY_RETURNS_MAX];
    unsigned legs = 0;

    search->signs = reversor->signs;
    JLT_PASS(jlt_certify_homoclinic_find(x, T, &legs, &system->flow, search));
    return jlt_given_homoclinic_make(question, given, reversor, legs, x, T, system->flow.direction == JLT_FALLING ? 1 : -1);
}

/* Add the homoclinic orbit to the question, by the first proved reversor for which one is found. */
static jlt_exit add_homoclinic(json_t *given, const jlt_given *question, const options *o, const jlt_system *system)
{
    const jlt_descriptor *d = question->question.descriptor;
    const jlt_chart *chart = system->flow.chart;
    JLT_FREED double *x = calloc((size_t)JLT_CERTIFY_RETURNS_MAX * d->state_count, sizeof *x);
    double q[JLT_CHART_DIM_MAX];
    double saddle[JLT_CHART_STATES_MAX] = { 0 };
    jlt_certify_search search = { .states = d->state_count, .saddle = q, .which = (unsigned)o->which, .distance = o->distance };
    jlt_status st = x == NULL ? JLT_ERR_NOMEM : JLT_ERR_UNSUPPORTED;

    for (unsigned i = 0, k = 0; i < d->state_count; i++)
        saddle[i] = i == question->question.column
                        ? chart->level
                        : ldexp(arf_get_d(arb_midref(question->legs.box + k++), ARF_RND_NEAR), -system->flow.units.state[i]);
    chart->lower(chart, q, NULL, saddle);
    for (unsigned i = 0; x != NULL && st != JLT_OK && i < d->reversor_count; i++) {
        const jlt_status found = jlt_theorem_is_proved(d, &d->reversors[i])
                                     ? find_homoclinic(given, x, question, &d->reversors[i], system, &search)
                                     : JLT_ERR_UNSUPPORTED;
        if (st == JLT_ERR_UNSUPPORTED || found == JLT_OK) st = found;
    }
    if (st == JLT_ERR_DOMAIN) return jlt_command_fail(JLT_EXIT_FAILED, unshown, o->motion.starts[0], o->digits, d->model);
    if (st == JLT_ERR_UNSUPPORTED)
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "no symmetric homoclinic orbit is looked for from %s: no proved reversor of %s flips the section's "
                                "state, which is to be 0, and one other, and takes the levels and the saddle to themselves: write "
                                "'reversor STATE -> -STATE, ...' in its table, or begin at another saddle",
                                o->motion.starts[0], d->model);
    return st == JLT_OK ? JLT_EXIT_DONE
                        : jlt_command_fail(JLT_EXIT_NUMERICAL, "no symmetric homoclinic orbit was found from %s: %s",
                                           o->motion.starts[0], jlt_status_text(st));
}

/* Refuse a proof of symmetry that would fail, before the orbit is refined: the table has no reversor for it, or those that it has
 * map the points x, shape (legs, states), elsewhere. An orbit that closes up to periods, with some of `turns` nonzero, is refused
 * for that. */
static jlt_exit check_reversors(const options *o, const jlt_cycle_question *question, const double *x, const int *turns,
                                unsigned legs)
{
    bool asked = strcmp(o->kind, "symmetric") == 0 || strcmp(o->kind, "elliptic") == 0;
    double miss = 0;
    jlt_status st = JLT_OK;

    for (unsigned i = 0; i < legs * question->descriptor->state_count; i++) asked = asked && turns[i] == 0;
    if (asked) st = jlt_symmetry_foresee(&miss, question, x, legs);
    if (st != JLT_OK) return jlt_command_fail(jlt_command_exit(st), "%s", jlt_status_text(st));
    if (isinf(miss))
        return jlt_command_fail(JLT_EXIT_FAILED, "not proved: no reversor of the table that is proved without a condition maps the "
                                                 "section, crossed as it is, and the levels to themselves");
    return miss <= far ? JLT_EXIT_DONE
                       : jlt_command_fail(JLT_EXIT_FAILED, "not proved: the orbit is not shown to be its own mirror image: its "
                                                           "points miss their images by %.2g of their size", miss);
}

/* Make the question about an orbit: find it in doubles, refine it in balls, and put boxes around it. */
static jlt_exit ask(json_t **given, const jlt_descriptor **d, options *o, jlt_system *system)
{
    JLT_FREED double *x = calloc((size_t)JLT_PERIODIC_MAX * JLT_CHART_STATES_MAX, sizeof *x);
    double T[JLT_PERIODIC_MAX], q[JLT_CHART_DIM_MAX], near_one = INFINITY;
    JLT_FREED int *turns = calloc((size_t)JLT_PERIODIC_MAX * JLT_CHART_STATES_MAX, sizeof *turns);
    unsigned legs = 0;
    char problem[JLT_GIVEN_PROBLEM_MAX] = "";
    jlt_given question;
    jlt_status st = JLT_OK;
    jlt_exit code = x == NULL || turns == NULL ? jlt_command_no_memory() : jlt_motion_start(q, system, o->motion.starts[0]);

    if (code == JLT_EXIT_DONE) code = jlt_motion_scale(system, q, NULL);
    if (code == JLT_EXIT_DONE) code = jlt_certify_cycle_check(system);
    if (code == JLT_EXIT_DONE) st = jlt_certify_cycle_find(x, T, turns, &legs, &near_one, system, q, o->period);
    if (st != JLT_OK) code = jlt_motion_no_orbit(st, system, o->motion.starts[0]);
    if (code == JLT_EXIT_DONE) code = jlt_certify_given(given, d, &o->motion, system, &o->spread, (unsigned)o->digits);
    if (code != JLT_EXIT_DONE) return code;
    code = jlt_given_read(&question, *given, *d, &o->watch, problem)
               ? check_reversors(o, &question.question, x, turns, legs)
               : jlt_command_fail(JLT_EXIT_INPUT, "%s", problem);
    if (code == JLT_EXIT_DONE)
        st = jlt_given_make_legs(&question, *given, legs, x, T, turns, o->radius, system->flow.units.state, problem);
    if (st != JLT_OK && *problem != '\0')
        code = jlt_command_fail(JLT_EXIT_INPUT, "%s", problem);
    else if (st == JLT_ERR_DOMAIN)
        code = jlt_command_fail(JLT_EXIT_FAILED, unshown, o->motion.starts[0], o->digits, (*d)->model);
    else if (st == JLT_ERR_NO_CONVERGENCE && near_one < jordan)
        code = jlt_command_fail(JLT_EXIT_NUMERICAL, in_family, o->digits, near_one);
    else if (st != JLT_OK)
        code = jlt_command_fail(JLT_EXIT_NUMERICAL, "the orbit could not be refined with %zu digits: %s", o->digits,
                                jlt_status_text(st));
    else if (code == JLT_EXIT_DONE && strcmp(o->kind, "homoclinic") == 0 && question.legs.turns == NULL)
        code = add_homoclinic(*given, &question, o, system); /* with turns the kind is refused */
    jlt_given_clear(&question);
    return code;
}

/* Make the question, for a family of equilibria or for an orbit. Out: *given, *d, its table; *system, for an orbit only. */
static jlt_exit find_question(json_t **given, const jlt_descriptor **d, jlt_system **system, options *o)
{
    const jlt_certify_family_options family = { o->family, o->box, o->limit, o->digits };
    const jlt_certify_pole_options pole = { o->motion.starts[0], &o->spread, o->digits, &o->watch };
    jlt_common *common = &o->motion.common;
    const bool is_orbit = has_section(o->kind);

    JLT_PASS(is_orbit ? jlt_motion_system(system, &o->motion) : jlt_common_model(common, d));
    if (is_orbit) JLT_PASS(jlt_motion_plan(*system, &o->motion));
    else if (strcmp(o->kind, "equilibria") == 0) JLT_PASS(jlt_certify_family(given, &family, &common->set, *d));
    if (common->plan) return jlt_common_still();
    JLT_PASS(jlt_common_write(common));
    if (is_orbit) return ask(given, d, o, *system);
    return *given != NULL ? JLT_EXIT_DONE : jlt_certify_pole(given, &pole, &common->set, *d);
}

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end) options o = { .period = 1, .digits = 20, .distance = 1e-7, .which = 1, .limit = 100000 };
    JLT_OWNED(jlt_system) *system = NULL;
    jlt_common *common = &o.motion.common;
    const jlt_descriptor *d = NULL;
    json_auto_t *given = NULL, *certificate = NULL;
    jlt_certificate_report report;
    jlt_progress progress;
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.tolerance = tolerance;
    ttc_options_parse(&parser, argc, argv, &o);
    o.watch = jlt_certify_watch(&progress);
    code = find_question(&given, &d, &system, &o);
    if (code == JLT_EXIT_DONE) certificate = jlt_certificate_make(&report, o.kind, given, d, &o.watch);
    jlt_progress_end(&progress);
    if (code == JLT_EXIT_DONE) code = fail(&report);
    if (code == JLT_EXIT_DONE
        && (json_dumpf(certificate, common->table.file, JSON_INDENT(1)) != 0 || fputc('\n', common->table.file) == EOF))
        code = jlt_command_no_memory();
    if (code == JLT_EXIT_DONE) code = jlt_common_save(common);
    jlt_assign_clear(&o.spread);
    return code;
}

const jlt_command jlt_command_certify = {
    "certify", "KIND [MODEL] [OPTION...]", "Prove an orbit, what equilibria exclude, or how motions end", run, NULL, NULL
};
