/* Finds invariant densities: div(rho f) = 0 where (log rho)' = -div f. */
#include "discover/claim_text.h"
#include "discover/discover.h"

#include <string.h>

/* base' = -2 div f base, in place of the density sqrt(base) where base changes its sign on the domain. */
static bool publish_square(ttc_discovery *d, const char *base)
{
    char *name = ttc_discovery_name(d, "square");
    ttc_text claim = { 0 };
    ttc_text_format(&claim, "rate %s : %s = -2*(", name, base);
    ttc_claim_text_add_ratio(&claim, d->flow, &d->flow->divergence);
    ttc_text_format(&claim, ")*(%s)%s", base, d->when);
    const bool proved = !claim.failed && ttc_discovery_publish(d, ttc_text_string(&claim));
    if (proved) ttc_discovery_remark(d, "%s has two signs: where it has one, the root of its absolute value is a density", name);
    ttc_text_clear(&claim);
    flint_free(name);
    return proved;
}

/* A square root needs a record of its own, and a base of one sign. */
static void write_density(ttc_text *claim, ttc_discovery *d, const char *name, const char *base, int power, bool negative)
{
    char *root = power == 2 ? ttc_discovery_name(d, "root") : NULL;
    const char *open = negative ? "-(" : "", *close = negative ? ")" : "";
    if (power == 2) ttc_text_format(claim, "root %s = sqrt(%s%s%s)\nmeasure %s = %s", root, open, base, close, name, root);
    else ttc_text_format(claim, "measure %s = %s%s%s", name, open, base, close);
    ttc_text_add(claim, d->when);
    flint_free(root);
}

/* What is remarked of a density. Its root, a record of the table then, excludes from the domain the points at which the base of the
 * root divides by zero. */
static const char *extent_of(const char *base, int power, bool is_smooth)
{
    if (!is_smooth) return "not positive and smooth on the whole domain: ttc prove -v says where";
    return power == 2 && strchr(base, '/') != NULL ? "positive and smooth where its root does not divide by zero"
                                                   : "positive and smooth on the domain";
}

bool ttc_discovery_publish_density(ttc_discovery *d, const char *base, int power)
{
    ttc_text claims[2] = { { 0 }, { 0 } };
    bool proved[2] = { false, false }, is_smooth[2] = { false, false };
    char *name = ttc_discovery_name(d, "rho");
    for (int i = 0; i < 2 && !is_smooth[0]; i++) {
        write_density(&claims[i], d, name, base, power, i == 1);
        proved[i] = !claims[i].failed && ttc_discovery_try(d, ttc_text_string(&claims[i]), &is_smooth[i]);
    }
    const int chosen = !proved[0] || (proved[1] && is_smooth[1]);
    const bool found = proved[chosen];
    if (found) {
        ttc_discovery_say(d, ttc_text_string(&claims[chosen]));
        ttc_discovery_remark(d, "%s is %s", name, extent_of(base, power, is_smooth[chosen]));
    }
    flint_free(name);
    for (int i = 0; i < 2; i++) ttc_text_clear(&claims[i]);
    if (!found && power == 2) return publish_square(d, base);
    d->unproved += !found;
    return found;
}

static bool take(ttc_discovery *d, void *context, const ttc_solution_exact *solution, int degree)
{
    const long power = *(const long *)context;
    ttc_text base = { 0 };
    (void)degree;
    if (d->densities.count > 0) return false; /* one is enough: the others are its products with integrals */
    ttc_text_add(&base, power < 0 ? "1/(" : "");
    ttc_claim_text_add(&base, d->flow, solution->polynomial.numerator);
    ttc_text_add(&base, power < 0 ? ")" : "");
    const bool proved = ttc_discovery_publish_density(d, ttc_text_string(&base), power == 2 || power == -2 ? 2 : 1);
    if (proved) ttc_knowns_add(&d->densities, d->flow, "", &solution->polynomial, NULL, 0);
    ttc_text_clear(&base);
    return false;
}

void ttc_discover_densities(ttc_discovery *d)
{
    static const long powers[] = { 1, -1, 2, -2 };
    ttc_ring *ring = d->flow->ring;
    ttc_modular_ratio twist = { .numerator = { .count = 0 } };
    ttc_ratio rate;
    fmpq_t power;
    int reached = d->degree;
    size_t monomials = 0;
    const size_t unproved = d->unproved;
    ttc_ratio_init(ring, &rate);
    fmpq_init(power);
    for (size_t k = 0; k < sizeof powers / sizeof *powers; k++) {
        long chosen = powers[k];
        fmpq_set_si(power, chosen, 1); /* rho = P^(1/k): P' + k P div f = 0 */
        ttc_ratio_scale(ring, &rate, &d->flow->divergence, power);
        ttc_modular_ratio_set(&twist, ring, &rate, d->flow->mod);
        ttc_question question = { .degree = reached, .twist = &twist, .keeps_signs = true };
        if (d->densities.count > 0) break;
        ttc_answer answer = ttc_search(d, &question, NULL, NULL); /* if there is none, one rank answers for all degrees */
        monomials = answer.monomials;
        if (answer.answered) continue;
        for (int degree = 0; degree <= reached && d->densities.count == 0; degree++) {
            question.degree = degree;
            answer = ttc_search(d, &question, take, &chosen);
            monomials = answer.monomials;
            if (!answer.answered) reached = degree - 1;
        }
    }
    d->left_out |= reached < d->degree;
    if (d->densities.count == 0 && d->unproved == unproved && reached >= 0) {
        ttc_discovery_remark(d, "densities: no P, 1/P, sqrt(P), 1/sqrt(P), deg P <= %d (%zu monomials, full rank)", reached,
                             monomials);
        d->host.settle(d->host.context,
                       &(ttc_discovery_settled){ "densities", "P^(1/k), k = 1, -1, 2, -2", reached, true, monomials, monomials });
    }
    fmpq_clear(power);
    ttc_ratio_clear(ring, &rate);
    ttc_modular_ratio_clear(&twist);
}
