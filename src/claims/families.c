/* Compares what kernels compute, at samples of the domain and of families of equilibria, with enclosures, table formulas and other
 * methods. */
#include "claims/check.h"
#include "claims/sample.h"
#include "claims/stepping.h"

#include "analysis/charpoly.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"
#include "kernel/kernel.h"

#include <complex.h>
#include <float.h>
#include <math.h>
#include <string.h>

enum { SIZE = JLT_SAMPLE_STATES_MAX };

/* Complex arithmetic takes up to four times the operations. */
static const double in_complex = 16.0;

static const char running_error[] = "4 times the running error of the expression as written (53-bit balls), and a rounding";
static const char pair_error[] = "8 times the running error of the expression as written (53-bit balls), 4 for each of the two";
static const char complex_error[] =
    "16 times the running error of the expression as written (53-bit balls), values rounded once, and a rounding";
static const char charpoly_error[] = "k(n+3) roundings of the coefficient without cancellation, and the formula's";
static const char root_error[] = "the reported error of each eigenvalue, to first order, and the polynomial's";
static const char fused_name[] = "fused field and Jacobian in ball enclosures of 256 bits";
static const char null_error[] = "running errors of gradient and matrix, and n+4 roundings, without cancellation";

static jlt_status compare_matrix(jlt_verify_family *f, const jlt_sample *s, const jlt_descriptor *d, const double *jacobian)
{
    static const char name[] = "generated Jacobian against the table's matrix";
    const size_t n = d->state_count;
    double formula[SIZE * SIZE];

    if (f->family->matrix == NULL) return JLT_OK;
    JLT_PASS(jlt_kernel_eval_function(formula, f->family->matrix, n * n, s->x, n, s->params, d->param_count));
    jlt_check_enclosures(f, "table's matrix in ball enclosures of 256 bits", formula, s->jacobian, n * n);
    for (size_t i = 0; i < n * n; i++)
        jlt_check_add(jlt_check_named(f, name, pair_error), fabs(formula[i] - jacobian[i]), s->jacobian[i].value,
                      jlt_check_running(s->jacobian[i].rounding, &s->jacobian[i]) / jlt_roundoff,
                      2 * jlt_rearranged * jlt_check_running(s->jacobian[i].rounding, &s->jacobian[i]));
    return JLT_OK;
}

/* Column j of the Jacobian is Im f(x + i h e_j) / h. Nothing is subtracted, so h may be as small as 2^-300 |x_j|: parameters range
 * over 1e-8 to 1e8, so that f may vary over lengths far below 2^-50 |x_j|, relative to whose squares h^2 must be negligible. */
static void compare_complex_step(jlt_verify_family *f, const jlt_sample *s, const jlt_descriptor *d, const double *jacobian)
{
    jlt_verify_check *check = jlt_check_named(f, "generated Jacobian against complex-step differentiation", complex_error);
    const size_t n = d->state_count;
    double complex x[SIZE], out[SIZE];

    if (d->rhs_complex == NULL) return;
    for (size_t j = 0; j < n; j++) {
        const double step = s->x[j] == 0.0 ? 0x1p-300 : ldexp(fabs(s->x[j]), -300);
        for (size_t i = 0; i < n; i++) x[i] = s->x[i] + (i == j ? step * I : 0.0);
        d->rhs_complex(x, s->params, out);
        for (size_t i = 0; i < n; i++) {
            const ttc_enclosure *exact = &s->jacobian[i * n + j];
            const double size = jlt_check_running(exact->plain_rounding, exact);
            jlt_check_add(check, fabs(cimag(out[i]) / step - jacobian[i * n + j]), exact->value,
                          size / jlt_roundoff, in_complex * size);
        }
    }
}

