/* Polynomials that the motion multiplies by a number: P' = cofactor P, the cofactor a function of parameters. */
#include "discover/claim_text.h"
#include "discover/discover.h"
#include "discover/extactic.h"
#include "discover/relations.h"

#include <stdlib.h>

enum {
    COLUMNS_MAX = 800, /* of a matrix whose characteristic polynomial is taken */
    OTHER_PARAMETERS = 40
};

/* Integrals and factors together: a product with an integral is no new factor. The items stay those of `d`. */
static ttc_knowns products_of(const ttc_discovery *d)
{
    ttc_knowns all = { .items = flint_calloc(d->integrals.count + d->factors.count + 1, sizeof *all.items) };
    for (size_t i = 0; i < d->integrals.count; i++) all.items[all.count++] = d->integrals.items[i];
    for (size_t i = 0; i < d->factors.count; i++) all.items[all.count++] = d->factors.items[i];
    return all;
}

/* context: what is known, a ttc_knowns as above, which the find joins. */
static bool take(ttc_discovery *d, void *context, const ttc_solution_exact *solution, int degree)
{
    ttc_text claim = { 0 }, polynomial = { 0 }, cofactor = { 0 };
    char *name = ttc_discovery_name(d, "P");
    ttc_knowns *products = context;
    ttc_claim_text_add(&polynomial, d->flow, solution->polynomial.numerator);
    ttc_claim_text_add_ratio(&cofactor, d->flow, &solution->cofactor);
    ttc_text_format(&claim, "rate %s : %s = %s*(%s)%s", name, ttc_text_string(&polynomial), ttc_text_string(&cofactor),
                    ttc_text_string(&polynomial), d->when);
    claim.failed |= polynomial.failed || cofactor.failed;
    const bool proved = ttc_discovery_publish(d, ttc_text_string(&claim));
    if (proved) {
        ttc_knowns_add(&d->factors, d->flow, name, &solution->polynomial, &solution->cofactor, degree);
        flint_free(products->items);
        *products = products_of(d);
    }
    ttc_text_clear(&cofactor);
    ttc_text_clear(&polynomial);
    ttc_text_clear(&claim);
    flint_free(name);
    return proved;
}

static int ascending(const void *left, const void *right)
{
    const ulong a = *(const ulong *)left, b = *(const ulong *)right;
    return a < b ? -1 : a > b;
}

/* All cofactors that some block of this degree may have. */
static size_t cofactors_of(ulong **out, ttc_discovery *d, const ttc_ansatz *ansatz)
{
    size_t count = 0, kept = 0;
    *out = flint_calloc(ansatz->total + 1, sizeof **out);
    for (size_t b = 0; b < ansatz->block_count; b++)
        count += ttc_solution_cofactors(*out + count, d->flow, &ansatz->blocks[b], d->parameters, &d->source);
    qsort(*out, count, sizeof **out, ascending);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || (*out)[i] != (*out)[i - 1]) (*out)[kept++] = (*out)[i];
    return kept;
}

/* Whether products of what is known have all cofactors that show at the parameters in use. Where there are none, cofactors are
 * numbers, and those beyond 30 bits are passed over. */
static bool is_explained(ttc_discovery *d, const ttc_ansatz *ansatz, int degree)
{
    ulong *cofactors = NULL;
    bool explained = true;
    fmpq_t number;
    fmpq_init(number);
    ttc_knowns products = products_of(d);
    const size_t count = cofactors_of(&cofactors, d, ansatz);
    for (size_t i = 0; i < count && explained; i++) {
        const ttc_question question = { .degree = degree, .shift = cofactors[i], .has_cofactor = true, .keeps_signs = true,
                                        .products = &products };
        if (d->flow->parameter_count == 0 && !ttc_modular_rational(number, cofactors[i], d->flow->mod)) continue;
        explained = ttc_search(d, &question, NULL, NULL).answered;
    }
    flint_free(products.items);
    flint_free(cofactors);
    fmpq_clear(number);
    return explained;
}

/* A cofactor that is rational in the parameters shows at all of them, an irrational one where it happens to be in the field:
 * parameters at which none shows but those of products prove that there is no other. */
static bool is_complete(ttc_discovery *d, const ttc_ansatz *ansatz, int degree)
{
    bool complete = is_explained(d, ansatz, degree);
    ulong *kept = d->parameters;
    d->parameters = flint_calloc(d->flow->ring->variable_count, sizeof *d->parameters);
    for (int i = 0; i < OTHER_PARAMETERS && !complete && d->flow->parameter_count > 0; i++) {
        ttc_flow_draw_parameters(d->flow, d->parameters, -1, &d->source);
        complete = is_explained(d, ansatz, degree);
    }
    flint_free(d->parameters);
    d->parameters = kept;
    return complete;
}

/* False: the degree takes too large a matrix. */
static bool search_degree(ttc_discovery *d, int degree, bool *complete)
{
    ttc_ansatz ansatz;
    ulong *cofactors = NULL;
    const size_t changes = d->changes.count - d->changes.last_is_backwards;
    double total, largest;
    ttc_ansatz_measure(&total, &largest, d->flow, degree, &d->changes, changes, NULL);
    if (largest > COLUMNS_MAX) return false;
    ttc_ansatz_create(&ansatz, d->flow, degree, &d->changes, changes, NULL);
    d->host.progress(d->host.context, "cofactors that are numbers");
    const size_t count = cofactors_of(&cofactors, d, &ansatz);
    for (size_t i = 0; i < count; i++) {
        ttc_knowns products = products_of(d);
        const ttc_question question = { .degree = degree, .shift = cofactors[i], .has_cofactor = true, .keeps_signs = true,
                                        .products = &products };
        ttc_search(d, &question, take, &products);
        flint_free(products.items);
    }
    *complete = is_complete(d, &ansatz, degree);
    flint_free(cofactors);
    ttc_ansatz_clear(&ansatz);
    return true;
}

void ttc_discover_factors(ttc_discovery *d, const ttc_id *given, size_t given_count)
{
    int reached = 0;
    bool complete = false; /* of the last degree, which has all those below */
    while (reached < d->degree && search_degree(d, reached + 1, &complete)) reached++;
    if (complete)
        ttc_discovery_remark(d, "factors: no %sP with P' = c P, c != 0 rational in the parameters, deg P <= %d%s",
                             d->factors.count > 0 ? "other " : "", reached, d->factors.count > 0 ? ", but products of these" : "");
    else
        ttc_discovery_remark(d, "factors: %sP with P' = c P, c != 0 rational in the parameters, deg P <= %d, may exist",
                             d->factors.count > 0 ? "more " : "", reached);
    ttc_factors *invariant = flint_calloc(1, sizeof *invariant);
    ttc_factors_init(invariant, d->flow);
    ttc_extactic_find(d, invariant);
    ttc_relations_find(d, invariant, given, given_count);
    ttc_factors_clear(invariant);
    flint_free(invariant);
}
