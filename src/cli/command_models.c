/* `jellett models`: lists the built-in models with their kernels, and the user's tables in the working directory. */
#include "base/options.h"
#include "cli/table.h"

#include "kernel/descriptor.h"
#include "report/json.h"

#include <argp.h>
#include <glob.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    bool json;
    const char *model; /* NULL: all */
} options;

static const struct argp_option option_table[] = {
    { "json", 'j', NULL, 0, "Print JSON", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case 'j': o->json = true; return 0;
    case ARGP_KEY_ARG:
        if (o->model != NULL) argp_error(state, "one model at most: '%s' is too many", value);
        o->model = value;
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "List the models that are built in, and your own tables in this folder; or describe one model or table (./my.tt): states, "
    "parameters, variants, kernels with operation counts, and hashes."
    "\vCounts are the operations of one call, on prepared parameters, of the right-hand side, of the Jacobian, and of both fused; "
    "a fused multiply-add counts as one. The hash is that of the table from which the kernels were written. JSON has the models "
    "that are built in, or the one that is named.",
    NULL, NULL, NULL,
};

/* A kernel of a descriptor; they are listed in the order of kernel_abi.h. */
typedef struct {
    const char *name;
    const jlt_kernel *kernel;
} entry;
enum { KERNELS = 14 };

static void list_kernels(entry out[KERNELS], const jlt_descriptor *d)
{
    const entry all[KERNELS] = {
        { "rhs", &d->rhs },
        { "jacobian", &d->jacobian },
        { "rhs_jacobian", &d->rhs_jacobian },
        { "divergence", &d->divergence },
        { "integral_values", &d->integral_values },
        { "integral_gradients", &d->integral_gradients },
        { "measure_values", &d->measure_values },
        { "measure_divergences", &d->measure_divergences },
        { "time_factor", &d->time_factor },
        { "eliminated", &d->eliminated },
        { "observe_values", &d->observe_values },
        { "valid_values", &d->valid_values },
        { "domain_values", &d->domain_values },
        { "domain_gradients", &d->domain_gradients },
    };
    memcpy(out, all, sizeof all);
}

static json_t *count_json(const jlt_operation_count *c)
{
    return json_pack("{s:i,s:i,s:i,s:i,s:i,s:i,s:i,s:i}", "add", (int)c->add, "multiply", (int)c->multiply, "fma",
                     (int)c->fma, "divide", (int)c->divide, "root", (int)c->root, "elementary", (int)c->elementary,
                     "depth", (int)c->depth, "live", (int)c->live);
}

static json_t *names_json(const jlt_named *named, unsigned count)
{
    json_t *array = json_array();

    for (unsigned i = 0; i < count; i++)
        json_array_append_new(array, json_pack("{s:s,s:s}", "name", named[i].name, "when", named[i].condition));
    return array;
}

static json_t *quantities_json(const jlt_quantity *quantities, unsigned count, bool defaults)
{
    json_t *array = json_array();

    for (unsigned i = 0; i < count; i++) {
        json_t *item = json_pack("{s:s,s:s,s:s}", "name", quantities[i].name, "unit", quantities[i].unit, "meaning",
                                 quantities[i].meaning);
        if (defaults) json_object_set_new(item, "default", jlt_json_number(quantities[i].value));
        json_array_append_new(array, item);
    }
    return array;
}

static json_t *sections_json(const jlt_descriptor *d)
{
    json_t *array = json_array();

    for (unsigned i = 0; i < d->section_count; i++) {
        const jlt_section_chart *s = &d->sections[i];
        json_array_append_new(array, json_pack("{s:s,s:b,s:s,s:o,s:o,s:o}", "name", s->name, "proved",
                                               d->claims[s->claim].verdict == JLT_PROVED, "state", d->states[s->column].name,
                                               "value", jlt_json_number(s->level), "coordinates",
                                               quantities_json(s->coordinates, s->coordinate_count, false), "levels",
                                               quantities_json(s->levels, s->level_count, true)));
    }
    return array;
}

static json_t *ways_json(const jlt_descriptor *d)
{
    json_t *array = json_array();

    for (unsigned i = 0; i < d->way_count; i++) {
        const jlt_way *way = &d->ways[i];
        json_t *conditions = json_array();
        for (unsigned k = 0; k < way->condition_count; k++) json_array_append_new(conditions, json_string(way->conditions[k].text));
        json_array_append_new(array, json_pack("{s:s,s:s,s:s,s:b,s:o}", "name", way->name, "kind", way->kind, "model", way->model,
                                               "proved", d->claims[way->claim].verdict == JLT_PROVED, "conditions", conditions));
    }
    return array;
}

static json_t *descriptor_json(const jlt_descriptor *d)
{
    entry kernels[KERNELS];
    json_t *object = json_pack("{s:s,s:s,s:s,s:s,s:s,s:s,s:s}", "model", d->model, "variant", d->variant, "time", d->time,
                               "elimination", d->elimination, "title", d->title, "sha256", d->sha256, "generator",
                               d->generator);
    json_object_set_new(object, "unproved", jlt_json_string(d->unproved));
    json_t *counts = json_object();

    list_kernels(kernels, d);
    for (size_t i = 0; i < KERNELS; i++)
        if (kernels[i].kernel->call != NULL)
            json_object_set_new(counts, kernels[i].name,
                                json_pack("{s:i,s:o,s:o,s:s}", "outputs", (int)kernels[i].kernel->outputs, "optimized",
                                          count_json(&kernels[i].kernel->optimized), "naive",
                                          count_json(&kernels[i].kernel->naive), "loses_digits",
                                          kernels[i].kernel->loses_digits));
    json_object_set_new(object, "states", quantities_json(d->states, d->state_count, false));
    json_object_set_new(object, "parameters", quantities_json(d->params, d->param_count, true));
    json_object_set_new(object, "integrals", names_json(d->integrals, d->integral_count));
    json_object_set_new(object, "measures", names_json(d->measures, d->measure_count));
    json_object_set_new(object, "observes", quantities_json(d->observes, d->observe_count, false));
    json_object_set_new(object, "sections", sections_json(d));
    json_object_set_new(object, "ways", ways_json(d));
    json_object_set_new(object, "kernels", counts);
    return object;
}

static void print_quantities(FILE *stream, const char *title, const jlt_quantity *quantities, unsigned count)
{
    fprintf(stream, "  %s\n", title);
    for (unsigned i = 0; i < count; i++) {
        const jlt_quantity *q = &quantities[i];
        fprintf(stream, "    %-10s %-9s %s", q->name, q->unit, q->meaning);
        if (q->value == q->value && title[0] == 'p') fprintf(stream, " (default %.10g)", q->value);
        fputc('\n', stream);
    }
}

static void print_section(FILE *stream, const jlt_descriptor *d, const jlt_section_chart *s)
{
    fprintf(stream, "    %-22s %s = %.10g in", s->name, d->states[s->column].name, s->level);
    for (unsigned i = 0; i < s->coordinate_count; i++) fprintf(stream, "%s %s", i == 0 ? "" : ",", s->coordinates[i].name);
    for (unsigned i = 0; i < s->level_count; i++)
        fprintf(stream, "%s %s = %.10g", i == 0 ? " on levels" : ",", s->levels[i].name, s->levels[i].value);
    fputs(d->claims[s->claim].verdict == JLT_PROVED ? "\n" : "  NOT PROVED\n", stream);
}

static bool excludes(const jlt_descriptor *d, const jlt_equilibria *family)
{
    return family->obstructs && jlt_descriptor_proves(d, "obstructs", family->name);
}

/* A larger table serves if its own reduction is proved, too; one that is not built in is not compiled here to know that. */
static void print_way(FILE *stream, const jlt_descriptor *d, const jlt_way *way)
{
    const jlt_descriptor *built_in = jlt_way_target(way, NULL);
    const jlt_claim *broken = &d->claims[way->claim];
    const bool holds = broken->verdict == JLT_PROVED, is_lift = strcmp(way->kind, "lift") == 0;
    const bool is_open = is_lift && (built_in == NULL || !jlt_way_holds(&broken, d, way, built_in));

    fprintf(stream, "    %-22s %s %s", way->name, is_lift ? "part of" : "reduced to", way->model);
    for (unsigned i = 0; i < way->condition_count; i++) fprintf(stream, "%s %s", i == 0 ? " where" : ",", way->conditions[i].text);
    fputs(!holds ? "  NOT PROVED\n" : is_open ? "  if its reduction is proved\n" : "\n", stream);
}

static void print_descriptor(FILE *stream, const jlt_descriptor *d, bool first)
{
    char name[128];

    if (first) {
        fprintf(stream, "%s%s%s\n  table %s\n  %s\n", d->model, *d->title == '\0' ? "" : ": ", d->title, d->sha256, d->generator);
        print_quantities(stream, "states", d->states, d->state_count);
        print_quantities(stream, "parameters", d->params, d->param_count);
        if (d->observe_count > 0) print_quantities(stream, "observed", d->observes, d->observe_count);
        for (unsigned i = 0; i < d->valid_count; i++)
            fprintf(stream, "%s    %-20s %s\n", i == 0 ? "  valid where\n" : "", d->valids[i].name, d->valids[i].meaning);
        for (unsigned i = 0; i < d->domain_count; i++)
            fprintf(stream, "%s    %-20s %s\n", i == 0 ? "  domain\n" : "", d->domains[i].name, d->domains[i].text);
        if (d->section_count > 0) fputs("  sections\n", stream);
        for (unsigned i = 0; i < d->section_count; i++) print_section(stream, d, &d->sections[i]);
        if (d->way_count > 0) fputs("  served by\n", stream);
        for (unsigned i = 0; i < d->way_count; i++) print_way(stream, d, &d->ways[i]);
        if (d->equilibria_count > 0) fputs("  equilibria\n", stream);
        for (unsigned i = 0; i < d->equilibria_count; i++)
            fprintf(stream, "    %-22s %s%s\n", d->equilibria[i].name, d->equilibria[i].condition,
                    excludes(d, &d->equilibria[i]) ? "  [its trace excludes an invariant measure]" : "");
        fprintf(stream, "  %-46s %6s %6s %9s %7s  %s\n", "kernels (variant, time, elimination)", "states", "rhs",
                "jacobian", "fused", "integrals, measures");
    }
    snprintf(name, sizeof name, "%s%s%s%s%s", d->variant[0] != '\0' ? d->variant : "general",
             d->time[0] != '\0' ? ", " : "", d->time, d->elimination[0] != '\0' ? ", " : "", d->elimination);
    fprintf(stream, "    %-44s %6u %6u %9u %7u ", name, d->state_count, jlt_descriptor_operations(&d->rhs.optimized),
            jlt_descriptor_operations(&d->jacobian.optimized), jlt_descriptor_operations(&d->rhs_jacobian.optimized));
    for (unsigned i = 0; i < d->integral_count; i++) fprintf(stream, " %s", d->integrals[i].name);
    for (unsigned i = 0; i < d->measure_count; i++) fprintf(stream, " %s", d->measures[i].name);
    if (d->unproved != NULL) fprintf(stream, "  UNPROVED: rests on %s", d->unproved);
    fputc('\n', stream);
}

/* Show the fields of a model: in `all`, as JSON, unless that is NULL, else as text. */
static void show_family(FILE *stream, json_t *all, const jlt_descriptor *model)
{
    for (const jlt_descriptor *const *d = model->family; *d != NULL; d++)
        if (all != NULL) json_array_append_new(all, descriptor_json(*d));
        else print_descriptor(stream, *d, d == model->family);
}

/* List the user's own tables in the working directory. They are not compiled here. */
static void list_folder(FILE *stream)
{
    glob_t found;

    fputs("\ntables of your own in this folder: jellett COMMAND ./TABLE compiles one, jellett models ./TABLE shows it\n", stream);
    if (glob("./*.tt", 0, NULL, &found) != 0) {
        fputs("    none\n", stream);
        return;
    }
    for (size_t i = 0; i < found.gl_pathc; i++) fprintf(stream, "    %s\n", found.gl_pathv[i]);
    globfree(&found);
}

/* Print without blanks at the ends of lines, which empty columns leave. Takes *output. */
static jlt_exit deliver(jlt_command_output *output)
{
    size_t length;

    if (jlt_command_close(output) != JLT_OK) {
        jlt_command_discard(output);
        return jlt_command_no_memory();
    }
    for (const char *line = output->text; *line != '\0'; line += length + 1) {
        size_t kept = length = strcspn(line, "\n");
        while (kept > 0 && line[kept - 1] == ' ') kept--;
        printf("%.*s\n", (int)kept, line);
    }
    jlt_command_discard(output);
    return JLT_EXIT_DONE;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { 0 };
    jlt_command_output output;
    json_t *all = NULL;

    ttc_options_parse(&parser, argc, argv, &o);
    if (jlt_command_open(&output) != JLT_OK)
        return jlt_command_no_memory();
    if (o.json) all = json_array();
    if (o.model != NULL) {
        const jlt_descriptor *model;
        const jlt_exit code = jlt_table_open(&model, &(bool){ false }, o.model, false);
        if (code != JLT_EXIT_DONE) {
            json_decref(all);
            jlt_command_discard(&output);
            return code;
        }
        show_family(output.stream, all, model);
    } else {
        for (size_t i = 0; i < jlt_descriptor_count(); i++) {
            const jlt_descriptor *d = jlt_descriptor_at(i);
            if (d != d->family[0]) continue;
            if (!o.json && i > 0) fputc('\n', output.stream);
            show_family(output.stream, all, d);
        }
        if (!o.json) list_folder(output.stream);
    }
    if (o.json && jlt_json_write(output.stream, all) != JLT_OK) {
        jlt_command_discard(&output);
        return jlt_command_no_memory();
    }
    return deliver(&output);
}

const jlt_command jlt_command_models = {
    "models", "[MODEL] [--json]", "Models built in and in this folder: variants, kernels, counts, hashes", run, NULL, NULL
};
