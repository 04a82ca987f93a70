/* Claims about families of equilibria. The states of the family are bound in the task's field. */
#include "prove/domain.h"

#include <stdlib.h>

static bool field_vanishes(ttc_task *task)
{
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < task->model->state_count && ttc_task_open(task); i++) {
        ttc_evaluate(task->field, &value, ttc_model_field(task->model, i));
        ttc_task_require_zero(task, &value, "d%s/dt on the family",
                              task->model->symbols[task->model->states[i]].name);
    }
    ttc_ratio_clear(task->ring, &value);
    return ttc_task_open(task);
}

static void trace(ttc_task *task, ttc_ratio *out)
{
    ttc_ratio entry;
    ttc_ratio_init(task->ring, &entry);
    ttc_ratio_set_integer(task->ring, out, 0);
    for (size_t i = 0; i < task->model->state_count; i++) {
        ttc_task_jacobian(task, &entry, i, i);
        ttc_ratio_add(task->ring, out, out, &entry);
    }
    ttc_ratio_clear(task->ring, &entry);
}

/* Require that states of the family, and roots and logarithms that depend on them, meet the conditions of their records. */
static void require_records(ttc_task *task)
{
    for (uint32_t i = 0; i < task->model->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = &task->model->symbols[i];
        /* Without domain records, roots and logarithms are not required: they may rest on these. */
        bool follows = (entry->kind == TTC_ROOT || entry->kind == TTC_LOG) && task->extent != TTC_DOMAIN_OF_OTHERS, bound = false;
        for (size_t k = 0; k < task->claim->bindings.count; k++) {
            uint32_t symbol = task->claim->bindings.items[k].symbol;
            bound |= symbol == i || (follows && ttc_model_depends(task->model, entry->node, symbol));
        }
        if (bound) ttc_domain_require_symbol(task, NULL, task->model, i, " on the family");
        task->shown = i + 1; /* roots after this one may rest on it */
    }
}

void ttc_prove_equilibria(ttc_task *task)
{
    if (task->tested != NULL) require_records(task);
    else field_vanishes(task);
}

void ttc_prove_trace(ttc_task *task)
{
    ttc_ratio sum;
    ttc_ratio_init(task->ring, &sum);
    trace(task, &sum);
    ttc_task_take_off(task, &sum, task->field, task->claim->expression);
    ttc_task_require_zero(task, &sum, "trace of the Jacobian - claimed trace");
    ttc_ratio_clear(task->ring, &sum);
}

static ttc_ratio *jacobian(ttc_task *task)
{
    size_t n = task->model->state_count;
    ttc_ratio *matrix = ttc_task_ratios(task, n * n);
    for (size_t i = 0; matrix != NULL && i < n * n; i++) ttc_task_jacobian(task, &matrix[i], i / n, i % n);
    return matrix;
}

void ttc_prove_matrix(ttc_task *task)
{
    size_t n = task->model->state_count;
    ttc_ratio entry;
    if (task->claim->entry_count != n * n) {
        ttc_task_unsettle(task, "the matrix has %zu entries and not %zu", task->claim->entry_count, n * n);
        return;
    }
    ttc_ratio_init(task->ring, &entry);
    for (size_t i = 0; i < n * n && ttc_task_open(task); i++) {
        ttc_task_jacobian(task, &entry, i / n, i % n);
        ttc_task_take_off(task, &entry, task->field, task->claim->entries[i]);
        ttc_task_require_zero(task, &entry, "Jacobian - claimed matrix, row %zu, column %zu", i / n + 1, i % n + 1);
    }
    ttc_ratio_clear(task->ring, &entry);
}

/* out = a b, shape (n, n) */
static void multiply(ttc_task *task, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            ttc_ratio_set_integer(task->ring, &out[i * n + j], 0);
            for (size_t k = 0; k < n; k++)
                ttc_ratio_add_product(task->ring, &out[i * n + j], &a[i * n + k], &b[k * n + j]);
        }
}

/** Coefficients of det(lambda E - A), c_n = 1 first, by Faddeev and LeVerrier:
 *  M_1 = E, c_(n-k) = -tr(A M_k)/k, M_(k+1) = A M_k + c_(n-k) E. */
