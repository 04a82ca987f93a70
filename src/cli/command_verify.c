/* `jellett verify`: proves the model's claims, and compares them with what the compiled kernels compute. */
#include "base/options.h"
#include "claims/sample.h"
#include "claims/verify.h"
#include "cli/common.h"
#include "cli/interrupt.h"
#include "cli/table.h"
#include "report/decimal.h"
#include "report/json.h"
#include "top/top.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char *variant_name(const jlt_descriptor *d)
{
    return d->variant[0] == '\0' ? "general field" : d->variant;
}

static const char *verdict(bool holds)
{
    return holds ? "holds" : "FAILS";
}

static void write_proofs(FILE *stream, const ttc_proof_report *r)
{
    fprintf(stream, "(a) Exact proofs over Q(parameters)(states, roots)\n\n");
    for (size_t i = 0; i < r->proof_count; i++) {
        const ttc_proof *p = &r->proofs[i];
        fprintf(stream, "  %-11s %-11s %s\n", ttc_proof_status_name(p->status), p->kind, p->name);
        if (p->remainder != NULL)
            fprintf(stream, "              %s:%u: %s\n", r->file, (unsigned)p->place.line, p->remainder);
        if (p->status == TTC_REFUTED && p->point != NULL) fprintf(stream, "              false at %s\n", p->point);
        if (p->note != NULL && !p->has_smooth_density) fprintf(stream, "              no smooth positive density: %s\n", p->note);
    }
    fprintf(stream, "\n  %zu of %zu proved\n", r->proved, r->proof_count);
}

static void write_family(FILE *stream, const jlt_verify_family *f)
{
    if (f->family == NULL) fprintf(stream, "\n  the whole domain: %zu points", f->samples);
    else fprintf(stream, "\n  family %s%s%s: %zu points", f->family->name, f->family->condition[0] == '\0' ? "" : ", when ",
                 f->family->condition, f->samples);
    if (f->refused > 0) fprintf(stream, ", %zu refused for overflow or underflow", f->refused);
    fprintf(stream, "\n\n    %-66s %9s %9s %9s %11s\n", "", "numbers", "error/ulp", "bound/ulp", "digits lost");
    for (size_t i = 0; i < f->check_count; i++) {
        const jlt_verify_check *c = &f->checks[i];
        char lost[16] = "-";
        if (c->lost > 0.0) snprintf(lost, sizeof lost, "%.0f", c->lost);
        if (c->lost > DBL_DIG) snprintf(lost, sizeof lost, "all");
        fprintf(stream, "    %-66s %9zu %9.3g %9.3g %11s  %s\n", c->name, c->compared, c->error_ulp, c->bound_ulp, lost,
                verdict(c->worst_part <= 1.0));
    }
    if (f->samples == f->refused)
        fprintf(stream, "    nothing could be compared%s\n", f->samples > 0 || f->family != NULL ? ": FAILS" : "");
    if (f->family == NULL) return;
    fprintf(stream,
            "    eigenvalues by other routes, largest difference relative to the matrix (measured, not judged: they lose half\n"
            "    the digits where zero is defective): LAPACK without deflation %.2g, ARPACK %.2g at %zu kernels\n",
            f->lapack_worst, f->arpack_worst, f->arpack_used);
}

static void write_certificate(FILE *stream, const jlt_verify_certificate *c)
{
    if (c->point == NULL) {
        fprintf(stream, "    %s: no rational point of the domain was found where f = 0 exactly: no certificate\n", c->family->name);
        return;
    }
    fprintf(stream, "    %s at %s\n      f = 0 exactly; trace = %s\n      in %s, zero %s: %s\n", c->family->name, c->point,
            c->trace == NULL ? "irrational" : c->trace, c->enclosure == NULL ? "?" : c->enclosure,
            c->excludes_zero ? "excluded" : "not excluded", verdict(c->exact && c->excludes_zero));
}

