/* Copies programs: without unused values, in another order, or with other numbers of parameters. */
#include "optimize/program.h"

#include <stdlib.h>

static ttc_value rebuilt(ttc_program *out, const ttc_value *renamed, const ttc_instruction *i, const uint32_t *numbers)
{
    switch (i->op) {
    case TTC_OP_INPUT: return ttc_program_input(out, i->index);
    case TTC_OP_PARAMETER: return ttc_program_parameter(out, numbers != NULL ? numbers[i->index] : i->index);
    case TTC_OP_CONSTANT: return ttc_program_constant(out, i->constant);
    case TTC_OP_PI: return ttc_program_pi(out);
    default:
        return ttc_program_copy(out, i->op, renamed[i->a], ttc_op_arity(i->op) > 1 ? renamed[i->b] : TTC_NO_VALUE,
                                ttc_op_arity(i->op) > 2 ? renamed[i->c] : TTC_NO_VALUE);
    }
}

/* Copy the first `count` values in this order. order, numbers of parameters: NULL: their own. */
static ttc_program *copy(const ttc_program *program, const ttc_value *order, size_t count, const uint32_t *numbers)
{
    size_t n = ttc_program_size(program);
    ttc_program *out = ttc_program_create();
    ttc_value *renamed = calloc(n + 1, sizeof *renamed);
    bool ok = out != NULL && renamed != NULL;
    if (ok) ttc_program_keep_duplicates(out);
    for (size_t k = 0; ok && k < count; k++) {
        const ttc_value from = order != NULL ? order[k] : (ttc_value)k;
        renamed[from] = rebuilt(out, renamed, ttc_program_at(program, from), numbers);
        ok = renamed[from] != TTC_NO_VALUE;
        const char *label = ttc_program_label_of(program, from);
        if (ok && label != NULL) ttc_program_label(out, renamed[from], label);
    }
    for (size_t k = 0; ok && k < ttc_program_output_count(program); k++)
        ttc_program_output(out, renamed[ttc_program_output_at(program, k)]);
    free(renamed);
    if (ok && !ttc_program_failed(out)) return out;
    ttc_program_destroy(out);
    return NULL;
}

ttc_program *ttc_program_reorder(const ttc_program *program, const ttc_value *order, size_t count)
{
    return copy(program, order, count, NULL);
}

ttc_program *ttc_program_renumber(const ttc_program *program, const uint32_t *numbers)
{
    return copy(program, NULL, ttc_program_size(program), numbers);
}

/* Set reached[v] = 1 for the values that outputs need. */
static void mark(const ttc_program *program, unsigned char *reached)
{
    for (size_t k = 0; k < ttc_program_output_count(program); k++) reached[ttc_program_output_at(program, k)] = 1;
    for (size_t k = ttc_program_size(program); k-- > 0;) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        for (unsigned j = 0; reached[k] && j < ttc_op_arity(i->op); j++) reached[i->operands[j]] = 1;
    }
}

ttc_program *ttc_program_trim(const ttc_program *program)
{
    size_t n = ttc_program_size(program), count = 0;
    unsigned char *reached = calloc(n + 1, 1);
    ttc_value *order = calloc(n + 1, sizeof *order);
    ttc_program *out = NULL;
    if (reached != NULL && order != NULL) {
        mark(program, reached);
        for (size_t k = 0; k < n; k++)
            if (reached[k]) order[count++] = (ttc_value)k;
        out = ttc_program_reorder(program, order, count);
    }
    free(reached);
    free(order);
    return out;
}
