/* Kernels on vectors of lanes: the same programs as the scalar ones, spelled for a vector type. */
#include "emit.h"

const char *const ttc_isa_names[TTC_ISA_COUNT] = { "baseline", "avx2", "avx512" };
const char *const ttc_isa_files[TTC_ISA_COUNT] = { "baseline.c", "avx2.c", "avx512.c" };

static const unsigned isa_lanes[TTC_ISA_COUNT] = { 2, 4, 8 };

static const ttc_dialect dialect = {
    .type = "jlt_lanes", .input = "x", .input_end = "", .broadcast = "jlt_lanes_of(", .broadcast_end = ")",
    .root = "jlt_lanes_root(", .cosine = "jlt_lanes_cosine(", .sine = "jlt_lanes_sine(",
    .output = "jlt_lanes_store(out + ", .output_middle = "*stride, ", .output_end = ")", .formulas = false,
};

static bool reads_input(const ttc_program *program, unsigned index)
{
    for (size_t k = 0; k < ttc_program_size(program); k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        if (i->op == TTC_OP_INPUT && i->index == index) return true;
    }
    return false;
}

static void add_kernel(ttc_text *text, const ttc_kernels *kernels, ttc_kernel_kind kind)
{
    const ttc_program *program = kernels->kernels[kind].optimized;
    const ttc_field *field = kernels->field;
    ttc_text_add(text, "\nstatic void ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "_%s(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)\n{\n",
                    ttc_kernel_name(kind));
    if (!ttc_emit_uses(program, TTC_OP_INPUT)) ttc_text_add(text, "    (void)x;\n");
    if (!ttc_emit_uses(program, TTC_OP_PARAMETER)) ttc_text_add(text, "    (void)p;\n");
    for (unsigned i = 0; i < field->state_count; i++)
        if (reads_input(program, i)) ttc_text_format(text, "    const jlt_lanes x%u = jlt_lanes_load(x + %u*stride);\n", i, i);
    ttc_emit_body(text, &dialect, program, field, &kernels->block, "p", 0);
    ttc_text_add(text, "}\n");
}

static void add_stage(ttc_text *text, const ttc_kernels *kernels)
{
    const ttc_program *program = kernels->kernels[TTC_KERNEL_RHS].optimized;
    const ttc_field *field = kernels->field;
    unsigned n = (unsigned)field->state_count;
    ttc_text_add(text, "\nstatic void ");
    ttc_emit_stem(text, field);
    ttc_text_add(text, "_stage(const double *restrict x, const double *const *restrict slope, const double *restrict weight,\n"
                       "    unsigned count, const double *restrict h, const double *restrict p, double *restrict z,\n"
                       "    double *restrict out)\n{\n"
                       "    enum { stride = JLT_LANES };\n"
                       "    const jlt_lanes step = jlt_lanes_load(h), first = jlt_lanes_of(weight[0]);\n");
    if (!ttc_emit_uses(program, TTC_OP_PARAMETER)) ttc_text_add(text, "    (void)p;\n");
    for (unsigned i = 0; i < n; i++)
        ttc_text_format(text, "    jlt_lanes x%u = first * jlt_lanes_load(slope[0] + %u*stride);\n", i, i);
    ttc_text_add(text, "    for (unsigned l = 1; l < count; l++) {\n        const jlt_lanes next = jlt_lanes_of(weight[l]);\n");
    for (unsigned i = 0; i < n; i++)
        ttc_text_format(text, "        x%u = jlt_lanes_fma(next, jlt_lanes_load(slope[l] + %u*stride), x%u);\n", i, i, i);
    ttc_text_add(text, "    }\n");
    for (unsigned i = 0; i < n; i++)
        ttc_text_format(text, "    x%u = jlt_lanes_fma(step, x%u, jlt_lanes_load(x + %u*stride));\n"
                              "    jlt_lanes_store(z + %u*stride, x%u);\n", i, i, i, i, i);
    ttc_emit_body(text, &dialect, program, field, &kernels->block, "p", 0);
    ttc_text_add(text, "}\n");
}

static void add_table(ttc_text *text, const ttc_kernels *kernels)
{
    const ttc_field *field = kernels->field;
    ttc_text name = { 0 }, stem = { 0 };
    ttc_emit_stem(&stem, field);
    ttc_text_format(&name, "JLT_BATCH_NAME(jlt_batch_%s_%s)", field->model->name, ttc_text_string(&stem));
    ttc_text_format(text, "\nextern const jlt_kernel_batch %s;\nconst jlt_kernel_batch %s = {\n"
                          "    .isa = JLT_BATCH_ISA,\n    .lanes = JLT_LANES,\n", ttc_text_string(&name), ttc_text_string(&name));
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++)
        if (kernels->kernels[kind].count > 0)
            ttc_text_format(text, "    .%s = %s_%s,\n", ttc_kernel_name((ttc_kernel_kind)kind), ttc_text_string(&stem),
                            ttc_kernel_name((ttc_kernel_kind)kind));
    ttc_text_format(text, "    .stage = %s_stage,\n};\n", ttc_text_string(&stem));
    text->failed |= name.failed || stem.failed;
    ttc_text_clear(&name);
    ttc_text_clear(&stem);
}

void ttc_emit_lanes(ttc_text *text, const ttc_kernels *kernels)
{
    ttc_text_format(text, "/* Kernels of %s, SHA-256 %s, on vectors of JLT_LANES lanes. Written by ttc %s; do not edit.\n"
                          " * The scalar file beside this one has the formulas. */\n",
                    kernels->field->model->name, kernels->field->model->sha256, JLT_VERSION);
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++)
        if (kernels->kernels[kind].count > 0) add_kernel(text, kernels, (ttc_kernel_kind)kind);
    add_stage(text, kernels);
    add_table(text, kernels);
}

void ttc_emit_batch(ttc_text *text, const ttc_plan *plan, unsigned isa)
{
    ttc_text_format(text, "/* Batched kernels of %s for %s. Written by ttc %s; do not edit. */\n", plan->model->name,
                    ttc_isa_names[isa], JLT_VERSION);
    ttc_text_format(text, "#define JLT_LANES %u\n#define JLT_BATCH_ISA \"%s\"\n#define JLT_BATCH_NAME(name) name##_%s\n\n",
                    isa_lanes[isa], ttc_isa_names[isa], ttc_isa_names[isa]);
    ttc_text_add(text, "#include \"kernel_abi.h\"\n#include \"lanes.h\"\n\n");
    for (size_t i = 0; i < plan->count; i++) {
        if (plan->fields[i].kernels == NULL) continue;
        ttc_text_add(text, "#include \"");
        ttc_emit_stem(text, plan->fields[i].kernels->field);
        ttc_text_add(text, "_lanes.inc\"\n");
    }
}