static void write_density(FILE *stream, const jlt_verify_density *d)
{
    const jlt_descriptor *k = d->descriptor;
    const jlt_measure_attempt *a = &d->attempt;

    fprintf(stream, "    %s at", variant_name(k));
    jlt_decimal_write_named(stream, k->params, d->params, k->param_count);
    fputc('\n', stream);
    if (d->status != JLT_OK) {
        fprintf(stream, "      not computed: %s: FAILS\n", jlt_status_text(d->status));
        return;
    }
    if (!a->found) {
        fprintf(stream, "      no density of one state q alone: at fixed q, -div f/f_q varies with the other states, relative to "
                        "its size, by\n      ");
        jlt_decimal_write_rounded(stream, k->states, a->defects, k->state_count);
        fputc('\n', stream);
    } else {
        fprintf(stream, "      density of %s alone: -div f/f_q is a function of it (defect %.2g)\n", k->states[a->along].name,
                a->defect);
        if (a->singular)
            fprintf(stream, "      it is singular where %s' = 0: no smooth positive density\n", k->states[a->along].name);
        if (a->turn != 1.0)
            fprintf(stream, "      it changes by the factor %.6g in a period of %s: no density of an angle\n", a->turn,
                    k->states[a->along].name);
        if (a->closed_form != NULL)
            fprintf(stream, "      by quadrature, against the closed form %s: difference %.2g, bound %.2g: %s\n",
                    a->closed_form, a->difference, a->difference_bound, verdict(a->difference <= a->difference_bound));
    }
    if (d->contradicted) fputs("      an equilibrium of the table excludes it: FAILS\n", stream);
    if (k->measure_count > 0)
        fprintf(stream, "      div(rho f) of the table's density: %.2g of its terms, bound %.0e: %s\n", d->residual,
                JLT_DENSITY_TOLERANCE, verdict(d->residual <= JLT_DENSITY_TOLERANCE));
}

static void report_text(FILE *stream, const jlt_verify_run *run)
{
    const jlt_descriptor *d = run->descriptor;

    fprintf(stream, "%s%s%s\ntable %s, %s; seed %llu, %zu samples\n\n", d->model, *d->title == '\0' ? "" : ": ", d->title,
            d->sha256, d->generator, (unsigned long long)run->seed, run->samples);
    write_proofs(stream, run->proofs);
    fprintf(stream, "\n(b) The compiled kernels, on the domain and on families of equilibria\n");
    if (d->state_count > JLT_SAMPLE_STATES_MAX)
        fprintf(stream, "\n  the domain: not compared, as the table has more than %d states\n", JLT_SAMPLE_STATES_MAX);
    else write_family(stream, &run->domain);
    if (run->family_count == 0) fprintf(stream, "\n  the table has no family of equilibria\n");
    for (size_t i = 0; i < run->family_count; i++) write_family(stream, &run->families[i]);
    if (run->domain.check_count > 0)
        fprintf(stream,
                "\n  Shown is the error that comes closest to its bound. An ulp is 2^-53 of all that is rounded on the way to a "
                "number,\n"
                "  in modulus and with the weight it has there, so that errors count roundings. Bounds are derived at each point:\n"
                "  4 ulp for an expression rearranged, 8 for two, 16 multiplied out or in complex arithmetic, 4k(n+3) for\n"
                "  the k-th coefficient of a polynomial, and for eigenvalues what their condition numbers give, which is much\n"
                "  where two nearly meet.\n"
                "  Digits lost: those that an ulp has more than 2^-53 of the number itself, where it has most, because terms\n"
                "  cancel in the table's own formula. The points come within 1e-12 of the poles, and sizes range over 1e-8 to "
                "1e8.\n");
    if (run->certificate_count > 0) fprintf(stream, "\n  certificates that no invariant measure has a smooth positive density\n\n");
    else fprintf(stream, "\n  no family is claimed to exclude an invariant measure, and no certificate is sought\n");
    for (size_t i = 0; i < run->certificate_count; i++) write_certificate(stream, &run->certificates[i]);
    fprintf(stream, "\n(c) Invariant density from the generated divergence\n\n");
    if (run->density_count == 0)
        fprintf(stream, "    not computed: densities are compared in tables of up to %d states, with up to %d records 'measure'\n",
                JLT_MEASURE_STATES_MAX, JLT_MEASURE_CLAIMS_MAX);
    for (size_t i = 0; i < run->density_count; i++) write_density(stream, &run->densities[i]);
    fprintf(stream, "\n(d) %s: %zu checks hold, %zu fail\n", d->model, run->held, run->failed);
}

