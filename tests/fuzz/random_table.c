/* A whole table, and claims that follow from how its field was made. */
#include "fuzz/random_maker.h"

#include <stdlib.h>
#include <string.h>

static const char *const all_names[VARIABLES] = { "a", "b", "c", "x", "y", "z", "w", "g", "h", "k", "l", "n" };

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
    if (target != NULL) (seed % 8 == 0 ? write_section : seed % 4 == 0 ? write_ways : write_table)(&m, target);
    bool good = target != NULL && fclose(target) == 0;
    good = m.out != NULL && fclose(m.out) == 0 && good;
    if (!good) {
        free(made.text);
        free(made.target);
        made.text = made.target = NULL;
    }
    return made;
}
