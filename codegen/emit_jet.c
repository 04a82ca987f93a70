/* Taylor coefficients of the solution, order by order, from the program of the field: each operation becomes the recurrence of
 * its series (R. E. Moore, Interval Analysis, 1966; A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., 2008, ch. 13).
 * What depends on parameters alone stays a number. */
#include "emit.h"

#include <stdlib.h>

typedef struct {
    ttc_text *text;
    const ttc_program *program;
    bool *series; /* by value: depends on states */
} jet;

static void add_name(jet *j, ttc_value value)
{
    const ttc_instruction *i = ttc_program_at(j->program, value);
    if (i->op == TTC_OP_INPUT) ttc_text_format(j->text, "x%u", i->index);
    else if (i->op == TTC_OP_PARAMETER) ttc_text_format(j->text, "p[%u]", i->index);
    else if (i->op == TTC_OP_CONSTANT) ttc_emit_constant(j->text, i->constant);
    else ttc_text_format(j->text, "t%u", value);
}

/* Coefficient k of an operand; a number has only the one of order 0. */
static void add_coefficient(jet *j, ttc_value value)
{
    if (j->series[value]) {
        add_name(j, value);
        ttc_text_add(j->text, "[k]");
    } else {
        ttc_text_add(j->text, "(k == 0 ? ");
        add_name(j, value);
        ttc_text_add(j->text, " : 0)");
    }
}

static void add_product(jet *j, ttc_value a, ttc_value b)
{
    if (j->series[a] && j->series[b]) {
        ttc_text_add(j->text, "jlt_jet_product(");
        add_name(j, a);
        ttc_text_add(j->text, ", ");
        add_name(j, b);
        ttc_text_add(j->text, ", k)");
        return;
    }
    add_name(j, a);
    ttc_text_add(j->text, j->series[a] ? "[k]*" : "*");
    add_name(j, b);
    if (j->series[b]) ttc_text_add(j->text, "[k]");
}

static void add_quotient(jet *j, ttc_value value, const ttc_instruction *i)
{
    if (!j->series[i->b]) {
        add_coefficient(j, i->a);
        ttc_text_add(j->text, "/");
        add_name(j, i->b);
        return;
    }
    ttc_text_add(j->text, "jlt_jet_quotient(");
    add_coefficient(j, i->a);
    ttc_text_add(j->text, ", ");
    add_name(j, i->b);
    ttc_text_format(j->text, ", t%u, k)", value);
}

static void add_sum(jet *j, ttc_value a, const char *sign, ttc_value b)
{
    add_coefficient(j, a);
    ttc_text_format(j->text, " %s ", sign);
    add_coefficient(j, b);
}

static void add_recurrence(jet *j, ttc_value value, const ttc_instruction *i)
{
    ttc_text_format(j->text, "        t%u[k] = ", value);
    switch (i->op) {
    case TTC_OP_NEGATE:
        ttc_text_add(j->text, "-");
        add_coefficient(j, i->a);
        break;
    case TTC_OP_ADD:
        add_sum(j, i->a, "+", i->b);
        break;
    case TTC_OP_SUBTRACT:
        add_sum(j, i->a, "-", i->b);
        break;
    case TTC_OP_MULTIPLY:
        add_product(j, i->a, i->b);
        break;
    case TTC_OP_DIVIDE:
        add_quotient(j, value, i);
        break;
    case TTC_OP_FMA:
    case TTC_OP_FMS:
        if (j->series[i->a] || j->series[i->b]) add_product(j, i->a, i->b);
        else ttc_text_add(j->text, "(k == 0 ? "), add_product(j, i->a, i->b), ttc_text_add(j->text, " : 0)");
        ttc_text_add(j->text, i->op == TTC_OP_FMA ? " + " : " - ");
        add_coefficient(j, i->c);
        break;
    case TTC_OP_FNMA:
        add_coefficient(j, i->c);
        ttc_text_add(j->text, " - ");
        if (j->series[i->a] || j->series[i->b]) add_product(j, i->a, i->b);
        else ttc_text_add(j->text, "(k == 0 ? "), add_product(j, i->a, i->b), ttc_text_add(j->text, " : 0)");
        break;
    case TTC_OP_ROOT:
        ttc_text_add(j->text, "jlt_jet_root(");
        add_coefficient(j, i->a);
        ttc_text_format(j->text, ", t%u, k)", value);
        break;
    default:
        ttc_text_format(j->text, "jlt_jet_%s(", i->op == TTC_OP_COSINE ? "cosine" : "sine");
        add_name(j, i->a);
        ttc_text_format(j->text, ", t%u, u%u, k)", value, value);
        break;
    }
    ttc_text_add(j->text, ";\n");
}

