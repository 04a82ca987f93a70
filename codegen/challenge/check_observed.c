/* Checks the divisors of records other than the equations, around one point: none is zero at all states near it. With functions of
 * states, parameters vary as well: exp(k*x) - 1 is zero at all states for one k only. */
#include "challenge/check.h"
#include "prove/observed.h"

#include <stdlib.h>

enum { PLACES = 8, NEAR_BITS = 60 };

/* Move a symbol by a random multiple of 2^-60 that is not zero: a state up or down, a parameter up. */
static void move(ttc_check *check, uint32_t symbol)
{
    fmpq_t number;
    arb_t value;
    fmpq_init(number);
    arb_init(value);
    ttc_sample_positive(number, &check->random, TTC_SAMPLE_MODERATE);
    if (check->model->symbols[symbol].kind == TTC_STATE && ttc_random_below(&check->random, 2) == 0) fmpq_neg(number, number);
    arb_set_fmpq(value, number, ttc_probe_precision(check->probe));
    arb_mul_2exp_si(value, value, -NEAR_BITS);
    arb_add(value, value, ttc_probe_value(check->probe, symbol), ttc_probe_precision(check->probe));
    ttc_probe_set(check->probe, symbol, value);
    arb_clear(value);
    fmpq_clear(number);
}

static bool uses_functions_of_states(const ttc_model *model, ttc_id divisor)
{
    bool uses = false;
    unsigned char *support = ttc_model_support(model, &divisor, 1);
    for (uint32_t i = 0; support != NULL && !uses && i < model->symbol_count; i++)
        for (size_t k = 0; support[i] && ttc_symbol_is_function(model->symbols[i].kind) && !uses && k < model->state_count; k++)
            uses = ttc_model_depends(model, model->symbols[i].node, model->states[k]);
    free(support);
    return uses;
}

/* The divisor must be nonzero at the current point, or at one of others near it that lie in the domain. */
static void check_divisor(ttc_check *check, ttc_id divisor, const char *name)
{
    const ttc_model *model = check->model;
    const bool moves_params = uses_functions_of_states(model, divisor);
    char fault[256];
    size_t told = 0;
    for (int place = 0; place < PLACES; place++) {
        const bool inside = ttc_domain_locate_image(check->probe, model, fault, sizeof fault) == TTC_INSIDE;
        arb_srcptr value = inside ? ttc_probe_at(check->probe, divisor) : NULL;
        if (value != NULL && !arb_contains_zero(value)) return;
        told += value != NULL;
        for (size_t i = 0; i < model->state_count; i++) move(check, model->states[i]);
        for (size_t i = 0; i < model->param_count && moves_params; i++) move(check, model->params[i]);
    }
    if (told == PLACES) ttc_check_violate(check, "zero at all states near: what divides", name);
    else ttc_check_undefined(check);
}

void ttc_check_observed(ttc_check *check)
{
    const ttc_model *model = check->model;
    ttc_observed record;
    ttc_observed_get(model, check->index, &record);
    unsigned char *own = ttc_observed_divisors(model, &record);
    if (own == NULL) ttc_check_undefined(check);
    for (size_t i = 0; own != NULL && i < model->divisor_count; i++)
        if (own[i]) check_divisor(check, model->divisors[i].divisor, record.name);
    free(own);
}
