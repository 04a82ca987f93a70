#include "cli/eigen.h"

#include "kernel/descriptor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { KEY_FIND = 256, KEY_SWEEP };

static const struct argp_option option_table[] = {
    { "at", 'a', "NAME=VALUE,...", 0, "States of the equilibrium; those not named follow from its family, or are zero", 1 },
    { "find", KEY_FIND, NULL, 0, "Take the states as a guess, and go to an equilibrium nearby by Newton's method", 1 },
    { "sweep", KEY_SWEEP, "NAME=LOW:HIGH:COUNT,...", 0, "A row for each point of a grid in these states or parameters", 1 },
    { "json", 'j', NULL, 0, "Print JSON", 1 },
    { "csv", 'c', NULL, 0, "Print CSV with a comment header (a sweep does so by itself)", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_eigen_request *r = state->input;
    jlt_exit code = JLT_EXIT_DONE;

    switch (key) {
    case ARGP_KEY_INIT: state->child_inputs[0] = &r->common; break;
    case 'a': jlt_common_list(&r->at, value, "--at"); break;
    case KEY_FIND: r->find = true; break;
    case KEY_SWEEP: code = jlt_eigen_parse_sweep(r, value); break;
    case 'j': r->json = true; break;
    case 'c': r->csv = true; break;
    case ARGP_KEY_END:
        if (r->json && r->csv) argp_error(state, "--json and --csv exclude each other");
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
    "\vExamples:\n"
    "  jellett eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1\n"
    "  jellett eigen --set a3=0,I1=2/5 --at v_nu=0.7,omega3=1.1 \\\n"
    "    --sweep gamma3=-0.99:0.99:201 --plot locus.svg\n"
    "  jellett eigen --at gamma3=-0.6,omega_n=1 --find\n\n"
    "Values are read exactly (1/3, 0.51), and eigenvalues and verdict are those of the exact equilibrium, in ball arithmetic of "
    "as many bits as settle them (192 to 6144); where none do, they are those of doubles, each with a bound on its error, and "
    "the verdict is \"undecided\" where the bounds leave it open. Eigenvalues that integrals force to vanish are exactly zero. A "
    "state that is off every equilibrium by more than the rounding of its digits, or by a part of its distance from a pole, is "
    "refused with status 3, and its residual is said.",
    children, NULL, NULL,
};

static void explain(jlt_eigen_row *row, const char *text)
{
    snprintf(row->reason, sizeof row->reason, "%s", text);
}

/* Bounds on the errors of the Jacobian and of the integrals' gradients against the exact values typed. */
static jlt_status entry_errors(double *errors, double *gradient_errors, jlt_eigen_row *row, const double *params,
                               const double *x)
{
    const jlt_eigen_request *q = row->request;
    const size_t n = q->descriptor->state_count;
    ttc_enclosure *exact = calloc(n * n, sizeof *exact);
    jlt_status st = exact == NULL ? JLT_ERR_NOMEM : JLT_OK;

    if (st == JLT_OK) st = jlt_linearization_residual(&row->result, q->descriptor, params, x);
    if (st == JLT_OK) {
        const bool moved = q->find || q->axis_count > 0;
        jlt_oracle_set_params(q->oracle, params, q->axis_count > 0 ? NULL : &q->common.set);
        jlt_oracle_set_states(q->oracle, x, moved ? NULL : &q->at);
        st = jlt_oracle_enclose(q->oracle, exact, q->oracle->jacobian, n * n);
    }
    for (size_t i = 0; st == JLT_OK && i < n * n; i++) {
        errors[i] = jlt_oracle_error(row->result.jacobian[i], &exact[i]);
        if (!isfinite(errors[i])) st = JLT_ERR_NONFINITE;
    }
    free(exact);
    if (st != JLT_OK) return st;
    return jlt_oracle_gradient_errors(q->oracle, gradient_errors, row->result.gradients, row->result.descriptor->integrals,
                                      row->result.integrals);
}

void jlt_eigen_compute(jlt_eigen_row *row, const jlt_eigen_request *request, double *params, double *x,
                       const unsigned char *given)
{
    const jlt_descriptor *d = request->descriptor;
    double errors[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX];
    double gradient_errors[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX];
    size_t index = 0;

    row->request = request;
    row->params = params;
    row->x = x;
    row->reason[0] = '\0';
    row->status = jlt_descriptor_check_params(d, params, &index);
    if (row->status != JLT_OK) {
        snprintf(row->reason, sizeof row->reason, "%s = %.17g is no value that %s allows", d->params[index].name,
                 params[index], d->model);
        return;
    }
    jlt_linearization_complete(x, given, d, params);
    row->status = jlt_descriptor_check_state(d, x, &index);
    if (row->status != JLT_OK) {
        snprintf(row->reason, sizeof row->reason, "%s = %.17g lies outside (%g, %g), where %s is defined", d->states[index].name,
                 x[index], d->states[index].low, d->states[index].high, d->model);
        return;
    }
    if (request->find) row->status = jlt_linearization_find(x, d, params, request->order, request->held);
    if (row->status != JLT_OK) {
        explain(row, "Newton's method finds no equilibrium from here (try another guess with --at)");
        return;
    }
    row->status = entry_errors(errors, gradient_errors, row, params, x);
    if (row->status == JLT_OK)
        row->status = jlt_linearization_compute(&row->result, d, params, x, errors, gradient_errors);
    /* Where balls settle nothing, the report is what doubles know. */
    if (row->status == JLT_OK && jlt_eigen_enclose(row) == JLT_ERR_NOMEM) row->status = JLT_ERR_NOMEM;
    if (row->status == JLT_ERR_EMPTY)
        snprintf(row->reason, sizeof row->reason,
                 "this state is no equilibrium: residual %.6g, relative %.3g (--find looks for one nearby)",
                 row->result.residual, row->result.residual_ratio);
    else if (row->status == JLT_ERR_NONFINITE)
        explain(row, "a value overflows or underflows on the way: use units in which parameters and states are nearer one");
    else if (row->status == JLT_ERR_DOMAIN)
        explain(row, "the field has a pole at this state");
    else if (row->status != JLT_OK) explain(row, jlt_status_text(row->status));
}

static jlt_exit single(jlt_eigen_request *r)
{
    jlt_eigen_row *row = calloc(1, sizeof *row);
    jlt_command_output output = { 0 };
    jlt_exit code = JLT_EXIT_NUMERICAL;

    if (row == NULL || jlt_command_open(&output) != JLT_OK) {
        free(row);
        return jlt_command_no_memory();
    }
    jlt_eigen_compute(row, r, r->params, r->x, r->given);
    if (row->status != JLT_OK) {
        code = jlt_command_fail(jlt_command_exit(row->status), "%s", row->reason);
        goto done;
    }
    if (r->json) {
        if (jlt_eigen_write_json(output.stream, row, 1, false) != JLT_OK) {
            code = jlt_command_no_memory();
            goto done;
        }
    } else if (r->csv) {
        jlt_eigen_write_csv_header(output.stream, r);
        jlt_eigen_write_csv_row(output.stream, row);
    } else {
        jlt_eigen_write_text(output.stream, row);
    }
    code = jlt_command_deliver(&output, r->common.output);
    if (code == JLT_EXIT_DONE && r->common.plot != NULL) code = jlt_eigen_draw(r, row, 1);
done:
    jlt_command_discard(&output);
    free(row);
    return code;
}

/* The list of states as given, the axes by name. */
static jlt_exit prepare(jlt_eigen_request *r)
{
    const jlt_descriptor *d;
    jlt_exit code = jlt_common_open(&r->common, &r->descriptor, &r->params);
    if (code == JLT_EXIT_DONE && r->common.plan) code = jlt_common_still();

    if (code != JLT_EXIT_DONE) return code;
    d = r->descriptor;
    if (d->state_count > JLT_LINEARIZATION_SIZE_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s has %u states; eigen serves up to %d", d->model, d->state_count,
                                JLT_LINEARIZATION_SIZE_MAX);
    code = jlt_assign_apply(r->x, r->given, &r->at, d->states, d->state_count, "state", d->model);
    if (code != JLT_EXIT_DONE) return code;
    for (size_t i = 0; i < r->at.count; i++) {
        size_t index = 0, known = 0;
        (void)jlt_descriptor_state(d, r->at.items[i].name, &index);
        while (known < r->held && r->order[known] != index) known++;
        if (known == r->held) r->order[r->held++] = index;
    }
    for (size_t i = 0; i < r->axis_count; i++) {
        jlt_eigen_target *target = &r->targets[i];
        target->is_state = jlt_descriptor_state(d, r->axes[i].name, &target->index);
        if (!target->is_state && !jlt_descriptor_param(d, r->axes[i].name, &target->index))
            return jlt_command_fail(JLT_EXIT_INPUT, "--sweep: %s has no state or parameter '%s'", d->model, r->axes[i].name);
    }
    if (jlt_oracle_create(&r->oracle, d) != JLT_OK)
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "cannot read the table of %s back: %s", d->model,
                                jlt_status_text(JLT_ERR_NOMEM));
    return JLT_EXIT_DONE;
}

void jlt_eigen_clear(jlt_eigen_request *request)
{
    free(request->params);
    jlt_common_end(&request->common);
    jlt_assign_clear(&request->at);
    jlt_oracle_destroy(request->oracle);
}

static jlt_exit run(int argc, char **argv)
{
    jlt_eigen_request request = { .axis_count = 0 };
    jlt_exit code;

    jlt_common_begin(&request.common, argc, argv);
    argp_parse(&parser, argc, argv, 0, NULL, &request);
    code = prepare(&request);
    if (code == JLT_EXIT_DONE) code = request.axis_count > 0 ? jlt_eigen_sweep(&request) : single(&request);
    jlt_eigen_clear(&request);
    return code;
}

const jlt_command jlt_command_eigen = {
    "eigen", "[MODEL] --set NAME=VALUE,... --at NAME=VALUE,... [--find] [--sweep ...] [--json|--csv] [--plot FILE]",
    "Report on an equilibrium: matrix, characteristic polynomial, eigenvalues, stability", run
};
