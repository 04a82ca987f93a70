/* Tables that serve in place of each other: target.tt has fewer states, on levels; or more; or an angle in place of two. That they
 * do, and that a slip in them is one, follows from how they are made: states are those of the other table through polynomials whose
 * inverse is one. */
#include "fuzz/random_maker.h"

#include <stdlib.h>

static const char *const small_names[MOST_STATES] = { "u", "v", "o", "p" };
static const char *const level_names[MOST_STATES] = { "g", "h", "k", "l" };

/* "(P)" in other names, for free(). */
static char *spell(const polynomial *p, const char *const *names)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL) abort();
    polynomial_print(out, p, names);
    if (fclose(out) != 0) abort();
    return text;
}

static char *join(const char *a, const char *between, const char *b)
{
    char *text = NULL;
    if (asprintf(&text, "(%s%s%s)", a, between, b) < 0) abort();
    return text;
}

static void write_params(const maker *m, FILE *out)
{
    static const char *const conditions[SIGNS] = { "", " > 0", " >= 0", " != 0" };
    for (size_t i = 0; i < m->params; i++) fprintf(out, "param %s%s\n", m->names[i], conditions[m->signs[i]]);
}

/* Later states make the shift between state i of the one table and that of the other. */
typedef struct {
    polynomial shift[MOST_STATES], rate[MOST_STATES];
    char *ahead[MOST_STATES];  /* the model's states in the other table's names */
    char *behind[MOST_STATES]; /* the other table's in the model's */
} triangle;

static triangle make_triangle(maker *m, size_t kept, const char *const *other)
{
    triangle t;
    const char *names[VARIABLES];
    for (size_t i = 0; i < VARIABLES; i++) names[i] = m->names[i];
    for (size_t i = m->states; i-- > 0;) {
        const unsigned later = state_mask(m) & ~((2u << (FIRST_STATE + i)) - 1);
        t.shift[i] = later == 0 ? polynomial_zero() : some(m, later | param_mask(m), 2, 2);
        t.rate[i] = i < kept ? some(m, any_mask(m), 3, 2) : polynomial_zero();
        char *ahead = spell(&t.shift[i], names), *behind = spell(&t.shift[i], m->names);
        t.ahead[i] = join(other[i], " + ", ahead);
        t.behind[i] = join(m->names[FIRST_STATE + i], " - ", behind);
        names[FIRST_STATE + i] = t.ahead[i];
        free(ahead);
        free(behind);
    }
    return t;
}

static void clear_triangle(const maker *m, triangle *t)
{
    for (size_t i = 0; i < m->states; i++) {
        free(t->ahead[i]);
        free(t->behind[i]);
    }
}

/* x_i' = (rate of the other's state) + (shift)': the shift is of later states, whose rates are there already. */
static void write_model(maker *m, const triangle *t)
{
    const char *names[VARIABLES];
    char *rates[MOST_STATES];
    for (size_t i = 0; i < VARIABLES; i++) names[i] = m->names[i];
    for (size_t i = 0; i < m->states; i++) names[FIRST_STATE + i] = t->behind[i];
    for (size_t i = m->states; i-- > 0;) {
        rates[i] = spell(&t->rate[i], names);
        for (size_t j = i + 1; j < m->states; j++) {
            const polynomial slope = polynomial_derivative(&t->shift[i], FIRST_STATE + j);
            char *factor = spell(&slope, m->names), *part = join(factor, "*", rates[j]), *sum = join(rates[i], " + ", part);
            free(factor);
            free(part);
            free(rates[i]);
            rates[i] = sum;
        }
    }
    for (size_t i = 0; i < m->states; i++) {
        fprintf(m->out, "eq %s = %s\n", m->names[FIRST_STATE + i], rates[i]);
        free(rates[i]);
    }
}

typedef enum { WAY_RIGHT, WAY_OFF, WAY_EXCHANGED } slip;

