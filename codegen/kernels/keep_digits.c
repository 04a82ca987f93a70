/* Makes a second program for each kernel whose sums can be written without cancellation, and keeps it if it is better. Comes after
 * all other passes: a kernel with nothing to gain is as it would be without this one. */
#include "kernels/kernels.h"

#include "optimize/optimize.h"
#include "optimize/program_cancel.h"
#include "optimize/workspace.h"

#include <stdlib.h>

/* Faults of a program: outputs that depend on a cancellation, and flops. */
typedef struct {
    unsigned outputs, flops;
} fault;

static bool judge(fault *f, const ttc_kernels *k, const ttc_program *program)
{
    size_t n = ttc_program_size(program);
    ttc_loss *losses = calloc(n + 1, sizeof *losses);
    unsigned char *is_reached = calloc(n + 1, 1);
    bool ok = losses != NULL && is_reached != NULL && ttc_program_losses(losses, program, k->field, &k->prepared);
    *f = (fault){ .flops = ttc_count_flops(ttc_program_count(program)) };
    for (size_t v = 0; ok && v < n; v++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)v);
        is_reached[v] = losses[v] == TTC_CANCELS;
        for (unsigned j = 0; j < ttc_op_arity(i->op); j++) is_reached[v] |= is_reached[i->operands[j]];
    }
    for (size_t j = 0; ok && j < ttc_program_output_count(program); j++)
        f->outputs += is_reached[ttc_program_output_at(program, j)];
    free(losses);
    free(is_reached);
    return ok;
}

/* Whether a is as good as b. A program that loses no digits may cost more operations than one that does; one that still loses some
 * may not. */
static bool is_better(const fault *a, const fault *b)
{
    return a->outputs <= b->outputs && (a->flops <= b->flops || (a->outputs == 0 && b->outputs > 0));
}

/* Whether some sum can be written without cancellation. */
static bool has_other_forms(ttc_field *field, const ttc_id *outputs, size_t count)
{
    size_t before = field->form_count;
    ttc_workspace *workspace = outputs == NULL ? NULL : ttc_workspace_create(field, outputs, count);
    ttc_workspace_destroy(workspace);
    return field->form_count > before;
}

/* Make *program without cancellation, if that is better. Returns false when memory is out. */
static bool replace(ttc_kernels *k, ttc_program **program, const ttc_id *outputs, const ttc_id *gathered, size_t count,
                    ttc_purpose purpose, ttc_effort effort, bool *changed)
{
    fault old, new;
    bool is_other = has_other_forms(k->field, outputs, count) || has_other_forms(k->field, gathered, count);
    if (!is_other) return true;
    ttc_program *other = ttc_optimize(k->field, outputs, gathered, count, purpose, effort, &k->prepared);
    *changed = true; /* ttc_optimize added prepared values, even if its program is not kept */
    bool ok = other != NULL && judge(&old, k, *program) && judge(&new, k, other);
    if (!ok || !is_better(&new, &old)) {
        ttc_program_destroy(other);
        return ok;
    }
    ttc_program_destroy(*program);
    *program = other;
    return true;
}

static bool replace_all(ttc_kernels *k, ttc_effort effort, bool *changed)
{
    bool ok = true;
    for (int kind = 0; ok && kind < TTC_KERNEL_KINDS; kind++) {
        ttc_kernel *kernel = k->kernels + kind;
        /* The divergence of an invariant density is zero and has no digits to keep. */
        if (kernel->count == 0 || kind == TTC_KERNEL_MEASURE_DIVERGENCES) continue;
        ok = replace(k, &kernel->optimized, kernel->outputs, kernel->gathered, kernel->count,
                     ttc_kernel_purpose(k, (ttc_kernel_kind)kind), effort, changed);
    }
    ttc_id *outputs = ok ? ttc_kernels_jet_outputs(k) : NULL;
    size_t count = k->field->state_count + (k->field->time != NULL);
    ok = outputs != NULL && replace(k, &k->jet, outputs, NULL, count, TTC_FOR_JETS, effort, changed);
    free(outputs);
    return ok;
}

/* Rewrite *program to read prepared values from `to`, to which those that it needs are added. */
static bool move_to_prepared(ttc_program **program, const ttc_prepared *from, ttc_prepared *to)
{
    size_t size = ttc_prepared_size(from);
    uint32_t *numbers = calloc(size + 1, sizeof *numbers);
    if (numbers == NULL) return false;
    for (ttc_value v = 0; v < ttc_program_size(*program); v++) {
        const ttc_instruction *i = ttc_program_at(*program, v);
        if (i->op == TTC_OP_PARAMETER) numbers[i->index] = ttc_prepared_index(to, ttc_prepared_at(from, i->index));
    }
    ttc_program *moved = to->failed ? NULL : ttc_program_renumber(*program, numbers);
    free(numbers);
    if (moved == NULL) return false;
    ttc_program_destroy(*program);
    *program = moved;
    return true;
}

static bool clear_up_prepared(ttc_kernels *k)
{
    ttc_prepared prepared = { .field = k->field };
    bool ok = true;
    for (int kind = 0; ok && kind < TTC_KERNEL_KINDS; kind++)
        if (k->kernels[kind].count > 0) ok = move_to_prepared(&k->kernels[kind].optimized, &k->prepared, &prepared);
    ok = ok && move_to_prepared(&k->jet, &k->prepared, &prepared);
    ttc_prepared_clear(&k->prepared);
    k->prepared = prepared;
    if (!ok) return false;
    ttc_program_destroy(k->prepare);
    k->prepare = ttc_lower(k->field, k->prepared.entries, k->prepared.count, (ttc_lowering){ .share = true });
    return k->prepare != NULL;
}

bool ttc_kernels_keep_digits(ttc_kernels *kernels, ttc_effort effort)
{
    bool changed = false;
    kernels->field->keeps_digits = true;
    return replace_all(kernels, effort, &changed) && (!changed || clear_up_prepared(kernels));
}
