/* Writes Runge-Kutta stages of the variational equations on lanes: field and Jacobian once a stage, and the products of the
 * Jacobian, without its identically zero entries, with the tangent vectors. A vector of lanes goes through all stages before the
 * next one, so that its slopes stay in cache. Two tangent vectors, as for a section with two coordinates, have a function of their
 * own: they are summed with the states, and the Jacobian stays in registers as far as it can. */
#include "emit/emit.h"

#include <stdio.h>

/* Up to so many states, the sums of one stage fit in 32 registers. */
enum { TOGETHER_MAX = 7 };

/* One column for each state, from `base`, a C expression, on, with sums LETTER0, LETTER1, ... */
typedef struct {
    char letter;
    const char *base;
} columns;

static bool is_zero(const ttc_program *program, size_t output)
{
    const ttc_instruction *i = ttc_program_at(program, ttc_program_output_at(program, output));
    return i->op == TTC_OP_CONSTANT && fmpq_is_zero(i->constant);
}

/* The arguments of the stage in these columns: x + h * sum. */
static void add_sums(ttc_text *text, size_t n, const columns *c, size_t count, const char *indent)
{
    ttc_text_format(text, "%sconst double *slope = k + (columns*sum->slope[0])*row + at;\n"
                          "%sjlt_lanes weight = jlt_lanes_of(sum->weight[0]);\n", indent, indent);
    for (size_t s = 0; s < count; s++)
        for (size_t i = 0; i < n; i++)
            ttc_text_format(text, "%sjlt_lanes %c%zu = weight*jlt_lanes_load(slope + (%s + %zu)*row);\n", indent, c[s].letter, i,
                            c[s].base, i);
    ttc_text_format(text, "%sfor (unsigned l = 1; l < sum->count; l++) {\n"
                          "%s    slope = k + (columns*sum->slope[l])*row + at;\n"
                          "%s    weight = jlt_lanes_of(sum->weight[l]);\n", indent, indent, indent);
    for (size_t s = 0; s < count; s++)
        for (size_t i = 0; i < n; i++)
            ttc_text_format(text, "%s    %c%zu = jlt_lanes_fma(weight, jlt_lanes_load(slope + (%s + %zu)*row), %c%zu);\n", indent,
                            c[s].letter, i, c[s].base, i, c[s].letter, i);
    ttc_text_format(text, "%s}\n", indent);
    for (size_t s = 0; s < count; s++)
        for (size_t i = 0; i < n; i++)
            ttc_text_format(text, "%s%c%zu = jlt_lanes_fma(step, %c%zu, jlt_lanes_load(x + (%s + %zu)*row + at));\n", indent,
                            c[s].letter, i, c[s].letter, i, c[s].base, i);
    ttc_text_format(text, "%sif (i == count) {\n", indent);
    for (size_t s = 0; s < count; s++)
        for (size_t i = 0; i < n; i++)
            ttc_text_format(text, "%s    jlt_lanes_store(z + (%s + %zu)*row + at, %c%zu);\n", indent, c[s].base, i, c[s].letter, i);
    ttc_text_format(text, "%s}\n", indent);
}