static jlt_status compare_charpoly(jlt_verify_family *f, const jlt_sample *s, const jlt_descriptor *d, const double *jacobian,
                                   const jlt_deflation *eigen)
{
    const size_t n = d->state_count;
    double computed[SIZE + 1], scale[SIZE + 1], formula[SIZE + 1], re[SIZE], im[SIZE], roots[SIZE + 1], sizes[SIZE + 1];
    double errors = 0.0;

    JLT_PASS(jlt_charpoly_faddeev_leverrier(computed, scale, jacobian, s->majorant, n));
    if (f->family->charpoly != NULL) {
        JLT_PASS(jlt_kernel_eval_function(formula, f->family->charpoly, n + 1, s->x, n, s->params, d->param_count));
        for (size_t k = 1; k <= n; k++)
            jlt_check_add(jlt_check_named(f, "characteristic polynomial, Faddeev-LeVerrier against the table's", charpoly_error),
                          fabs(computed[k] - formula[k] / formula[0]), formula[k] / formula[0], scale[k],
                          jlt_rearranged * (double)(k * (n + 3)) * jlt_roundoff * scale[k]);
    }
    for (size_t i = 0; i < n; i++) {
        re[i] = eigen->values[i].re;
        im[i] = eigen->values[i].im;
        errors += eigen->values[i].error;
    }
    JLT_PASS(jlt_charpoly_from_roots(roots, sizes, re, im, n));
    for (size_t k = 1; k <= n; k++)
        jlt_check_add(jlt_check_named(f, "eigenvalues against the characteristic polynomial", root_error),
                      fabs(roots[k] - computed[k]), 0.0, scale[k] + sizes[k],
                      errors * sizes[k - 1] * (double)k +
                          jlt_rearranged * (double)(k * (n + 3)) * jlt_roundoff * (scale[k] + sizes[k]));
    return JLT_OK;
}

static jlt_status compare_left_null(jlt_verify_family *f, const jlt_sample *s, const jlt_descriptor *d, const double *jacobian)
{
    jlt_verify_check *check;
    const size_t n = d->state_count, count = f->family->left_null_count;
    double w[SIZE * SIZE];

    if (count == 0 || f->family->left_null_gradients == NULL) return JLT_OK;
    JLT_PASS(jlt_kernel_eval_function(w, f->family->left_null_gradients, count * n, s->x, n, s->params, d->param_count));
    jlt_check_enclosures(f, "integrals' gradients in ball enclosures of 256 bits", w, s->gradient, count * n);
    check = jlt_check_named(f, "integrals' gradients as left null vectors", null_error);
    for (size_t k = 0; k < count; k++)
        for (size_t j = 0; j < n; j++) {
            double sum = 0.0, terms = 0.0, size = 0.0, bound = 0.0;
            for (size_t i = 0; i < n; i++) {
                const ttc_enclosure *gradient = &s->gradient[k * n + i], *entry = &s->jacobian[i * n + j];
                const double weight = fmax(fabs(gradient->value), gradient->rounding / jlt_roundoff);
                sum += w[k * n + i] * jacobian[i * n + j];
                terms += fabs(w[k * n + i] * jacobian[i * n + j]);
                size += weight * s->majorant[i * n + j];
                bound += jlt_rearranged * (gradient->rounding * s->majorant[i * n + j] + weight * entry->rounding);
            }
            jlt_check_add(check, fabs(sum), 0.0, size, bound + (double)(n + 4) * jlt_roundoff * terms);
        }
    return JLT_OK;
}

static jlt_status compare_eigen(jlt_verify_family *f, jlt_deflation *eigen, const jlt_sample *s, jlt_oracle *oracle,
                                const jlt_instance *special, const double *jacobian)
{
    const jlt_descriptor *d = special->descriptor;
    const size_t n = d->state_count;
    double gradients[SIZE * SIZE], errors[SIZE * SIZE], gradient_errors[SIZE * SIZE];
    jlt_named proved[SIZE];
    size_t count = 0;

    if (d->integral_gradients.call != NULL && d->integral_count <= SIZE) {
        const jlt_status st = jlt_instance_gradients(special, gradients, s->x);
        if (st != JLT_OK && st != JLT_ERR_DOMAIN && st != JLT_ERR_NONFINITE) return st; /* these two: one has a pole there */
        for (unsigned k = 0; st == JLT_OK && k < d->integral_count; k++) {
            if (!jlt_descriptor_proves(d, "integral", d->integrals[k].name)) continue;
            memmove(gradients + count * n, gradients + k * n, n * sizeof *gradients);
            proved[count++] = d->integrals[k];
        }
        JLT_PASS(jlt_oracle_gradient_errors(oracle, gradient_errors, gradients, proved, count));
    }
    for (size_t i = 0; i < n * n; i++) errors[i] = jlt_oracle_error(jacobian[i], &s->jacobian[i]);
    JLT_PASS(jlt_deflation_compute(eigen, jacobian, errors, n, gradients, gradient_errors, count));
    f->lapack_worst = fmax(f->lapack_worst, eigen->plain_difference);
    if (!isnan(eigen->arpack_difference)) {
        f->arpack_worst = fmax(f->arpack_worst, eigen->arpack_difference);
        f->arpack_used++;
    }
    return JLT_OK;
}

