/* Writes Taylor coefficients of the solution, order by order: each operation of the field's program becomes the recurrence of its
 * series (R. E. Moore, Interval Analysis, 1966; A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., 2008, ch. 13). What
 * depends on parameters alone is a number. Coefficients and numbers are doubles, or vectors of lanes. */
#include "emit/emit.h"

#include <stdlib.h>

typedef struct {
    ttc_text *text;
    const ttc_program *program;
    bool lanes;   /* coefficients and numbers are vectors */
    bool *series; /* by value: depends on states */
} jet;

static void add_name(jet *j, ttc_value value)
{
    const ttc_instruction *i = ttc_program_at(j->program, value);
    if (i->op == TTC_OP_INPUT) ttc_text_format(j->text, "x%u", i->index);
    else if (i->op == TTC_OP_PARAMETER) ttc_text_format(j->text, j->lanes ? "jlt_lanes_load(p + %u*JLT_LANES)" : "p[%u]", i->index);
    else if (i->op == TTC_OP_CONSTANT) ttc_emit_constant(j->text, i->constant);
    else if (i->op == TTC_OP_PI) ttc_text_add(j->text, TTC_PI_DOUBLE);
    else ttc_text_format(j->text, "t%u", value);
}

/* A value's name; on lanes, a constant as a vector. */
static void add_as_number(jet *j, ttc_value value)
{
    const ttc_op op = ttc_program_at(j->program, value)->op;
    const bool is_constant = j->lanes && (op == TTC_OP_CONSTANT || op == TTC_OP_PI);

    ttc_text_add(j->text, is_constant ? "jlt_lanes_of(" : "");
    add_name(j, value);
    ttc_text_add(j->text, is_constant ? ")" : "");
}

/* A number as coefficient k of a series: only that of order 0 is not zero. */
static void open_number(jet *j)
{
    ttc_text_add(j->text, "(k == 0 ? ");
}

static void close_number(jet *j)
{
    ttc_text_add(j->text, j->lanes ? " : jlt_lanes_of(0))" : " : 0)");
}

