/* Finds first integrals, degree by degree. */
#include "discover/claim_text.h"
#include "discover/discover.h"
#include "discover/factor_list.h"
#include "discover/gradient.h"

enum { LOW_DEGREE = 6, FRACTION_COLUMNS = 1000 };

typedef struct {
    const ttc_ratio *denominator; /* NULL: none */
    const char *text;
} search_context;

static bool take(ttc_discovery *d, void *context, const ttc_solution_exact *solution, int degree)
{
    const search_context *search = context;
    ttc_ring *ring = d->flow->ring;
    ttc_text claim = { 0 };
    ttc_ratio value;
    char *name = ttc_discovery_name(d, "F");
    ttc_ratio_init(ring, &value);
    ttc_ratio_set(ring, &value, &solution->polynomial);
    ttc_text_format(&claim, "integral %s = %s", name, search->text != NULL ? "(" : "");
    ttc_claim_text_add(&claim, d->flow, value.numerator);
    if (search->text != NULL) {
        ttc_text_format(&claim, ")/(%s)", search->text);
        ttc_ratio_divide(ring, &value, &value, search->denominator);
    }
    ttc_text_add(&claim, d->when);
    const bool depends = !ttc_gradient_is_new(d->flow, &d->integrals, &value, d->parameters, &d->source);
    const bool proved = ttc_discovery_publish(d, ttc_text_string(&claim));
    if (proved && depends)
        ttc_discovery_remark(d, "%s is a function of those known before, and no polynomial in them of this degree", name);
    if (proved) ttc_knowns_add(&d->integrals, d->flow, name, &value, NULL, search->text == NULL ? degree : -1);
    ttc_ratio_clear(ring, &value);
    ttc_text_clear(&claim);
    flint_free(name);
    return proved;
}

static void list_knowns(ttc_text *text, const ttc_knowns *knowns)
{
    for (size_t i = 0; i < knowns->count; i++) ttc_text_format(text, "%s%s", i > 0 ? ", " : "", knowns->items[i].name);
}

/* Remark what is known of all degrees up to `reached`, whose answer is given. */
static void conclude(ttc_discovery *d, const ttc_answer *answer, int reached, const char *denominator)
{
    ttc_text names = { 0 }, form = { 0 };
    const size_t rank = answer->monomials - (size_t)answer->bound;
    const slong open = answer->bound - answer->explained;
    list_knowns(&names, &d->integrals);
    ttc_text_format(&form, denominator != NULL ? "P/(%s)" : "P", denominator);
    d->left_out |= reached < d->degree;
    if (reached < d->degree && d->too_large > 0)
        ttc_discovery_remark(d, "degree %d is left out: it takes %.3g GiB", reached + 1, d->too_large / (1 << 30));
    if (reached >= 0 && open > 0)
        ttc_discovery_remark(d, "integrals: %ld more %s, deg P <= %d, may exist", (long)open, ttc_text_string(&form), reached);
    else if (reached >= 0)
        ttc_discovery_remark(d, "integrals: no %s %s, deg P <= %d (%zu monomials, rank %zu)", d->integrals.count > 0
                             ? "other" : "integral",
                             ttc_text_string(&form), reached, answer->monomials, rank);
    if (reached >= 0)
        d->host.settle(d->host.context, &(ttc_discovery_settled){ "integrals", ttc_text_string(&form), reached, open <= 0,
                                                                   answer->monomials, rank });
    if (reached >= 0 && open <= 0 && d->integrals.count > 0)
        ttc_discovery_remark(d, "           than %s and sums of %s products", ttc_text_string(&names), d->integrals.count > 1
                             ? "their" : "its");
    ttc_text_clear(&form);
    ttc_text_clear(&names);
}

void ttc_discover_integrals(ttc_discovery *d, const ttc_ratio *denominator, const char *denominator_text)
{
    ttc_ring *ring = d->flow->ring;
    const bool divides = denominator != NULL;
    search_context context = { denominator, denominator_text };
    ttc_modular_ratio twist = { .numerator = { .count = 0 } }, factor = { .numerator = { .count = 0 } };
    ttc_ratio rate;
    ttc_answer last = { .bound = 0 };
    int reached = -1;
    ttc_ratio_init(ring, &rate);
    if (divides) { /* (P/Q)' = (P' - P Q'/Q)/Q */
        ttc_flow_logarithmic_rate(d->flow, &rate, denominator);
        ttc_ratio_scale(ring, &rate, &rate, ring->minus_one);
        ttc_modular_ratio_set(&twist, ring, &rate, d->flow->mod);
        ttc_ratio_set_integer(ring, &rate, 1);
        ttc_ratio_divide(ring, &rate, &rate, denominator);
        ttc_modular_ratio_set(&factor, ring, &rate, d->flow->mod);
    }
    const bool keeps = !divides || ttc_sign_changes_keep(&d->changes, d->flow, denominator);
    for (int degree = 1; degree <= d->degree && ring->status == TTC_RING_OK; degree++) {
        ttc_question question = { .degree = degree, .twist = divides ? &twist : NULL, .keeps_signs = keeps,
                                  .divisor = denominator, .factor = divides ? &factor : NULL, .products = &d->integrals };
        ttc_answer answer = ttc_search(d, &question, take, &context);
        if (!answer.answered) break;
        last = answer;
        reached = degree;
        if (degree != LOW_DEGREE || d->degree < degree + 2) continue;
        question.degree = d->degree; /* with what is known by now, one rank may answer for all the degrees between */
        answer = ttc_search(d, &question, NULL, NULL);
        if (!answer.answered) continue;
        last = answer;
        reached = d->degree;
        break;
    }
    conclude(d, &last, reached, denominator_text);
    ttc_modular_ratio_clear(&factor);
    ttc_modular_ratio_clear(&twist);
    ttc_ratio_clear(ring, &rate);
}

/* The greatest degree, at most d->degree, with small matrices. */
static int small_degree(const ttc_discovery *d)
{
    ttc_question question = { .degree = d->degree };
    size_t columns = 0;
    while (question.degree > 1 && (ttc_search_bytes(d, &question, false, &columns), columns) > FRACTION_COLUMNS) question.degree--;
    return question.degree;
}

void ttc_discover_fractions(ttc_discovery *d)
{
    const int degree = d->degree;
    ttc_factors factors;
    ttc_ratio denominator;
    ttc_factors_init(&factors, d->flow);
    ttc_ratio_init(d->flow->ring, &denominator);
    for (size_t i = 0; i < d->flow->count; i++) ttc_factors_add_all(&factors, d->flow->slopes[d->flow->variables[i]].denominator);
    ttc_factors_join_radicands(&factors);
    d->degree = small_degree(d);
    for (size_t i = 0; i < factors.count; i++) {
        ttc_text text = { 0 };
        ttc_ratio_set_polynomial(d->flow->ring, &denominator, &factors.items[i]);
        ttc_claim_text_add(&text, d->flow, &factors.items[i]);
        if (!text.failed) ttc_discover_integrals(d, &denominator, ttc_text_string(&text));
        ttc_text_clear(&text);
    }
    ttc_ratio_clear(d->flow->ring, &denominator);
    ttc_factors_clear(&factors);
    d->degree = degree;
}