static void characteristic(ttc_task *task, ttc_ratio *coefficients, const ttc_ratio *a, size_t n)
{
    ttc_ratio *m = ttc_task_ratios(task, n * n), *am = ttc_task_ratios(task, n * n);
    fmpq_t factor;
    fmpq_init(factor);
    ttc_ratio_set_integer(task->ring, &coefficients[0], 1);
    for (size_t i = 0; m != NULL && i < n; i++) ttc_ratio_set_integer(task->ring, &m[i * n + i], 1);
    for (size_t k = 1; m != NULL && am != NULL && k <= n && ttc_task_open(task); k++) {
        multiply(task, am, a, m, n);
        for (size_t i = 0; i < n; i++)
            ttc_ratio_add(task->ring, &coefficients[k], &coefficients[k], &am[i * n + i]);
        fmpq_set_si(factor, -1, k);
        ttc_ratio_scale(task->ring, &coefficients[k], &coefficients[k], factor);
        for (size_t i = 0; i < n; i++)
            ttc_ratio_add(task->ring, &am[i * n + i], &am[i * n + i], &coefficients[k]);
        ttc_ratio *swapped = m;
        m = am;
        am = swapped;
    }
    fmpq_clear(factor);
    ttc_task_free(task, am, n * n);
    ttc_task_free(task, m, n * n);
}

/* The coefficient of lambda^k in a claimed polynomial whose denominator is free of lambda. */
static void coefficient_of(ttc_task *task, ttc_ratio *out, const ttc_ratio *polynomial, slong lambda, size_t k)
{
    ttc_ratio denominator;
    ulong exponent = k;
    fmpz_mpoly_t part;
    ttc_ratio_init(task->ring, &denominator);
    fmpz_mpoly_init(part, task->ring->context);
    fmpz_mpoly_get_coeff_vars_ui(part, polynomial->numerator, &lambda, &exponent, 1, task->ring->context);
    ttc_ratio_set_polynomial(task->ring, out, part);
    ttc_ratio_set_polynomial(task->ring, &denominator, polynomial->denominator);
    ttc_ratio_divide(task->ring, out, out, &denominator);
    fmpz_mpoly_clear(part, task->ring->context);
    ttc_ratio_clear(task->ring, &denominator);
}

static slong lambda_variable(const ttc_task *task)
{
    return ttc_valuation_variable(task->field, ttc_model_lambda(task->model));
}

/* Refute that a ratio, whose denominator contains lambda, is a polynomial in lambda: where the denominator's leading coefficient is
 * not zero, and the remainder of a power of it times the numerator is not. */
static void refute_quotient(ttc_task *task, const ttc_ratio *claimed, slong lambda)
{
    enum { REST, BELOW, LEAD, TOP, POWER, COUNT };
    ttc_ring *ring = task->ring;
    const slong degree = fmpz_mpoly_degree_si(claimed->denominator, lambda, ring->context);
    char *point = NULL;
    ttc_ratio *r = ttc_task_ratios(task, COUNT);
    if (r == NULL) return;
    ttc_ratio_set_polynomial(ring, &r[REST], claimed->numerator);
    ttc_ratio_set_polynomial(ring, &r[BELOW], claimed->denominator);
    coefficient_of(task, &r[LEAD], &r[BELOW], lambda, (size_t)degree);
    for (slong k; ttc_task_open(task) && (k = fmpz_mpoly_degree_si(r[REST].numerator, lambda, ring->context)) >= degree;) {
        coefficient_of(task, &r[TOP], &r[REST], lambda, (size_t)k);
        ttc_ratio_multiply(ring, &r[TOP], &r[TOP], &r[BELOW]);
        ttc_ratio_set_variable(ring, &r[POWER], lambda);
        ttc_ratio_power(ring, &r[POWER], &r[POWER], k - degree);
        ttc_ratio_multiply(ring, &r[TOP], &r[TOP], &r[POWER]);
        ttc_ratio_multiply(ring, &r[REST], &r[REST], &r[LEAD]);
        ttc_ratio_subtract(ring, &r[REST], &r[REST], &r[TOP]);
    }
    for (slong k = 0; k < degree && ttc_task_open(task) && point == NULL; k++) {
        coefficient_of(task, &r[TOP], &r[REST], lambda, (size_t)k);
        ttc_ratio_multiply(ring, &r[TOP], &r[TOP], &r[LEAD]);
        ttc_task_search(task, &r[TOP], TTC_IS_NONZERO, &point);
    }
    if (point != NULL) ttc_task_refute_at(task, point, claimed, "not a polynomial in lambda: claimed");
    else ttc_task_unsettle(task, "no point is known at which the claimed ratio is no polynomial in lambda");
    ttc_task_free(task, r, COUNT);
}

