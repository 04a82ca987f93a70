/* Finds polynomials with P' = cofactor P, the cofactor a function of parameters. */
#include "discover/claim_text.h"
#include "discover/discover.h"
#include "discover/extactic.h"
#include "discover/relations.h"

#include <stdlib.h>

enum {
    COLUMNS_MAX = 800, /* of a matrix whose characteristic polynomial is taken */
    OTHER_FIELDS = 40
};

/* unsaid: integrals that are not reported, but explain cofactors 0. */
typedef struct {
    ttc_discovery *d;
    ttc_knowns unsaid;
} factors;

/* Integrals and factors together: a product with an integral is no new factor. The items are borrowed. */
static ttc_knowns products_of(const factors *f)
{
    const ttc_knowns *parts[] = { &f->d->integrals, &f->unsaid, &f->d->factors };
    ttc_knowns all = { .count = 0 };
    all.items = flint_calloc(parts[0]->count + parts[1]->count + parts[2]->count + 1, sizeof *all.items);
    for (size_t p = 0; p < 3; p++)
        for (size_t i = 0; i < parts[p]->count; i++) all.items[all.count++] = parts[p]->items[i];
    return all;
}

/* All that is known, and where finds are added. */
typedef struct {
    factors *f;
    ttc_knowns products;
} taker;

static void join(taker *t)
{
    flint_free(t->products.items);
    t->products = products_of(t->f);
}

static bool take(ttc_discovery *d, void *context, const ttc_solution_exact *solution, int degree)
{
    ttc_text claim = { 0 }, polynomial = { 0 }, cofactor = { 0 };
    char *name = ttc_discovery_name(d, "P");
    ttc_claim_text_add(&polynomial, d->flow, solution->polynomial.numerator);
    ttc_claim_text_add_ratio(&cofactor, d->flow, &solution->cofactor);
    ttc_text_format(&claim, "rate %s : %s = %s*(%s)%s", name, ttc_text_string(&polynomial), ttc_text_string(&cofactor),
                    ttc_text_string(&polynomial), d->when);
    claim.failed |= polynomial.failed || cofactor.failed;
    const bool proved = ttc_discovery_publish(d, ttc_text_string(&claim));
    if (proved) {
        ttc_knowns_add(&d->factors, d->flow, name, &solution->polynomial, &solution->cofactor, degree);
        join(context);
    }
    ttc_text_clear(&cofactor);
    ttc_text_clear(&polynomial);
    ttc_text_clear(&claim);
    flint_free(name);
    return proved;
}

/* Keep a proved integral without reporting it. */
static bool take_unsaid(ttc_discovery *d, void *context, const ttc_solution_exact *solution, int degree)
{
    taker *t = context;
    ttc_text claim = { 0 };
    const size_t named = d->named;
    char *name = ttc_discovery_name(d, "F");
    d->named = named; /* the name is not reported, so it stays free */
    ttc_text_format(&claim, "integral %s = ", name);
    ttc_claim_text_add(&claim, d->flow, solution->polynomial.numerator);
    ttc_text_add(&claim, d->when);
    const bool proved = !claim.failed && ttc_discovery_try(d, ttc_text_string(&claim), NULL);
    if (proved) {
        ttc_knowns_add(&t->f->unsaid, d->flow, name, &solution->polynomial, NULL, degree);
        join(t);
    }
    ttc_text_clear(&claim);
    flint_free(name);
    return proved;
}

static int ascending(const void *left, const void *right)
{
    const ulong a = *(const ulong *)left, b = *(const ulong *)right;
    return a < b ? -1 : a > b;
}

/* All nonzero residues that may be cofactors in some sector. Returns false if those of some sector are not known. */
static bool cofactors_of(ulong **out, size_t *kept, ttc_discovery *d, const ttc_ansatz *ansatz)
{
    size_t count = 0;
    bool good = true;
    *kept = 0;
    *out = flint_calloc(ansatz->total + 1, sizeof **out);
    for (size_t b = 0; b < ansatz->sector_count; b++) {
        size_t more = 0;
        good &= ttc_solution_cofactors(*out + count, &more, d->flow, &ansatz->sectors[b], d->parameters, &d->source);
        count += more;
    }
    qsort(*out, count, sizeof **out, ascending);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || (*out)[i] != (*out)[i - 1]) (*out)[(*kept)++] = (*out)[i];
    return good;
}

static ttc_question question_of(int degree, ulong cofactor, const ttc_knowns *products)
{
    return (ttc_question){ .degree = degree, .shift = cofactor, .has_cofactor = true, .keeps_signs = true, .products = products };
}

/* Whether products of known functions explain all cofactors in the current field at the current parameters; 0 as well, which is
 * the image of a cofactor that happens to vanish there. */
