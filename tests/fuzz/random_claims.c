/* Claims about any model: identities, rates, signs, maps into other tables. */
#include "fuzz/random_maker.h"

#include <string.h>

void claim_identities(maker *m)
{
    polynomial a = some(m, any_mask(m), 3, 2), b = some(m, any_mask(m), 3, 2), ab = polynomial_multiply(&a, &b);
    open_claim(m, "equal", CLAIM_TRUE);
    WRITE(m, " : %P*%P = %P\n", &a, &b, &ab);
    open_claim(m, "equal", CLAIM_FALSE);
    WRITE(m, " : %P*%P = %P + 1/7\n", &a, &b, &ab);
    open_claim(m, "equal", CLAIM_TRUE);
    WRITE(m, " : %P^3/%P = %P^2\n", &a, &a, &a);
    open_claim(m, "equal", CLAIM_OPEN);
    WRITE(m, " : %P = %P\n", &a, &b);
    if (m->params > 0) {
        polynomial only = some(m, param_mask(m) & ~1u, 2, 2);
        open_claim(m, "equal", CLAIM_TRUE);
        fprintf(m->out, " : %s = ", m->names[0]);
        WRITE(m, "%P when ", &only);
        fprintf(m->out, "%s = ", m->names[0]);
        WRITE(m, "%P\n", &only);
        open_claim(m, "equal", CLAIM_OPEN);
        WRITE(m, " : %P = %P when ", &a, &b);
        fprintf(m->out, "%s = %d\n", m->names[0], (int)below(m, 5) - 2);
    }
    open_claim(m, "equal", CLAIM_OPEN);
    WRITE(m, " : %P = %P*%P when ", &a, &b, &b);
    fprintf(m->out, "%s = ", m->names[FIRST_STATE]);
    polynomial target = some(m, any_mask(m) & ~(1u << FIRST_STATE), 2, 2);
    WRITE(m, "%P\n", &target);
}

void claim_roots_and_angles(maker *m)
{
    polynomial e = some(m, any_mask(m), 2, 1), square = polynomial_multiply(&e, &e);
    if (m->has_root) {
        open_claim(m, "equal", CLAIM_TRUE);
        WRITE(m, " : (r - %P)*(r + %P) = %P - %P\n", &e, &e, &m->radicand, &square);
        open_claim(m, "equal", CLAIM_FALSE);
        WRITE(m, " : r*%P^2 = -1 - r\n", &e);
        open_claim(m, "integral", CLAIM_SILENT);
        WRITE(m, " = r^2 - %P\n", &m->radicand);
        open_claim(m, "time", CLAIM_TRUE);
        WRITE(m, " : r + %P^2\n", &e);
    }
    if (m->has_angle) {
        open_claim(m, "equal", CLAIM_TRUE);
        WRITE(m, " : (C + %P*S)^2 = C^2 + %P*S2 + %P*(1 - C^2)\n", &e, &e, &square);
        open_claim(m, "equal", CLAIM_FALSE);
        fprintf(m->out, " : C2 = 2*C^2 + 1\n");
        open_claim(m, "rate", CLAIM_TRUE);
        WRITE(m, " : C2 = -2*%P*S2\n", &m->field[0]);
        open_claim(m, "time", CLAIM_TRUE);
        fprintf(m->out, " : 3 - C*S\n");
    }
    if (m->random_root) {
        open_claim(m, "equal", CLAIM_OPEN);
        WRITE(m, " : q = %P\n", &e);
        open_claim(m, "equal", CLAIM_OPEN);
        WRITE(m, " : q^2 = %P^2 when ", &e);
        fprintf(m->out, "%s = 0\n", m->names[FIRST_STATE]);
    }
}

static polynomial rate_of(const maker *m, const polynomial *e)
{
    polynomial rate = polynomial_zero();
    for (size_t k = 0; k < m->states; k++) {
        polynomial slope = polynomial_derivative(e, FIRST_STATE + k), part = polynomial_multiply(&slope, &m->field[k]);
        rate = polynomial_add(&rate, &part);
    }
    return rate;
}