/* claimed = factor * det(lambda E - A), the factor being the claimed coefficient of lambda^n, nonzero. */
static void compare_polynomials(ttc_task *task, const ttc_ratio *claimed, const ttc_ratio *coefficients, slong lambda)
{
    size_t n = task->model->state_count;
    ttc_ratio factor, expected, found;
    ttc_ratio_init(task->ring, &factor);
    ttc_ratio_init(task->ring, &expected);
    ttc_ratio_init(task->ring, &found);
    slong degree = fmpz_mpoly_degree_si(claimed->numerator, lambda, task->ring->context);
    if (fmpz_mpoly_degree_si(claimed->denominator, lambda, task->ring->context) > 0) {
        refute_quotient(task, claimed, lambda);
    } else if (degree < (slong)n) {
        ttc_task_refute(task, claimed, "not of degree %zu in lambda: claimed", n);
    } else {
        for (size_t k = (size_t)degree; k > n && ttc_task_open(task); k--) {
            coefficient_of(task, &found, claimed, lambda, k);
            ttc_task_require_zero(task, &found, "not of degree %zu in lambda: coefficient of lambda^%zu", n, k);
        }
        coefficient_of(task, &factor, claimed, lambda, n);
        ttc_task_require(task, &factor, TTC_IS_NONZERO, "the polynomial vanishes with the factor of lambda^%zu", n);
        for (size_t k = 0; k < n && ttc_task_open(task); k++) {
            ttc_ratio_multiply(task->ring, &expected, &factor, &coefficients[n - k]);
            coefficient_of(task, &found, claimed, lambda, k);
            ttc_ratio_subtract(task->ring, &expected, &expected, &found);
            ttc_task_require_zero(task, &expected, "coefficient of lambda^%zu, actual - claimed", k);
        }
    }
    ttc_ratio_clear(task->ring, &found);
    ttc_ratio_clear(task->ring, &expected);
    ttc_ratio_clear(task->ring, &factor);
}

void ttc_prove_charpoly(ttc_task *task)
{
    size_t n = task->model->state_count;
    slong lambda = lambda_variable(task);
    ttc_ratio claimed;
    ttc_ratio_init(task->ring, &claimed);
    ttc_ratio *matrix = jacobian(task), *coefficients = ttc_task_ratios(task, n + 1);
    if (matrix != NULL && coefficients != NULL && lambda >= 0) {
        characteristic(task, coefficients, matrix, n);
        ttc_evaluate(task->field, &claimed, task->claim->expression);
        if (ttc_task_open(task)) compare_polynomials(task, &claimed, coefficients, lambda);
    }
    ttc_task_free(task, coefficients, n + 1);
    ttc_task_free(task, matrix, n * n);
    ttc_ratio_clear(task->ring, &claimed);
}

/* gradient . A = 0, and the gradient is not zero on the whole family */
static void check_left_null(ttc_task *task, const ttc_claim *member, const ttc_ratio *matrix)
{
    size_t n = task->model->state_count;
    bool zero = true;
    ttc_ratio sum;
    ttc_ratio_init(task->ring, &sum);
    ttc_ratio *gradient = ttc_task_ratios(task, n);
    for (size_t i = 0; gradient != NULL && i < n; i++) {
        ttc_evaluate(task->field, &gradient[i], ttc_derive_state(task->model, member->expression, i));
        zero = zero && ttc_ratio_is_zero(task->ring, &gradient[i]);
    }
    if (ttc_task_open(task) && zero && ttc_task_may_have_point(task))
        ttc_task_unsettle(task, "the gradient of %s vanishes on the whole family", member->name);
    for (size_t j = 0; gradient != NULL && j < n && ttc_task_open(task); j++) {
        ttc_ratio_set_integer(task->ring, &sum, 0);
        for (size_t i = 0; i < n; i++) ttc_ratio_add_product(task->ring, &sum, &gradient[i], &matrix[i * n + j]);
        ttc_task_require_zero(task, &sum, "grad(%s) times the Jacobian, column %zu", member->name, j + 1);
    }
    ttc_task_free(task, gradient, n);
    ttc_ratio_clear(task->ring, &sum);
}

void ttc_prove_left_null(ttc_task *task)
{
    size_t n = task->model->state_count;
    ttc_ratio *matrix = jacobian(task);
    for (size_t i = 0; matrix != NULL && i < task->claim->member_count && ttc_task_open(task); i++)
        check_left_null(task, &task->model->claims[task->claim->members[i]], matrix);
    ttc_task_free(task, matrix, n * n);
}

/* There is no invariant smooth positive density if the trace is nonzero at some equilibrium of the domain: search for one. */
void ttc_prove_obstructs(ttc_task *task)
{
    ttc_ratio sum;
    char *point = NULL;
    ttc_ratio_init(task->ring, &sum);
    trace(task, &sum);
    if (field_vanishes(task)) {
        ttc_search_result result = ttc_task_search(task, &sum, TTC_IS_NONZERO, &point);
        if (result == TTC_POINT_FOUND) {
            task->exhibited = true;
            free(task->point);
            task->point = point;
        } else if (result == TTC_POINT_NOT_DECIDED) {
            ttc_task_unsettle(task, "no equilibrium of the domain was found at which the trace is not zero");
        } else {
            ttc_task_refute(task, &sum, "nothing is obstructed: trace on the family, which vanishes wherever the domain has it");
        }
    }
    ttc_ratio_clear(task->ring, &sum);
}