/* The numbers: what depends on parameters alone. */
static void add_number(jet *j, ttc_value value, const ttc_instruction *i)
{
    static const char *const signs[] = {
        [TTC_OP_ADD] = " + ", [TTC_OP_SUBTRACT] = " - ", [TTC_OP_MULTIPLY] = "*", [TTC_OP_DIVIDE] = "/",
        [TTC_OP_FMA] = " + ", [TTC_OP_FMS] = " - ",      [TTC_OP_FNMA] = " - ",
    };
    ttc_text_format(j->text, "    const double t%u = ", value);
    switch (i->op) {
    case TTC_OP_NEGATE:
    case TTC_OP_ROOT:
    case TTC_OP_COSINE:
    case TTC_OP_SINE:
        ttc_text_add(j->text, i->op == TTC_OP_NEGATE   ? "-("
                              : i->op == TTC_OP_ROOT   ? "sqrt("
                              : i->op == TTC_OP_COSINE ? "cos("
                                                       : "sin(");
        add_name(j, i->a);
        ttc_text_add(j->text, ")");
        break;
    case TTC_OP_FNMA:
        add_name(j, i->c);
        ttc_text_add(j->text, " - ");
        add_product(j, i->a, i->b);
        break;
    case TTC_OP_FMA:
    case TTC_OP_FMS:
        add_product(j, i->a, i->b);
        ttc_text_add(j->text, signs[i->op]);
        add_name(j, i->c);
        break;
    default:
        add_name(j, i->a);
        ttc_text_add(j->text, signs[i->op]);
        add_name(j, i->b);
        break;
    }
    ttc_text_add(j->text, ";\n");
}

static void add_declarations(jet *j, size_t states)
{
    for (size_t i = 0; i < states; i++) ttc_text_format(j->text, "    double x%zu[JLT_JET_ORDER_MAX + 1];\n", i);
    for (size_t v = 0; v < ttc_program_size(j->program); v++) {
        const ttc_instruction *i = ttc_program_at(j->program, (ttc_value)v);
        if (ttc_op_arity(i->op) == 0) continue;
        if (!j->series[v]) {
            add_number(j, (ttc_value)v, i);
            continue;
        }
        ttc_text_format(j->text, "    double t%zu[JLT_JET_ORDER_MAX + 1];\n", v);
        if (i->op == TTC_OP_COSINE || i->op == TTC_OP_SINE)
            ttc_text_format(j->text, "    double u%zu[JLT_JET_ORDER_MAX + 1];\n", v);
    }
}

static bool find_series(jet *j)
{
    size_t n = ttc_program_size(j->program);
    j->series = calloc(n + 1, sizeof *j->series);
    if (j->series == NULL) return false;
    for (size_t v = 0; v < n; v++) {
        const ttc_instruction *i = ttc_program_at(j->program, (ttc_value)v);
        const ttc_value operands[] = { i->a, i->b, i->c };
        j->series[v] = i->op == TTC_OP_INPUT;
        for (unsigned k = 0; k < ttc_op_arity(i->op); k++) j->series[v] |= j->series[operands[k]];
    }
    return true;
}

