/* Translation: every kernel program of a table computes what the table says, exactly; and a program with one operation
 * exchanged for another does not. Those of the shipped tables are proved where they are generated: unit.regenerated. */
#include "prove_text.h"

#include "readback/prove_kernels.h"

static ttc_model *read_table(const char *path)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_read(path, diagnostics);
    if (model == NULL) ttc_diagnostics_print(diagnostics, stderr);
    ttc_diagnostics_destroy(diagnostics);
    assert_non_null(model);
    return model;
}

static size_t check_table(const char *path)
{
    ttc_catalogue plan;
    ttc_proof_report report = { 0 };
    ttc_model *model = read_table(path);
    if (model->lift.file != NULL) { /* coordinates of a section, which have no field */
        ttc_model_destroy(model);
        return 0;
    }
    assert_true(ttc_catalogue_create(&plan, model, TTC_ALL_FIELDS, TTC_EFFORT_QUICK));
    assert_true(ttc_prove_kernels(&plan, &report));
    for (size_t i = 0; i < report.proof_count; i++) {
        if (report.proofs[i].status != TTC_PROVED)
            print_error("%s: %s: %s\n", path, report.proofs[i].name, report.proofs[i].remainder);
        free(report.proofs[i].name);
        free(report.proofs[i].remainder);
    }
    size_t count = report.proof_count;
    print_message("%s: %zu kernels proved\n", model->name, report.proved);
    assert_int_equal(report.proved, count);
    free(report.proofs);
    ttc_catalogue_clear(&plan);
    ttc_model_destroy(model);
    return count;
}

static void kernels_of_unseen_tables_compute_what_the_table_says(void **state)
{
    (void)state;
    assert_true(check_tables(JLT_SOURCE_DIR "/tests/proof/models", check_table) > 20);
}

static ttc_op exchanged(ttc_op op)
{
    switch (op) {
    case TTC_OP_ADD: return TTC_OP_SUBTRACT;
    case TTC_OP_SUBTRACT: return TTC_OP_ADD;
    case TTC_OP_MULTIPLY: return TTC_OP_DIVIDE;
    case TTC_OP_DIVIDE: return TTC_OP_MULTIPLY;
    case TTC_OP_FMA: return TTC_OP_FNMA;
    case TTC_OP_FMS: return TTC_OP_FMA;
    case TTC_OP_FNMA: return TTC_OP_FMS;
    default: return op;
    }
}

/* The program with the operation of one value exchanged; NULL when that value is no such operation. */
static ttc_program *altered(const ttc_program *program, ttc_value target)
{
    if (exchanged(ttc_program_at(program, target)->op) == ttc_program_at(program, target)->op) return NULL;
    ttc_program *made = ttc_program_create();
    ttc_program_keep_duplicates(made);
    ttc_value *image = calloc(ttc_program_size(program), sizeof *image);
    assert_non_null(image);
    for (ttc_value i = 0; i < ttc_program_size(program); i++) {
        const ttc_instruction *instruction = ttc_program_at(program, i);
        unsigned arity = ttc_op_arity(instruction->op);
        ttc_op op = i == target ? exchanged(instruction->op) : instruction->op;
        if (op == TTC_OP_INPUT) image[i] = ttc_program_input(made, instruction->index);
        else if (op == TTC_OP_PARAMETER) image[i] = ttc_program_parameter(made, instruction->index);
        else if (op == TTC_OP_CONSTANT) image[i] = ttc_program_constant(made, instruction->constant);
        else
            image[i] = ttc_program_copy(made, op, image[instruction->a], arity > 1 ? image[instruction->b] : TTC_NO_VALUE,
                                        arity > 2 ? image[instruction->c] : TTC_NO_VALUE);
    }
    for (size_t i = 0; i < ttc_program_output_count(program); i++)
        ttc_program_output(made, image[ttc_program_output_at(program, i)]);
    assert_false(ttc_program_failed(made));
    free(image);
    return made;
}

/* Whether some kernel of this plan is not proved. */
static bool is_refuted(const ttc_catalogue *plan)
{
    ttc_proof_report report = { 0 };
    assert_true(ttc_prove_kernels(plan, &report));
    for (size_t i = 0; i < report.proof_count; i++) {
        free(report.proofs[i].name);
        free(report.proofs[i].remainder);
    }
    free(report.proofs);
    return report.proved < report.proof_count;
}

/* Exchanges every stride-th operation of a program of the plan in turn, and holds that it is noticed. Returns their number. */
static size_t exchange_all(ttc_program **place, const ttc_catalogue *plan, const char *what, ttc_value stride)
{
    ttc_program *original = *place;
    size_t count = 0;
    for (ttc_value i = 0; i < ttc_program_size(original); i++) {
        ttc_program *wrong = i % stride == 0 ? altered(original, i) : NULL;
        if (wrong == NULL) continue;
        *place = wrong;
        const bool refuted = is_refuted(plan);
        *place = original;
        ttc_program_destroy(wrong);
        if (!refuted) print_error("%s: operation %u exchanged: not noticed\n", what, (unsigned)i);
        assert_true(refuted);
        count++;
    }
    return count;
}

/* What runs, what it is compared with in balls, and the Taylor recurrences. */
static void a_kernel_with_one_operation_exchanged_is_refuted(void **state)
{
    (void)state;
    static const ttc_kernel_kind kinds[] = { TTC_KERNEL_RHS, TTC_KERNEL_DIVERGENCE, TTC_KERNEL_INTEGRAL_GRADIENTS };
    ttc_catalogue plan;
    size_t optimized = 0, reference = 0;
    ttc_model *model = read_table(JLT_SOURCE_DIR "/codegen/models/spherical_top.tt");
    assert_true(ttc_catalogue_create(&plan, model, TTC_ALL_FIELDS, TTC_EFFORT_FULL));
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        /* The general field with this kernel, and those that it is compared with. */
        ttc_kernels few = *plan.fields[0].kernels;
        for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++)
            if (kind != TTC_KERNEL_RHS && kind != TTC_KERNEL_INTEGRAL_VALUES && kind != (int)kinds[k]) few.kernels[kind].count = 0;
        ttc_catalogue_entry field = { .kernels = &few };
        ttc_catalogue general = { .model = model, .fields = &field, .count = 1 };
        const char *name = ttc_kernel_name(kinds[k]);
        assert_false(is_refuted(&general));
        optimized += exchange_all(&few.kernels[kinds[k]].optimized, &general, name, 1);
        reference += exchange_all(&few.kernels[kinds[k]].reference, &general, name, 4);
        if (kinds[k] == TTC_KERNEL_RHS) assert_true(exchange_all(&few.jet, &general, "jet", 3) > 5);
    }
    print_message("%zu optimized and %zu reference programs refuted\n", optimized, reference);
    assert_true(optimized > 60 && reference > 20);
    ttc_catalogue_clear(&plan);
    ttc_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kernels_of_unseen_tables_compute_what_the_table_says),
        cmocka_unit_test(a_kernel_with_one_operation_exchanged_is_refuted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