/* Append coefficient k of an operand. */
static void add_coefficient(jet *j, ttc_value value)
{
    if (j->series[value]) {
        add_name(j, value);
        ttc_text_add(j->text, "[k]");
    } else {
        open_number(j);
        add_as_number(j, value);
        close_number(j);
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
    const bool number = !j->series[a] && !j->series[b];
    if (number) open_number(j);
    add_as_number(j, a);
    ttc_text_add(j->text, j->series[a] ? "[k]*" : "*");
    add_as_number(j, b);
    if (j->series[b]) ttc_text_add(j->text, "[k]");
    if (number) close_number(j);
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
    case TTC_OP_ADD: add_sum(j, i->a, "+", i->b); break;
    case TTC_OP_SUBTRACT: add_sum(j, i->a, "-", i->b); break;
    case TTC_OP_MULTIPLY: add_product(j, i->a, i->b); break;
    case TTC_OP_DIVIDE: add_quotient(j, value, i); break;
    case TTC_OP_FMA:
    case TTC_OP_FMS:
        add_product(j, i->a, i->b);
        ttc_text_add(j->text, i->op == TTC_OP_FMA ? " + " : " - ");
        add_coefficient(j, i->c);
        break;
    case TTC_OP_FNMA:
        add_coefficient(j, i->c);
        ttc_text_add(j->text, " - ");
        add_product(j, i->a, i->b);
        break;
    case TTC_OP_ROOT:
        ttc_text_add(j->text, "jlt_jet_root(");
        add_coefficient(j, i->a);
        ttc_text_format(j->text, ", t%u, k)", value);
        break;
    case TTC_OP_EXP:
        ttc_text_add(j->text, "jlt_jet_exp(");
        add_name(j, i->a);
        ttc_text_format(j->text, ", t%u, k)", value);
        break;
    case TTC_OP_LOG:
        ttc_text_add(j->text, "jlt_jet_log(");
        add_name(j, i->a);
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

static void add_number_product(jet *j, const ttc_instruction *i)
{
    add_as_number(j, i->a);
    ttc_text_add(j->text, "*");
    add_as_number(j, i->b);
}

/* How an operation on one number is spelled. */
static const char *number_function(const jet *j, ttc_op op)
{
    static const char *const on_lanes[] = { [TTC_OP_ROOT] = "jlt_lanes_root",
                                            [TTC_OP_COSINE] = "jlt_lanes_cosine_each",
                                            [TTC_OP_SINE] = "jlt_lanes_sine_each",
                                            [TTC_OP_EXP] = "jlt_lanes_exp_each",
                                            [TTC_OP_LOG] = "jlt_lanes_log_each" };

    if (op == TTC_OP_NEGATE) return "-";
    return j->lanes ? on_lanes[op] : ttc_emit_function_name(op);
}

/* A number: a value that depends on parameters alone. */
static void add_number(jet *j, ttc_value value, const ttc_instruction *i)
{
    static const char *const signs[] = {
        [TTC_OP_ADD] = " + ", [TTC_OP_SUBTRACT] = " - ", [TTC_OP_MULTIPLY] = "*", [TTC_OP_DIVIDE] = "/",
        [TTC_OP_FMA] = " + ", [TTC_OP_FMS] = " - ",      [TTC_OP_FNMA] = " - ",
    };
    ttc_text_format(j->text, "    const %s t%u = ", j->lanes ? "jlt_lanes" : "double", value);
    switch (i->op) {
    case TTC_OP_NEGATE:
    case TTC_OP_ROOT:
    case TTC_OP_COSINE:
    case TTC_OP_SINE:
    case TTC_OP_EXP:
    case TTC_OP_LOG:
        ttc_text_format(j->text, "%s(", number_function(j, i->op));
        add_as_number(j, i->a);
        ttc_text_add(j->text, ")");
        break;
    case TTC_OP_FNMA:
        add_as_number(j, i->c);
        ttc_text_add(j->text, " - ");
        add_number_product(j, i);
        break;
    case TTC_OP_FMA:
    case TTC_OP_FMS:
        add_number_product(j, i);
        ttc_text_add(j->text, signs[i->op]);
        add_as_number(j, i->c);
        break;
    default:
        add_as_number(j, i->a);
        ttc_text_add(j->text, signs[i->op]);
        add_as_number(j, i->b);
        break;
    }
    ttc_text_add(j->text, ";\n");
}

static void add_declarations(jet *j, size_t states)
{
    const char *type = j->lanes ? "jlt_lanes" : "double";
    for (size_t i = 0; i < states; i++) ttc_text_format(j->text, "    %s x%zu[JLT_JET_ORDER_MAX + 1];\n", type, i);
    for (size_t v = 0; v < ttc_program_size(j->program); v++) {
        const ttc_instruction *i = ttc_program_at(j->program, (ttc_value)v);
        if (ttc_op_arity(i->op) == 0) continue;
        if (!j->series[v]) {
            add_number(j, (ttc_value)v, i);
            continue;
        }
        ttc_text_format(j->text, "    %s t%zu[JLT_JET_ORDER_MAX + 1];\n", type, v);
        if (i->op == TTC_OP_COSINE || i->op == TTC_OP_SINE)
            ttc_text_format(j->text, "    %s u%zu[JLT_JET_ORDER_MAX + 1];\n", type, v);
    }
}

static bool find_series(jet *j)
{
    size_t n = ttc_program_size(j->program);
    j->series = calloc(n + 1, sizeof *j->series);
    if (j->series == NULL) return false;
    for (size_t v = 0; v < n; v++) {
        const ttc_instruction *i = ttc_program_at(j->program, (ttc_value)v);
        j->series[v] = i->op == TTC_OP_INPUT;
        for (unsigned k = 0; k < ttc_op_arity(i->op); k++) j->series[v] |= j->series[i->operands[k]];
    }
    return true;
}

/* The coefficients of order 0, and the loop over higher orders. */
static void add_orders(jet *j, size_t states, size_t columns)
{
    const char *stride = j->lanes ? "*stride" : "";
    for (size_t i = 0; i < states; i++) {
        if (j->lanes) ttc_text_format(j->text, "    x%zu[0] = jlt_lanes_load(x + %zu*stride);\n"
                                               "    jlt_lanes_store(coefficients + %zu*stride, x%zu[0]);\n", i, i, i, i);
        else ttc_text_format(j->text, "    coefficients[%zu] = x%zu[0] = x[%zu];\n", i, i, i);
    }
    for (size_t i = states; i < columns; i++)
        ttc_text_format(j->text, j->lanes ? "    jlt_lanes_store(coefficients + %zu*stride, jlt_lanes_of(0));\n"
                                          : "    coefficients[%zu] = 0;\n", i);
    ttc_text_add(j->text, "    for (unsigned k = 0; k < order; k++) {\n");
    for (size_t v = 0; v < ttc_program_size(j->program); v++) {
        const ttc_instruction *i = ttc_program_at(j->program, (ttc_value)v);
        if (ttc_op_arity(i->op) > 0 && j->series[v]) add_recurrence(j, (ttc_value)v, i);
    }
    ttc_text_format(j->text, "        double *restrict next = coefficients + (k + 1)*%zu%s;\n", columns, stride);
    for (size_t i = 0; i < columns; i++) {
        if (j->lanes) ttc_text_format(j->text, "        jlt_lanes_store(next + %zu*stride, ", i);
        else ttc_text_format(j->text, "        next[%zu] = ", i);
        if (i < states) ttc_text_format(j->text, "x%zu[k + 1] = ", i);
        add_coefficient(j, ttc_program_output_at(j->program, i));
        ttc_text_add(j->text, j->lanes ? "/(double)(k + 1));\n" : "/(k + 1);\n");
    }
    ttc_text_add(j->text, "    }\n}\n");
}

static void add_jet(ttc_text *text, const ttc_kernels *kernels, bool lanes)
{
    const ttc_program *program = kernels->jet;
    const size_t states = kernels->field->state_count;
    jet j = { .text = text, .program = program, .lanes = lanes };
    if (!find_series(&j)) {
        text->failed = true;
        return;
    }
    if (lanes) {
        ttc_text_add(text, "\nstatic void ");
        ttc_emit_stem(text, kernels->field);
        ttc_text_add(text, "_jet(const double *restrict x, const double *restrict p, unsigned order,\n"
                           "    double *restrict coefficients, size_t stride)\n{\n");
    } else {
        ttc_text_add(text, "static void jet(const double *restrict x, const double *restrict p, unsigned order,\n"
                           "                double *restrict coefficients)\n{\n");
    }
    if (!ttc_emit_uses(program, TTC_OP_PARAMETER)) ttc_text_add(text, "    (void)p;\n");
    add_declarations(&j, states);
    add_orders(&j, states, ttc_program_output_count(program));
    free(j.series);
}

void ttc_emit_jet(ttc_text *text, const ttc_kernels *kernels)
{
    add_jet(text, kernels, false);
}

void ttc_emit_jet_lanes(ttc_text *text, const ttc_kernels *kernels)
{
    add_jet(text, kernels, true);
}
