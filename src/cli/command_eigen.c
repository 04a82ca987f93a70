/* `jellett eigen`: reports on an equilibrium, its matrix, characteristic polynomial, eigenvalues and stability. */
#include "base/options.h"
#include "cli/eigen.h"

#include "kernel/descriptor.h"

#include <stdlib.h>

enum { KEY_FIND = 256, KEY_SWEEP, KEY_DIGITS, KEY_FAST, KEY_THREADS };

static const struct argp_option option_table[] = {
    { "at", 'a', "STATE=VALUE,...", TTC_OPTIONS_REPEATED,
      "States of the equilibrium. States not named follow from its family, or are zero", 1 },
    { "find", KEY_FIND, NULL, 0, "Take the states as a guess, and find an equilibrium nearby by Newton's method", 1 },
    { "sweep", KEY_SWEEP, "STATE|PARAM=LOW:HIGH:COUNT,...", 0,
      "Write one row for each point of a grid in these states or parameters", 1 },
    { "threads", KEY_THREADS, "N", 0,
      "Compute a sweep by N processes; default: as many as processors, or as OMP_NUM_THREADS says. Rows do not depend on N", 1 },
    { "digits", KEY_DIGITS, "N", 0, "Print numbers with N digits (1 to 1000), all of them right; not with --sweep or --csv", 1 },
    { "fast", KEY_FAST, NULL, 0, "Compute in doubles only, with bounds on their errors; verdicts are then not proved", 1 },
    { "json", 'j', NULL, 0, "Print JSON", 1 },
    { "csv", 'c', NULL, 0, "Print CSV with a header of comments, as a sweep always does", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_eigen_request *r = state->input;
    jlt_exit code = JLT_EXIT_DONE;
    size_t digits;

    switch (key) {
    case ARGP_KEY_INIT: state->child_inputs[0] = &r->common; break;
    case 'a': jlt_common_list(&r->at, value, "--at"); break;
    case KEY_FIND: r->question.find = true; break;
    case KEY_SWEEP:
        r->common.own_sweep = value;
        code = jlt_eigen_parse_sweep(r, value);
        break;
    case KEY_DIGITS:
        jlt_common_count(&digits, value, 1, JLT_BALL_TEXTS_DIGITS_MAX, "--digits");
        r->question.digits = (long)digits;
        break;
    case KEY_FAST: r->question.fast = true; break;
    case KEY_THREADS: jlt_common_count(&r->processes, value, 1, 1024, "--threads"); break;
    case 'j': r->json = true; break;
    case 'c': r->csv = true; break;
    case ARGP_KEY_END:
        if (r->processes > 0 && r->axis_count == 0) argp_error(state, "--threads needs --sweep: add it, or leave out --threads");
        if (r->json && r->csv) argp_error(state, "--json and --csv exclude each other");
        if (r->question.digits > 0 && (r->question.fast || r->csv || r->axis_count > 0))
            argp_error(state, "--digits excludes --fast, --csv and --sweep");
        jlt_common_not_swept(&r->common, &r->at, "--at");
        r->question.proved_only = !r->json && (r->csv || r->axis_count > 0);
        if (!r->question.proved_only) jlt_common_no_table(&r->common, state, "a report");
        break;
    default: return ARGP_ERR_UNKNOWN;
    }
    if (code != JLT_EXIT_DONE) exit((int)code);
    return 0;
}

static const struct argp_child children[] = { { &jlt_common_argp, 0, NULL, 0 }, { 0 } };

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Report on an equilibrium: residual, Jacobian, characteristic polynomial, trace, eigenvalues, stability, and what follows "
    "for an invariant measure."
    "\vValues are read exactly (1/3, 0.51). Matrix, characteristic polynomial, trace and eigenvalues are those of the exact "
    "equilibrium, in ball arithmetic with as many bits, 192 to 6144, as make every number printed the nearest double, or with "
    "--digits the nearest decimal of N digits. An error, or that there is none, is that of the double to which the 17 digits shown "
    "read back. Eigenvalues that integrals force to vanish are exactly zero.\n\n"
    "Verdicts:\n"
    "  stable, unstable, centre: of the linearization, and proved\n"
    "  not settled       the number of bits did not suffice for a proof\n\n"
    "The proof of a verdict covers:\n"
    "  that the equilibrium exists: by exact arithmetic with square roots, or by\n"
    "  Krawczyk's test\n"
    "  zero eigenvalues, and pairs on the imaginary axis: by exact polynomials, by\n"
    "  integrals, by zeros of the matrix, and by a reversor that leaves the\n"
    "  equilibrium where it is\n\n"
    "What follows for the motion itself is reported separately. It is often \"not settled\", as a linear centre may be a weak "
    "focus, and a zero eigenvalue may hide x' = x^2.\n\n"
    "A sweep does the same at the decimals that its rows show. With --fast, numbers and verdicts are those of doubles, and each "
    "eigenvalue has a bound on its error. A state is refused with status 3, and its residual is printed, if it is off every "
    "equilibrium by more than the rounding of its digits, or by a part of its distance from a pole.\n\n"
    "Columns of a sweep:\n"
    "  PARAM, STATE      what --sweep varies of the parameters; every state\n"
    "  residual          the largest rate of a state\n"
    "  trace, trace_formula: as computed; by the table's formula, if it has one\n"
    "  c1, c2, ...       of the characteristic polynomial x^n + c1 x^(n-1) + ...\n"
    "  re1, im1, error1, ...: eigenvalues, first those that integrals make zero,\n"
    "                    then ascending; bounds on their errors\n"
    "  verdict           as above, or refused\n\n"
    "Examples:\n"
    "  jellett eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1\n"
    "  jellett eigen --set a3=0,I1=2/5 --at v_nu=0.7,omega3=1.1 \\\n"
    "    --sweep gamma3=-0.99:0.99:201 --plot locus.svg\n"
    "  jellett eigen --at gamma3=-0.6,omega_n=1 --find --digits 50",
    children, NULL, NULL,
};

