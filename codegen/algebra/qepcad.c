#define _GNU_SOURCE /* memfd_create */
#include "algebra/qepcad.h"
#include "base/executable.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

bool ttc_qepcad_is_there(void)
{
    char *path = ttc_executable_find("qepcad");
    free(path);
    return path != NULL;
}

/* Where a variable occurs: its largest exponent, the largest degree of a term that has it, and the number of these terms. */
typedef struct {
    size_t variable, exponent, degree, terms;
    double place; /* position in the order; 0 for all: the counts above decide */
} occurrence;

static Z3_decl_kind kind_of(Z3_context z3, Z3_ast e)
{
    return Z3_get_decl_kind(z3, Z3_get_app_decl(z3, Z3_to_app(z3, e)));
}

static size_t variable_of(Z3_context z3, Z3_ast e)
{
    return (size_t)Z3_get_symbol_int(z3, Z3_get_decl_name(z3, Z3_get_app_decl(z3, Z3_to_app(z3, e))));
}

/* Count the variables of a term: of a variable alone, or of a product in which equal variables are neighbours. */
static void count_term(Z3_context z3, Z3_ast term, occurrence *of)
{
    const bool is_product = kind_of(z3, term) == Z3_OP_MUL;
    const unsigned count = is_product ? Z3_get_app_num_args(z3, Z3_to_app(z3, term)) : 1;
    size_t before = SIZE_MAX, exponent = 0;
    for (unsigned i = 0; i < count; i++) {
        Z3_ast factor = is_product ? Z3_get_app_arg(z3, Z3_to_app(z3, term), i) : term;
        if (Z3_is_numeral_ast(z3, factor)) continue;
        occurrence *o = &of[variable_of(z3, factor)];
        exponent = o->variable == before ? exponent + 1 : 1;
        before = o->variable;
        if (exponent == 1) o->terms++;
        if (exponent > o->exponent) o->exponent = exponent;
        if (count > o->degree) o->degree = count;
    }
}

static void count_variables(Z3_context z3, Z3_ast e, occurrence *of)
{
    if (Z3_is_numeral_ast(z3, e)) return;
    const Z3_decl_kind kind = kind_of(z3, e);
    if (kind == Z3_OP_MUL || kind == Z3_OP_UNINTERPRETED) {
        count_term(z3, e, of);
        return;
    }
    for (unsigned i = 0; i < Z3_get_app_num_args(z3, Z3_to_app(z3, e)); i++)
        count_variables(z3, Z3_get_app_arg(z3, Z3_to_app(z3, e), i), of);
}

/* Variables that do not occur come last. Of the others, the last is eliminated first: that of the lowest exponents (C. W. Brown's
 * order). */
static int compare(const void *left, const void *right)
{
    const occurrence *a = left, *b = right;
    if ((a->terms > 0) != (b->terms > 0)) return a->terms > 0 ? -1 : 1;
    if (a->place < b->place || a->place > b->place) return a->place < b->place ? -1 : 1;
    if (a->exponent != b->exponent) return a->exponent < b->exponent ? 1 : -1;
    if (a->degree != b->degree) return a->degree < b->degree ? 1 : -1;
    if (a->terms != b->terms) return a->terms < b->terms ? 1 : -1;
    return (a->variable > b->variable) - (a->variable < b->variable);
}

/* Eliminate every root just before the variables of its square. In/out: order, sorted. */
static void move_roots(const ttc_ring *ring, occurrence *order)
{
    double *place = calloc(ring->variable_count + 1, sizeof *place);
    if (place == NULL) return;
    for (size_t i = 0; i < ring->variable_count; i++) place[order[i].variable] = (double)(i + 1);
    for (size_t i = 0; i < ring->generator_count; i++) {
        const ttc_generator *root = &ring->generators[i];
        double last = 0;
        for (size_t v = 0; v < ring->variable_count; v++)
            if (fmpz_mpoly_degree_si(root->square.numerator, (slong)v, ring->context) > 0 ||
                fmpz_mpoly_degree_si(root->square.denominator, (slong)v, ring->context) > 0)
                last = fmax(last, place[v]);
        place[root->variable] = last + 1e-6 * (double)(i + 1);
    }
    for (size_t i = 0; i < ring->variable_count; i++) order[i].place = place[order[i].variable];
    qsort(order, ring->variable_count, sizeof *order, compare);
    free(place);
}

static const char *operator_of(Z3_decl_kind kind)
{
    switch (kind) {
    case Z3_OP_ADD: return " + ";
    case Z3_OP_MUL: return " ";
    case Z3_OP_EQ: return " = ";
    case Z3_OP_GT: return " > ";
    case Z3_OP_GE: return " >= ";
    case Z3_OP_OR: return " \\/ ";
    case Z3_OP_NOT: return "~ ";
    default: return "?"; /* QEPCAD does not read it, and gives no answer */
    }
}

