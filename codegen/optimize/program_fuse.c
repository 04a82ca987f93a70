/* Fuses a product that is used once, by an addition or subtraction, with it; a reciprocal that is used once, by a product, becomes
 * a quotient. */
#include "optimize/workspace_lower.h"

#include <stdlib.h>

typedef struct {
    const ttc_program *program;
    ttc_program *out;
    uint32_t *uses;
    ttc_value *renamed;
} fusing;

/* The operand that is a reciprocal used by this product alone: x * (1/y) becomes x/y, which rounds once. */
static ttc_value lone_reciprocal(const fusing *f, const ttc_instruction *i)
{
    for (int k = 0; i->op == TTC_OP_MULTIPLY && k < 2; k++) {
        const ttc_instruction *operand = ttc_program_at(f->program, i->operands[k]);
        if (operand->op != TTC_OP_DIVIDE || f->uses[i->operands[k]] != 1) continue;
        const ttc_instruction *one = ttc_program_at(f->program, operand->a);
        if (one->op == TTC_OP_CONSTANT && fmpq_is_one(one->constant)) return i->operands[k];
    }
    return TTC_NO_VALUE;
}

static bool may_fuse(const fusing *f, ttc_value value)
{
    const ttc_instruction *i = ttc_program_at(f->program, value);
    return i->op == TTC_OP_MULTIPLY && f->uses[value] == 1 && ttc_program_label_of(f->program, value) == NULL
           && lone_reciprocal(f, i) == TTC_NO_VALUE;
}

/* Fuse an addition or subtraction with a product; of two, with the later one, which is ready last. */
static ttc_value fused(const fusing *f, const ttc_instruction *i)
{
    bool first = may_fuse(f, i->a), second = may_fuse(f, i->b);
    if (first && second) first = i->a > i->b;
    second = second && !first;
    const ttc_instruction *product = ttc_program_at(f->program, first ? i->a : i->b);
    ttc_value x = f->renamed[product->a], y = f->renamed[product->b], rest = f->renamed[first ? i->b : i->a];
    ttc_op op = i->op == TTC_OP_ADD ? TTC_OP_FMA : first ? TTC_OP_FMS : TTC_OP_FNMA;
    return ttc_program_copy(f->out, op, x, y, rest);
}

static ttc_value copied(const fusing *f, const ttc_instruction *i)
{
    unsigned arity = ttc_op_arity(i->op);
    if (i->op == TTC_OP_INPUT) return ttc_program_input(f->out, i->index);
    if (i->op == TTC_OP_PARAMETER) return ttc_program_parameter(f->out, i->index);
    if (i->op == TTC_OP_CONSTANT) return ttc_program_constant(f->out, i->constant);
    if (i->op == TTC_OP_PI) return ttc_program_pi(f->out);
    return ttc_program_copy(f->out, i->op, f->renamed[i->a], arity > 1 ? f->renamed[i->b] : TTC_NO_VALUE,
                            arity > 2 ? f->renamed[i->c] : TTC_NO_VALUE);
}

static ttc_value quotient(const fusing *f, const ttc_instruction *i, ttc_value reciprocal)
{
    ttc_value other = i->a == reciprocal ? i->b : i->a;
    return ttc_program_copy(f->out, TTC_OP_DIVIDE, f->renamed[other], f->renamed[ttc_program_at(f->program, reciprocal)->b],
                            TTC_NO_VALUE);
}

ttc_program *ttc_program_fuse(const ttc_program *program)
{
    size_t n = ttc_program_size(program);
    fusing f = { program, ttc_program_create(), calloc(n + 1, sizeof *f.uses), calloc(n + 1, sizeof *f.renamed) };
    ttc_program *trimmed = NULL;
    if (f.out == NULL || f.uses == NULL || f.renamed == NULL) goto done;
    ttc_program_count_uses(f.uses, program); /* outputs count twice: they are never fused */
    for (size_t k = 0; k < n; k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        bool is_sum = (i->op == TTC_OP_ADD || i->op == TTC_OP_SUBTRACT) && i->a != i->b;
        ttc_value reciprocal = lone_reciprocal(&f, i);
        if (reciprocal != TTC_NO_VALUE) f.renamed[k] = quotient(&f, i, reciprocal);
        else f.renamed[k] = is_sum && (may_fuse(&f, i->a) || may_fuse(&f, i->b)) ? fused(&f, i) : copied(&f, i);
        if (f.renamed[k] == TTC_NO_VALUE) goto done;
        if (ttc_program_label_of(program, (ttc_value)k) != NULL)
            ttc_program_label(f.out, f.renamed[k], ttc_program_label_of(program, (ttc_value)k));
    }
    for (size_t k = 0; k < ttc_program_output_count(program); k++)
        ttc_program_output(f.out, f.renamed[ttc_program_output_at(program, k)]);
    if (!ttc_program_failed(f.out)) trimmed = ttc_program_trim(f.out);
done:
    ttc_program_destroy(f.out);
    free(f.uses);
    free(f.renamed);
    return trimmed;
}
