/* Writes a program as C statements, with the formula that each temporary stands for. */
#include "emit/emit.h"

#include "optimize/lower.h"

#include <stdlib.h>
#include <string.h>

/* How tightly a formula binds, loosest first. */
typedef enum { BINDS_SUM, BINDS_PRODUCT, BINDS_ATOM } binding;

enum { FORMULA_LIMIT = 60 }; /* longer operands appear in formulas by the name of their temporary */

const ttc_dialect ttc_dialect_scalar = {
    .type = "double", .input = "x[", .input_end = "]",
    .parameter = "", .parameter_middle = "[", .parameter_end = "]", .broadcast = "", .broadcast_end = "",
    .root = "sqrt(", .cosine = "cos(", .sine = "sin(", .exp = "exp(", .log = "log(",
    .output = "out[", .output_middle = "] = ", .output_end = "", .formulas = true,
};

typedef struct {
    ttc_text *text;
    const ttc_dialect *dialect;
    const ttc_program *program;
    const ttc_field *field;
    const ttc_prepared *prepared;
    const char *parameters;
    size_t *numbers;    /* by value: number of its temporary */
    ttc_text *formulas; /* by value */
    binding *bindings;
    size_t *first_output, *next_output; /* by value and by output: 1 + the next output of the value */
} body;

static void add_operand(body *b, ttc_value value)
{
    const ttc_instruction *i = ttc_program_at(b->program, value);
    const char *open = b->dialect->broadcast, *close = b->dialect->broadcast_end;
    if (i->op == TTC_OP_INPUT) {
        ttc_text_format(b->text, "%s%u%s", b->dialect->input, i->index, b->dialect->input_end);
    } else if (i->op == TTC_OP_PARAMETER) {
        ttc_text_format(b->text, "%s%s%s%u%s", b->dialect->parameter, b->parameters, b->dialect->parameter_middle, i->index,
                        b->dialect->parameter_end);
    } else if (i->op == TTC_OP_CONSTANT) {
        ttc_text_add(b->text, open);
        ttc_emit_constant(b->text, i->constant);
        ttc_text_add(b->text, close);
    } else if (i->op == TTC_OP_PI) {
        ttc_text_format(b->text, "%s%s%s", open, TTC_PI_DOUBLE, close);
    } else {
        ttc_text_format(b->text, "t%zu", b->numbers[value]);
    }
}

static void add_operation(body *b, const ttc_instruction *i)
{
    const char *const functions[][4] = {
        [TTC_OP_ROOT] = { b->dialect->root, ")", "", "" },
        [TTC_OP_COSINE] = { b->dialect->cosine, ")", "", "" },
        [TTC_OP_SINE] = { b->dialect->sine, ")", "", "" },
        [TTC_OP_EXP] = { b->dialect->exp, ")", "", "" },
        [TTC_OP_LOG] = { b->dialect->log, ")", "", "" },
    };
    static const char *const shapes[][4] = {
        [TTC_OP_NEGATE] = { "-", "", "", "" },
        [TTC_OP_ADD] = { "", " + ", "", "" },
        [TTC_OP_SUBTRACT] = { "", " - ", "", "" },
        [TTC_OP_MULTIPLY] = { "", "*", "", "" },
        [TTC_OP_DIVIDE] = { "", "/", "", "" },
        [TTC_OP_FMA] = { "JLT_FMA(", ", ", ", ", ")" },
        [TTC_OP_FMS] = { "JLT_FMS(", ", ", ", ", ")" },
        [TTC_OP_FNMA] = { "JLT_FNMA(", ", ", ", ", ")" },
    };
    const char *const *shape = i->op >= TTC_OP_ROOT ? functions[i->op] : shapes[i->op];
    unsigned arity = ttc_op_arity(i->op);
    for (unsigned k = 0; k < arity; k++) {
        ttc_text_add(b->text, shape[k]);
        add_operand(b, i->operands[k]);
    }
    ttc_text_add(b->text, shape[arity]);
}

/* An operand's formula, in brackets if it binds more loosely than needed. */
static void add_formula(body *b, ttc_text *formula, ttc_value value, binding needed)
{
    const char *label = ttc_program_label_of(b->program, value);
    if (label != NULL) {
        bool bracket = needed == BINDS_ATOM && strpbrk(label, "*/") != NULL;
        ttc_text_format(formula, bracket ? "(%s)" : "%s", label);
    } else if (b->formulas[value].length > FORMULA_LIMIT) {
        ttc_text_format(formula, "t%zu", b->numbers[value]);
    } else {
        bool bracket = b->bindings[value] < needed;
        if (bracket) ttc_text_add(formula, "(");
        ttc_text_add(formula, ttc_text_string(b->formulas + value));
        if (bracket) ttc_text_add(formula, ")");
    }
}

