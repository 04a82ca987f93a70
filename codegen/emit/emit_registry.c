#include "emit/emit_registry.h"

#include "emit/emit.h"

void ttc_emit_registry_header(ttc_text *text)
{
    ttc_text_add(text, "/** All descriptors, those of a model together, the general field of each first. Written by ttc; do not edit. */\n"
                       "#ifndef JLT_REGISTRY_H\n"
                       "#define JLT_REGISTRY_H\n"
                       "\n"
                       "#include \"kernel_abi.h\"\n"
                       "\n"
                       "extern const jlt_descriptor *const jlt_registry[];\n"
                       "extern const unsigned jlt_registry_count;\n"
                       "\n"
                       "#endif\n");
}

static void add_list(ttc_text *text, const ttc_plan *plans, size_t count, const char *type, const char *prefix,
                     const char *registry, bool balls)
{
    ttc_text entries = { 0 };
    size_t number = 0;
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < plans[i].count; k++) {
            const ttc_planned *planned = plans[i].fields + k;
            if (planned->kernels == NULL || (balls && planned->variant != NULL)) continue;
            ttc_text name = { 0 };
            ttc_text_format(&name, "%s_%s_", prefix, plans[i].model->name);
            ttc_emit_stem(&name, planned->kernels->field);
            ttc_text_format(text, "extern const %s %s;\n", type, ttc_text_string(&name));
            ttc_text_format(&entries, "    &%s,\n", ttc_text_string(&name));
            text->failed |= name.failed;
            ttc_text_clear(&name);
            number++;
        }
    ttc_text_format(text, "\nconst %s *const %s[] = {\n%s};\n\nconst unsigned %s_count = %zu;\n", type, registry,
                    ttc_text_string(&entries), registry, number);
    text->failed |= entries.failed;
    ttc_text_clear(&entries);
}

void ttc_emit_registry(ttc_text *text, const ttc_plan *plans, size_t count)
{
    ttc_text_add(text, "/* Written by ttc; do not edit. */\n#include \"registry.h\"\n\n");
    add_list(text, plans, count, "jlt_descriptor", "jlt_kernels", "jlt_registry", false);
}

void ttc_emit_ball_registry(ttc_text *text, const ttc_plan *plans, size_t count)
{
    ttc_text_add(text, "/* Written by ttc; do not edit. */\n#include \"kernel_ball.h\"\n\n");
    add_list(text, plans, count, "jlt_ball_table", "jlt_balls", "jlt_ball_registry", true);
    ttc_text_add(text, "\nvoid jlt_ball_rational(arb_t out, const char *digits, slong prec)\n"
                       "{\n"
                       "    fmpq_t q;\n"
                       "    fmpq_init(q);\n"
                       "    if (fmpq_set_str(q, digits, 10) == 0) arb_set_fmpq(out, q, prec);\n"
                       "    else arb_indeterminate(out);\n"
                       "    fmpq_clear(q);\n"
                       "}\n");
}

static const char *name_or_dash(const char *name) { return name == NULL ? "-" : name; }

static void add_key(ttc_text *text, const ttc_plan *plan, const ttc_planned *planned)
{
    ttc_text_format(text, "%s\t%s\t%s\t%s", plan->model->name,
                    name_or_dash(planned->variant == NULL ? NULL : planned->variant->name),
                    name_or_dash(planned->time == NULL ? NULL : planned->time->name),
                    name_or_dash(planned->elimination == NULL ? NULL : planned->elimination->name));
}

void ttc_emit_manifest(ttc_text *text, const ttc_plan *plans, size_t count)
{
    ttc_text_add(text, "model\tvariant\ttime\telimination\tsha256\tfile\n");
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < plans[i].count; k++) {
            const ttc_planned *planned = plans[i].fields + k;
            add_key(text, plans + i, planned);
            ttc_text_format(text, "\t%s\t", plans[i].model->sha256);
            if (planned->kernels == NULL) {
                ttc_text_add(text, "none: divides by zero identically\n");
                continue;
            }
            ttc_text_format(text, "%s/", plans[i].model->name);
            ttc_emit_stem(text, planned->kernels->field);
            ttc_text_add(text, ".c\n");
        }
}

static void add_counts(ttc_text *text, ttc_count c)
{
    ttc_text_format(text, "\t%u\t%u\t%u\t%u\t%u\t%u\t%u\t%u\t%u", ttc_count_flops(c), c.add, c.multiply, c.fma, c.divide,
                    c.root, c.elementary, c.depth, c.live);
}

void ttc_emit_counts(ttc_text *text, const ttc_plan *plans, size_t count)
{
    static const char *const columns[] = { "flops", "add", "mul", "fma", "div", "sqrt", "elementary", "depth", "live" };
    ttc_text_add(text, "model\tvariant\ttime\telimination\tkernel");
    for (int side = 0; side < 2; side++)
        for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
            ttc_text_format(text, "\t%s%s", side == 0 ? "" : "naive_", columns[i]);
    ttc_text_add(text, "\n");
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < plans[i].count; k++)
            for (int kind = 0; plans[i].fields[k].kernels != NULL && kind < TTC_KERNEL_KINDS; kind++) {
                const ttc_kernel *kernel = plans[i].fields[k].kernels->kernels + kind;
                if (kernel->count == 0) continue;
                add_key(text, plans + i, plans[i].fields + k);
                ttc_text_format(text, "\t%s", ttc_kernel_name((ttc_kernel_kind)kind));
                add_counts(text, ttc_program_count(kernel->optimized));
                add_counts(text, ttc_program_count(kernel->naive));
                ttc_text_add(text, "\n");
            }
}