static void write_way(maker *m, const triangle *t, size_t kept, bool by_root, slip what, const char *where)
{
    fprintf(m->out, " : by target.tt with");
    for (size_t i = 0; i < kept; i++)
        fprintf(m->out, "%s %s = %s%s", i > 0 ? "," : "", small_names[i],
                t->behind[what == WAY_EXCHANGED && i < 2 ? 1 - i : i], what == WAY_OFF && i == 0 ? " + 1" : "");
    for (size_t i = kept; i < m->states; i++)
        fprintf(m->out, by_root && i == kept ? ", %s = sqrt(level%zu)" : ", %s = level%zu", level_names[i - kept], i - kept);
    fprintf(m->out, "%s\n", where);
}

/* Fewer states, on levels. The first level may be the square of a parameter. */
static void write_descent(maker *m, FILE *target)
{
    const size_t kept = 1 + below(m, m->states - 1);
    const bool bounded = chance(m, 3), by_root = chance(m, 3), wrong_motion = chance(m, 4), narrow_level = chance(m, 3);
    const bool unsigned_root = by_root && chance(m, 3); /* a square has two */
    const char *other[MOST_STATES], *squared = "(g^2)";
    char where[4096], *inside = NULL;
    for (size_t i = 0; i < m->states; i++) other[i] = i < kept ? small_names[i] : level_names[i - kept];
    if (by_root) other[kept] = squared;
    triangle t = make_triangle(m, kept, other);
    write_model(m, &t);

    fprintf(target, "model target\n");
    write_params(m, target);
    for (size_t i = kept; i < m->states; i++)
        fprintf(target, "param %s%s\n", level_names[i - kept],
                i > kept       ? ""
                : by_root      ? (unsigned_root ? "" : " >= 0")
                : narrow_level ? " != 0"
                               : "");
    for (size_t i = 0; i < kept; i++) fprintf(target, "state %s%s\n", small_names[i], bounded && i == 0 ? " in (0, 1)" : "");
    const char *names[VARIABLES];
    for (size_t i = 0; i < VARIABLES; i++) names[i] = m->names[i];
    for (size_t i = 0; i < m->states; i++) names[FIRST_STATE + i] = other[i];
    for (size_t i = 0; i < kept; i++) {
        fprintf(target, "eq %s = ", small_names[i]);
        polynomial_print(target, &t.rate[i], names);
        fprintf(target, wrong_motion && i == 0 ? " + 1\n" : "\n");
    }
    fprintf(target, "embedding back : into random.tt with");
    for (size_t i = 0; i < m->states; i++)
        fprintf(target, "%s %s = %s", i > 0 ? "," : "", m->names[FIRST_STATE + i], t.ahead[i]);
    fprintf(target, "\n");

    for (size_t i = kept; i < m->states; i++) fprintf(m->out, "integral level%zu = %s\n", i - kept, t.behind[i]);
    /* A negative level has no root, one that is zero no parameter that cannot be, and states fill more than the interval. */
    const bool leaves = bounded || by_root || narrow_level;
    const claim_truth right = wrong_motion || unsigned_root ? CLAIM_FALSE : CLAIM_TRUE;
    open_claim(m, "reduction", leaves ? CLAIM_FALSE : right);
    write_way(m, &t, kept, by_root, WAY_RIGHT, "");
    if (asprintf(&inside, "%s > 0, 1 - %s > 0, %s%s > 0", t.behind[0], t.behind[0], t.behind[kept], by_root ? "" : "^2") < 0)
        abort();
    snprintf(where, sizeof where, " where %s", inside);
    free(inside);
    open_claim(m, "reduction", right);
    write_way(m, &t, kept, by_root, WAY_RIGHT, where);
    open_claim(m, "reduction", CLAIM_FALSE);
    write_way(m, &t, kept, by_root, WAY_OFF, "");
    if (kept > 1) {
        open_claim(m, "reduction", CLAIM_FALSE);
        write_way(m, &t, kept, by_root, WAY_EXCHANGED, "");
    }
    const polynomial e = some(m, any_mask(m), 2, 2);
    char *never = spell(&e, m->names);
    snprintf(where, sizeof where, " where -1 - %s^2 > 0", never);
    free(never);
    open_claim(m, "reduction", wrong_motion || unsigned_root ? CLAIM_OPEN : CLAIM_SILENT);
    write_way(m, &t, kept, by_root, WAY_RIGHT, where);
    clear_triangle(m, &t);
}