static void write_formula(FILE *out, Z3_context z3, Z3_ast e)
{
    if (Z3_is_numeral_ast(z3, e)) {
        fprintf(out, "(%s)", Z3_get_numeral_string(z3, e));
        return;
    }
    const Z3_decl_kind kind = kind_of(z3, e);
    if (kind == Z3_OP_UNINTERPRETED) {
        fprintf(out, "x%zu", variable_of(z3, e));
        return;
    }
    const bool is_sum = kind == Z3_OP_ADD, is_product = kind == Z3_OP_MUL;
    fputs(is_sum ? "(" : is_product ? "" : "[", out);
    for (unsigned i = 0; i < Z3_get_app_num_args(z3, Z3_to_app(z3, e)); i++) {
        if (i > 0 || kind == Z3_OP_NOT) fputs(operator_of(kind), out);
        write_formula(out, z3, Z3_get_app_arg(z3, Z3_to_app(z3, e), i));
    }
    fputs(is_sum ? ")" : is_product ? "" : "]", out);
}

/* "Is there a point?" Variables that do not occur are left out; x0 stands in if there is none at all. */
static void write_question(FILE *out, Z3_context z3, const Z3_ast *conditions, size_t count, const occurrence *order, size_t used)
{
    fputs("[]\n(", out);
    for (size_t i = 0; i < used; i++) fprintf(out, "%sx%zu", i == 0 ? "" : ",", order[i].variable);
    fputs(")\n0\n", out);
    for (size_t i = 0; i < used; i++) fprintf(out, "(E x%zu)", order[i].variable);
    fputs("[", out);
    for (size_t i = 0; i < count; i++) {
        if (i > 0) fputs(" /\\ ", out);
        write_formula(out, z3, conditions[i]);
    }
    fputs("].\nfinish\n", out);
}

static void run(FILE *question, FILE *answer, unsigned seconds)
{
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        const struct rlimit time = { seconds, seconds }, size = { 1 << 20, 1 << 20 }, none = { 0, 0 };
        prctl(PR_SET_PDEATHSIG, SIGTERM); /* when this program ends, so does QEPCAD */
        if (getppid() != parent) _exit(127);
        setrlimit(RLIMIT_CPU, &time);
        setrlimit(RLIMIT_FSIZE, &size);
        setrlimit(RLIMIT_CORE, &none);
        alarm(10 * seconds); /* it may wait for something, and use no time of the processor */
        dup2(fileno(question), STDIN_FILENO);
        dup2(fileno(answer), STDOUT_FILENO);
        dup2(fileno(answer), STDERR_FILENO);
        execlp("qepcad", "qepcad", "-noecho", "+N2000000", (char *)NULL);
        _exit(127);
    }
    while (child > 0 && waitpid(child, NULL, 0) < 0 && errno == EINTR) {}
}

/* Returns true if the answer is FALSE. An answer with an error, or with a warning that the decomposition may not be valid, does not
 * count. */
static bool says_false(FILE *answer)
{
    static const char *const doubts[] = { "rror", "ERROR", "arning", "WARNING", "not be valid" };
    static const char before[] = "An equivalent quantifier-free formula:";
    char *line = NULL;
    size_t size = 0;
    bool found = false, doubtful = false, none = false;
    rewind(answer);
    while (getline(&line, &size, answer) > 0) {
        for (size_t i = 0; i < sizeof doubts / sizeof *doubts; i++) doubtful |= strstr(line, doubts[i]) != NULL;
        none |= found && strcmp(line, "FALSE\n") == 0;
        found |= strncmp(line, before, sizeof before - 1) == 0;
    }
    free(line);
    return none && !doubtful;
}

/* A file in memory, which no full or closed folder of temporary files can refuse; NULL: memory is out. */
static FILE *open_file(const char *name)
{
    const int descriptor = memfd_create(name, MFD_CLOEXEC);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "w+") : NULL;
    if (file == NULL && descriptor >= 0) close(descriptor);
    return file;
}

static bool finds_none(Z3_context z3, const ttc_ring *ring, const Z3_ast *conditions, size_t count, bool by_roots,
                       unsigned seconds)
{
    occurrence *order = calloc(ring->variable_count + 1, sizeof *order);
    FILE *question = open_file("question"), *answer = open_file("answer");
    bool none = false;
    if (order != NULL && question != NULL && answer != NULL) {
        size_t used = 0;
        for (size_t i = 0; i < ring->variable_count; i++) order[i].variable = i;
        for (size_t i = 0; i < count; i++) count_variables(z3, conditions[i], order);
        qsort(order, ring->variable_count, sizeof *order, compare);
        if (by_roots) move_roots(ring, order);
        while (used < ring->variable_count && order[used].terms > 0) used++;
        write_question(question, z3, conditions, count, order, used > 0 ? used : 1);
        if (fflush(question) == 0 && !ferror(question) && fseek(question, 0, SEEK_SET) == 0) run(question, answer, seconds);
        none = says_false(answer);
    }
    if (answer != NULL) fclose(answer);
    if (question != NULL) fclose(question);
    free(order);
    return none;
}

bool ttc_qepcad_finds_none(Z3_context z3, const ttc_ring *ring, const Z3_ast *conditions, size_t count, unsigned seconds)
{
    return finds_none(z3, ring, conditions, count, false, seconds) ||
           (ring->generator_count > 0 && finds_none(z3, ring, conditions, count, true, seconds));
}
