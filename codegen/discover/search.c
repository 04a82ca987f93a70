#include "discover/search.h"

#include <stdio.h>

enum { POINTS_TO_SPARE = 6, POINTS_FOR_OTHERS = 400, TRIED_MAX = 12 };

static void tell(ttc_discovery *d, const ttc_question *question, size_t sector, const ttc_ansatz *ansatz)
{
    char text[120];
    snprintf(text, sizeof text, "degree %d: sector %zu of %zu, %zu columns", question->degree, sector + 1, ansatz->sector_count,
             ansatz->sectors[sector].count);
    d->host.progress(d->host.context, text);
}

/* How many sign changes keep sectors apart: not the backward one if there is a cofactor, which changes its sign with time. */
static size_t changes_of(const ttc_discovery *d, const ttc_question *question)
{
    return !question->keeps_signs ? 0 : d->changes.count - (question->has_cofactor && d->changes.last_is_backwards);
}

static bool is_graded(const ttc_discovery *d, const ttc_question *question)
{
    return d->grading.weights != NULL && question->keeps_signs && !question->has_cofactor && question->divisor == NULL;
}

/* A matrix with the copies of its quarters that fast multiplication makes, and the list of all monomials. */
double ttc_search_bytes(const ttc_discovery *d, const ttc_question *question, bool graded, size_t *columns)
{
    double total, largest;
    ttc_ansatz_measure(&total, &largest, d->flow, question->degree, &d->changes, changes_of(d, question), graded
                       ? &d->grading : NULL);
    *columns = largest < 1e18 ? (size_t)largest : SIZE_MAX;
    return 8.0 * 1.5 * largest * largest + total * (double)(2 * d->flow->count + 64);
}

static bool make_ansatz(ttc_ansatz *ansatz, ttc_discovery *d, const ttc_question *question, bool graded)
{
    size_t columns;
    const double bytes = ttc_search_bytes(d, question, graded, &columns);
    *ansatz = (ttc_ansatz){ .total = 0 };
    if (bytes > (double)d->memory) {
        d->too_large = bytes;
        return false;
    }
    ttc_ansatz_create(ansatz, d->flow, question->degree, &d->changes, changes_of(d, question), graded ? &d->grading : NULL);
    return true;
}

/* Upper bound of the dimension of solutions; -1 if no points were found. With `graded`, of leading parts, weight by weight: the
 * leading part of a solution solves the equation of the motion's leading part, and solutions have a basis with independent leading
 * parts. by_sector: receives the bounds, shape (sector_count,), for the caller to free; may be NULL. */
static slong bound_of(ttc_discovery *d, const ttc_question *question, const ttc_ansatz *ansatz, bool graded, slong **by_sector)
{
    slong sum = 0;
    ulong *parameters = graded ? d->leading : d->parameters;
    if (by_sector != NULL) *by_sector = flint_calloc(ansatz->sector_count + 1, sizeof **by_sector);
    for (size_t b = 0; b < ansatz->sector_count && sum >= 0; b++) {
        tell(d, question, b, ansatz);
        const slong bound = ttc_null_space_bound(d->flow, &ansatz->sectors[b], (ttc_twist){ question->twist, question->shift },
                                                 parameters, &d->source);
        if (by_sector != NULL) (*by_sector)[b] = bound;
        sum = bound < 0 ? -1 : sum + bound;
    }
    return sum;
}

/* Choose products of known functions that certainly have the form asked for: polynomials K, of several factors only where
 * radicands are polynomials; over a divisor Q, K Q/Q and K P/Q. With `beyond` also others, so that no find is reported twice. */