void claim_exponentials(maker *m)
{
    polynomial e = some(m, any_mask(m), 2, 1), square = polynomial_multiply(&e, &e);
    polynomial rate = rate_of(m, &m->exponent), radicand_rate = rate_of(m, &m->radicand);
    open_claim(m, "equal", CLAIM_TRUE);
    WRITE(m, " : (E + %P)^2 = E^2 + 2*E*%P + %P\n", &e, &e, &square);
    open_claim(m, "equal", CLAIM_FALSE);
    WRITE(m, " : E = -1 - %P^2\n", &e);
    open_claim(m, "rate", CLAIM_TRUE);
    WRITE(m, " : E = %P*E\n", &rate);
    open_claim(m, "rate", CLAIM_TRUE);
    WRITE(m, " : L = %P/%P\n", &radicand_rate, &m->radicand);
    open_claim(m, "time", CLAIM_TRUE);
    WRITE(m, " : E + %P^2\n", &e);
    open_claim(m, "equal", CLAIM_OPEN);
    WRITE(m, " : L = E*%P\n", &e);
}

void claim_rates(maker *m)
{
    size_t i = below(m, m->states);
    polynomial e = some(m, any_mask(m), 3, 2), rate = rate_of(m, &e);
    open_claim(m, "rate", CLAIM_TRUE);
    WRITE(m, " : %P = %P\n", &e, &rate);
    open_claim(m, "rate", CLAIM_FALSE);
    WRITE(m, " : %P = %P - 3\n", &e, &rate);
    open_claim(m, "integral", polynomial_is_zero(&rate) ? CLAIM_OPEN : CLAIM_FALSE);
    WRITE(m, " = %P\n", &e);
    open_claim(m, "integral", CLAIM_OPEN);
    WRITE(m, " = %P when ", &e);
    fprintf(m->out, "%s = %d\n", m->names[FIRST_STATE + i], (int)below(m, 3));
    open_claim(m, "measure", CLAIM_OPEN);
    WRITE(m, " = %P\n", &e);
    open_claim(m, "invariant", CLAIM_OPEN);
    WRITE(m, " = %P\n", &e);
    if (m->params > 0) {
        polynomial number = some(m, param_mask(m), 2, 2);
        open_claim(m, "integral", CLAIM_SILENT);
        WRITE(m, " = %P\n", &number);
    }
    fprintf(m->out, "reversor %s -> -%s\n", m->names[FIRST_STATE + i], m->names[FIRST_STATE + i]);
    open_claim(m, "symmetry", CLAIM_OPEN);
    fprintf(m->out, " : %s -> %s, %s -> -%s\n", m->names[FIRST_STATE], m->names[FIRST_STATE + 1], m->names[FIRST_STATE + 1],
            m->names[FIRST_STATE]);
}

void claim_signs(maker *m)
{
    polynomial e = some(m, any_mask(m), 3, 2);
    const bool narrowed = m->random_root || m->has_region;
    static const struct {
        const char *format;
        claim_truth truth;
    } shapes[] = { { " : 1 + %P^2\n", CLAIM_TRUE },           { " : -%P^2\n", CLAIM_FALSE },
                   { " : %P\n", CLAIM_OPEN },                 { " : 2 - %P\n", CLAIM_OPEN },
                   { " : %P^2 + 3*%P + 5\n", CLAIM_TRUE },    { " : %P^4 + 1/100\n", CLAIM_TRUE },
                   { " : 1/(1 + %P^2)\n", CLAIM_TRUE },       { " : -1 - %P^2\n", CLAIM_FALSE },
                   { " : %P^2\n", CLAIM_OPEN } };
    for (int k = 0; k < 2; k++) {
        const size_t i = below(m, sizeof shapes / sizeof *shapes), j = below(m, sizeof shapes / sizeof *shapes);
        open_claim(m, "time", shapes[i].truth);
        WRITE(m, shapes[i].format, &e, &e);
        open_claim(m, "positive", shapes[j].truth);
        WRITE(m, shapes[j].format, &e, &e);
    }
    for (size_t i = 0; i < m->params; i++) {
        static const claim_truth negative[SIGNS] = { CLAIM_TRUE, CLAIM_FALSE, CLAIM_FALSE, CLAIM_TRUE };
        polynomial others = some(m, param_mask(m) & ~(1u << i), 2, 2);
        open_claim(m, "variant", narrowed && negative[m->signs[i]] == CLAIM_TRUE ? CLAIM_OPEN : negative[m->signs[i]]);
        fprintf(m->out, " : %s = -3/2\n", m->names[i]);
        open_claim(m, "variant", narrowed ? CLAIM_OPEN : CLAIM_TRUE);
        fprintf(m->out, " : %s = ", m->names[i]);
        WRITE(m, "1 + %P^2\n", &others);
        open_claim(m, "variant", CLAIM_OPEN);
        fprintf(m->out, " : %s = ", m->names[i]);
        WRITE(m, "%P\n", &others);
    }
}

