/* Writes ball-arithmetic kernels: the expressions as they stand, operation by operation in Arb. */
#include "emit/emit.h"

#include <stdlib.h>

static void add_operand(ttc_text *text, const ttc_program *program, ttc_value value)
{
    const ttc_instruction *i = ttc_program_at(program, value);
    if (i->op == TTC_OP_INPUT) ttc_text_format(text, "x + %u", i->index);
    else if (i->op == TTC_OP_PARAMETER) ttc_text_format(text, "params + %u", i->index);
    else ttc_text_format(text, "t + %u", value);
}

static void add_constant(ttc_text *text, ttc_value value, const fmpq_t constant)
{
    const fmpz *up = fmpq_numref(constant), *down = fmpq_denref(constant);
    if (fmpz_bits(up) < 31 && fmpz_is_one(down)) {
        ttc_text_format(text, "    arb_set_si(t + %u, %ld);\n", value, (long)fmpz_get_si(up));
        return;
    }
    char *digits = fmpq_get_str(NULL, 10, constant);
    ttc_text_format(text, "    jlt_ball_rational(t + %u, \"%s\", prec);\n", value, digits);
    flint_free(digits);
}

static void add_instruction(ttc_text *text, const ttc_program *program, ttc_value value)
{
    static const char *const names[] = { [TTC_OP_NEGATE] = "neg",    [TTC_OP_ADD] = "add",     [TTC_OP_SUBTRACT] = "sub",
                                         [TTC_OP_MULTIPLY] = "mul",  [TTC_OP_DIVIDE] = "div",  [TTC_OP_ROOT] = "sqrt",
                                         [TTC_OP_COSINE] = "cos",    [TTC_OP_SINE] = "sin",    [TTC_OP_EXP] = "exp",
                                         [TTC_OP_LOG] = "log" };
    const ttc_instruction *i = ttc_program_at(program, value);
    if (i->op == TTC_OP_INPUT || i->op == TTC_OP_PARAMETER) return;
    if (i->op == TTC_OP_CONSTANT) {
        add_constant(text, value, i->constant);
        return;
    }
    if (i->op == TTC_OP_PI) {
        ttc_text_format(text, "    arb_const_pi(t + %u, prec);\n", value);
        return;
    }
    ttc_text_format(text, "    arb_%s(t + %u", names[i->op], value);
    for (unsigned k = 0; k < ttc_op_arity(i->op); k++) {
        ttc_text_add(text, ", ");
        add_operand(text, program, i->operands[k]);
    }
    ttc_text_add(text, i->op == TTC_OP_NEGATE ? ");" : ", prec);");
    const char *label = ttc_program_label_of(program, value);
    if (label != NULL) ttc_text_format(text, " /* %s */", label);
    ttc_text_add(text, "\n");
}

static void add_function(ttc_text *text, const char *stem, const char *name, const ttc_program *program)
{
    const size_t n = ttc_program_size(program);
    const ttc_value zero = ttc_emit_zeros(program);
    ttc_text_format(text, "static void %s_%s(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)\n{\n", stem, name);
    ttc_text_format(text, "    arb_ptr t = _arb_vec_init(%zu);\n    (void)x;\n    (void)params;\n    (void)prec;\n", n);
    for (size_t k = 0; k < n; k++) add_instruction(text, program, (ttc_value)k);
    if (zero != TTC_NO_VALUE) ttc_text_format(text, "    _arb_vec_zero(out, %zu);\n", ttc_program_output_count(program));
    for (size_t k = 0; k < ttc_program_output_count(program); k++) {
        if (ttc_program_output_at(program, k) == zero) continue;
        ttc_text_format(text, "    arb_set(out + %zu, ", k);
        add_operand(text, program, ttc_program_output_at(program, k));
        ttc_text_add(text, ");\n");
    }
    ttc_text_format(text, "    _arb_vec_clear(t, %zu);\n}\n\n", n);
}

typedef struct {
    ttc_text *text, *entry;
    ttc_field *field;
    const char *stem;
} ball;

static bool add_expressions(ball *b, const char *name, const ttc_id *ids, size_t count)
{
    ttc_program *program = ttc_lower(b->field, ids, count, (ttc_lowering){ .share = true });
    if (program == NULL) return false;
    add_function(b->text, b->stem, name, program);
    ttc_program_destroy(program);
    return true;
}

static void add_names(ball *b, const uint32_t *claims, size_t count)
{
    ttc_text_format(b->text, "static const char *const %s_integral[] = {", b->stem);
    for (size_t i = 0; i < count; i++)
        ttc_text_format(b->text, "%s\"%s\"", i == 0 ? " " : ", ", b->field->model->claims[claims[i]].name);
    ttc_text_add(b->text, " };\n\n");
    ttc_text_format(b->entry, "    .integral_count = %zu,\n    .integral = %s_integral,\n", count, b->stem);
}

