/* Writes the results of `jellett eigen` as text, JSON and CSV. */
#include "cli/eigen.h"

#include "analysis/family.h"
#include "core/digits.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "report/decimal.h"
#include "report/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *source_of(const jlt_linearization *r, const jlt_eigenvalue *value)
{
    return value->source < 0 ? NULL : r->sources[value->source];
}

static const char *consequence(const jlt_linearization *r)
{
    if (r->obstructs)
        return r->exists ? "the trace is not zero: no invariant measure has a smooth positive density around this equilibrium"
                         : "the trace is not zero here, but that an equilibrium with such a trace exists is not proved: nothing "
                           "follows";
    return r->trace_error > 0.0 ? "the trace is zero to within its error, and excludes no invariant measure"
                                : "the trace is zero, and excludes no invariant measure";
}

void jlt_eigen_reason(char *text, const jlt_eigen_row *row)
{
    const jlt_descriptor *d = row->descriptor;
    const jlt_equilibrium *e = &row->found;
    const size_t size = JLT_EIGEN_REASON_MAX;
    char digits[JLT_DIGITS_SIZE];

    if (e->stage == JLT_EQUILIBRIUM_PARAMS) {
        jlt_digits_shortest(digits, row->params[e->index]);
        snprintf(text, size, "%s = %s is no value that %s allows", d->params[e->index].name, digits, d->model);
    } else if (e->stage == JLT_EQUILIBRIUM_STATES) {
        const jlt_quantity *q = &d->states[e->index];
        jlt_digits_shortest(digits, row->x[e->index]);
        snprintf(text, size, "%s = %s lies outside (%g, %g), where %s is defined", q->name, digits, q->low, q->high, d->model);
    } else if (e->stage == JLT_EQUILIBRIUM_DOMAIN && e->status == JLT_ERR_DOMAIN)
        snprintf(text, size, "this state lies outside the domain of %s: %s needs %s, and it is %.10g here", d->model,
                 e->region->name, e->region->text, e->region_value);
    else if (e->stage == JLT_EQUILIBRIUM_DIGITS)
        snprintf(text, size, "no number of digits can be given here: %s",
                 e->status == JLT_ERR_NO_CONVERGENCE
                     ? "eigenvalues are multiple, or too close together, and there are no exact numbers (leave --digits out)"
                     : jlt_status_text(e->status));
    else if (e->stage == JLT_EQUILIBRIUM_SEARCH)
        snprintf(text, size, "Newton's method finds no equilibrium from here (try another guess with --at)");
    else if (e->status == JLT_ERR_EMPTY) {
        const jlt_equilibria *refuted = jlt_family_refuted(d);
        char relative[32] = "";
        if (isfinite(e->result.residual_ratio)) snprintf(relative, sizeof relative, ", relative %.3g", e->result.residual_ratio);
        snprintf(text, size, "this state is no equilibrium: residual %.6g%s (--at gives its states; --find looks for one "
                             "nearby)%s%s%s", e->result.residual, relative,
                 refuted != NULL ? "; the family " : "", refuted != NULL ? refuted->name : "",
                 refuted != NULL ? " is refuted, and gives none" : "");
    }
    else if (e->status == JLT_ERR_NONFINITE)
        snprintf(text, size, "a value overflows or underflows on the way: use units in which parameters and states are nearer "
                             "one");
    else if (e->status == JLT_ERR_DOMAIN)
        snprintf(text, size, "the field or its Jacobian divides here by what is 0, or underflows");
    else snprintf(text, size, "%s", jlt_status_text(e->status));
}

/* Write a number in a column of this width: the decimal text if there is one (--digits), else the double. */
static void write_number(FILE *stream, int width, int precision, const char *decimal, double value)
{
    if (decimal != NULL) fprintf(stream, "%*s", width, decimal);
    else fprintf(stream, "%*.*g", width, precision, value);
}