/* The target has the same field in other units: u = 2 x for every state. Its first state may have an interval. */
static void write_target(maker *m, FILE *out, bool bounded)
{
    static const char *const images[MOST_STATES] = { "(u/2)", "(v/2)", "(o/2)", "(p/2)" };
    static const char *const names[MOST_STATES] = { "u", "v", "o", "p" };
    static const char *const conditions[SIGNS] = { "", " > 0", " >= 0", " != 0" };
    const char *shown[VARIABLES];
    memcpy(shown, m->names, sizeof shown);
    for (size_t i = 0; i < m->states; i++) shown[FIRST_STATE + i] = images[i];
    fprintf(out, "model target\n");
    for (size_t i = 0; i < m->params; i++) fprintf(out, "param %s%s\n", m->names[i], conditions[m->signs[i]]);
    for (size_t i = 0; i < m->states; i++) fprintf(out, "state %s%s\n", names[i], bounded && i == 0 ? " in (0, 1)" : "");
    for (size_t i = 0; i < m->states; i++) {
        fprintf(out, "eq %s = 2*", names[i]);
        polynomial_print(out, &m->field[i], shown);
        fputc('\n', out);
    }
}

void claim_reductions(maker *m, FILE *target)
{
    static const char *const names[MOST_STATES] = { "u", "v", "o", "p" };
    bool bounded = chance(m, 3), embedding = chance(m, 3);
    const char *kind = embedding ? "embedding" : "reduction", *into = embedding ? "into" : "onto";
    write_target(m, target, bounded);
    open_claim(m, kind, CLAIM_TRUE);
    fprintf(m->out, " : %s random.tt with", into);
    for (size_t i = 0; i < m->states; i++)
        fprintf(m->out, "%s %s = %s", i > 0 ? "," : "", m->names[FIRST_STATE + i], m->names[FIRST_STATE + i]);
    fputc('\n', m->out);
    open_claim(m, kind, bounded ? CLAIM_OPEN : CLAIM_TRUE);
    fprintf(m->out, " : %s target.tt with", into);
    for (size_t i = 0; i < m->states; i++) fprintf(m->out, "%s %s = 2*%s", i > 0 ? "," : "", names[i], m->names[FIRST_STATE + i]);
    fputc('\n', m->out);
    open_claim(m, kind, CLAIM_OPEN);
    fprintf(m->out, " : %s target.tt with", into);
    for (size_t i = 0; i < m->states; i++)
        fprintf(m->out, "%s %s = %s", i > 0 ? "," : "", names[i], m->names[FIRST_STATE + below(m, m->states)]);
    fputc('\n', m->out);
}

/* Powers of powers, as deep as it happens: whatever is said of them must be said soon. */
void claim_towers(maker *m)
{
    size_t depth = 1 + below(m, 6);
    fprintf(m->out, "let t0 = (%s + %d)^64\n", m->names[FIRST_STATE], (int)below(m, 2));
    for (size_t i = 1; i <= depth; i++) fprintf(m->out, "let t%zu = (t%zu^64)^4\n", i, i - 1);
    open_claim(m, "equal", CLAIM_TRUE);
    fprintf(m->out, " : t%zu + 1 = 1 + t%zu\n", depth, depth);
    open_claim(m, "equal", CLAIM_FALSE);
    fprintf(m->out, " : t%zu = -1\n", depth);
    open_claim(m, "time", CLAIM_TRUE);
    fprintf(m->out, " : 1 + t%zu\n", depth);
    open_claim(m, "integral", CLAIM_OPEN);
    fprintf(m->out, " = t%zu\n", depth);
    open_claim(m, "invariant", CLAIM_OPEN);
    fprintf(m->out, " = t%zu - 1\n", depth);
}
