#include "spectrum/equilibrium.h"

#include "analysis/family.h"
#include "core/memory.h"
#include "ext/number.h"
#include "kernel/descriptor.h"
#include "spectrum/exact_point.h"

#include <math.h>
#include <string.h>

/* ---- the formulas of the table ---- */

static const ttc_claim *claim_of(const jlt_oracle *oracle, ttc_claim_kind kind, const char *family)
{
    for (size_t k = 0; k < oracle->model->claim_count; k++)
        if (oracle->model->claims[k].kind == kind && strcmp(oracle->model->claims[k].name, family) == 0)
            return &oracle->model->claims[k];
    return NULL;
}

static void bind(const jlt_oracle *oracle, const ttc_claim *family, const unsigned char *given)
{
    for (size_t b = 0; b < family->bindings.count; b++)
        for (size_t i = 0; i < oracle->model->state_count; i++)
            if (oracle->states[i] == family->bindings.items[b].symbol && !given[i])
                ttc_ball_bind(oracle->ball, oracle->states[i], family->bindings.items[b].expression);
}

static void enclose_one(double *value, const jlt_oracle *oracle, ttc_id id)
{
    ttc_enclosure exact;

    if (ttc_ball_enclose(&exact, oracle->ball, id)) *value = exact.value + 0.0; /* -0 becomes 0 */
}

/* Replace the values in doubles of the table's formulas for trace and characteristic polynomial, of the family result->family, by
 * those in ball arithmetic, rounded. Symbols have the values set in the oracle; states that the family binds are given by its
 * expressions where given[i] is 0. */
static void enclose_formulas(jlt_linearization *result, jlt_oracle *oracle, const unsigned char *given)
{
    const ttc_claim *claim;
    const ttc_id *c;

    if (result->family == NULL) return;
    claim = claim_of(oracle, TTC_CLAIM_EQUILIBRIA, result->family->name);
    if (claim != NULL) bind(oracle, claim, given);
    claim = claim_of(oracle, TTC_CLAIM_TRACE, result->family->name);
    if (claim != NULL) enclose_one(&result->trace_formula, oracle, claim->expression);
    claim = claim_of(oracle, TTC_CLAIM_CHARPOLY, result->family->name);
    if (claim == NULL) return;
    c = jlt_oracle_charpoly(oracle, (size_t)(claim - oracle->model->claims));
    for (size_t k = 1; c != NULL && k <= result->n; k++) enclose_one(&result->charpoly_formula[k], oracle, c[k]);
}

static void set_point(const jlt_equilibrium_question *q, const double *params, const double *x, const char *const *exact_x)
{
    jlt_oracle_set_params(q->oracle, params, q->params);
    jlt_oracle_set_states(q->oracle, x, exact_x);
}

static double least_size(const ttc_enclosure *exact) { return fmax(0.0, fabs(exact->value) - exact->radius); }

/* Linearize in doubles, with exact sizes of field and Jacobian, and bounds on the errors of the Jacobian and of the integrals'
 * gradients. */
static jlt_status linearize(jlt_linearization *result, const jlt_equilibrium_question *q, const double *params, const double *x,
                            const char *const *exact_x)
{
    enum { SIZE = JLT_LINEARIZATION_SIZE_MAX };
    const size_t n = q->descriptor->state_count;
    double errors[SIZE * SIZE], gradient_errors[SIZE * SIZE], sizes[SIZE + SIZE * SIZE];
    JLT_FREED ttc_enclosure *exact = calloc(n * n, sizeof *exact);
    bool finite = true;

    if (exact == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_linearization_residual(result, q->descriptor, params, x));
    set_point(q, params, x, exact_x);
    JLT_PASS(jlt_oracle_enclose(q->oracle, exact, q->oracle->field, n));
    for (size_t i = 0; i < n; i++) {
        sizes[i] = least_size(&exact[i]);
        if (q->find) sizes[i] = fmin(sizes[i], fabs(result->f[i])); /* states are found as far as doubles tell */
    }
    JLT_PASS(jlt_oracle_enclose(q->oracle, exact, q->oracle->jacobian, n * n));
    for (size_t i = 0; i < n * n; i++) {
        sizes[n + i] = least_size(&exact[i]);
        errors[i] = jlt_oracle_error(result->jacobian[i], &exact[i]);
        finite &= isfinite(errors[i]) != 0;
    }
    if (!finite) return JLT_ERR_NONFINITE;
    JLT_PASS(jlt_oracle_gradient_errors(q->oracle, gradient_errors, result->gradients, result->held, result->integrals));
    return jlt_linearization_compute(result, q->descriptor, params, x, sizes, errors, gradient_errors);
}

/* Whether x still is the double of the fraction that the caller gave. */
static bool untouched(double x, const char *fraction)
{
    double typed;

    return fraction != NULL && jlt_number_parse(&typed, fraction, strlen(fraction)) == JLT_OK && !(typed < x) && !(typed > x);
}