/* All integrals but those with `modulo`. Conditional ones hold where the caller's parameters satisfy their condition. */
static bool add_integrals(ball *b)
{
    const ttc_model *model = b->field->model;
    size_t n = b->field->state_count, count = 0;
    uint32_t *claims = calloc(model->claim_count + 1, sizeof *claims);
    ttc_id *values = calloc(model->claim_count + 1, sizeof *values);
    ttc_id *gradients = calloc(model->claim_count * n + 1, sizeof *gradients);
    bool ok = claims != NULL && values != NULL && gradients != NULL;
    for (uint32_t i = 0; ok && i < model->claim_count; i++) {
        bool is_level = b->field->elimination != NULL && b->field->elimination->integral == i;
        if (model->claims[i].kind != TTC_CLAIM_INTEGRAL || model->claims[i].modulo_count > 0 || is_level) continue;
        claims[count] = i;
        values[count] = ttc_field_specialise(b->field, model->claims[i].expression);
        for (size_t j = 0; ok && j < n; j++) {
            gradients[count * n + j] = ttc_field_partial(b->field, values[count], j);
            ok = gradients[count * n + j] != TTC_NONE;
        }
        count++;
    }
    if (ok && count > 0) {
        add_names(b, claims, count);
        ok = add_expressions(b, "integral_values", values, count)
             && add_expressions(b, "integral_gradients", gradients, count * n);
        ttc_text_format(b->entry, "    .integral_values = %s_integral_values,\n    .integral_gradients = %s_integral_gradients,\n",
                        b->stem, b->stem);
    }
    free(claims);
    free(values);
    free(gradients);
    return ok;
}

static bool add_field(ttc_text *text, ttc_kernels *k)
{
    static const ttc_kernel_kind kinds[] = { TTC_KERNEL_RHS, TTC_KERNEL_JACOBIAN, TTC_KERNEL_DIVERGENCE };
    ttc_text stem = { 0 }, entry = { 0 };
    ttc_emit_stem(&stem, k->field);
    ball b = { text, &entry, k->field, ttc_text_string(&stem) };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        add_function(text, b.stem, ttc_kernel_name(kinds[i]), k->kernels[kinds[i]].reference);
        ttc_text_format(&entry, "    .%s = %s_%s,\n", ttc_kernel_name(kinds[i]), b.stem, ttc_kernel_name(kinds[i]));
    }
    bool ok = add_integrals(&b);
    const ttc_field *field = k->field;
    ttc_text_format(text, "extern const jlt_ball_table jlt_balls_%s_%s;\nconst jlt_ball_table jlt_balls_%s_%s = {\n",
                    field->model->name, b.stem, field->model->name, b.stem);
    ttc_text_format(text, "    .model = \"%s\", .time = \"%s\", .elimination = \"%s\",\n", field->model->name,
                    field->time == NULL ? "" : field->time->name, field->elimination == NULL ? "" : field->elimination->name);
    ttc_text_format(text, "    .state_count = %zu, .param_count = %zu,\n%s};\n\n", field->state_count, field->param_count,
                    ttc_text_string(&entry));
    ok = ok && !stem.failed && !entry.failed;
    ttc_text_clear(&stem);
    ttc_text_clear(&entry);
    return ok;
}

bool ttc_emit_ball(ttc_text *text, const ttc_catalogue *catalogue)
{
    const ttc_model *model = catalogue->model;
    bool ok = true;
    ttc_text_add(text, "/* ");
    ttc_text_add_comment(text, model->title == NULL ? model->name : model->title);
    ttc_text_add(text, ": enclosures in ball arithmetic,\n * from the expressions as they stand, without the optimizer.\n *\n");
    ttc_text_format(text, " *  Table:      %s, SHA-256 %s\n", model->name, model->sha256);
    for (size_t i = 0; i < catalogue->count; i++) {
        if (catalogue->fields[i].kernels == NULL) continue;
        ttc_text_add(text, " *  Command:    ");
        ttc_emit_command(text, catalogue->fields[i].kernels);
        ttc_text_add(text, "\n");
        break;
    }
    ttc_text_add(text, " */\n");
    ttc_text_add(text, "#include \"kernel_ball.h\"\n\n");
    for (size_t i = 0; ok && i < catalogue->count; i++)
        if (catalogue->fields[i].kernels != NULL && catalogue->fields[i].variant == NULL)
            ok = add_field(text, catalogue->fields[i].kernels);
    return ok && !text->failed;
}
