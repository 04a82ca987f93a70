/* Writes the file of one descriptor: header, kernels, tables. */
#include "emit/emit.h"
#include "fields/dimensions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void add_comment_line(ttc_text *text, const char *label, const char *content)
{
    if (content == NULL || *content == '\0') return;
    ttc_text_format(text, " *  %-12s", label);
    ttc_text_add_comment(text, content);
    ttc_text_add(text, "\n");
}

static void describe_field(ttc_text *text, ttc_field *field)
{
    ttc_text line = { 0 };
    if (field->variant != NULL) {
        ttc_text_format(&line, "%s: ", field->variant->name);
        ttc_emit_condition(&line, field, &field->variant->bindings);
        add_comment_line(text, "Variant:", ttc_text_string(&line));
        ttc_text_clear(&line);
    }
    if (field->time != NULL) {
        ttc_text_format(&line, "%s: dt = (", field->time->name);
        ttc_emit_formula(&line, field->graph, field->time->factor, ttc_emit_symbol_name, field);
        ttc_text_add(&line, ") dtau");
        for (size_t i = 0; i < ttc_field_lifted_count(field); i++)
            ttc_text_format(&line, "%s%s", i == 0 ? "; states of their own: " : ", ",
                            field->model->symbols[field->time->lifted[i]].name);
        add_comment_line(text, "Time:", ttc_text_string(&line));
        ttc_text_clear(&line);
    }
    if (field->elimination != NULL) {
        ttc_text_format(&line, "%s: %s from %s = %s", field->elimination->name,
                        field->model->symbols[field->elimination->state].name,
                        field->model->claims[field->elimination->integral].name,
                        field->model->symbols[field->elimination->level].name);
        add_comment_line(text, "Eliminated:", ttc_text_string(&line));
        ttc_text_clear(&line);
    }
    text->failed |= line.failed;
}

/* A line of the header, broken after commas if it is long. */
static void add_wrapped(ttc_text *text, char *line)
{
    enum { WIDTH = 112 };
    for (bool is_first = true; line != NULL; is_first = false) {
        char *end = strstr(line, ", "), *next = end;
        while (next != NULL && (size_t)(next - line) < WIDTH && strlen(line) > WIDTH) {
            end = next;
            next = strstr(next + 2, ", ");
        }
        if (strlen(line) <= WIDTH) end = NULL;
        if (end != NULL) end[1] = '\0';
        ttc_text_add(text, is_first ? " *    " : " *      ");
        ttc_text_add_comment(text, line);
        ttc_text_add(text, "\n");
        line = end == NULL ? NULL : end + 2;
    }
}

/* Losses of the field and its Jacobian, one a line. */
static void add_accuracy(ttc_text *text, ttc_kernels *k)
{
    ttc_text losses = { 0 };
    ttc_emit_losses(&losses, k, TTC_KERNEL_RHS_JACOBIAN);
    ttc_text_add(text, " *\n *  Accuracy\n");
    if (losses.length == 0)
        ttc_text_add(text, " *    no denominator or radicand of the field vanishes in the domain, and no terms cancel\n");
    for (char *line = losses.bytes, *end = line; line != NULL; line = end == NULL ? NULL : end + strlen(TTC_LOSS_SEPARATOR)) {
        end = strstr(line, TTC_LOSS_SEPARATOR);
        if (end != NULL) *end = '\0';
        add_wrapped(text, line);
    }
    text->failed |= losses.failed;
    ttc_text_clear(&losses);
}

static const char *effort_option(const ttc_kernels *k) { return k->effort == TTC_EFFORT_FULL ? " --effort full" : ""; }

void ttc_emit_command(ttc_text *text, const ttc_kernels *k)
{
    ttc_text_format(text, "ttc generate%s%s --out DIR %s (ttc %s); do not edit", effort_option(k),
                    k->unproved != NULL ? " --unproved" : "", ttc_model_base_name(k->field->model), JLT_VERSION);
}

static void write_generator(ttc_text *text, const ttc_kernels *k)
{
    ttc_text_format(text, "ttc %s%s", JLT_VERSION, effort_option(k));
}

