/* Names for readers where terms of a kernel's sums may nearly cancel: by labels, outputs, or formulas. */
#include "emit/emit.h"

#include "optimize/program_cancel.h"

#include <stdlib.h>
#include <string.h>

enum { FORMULA_LIMIT = 72 };

typedef struct {
    ttc_text *text;
    const ttc_kernels *kernels;
    ttc_kernel_kind kind;
    const ttc_program *program;
    ttc_loss *losses;      /* by value */
    ttc_value *users;      /* by value: the last value that uses it */
    uint32_t *use_counts;  /* by value; an output counts as two uses */
    size_t found;
} survey;

static bool is_sum(ttc_op op)
{
    return op == TTC_OP_ADD || op == TTC_OP_SUBTRACT || op == TTC_OP_FMA || op == TTC_OP_FMS || op == TTC_OP_FNMA;
}

/* Whether `user` adds the value to something. */
static bool is_term_of(const survey *s, ttc_value value, ttc_value user)
{
    const ttc_instruction *i = ttc_program_at(s->program, user);
    if (!is_sum(i->op)) return false;
    if (ttc_op_arity(i->op) == 2) return i->a == value || i->b == value;
    return i->c == value && i->a != value && i->b != value;
}

/* The last addition of the sum that an addition belongs to. */
static ttc_value whole_of(const survey *s, ttc_value value)
{
    while (s->use_counts[value] == 1 && s->users[value] != TTC_NO_VALUE && ttc_program_label_of(s->program, value) == NULL
           && is_term_of(s, value, s->users[value]))
        value = s->users[value];
    return value;
}

static const char *state_name(const survey *s, size_t position)
{
    const ttc_field *field = s->kernels->field;
    return field->symbols[field->states[position]].name;
}

/* Append the name of the kernel's output `index`. */
static void add_output_name(survey *s, size_t index)
{
    const ttc_field *field = s->kernels->field;
    const ttc_model *model = field->model;
    size_t n = field->state_count, offset = s->kind == TTC_KERNEL_RHS_JACOBIAN ? n : 0;
    const char *time = field->time == NULL ? "t" : "tau";
    switch (s->kind) {
    case TTC_KERNEL_RHS:
    case TTC_KERNEL_JACOBIAN:
    case TTC_KERNEL_RHS_JACOBIAN:
        if (s->kind == TTC_KERNEL_RHS || index < offset)
            ttc_text_format(s->text, "d(%s)/d%s", state_name(s, index), time);
        else
            ttc_text_format(s->text, "d(d(%s)/d%s)/d(%s)", state_name(s, (index - offset) / n), time,
                            state_name(s, (index - offset) % n));
        break;
    case TTC_KERNEL_INTEGRAL_VALUES: ttc_text_add(s->text, model->claims[s->kernels->integrals[index]].name); break;
    case TTC_KERNEL_INTEGRAL_GRADIENTS:
        ttc_text_format(s->text, "d(%s)/d(%s)", model->claims[s->kernels->integrals[index / n]].name, state_name(s, index % n));
        break;
    case TTC_KERNEL_MEASURE_VALUES: ttc_text_add(s->text, model->claims[s->kernels->measures[index]].name); break;
    case TTC_KERNEL_MEASURE_DIVERGENCES:
        ttc_text_format(s->text, "div(%s f)", model->claims[s->kernels->measures[index]].name);
        break;
    case TTC_KERNEL_TIME_FACTOR: ttc_text_add(s->text, "dt/dtau"); break;
    case TTC_KERNEL_ELIMINATED: ttc_text_add(s->text, model->symbols[field->elimination->state].name); break;
    case TTC_KERNEL_OBSERVE_VALUES: ttc_text_add(s->text, model->symbols[model->observed[index]].name); break;
    case TTC_KERNEL_VALID_VALUES: ttc_text_add(s->text, model->validities[index].name); break;
    case TTC_KERNEL_DOMAIN_VALUES: ttc_text_add(s->text, s->kernels->watched[index].name); break;
    case TTC_KERNEL_DOMAIN_GRADIENTS:
        ttc_text_format(s->text, "d(%s)/d(%s)", s->kernels->watched[index / n].name, state_name(s, index % n));
        break;
    default: ttc_text_add(s->text, "the divergence"); break;
    }
}

static void add_formula(const survey *s, ttc_text *out, ttc_value value, bool is_whole, bool bracket);