static bool is_explained(const factors *f, const ttc_ansatz *ansatz, int degree)
{
    ttc_discovery *d = f->d;
    ulong *cofactors = NULL;
    size_t count;
    ttc_knowns products = products_of(f);
    bool explained = cofactors_of(&cofactors, &count, d, ansatz);
    for (size_t i = 0; i <= count && explained; i++) {
        const ttc_question question = question_of(degree, i < count ? cofactors[i] : 0, &products);
        explained = ttc_search(d, &question, NULL, NULL).answered;
    }
    flint_free(products.items);
    flint_free(cofactors);
    return explained;
}

static bool take_prime(const factors *f, ulong prime)
{
    ttc_discovery *d = f->d;
    const bool found = ttc_flow_take_prime(d->flow, prime);
    ttc_knowns unsaid = f->unsaid;
    ttc_knowns_reduce(&d->integrals, d->flow);
    ttc_knowns_reduce(&d->factors, d->flow);
    ttc_knowns_reduce(&unsaid, d->flow);
    return found;
}

/* Whether there are no other cofactors rational in the parameters. Such a one has an image in all fields, at all parameters, an
 * irrational one where it happens to lie in the field: a field in which products explain all cofactors proves that there is no
 * other. */
static bool is_complete(const factors *f, const ttc_ansatz *ansatz, int degree)
{
    ttc_discovery *d = f->d;
    const ulong prime = d->flow->mod.n;
    bool complete = is_explained(f, ansatz, degree);
    ulong *kept = d->parameters;
    d->parameters = flint_calloc(d->flow->ring->variable_count, sizeof *d->parameters);
    for (int i = 0; i < OTHER_FIELDS && !complete; i++)
        complete = take_prime(f, d->flow->mod.n - 1) && ttc_flow_draw_parameters(d->flow, d->parameters, -1, &d->source)
                   && is_explained(f, ansatz, degree);
    take_prime(f, prime);
    flint_free(d->parameters);
    d->parameters = kept;
    return complete;
}

/* Returns false if the degree takes too large a matrix. */
static bool search_degree(factors *f, int degree, bool *complete)
{
    ttc_discovery *d = f->d;
    ttc_ansatz ansatz;
    ulong *cofactors = NULL;
    size_t found;
    taker t = { .f = f };
    const size_t changes = d->changes.count - d->changes.last_is_backwards;
    double total, largest;
    ttc_ansatz_measure(&total, &largest, d->flow, degree, &d->changes, changes, NULL);
    if (largest > COLUMNS_MAX) return false;
    ttc_ansatz_create(&ansatz, d->flow, degree, &d->changes, changes, NULL);
    d->host.progress(d->host.context, "cofactors that are numbers");
    join(&t);
    cofactors_of(&cofactors, &found, d, &ansatz);
    for (size_t i = 0; i < found; i++) {
        const ttc_question question = question_of(degree, cofactors[i], &t.products);
        ttc_search(d, &question, take, &t);
    }
    const ttc_question integrals = { .degree = degree, .keeps_signs = true, .products = &t.products };
    const size_t unproved = d->unproved;
    ttc_search(d, &integrals, take_unsaid, &t);
    d->unproved = unproved;
    *complete = is_complete(f, &ansatz, degree);
    flint_free(t.products.items);
    flint_free(cofactors);
    ttc_ansatz_clear(&ansatz);
    return true;
}

void ttc_discover_factors(ttc_discovery *d, const ttc_id *given, size_t given_count)
{
    factors f = { .d = d };
    int reached = 0;
    bool complete = false; /* for the last degree, which includes all below it */
    while (reached < d->degree && search_degree(&f, reached + 1, &complete)) reached++;
    const bool any = d->factors.count > 0;
    if (complete)
        ttc_discovery_remark(d, "factors: no %sP with P' = c P, c != 0 rational in the parameters, deg P <= %d%s%s",
                             any ? "other " : "", reached, any ? ", but sums of products of these" : "",
                             any && d->integrals.count + f.unsaid.count > 0 ? " and of integrals" : "");
    else
        ttc_discovery_remark(d, "factors: %sP with P' = c P, c != 0 rational in the parameters, deg P <= %d, may exist",
                             d->factors.count > 0 ? "more " : "", reached);
    d->host.settle(d->host.context, &(ttc_discovery_settled){ "factors", "P' = c P", reached, complete, 0, 0 });
    ttc_factors *invariant = flint_calloc(1, sizeof *invariant);
    ttc_factors_init(invariant, d->flow);
    ttc_extactic_find(d, invariant);
    ttc_relations_find(d, invariant, given, given_count);
    ttc_factors_clear(invariant);
    flint_free(invariant);
    ttc_knowns_clear(&f.unsaid, d->flow);
}