/* A call with the prepared values of the vector of lanes. */
static void add_call(ttc_text *text, const ttc_field *field, const char *name, const char *out)
{
    ttc_text_add(text, "            ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "_%s(", name);
    for (size_t i = 0; i < field->state_count; i++) ttc_text_format(text, "a%zu, ", i);
    ttc_text_format(text, "own, %s);\n", out);
}

/* Slopes of the states, the integral of the divergence, and t, from field and Jacobian in `linear`. */
static void add_slopes(ttc_text *text, const ttc_kernels *kernels)
{
    const ttc_field *field = kernels->field;
    const ttc_program *program = kernels->kernels[TTC_KERNEL_RHS_JACOBIAN].optimized;
    const size_t n = field->state_count;
    bool is_first = true;

    for (size_t i = 0; i < n; i++)
        ttc_text_format(text, "            jlt_lanes_store(out + %zu*row, jlt_lanes_load(linear + %zu*JLT_LANES));\n", i, i);
    ttc_text_add(text, "            jlt_lanes_store(out + (columns - 2)*row, ");
    for (size_t i = 0; i < n; i++) {
        if (is_zero(program, n + i * n + i)) continue;
        ttc_text_format(text, "%sjlt_lanes_load(linear + %zu*JLT_LANES)", is_first ? "" : " + ", n + i * n + i);
        is_first = false;
    }
    ttc_text_add(text, is_first ? "jlt_lanes_of(0));\n" : ");\n");
    if (field->time != NULL) add_call(text, field, "clock", "out + (columns - 1)*row, row");
    else ttc_text_add(text, "            jlt_lanes_store(out + (columns - 1)*row, jlt_lanes_of(1));\n");
}

/* Emit the product of the Jacobian and these columns. */
static void add_product(ttc_text *text, const ttc_kernels *kernels, const columns *c, const char *indent)
{
    const ttc_program *program = kernels->kernels[TTC_KERNEL_RHS_JACOBIAN].optimized;
    const size_t n = kernels->field->state_count;

    for (size_t i = 0; i < n; i++) {
        bool is_first = true;
        ttc_text_format(text, "%sjlt_lanes %cd%zu = ", indent, c->letter, i);
        for (size_t j = 0; j < n; j++) {
            const size_t entry = n + i * n + j;
            if (is_zero(program, entry)) continue;
            if (is_first) ttc_text_format(text, "jlt_lanes_load(linear + %zu*JLT_LANES)*%c%zu;\n", entry, c->letter, j);
            else
                ttc_text_format(text, "%s%cd%zu = jlt_lanes_fma(jlt_lanes_load(linear + %zu*JLT_LANES), %c%zu, %cd%zu);\n", indent,
                                c->letter, i, entry, c->letter, j, c->letter, i);
            is_first = false;
        }
        if (is_first) ttc_text_add(text, "jlt_lanes_of(0);\n");
        ttc_text_format(text, "%sjlt_lanes_store(out + (%s + %zu)*row, %cd%zu);\n", indent, c->base, i, c->letter, i);
    }
}

/* The two integrals at the end, which only the last stage needs. */
static void add_integrals(ttc_text *text)
{
    ttc_text_add(text, "        for (size_t i = columns - 2; i < columns; i++) {\n"
                       "            const jlt_stage_sum *sum = sums + count - 1;\n"
                       "            jlt_lanes integral = jlt_lanes_of(0);\n"
                       "            for (unsigned l = 0; l < sum->count; l++)\n"
                       "                integral = jlt_lanes_fma(jlt_lanes_of(sum->weight[l]), "
                       "jlt_lanes_load(k + (columns*sum->slope[l] + i)*row + at), integral);\n"
                       "            integral = jlt_lanes_fma(step, integral, jlt_lanes_load(x + i*row + at));\n"
                       "            jlt_lanes_store(z + i*row + at, integral);\n        }\n");
}

static void begin_stages(ttc_text *text, const ttc_field *field, const char *name, const char *tangents)
{
    ttc_text_add(text, "\nstatic void ");
    ttc_emit_stem(text, field);
    ttc_text_format(text, "_%s(const double *restrict x, double *restrict k, const jlt_stage_sum *restrict sums,\n"
                          "    unsigned count, const double *restrict h, const double *restrict p, double *restrict z%s)\n{\n"
                          "    enum { row = JLT_BATCH_VECTORS*JLT_LANES };\n", name, tangents);
}

static void begin_loops(ttc_text *text, const ttc_kernels *kernels)
{
    const size_t n = kernels->field->state_count;
    ttc_text_format(text, "    for (unsigned at = 0; at < row; at += JLT_LANES) {\n"
                          "        const jlt_lanes step = jlt_lanes_load(h + at);\n"
                          "        for (unsigned i = 1; i <= count; i++) {\n"
                          "            const double *restrict own = jlt_lanes_fresh(p + %zu*at);\n"
                          "            const jlt_stage_sum *sum = sums + i - 1;\n"
                          "            double *out = k + columns*i*row + at;\n"
                          "            _Alignas(8*JLT_LANES) double linear[%zu*JLT_LANES];\n",
                    ttc_prepared_size(&kernels->prepared), n * (n + 1));
}

static void end_stages(ttc_text *text)
{
    ttc_text_add(text, "        }\n");
    add_integrals(text);
    ttc_text_add(text, "    }\n}\n");
}

/* The function for two tangent vectors. */
static void add_pair(ttc_text *text, const ttc_kernels *kernels)
{
    const size_t n = kernels->field->state_count;
    char first[24], second[24];
    const columns all[] = { { 'a', "0" }, { 'b', first }, { 'c', second } };

    snprintf(first, sizeof first, "%zu", n);
    snprintf(second, sizeof second, "%zu", 2 * n);
    begin_stages(text, kernels->field, "stages_pair", "");
    ttc_text_format(text, "    const size_t columns = %zu;\n", 3 * n + 2);
    begin_loops(text, kernels);
    add_sums(text, n, all, 3, "            ");
    add_call(text, kernels->field, "linear", "linear, JLT_LANES");
    add_slopes(text, kernels);
    for (size_t s = 1; s < 3; s++) add_product(text, kernels, all + s, "            ");
    end_stages(text);
}

void ttc_emit_stages_varied(ttc_text *text, const ttc_kernels *kernels)
{
    static const columns states[] = { { 'a', "0" } }, vector[] = { { 'b', "first" } };
    const size_t n = kernels->field->state_count;

    if (n <= TOGETHER_MAX) add_pair(text, kernels);
    begin_stages(text, kernels->field, "stages_varied", ", unsigned tangents");
    if (n <= TOGETHER_MAX) {
        ttc_text_add(text, "    if (tangents == 2) {\n        ");
        ttc_emit_stem(text, kernels->field);
        ttc_text_add(text, "_stages_pair(x, k, sums, count, h, p, z);\n        return;\n    }\n");
    }
    ttc_text_format(text, "    const size_t columns = %zu*(1 + (size_t)tangents) + 2;\n", n);
    begin_loops(text, kernels);
    ttc_text_format(text, "            _Alignas(8*JLT_LANES) double state[%zu*JLT_LANES];\n            {\n", n);
    add_sums(text, n, states, 1, "            ");
    for (size_t i = 0; i < n; i++) ttc_text_format(text, "            jlt_lanes_store(state + %zu*JLT_LANES, a%zu);\n", i, i);
    ttc_text_add(text, "            ");
    ttc_emit_stem(text, kernels->field);
    ttc_text_add(text, "__rhs_jacobian(state, own, linear, JLT_LANES);\n");
    add_slopes(text, kernels);
    ttc_text_format(text, "            }\n            for (unsigned v = 1; v <= tangents; v++) {\n"
                          "                const size_t first = %zu*(size_t)v;\n", n);
    add_sums(text, n, vector, 1, "                ");
    add_product(text, kernels, vector, "                ");
    ttc_text_add(text, "            }\n");
    end_stages(text);
}