/* Write NAME=VALUE for all quantities: the decimals, shape (count,), or, if NULL, the fewest digits that read back. */
static void write_values(FILE *stream, const char *title, const jlt_quantity *quantities, const double *values,
                         char *const *decimals, size_t count)
{
    fprintf(stream, "%-12s", title);
    if (decimals == NULL) jlt_decimal_write_named(stream, quantities, values, count);
    for (size_t i = 0; decimals != NULL && i < count; i++) fprintf(stream, " %s=%s", quantities[i].name, decimals[i]);
    fputc('\n', stream);
}

static void write_eigenvalue(FILE *stream, const jlt_linearization *r, size_t which)
{
    const jlt_eigenvalue *value = &r->eigen.values[which];
    const jlt_ball_texts *texts = r->texts;
    const char *source = source_of(r, value);
    char number[80];

    if (source != NULL) {
        fprintf(stream, "  %-48s by the integral %s\n", "0 exactly", source);
        return;
    }
    if (texts != NULL) {
        const char *im = texts->im[which];
        fprintf(stream, "  %s", texts->re[which]);
        if (strcmp(im, "0") != 0) fprintf(stream, " %s%si", *im == '-' ? "" : "+", im);
    } else {
        if (value->im == 0.0) snprintf(number, sizeof number, "%.17g", value->re);
        else snprintf(number, sizeof number, "%.17g %+.17gi", value->re, value->im);
        fprintf(stream, "  %-48s ", number);
        jlt_decimal_write_error(stream, value->error);
    }
    fputs(texts != NULL ? "   condition " : ", condition ", stream);
    if (isfinite(value->condition)) fprintf(stream, "%.3g\n", value->condition);
    else fputs(isnan(value->condition) ? "not defined\n" : "infinite: defective\n", stream);
}

/* What the table's formula of this kind for the family is worth, after its value. */
static const char *standing(const jlt_descriptor *d, const jlt_linearization *r, const char *kind)
{
    static const char *const words[] = { [JLT_PROVED] = "", [JLT_REFUTED] = ", a refuted claim", [JLT_UNSETTLED] = ", not proved" };
    const jlt_claim *claim = r->family == NULL ? NULL : jlt_descriptor_claim(d, kind, r->family->name);
    return claim == NULL ? "" : words[claim->verdict];
}

static void write_matrix(FILE *stream, const jlt_descriptor *d, const jlt_linearization *r)
{
    const size_t n = r->n;

    fputs("\nJacobian\n", stream);
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) {
            fputc(' ', stream);
            write_number(stream, r->texts == NULL ? 24 : 0, 16, r->texts == NULL ? NULL : r->texts->jacobian[i * n + j],
                         r->jacobian[i * n + j]);
        }
        fputc('\n', stream);
    }
    fputs("\ncharacteristic polynomial, highest power first\n", stream);
    for (size_t k = 0; k <= n; k++) {
        fprintf(stream, "  lambda^%-2zu ", n - k);
        write_number(stream, r->texts == NULL ? 24 : 0, 17, r->texts == NULL ? NULL : r->texts->charpoly[k], r->charpoly[k]);
        if (r->texts == NULL && r->charpoly_error[k] > 0.0) {
            fputs("   ", stream);
            jlt_decimal_write_error(stream, r->charpoly_error[k]);
        }
        if (!isnan(r->charpoly_formula[k]))
            fprintf(stream, "   formula %.17g%s", r->charpoly_formula[k], standing(d, r, "charpoly"));
        fputc('\n', stream);
    }
    fputs("\ntrace        ", stream);
    write_number(stream, 0, 17, r->texts == NULL ? NULL : r->texts->trace, r->trace);
    if (r->texts == NULL) fputs(", ", stream);
    if (r->texts == NULL) jlt_decimal_write_error(stream, r->trace_error);
    if (!isnan(r->trace_formula)) fprintf(stream, "; formula %.17g%s", r->trace_formula, standing(d, r, "trace"));
    fputc('\n', stream);
}