static void add_operation(const survey *s, ttc_text *out, const ttc_instruction *i)
{
    static const char *const signs[] = { [TTC_OP_ADD] = " + ",      [TTC_OP_SUBTRACT] = " - ", [TTC_OP_MULTIPLY] = "*",
                                         [TTC_OP_DIVIDE] = "/",     [TTC_OP_FMA] = " + ",      [TTC_OP_FMS] = " - ",
                                         [TTC_OP_FNMA] = " - ",     [TTC_OP_ROOT] = "sqrt(",   [TTC_OP_COSINE] = "cos(",
                                         [TTC_OP_SINE] = "sin(",    [TTC_OP_EXP] = "exp(",     [TTC_OP_LOG] = "log(",
                                         [TTC_OP_NEGATE] = "-" };
    bool is_factor = i->op == TTC_OP_MULTIPLY || i->op == TTC_OP_DIVIDE;
    if (i->op == TTC_OP_PI) {
        ttc_text_add(out, "pi");
        return;
    }
    if (i->op == TTC_OP_NEGATE || i->op >= TTC_OP_ROOT) {
        ttc_text_add(out, signs[i->op]);
        add_formula(s, out, i->a, false, i->op == TTC_OP_NEGATE);
        if (i->op >= TTC_OP_ROOT) ttc_text_add(out, ")");
        return;
    }
    if (ttc_op_arity(i->op) == 2) {
        add_formula(s, out, i->a, false, is_factor);
        ttc_text_add(out, signs[i->op]);
        add_formula(s, out, i->b, false, is_factor || i->op == TTC_OP_SUBTRACT);
        return;
    }
    if (i->op == TTC_OP_FNMA) {
        add_formula(s, out, i->c, false, false);
        ttc_text_add(out, " - ");
    }
    add_formula(s, out, i->a, false, true);
    ttc_text_add(out, "*");
    add_formula(s, out, i->b, false, true);
    if (i->op == TTC_OP_FNMA) return;
    ttc_text_add(out, signs[i->op]);
    add_formula(s, out, i->c, false, i->op == TTC_OP_FMS);
}

/* Append the formula of a value. Labelled operands stand by their labels; so does the value itself unless is_whole. A formula
 * beyond the limit is not used, and so not finished. */
static void add_formula(const survey *s, ttc_text *out, ttc_value value, bool is_whole, bool bracket)
{
    const ttc_field *field = s->kernels->field;
    const ttc_instruction *i = ttc_program_at(s->program, value);
    const char *label = ttc_program_label_of(s->program, value);
    bool is_prepared = i->op == TTC_OP_PARAMETER;
    if (out->length > FORMULA_LIMIT) return;
    if (label != NULL && !is_whole) {
        ttc_text_add(out, label);
    } else if (i->op == TTC_OP_INPUT) {
        ttc_text_add(out, state_name(s, i->index));
    } else if (is_prepared || i->op == TTC_OP_CONSTANT) {
        ttc_id id = is_prepared ? ttc_prepared_at(&s->kernels->prepared, i->index) : ttc_number(field->graph, i->constant);
        bool is_atom = ttc_kind_of(field->graph, id) == TTC_SYMBOL;
        if (bracket && !is_atom) ttc_text_add(out, "(");
        ttc_emit_formula(out, field->graph, id, ttc_emit_symbol_name, (void *)(uintptr_t)field);
        if (bracket && !is_atom) ttc_text_add(out, ")");
    } else {
        bool needs = bracket && (is_sum(i->op) || i->op == TTC_OP_DIVIDE || i->op == TTC_OP_NEGATE);
        if (needs) ttc_text_add(out, "(");
        add_operation(s, out, i);
        if (needs) ttc_text_add(out, ")");
    }
}

/* The names of the outputs that depend on the value or, if `alone`, are equal to it. */
static void add_outputs_of(survey *s, ttc_value value, bool alone)
{
    size_t n = ttc_program_size(s->program), named = 0;
    unsigned char *needs = calloc(n + 1, 1);
    s->text->failed |= needs == NULL;
    if (needs == NULL) return;
    needs[value] = 1;
    for (size_t v = (size_t)value + 1; v < n && !alone; v++) {
        const ttc_instruction *i = ttc_program_at(s->program, (ttc_value)v);
        for (unsigned k = 0; k < ttc_op_arity(i->op); k++) needs[v] |= needs[i->operands[k]];
    }
    for (size_t k = 0; k < ttc_program_output_count(s->program); k++) {
        if (!needs[ttc_program_output_at(s->program, k)]) continue;
        if (named++ > 0) ttc_text_add(s->text, alone ? ", " : " and of ");
        add_output_name(s, k);
    }
    free(needs);
}

static bool is_output(const survey *s, ttc_value value)
{
    for (size_t k = 0; k < ttc_program_output_count(s->program); k++)
        if (ttc_program_output_at(s->program, k) == value) return true;
    return false;
}

static void name_place(survey *s, ttc_value value)
{
    const char *label = ttc_program_label_of(s->program, value);
    ttc_text formula = { 0 };
    ttc_text_add(s->text, s->found++ == 0 ? "digits are lost where terms nearly cancel in " : ", ");
    if (is_output(s, value)) {
        add_outputs_of(s, value, true);
        return;
    }
    add_formula(s, &formula, value, true, false);
    bool is_short = formula.length > 0 && formula.length <= FORMULA_LIMIT;
    if (label != NULL) ttc_text_format(s->text, is_short ? "%s = " : "%s", label);
    if (is_short) {
        ttc_text_add(s->text, ttc_text_string(&formula));
    } else if (label == NULL) {
        ttc_text_add(s->text, "a part of ");
        add_outputs_of(s, value, false);
    }
    s->text->failed |= formula.failed;
    ttc_text_clear(&formula);
}