/* Compare the values and gradients of one integral; where it has a pole nothing is compared. */
static jlt_status compare_integral(jlt_verify_family *f, jlt_oracle *oracle, const char *name, double value, const double *gradient)
{
    const ttc_model *model = oracle->model;
    const size_t n = model->state_count;
    const ttc_id *partials = jlt_oracle_gradient(oracle, name);
    ttc_enclosure exact[SIZE + 1];
    uint32_t claim = 0;

    if (partials == NULL || !ttc_model_find_claim(model, name, &claim)) return JLT_ERR_UNSUPPORTED;
    if (jlt_oracle_estimate(oracle, exact, &model->claims[claim].expression, 1) != JLT_OK ||
        jlt_oracle_estimate(oracle, exact + 1, partials, n) != JLT_OK)
        return JLT_OK;
    jlt_check_enclosures(f, "integrals in ball enclosures of 256 bits", &value, exact, 1);
    jlt_check_enclosures(f, "integrals' gradients in ball enclosures of 256 bits", gradient, exact + 1, n);
    return JLT_OK;
}

/* Compare what only the whole domain tells: the field, which is zero on families of equilibria, and all integrals. */
static jlt_status compare_anywhere(jlt_verify_family *f, const jlt_sample *s, jlt_oracle *oracle, const jlt_instance *special,
                                   const double *field, const double *fused)
{
    const jlt_descriptor *d = special->descriptor;
    const size_t n = d->state_count;
    double values[SIZE], gradients[SIZE * SIZE];

    jlt_check_enclosures(f, "generated field in ball enclosures of 256 bits", field, s->field, n);
    jlt_check_enclosures(f, fused_name, fused, s->field, n);
    if (d->integral_values.call == NULL || d->integral_count > SIZE ||
        jlt_kernel_eval(values, &d->integral_values, s->x, n, special->prepared) != JLT_OK ||
        jlt_instance_gradients(special, gradients, s->x) != JLT_OK)
        return JLT_OK; /* an integral has a pole there, or is out of range */
    for (size_t k = 0; k < d->integral_count; k++)
        JLT_PASS(compare_integral(f, oracle, d->integrals[k].name, values[k], gradients + k * n));
    return JLT_OK;
}