static json_t *proofs_json(const ttc_proof_report *r)
{
    json_t *array = json_array();

    for (size_t i = 0; i < r->proof_count; i++) {
        const ttc_proof *p = &r->proofs[i];
        json_array_append_new(array, json_pack("{s:s,s:s,s:i,s:s,s:o,s:o,s:o,s:b}", "name", p->name, "kind", p->kind, "line",
                                               (int)p->place.line, "status", ttc_proof_status_name(p->status), "remainder",
                                               jlt_json_string(p->remainder), p->status == TTC_PROVED ? "witness" : "point",
                                               jlt_json_string(p->point), "note", jlt_json_string(p->note), "relies_on_solver",
                                               p->relies_on_solver ? 1 : 0));
    }
    return array;
}

static json_t *family_json(const jlt_verify_family *f)
{
    json_t *checks = json_array();

    for (size_t i = 0; i < f->check_count; i++) {
        const jlt_verify_check *c = &f->checks[i];
        json_array_append_new(checks, json_pack("{s:s,s:s,s:I,s:o,s:o,s:o,s:o,s:b}", "name", c->name, "bound", c->bound,
                                                "numbers", (json_int_t)c->compared, "error_ulp",
                                                jlt_json_number(c->error_ulp), "bound_ulp", jlt_json_number(c->bound_ulp),
                                                "error_part_of_bound", jlt_json_number(c->worst_part), "digits_lost",
                                                jlt_json_number(c->lost), "holds", c->worst_part <= 1.0));
    }
    return json_pack("{s:s*,s:s*,s:I,s:I,s:o,s:o,s:o}", "family", f->family != NULL ? f->family->name : NULL, "when",
                     f->family != NULL ? f->family->condition : NULL, "samples",
                     (json_int_t)f->samples, "refused", (json_int_t)f->refused, "checks", checks,
                     "lapack_undeflated_difference", jlt_json_number(f->lapack_worst), "arpack_difference",
                     jlt_json_number(f->arpack_used > 0 ? f->arpack_worst : NAN));
}

static json_t *certificate_json(const jlt_verify_certificate *c)
{
    return json_pack("{s:s,s:o,s:b,s:o,s:o,s:b}", "family", c->family->name, "point", jlt_json_string(c->point),
                     "field_is_exactly_zero", c->exact, "trace", jlt_json_string(c->trace), "trace_enclosure",
                     jlt_json_string(c->enclosure), "excludes_zero", c->excludes_zero);
}

static json_t *density_json(const jlt_verify_density *d)
{
    const jlt_descriptor *k = d->descriptor;
    const jlt_measure_attempt *a = &d->attempt;
    const bool compared = a->closed_form != NULL;

    return json_pack("{s:s,s:o,s:s,s:s,s:o,s:o,s:b,s:b,s:o,s:b,s:o,s:o,s:o,s:o}", "variant", k->variant, "parameters",
                     jlt_json_named(k->params, d->params, k->param_count), "status", jlt_status_text(d->status), "along",
                     k->states[a->along].name, "defect", jlt_json_number(a->defect), "defects",
                     jlt_json_named(k->states, a->defects, k->state_count), "found", a->found, "singular", a->singular, "turn",
                     jlt_json_number(a->turn), "contradicted", d->contradicted, "closed_form",
                     jlt_json_string(a->closed_form), "difference", jlt_json_number(compared ? a->difference : NAN),
                     "difference_bound", jlt_json_number(compared ? a->difference_bound : NAN), "residual",
                     jlt_json_number(k->measure_count > 0 ? d->residual : NAN));
}

static jlt_status report_json(FILE *stream, const jlt_verify_run *run)
{
    const jlt_descriptor *d = run->descriptor;
    json_t *families = json_array(), *certificates = json_array(), *densities = json_array();

    for (size_t i = 0; i < run->family_count; i++) json_array_append_new(families, family_json(&run->families[i]));
    for (size_t i = 0; i < run->certificate_count; i++)
        json_array_append_new(certificates, certificate_json(&run->certificates[i]));
    for (size_t i = 0; i < run->density_count; i++) json_array_append_new(densities, density_json(&run->densities[i]));
    return jlt_json_write(stream, json_pack("{s:s,s:s,s:I,s:I,s:o,s:o,s:o,s:o,s:o,s:{s:I,s:I}}", "model", d->model, "sha256",
                                            d->sha256, "seed", (json_int_t)run->seed, "samples", (json_int_t)run->samples,
                                            "proofs", proofs_json(run->proofs), "domain", family_json(&run->domain), "families",
                                            families, "certificates", certificates, "densities", densities, "totals", "held",
                                            (json_int_t)run->held, "failed", (json_int_t)run->failed));
}

