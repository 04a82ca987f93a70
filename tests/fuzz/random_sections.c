/* Sections with coordinates: x' = y, and y^2 + potential is an integral, so that y is a root on its levels where x is a number; the
 * other states are coordinates, shifted by polynomials of each other. */
#include "fuzz/random_maker.h"

#include <stdlib.h>
#include <string.h>

static const char *const coordinate_names[] = { "u", "v" };

static char *print(const polynomial *p, const char *const *names)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL) abort();
    polynomial_print(out, p, names);
    if (fclose(out) != 0) abort();
    return text;
}

/* z' = y r, and y' = -(dV/dx + sum of dV/dz r)/2: y^2 + V is kept. */
static void write_motion(maker *m, const polynomial *potential, bool kept)
{
    polynomial slope = polynomial_derivative(potential, FIRST_STATE);
    fprintf(m->out, "eq x = y\n");
    for (size_t i = 2; i < m->states; i++) {
        const polynomial r = some(m, any_mask(m), 2, 2), along = polynomial_derivative(potential, FIRST_STATE + i);
        const polynomial part = polynomial_multiply(&along, &r);
        slope = polynomial_add(&slope, &part);
        fprintf(m->out, "eq %s = y*", m->names[FIRST_STATE + i]);
        WRITE(m, "%P\n", &r);
    }
    WRITE(m, kept ? "eq y = -1/2*%P\n" : "eq y = -1/2*%P - 1\n", &slope);
    open_claim(m, "integral", kept ? CLAIM_TRUE : CLAIM_FALSE);
    WRITE(m, " = y^2 + %P\n", potential);
}

typedef enum { CHART_RIGHT, CHART_HALF, CHART_LEVEL, CHART_BESIDE, CHART_SHIFTED, CHART_SIGNED, CHARTS } chart_slip;

void write_section(maker *m, FILE *target)
{
    m->params = below(m, MOST_PARAMS + 1);
    m->states = 2 + below(m, 3);
    for (size_t i = 0; i < m->params; i++) m->signs[i] = ANY;
    fprintf(m->out, "model random\n");
    for (size_t i = 0; i < m->params; i++) fprintf(m->out, "param %s\n", m->names[i]);
    for (size_t i = 0; i < m->states; i++) fprintf(m->out, "state %s\n", m->names[FIRST_STATE + i]);

    /* The potential does not hold y; what is added keeps a region of every level. */
    const unsigned places = any_mask(m) & ~(2u << FIRST_STATE);
    const polynomial potential = some(m, places, 3, 2), second = some(m, param_mask(m) | 8u << FIRST_STATE, 2, 2);
    const bool kept = !chance(m, 6), backwards = chance(m, 2), shifts = m->states > 3 && chance(m, 2);
    const chart_slip slip = m->states == 2 && chance(m, 2) ? CHART_RIGHT : (chart_slip)below(m, CHARTS);
    const int at = (int)below(m, 5) - 2;
    write_motion(m, &potential, kept);
    char integral[sizeof m->made->claims->name];
    snprintf(integral, sizeof integral, "%s", last_name(m));

    /* z = u + shift(v), w = v */
    const char *names[VARIABLES], *held[VARIABLES];
    char place[16], *shift, *ahead = NULL, *behind = NULL;
    for (size_t i = 0; i < VARIABLES; i++) names[i] = held[i] = m->names[i];
    snprintf(place, sizeof place, "(%d)", at);
    names[FIRST_STATE] = place;
    names[FIRST_STATE + 3] = "v";
    shift = shifts ? print(&second, names) : strdup("0");
    if (asprintf(&ahead, "(u + %s)", shift) < 0) abort();
    free(shift);
    shift = shifts ? print(&second, held) : strdup("0");
    if (asprintf(&behind, "(z - %s)", shift) < 0) abort();
    free(shift);
    names[FIRST_STATE + 2] = ahead;
    fprintf(target, "model target\n");
    for (size_t i = 0; i < m->params; i++) fprintf(target, "param %s\n", m->names[i]);
    fprintf(target, "param g\n");
    for (size_t i = 2; i < m->states; i++)
        fprintf(target, "state %s%s\n", coordinate_names[i - 2], slip == CHART_HALF && i == 2 ? " in (0, inf)" : "");
    char *value = print(&potential, names);
    fprintf(target, "let square = g - %s%s\ndomain inside : square > 0\nroot s = sqrt(square)\n", value,
            slip == CHART_LEVEL ? " - 1" : "");
    free(value);
    fprintf(target, "lift into random.tt with x = %d%s, y = %ss", at, slip == CHART_BESIDE ? " + s" : "", backwards ? "-" : "");
    if (m->states > 2) fprintf(target, ", z = %s%s", ahead, slip == CHART_SHIFTED ? " + 1" : slip == CHART_SIGNED ? "*s/s" : "");
    if (m->states > 3) fprintf(target, ", w = v");
    fprintf(target, "\n");

    const bool wrong = !kept || slip == CHART_LEVEL || slip == CHART_BESIDE ||
                       (m->states > 2 && (slip == CHART_SHIFTED || slip == CHART_HALF));
    for (int k = 0; k < 3; k++) {
        /* The second way back is off, unless the lift is so by as much; the third is at another value of x. */
        const bool shifted_back = k == 1 && slip == CHART_SHIFTED, off = (wrong && !shifted_back) || k > 0;
        open_claim(m, "section", m->states == 2 || shifted_back ? CLAIM_OPEN : off ? CLAIM_FALSE : CLAIM_TRUE);
        fprintf(m->out, " : by target.tt at x = %d with", k == 2 ? at + 1 : at);
        if (m->states > 2) fprintf(m->out, " u = %s%s,", behind, k == 1 ? " - 1" : "");
        if (m->states > 3) fprintf(m->out, " v = w,");
        fprintf(m->out, " g = %s\n", integral);
    }
    free(ahead);
    free(behind);
}
