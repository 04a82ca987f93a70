#include "fuzz/random_table.h"

#include "fuzz/random_polynomial.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PARAMS = 3, MOST_STATES = 4, FIRST_STATE = MOST_PARAMS };

typedef enum { ANY, POSITIVE, NONNEGATIVE, NONZERO, SIGNS } sign;

typedef struct {
    ttc_random random;
    FILE *out;
    made_table *made;
    size_t params, states;
    sign signs[MOST_PARAMS];
    bool bounded[MOST_STATES];    /* has an interval */
    polynomial field[MOST_STATES];
    polynomial radicand;          /* of the root r, 1 + e^2 */
    polynomial exponent;          /* of the exponential E; the logarithm L is of the radicand */
    bool has_root, has_angle, has_exponential, random_root, has_region;
    const char *names[VARIABLES];
} maker;

static const char *const all_names[VARIABLES] = { "a", "b", "c", "x", "y", "z", "w", "g", "h", "k", "l", "n" };

static uint64_t below(maker *m, uint64_t bound) { return ttc_random_below(&m->random, bound); }
static bool chance(maker *m, uint64_t in) { return below(m, in) == 0; }

static unsigned param_mask(const maker *m) { return (1u << m->params) - 1; }
static unsigned state_mask(const maker *m) { return ((1u << m->states) - 1) << FIRST_STATE; }
static unsigned any_mask(const maker *m) { return param_mask(m) | state_mask(m); }

/* Never zero, and no number where the mask offers variables. */
static polynomial some(maker *m, unsigned mask, size_t terms, unsigned degree)
{
    polynomial p = polynomial_random(&m->random, mask, 1 + below(m, terms), degree), one;
    size_t variable = 0;
    if (!polynomial_is_number(&p)) return p;
    while (variable < VARIABLES - 1 && (mask >> variable & 1) == 0) variable++;
    one = mask == 0 ? polynomial_number(polynomial_is_zero(&p)) : polynomial_variable(variable);
    return polynomial_add(&p, &one);
}

/* Write, every %P being replaced by the next polynomial. */
static void write_polynomials(maker *m, const char *format, const polynomial *const *list)
{
    for (const char *at = format; *at != '\0'; at++) {
        if (at[0] == '%' && at[1] == 'P') {
            polynomial_print(m->out, *list++, m->names);
            at++;
        } else {
            fputc(*at, m->out);
        }
    }
}

#define WRITE(m, format, ...) write_polynomials((m), (format), (const polynomial *const[]){ __VA_ARGS__, NULL })

/* Open a record of a claim with a name of its own: "KIND NAME". */
static void open_claim(maker *m, const char *kind, claim_truth truth)
{
    made_claim *claim = &m->made->claims[m->made->count];
    snprintf(claim->kind, sizeof claim->kind, "%s", kind);
    snprintf(claim->name, sizeof claim->name, "n%zu", m->made->count);
    claim->truth = polynomial_overflowed() ? CLAIM_OPEN : truth;
    fprintf(m->out, "%s %s", kind, claim->name);
    m->made->count++;
}

static const char *last_name(const maker *m) { return m->made->claims[m->made->count - 1].name; }

static void write_declarations(maker *m, size_t states)
{
    static const char *const conditions[SIGNS] = { "", " > 0", " >= 0", " != 0" };
    static const char *const intervals[] = { "(0, inf)", "(-1, 1)", "(-inf, -2)", "(1/3, 7)", "(0, 1)" };
    m->params = below(m, MOST_PARAMS + 1);
    m->states = states;
    fprintf(m->out, "model random\n");
    for (size_t i = 0; i < m->params; i++) {
        m->signs[i] = (sign)below(m, SIGNS);
        fprintf(m->out, "param %s%s\n", m->names[i], conditions[m->signs[i]]);
    }
    for (size_t i = 0; i < m->states; i++) {
        m->bounded[i] = chance(m, 4);
        fprintf(m->out, "state %s", m->names[FIRST_STATE + i]);
        if (m->bounded[i] && m->params > 0 && chance(m, 4)) fprintf(m->out, " in (%s, %s + 2)", m->names[0], m->names[0]);
        else if (m->bounded[i]) fprintf(m->out, " in %s", intervals[below(m, sizeof intervals / sizeof *intervals)]);
        fputc('\n', m->out);
    }
}