static void add_header(ttc_text *text, ttc_kernels *k)
{
    const ttc_model *model = k->field->model;
    ttc_text_add(text, "/* ");
    ttc_text_add_comment(text, model->title == NULL ? model->name : model->title);
    ttc_text_add(text, "\n *\n");
    add_comment_line(text, "Source:", model->source);
    describe_field(text, k->field);
    ttc_text_format(text, " *  %-12s%s, SHA-256 %s\n", "Table:", model->name, model->sha256);
    ttc_text_format(text, " *  %-12s", "Command:");
    ttc_emit_command(text, k);
    ttc_text_add(text, "\n");
    add_comment_line(text, "UNPROVED:", k->unproved);
    ttc_text_add(text, " *\n *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)\n");
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) {
        const ttc_kernel *kernel = k->kernels + kind;
        if (kernel->count == 0) continue;
        ttc_count c = ttc_program_count(kernel->optimized);
        ttc_text_format(text, " *  %-20s%u %4u %4u %4u %4u %4u %6u %4u   (%u)\n", ttc_kernel_name((ttc_kernel_kind)kind), c.add,
                        c.multiply, c.fma, c.divide, c.root, c.elementary, c.depth, c.live,
                        ttc_count_flops(ttc_program_count(kernel->naive)));
    }
    add_accuracy(text, k);
    const ttc_kernel *both = k->kernels + TTC_KERNEL_RHS_JACOBIAN;
    if (ttc_program_count(both->optimized).divide < ttc_program_count(both->naive).divide)
        ttc_text_add(
            text,
            " *    one division serves all denominators: their product may leave the range of double precision where none of\n"
            " *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN\n");
    ttc_text_add(text, " */\n");
}

static void add_prepare(ttc_text *text, const ttc_kernels *k)
{
    size_t n = k->field->param_count;
    ttc_text_add(text, "static void prepare(const double *restrict params, double *restrict out)\n{\n");
    if (n == 0 && k->prepared.count == 0) ttc_text_add(text, "    (void)params;\n    (void)out;\n");
    for (size_t i = 0; i < n; i++) ttc_text_format(text, "    out[%zu] = params[%zu];\n", i, i);
    ttc_emit_body(text, &ttc_dialect_scalar, k->prepare, k->field, NULL, "params", n);
    ttc_text_add(text, "}\n\n");
}

static bool add_impose(ttc_text *text, ttc_kernels *k)
{
    ttc_field *field = k->field;
    if (field->variant == NULL) return true;
    ttc_id *ids = calloc(field->param_count + 1, sizeof *ids);
    ttc_program *program = NULL;
    for (size_t i = 0; ids != NULL && i < field->param_count; i++)
        ids[i] = ttc_field_specialise(field, field->model->symbols[field->params[i]].node);
    if (ids != NULL) program = ttc_lower(field, ids, field->param_count, (ttc_lowering){ .share = true });
    if (program != NULL) {
        ttc_emit_function(text, "impose", program, field, NULL);
        ttc_text_add(text, "\n");
    }
    ttc_program_destroy(program);
    free(ids);
    return program != NULL;
}

static void add_names(ttc_text *text, const char *name, ttc_field *field, const uint32_t *claims, size_t count)
{
    if (count == 0) return;
    ttc_text_format(text, "static const jlt_named %s[] = {\n", name);
    for (size_t i = 0; i < count; i++) {
        const ttc_claim *claim = field->model->claims + claims[i];
        ttc_text_format(text, "    { \"%s\", \"", claim->name);
        ttc_emit_condition(text, field, &claim->when);
        ttc_text_add(text, "\" },\n");
    }
    ttc_text_add(text, "};\n\n");
}

static void add_validities(ttc_text *text, const ttc_model *model)
{
    ttc_text_add(text, "static const jlt_validity valids[] = {\n");
    for (size_t i = 0; i < model->validity_count; i++) {
        ttc_text_format(text, "    { \"%s\", \"", model->validities[i].name);
        ttc_text_add_escaped(text, model->validities[i].unit);
        ttc_text_add(text, "\", \"");
        ttc_text_add_escaped(text, model->validities[i].meaning);
        ttc_text_add(text, "\" },\n");
    }
    ttc_text_add(text, "};\n\n");
}