/* Make all comparisons for the kernels of one descriptor at one sample. */
static jlt_status compare(jlt_verify_family *f, const jlt_sample *s, jlt_oracle *oracle, const jlt_descriptor *kernels,
                          const jlt_descriptor *general)
{
    const size_t n = general->state_count;
    double field[SIZE], jacobian[SIZE * SIZE], both[SIZE + SIZE * SIZE], divergence, trace;
    JLT_OWNED(jlt_instance) *instance = NULL;
    JLT_FREED jlt_deflation *eigen = malloc(sizeof *eigen);

    if (eigen == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_instance_create(&instance, kernels, s->params));
    JLT_PASS(jlt_instance_rhs(instance, field, s->x));
    JLT_PASS(jlt_instance_jacobian(instance, jacobian, s->x));
    JLT_PASS(jlt_kernel_eval(both, &kernels->rhs_jacobian, s->x, n, instance->prepared));
    JLT_PASS(jlt_instance_divergence(instance, &divergence, s->x));
    if (f->family == NULL) JLT_PASS(compare_anywhere(f, s, oracle, instance, field, both));
    for (size_t i = 0; f->family != NULL && i < n; i++)
        jlt_check_add(jlt_check_named(f, "field on the family, which is zero", running_error), fabs(field[i]), 0.0,
                      s->field[i].rounding / jlt_roundoff, jlt_rearranged * s->field[i].rounding);
    jlt_check_enclosures(f, "generated Jacobian in ball enclosures of 256 bits", jacobian, s->jacobian, n * n);
    jlt_check_enclosures(f, fused_name, both + n, s->jacobian, n * n);
    jlt_check_enclosures(f, "generated divergence in ball enclosures of 256 bits", &divergence, &s->trace, 1);
    if (f->family == NULL) return jlt_stepping_compare(f, s, oracle, kernels);
    if (f->family->trace != NULL) {
        JLT_PASS(jlt_kernel_eval_function(&trace, f->family->trace, 1, s->x, n, s->params, general->param_count));
        jlt_check_enclosures(f, "table's trace in ball enclosures of 256 bits", &trace, &s->trace, 1);
        jlt_check_add(jlt_check_named(f, "generated divergence against the table's trace", pair_error), fabs(divergence - trace),
                      s->trace.value, jlt_check_running(s->trace.rounding, &s->trace) / jlt_roundoff,
                      2 * jlt_rearranged * jlt_check_running(s->trace.rounding, &s->trace));
    }
    JLT_PASS(compare_matrix(f, s, general, jacobian));
    compare_complex_step(f, s, general, jacobian);
    JLT_PASS(compare_left_null(f, s, general, jacobian));
    JLT_PASS(compare_eigen(f, eigen, s, oracle, instance, jacobian));
    return compare_charpoly(f, s, general, jacobian, eigen);
}

static jlt_status verify_family(jlt_verify_run *run, jlt_verify_family *f)
{
    const jlt_descriptor *general = run->descriptor;
    const ttc_model *model = run->oracle->model;
    jlt_sample_subject subject = { 0 };
    JLT_FREED jlt_sample *s = malloc(sizeof *s);
    jlt_status st = s == NULL ? JLT_ERR_NOMEM : JLT_OK;

    if (st == JLT_OK) st = jlt_sample_subject_init(&subject, run, f->family);
    f->expands = f->family == NULL;
    for (size_t i = 0; i < model->symbol_count; i++) f->expands = f->expands || model->symbols[i].kind == TTC_COSINE;
    for (size_t k = 0; st == JLT_OK && k < run->samples && !*run->interrupt; k++) {
        const jlt_descriptor *special;
        jlt_status refused;
        if (!jlt_sample_draw(s, run, &subject, k)) break;
        f->samples++;
        refused = jlt_sample_enclose(s, run, &subject);
        if (refused == JLT_OK) refused = compare(f, s, run->oracle, general, general);
        special = jlt_descriptor_choose(general, NULL, NULL, s->params);
        if (refused == JLT_OK && special != NULL && special != general) refused = compare(f, s, run->oracle, special, general);
        if (refused == JLT_ERR_NOMEM) st = refused;
        if (refused != JLT_OK) f->refused++;
    }
    for (size_t i = 0; i < f->check_count; i++) *(f->checks[i].worst_part <= 1.0 ? &run->held : &run->failed) += 1;
    /* If every sample was refused, nothing is verified; a domain that random points do not meet is no failure. */
    if (f->samples == f->refused && (f->family != NULL || f->samples > 0)) run->failed++;
    jlt_sample_subject_clear(&subject);
    return st;
}

jlt_status jlt_verify_families(jlt_verify_run *run)
{
    const jlt_descriptor *d = run->descriptor;
    jlt_status st = JLT_OK;

    if (d->state_count > SIZE) return d->equilibria_count > 0 ? JLT_ERR_UNSUPPORTED : JLT_OK;
    run->families = calloc(d->equilibria_count + 1, sizeof *run->families);
    if (run->families == NULL) return JLT_ERR_NOMEM;
    const jlt_random random = run->random;
    st = verify_family(run, &run->domain);
    run->random = random; /* so that the points on families do not depend on how many the domain took */
    for (; st == JLT_OK && run->family_count < d->equilibria_count; run->family_count++) {
        run->families[run->family_count].family = &d->equilibria[run->family_count];
        st = verify_family(run, &run->families[run->family_count]);
    }
    return st;
}