static jlt_exit single(jlt_eigen_request *r)
{
    jlt_eigen_row *row = calloc(1, sizeof *row);
    jlt_command_output output = { 0 };
    char reason[JLT_EIGEN_REASON_MAX];
    jlt_exit code = JLT_EXIT_NUMERICAL;

    if (row == NULL || jlt_command_open(&output) != JLT_OK) {
        free(row);
        return jlt_command_no_memory();
    }
    const jlt_eigen_rows one = { (const char *)row, sizeof *row, 1 };
    *row = (jlt_eigen_row){ .descriptor = r->question.descriptor, .params = r->params, .x = r->x };
    jlt_equilibrium_compute(&row->found, &r->question, r->params, r->x);
    if (row->found.status != JLT_OK) {
        jlt_eigen_reason(reason, row);
        const bool sought = row->found.stage == JLT_EQUILIBRIUM_SEARCH;
        code = jlt_command_fail(sought ? JLT_EXIT_NUMERICAL : jlt_command_exit(row->found.status), "%s", reason);
        goto done;
    }
    if (r->json) {
        if (jlt_eigen_write_json(output.stream, one, false) != JLT_OK) {
            code = jlt_command_no_memory();
            goto done;
        }
    } else if (r->csv) {
        jlt_eigen_write_csv(output.stream, r, one);
    } else {
        jlt_eigen_write_text(output.stream, row);
    }
    code = jlt_stream_deliver(&output, r->common.output);
    if (code == JLT_EXIT_DONE && r->common.plot != NULL) code = jlt_eigen_draw(r, one);
done:
    jlt_command_discard(&output);
    jlt_ball_texts_destroy(row->found.result.texts);
    free(row);
    return code;
}

/* Give the question the exact values of what was typed, and of the table's defaults, in place of their roundings. States that are
 * solved for stay doubles; each row of a sweep has values of its own. */
static jlt_exit take_exact(jlt_eigen_request *r)
{
    jlt_equilibrium_question *q = &r->question;
    const jlt_descriptor *d = q->descriptor;

    q->params = jlt_common_exact(&r->common, d, q->oracle->defaults);
    if (q->params == NULL) return jlt_command_no_memory();
    for (size_t i = 0; i < d->state_count; i++) q->x[i] = jlt_assign_fraction(&r->at, d->states[i].name);
    for (size_t i = 0; i < r->axis_count; i++)
        if (r->targets[i].is_state) q->given[r->targets[i].index] = 1;
    return JLT_EXIT_DONE;
}

/* Open the model, and look up the states of --at and the axes of --sweep by name. A search holds the states of the sweep first. */
static jlt_exit prepare(jlt_eigen_request *r)
{
    jlt_equilibrium_question *q = &r->question;
    const jlt_descriptor *d;

    JLT_PASS(jlt_common_open(&r->common, &q->descriptor, &r->params));
    d = q->descriptor;
    if (d->state_count > JLT_LINEARIZATION_SIZE_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s has %u states; eigen serves up to %d", d->model, d->state_count,
                                JLT_LINEARIZATION_SIZE_MAX);
    JLT_PASS(jlt_assign_apply(r->x, q->given, &r->at, d->states, d->state_count, "state", d->model));
    for (size_t i = 0; i < r->axis_count; i++) {
        jlt_eigen_target *target = &r->targets[i];
        target->is_state = jlt_descriptor_state(d, r->axes[i].name, &target->index);
        if (target->is_state)
            q->order[q->held++] = target->index;
        else if (!jlt_descriptor_param(d, r->axes[i].name, &target->index))
            return jlt_command_fail(JLT_EXIT_INPUT, "--sweep: %s has no state or parameter '%s'", d->model, r->axes[i].name);
    }
    for (size_t i = 0; i < r->at.count; i++) (void)jlt_descriptor_state(d, r->at.items[i].name, &q->order[q->held++]);
    if (jlt_oracle_create(&q->oracle, d, NULL) != JLT_OK)
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "cannot read the table of %s back: %s", d->model,
                                jlt_status_text(JLT_ERR_NOMEM));
    JLT_PASS(take_exact(r));
    return r->common.plan ? jlt_common_still() : JLT_EXIT_DONE;
}

static jlt_exit run(int argc, char **argv)
{
    jlt_eigen_request request = { .points = 0 };
    jlt_exit code;

    jlt_common_begin(&request.common, argc, argv);
    ttc_options_parse(&parser, argc, argv, &request);
    code = prepare(&request);
    if (code == JLT_EXIT_DONE) code = request.axis_count > 0 ? jlt_eigen_sweep(&request) : single(&request);
    free(request.params);
    free(request.question.params);
    jlt_oracle_destroy(request.question.oracle);
    jlt_assign_clear(&request.at);
    jlt_common_end(&request.common);
    return code;
}

const jlt_command jlt_command_eigen = {
    "eigen", "[MODEL] --at STATE=VALUE,... [OPTION...]",
    "An equilibrium: matrix, polynomial, eigenvalues, stability", run, &parser, NULL
};