static void add_conditions(ttc_text *text, const ttc_kernels *k)
{
    ttc_text_add(text, "static const jlt_region domains[] = {\n");
    for (size_t i = 0; i < k->watched_count; i++) {
        ttc_text_format(text, "    { \"%s\", \"", k->watched[i].name);
        ttc_text_add_escaped(text, k->watched[i].text);
        ttc_text_format(text, "\", %d },\n", ttc_field_is_constant(k->field, k->kernels[TTC_KERNEL_DOMAIN_VALUES].outputs[i]));
    }
    ttc_text_add(text, "};\n\n");
}

static void add_count(ttc_text *text, ttc_count c)
{
    ttc_text_format(text, "{ %u, %u, %u, %u, %u, %u, %u, %u }", c.add, c.multiply, c.fma, c.divide, c.root, c.elementary,
                    c.depth, c.live);
}

static void add_kernel_member(ttc_text *text, ttc_kernels *k, ttc_kernel_kind kind)
{
    const ttc_kernel *kernel = k->kernels + kind;
    ttc_text losses = { 0 };
    if (kernel->count == 0) {
        ttc_text_format(text, "    .%s = { .loses_digits = \"\" },\n", ttc_kernel_name(kind));
        return;
    }
    ttc_emit_losses(&losses, k, kind);
    ttc_text_format(text, "    .%s = { %s, %zu, ", ttc_kernel_name(kind), ttc_kernel_name(kind), kernel->count);
    add_count(text, ttc_program_count(kernel->optimized));
    ttc_text_add(text, ", ");
    add_count(text, ttc_program_count(kernel->naive));
    ttc_text_add(text, ",\n        \"");
    ttc_text_add_escaped(text, ttc_text_string(&losses));
    ttc_text_add(text, "\" },\n");
    text->failed |= losses.failed;
    ttc_text_clear(&losses);
}

static void add_string_member(ttc_text *text, const char *member, const char *value)
{
    ttc_text_format(text, "    .%s = \"", member);
    ttc_text_add_escaped(text, value);
    ttc_text_add(text, "\",\n");
}

static void add_descriptor(ttc_text *text, ttc_kernels *k, size_t sections, size_t ways, size_t divisors)
{
    const ttc_field *field = k->field;
    const ttc_model *model = field->model;
    ttc_text_format(text, "const jlt_descriptor jlt_kernels_%s_", model->name);
    ttc_emit_stem(text, field);
    ttc_text_add(text, " = {\n");
    add_string_member(text, "model", model->name);
    add_string_member(text, "variant", field->variant == NULL ? "" : field->variant->name);
    add_string_member(text, "time", field->time == NULL ? "" : field->time->name);
    add_string_member(text, "elimination", field->elimination == NULL ? "" : field->elimination->name);
    add_string_member(text, "title", model->title);
    add_string_member(text, "source", model->source);
    add_string_member(text, "sha256", model->sha256);
    ttc_text_add(text, "    .generator = \"");
    write_generator(text, k);
    ttc_text_add(text, "\",\n");
    if (k->unproved != NULL) add_string_member(text, "unproved", k->unproved);
    ttc_text_format(text, "    .table = jlt_table_%s, .family = jlt_family_%s, .claims = jlt_claims_%s,\n", model->name,
                    model->name, model->name);
    if (ttc_dimensions_agree(k->field, k->integrals, k->integral_count)) ttc_text_add(text, "    .scales = 1,\n");
    ttc_text_format(text, "    .state_count = %zu, .param_count = %zu, .prepared_count = %zu,\n", field->state_count,
                    field->param_count, ttc_prepared_size(&k->prepared));
    if (field->state_count > 0) ttc_text_add(text, "    .states = states,\n");
    if (field->param_count > 0) ttc_text_add(text, "    .params = params,\n");
    if (field->variant != NULL) ttc_text_add(text, "    .impose = impose,\n");
    ttc_text_add(text, "    .prepare = prepare,\n");
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) add_kernel_member(text, k, (ttc_kernel_kind)kind);
    if (k->kernels[TTC_KERNEL_OBSERVE_VALUES].count > 0)
        ttc_text_format(text, "    .observe_count = %zu, .observes = observes,\n", model->observed_count);
    if (k->kernels[TTC_KERNEL_VALID_VALUES].count > 0)
        ttc_text_format(text, "    .valid_count = %zu, .valids = valids,\n", model->validity_count);
    if (k->watched_count > 0) ttc_text_format(text, "    .domain_count = %zu, .domains = domains,\n", k->watched_count);
    if (divisors > 0)
        ttc_text_format(text, "    .divisor_count = %zu, .divisors = divisors, .divisor_values = divisor_values,\n", divisors);
    ttc_emit_reversor_member(text, field);
    ttc_emit_pole_member(text, field);
    if (sections > 0) ttc_text_format(text, "    .section_count = %zu, .sections = sections,\n", sections);
    ttc_emit_way_members(text, field, ways);
    ttc_emit_root_member(text, field);
    ttc_text_format(text, "    .integral_count = %zu, .measure_count = %zu, .equilibria_count = %zu,\n", k->integral_count,
                    k->measure_count, k->family_count);
    if (k->integral_count > 0) ttc_text_add(text, "    .integrals = integrals,\n");
    if (k->measure_count > 0) ttc_text_add(text, "    .measures = measures,\n");
    if (k->family_count > 0) ttc_text_add(text, "    .equilibria = equilibria,\n");
    ttc_text_add(text, "#ifndef JLT_WITHOUT_BALLS\n    .balls = &");
    ttc_emit_ball_name(text, field);
    ttc_text_add(text, ",\n#endif\n");
    ttc_text_add(text, "    .jet = jet,\n    .rhs_complex = rhs_complex,\n#ifndef JLT_WITHOUT_LANES\n");
    ttc_text_format(text, "    .batches = { JLT_BATCHES(jlt_batch_%s_", model->name);
    ttc_emit_stem(text, field);
    ttc_text_add(text, ") },\n#endif\n};\n");
}