static binding leaf_formula(body *b, ttc_text *formula, const ttc_instruction *i)
{
    if (i->op == TTC_OP_INPUT) {
        ttc_text_add(formula, b->field->symbols[b->field->states[i->index]].name);
        return BINDS_ATOM;
    }
    if (i->op == TTC_OP_PI) {
        ttc_text_add(formula, "pi");
        return BINDS_ATOM;
    }
    if (i->op == TTC_OP_CONSTANT) {
        char *digits = fmpq_get_str(NULL, 10, i->constant);
        ttc_text_add(formula, digits);
        flint_free(digits);
        return fmpq_sgn(i->constant) < 0 ? BINDS_SUM : fmpz_is_one(fmpq_denref(i->constant)) ? BINDS_ATOM : BINDS_PRODUCT;
    }
    if (b->prepared == NULL || i->index < b->field->param_count) {
        ttc_text_add(formula, b->field->symbols[b->field->params[i->index]].name);
        return BINDS_ATOM;
    }
    ttc_id id = ttc_prepared_at(b->prepared, i->index);
    ttc_emit_formula(formula, b->field->graph, id, ttc_emit_symbol_name, (void *)(uintptr_t)b->field);
    ttc_kind kind = ttc_kind_of(b->field->graph, id);
    bool negative = kind == TTC_PRODUCT && fmpq_sgn(ttc_coefficient(b->field->graph, id)) < 0;
    return kind == TTC_SUM || negative ? BINDS_SUM : kind == TTC_SYMBOL ? BINDS_ATOM : BINDS_PRODUCT;
}

static binding operation_formula(body *b, ttc_text *formula, const ttc_instruction *i)
{
    switch (i->op) {
    case TTC_OP_NEGATE:
        ttc_text_add(formula, "-");
        add_formula(b, formula, i->a, BINDS_PRODUCT);
        return BINDS_SUM;
    case TTC_OP_ADD:
    case TTC_OP_SUBTRACT:
        add_formula(b, formula, i->a, BINDS_SUM);
        ttc_text_add(formula, i->op == TTC_OP_ADD ? " + " : " - ");
        add_formula(b, formula, i->b, i->op == TTC_OP_ADD ? BINDS_SUM : BINDS_PRODUCT);
        return BINDS_SUM;
    case TTC_OP_MULTIPLY:
    case TTC_OP_DIVIDE:
        add_formula(b, formula, i->a, BINDS_PRODUCT);
        ttc_text_add(formula, i->op == TTC_OP_MULTIPLY ? "*" : "/");
        add_formula(b, formula, i->b, i->op == TTC_OP_MULTIPLY ? BINDS_PRODUCT : BINDS_ATOM);
        return BINDS_PRODUCT;
    case TTC_OP_FMA:
    case TTC_OP_FMS:
        add_formula(b, formula, i->a, BINDS_PRODUCT);
        ttc_text_add(formula, "*");
        add_formula(b, formula, i->b, BINDS_PRODUCT);
        ttc_text_add(formula, i->op == TTC_OP_FMA ? " + " : " - ");
        add_formula(b, formula, i->c, i->op == TTC_OP_FMA ? BINDS_SUM : BINDS_PRODUCT);
        return BINDS_SUM;
    case TTC_OP_FNMA:
        add_formula(b, formula, i->c, BINDS_SUM);
        ttc_text_add(formula, " - ");
        add_formula(b, formula, i->a, BINDS_PRODUCT);
        ttc_text_add(formula, "*");
        add_formula(b, formula, i->b, BINDS_PRODUCT);
        return BINDS_SUM;
    default:
        ttc_text_add(formula, ttc_emit_function_name(i->op));
        ttc_text_add(formula, "(");
        add_formula(b, formula, i->a, BINDS_SUM);
        ttc_text_add(formula, ")");
        return BINDS_ATOM;
    }
}

static void add_statement(body *b, ttc_value value, size_t *count)
{
    const ttc_instruction *i = ttc_program_at(b->program, value);
    const char *label = ttc_program_label_of(b->program, value);
    ttc_text *formula = b->formulas + value;
    if (ttc_op_arity(i->op) == 0) {
        b->bindings[value] = leaf_formula(b, formula, i);
        return;
    }
    b->bindings[value] = operation_formula(b, formula, i);
    b->numbers[value] = (*count)++;
    ttc_text_format(b->text, "    const %s t%zu = ", b->dialect->type, b->numbers[value]);
    add_operation(b, i);
    if (!b->dialect->formulas) {
        ttc_text_add(b->text, ";\n");
        return;
    }
    ttc_text_add(b->text, "; /* ");
    if (label != NULL) {
        ttc_text_add_comment(b->text, label);
        ttc_text_add(b->text, " = ");
    }
    ttc_text_add_comment(b->text, ttc_text_string(formula));
    ttc_text_add(b->text, " */\n");
}

/* An output is stored at once, so that its temporary need not be kept. */
static void add_outputs(body *b, ttc_value value, size_t offset)
{
    for (size_t k = b->first_output[value]; k != 0; k = b->next_output[k - 1]) {
        ttc_text_format(b->text, "    %s%zu%s", b->dialect->output, offset + k - 1, b->dialect->output_middle);
        add_operand(b, value);
        ttc_text_format(b->text, "%s;\n", b->dialect->output_end);
    }
}

