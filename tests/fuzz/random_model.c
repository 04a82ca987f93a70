/* What a random table says of its model: parameters, states, definitions, and fields of which something is known. */
#include "fuzz/random_maker.h"

uint64_t below(maker *m, uint64_t bound) { return ttc_random_below(&m->random, bound); }
bool chance(maker *m, uint64_t in) { return below(m, in) == 0; }

unsigned param_mask(const maker *m) { return (1u << m->params) - 1; }
unsigned state_mask(const maker *m) { return ((1u << m->states) - 1) << FIRST_STATE; }
unsigned any_mask(const maker *m) { return param_mask(m) | state_mask(m); }

/* Never zero, and no number where the mask offers variables. */
polynomial some(maker *m, unsigned mask, size_t terms, unsigned degree)
{
    polynomial p = polynomial_random(&m->random, mask, 1 + below(m, terms), degree), one;
    size_t variable = 0;
    if (!polynomial_is_number(&p)) return p;
    while (variable < VARIABLES - 1 && (mask >> variable & 1) == 0) variable++;
    one = mask == 0 ? polynomial_number(polynomial_is_zero(&p)) : polynomial_variable(variable);
    return polynomial_add(&p, &one);
}

/* Write, every %P being replaced by the next polynomial. */
void write_polynomials(maker *m, const char *format, const polynomial *const *list)
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

/* Open a record of a claim with a name of its own: "KIND NAME". */
void open_claim(maker *m, const char *kind, claim_truth truth)
{
    made_claim *claim = &m->made->claims[m->made->count];
    snprintf(claim->kind, sizeof claim->kind, "%s", kind);
    snprintf(claim->name, sizeof claim->name, "n%zu", m->made->count);
    claim->truth = polynomial_overflowed() ? CLAIM_OPEN : truth;
    fprintf(m->out, "%s %s", kind, claim->name);
    m->made->count++;
}

const char *last_name(const maker *m) { return m->made->claims[m->made->count - 1].name; }

void write_declarations(maker *m, size_t states)
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
void write_definitions(maker *m)
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
polynomial make_orthogonal(maker *m, bool *constant)
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
polynomial make_darboux(maker *m, bool integral)
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

void write_field(maker *m)
{
    for (size_t i = 0; i < m->states; i++) {
        fprintf(m->out, "eq %s = ", m->names[FIRST_STATE + i]);
        WRITE(m, "%P\n", &m->field[i]);
    }
}

/* x' = M (x - e) in two states, M and e free of states: everything about the family is known. */
void make_linear(maker *m, polynomial matrix[2][2], polynomial rest[2])
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
