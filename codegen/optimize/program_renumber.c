/* Rewrites a program for another layout of its prepared values. */
#include "optimize/program.h"

#include <stdlib.h>

ttc_program *ttc_program_renumber(const ttc_program *program, const uint32_t *numbers)
{
    size_t n = ttc_program_size(program);
    ttc_program *out = ttc_program_create();
    ttc_value *renamed = calloc(n + 1, sizeof *renamed);
    bool ok = out != NULL && renamed != NULL;
    if (ok) ttc_program_keep_duplicates(out);
    for (size_t k = 0; ok && k < n; k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        unsigned arity = ttc_op_arity(i->op);
        if (i->op == TTC_OP_INPUT) renamed[k] = ttc_program_input(out, i->index);
        else if (i->op == TTC_OP_PARAMETER) renamed[k] = ttc_program_parameter(out, numbers[i->index]);
        else if (i->op == TTC_OP_CONSTANT) renamed[k] = ttc_program_constant(out, i->constant);
        else if (i->op == TTC_OP_PI) renamed[k] = ttc_program_pi(out);
        else renamed[k] = ttc_program_copy(out, i->op, renamed[i->a], arity > 1 ? renamed[i->b] : TTC_NO_VALUE,
                                           arity > 2 ? renamed[i->c] : TTC_NO_VALUE);
        ok = renamed[k] != TTC_NO_VALUE;
        const char *label = ttc_program_label_of(program, (ttc_value)k);
        if (ok && label != NULL) ttc_program_label(out, renamed[k], label);
    }
    for (size_t k = 0; ok && k < ttc_program_output_count(program); k++)
        ttc_program_output(out, renamed[ttc_program_output_at(program, k)]);
    free(renamed);
    if (ok && !ttc_program_failed(out)) return out;
    ttc_program_destroy(out);
    return NULL;
}