static void write_verdict(FILE *stream, const jlt_linearization *r)
{
    fprintf(stream, "\nverdict      %s", jlt_linearization_verdict(r->verdict));
    if (r->verdict == JLT_UNDECIDED) fprintf(stream, " at %ld bits", r->precision);
    else if (!r->proved) fputs(", not proved", stream);
    fprintf(stream, "\nmotion       %s%s", jlt_linearization_motion(r->motion),
            r->motion == JLT_MOTION_OPEN ? " by the linearization" : "");
    fprintf(stream, "\nmeasure      %s\n", consequence(r));
}

void jlt_eigen_write_text(FILE *stream, const jlt_eigen_row *row)
{
    const jlt_descriptor *d = row->descriptor;
    const jlt_linearization *r = &row->found.result;

    fprintf(stream, "%s%s%s\n", d->model, *d->title == '\0' ? "" : ": ", d->title);
    fprintf(stream, "kernels      %s, table %.12s\n", r->descriptor->variant[0] == '\0' ? "general" : r->descriptor->variant,
            d->sha256);
    write_values(stream, "parameters", d->params, row->params, r->texts == NULL ? NULL : r->texts->param, d->param_count);
    write_values(stream, "state", d->states, row->x, r->texts == NULL ? NULL : r->texts->state, r->n);
    fprintf(stream, "family       %s%s%s\n", r->family == NULL ? "none of the table" : r->family->name,
            r->family == NULL || r->family->condition[0] == '\0' ? "" : ", when ",
            r->family == NULL ? "" : r->family->condition);
    fprintf(stream, "residual     %.3g (relative %.2g; refused above %.0e)\n", r->residual, r->residual_ratio,
            JLT_LINEARIZATION_TOLERANCE);
    write_matrix(stream, d, r);
    fprintf(stream, "\neigenvalues, with %ld bits%s\n", r->precision,
            r->texts != NULL && !r->sure ? ", which leave digits open: they are left out, and 0 may be small" : "");
    for (size_t i = 0; i < r->n; i++) write_eigenvalue(stream, r, i);
    if (r->eigen.defective_zero && r->verdict == JLT_UNSTABLE)
        fputs("  zero is defective: perturbations grow at least linearly in time\n", stream);
    fputs("  other routes in doubles, relative to the matrix: ", stream);
    if (!isnan(r->eigen.lapack_difference))
        fprintf(stream, "LAPACK on the deflated block %.2g, LAPACK on the whole %.2g, ", r->eigen.lapack_difference,
                r->eigen.plain_difference);
    fputs("ARPACK ", stream);
    if (isnan(r->eigen.arpack_difference)) fprintf(stream, "not used (%s)\n", r->eigen.arpack_note);
    else fprintf(stream, "%.2g\n", r->eigen.arpack_difference);
    write_verdict(stream, r);
}

static json_t *eigenvalues_json(const jlt_linearization *r)
{
    json_t *array = json_array();

    for (size_t i = 0; i < r->n; i++) {
        const jlt_eigenvalue *value = &r->eigen.values[i];
        json_array_append_new(array, json_pack("{s:o,s:o,s:o,s:o,s:o}", "re", jlt_json_number(value->re), "im",
                                               jlt_json_number(value->im), "condition", jlt_json_number(value->condition),
                                               "error", jlt_json_number(value->error), "integral",
                                               jlt_json_string(source_of(r, value))));
    }
    return array;
}

static json_t *texts_json(char *const *texts, size_t count)
{
    json_t *array = json_array();

    for (size_t i = 0; i < count; i++) json_array_append_new(array, json_string(texts[i]));
    return array;
}

static json_t *named_texts_json(const jlt_quantity *quantities, char *const *texts, size_t count)
{
    json_t *o = json_object();

    for (size_t i = 0; i < count; i++) json_object_set_new(o, quantities[i].name, json_string(texts[i]));
    return o;
}