/* Find the states, turned[i] = 1, that differ from those of the family (NULL: none) by whole periods. */
static void find_turned(unsigned char *turned, const jlt_equilibria *family, const jlt_descriptor *d, const double *params,
                        const double *x)
{
    double on[JLT_LINEARIZATION_SIZE_MAX];

    if (family != NULL) jlt_family_turn_back(on, family, d, params, x);
    for (size_t i = 0; i < d->state_count; i++) turned[i] = family != NULL && (on[i] < x[i] || on[i] > x[i]);
}

/* Recompute the report in ball arithmetic from the exact values, with exact numbers where the point allows them. On failure the
 * numbers stay those of doubles, and the verdict becomes undecided. */
static jlt_status enclose(jlt_linearization *result, const jlt_equilibrium_question *q, const double *params, const double *x,
                          const char *const *fractions)
{
    const jlt_descriptor *d = q->descriptor;
    const jlt_equilibria *family = result->family;
    unsigned char given[JLT_LINEARIZATION_SIZE_MAX], turned[JLT_LINEARIZATION_SIZE_MAX];
    JLT_FREED jlt_ball_value *exact = calloc(d->param_count + 1, sizeof *exact);
    jlt_ball_value exact_x[JLT_LINEARIZATION_SIZE_MAX];
    jlt_exact_matrix *matrix = NULL;
    jlt_status st = JLT_ERR_NOMEM;

    if (exact == NULL) return st;
    for (size_t i = 0; i < d->param_count; i++) exact[i] = (jlt_ball_value){ params[i], q->params[i] };
    find_turned(turned, family, d, params, x);
    for (size_t i = 0; i < d->state_count; i++)
        given[i] = turned[i] || (q->find && family != NULL ? family->is_free[i] : q->given[i]);
    for (size_t i = 0; i < d->state_count; i++) exact_x[i] = (jlt_ball_value){ x[i], fractions[i] };
    st = jlt_exact_point_linearize(&matrix, q->oracle, exact, exact_x, family == NULL ? NULL : family->name, given);
    if (st == JLT_OK) st = jlt_linearization_enclose(result, d, exact, exact_x, matrix, q->digits);
    for (size_t i = 0; i < d->state_count; i++) given[i] = given[i] && !turned[i];
    if (st == JLT_OK) enclose_formulas(result, q->oracle, given);
    if (st != JLT_OK) {
        result->verdict = JLT_UNDECIDED;
        result->motion = JLT_MOTION_OPEN;
    }
    jlt_exact_matrix_destroy(matrix);
    return st;
}

/* Linearize in balls alone. Returns false where they do not settle everything. */
static bool prove(jlt_linearization *result, const jlt_equilibrium_question *q, const double *params, const double *x,
                  const char *const *fractions)
{
    if (jlt_linearization_place(result, q->descriptor, params, x) != JLT_OK) return false;
    set_point(q, params, x, fractions);
    return enclose(result, q, params, x, fractions) == JLT_OK && result->proved && !isnan(result->eigen.values[result->n - 1].re);
}

void jlt_equilibrium_compute(jlt_equilibrium *out, const jlt_equilibrium_question *q, double *params, double *x)
{
    const jlt_descriptor *d = q->descriptor;
    const char *fractions[JLT_LINEARIZATION_SIZE_MAX];

    out->stage = JLT_EQUILIBRIUM_PARAMS;
    out->status = jlt_descriptor_check_params(d, params, &out->index);
    if (out->status != JLT_OK) return;
    jlt_family_complete(x, q->given, d, params);
    out->stage = JLT_EQUILIBRIUM_STATES;
    out->status = jlt_descriptor_check_state(d, x, &out->index);
    if (out->status != JLT_OK) return;
    out->stage = JLT_EQUILIBRIUM_DOMAIN;
    out->status = jlt_region_check(&out->region, &out->region_value, d, params, x);
    if (out->status != JLT_OK) return;
    out->stage = JLT_EQUILIBRIUM_SEARCH;
    if (q->find) out->status = jlt_linearization_find(x, d, params, q->order, q->held);
    if (out->status != JLT_OK) return;
    for (size_t i = 0; i < d->state_count; i++) fractions[i] = untouched(x[i], q->x[i]) ? q->x[i] : NULL;
    out->stage = JLT_EQUILIBRIUM_POINT;
    if (q->proved_only && !q->fast && prove(&out->result, q, params, x, fractions)) return;
    out->status = linearize(&out->result, q, params, x, fractions);
    if (out->status != JLT_OK || q->fast) return;
    const jlt_status st = enclose(&out->result, q, params, x, fractions);
    if (st == JLT_OK || (st != JLT_ERR_NOMEM && q->digits == 0)) return;
    out->stage = JLT_EQUILIBRIUM_DIGITS;
    out->status = st;
}