/* A root that is real everywhere, an angle, a let, and now and then a root that is real where it happens to be. */
static void write_definitions(maker *m)
{
    polynomial e = some(m, any_mask(m), 2, 2), square = polynomial_multiply(&e, &e), one = polynomial_number(1);
    m->has_root = chance(m, 2);
    m->has_angle = chance(m, 3);
    m->random_root = chance(m, 6);
    m->radicand = polynomial_add(&square, &one);
    if (m->has_root) {
        made_claim *claim = &m->made->claims[m->made->count++];
        *claim = (made_claim){ "root", "r", polynomial_overflowed() ? CLAIM_OPEN : CLAIM_TRUE };
        WRITE(m, "root r = sqrt%P\n", &m->radicand);
    }
    if (m->has_angle)
        fprintf(m->out, "angle C S = cos(%s) sin(%s)\nangle C2 S2 = cos(2*%s) sin(2*%s)\n", m->names[FIRST_STATE],
                m->names[FIRST_STATE], m->names[FIRST_STATE], m->names[FIRST_STATE]);
    m->has_exponential = chance(m, 5);
    m->exponent = some(m, any_mask(m), 2, 1);
    if (m->has_exponential) {
        WRITE(m, "exp E = exp%P\n", &m->exponent);
        WRITE(m, "log L = log%P\n", &m->radicand);
    }
    if (m->random_root) {
        polynomial wild = some(m, any_mask(m), 3, 2);
        WRITE(m, "root q = sqrt(%P^2 + %P)\n", &e, &wild);
        if (chance(m, 2)) WRITE(m, "root q2 = sqrt(3*%P^2 + 3*%P)\n", &e, &wild);
    }
    m->has_region = chance(m, 5);
    if (m->has_region) {
        polynomial region = some(m, any_mask(m), 2, 2);
        WRITE(m, "domain d : 5 - %P > 0\n", &region);
        open_claim(m, "positive", CLAIM_TRUE);
        WRITE(m, " : 10 - 2*%P\n", &region);
        open_claim(m, "positive", CLAIM_OPEN);
        WRITE(m, " : 4 - %P\n", &region);
    }
}

/* f = A grad(H) with an antisymmetric A: H is kept. constant: the entries of A are numbers, so that f has no divergence. */
static polynomial make_orthogonal(maker *m, bool *constant)
{
    polynomial h = some(m, any_mask(m), 4, 3);
    *constant = chance(m, 2);
    for (size_t i = 0; i < m->states; i++) m->field[i] = polynomial_zero();
    for (size_t i = 0; i < m->states; i++)
        for (size_t j = i + 1; j < m->states; j++) {
            polynomial a = *constant ? polynomial_number((long)below(m, 5) - 2) : some(m, any_mask(m), 2, 1);
            polynomial hi = polynomial_derivative(&h, FIRST_STATE + i), hj = polynomial_derivative(&h, FIRST_STATE + j);
            polynomial up = polynomial_multiply(&a, &hj), down = polynomial_multiply(&a, &hi);
            down = polynomial_scale(&down, -1);
            m->field[i] = polynomial_add(&m->field[i], &up);
            m->field[j] = polynomial_add(&m->field[j], &down);
        }
    return h;
}

/* x' = (g of the other states)' + cofactor (x - g): x = g is kept, and x - g is an integral when the cofactor is 0. */
static polynomial make_darboux(maker *m, bool integral)
{
    unsigned others = state_mask(m) & ~(1u << FIRST_STATE);
    polynomial g = some(m, others | param_mask(m), 3, 2), x = polynomial_variable(FIRST_STATE);
    polynomial minus = polynomial_scale(&g, -1), d = polynomial_add(&x, &minus);
    polynomial cofactor = integral ? polynomial_zero() : some(m, any_mask(m), 2, 1);
    m->field[0] = polynomial_multiply(&cofactor, &d);
    for (size_t i = 1; i < m->states; i++) {
        polynomial slope = polynomial_derivative(&g, FIRST_STATE + i), part;
        m->field[i] = some(m, any_mask(m), 3, 2);
        part = polynomial_multiply(&slope, &m->field[i]);
        m->field[0] = polynomial_add(&m->field[0], &part);
    }
    return d;
}

static void write_field(maker *m)
{
    for (size_t i = 0; i < m->states; i++) {
        fprintf(m->out, "eq %s = ", m->names[FIRST_STATE + i]);
        WRITE(m, "%P\n", &m->field[i]);
    }
}

static void claim_identities(maker *m)
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

static void claim_roots_and_angles(maker *m)
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

