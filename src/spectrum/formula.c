#include "spectrum/formula.h"

#include "fields/coefficients.h"

#include <string.h>

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

static void enclose(double *value, const jlt_oracle *oracle, ttc_id id)
{
    ttc_enclosure exact;

    if (ttc_ball_enclose(&exact, oracle->ball, id)) *value = exact.value + 0.0; /* -0 becomes 0 */
}

void jlt_formula_enclose(jlt_linearization *result, const jlt_oracle *oracle, const unsigned char *given)
{
    const size_t n = result->n;
    ttc_graph *graph = oracle->model->graph;
    ttc_id coefficients[JLT_LINEARIZATION_SIZE_MAX + 1];
    const ttc_claim *claim;
    uint32_t lambda = 0;

    if (result->family == NULL) return;
    claim = claim_of(oracle, TTC_CLAIM_EQUILIBRIA, result->family->name);
    if (claim != NULL) bind(oracle, claim, given);
    claim = claim_of(oracle, TTC_CLAIM_TRACE, result->family->name);
    if (claim != NULL) enclose(&result->trace_formula, oracle, claim->expression);
    claim = claim_of(oracle, TTC_CLAIM_CHARPOLY, result->family->name);
    while (oracle->model->symbols[lambda].kind != TTC_LAMBDA) lambda++;
    if (claim == NULL ||
        !ttc_polynomial_coefficients(graph, coefficients, n, ttc_model_expand(oracle->model, claim->expression), lambda))
        return;
    for (size_t k = 1; k <= n; k++)
        enclose(&result->charpoly_formula[k], oracle, ttc_divide(graph, coefficients[k], coefficients[0]));
}