enum { KEY_SEED = 256, KEY_SAMPLES, SAMPLES_DEFAULT = 400, SAMPLES_MAX = 10000000 };

typedef struct {
    const char *model;
    bool json;
    jlt_verify_run verify;
} request;

static const struct argp_option option_table[] = {
    { "json", 'j', NULL, 0, "Print JSON", 0 },
    { "seed", KEY_SEED, "N|0", 0,
      "Seed of the random points; with the same seed the output is the same, byte for byte; default 1", 0 },
    { "samples", KEY_SAMPLES, "N", 0, "Points of the domain, and on each family of equilibria; default 400", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    request *r = state->input;

    switch (key) {
    case 'j': r->json = true; return 0;
    case KEY_SEED: jlt_common_count(&r->verify.seed, value, 0, INT64_MAX, "--seed"); return 0;
    case KEY_SAMPLES: jlt_common_count(&r->verify.samples, value, 1, SAMPLES_MAX, "--samples"); return 0;
    case ARGP_KEY_ARG:
        if (state->arg_num > 0) argp_error(state, "one model at most: '%s' is too many", value);
        r->model = value;
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Prove what the model claims, and verify it through the compiled kernels."
    "\v(a) Every claim of the table is proved or refuted in exact arithmetic.\n"
    "(b) Numbers are compared on the whole domain, and on every family of equilibria, at random and extreme parameters and points. "
    "The generated field and its Jacobian in all its times, the field on vectors, integrals and their gradients are compared "
    "with ball enclosures of 256 bits (of other kernels, such as those of sections, `ttc prove --kernels` proves the programs); "
    "on families also with the table's formulas and with complex-step differentiation, and characteristic polynomials by the "
    "method of Faddeev and LeVerrier with the table's and with the eigenvalues. Where the trace excludes an invariant measure, "
    "there are certificates at rational points, if any are found.\n"
    "(c) The density of an invariant measure is computed from the divergence alone, where there is one.\n"
    "(d) Totals. The exit status is 0 when everything holds, and 1 when something fails.",
    NULL, NULL, NULL,
};

static jlt_exit run(int argc, char **argv)
{
    request r = { .model = JLT_DEFAULT_MODEL, .verify = { .seed = 1, .samples = SAMPLES_DEFAULT } };
    jlt_verify_run *v = &r.verify;
    jlt_command_output output = { 0 };
    const volatile sig_atomic_t *interrupt = NULL;

    ttc_options_parse(&parser, argc, argv, &r);
    bool has_said;
    JLT_PASS(jlt_table_open(&v->descriptor, &has_said, r.model, true));
    v->file = jlt_table_is_file(r.model) ? r.model : NULL;
    if (v->descriptor->equilibria_count > 0 && v->descriptor->state_count > JLT_SAMPLE_STATES_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s has %u states; verify serves up to %d where there are equilibria "
                                "('ttc prove --kernels' proves claims and kernels of any table)",
                                v->descriptor->model, v->descriptor->state_count, JLT_SAMPLE_STATES_MAX);
    if (!has_said) jlt_command_warn_unproved(v->descriptor);
    jlt_status st = jlt_verify_prove(v);
    if (st == JLT_OK) st = jlt_verify_measure(v, interrupt = jlt_interrupt_install());
    if (interrupt != NULL && *interrupt) {
        jlt_verify_clear(v);
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "interrupted; nothing is reported: verdicts need all samples");
    }
    if (st == JLT_OK) st = jlt_command_open(&output);
    if (st == JLT_OK && r.json) st = report_json(output.stream, v);
    else if (st == JLT_OK) report_text(output.stream, v);
    jlt_exit code = st == JLT_OK ? jlt_command_deliver(&output, NULL)
                                 : jlt_command_fail(jlt_command_exit(st), "verify %s: %s", r.model, jlt_status_text(st));
    if (code == JLT_EXIT_DONE && v->failed > 0)
        code = jlt_command_fail(JLT_EXIT_FAILED, "%s: %zu checks fail", r.model, v->failed);
    jlt_command_discard(&output);
    jlt_verify_clear(v);
    return code;
}

const jlt_command jlt_command_verify = {
    "verify", "[MODEL] [--json] [--seed N] [--samples N]",
    "Prove the model's claims, and verify them through the compiled kernels", run, &parser, NULL
};