bool ttc_emit_descriptor(ttc_text *text, ttc_kernels *k)
{
    const ttc_field *field = k->field;
    size_t sections = 0, ways = 0, divisors = 0;
    add_header(text, k);
    ttc_text_add(text,
                 "#include \"kernel_abi.h\"\n#include \"kernel_arithmetic.h\"\n#include \"kernel_jet.h\"\n\n#include <math.h>\n\n");
    ttc_emit_model_names(text, field->model);
    ttc_text_format(text, "extern const jlt_descriptor jlt_kernels_%s_", field->model->name);
    ttc_emit_stem(text, field);
    ttc_text_add(text, ";\nextern const struct jlt_ball_table ");
    ttc_emit_ball_name(text, field);
    ttc_text_add(text, ";\n");
    for (unsigned isa = 0; isa < TTC_ISA_COUNT; isa++) {
        ttc_text_format(text, "extern const jlt_kernel_batch jlt_batch_%s_", field->model->name);
        ttc_emit_stem(text, field);
        ttc_text_format(text, "_%s;\n", ttc_isa_names[isa]);
    }
    ttc_text_add(text, "\n");
    if (!add_impose(text, k)) return false;
    add_prepare(text, k);
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) {
        if (k->kernels[kind].count == 0) continue;
        ttc_emit_function(text, ttc_kernel_name((ttc_kernel_kind)kind), k->kernels[kind].optimized, field, &k->prepared);
        ttc_text_add(text, "\n");
    }
    ttc_emit_jet(text, k);
    ttc_text_add(text, "\n");
    ttc_emit_complex(text, k->field);
    ttc_text_add(text, "\n");
    if (!ttc_emit_equilibria(text, k) || !ttc_emit_sections(text, k, &sections) || !ttc_emit_lifted(text, field) ||
        !ttc_emit_roots(text, k->field) || !ttc_emit_tier(text, k->field) || !ttc_emit_ways(text, k, &ways) ||
        !ttc_emit_divisors(text, k->field, &divisors))
        return false;
    ttc_emit_quantities(text, "states", field->model, field->states, field->state_count, NULL);
    ttc_emit_quantities(text, "params", field->model, field->params, field->param_count, NULL);
    add_names(text, "integrals", k->field, k->integrals, k->integral_count);
    add_names(text, "measures", k->field, k->measures, k->measure_count);
    if (k->kernels[TTC_KERNEL_OBSERVE_VALUES].count > 0)
        ttc_emit_quantities(text, "observes", field->model, field->model->observed, field->model->observed_count, NULL);
    if (k->kernels[TTC_KERNEL_VALID_VALUES].count > 0) add_validities(text, field->model);
    if (k->watched_count > 0) add_conditions(text, k);
    ttc_emit_reversors(text, field);
    ttc_emit_poles(text, field);
    add_descriptor(text, k, sections, ways, divisors);
    return !text->failed;
}