static void choose_products(ttc_products *which, const ttc_discovery *d, const ttc_question *question, bool beyond)
{
    const ttc_knowns *knowns = question->products;
    const bool divides = question->divisor != NULL;
    const int degree = divides ? ttc_flow_degree(d->flow, question->divisor->numerator) : 0;
    ttc_ratio numerator;
    ttc_ratio_init(d->flow->ring, &numerator);
    *which = (ttc_products){ .budget = question->degree - (beyond ? 0 : degree) };
    which->degrees = flint_calloc(knowns->count + 1, sizeof *which->degrees);
    which->single = flint_calloc(knowns->count + 1, sizeof *which->single);
    for (size_t k = 0; k < knowns->count; k++) {
        const ttc_known *known = &knowns->items[k];
        if (known->degree >= 0) {
            which->degrees[k] = known->degree;
            which->single[k] = !beyond && !d->flow->is_graded && known->degree > 0;
        } else if (divides && beyond) {
            which->degrees[k] = 1;
        } else if (divides) {
            ttc_ratio_multiply(d->flow->ring, &numerator, &known->value, question->divisor);
            which->single[k] = ttc_flow_degree(d->flow, numerator.denominator) == 0;
            if (which->single[k]) which->degrees[k] = ttc_flow_degree(d->flow, numerator.numerator) - degree;
        }
    }
    ttc_ratio_clear(d->flow->ring, &numerator);
}

/* Add values of these products at the points to the span. */
static void explain(ttc_span *span, const ttc_discovery *d, const ttc_question *question, const ttc_points *points, bool beyond)
{
    ttc_products which;
    if (question->products == NULL) return;
    choose_products(&which, d, question, beyond);
    ttc_span_add_products(span, question->products, points, &which, question->shift);
    flint_free(which.single);
    flint_free(which.degrees);
}

/* Returns false if the factor has a pole at a point. */
static bool values_of(ulong *out, const ttc_discovery *d, const ttc_question *question, const ttc_ansatz_sector *sector,
                      const mp_limb_t *vector,
                      const ttc_points *points)
{
    bool good = true;
    ulong *monomials = flint_calloc(sector->count + 1, sizeof *monomials);
    for (size_t i = 0; i < points->count && good; i++) {
        const ulong *values = points->values + i * points->width;
        ulong factor = 1;
        ttc_null_space_values(monomials, d->flow, sector, values);
        out[i] = 0;
        for (size_t j = 0; j < sector->count; j++)
            if (vector[j] != 0) out[i] = nmod_add(out[i], nmod_mul(vector[j], monomials[j], d->flow->mod), d->flow->mod);
        if (question->factor != NULL) good = ttc_modular_ratio_value(&factor, question->factor, values, d->flow->mod);
        out[i] = nmod_mul(out[i], factor, d->flow->mod);
    }
    flint_free(monomials);
    return good;
}

/* Choose, of the first new candidates, sparsest first, the one with the fewest terms when lifted, and add it to the span. Returns
 * its index, or -1 if none is new. *best is set if *lifted: some could be lifted. */
static slong choose(ttc_solution_exact *best, bool *lifted, ttc_discovery *d, const ttc_question *question,
                    const ttc_ansatz_sector *sector,
                    const nmod_mat_t candidates, ttc_span *span, const ttc_points *points)
{
    const fmpz_mpoly_ctx_struct *context = d->flow->ring->context;
    slong chosen = -1;
    int tried = 0;
    ulong *values = flint_calloc(points->count + 1, sizeof *values);
    *lifted = false;
    for (slong i = 0; i < candidates->r && tried < TRIED_MAX; i++) {
        ttc_solution_exact exact;
        const mp_limb_t *vector = &nmod_mat_entry(candidates, i, 0);
        if (!values_of(values, d, question, sector, vector, points) || !ttc_span_add(span, values)) continue;
        ttc_span_drop_last(span);
        tried++;
        if (chosen < 0) chosen = i;
        const bool good = ttc_solution_lift(&exact, d->flow, sector, vector, question->twist,
                                            question->has_cofactor ? question->shift : 0, &d->source);
        const bool better = good && (!*lifted || fmpz_mpoly_length(exact.polynomial.numerator, context)
                                                     < fmpz_mpoly_length(best->polynomial.numerator, context));
        if (better && *lifted) ttc_solution_clear(best, d->flow);
        if (better) {
            *best = exact;
            *lifted = true;
            chosen = i;
        } else ttc_solution_clear(&exact, d->flow);
    }
    if (chosen >= 0 && values_of(values, d, question, sector, &nmod_mat_entry(candidates, chosen, 0), points)) ttc_span_add(span,
                                                                                                                           values);
    flint_free(values);
    return chosen;
}

