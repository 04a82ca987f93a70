/* Checks claims about families of equilibria, at one point of the family. */
#include "challenge/check.h"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

enum { LAMBDAS = 3 };

void ttc_check_equilibria(ttc_check *check)
{
    for (size_t i = 0; i < check->model->state_count; i++) {
        arb_srcptr speed = ttc_check_at(check, ttc_model_field(check->model, i));
        if (speed == NULL) return;
        ttc_check_zero(check, speed, "the field on the family in", check->model->symbols[check->model->states[i]].name);
    }
}

static bool trace_of(ttc_check *check, arb_t out)
{
    arb_zero(out);
    for (size_t i = 0; i < check->model->state_count; i++) {
        arb_srcptr speed = ttc_check_at(check, ttc_model_field(check->model, i));
        if (speed == NULL) return false;
        arb_add(out, out, speed + 1 + i, ttc_probe_precision(check->probe));
    }
    return true;
}

void ttc_check_trace(ttc_check *check)
{
    arb_t trace;
    arb_init(trace);
    arb_srcptr claimed = ttc_check_at(check, check->claim->expression);
    if (claimed != NULL && trace_of(check, trace)) {
        arb_sub(trace, trace, claimed, ttc_probe_precision(check->probe));
        ttc_check_zero(check, trace, "trace - claimed trace of", check->claim->name);
    }
    arb_clear(trace);
}

/* The family is one of equilibria, and the trace differs from zero at some point of it. */
void ttc_check_obstructs(ttc_check *check)
{
    arb_t trace;
    arb_init(trace);
    ttc_check_equilibria(check);
    if (trace_of(check, trace)) ttc_check_witness(check, trace);
    arb_clear(trace);
}

void ttc_check_matrix(ttc_check *check)
{
    const size_t n = check->model->state_count;
    arb_ptr jacobian = _arb_vec_init((long)(n * n));
    bool good = check->claim->entry_count == n * n && ttc_check_jacobian(check, jacobian);
    for (size_t i = 0; good && i < n * n; i++) {
        arb_srcptr claimed = ttc_check_at(check, check->claim->entries[i]);
        good = claimed != NULL;
        if (!good) break;
        arb_sub(jacobian + i, jacobian + i, claimed, ttc_probe_precision(check->probe));
        ttc_check_zero(check, jacobian + i, "Jacobian - claimed matrix of", check->claim->name);
    }
    _arb_vec_clear(jacobian, (long)(n * n));
}

void ttc_check_left_null(ttc_check *check)
{
    const size_t n = check->model->state_count;
    arb_t sum;
    arb_ptr jacobian = _arb_vec_init((long)(n * n)), gradient = _arb_vec_init((long)n);
    bool good = ttc_check_jacobian(check, jacobian);
    arb_init(sum);
    for (size_t m = 0; good && m < check->claim->member_count; m++) {
        const ttc_claim *member = &check->model->claims[check->claim->members[m]];
        arb_srcptr jet = ttc_check_at(check, member->expression);
        good = jet != NULL;
        if (!good) break;
        _arb_vec_set(gradient, jet + 1, (long)n);
        for (size_t j = 0; j < n; j++) {
            arb_zero(sum);
            for (size_t i = 0; i < n; i++)
                arb_addmul(sum, gradient + i, jacobian + i * n + j, ttc_probe_precision(check->probe));
            ttc_check_zero(check, sum, "gradient times Jacobian of", member->name);
            ttc_check_witness(check, gradient + j);
        }
    }
    arb_clear(sum);
    _arb_vec_clear(gradient, (long)n);
    _arb_vec_clear(jacobian, (long)(n * n));
}

/* det(lambda E - A) */
static void determinant(arb_t out, arb_srcptr jacobian, size_t n, const arb_t lambda, long precision)
{
    arb_mat_t matrix;
    arb_mat_init(matrix, (long)n, (long)n);
    for (size_t i = 0; i < n * n; i++) arb_neg(arb_mat_entry(matrix, (long)(i / n), (long)(i % n)), jacobian + i);
    for (size_t i = 0; i < n; i++)
        arb_add(arb_mat_entry(matrix, (long)i, (long)i), arb_mat_entry(matrix, (long)i, (long)i), lambda, precision);
    arb_mat_det(out, matrix, precision);
    arb_mat_clear(matrix);
}

/* P(lambda) = c det(lambda E - A) with one c: P and the determinant have the same ratios at some lambdas. */
void ttc_check_charpoly(ttc_check *check)
{
    const size_t n = check->model->state_count;
    const long precision = ttc_probe_precision(check->probe);
    const uint32_t symbol = ttc_model_lambda(check->model);
    fmpq_t number;
    arb_t lambda, cross;
    fmpq_init(number);
    arb_init(lambda);
    arb_init(cross);
    arb_ptr jacobian = _arb_vec_init((long)(n * n)), actual = _arb_vec_init(LAMBDAS), claimed = _arb_vec_init(LAMBDAS);
    bool good = ttc_check_jacobian(check, jacobian);
    ttc_random random = check->random;
    for (int i = 0; good && i < LAMBDAS; i++) {
        ttc_sample_any(number, &random, TTC_SAMPLE_MODERATE);
        arb_set_fmpq(lambda, number, precision);
        ttc_probe_set(check->probe, symbol, lambda);
        arb_srcptr value = ttc_check_at(check, check->claim->expression);
        good = value != NULL;
        if (!good) break;
        arb_set(claimed + i, value);
        ttc_check_witness(check, value);
        determinant(actual + i, jacobian, n, lambda, precision);
    }
    for (int i = 0; good && i < LAMBDAS; i++) {
        arb_mul(cross, claimed + i, actual + (i + 1) % LAMBDAS, precision);
        arb_submul(cross, claimed + (i + 1) % LAMBDAS, actual + i, precision);
        ttc_check_zero(check, cross, "ratio of polynomials at two lambdas of", check->claim->name);
    }
    _arb_vec_clear(claimed, LAMBDAS);
    _arb_vec_clear(actual, LAMBDAS);
    _arb_vec_clear(jacobian, (long)(n * n));
    arb_clear(cross);
    arb_clear(lambda);
    fmpq_clear(number);
}