ttc_value ttc_emit_zeros(const ttc_program *program)
{
    enum { MANY = 64 };
    for (size_t v = 0; v < ttc_program_size(program); v++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)v);
        size_t count = 0;
        if (i->op != TTC_OP_CONSTANT || !fmpq_is_zero(i->constant)) continue;
        for (size_t k = 0; k < ttc_program_output_count(program); k++) count += ttc_program_output_at(program, k) == v;
        if (count > MANY) return (ttc_value)v;
    }
    return TTC_NO_VALUE;
}

static void add_zeros(body *b, ttc_value zero, size_t offset, size_t outputs)
{
    ttc_text_format(b->text, "    for (size_t i = %zu; i < %zu; i++) %si%s", offset, offset + outputs, b->dialect->output,
                    b->dialect->output_middle);
    add_operand(b, zero);
    ttc_text_format(b->text, "%s;\n", b->dialect->output_end);
}

void ttc_emit_body(ttc_text *text, const ttc_dialect *dialect, const ttc_program *program, const ttc_field *field,
                   const ttc_prepared *prepared, const char *parameters, size_t offset)
{
    const ttc_value zero = ttc_emit_zeros(program);
    size_t n = ttc_program_size(program), count = 0, outputs = ttc_program_output_count(program);
    body b = {
        .text = text, .dialect = dialect, .program = program, .field = field, .prepared = prepared, .parameters = parameters
    };
    b.numbers = calloc(n + 1, sizeof *b.numbers);
    b.formulas = calloc(n + 1, sizeof *b.formulas);
    b.bindings = calloc(n + 1, sizeof *b.bindings);
    b.first_output = calloc(n + 1, sizeof *b.first_output);
    b.next_output = calloc(outputs + 1, sizeof *b.next_output);
    if (b.numbers == NULL || b.formulas == NULL || b.bindings == NULL || b.first_output == NULL || b.next_output == NULL) {
        text->failed = true;
        goto done;
    }
    if (zero != TTC_NO_VALUE) add_zeros(&b, zero, offset, outputs);
    for (size_t k = outputs; k-- > 0;) {
        if (ttc_program_output_at(program, k) == zero) continue;
        b.next_output[k] = b.first_output[ttc_program_output_at(program, k)];
        b.first_output[ttc_program_output_at(program, k)] = k + 1;
    }
    for (size_t k = 0; k < n; k++) {
        add_statement(&b, (ttc_value)k, &count);
        add_outputs(&b, (ttc_value)k, offset);
    }
done:
    for (size_t k = 0; b.formulas != NULL && k < n; k++) {
        text->failed |= b.formulas[k].failed;
        ttc_text_clear(b.formulas + k);
    }
    free(b.numbers);
    free(b.formulas);
    free(b.bindings);
    free(b.first_output);
    free(b.next_output);
}

const char *ttc_emit_function_name(ttc_op op)
{
    switch (op) {
    case TTC_OP_ROOT: return "sqrt";
    case TTC_OP_COSINE: return "cos";
    case TTC_OP_SINE: return "sin";
    case TTC_OP_EXP: return "exp";
    case TTC_OP_LOG: return "log";
    default: return "";
    }
}

bool ttc_emit_uses(const ttc_program *program, ttc_op op)
{
    for (size_t k = 0; k < ttc_program_size(program); k++)
        if (ttc_program_at(program, (ttc_value)k)->op == op) return true;
    return false;
}

void ttc_emit_function(ttc_text *text, const char *name, const ttc_program *program, const ttc_field *field,
                       const ttc_prepared *prepared)
{
    const char *parameters = prepared == NULL ? "params" : "p";
    ttc_text_format(text, "static void %s(const double *restrict x, const double *restrict %s, double *restrict out)\n{\n",
                    name, parameters);
    if (!ttc_emit_uses(program, TTC_OP_INPUT)) ttc_text_add(text, "    (void)x;\n");
    if (!ttc_emit_uses(program, TTC_OP_PARAMETER)) ttc_text_format(text, "    (void)%s;\n", parameters);
    if (ttc_program_output_count(program) == 0) ttc_text_add(text, "    (void)out;\n");
    ttc_emit_body(text, &ttc_dialect_scalar, program, field, prepared, parameters, 0);
    ttc_text_add(text, "}\n");
}

bool ttc_emit_outputs(ttc_text *text, const char *name, ttc_field *field, const ttc_id *ids, size_t count)
{
    ttc_program *program = ttc_lower(field, ids, count, (ttc_lowering){ .share = true, .factor_roots = true });
    if (program != NULL) {
        ttc_emit_function(text, name, program, field, NULL);
        ttc_text_add(text, "\n");
    }
    ttc_program_destroy(program);
    return program != NULL;
}

bool ttc_emit_numbered(ttc_text *text, const char *what, size_t number, const char *name, ttc_field *field, const ttc_id *ids,
                       size_t count)
{
    ttc_text function = { 0 };
    ttc_text_format(&function, "%s%zu_%s", what, number, name);
    const bool ok = !function.failed && ttc_emit_outputs(text, ttc_text_string(&function), field, ids, count);
    ttc_text_clear(&function);
    return ok;
}