/* The same numbers as strings of decimal digits. */
static json_t *decimals_json(const jlt_descriptor *d, const jlt_linearization *r)
{
    const jlt_ball_texts *t = r->texts;
    json_t *o = json_object(), *jacobian = json_array();

    for (size_t i = 0; i < t->n; i++) json_array_append_new(jacobian, texts_json(t->jacobian + i * t->n, t->n));
    json_object_set_new(o, "digits", json_integer(t->digits));
    json_object_set_new(o, "sure", json_boolean(r->sure));
    json_object_set_new(o, "parameters", named_texts_json(d->params, t->param, t->params));
    json_object_set_new(o, "state", named_texts_json(d->states, t->state, t->n));
    json_object_set_new(o, "jacobian", jacobian);
    json_object_set_new(o, "charpoly", texts_json(t->charpoly, t->n + 1));
    json_object_set_new(o, "trace", json_string(t->trace));
    json_object_set_new(o, "re", texts_json(t->re, t->n));
    json_object_set_new(o, "im", texts_json(t->im, t->n));
    return o;
}

static json_t *row_json(const jlt_eigen_row *row)
{
    const jlt_descriptor *d = row->descriptor;
    const jlt_linearization *r = &row->found.result;
    const size_t n = d->state_count;
    json_t *o = json_object();
    char reason[JLT_EIGEN_REASON_MAX];

    json_object_set_new(o, "model", json_string(d->model));
    json_object_set_new(o, "sha256", json_string(d->sha256));
    json_object_set_new(o, "parameters", jlt_json_named(d->params, row->params, d->param_count));
    json_object_set_new(o, "state", jlt_json_named(d->states, row->x, n));
    if (row->found.status != JLT_OK) {
        jlt_eigen_reason(reason, row);
        json_object_set_new(o, "refused", json_string(reason));
        return o;
    }
    json_object_set_new(o, "variant", json_string(r->descriptor->variant));
    if (d->unproved != NULL) json_object_set_new(o, "unproved", json_string(d->unproved));
    json_object_set_new(o, "family", jlt_json_string(r->family == NULL ? NULL : r->family->name));
    json_object_set_new(o, "residual", jlt_json_number(r->residual));
    json_object_set_new(o, "residual_relative", jlt_json_number(r->residual_ratio));
    json_object_set_new(o, "jacobian", jlt_json_matrix(r->jacobian, n, n));
    json_object_set_new(o, "charpoly", jlt_json_numbers(r->charpoly, n + 1));
    json_object_set_new(o, "charpoly_error", jlt_json_numbers(r->charpoly_error, n + 1));
    json_object_set_new(o, "charpoly_formula",
                        isnan(r->charpoly_formula[0]) ? json_null() : jlt_json_numbers(r->charpoly_formula, n + 1));
    json_object_set_new(o, "trace", jlt_json_number(r->trace));
    json_object_set_new(o, "trace_error", jlt_json_number(r->trace_error));
    json_object_set_new(o, "trace_formula", jlt_json_number(r->trace_formula));
    json_object_set_new(o, "eigenvalues", eigenvalues_json(r));
    json_object_set_new(o, "precision_bits", json_integer(r->precision));
    json_object_set_new(o, "defective_zero", json_boolean(r->eigen.defective_zero));
    json_object_set_new(o, "left_null_defect", jlt_json_number(r->eigen.defect));
    json_object_set_new(o, "lapack_difference", jlt_json_number(r->eigen.lapack_difference));
    json_object_set_new(o, "lapack_undeflated_difference", jlt_json_number(r->eigen.plain_difference));
    json_object_set_new(o, "arpack_difference", jlt_json_number(r->eigen.arpack_difference));
    json_object_set_new(o, "arpack_note", json_string(r->eigen.arpack_note));
    json_object_set_new(o, "verdict", json_string(jlt_linearization_verdict(r->verdict)));
    json_object_set_new(o, "verdict_proved", json_boolean(r->proved));
    json_object_set_new(o, "motion", json_string(jlt_linearization_motion(r->motion)));
    if (r->texts != NULL) json_object_set_new(o, "decimals", decimals_json(d, r));
    json_object_set_new(o, "measure_excluded", json_boolean(r->obstructs && r->exists));
    json_object_set_new(o, "measure", json_string(consequence(r)));
    return o;
}