static void claim_exponentials(maker *m)
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

static void claim_rates(maker *m)
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

static void claim_orthogonal(maker *m, const polynomial *h, bool constant)
{
    polynomial e = some(m, any_mask(m), 2, 2);
    open_claim(m, "integral", CLAIM_TRUE);
    WRITE(m, " = %P\n", h);
    const char *name = last_name(m);
    open_claim(m, "equal", CLAIM_TRUE);
    WRITE(m, " : %P*%P = 0 modulo ", h, &e);
    fprintf(m->out, "%s\n", name);
    open_claim(m, "equal", CLAIM_FALSE);
    WRITE(m, " : %P*%P = 5 modulo ", h, &e);
    fprintf(m->out, "%s\n", name);
    open_claim(m, "equal", CLAIM_OPEN);
    WRITE(m, " : %P = 0 modulo ", &e);
    fprintf(m->out, "%s\n", name);
    open_claim(m, "integral", CLAIM_TRUE);
    WRITE(m, " = %P^2 + 2*%P + 2\n", h, h);
    name = last_name(m);
    open_claim(m, "equal", CLAIM_SILENT);
    WRITE(m, " : %P*%P = 0 modulo ", h, &e);
    fprintf(m->out, "%s\n", name);
    open_claim(m, "measure", constant ? CLAIM_TRUE : CLAIM_OPEN);
    fprintf(m->out, " = 1\n");
    open_claim(m, "measure", constant ? CLAIM_TRUE : CLAIM_OPEN);
    WRITE(m, " = 1/(1 + %P^2)\n", h);
}

static void claim_darboux(maker *m, const polynomial *d, bool integral)
{
    polynomial e = some(m, any_mask(m), 2, 2), x = polynomial_variable(FIRST_STATE), minus = polynomial_scale(d, -1);
    polynomial g = polynomial_add(&x, &minus);
    static const char *const shapes[] = { " = %P\n", " = %P^2\n", " = %P*(1 + %P^2)\n", " = %P^3*(2 + %P^4)\n" };
    size_t shape = below(m, 4);
    open_claim(m, "invariant", CLAIM_TRUE);
    WRITE(m, shapes[shape], d, &e);
    const char *name = last_name(m);
    open_claim(m, "equal", CLAIM_TRUE);
    fprintf(m->out, " : %s = ", m->names[FIRST_STATE]);
    WRITE(m, "%P modulo ", &g);
    fprintf(m->out, "%s\n", name);
    open_claim(m, "equal", CLAIM_FALSE);
    fprintf(m->out, " : %s = ", m->names[FIRST_STATE]);
    WRITE(m, "%P + 1 modulo ", &g);
    fprintf(m->out, "%s\n", name);
    open_claim(m, "invariant", CLAIM_SILENT);
    WRITE(m, " = 1 + %P^2\n", d);
    if (!integral) return;
    open_claim(m, "integral", CLAIM_TRUE);
    WRITE(m, " = %P\n", d);
    name = last_name(m);
    fprintf(m->out, "eliminate e0 : %s by %s = level\n", m->names[FIRST_STATE], name);
    made_claim *claim = &m->made->claims[m->made->count++];
    *claim = (made_claim){ "eliminate", "e0", m->bounded[0] ? CLAIM_OPEN : CLAIM_TRUE };
}

static void claim_signs(maker *m)
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

/* x' = M (x - e) in two states, M and e free of states: everything about the family is known. */
static void make_linear(maker *m, polynomial matrix[2][2], polynomial rest[2])
{
    for (size_t i = 0; i < 2; i++) rest[i] = some(m, param_mask(m), 2, 1);
    for (size_t i = 0; i < 2; i++) {
        m->field[i] = polynomial_zero();
        for (size_t j = 0; j < 2; j++) {
            polynomial x = polynomial_variable(FIRST_STATE + j), minus = polynomial_scale(&rest[j], -1);
            polynomial distance = polynomial_add(&x, &minus), part;
            matrix[i][j] = some(m, param_mask(m), 2, 1);
            part = polynomial_multiply(&matrix[i][j], &distance);
            m->field[i] = polynomial_add(&m->field[i], &part);
        }
    }
}