static void list_users(survey *s)
{
    for (size_t v = 0; v < ttc_program_size(s->program); v++) {
        const ttc_instruction *i = ttc_program_at(s->program, (ttc_value)v);
        for (unsigned k = 0; k < ttc_op_arity(i->op); k++) s->users[i->operands[k]] = (ttc_value)v;
    }
    ttc_program_count_uses(s->use_counts, s->program);
}

/* Name sums that may cancel, each once, and prepared values with such sums. */
static void name_sums(survey *s)
{
    size_t n = ttc_program_size(s->program);
    for (size_t v = 0; v < n; v++) /* a whole sum takes the losses of its parts */
        if (s->losses[v] == TTC_CANCELS) s->losses[whole_of(s, (ttc_value)v)] = TTC_CANCELS;
    for (size_t v = 0; v < n; v++) {
        const ttc_instruction *i = ttc_program_at(s->program, (ttc_value)v);
        if (s->losses[v] == TTC_CANCELS && whole_of(s, (ttc_value)v) == v) name_place(s, (ttc_value)v);
        if (i->op == TTC_OP_PARAMETER
            && ttc_expression_cancels(s->kernels->field, ttc_prepared_at(&s->kernels->prepared, i->index)))
            name_place(s, (ttc_value)v);
    }
}

static void begin_function(survey *s)
{
    if (s->found++ > 0) ttc_text_add(s->text, ", ");
    else ttc_text_add(s->text, s->text->length > 0 ? TTC_LOSS_SEPARATOR "takes " : "takes ");
}

static void name_function(survey *s, ttc_value value)
{
    const char *label = ttc_program_label_of(s->program, value);
    ttc_text formula = { 0 };
    add_operation(s, &formula, ttc_program_at(s->program, value));
    begin_function(s);
    ttc_text_add(s->text, formula.length <= FORMULA_LIMIT || label == NULL ? ttc_text_string(&formula) : label);
    s->text->failed |= formula.failed;
    ttc_text_clear(&formula);
}

/* Name functions of rounded arguments in an expression of parameters, definitions included, each once. seen: by id. */
static void name_functions_of(survey *s, ttc_id id, bool *seen)
{
    ttc_field *field = s->kernels->field;
    if (seen[id]) return;
    seen[id] = true;
    if (ttc_kind_of(field->graph, id) == TTC_SYMBOL) {
        const ttc_field_symbol *symbol = field->symbols + ttc_symbol_of(field->graph, id);
        if (symbol->role >= TTC_ROLE_COSINE && ttc_expression_is_rounded(field, symbol->definition)) {
            begin_function(s);
            ttc_emit_formula(s->text, field->graph, id, ttc_emit_symbol_name, field);
        }
        if (symbol->role >= TTC_ROLE_UNIT) name_functions_of(s, symbol->definition, seen);
    }
    for (size_t i = 0; i < ttc_part_count(field->graph, id); i++) name_functions_of(s, ttc_part_at(field->graph, id, i).id, seen);
}

/* Name functions of rounded arguments, also in prepared values. */
static void name_arguments(survey *s)
{
    bool *seen = calloc(ttc_graph_size(s->kernels->field->graph) + 1, sizeof *seen);
    s->found = 0;
    s->text->failed |= seen == NULL;
    for (size_t v = 0; seen != NULL && v < ttc_program_size(s->program); v++) {
        const ttc_instruction *i = ttc_program_at(s->program, (ttc_value)v);
        if (s->losses[v] == TTC_ROUNDED_ARGUMENT) name_function(s, (ttc_value)v);
        if (i->op == TTC_OP_PARAMETER) name_functions_of(s, ttc_prepared_at(&s->kernels->prepared, i->index), seen);
    }
    if (s->found > 0)
        ttc_text_add(s->text, " of a rounded argument: digits are lost near its zeros, or where an exponent is large");
    free(seen);
}

void ttc_emit_cancellations(ttc_text *text, const ttc_kernels *kernels, ttc_kernel_kind kind)
{
    const ttc_program *program = kernels->kernels[kind].optimized;
    size_t n = ttc_program_size(program) + 1;
    ttc_text found = { 0 };
    survey s = { &found, kernels, kind, program, calloc(n, sizeof(ttc_loss)), malloc(n * sizeof(ttc_value)),
                 calloc(n, sizeof(uint32_t)), 0 };
    bool ok = s.losses != NULL && s.users != NULL && s.use_counts != NULL
              && ttc_program_losses(s.losses, program, kernels->field, &kernels->prepared);
    for (size_t v = 0; ok && v < n; v++) s.users[v] = TTC_NO_VALUE;
    if (ok) {
        list_users(&s);
        name_sums(&s);
        name_arguments(&s);
        if (text->length > 0 && found.length > 0) ttc_text_add(text, TTC_LOSS_SEPARATOR);
        ttc_text_add(text, ttc_text_string(&found));
    }
    text->failed |= !ok || found.failed;
    ttc_text_clear(&found);
    free(s.losses);
    free(s.users);
    free(s.use_counts);
}
