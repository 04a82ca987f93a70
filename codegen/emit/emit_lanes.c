/* Writes kernels on vectors of lanes: the programs of the scalar ones, spelled for a vector type. */
#include "emit/emit.h"

const char *const ttc_isa_names[TTC_ISA_COUNT] = { "baseline", "avx2", "avx512" };
const char *const ttc_isa_files[TTC_ISA_COUNT] = { "baseline.c", "avx2.c", "avx512.c" };

static const unsigned isa_lanes[TTC_ISA_COUNT] = { 2, 4, 8 };

static const ttc_dialect dialect = {
    .type = "jlt_lanes", .input = "x", .input_end = "",
    .parameter = "jlt_lanes_load(", .parameter_middle = " + ", .parameter_end = "*JLT_LANES)",
    .broadcast = "jlt_lanes_of(", .broadcast_end = ")",
    .root = "jlt_lanes_root(", .cosine = "jlt_lanes_cosine(", .sine = "jlt_lanes_sine(",
    .exp = "jlt_lanes_exp(", .log = "jlt_lanes_log(",
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

/* STEM_NAME, an inline kernel with its states in registers. */
static void add_inline(ttc_text *text, const ttc_kernels *kernels, ttc_kernel_kind kind, const char *name)
{
    const ttc_program *program = kernels->kernels[kind].optimized;
    const ttc_field *field = kernels->field;
    ttc_text_add(text, "\nstatic inline __attribute__((always_inline)) void ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "_%s(", name);
    for (size_t i = 0; i < field->state_count; i++) ttc_text_format(text, "jlt_lanes x%zu, ", i);
    ttc_text_add(text, "const double *restrict p, double *restrict out, size_t stride)\n{\n");
    for (unsigned i = 0; i < field->state_count; i++)
        if (!reads_input(program, i)) ttc_text_format(text, "    (void)x%u;\n", i);
    if (!ttc_emit_uses(program, TTC_OP_PARAMETER)) ttc_text_add(text, "    (void)p;\n");
    ttc_emit_body(text, &dialect, program, field, &kernels->prepared, "p", 0);
    ttc_text_add(text, "}\n");
}

/* Two underscores, also below: with one, the jacobian of 'c_rhs' would be the rhs_jacobian of 'c'. */
static void add_kernel(ttc_text *text, const ttc_kernels *kernels, ttc_kernel_kind kind)
{
    const ttc_program *program = kernels->kernels[kind].optimized;
    const ttc_field *field = kernels->field;
    ttc_text_add(text, "\nstatic void ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "__%s(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)\n{\n",
                    ttc_kernel_name(kind));
    if (!ttc_emit_uses(program, TTC_OP_INPUT)) ttc_text_add(text, "    (void)x;\n");
    if (!ttc_emit_uses(program, TTC_OP_PARAMETER)) ttc_text_add(text, "    (void)p;\n");
    for (unsigned i = 0; i < field->state_count; i++)
        if (reads_input(program, i)) ttc_text_format(text, "    const jlt_lanes x%u = jlt_lanes_load(x + %u*stride);\n", i, i);
    ttc_emit_body(text, &dialect, program, field, &kernels->prepared, "p", 0);
    ttc_text_add(text, "}\n");
}

/* The kernel `name`, which loads the states for the inline kernel `inlined`. */
static void add_loading(ttc_text *text, const ttc_field *field, const char *name, const char *inlined)
{
    ttc_text_add(text, "\nstatic void ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "__%s(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)\n{\n    ",
                    name);
    ttc_emit_stem(text, field);
    ttc_text_format(text, "_%s(", inlined);
    for (size_t i = 0; i < field->state_count; i++) ttc_text_format(text, "jlt_lanes_load(x + %zu*stride), ", i);
    ttc_text_add(text, "p, out, stride);\n}\n");
}

/* Up to so many states, the accumulators of two vectors, a weight and a slope fit in the 16 registers of the narrower sets. */
enum { SIDE_BY_SIDE_MAX = 7 };

/* A vector of each row: `at`, a C expression, is its offset, and its accumulators are LETTER0, LETTER1, ... */
typedef struct {
    char letter;
    const char *at;
} side;

static void add_first_slope(ttc_text *text, size_t n, const side *s)
{
    for (size_t i = 0; i < n; i++)
        ttc_text_format(text, "        jlt_lanes %c%zu = first * jlt_lanes_load(slope + %zu*row + %s);\n", s->letter, i, i, s->at);
}

static void add_next_slope(ttc_text *text, size_t n, const side *s)
{
    for (size_t i = 0; i < n; i++)
        ttc_text_format(text, "            %c%zu = jlt_lanes_fma(next, jlt_lanes_load(slope + %zu*row + %s), %c%zu);\n", s->letter,
                        i, i, s->at, s->letter, i);
}

static void add_arguments(ttc_text *text, const ttc_field *field, const char *name, char letter)
{
    ttc_text_add(text, "        ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "_%s(", name);
    for (size_t i = 0; i < field->state_count; i++) ttc_text_format(text, "%c%zu, ", letter, i);
}

/* Slopes at x + h * sum. columns: the states, and one more for the clock, if carried, whose slope is dt/dtau. Each vector has
 * prepared values of its own, one vector's after the other's. */
static void add_slope_of_sum(ttc_text *text, const ttc_kernels *kernels, size_t columns, const side *s)
{
    const ttc_field *field = kernels->field;
    const size_t n = field->state_count, prepared = ttc_prepared_size(&kernels->prepared);
    ttc_text_format(text, "        const jlt_lanes %ch = jlt_lanes_load(h + %s);\n", s->letter, s->at);
    for (size_t i = 0; i < n; i++)
        ttc_text_format(text, "        %c%zu = jlt_lanes_fma(%ch, %c%zu, jlt_lanes_load(x + %zu*row + %s));\n", s->letter, i,
                        s->letter, s->letter, i, i, s->at);
    add_arguments(text, field, "field", s->letter);
    ttc_text_format(text, "own + %zu*%s, k + %zu*i*row + %s, row);\n", prepared, s->at, columns, s->at);
    if (columns > n && field->time != NULL) {
        add_arguments(text, field, "clock", s->letter);
        ttc_text_format(text, "own + %zu*%s, k + (%zu*i + %zu)*row + %s, row);\n", prepared, s->at, columns, n, s->at);
    } else if (columns > n) {
        ttc_text_format(text, "        jlt_lanes_store(k + (%zu*i + %zu)*row + %s, jlt_lanes_of(1));\n", columns, n, s->at);
    }
    ttc_text_add(text, "        if (i == count) {\n");
    for (size_t i = 0; i < n; i++)
        ttc_text_format(text, "            jlt_lanes_store(z + %zu*row + %s, %c%zu);\n", i, s->at, s->letter, i);
    ttc_text_add(text, "        }\n");
}

/* The loop over stages, for vectors whose sums are computed side by side. */
static void add_stage_loop(ttc_text *text, const ttc_kernels *kernels, size_t columns, const side *sides, size_t count)
{
    const size_t n = kernels->field->state_count;
    ttc_text_format(text, "    for (unsigned i = 1; i <= count; i++) {\n"
                          "        const jlt_stage_sum *sum = sums + i - 1;\n"
                          "        const double *restrict own = jlt_lanes_fresh(p);\n"
                          "        const double *slope = k + %zu*sum->slope[0]*row;\n"
                          "        const jlt_lanes first = jlt_lanes_of(sum->weight[0]);\n", columns);
    for (size_t s = 0; s < count; s++) add_first_slope(text, n, sides + s);
    ttc_text_format(text, "        for (unsigned l = 1; l < sum->count; l++) {\n"
                          "            const jlt_lanes next = jlt_lanes_of(sum->weight[l]);\n"
                          "            slope = k + %zu*sum->slope[l]*row;\n", columns);
    for (size_t s = 0; s < count; s++) add_next_slope(text, n, sides + s);
    ttc_text_add(text, "        }\n");
    for (size_t s = 0; s < count; s++) add_slope_of_sum(text, kernels, columns, sides + s);
    ttc_text_add(text, "    }\n");
}

/* The clock at the end, which only the last stage needs. */
static void add_clock_end(ttc_text *text, size_t n)
{
    ttc_text_format(text, "    for (unsigned at = 0; at < row; at += JLT_LANES) {\n"
                          "        const jlt_stage_sum *sum = sums + count - 1;\n"
                          "        jlt_lanes t = jlt_lanes_of(0);\n"
                          "        for (unsigned l = 0; l < sum->count; l++)\n"
                          "            t = jlt_lanes_fma(jlt_lanes_of(sum->weight[l]), "
                          "jlt_lanes_load(k + (%zu*sum->slope[l] + %zu)*row + at), t);\n"
                          "        t = jlt_lanes_fma(jlt_lanes_load(h + at), t, jlt_lanes_load(x + %zu*row + at));\n"
                          "        jlt_lanes_store(z + %zu*row + at, t);\n    }\n", n + 1, n, n, n);
}

static void add_stages(ttc_text *text, const ttc_kernels *kernels, bool clock)
{
    static const side together[] = { { 'a', "0" }, { 'b', "JLT_LANES" } }, single[] = { { 'a', "at" } };
    const ttc_field *field = kernels->field;
    const size_t columns = field->state_count + clock;
    ttc_text_add(text, "\nstatic void ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "_stages%s(const double *restrict x, double *restrict k, const jlt_stage_sum *restrict sums,\n"
                          "    unsigned count, const double *restrict h, const double *restrict p, double *restrict z)\n{\n"
                          "    enum { row = JLT_BATCH_VECTORS*JLT_LANES };\n", clock ? "_clock" : "");
    if (field->state_count <= SIDE_BY_SIDE_MAX) {
        add_stage_loop(text, kernels, columns, together, 2);
    } else {
        ttc_text_add(text, "    for (unsigned at = 0; at < row; at += JLT_LANES)\n");
        add_stage_loop(text, kernels, columns, single, 1);
    }
    if (clock) add_clock_end(text, field->state_count);
    ttc_text_add(text, "}\n");
}

static void add_table(ttc_text *text, const ttc_kernels *kernels)
{
    const ttc_field *field = kernels->field;
    ttc_text name = { 0 }, stem = { 0 };
    ttc_emit_stem(&stem, field);
    ttc_text_format(&name, "JLT_BATCH_NAME(jlt_batch_%s_%s)", field->model->name, ttc_text_string(&stem));
    ttc_text_format(text, "\nextern const jlt_kernel_batch %s;\nconst jlt_kernel_batch %s = {\n"
                          "    .isa = JLT_BATCH_ISA,\n    .lanes = JLT_LANES,\n    .prepared = %zu,\n", ttc_text_string(&name),
                    ttc_text_string(&name), ttc_prepared_size(&kernels->prepared));
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++)
        if (kernels->kernels[kind].count > 0)
            ttc_text_format(text, "    .%s = %s__%s,\n", ttc_kernel_name((ttc_kernel_kind)kind), ttc_text_string(&stem),
                            ttc_kernel_name((ttc_kernel_kind)kind));
    ttc_text_format(text, "    .stages = %s_stages,\n    .stages_clock = %s_stages_clock,\n    .stages_varied = %s_stages_varied,\n"
                          "    .jet = %s_jet,\n};\n",
                    ttc_text_string(&stem), ttc_text_string(&stem), ttc_text_string(&stem), ttc_text_string(&stem));
    text->failed |= name.failed || stem.failed;
    ttc_text_clear(&name);
    ttc_text_clear(&stem);
}

void ttc_emit_lanes(ttc_text *text, const ttc_kernels *kernels)
{
    ttc_text_format(text, "/* Kernels of %s, SHA-256 %s, on vectors of JLT_LANES lanes. Written by ttc %s; do not edit.\n"
                          " * The scalar file beside this one has the formulas. */\n",
                    kernels->field->model->name, kernels->field->model->sha256, JLT_VERSION);
    add_inline(text, kernels, TTC_KERNEL_RHS, "field");
    if (kernels->field->time != NULL) add_inline(text, kernels, TTC_KERNEL_TIME_FACTOR, "clock");
    add_inline(text, kernels, TTC_KERNEL_RHS_JACOBIAN, "linear");
    add_loading(text, kernels->field, "rhs", "field");
    add_loading(text, kernels->field, "rhs_jacobian", "linear");
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++)
        if (kind != TTC_KERNEL_RHS && kind != TTC_KERNEL_RHS_JACOBIAN && kernels->kernels[kind].count > 0)
            add_kernel(text, kernels, (ttc_kernel_kind)kind);
    add_stages(text, kernels, false);
    add_stages(text, kernels, true);
    ttc_emit_stages_varied(text, kernels);
    ttc_emit_jet_lanes(text, kernels);
    add_table(text, kernels);
}

void ttc_emit_batch(ttc_text *text, const ttc_catalogue *catalogue, unsigned isa)
{
    ttc_text_format(text, "/* Batched kernels of %s for %s. Written by ttc %s; do not edit. */\n", catalogue->model->name,
                    ttc_isa_names[isa], JLT_VERSION);
    ttc_text_format(text, "#define JLT_LANES %u\n#define JLT_BATCH_ISA \"%s\"\n#define JLT_BATCH_NAME(name) name##_%s\n\n",
                    isa_lanes[isa], ttc_isa_names[isa], ttc_isa_names[isa]);
    ttc_text_add(text, "#include \"kernel_abi.h\"\n#include \"lanes.h\"\n#include \"kernel_jet.h\"\n\n");
    for (size_t i = 0; i < catalogue->count; i++) {
        if (catalogue->fields[i].kernels == NULL) continue;
        ttc_text_add(text, "#include \"");
        ttc_emit_stem(text, catalogue->fields[i].kernels->field);
        ttc_text_add(text, "_lanes.inc\"\n");
    }
}