static void claim_linear(maker *m, polynomial matrix[2][2], const polynomial rest[2])
{
    const bool inside = !m->bounded[0] && !m->bounded[1] && !m->random_root && !m->has_region;
    const claim_truth yes = inside ? CLAIM_TRUE : CLAIM_OPEN;
    static const char *const kinds[] = { "trace", "matrix", "charpoly", "obstructs" };
    polynomial product = polynomial_multiply(&matrix[0][0], &matrix[1][1]);
    polynomial other = polynomial_multiply(&matrix[0][1], &matrix[1][0]);
    polynomial minus = polynomial_scale(&other, -1), determinant = polynomial_add(&product, &minus);
    polynomial trace = polynomial_add(&matrix[0][0], &matrix[1][1]);
    bool wrong = chance(m, 2);
    open_claim(m, "equilibria", yes);
    char family[sizeof m->made->claims->name];
    memcpy(family, last_name(m), sizeof family);
    fprintf(m->out, " : %s = ", m->names[FIRST_STATE]);
    WRITE(m, "%P, ", &rest[0]);
    fprintf(m->out, "%s = ", m->names[FIRST_STATE + 1]);
    WRITE(m, "%P\n", &rest[1]);
    fprintf(m->out, "trace %s = ", family);
    WRITE(m, wrong ? "%P + 1\n" : "%P\n", &trace);
    fprintf(m->out, "matrix %s = ", family);
    WRITE(m, wrong ? "%P, %P; %P, %P - 2\n" : "%P, %P; %P, %P\n", &matrix[0][0], &matrix[0][1], &matrix[1][0], &matrix[1][1]);
    fprintf(m->out, "charpoly %s = ", family);
    WRITE(m, wrong ? "lambda^2 - %P*lambda + %P + 1\n" : "lambda^2 - %P*lambda + %P\n", &trace, &determinant);
    fprintf(m->out, "obstructs %s\n", family);
    open_claim(m, "symmetry", yes);
    fprintf(m->out, " : %s -> ", m->names[FIRST_STATE]);
    WRITE(m, "2*%P - ", &rest[0]);
    fprintf(m->out, "%s, %s -> ", m->names[FIRST_STATE], m->names[FIRST_STATE + 1]);
    WRITE(m, "2*%P - ", &rest[1]);
    fprintf(m->out, "%s\n", m->names[FIRST_STATE + 1]);
    for (size_t k = 0; k < 4; k++) {
        made_claim *claim = &m->made->claims[m->made->count++];
        snprintf(claim->kind, sizeof claim->kind, "%s", kinds[k]);
        memcpy(claim->name, family, sizeof claim->name);
        claim->truth = polynomial_overflowed() || k == 3 ? CLAIM_OPEN : wrong ? CLAIM_FALSE : yes;
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

static void claim_reductions(maker *m, FILE *target)
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
static void claim_towers(maker *m)
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

static void write_table(maker *m, FILE *target)
{
    polynomial matrix[2][2], rest[2], kept = polynomial_zero();
    bool constant = false;
    const uint64_t shape = below(m, 4);
    write_declarations(m, shape == 2 ? 2 : 2 + below(m, MOST_STATES - 1));
    write_definitions(m);
    if (shape == 0) kept = make_orthogonal(m, &constant);
    else if (shape == 2) make_linear(m, matrix, rest);
    else kept = make_darboux(m, shape == 3);
    bool overflow = polynomial_overflowed();
    write_field(m);
    size_t first = m->made->count;
    claim_identities(m);
    claim_roots_and_angles(m);
    if (m->has_exponential) claim_exponentials(m);
    claim_rates(m);
    claim_signs(m);
    if (shape == 0) claim_orthogonal(m, &kept, constant);
    else if (shape == 2) claim_linear(m, matrix, rest);
    else claim_darboux(m, &kept, shape == 3);
    claim_reductions(m, target);
    if (chance(m, 8)) claim_towers(m);
    for (size_t i = first; overflow && i < m->made->count; i++) m->made->claims[i].truth = CLAIM_OPEN;
}

made_table table_make(uint64_t seed)
{
    made_table made = { 0 };
    maker m = { .random = { seed }, .made = &made };
    size_t size = 0, target_size = 0;
    memcpy(m.names, all_names, sizeof m.names);
    m.out = open_memstream(&made.text, &size);
    FILE *target = m.out != NULL ? open_memstream(&made.target, &target_size) : NULL;
    if (target != NULL) write_table(&m, target);
    bool good = target != NULL && fclose(target) == 0;
    good = m.out != NULL && fclose(m.out) == 0 && good;
    if (!good) {
        free(made.text);
        free(made.target);
        made.text = made.target = NULL;
    }
    return made;
}