void ttc_emit_jet(ttc_text *text, const ttc_kernels *kernels)
{
    const ttc_program *program = kernels->jet;
    size_t states = kernels->field->state_count, columns = ttc_program_output_count(program);
    jet j = { text, program, NULL };
    if (!find_series(&j)) {
        text->failed = true;
        return;
    }
    ttc_text_add(text, "static void jet(const double *restrict x, const double *restrict p, unsigned order,\n"
                       "                double *restrict coefficients)\n{\n");
    if (!ttc_emit_uses(program, TTC_OP_PARAMETER)) ttc_text_add(text, "    (void)p;\n");
    add_declarations(&j, states);
    for (size_t i = 0; i < states; i++) ttc_text_format(text, "    coefficients[%zu] = x%zu[0] = x[%zu];\n", i, i, i);
    for (size_t i = states; i < columns; i++) ttc_text_format(text, "    coefficients[%zu] = 0;\n", i);
    ttc_text_add(text, "    for (unsigned k = 0; k < order; k++) {\n");
    for (size_t v = 0; v < ttc_program_size(program); v++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)v);
        if (ttc_op_arity(i->op) > 0 && j.series[v]) add_recurrence(&j, (ttc_value)v, i);
    }
    ttc_text_format(text, "        double *restrict next = coefficients + (k + 1)*%zu;\n", columns);
    for (size_t i = 0; i < columns; i++) {
        ttc_text_format(text, i < states ? "        next[%zu] = x%zu[k + 1] = " : "        next[%zu] = ", i, i);
        add_coefficient(&j, ttc_program_output_at(program, i));
        ttc_text_add(text, "/(k + 1);\n");
    }
    ttc_text_add(text, "    }\n}\n");
    free(j.series);
}

void ttc_emit_jet_header(ttc_text *text)
{
    ttc_text_add(text,
                 "/** Coefficients of order k of products, quotients, roots, cosines and sines of power series whose operands are known to\n"
                 " *  order k, and whose result is known below k. Cost: k + 1 products. Written by ttc; do not edit. */\n"
                 "#ifndef JLT_JET_H\n"
                 "#define JLT_JET_H\n"
                 "\n"
                 "#include <math.h>\n"
                 "\n"
                 "static inline double jlt_jet_product(const double *a, const double *b, unsigned k)\n"
                 "{\n"
                 "    double sum = a[0] * b[k];\n"
                 "    for (unsigned j = 1; j <= k; j++) sum += a[j] * b[k - j];\n"
                 "    return sum;\n"
                 "}\n"
                 "\n"
                 "/* q = a/b; a is coefficient k of the numerator. */\n"
                 "static inline double jlt_jet_quotient(double a, const double *b, const double *q, unsigned k)\n"
                 "{\n"
                 "    for (unsigned j = 1; j <= k; j++) a -= b[j] * q[k - j];\n"
                 "    return a / b[0];\n"
                 "}\n"
                 "\n");
    ttc_text_add(text,
                 "/* r = sqrt(a); a is coefficient k of the radicand. */\n"
                 "static inline double jlt_jet_root(double a, const double *r, unsigned k)\n"
                 "{\n"
                 "    if (k == 0) return sqrt(a);\n"
                 "    for (unsigned j = 1; j < k; j++) a -= r[j] * r[k - j];\n"
                 "    return a / (2 * r[0]);\n"
                 "}\n"
                 "\n"
                 "/* sum over j of j a_j b_(k-j), over k */\n"
                 "static inline double jlt_jet_slope(const double *a, const double *b, unsigned k)\n"
                 "{\n"
                 "    double sum = 0;\n"
                 "    for (unsigned j = 1; j <= k; j++) sum += j * a[j] * b[k - j];\n"
                 "    return sum / k;\n"
                 "}\n"
                 "\n");
    ttc_text_add(text,
                 "/* c = cos(a), s = sin(a) go together: each call makes the partner's coefficient as well. */\n"
                 "static inline double jlt_jet_cosine(const double *a, double *c, double *s, unsigned k)\n"
                 "{\n"
                 "    s[k] = k == 0 ? sin(a[0]) : jlt_jet_slope(a, c, k);\n"
                 "    return k == 0 ? cos(a[0]) : -jlt_jet_slope(a, s, k);\n"
                 "}\n"
                 "\n"
                 "static inline double jlt_jet_sine(const double *a, double *s, double *c, unsigned k)\n"
                 "{\n"
                 "    c[k] = k == 0 ? cos(a[0]) : -jlt_jet_slope(a, s, k);\n"
                 "    return k == 0 ? sin(a[0]) : jlt_jet_slope(a, c, k);\n"
                 "}\n"
                 "\n"
                 "#endif\n");
}