/* More states: those of the model, shifted by what is new. */
static void write_rise(maker *m, FILE *target)
{
    const bool bounded = chance(m, 3);
    const char *names[VARIABLES];
    const polynomial shift = some(m, (7u << (FIRST_STATE + MOST_STATES)) | param_mask(m), 2, 2), added = some(m, any_mask(m), 2, 2);
    for (size_t i = 0; i < VARIABLES; i++) names[i] = m->names[i];
    for (size_t i = 0; i < m->states; i++) m->field[i] = some(m, any_mask(m), 3, 2);
    write_field(m);
    /* The new states are called as the levels are: g, h, k. Only the first is there to move. */
    fprintf(target, "model target\n");
    write_params(m, target);
    for (size_t i = 0; i < m->states; i++) fprintf(target, "state %s\n", small_names[i]);
    fprintf(target, "state g%s\nstate h\nstate k\n", bounded ? " in (-1, 1)" : "");
    char *behind = spell(&shift, names), *first = join("u", " - ", behind);
    names[FIRST_STATE] = first;
    for (size_t i = 1; i < m->states; i++) names[FIRST_STATE + i] = small_names[i];
    const polynomial slope = polynomial_derivative(&shift, FIRST_STATE + MOST_STATES);
    for (size_t i = 0; i < m->states; i++) {
        fprintf(target, "eq %s = ", small_names[i]);
        polynomial_print(target, &m->field[i], names);
        if (i == 0) {
            fprintf(target, " + ");
            polynomial_print(target, &slope, names);
            fprintf(target, "*");
            polynomial_print(target, &added, names);
        }
        fprintf(target, "\n");
    }
    fprintf(target, "eq g = ");
    polynomial_print(target, &added, names);
    fprintf(target, "\neq h = 0\neq k = 0\nreduction back : onto random.tt with %s = %s", m->names[FIRST_STATE], first);
    for (size_t i = 1; i < m->states; i++) fprintf(target, ", %s = %s", m->names[FIRST_STATE + i], small_names[i]);
    fprintf(target, "\n");

    static const struct {
        const char *g, *h, *k, *more;
        bool may_leave, off;
    } lifts[] = { { "0", "0", "0", "", false, false },  { "1/2", "0", "2", "", false, false }, { "2", "0", "0", "", true, false },
                  { "0", "0", "0",
                    " + 1", false, true }, { "x", "y", "x*y", "", true, false },  { "0", "x^2", "-y", "", false, false } };
    for (size_t k = 0; k < sizeof lifts / sizeof *lifts; k++) {
        const char *at[VARIABLES];
        for (size_t i = 0; i < VARIABLES; i++) at[i] = m->names[i];
        at[FIRST_STATE + MOST_STATES] = lifts[k].g;
        at[FIRST_STATE + MOST_STATES + 1] = lifts[k].h;
        at[FIRST_STATE + MOST_STATES + 2] = lifts[k].k;
        char *moved = NULL;
        const char *held[VARIABLES];
        char brackets[3][16];
        for (size_t i = 0; i < VARIABLES; i++) held[i] = at[i];
        for (size_t i = 0; i < 3; i++) {
            snprintf(brackets[i], sizeof *brackets, "(%s)", at[FIRST_STATE + MOST_STATES + i]);
            held[FIRST_STATE + MOST_STATES + i] = brackets[i];
        }
        moved = spell(&shift, held);
        open_claim(m, "lift", lifts[k].off || (bounded && lifts[k].may_leave) ? CLAIM_FALSE : CLAIM_TRUE);
        fprintf(m->out, " : into target.tt with u = %s + %s%s", m->names[FIRST_STATE], moved, lifts[k].more);
        for (size_t i = 1; i < m->states; i++) fprintf(m->out, ", %s = %s", small_names[i], m->names[FIRST_STATE + i]);
        fprintf(m->out, ", g = %s, h = %s, k = %s\n", lifts[k].g, lifts[k].h, lifts[k].k);
        free(moved);
    }
    free(behind);
    free(first);
}