/* Pass to `take` the new solutions of one sector: independent of what is known, and of those before. */
static void take_sector(ttc_discovery *d, const ttc_question *question, const ttc_ansatz_sector *sector, const nmod_mat_t null,
                        ttc_span *span,
                        const ttc_points *points, ttc_search_taker take, void *context)
{
    bool lifted = false;
    nmod_mat_t candidates;
    ttc_solution_exact exact;
    ttc_solution_sparse(candidates, null, &d->source);
    while (choose(&exact, &lifted, d, question, sector, candidates, span, points) >= 0) {
        if (!lifted) {
            d->unproved += !question->has_cofactor; /* most cofactors that cannot be lifted are irrational */
            continue;
        }
        /* Products with the new solution are known as well. */
        if (take(d, context, &exact, question->degree)) explain(span, d, question, points, true);
        ttc_solution_clear(&exact, d->flow);
    }
    nmod_mat_clear(candidates);
}

static void take_all(ttc_discovery *d, const ttc_question *question, const ttc_ansatz *ansatz, const slong *bounds,
                     ttc_answer *answer,
                     ttc_search_taker take, void *context)
{
    ttc_points points;
    ttc_span span = { .width = 0 };
    const size_t count = (size_t)answer->bound + POINTS_FOR_OTHERS;
    if (!ttc_points_draw(&points, count, d->flow, d->parameters, &d->source)) {
        answer->answered = false;
        ttc_points_clear(&points);
        return;
    }
    ttc_span_init(&span, points.count, d->flow->mod);
    explain(&span, d, question, &points, true);
    for (size_t b = 0; b < ansatz->sector_count; b++) {
        nmod_mat_t null;
        if (bounds[b] <= 0) continue;
        tell(d, question, b, ansatz);
        ttc_null_space(null, d->flow, &ansatz->sectors[b], (ttc_twist){ question->twist, question->shift }, d->parameters,
                       &d->source);
        if (null->r > 0) take_sector(d, question, &ansatz->sectors[b], null, &span, &points, take, context);
        nmod_mat_clear(null);
    }
    ttc_span_clear(&span);
    ttc_points_clear(&points);
}

/* The dimension of solutions that are certainly products of known functions: the rank of values, at most that of functions; -1 if
 * no points were found. */
static slong explained_by(ttc_discovery *d, const ttc_question *question, slong bound)
{
    ttc_points points;
    ttc_span span;
    slong count = -1;
    if (ttc_points_draw(&points, (size_t)bound + POINTS_TO_SPARE, d->flow, d->parameters, &d->source)) {
        ttc_span_init(&span, points.count, d->flow->mod);
        explain(&span, d, question, &points, false);
        count = (slong)span.count;
        ttc_span_clear(&span);
    }
    ttc_points_clear(&points);
    return count;
}

ttc_answer ttc_search(ttc_discovery *d, const ttc_question *question, ttc_search_taker take, void *context)
{
    ttc_answer answer = { .bound = -1 };
    ttc_ansatz ansatz;
    slong *bounds = NULL;
    d->too_large = 0;
    if (is_graded(d, question)) {
        if (make_ansatz(&ansatz, d, question, true)) answer.bound = bound_of(d, question, &ansatz, true, NULL);
        answer.monomials = ansatz.total;
        ttc_ansatz_clear(&ansatz);
        if (answer.bound >= 0) answer.explained = explained_by(d, question, answer.bound);
        answer.answered = answer.bound >= 0 && answer.explained == answer.bound;
        if (answer.answered || take == NULL) return answer;
    }
    if (make_ansatz(&ansatz, d, question, false)) {
        answer.monomials = ansatz.total;
        answer.bound = bound_of(d, question, &ansatz, false, &bounds);
        if (answer.bound >= 0) answer.explained = explained_by(d, question, answer.bound);
        answer.answered = answer.explained >= 0 && answer.explained <= answer.bound
                          && (take != NULL || answer.bound == answer.explained);
        if (answer.answered && answer.bound > answer.explained) {
            take_all(d, question, &ansatz, bounds, &answer, take, context);
            answer.explained = explained_by(d, question, answer.bound);
        }
    }
    flint_free(bounds);
    ttc_ansatz_clear(&ansatz);
    return answer;
}