jlt_status jlt_eigen_write_json(FILE *stream, jlt_eigen_rows rows, bool array)
{
    json_t *value = array ? json_array() : row_json(jlt_eigen_row_at(rows, 0));

    for (size_t k = 0; array && k < rows.count; k++) json_array_append_new(value, row_json(jlt_eigen_row_at(rows, k)));
    return jlt_json_write(stream, value);
}

static void write_csv_header(FILE *stream, const jlt_eigen_request *request)
{
    const jlt_descriptor *d = request->question.descriptor;
    jlt_csv_names names;

    for (size_t i = 0; i < request->axis_count; i++) /* swept: its value changes from row to row, and rows have copies of it */
        if (!request->targets[i].is_state) request->params[request->targets[i].index] = NAN;
    jlt_csv_header(stream, &(jlt_csv_settings){ .command = request->common.command, .descriptor = d, .params = request->params });
    fputs("# eigenvalues: first those that integrals make zero, then ascending; error_k bounds the error of the k-th\n", stream);
    if (request->question.fast) fputs("# doubles alone: verdicts are not proved\n", stream);
    FILE *line = jlt_csv_names_begin(&names, stream);
    for (size_t i = 0; i < request->axis_count; i++)
        if (!request->targets[i].is_state) fprintf(line, "%s,", request->axes[i].name);
    for (unsigned i = 0; i < d->state_count; i++) fprintf(line, "%s,", d->states[i].name);
    fputs("residual,trace,trace_formula", line);
    for (unsigned k = 1; k <= d->state_count; k++) fprintf(line, ",c%u", k);
    for (unsigned k = 1; k <= d->state_count; k++) fprintf(line, ",re%u,im%u,error%u", k, k, k);
    fputs(",verdict", line);
    jlt_csv_names_end(&names);
}

static void field(FILE *stream, double value)
{
    jlt_csv_value(stream, value);
    fputc(',', stream);
}

static void write_csv_row(FILE *stream, const jlt_eigen_request *q, const jlt_eigen_row *row)
{
    const jlt_linearization *r = &row->found.result;
    const size_t n = row->descriptor->state_count;
    const bool good = row->found.status == JLT_OK;

    for (size_t i = 0; i < q->axis_count; i++)
        if (!q->targets[i].is_state) field(stream, row->params[q->targets[i].index]);
    for (size_t i = 0; i < n; i++) field(stream, row->x[i]);
    field(stream, good || row->found.status == JLT_ERR_EMPTY ? r->residual : NAN);
    field(stream, good ? r->trace : NAN);
    field(stream, good ? r->trace_formula : NAN);
    for (size_t k = 1; k <= n; k++) field(stream, good ? r->charpoly[k] : NAN);
    for (size_t k = 0; k < n; k++) {
        field(stream, good ? r->eigen.values[k].re : NAN);
        field(stream, good ? r->eigen.values[k].im : NAN);
        field(stream, good ? r->eigen.values[k].error : NAN);
    }
    fprintf(stream, "%s\n", good ? jlt_linearization_verdict(r->verdict) : "refused");
}

void jlt_eigen_write_csv(FILE *stream, const jlt_eigen_request *request, jlt_eigen_rows rows)
{
    write_csv_header(stream, request);
    for (size_t k = 0; k < rows.count; k++) write_csv_row(stream, request, jlt_eigen_row_at(rows, k));
}