/* x = A cos u, y = A sin u, which keep A, beside any other states. */
static void write_turning(maker *m, FILE *target)
{
    static const char *const conditions[] = { "", " > 0", " >= 0" };
    static const struct {
        const char *angle, *root;
        claim_truth truth;
    } shapes[] = { { "atan2(y, x)", "x^2 + y^2", CLAIM_TRUE },        { "atan2(3*y, 3*x)", "x^2 + y^2", CLAIM_TRUE },
                   { "atan2(x, y)", "x^2 + y^2", CLAIM_FALSE },       { "atan2(-y, x)", "x^2 + y^2", CLAIM_FALSE },
                   { "atan2(y, x)", "x^2 + y^2 + 1", CLAIM_FALSE },   { "atan2(y, x)", "4*x^2 + 4*y^2", CLAIM_FALSE },
                   { "atan2(-y, -x)", "x^2 + y^2", CLAIM_FALSE },     { "atan2(y*(1 + x^2), x + x^3)", "x^2 + y^2", CLAIM_TRUE } };
    const size_t condition = below(m, 3);
    const bool backwards = chance(m, 4);
    const unsigned slow = any_mask(m) & ~(3u << FIRST_STATE);
    const polynomial pace = some(m, slow | 1u << (FIRST_STATE + MOST_STATES), 3, 2);
    const char *names[VARIABLES];
    for (size_t i = 0; i < VARIABLES; i++) names[i] = m->names[i];
    names[FIRST_STATE + MOST_STATES] = "(x^2 + y^2)";
    char *turn = spell(&pace, names);
    fprintf(m->out, "eq x = -y*%s\neq y = x*%s\n", turn, turn);
    free(turn);
    for (size_t i = 2; i < m->states; i++) {
        m->field[i] = some(m, any_mask(m), 3, 2);
        fprintf(m->out, "eq %s = ", m->names[FIRST_STATE + i]);
        WRITE(m, "%P\n", &m->field[i]);
    }
    fprintf(target, "model target\n");
    write_params(m, target);
    fprintf(target, "param A%s\nstate u\nangle C S = cos(u) sin(u)\n", conditions[condition]);
    for (size_t i = 2; i < m->states; i++) fprintf(target, "state %s\n", small_names[i]);
    names[FIRST_STATE] = "(A*C)";
    names[FIRST_STATE + 1] = "(A*S)";
    for (size_t i = 2; i < m->states; i++) names[FIRST_STATE + i] = small_names[i];
    names[FIRST_STATE + MOST_STATES] = "(A^2)";
    fprintf(target, "eq u = %s", backwards ? "-" : "");
    polynomial_print(target, &pace, names);
    for (size_t i = 2; i < m->states; i++) {
        fprintf(target, "\neq %s = ", small_names[i]);
        polynomial_print(target, &m->field[i], names);
    }
    fprintf(target, "\nembedding back : into random.tt with x = A*C, y = A*S");
    for (size_t i = 2; i < m->states; i++) fprintf(target, ", %s = %s", m->names[FIRST_STATE + i], small_names[i]);
    fprintf(target, "\n");
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++) {
        /* Without a sign A leads to its opposite, and half a turn away. */
        open_claim(m, "reduction", backwards || condition == 0 ? CLAIM_FALSE : shapes[k].truth);
        fprintf(m->out, " : by target.tt with u = %s, A = sqrt(%s)", shapes[k].angle, shapes[k].root);
        for (size_t i = 2; i < m->states; i++) fprintf(m->out, ", %s = %s", small_names[i], m->names[FIRST_STATE + i]);
        fprintf(m->out, "\n");
    }
}

void write_ways(maker *m, FILE *target)
{
    m->params = below(m, MOST_PARAMS + 1);
    m->states = 2 + below(m, MOST_STATES - 1);
    for (size_t i = 0; i < m->params; i++) m->signs[i] = (sign)below(m, SIGNS);
    fprintf(m->out, "model random\n");
    write_params(m, m->out);
    for (size_t i = 0; i < m->states; i++) fprintf(m->out, "state %s\n", m->names[FIRST_STATE + i]);
    switch (below(m, 3)) {
    case 0: write_rise(m, target); return;
    case 1: write_turning(m, target); return;
    default: write_descent(m, target); return;
    }
}
