/* Sections that tables describe: finds them, makes the system of a command line on one, and prints why that is refused. */
#include "cli/motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/grid.h"
#include "cli/table.h"
#include "core/digits.h"
#include "core/memory.h"
#include "dynamics/surface_units.h"
#include "kernel/descriptor.h"

/* List the names of parameters and levels number first .. end - 1; and: the separator before the last one. */
static void list_names(char *text, size_t size, const jlt_surface *surface, unsigned first, unsigned end, const char *and)
{
    size_t used = 0;

    *text = '\0';
    for (unsigned i = first; i < end && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", i == first ? "" : i + 1 == end ? and : ", ", surface->names[i]);
}

static jlt_exit refuse_empty(const jlt_surface *surface, const double *values, const char *what)
{
    const jlt_section_chart *section = surface->section;
    char text[512];
    double level;
    int used = snprintf(text, sizeof text, "no state with %s = %.10g has", surface->table->states[section->column].name,
                        section->level);

    for (unsigned i = surface->params; i < surface->count && used < (int)sizeof text; i++)
        used += snprintf(text + used, sizeof text - (size_t)used, "%s %s = %.10g",
                         i == surface->params      ? ""
                         : i + 1 == surface->count ? " and"
                                                   : ",",
                         surface->names[i], values[i]);
    if (!jlt_surface_nearest_level(surface, values, &level))
        return jlt_command_fail(JLT_EXIT_INPUT, "%s%s: change a level or parameter", what, text);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s%s: %s %s %s %.10g, or change another level or parameter", what, text,
                            level > values[surface->params] ? "raise" : "lower", surface->names[surface->params],
                            level > values[surface->params] ? "above" : "below", fabs(level) > 1e-300 ? level : 0);
}

enum { OWN_SECTION = 128 };

/* Write what asks for the same plane in the table asked for, whose state may have another name there. Returns text. */
static const char *own_section(char text[OWN_SECTION], const jlt_surface *surface)
{
    const char *name = surface->table->states[surface->section->column].name;
    char digits[JLT_DIGITS_SIZE];
    size_t index;

    jlt_digits_shortest(digits, surface->section->level);
    if (!jlt_descriptor_state(surface->asked, name, &index)) return "--section STATE=VALUE";
    snprintf(text, OWN_SECTION, "--section %s=%s", name, digits);
    return text;
}

/* Refuse a section that exceeds the limits for sections that tables describe, or whose names are not unique; plane sections do not
 * have these limits. */
static jlt_exit refuse_large(const jlt_surface *surface)
{
    const jlt_section_chart *section = surface->section;
    const jlt_descriptor *table = surface->table;
    const unsigned values = table->param_count + section->level_count, coordinates = section->coordinate_count;
    char what[160], own[OWN_SECTION];

    for (unsigned k = 0; k < values; k++) {
        const jlt_quantity *q = k < table->param_count ? &table->params[k] : &section->levels[k - table->param_count];
        const char *level = q->name, *taken = jlt_surface_taken(surface, level);
        if (taken != NULL)
            return jlt_command_fail(JLT_EXIT_INPUT, "the section %s of %s has a level %s, which is %s of %s: rename one of the "
                                    "two, or ask for a section of the table itself, %s", section->name, table->model, level, taken,
                                    surface->asked->model, own_section(own, surface));
    }
    if (coordinates > JLT_CHART_COORDINATES_MAX)
        snprintf(what, sizeof what, "has %u coordinates, and %d are the limit", coordinates, (int)JLT_CHART_COORDINATES_MAX);
    else if (values > JLT_CHART_VALUES_MAX)
        snprintf(what, sizeof what, "has %u parameters and levels, and %d are the limit", values, (int)JLT_CHART_VALUES_MAX);
    else snprintf(what, sizeof what, "has %u derivatives, of %u states by %u coordinates and levels, and %d are the limit",
                  table->state_count * (coordinates + section->level_count), table->state_count, coordinates + section->level_count,
                  (int)JLT_CHART_SLOPES_MAX);
    return jlt_command_fail(JLT_EXIT_INPUT,
                            "the section %s of %s %s of sections that tables describe: ask for one of the table itself, "
                            "%s, with all other states as coordinates (--level and --solve leave fewer)",
                            section->name, table->model, what, own_section(own, surface));
}

/* How far a value is from 1, on a logarithmic scale; 0 is not far. */
static double distance_from_one(double value) { return value == 0 ? 0 : fabs(log(fabs(value))); }

/* Refuse a value that breaks the sign of the table's parameter number `entry`. */
static jlt_exit refuse_sign(const jlt_descriptor *table, size_t entry, double value, const char *where)
{
    const jlt_quantity *q = &table->params[entry];

    if (jlt_descriptor_allows(q, value)) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_INPUT, "%s%s = %.10g: %s needs %s%s", where, q->name, value, table->model, q->name,
                            jlt_descriptor_condition(q));
}

jlt_exit jlt_motion_refuse(const jlt_surface *surface, const double *values, jlt_status status, const char *what)
{
    double arranged[JLT_CHART_VALUES_MAX] = { 0 };
    char where[256] = "";

    if (what != NULL) snprintf(where, sizeof where, "%s: ", what);
    if (status == JLT_ERR_EMPTY) return refuse_empty(surface, values, where);
    if (status == JLT_ERR_UNSUPPORTED) return refuse_large(surface);
    jlt_surface_arrange(arranged, surface, values);
    for (size_t i = 0, entry; status == JLT_ERR_DOMAIN && i < surface->params; i++)
        if (surface->entries[i] == JLT_SURFACE_COMPUTED && jlt_descriptor_param(surface->asked, surface->names[i], &entry))
            JLT_PASS(refuse_sign(surface->asked, entry, values[i], where));
    for (size_t k = 0; status == JLT_ERR_DOMAIN && k < surface->table->param_count; k++)
        JLT_PASS(refuse_sign(surface->table, k, arranged[k], where));
    if (status == JLT_ERR_ARG)
        return jlt_command_fail(JLT_EXIT_INPUT, "%sthe section %s covers the half of %s = %.10g that is crossed the other way; "
                                "crossings in this --direction lie on the other half", where, surface->section->name,
                                surface->table->states[surface->section->column].name, surface->section->level);
    if ((status == JLT_ERR_DOMAIN || status == JLT_ERR_NONFINITE) && surface->count > 0) {
        unsigned farthest = 0;
        for (unsigned i = 1; i < surface->count; i++)
            if (distance_from_one(values[i]) > distance_from_one(values[farthest])) farthest = i;
        return jlt_command_fail(jlt_command_exit(status), "%sproducts leave the range of doubles; %s = %.10g is the farthest from "
                                "1: rescale the units, or take another value", where, surface->names[farthest], values[farthest]);
    }
    return jlt_command_fail(jlt_command_exit(status), "%sthe section %s of %s: %s", where, surface->section->name,
                            surface->table->model, jlt_status_text(status));
}

jlt_exit jlt_motion_refuse_point(const jlt_surface *surface, const double *q, const char *text)
{
    for (unsigned k = 0; k < surface->section->coordinate_count; k++) {
        const jlt_quantity *c = &surface->section->coordinates[k];
        if (surface->section->is_angle[k] || c->period != 0 || (q[k] > c->low && q[k] < c->high)) continue;
        return jlt_assign_refuse_interval(text, c);
    }
    return JLT_EXIT_DONE;
}

/* If sections cannot follow a proved reduction of a table onto `to` (NULL: not known), print why. Returns whether that is so. */
static bool tell_unfollowed(const jlt_descriptor *table, const jlt_claim *claim, const jlt_descriptor *to)
{
    const bool is_bound = claim->condition[0] != '\0', is_known = to != NULL && !is_bound;
    const char *renamed = is_known ? jlt_link_renames(table, claim, to) : NULL;
    const char *wider = is_known ? jlt_link_widens(table, claim) : NULL;

    if (is_bound && jlt_way_of(table, claim) == NULL)
        jlt_command_fail(JLT_EXIT_INPUT, "the %s %s of %s holds only where %s, and no section is taken from its table", claim->kind,
                         claim->name, table->model, claim->condition);
    else if (renamed != NULL && !jlt_descriptor_param(table, renamed, &(size_t){ 0 })
             && jlt_descriptor_claim(table, "integral", renamed) == NULL)
        jlt_command_fail(JLT_EXIT_INPUT, "the %s %s gives %s of %s, which %s does not have: call it %s there too, or ask %s",
                         claim->kind, claim->name, renamed, to->model, table->model, renamed, to->model);
    else if (renamed != NULL)
        jlt_command_fail(JLT_EXIT_INPUT, "the %s %s sets %s of %s to something other than %s of %s: rename one of the two, or ask "
                         "%s", claim->kind, claim->name, renamed, to->model, renamed, table->model, to->model);
    else if (wider != NULL)
        jlt_command_fail(JLT_EXIT_INPUT,
                         "the %s %s of %s leads onto %s, where %s does not bound the motion: give it the same bound there, in "
                         "the states that the %s gives, or ask %s", claim->kind, claim->name, table->model, to->model, wider,
                         claim->kind, to->model);
    else return false;
    return true;
}

/* Refuse a section that rests on an unproved claim: its levels must be integrals, and its table stand for the asked one. */
static jlt_exit refuse_broken(const jlt_surface *surface, const jlt_claim *broken, const jlt_descriptor *asked)
{
    const jlt_descriptor *table = surface->table;
    const bool unfollowed = broken->verdict == JLT_PROVED && tell_unfollowed(asked, broken, table->family[0]);
    const bool is_there = strcmp(broken->kind, "section") == 0 && strcmp(table->sha256, asked->sha256) != 0;
    bool told = false;
    char own[OWN_SECTION];

    for (unsigned i = surface->params; !unfollowed && i < surface->count; i++) {
        const jlt_claim *claim = jlt_descriptor_claim(asked, "integral", surface->names[i]);
        if (claim == NULL || claim->verdict == JLT_PROVED) continue;
        jlt_command_fail(JLT_EXIT_INPUT, "%s is no integral of this table any more: %s", claim->name, claim->reason);
        told = true;
    }
    if (!unfollowed && !told)
        jlt_command_fail(JLT_EXIT_INPUT, "%s %s is not proved of %s: %s", broken->kind, broken->name,
                         is_there ? table->model : "this table", broken->reason);
    return jlt_command_fail(JLT_EXIT_INPUT, "there is no section %s, then: ask for one of the table itself, %s, with all "
                                            "other states as coordinates (--level and --solve leave fewer)",
                            surface->section->name, own_section(own, surface));
}

/* Print the claims of a table that would lead to a section but are not proved or not followed. Returns whether there are any. */
static bool tell_lost(const jlt_descriptor *table, const char *of, const jlt_way_tables *others)
{
    bool is_lost = false;

    for (const jlt_claim *claim = table->claims; claim->kind != NULL; claim++) {
        const bool leads = strcmp(claim->kind, "reduction") == 0 || strcmp(claim->kind, "section") == 0;
        if (claim->verdict == JLT_PROVED && claim->target != NULL && strcmp(claim->kind, "reduction") == 0)
            is_lost |= tell_unfollowed(table, claim, jlt_way_target(&(jlt_way){ .sha256 = claim->target }, others));
        if (!leads || claim->verdict == JLT_PROVED) continue;
        jlt_command_fail(JLT_EXIT_INPUT, "%s %s is not proved of %s: %s", claim->kind, claim->name, of, claim->reason);
        is_lost = true;
    }
    return is_lost;
}

/* Refuse if a section of this table, or of another one, would serve if some claim were proved; print these claims. */
static jlt_exit refuse_lost(const jlt_descriptor *asked, const jlt_way_tables *others)
{
    bool is_lost = tell_lost(asked, "this table", others);

    for (unsigned i = 0; i < others->count; i++) is_lost |= tell_lost(others->tables[i], others->tables[i]->model, others);
    if (!is_lost) return JLT_EXIT_DONE;
    for (const jlt_claim *claim = asked->claims; claim->kind != NULL; claim++)
        if (claim->verdict != JLT_PROVED && strcmp(claim->kind, "integral") == 0 && claim->condition[0] == '\0')
            jlt_command_fail(JLT_EXIT_INPUT, "%s is no integral of this table: %s", claim->name, claim->reason);
    return jlt_command_fail(JLT_EXIT_INPUT, "there is no section that a table describes, then: ask for one of the table itself, "
                                            "--section STATE=VALUE, with all other states as coordinates "
                                            "(--level and --solve leave fewer)");
}

enum { EMBEDDINGS_MAX = 4 };

/* A larger table that leads to a section, and into which this one is embedded by a chain of at most `depth` claims; NULL: none. */
static const jlt_descriptor *embedded_into(jlt_surface *surface, const jlt_descriptor *of, const jlt_way_tables *others,
                                           const char *name, unsigned depth)
{
    const jlt_descriptor *found = NULL;

    for (const jlt_claim *claim = of->claims; claim->kind != NULL && found == NULL && depth > 0; claim++) {
        const jlt_claim *broken;
        if (claim->target == NULL || strcmp(claim->kind, "embedding") != 0 || claim->verdict != JLT_PROVED) continue;
        const jlt_descriptor *larger = jlt_way_target(&(jlt_way){ .sha256 = claim->target }, others);
        if (larger == NULL) continue;
        if (jlt_surface_find(surface, &broken, larger, others, name) == JLT_OK && broken == NULL) found = larger;
        else found = embedded_into(surface, larger, others, name, depth - 1);
    }
    return found;
}

/* Refuse, and name a larger table with a section. It is not taken, since the embedding gives its parameters, and its orbits are not
 * only those of the table asked for. */
static jlt_exit refuse_larger(const jlt_descriptor *asked, const jlt_way_tables *others, const char *name)
{
    jlt_surface surface;
    const jlt_descriptor *larger = embedded_into(&surface, asked, others, name, EMBEDDINGS_MAX);

    if (larger == NULL) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_INPUT,
                            "%s describes no section, and leads to no smaller table that does; the larger one that it is embedded "
                            "into has the section %s: ask %s, with the parameters that the embedding says, or for one of this "
                            "table, --section STATE=VALUE, with all other states as coordinates (--level and --solve leave fewer)",
                            asked->model, surface.section->name, larger->model);
}

/* Refuse a section whose table has other conditions (`valid`) than the table asked for, if that has any: orbits are followed in the
 * section's table, which must tell where the model asked for ceases to hold. */
static jlt_exit refuse_unwatched(const jlt_surface *surface, const jlt_descriptor *asked)
{
    const jlt_descriptor *table = surface->table;
    char own[OWN_SECTION];
    unsigned k;

    for (unsigned i = 0; i < asked->valid_count; i++) {
        for (k = 0; k < table->valid_count && strcmp(table->valids[k].name, asked->valids[i].name) != 0; k++) { }
        if (k == table->valid_count)
            return jlt_command_fail(JLT_EXIT_INPUT,
                                    "the section %s is one of %s, which does not say where %s of this table is lost: write "
                                    "'valid %s : ...' in its coordinates there, or ask for a section of the table itself, %s",
                                    surface->section->name, table->model, asked->valids[i].name, asked->valids[i].name,
                                    own_section(own, surface));
    }
    for (k = 0; asked->valid_count > 0 && k < table->valid_count; k++) {
        unsigned i = 0;
        while (i < asked->valid_count && strcmp(table->valids[k].name, asked->valids[i].name) != 0) i++;
        if (i == asked->valid_count)
            return jlt_command_fail(JLT_EXIT_INPUT,
                                    "the section %s is one of %s, which has a condition %s that this table has not: write it here, "
                                    "remove it there, or ask for a section of the table itself, %s",
                                    surface->section->name, table->model, table->valids[k].name, own_section(own, surface));
    }
    return JLT_EXIT_DONE;
}

static jlt_exit read_values(double *values, const jlt_motion_options *options, const jlt_surface *surface)
{
    const jlt_assign_list *const lists[] = { &options->common.set, &options->level };
    char text[512];
    double ends[2];

    memcpy(values, surface->defaults, surface->count * sizeof *values);
    for (unsigned k = 0; k < 2; k++)
        for (size_t i = 0; i < lists[k]->count; i++) {
            const jlt_assignment *item = &lists[k]->items[i];
            const unsigned index = jlt_surface_value(surface, item->name);
            const unsigned kind = index >= surface->params; /* as in `lists` */
            if (index < surface->count && kind != k)
                return jlt_command_fail(JLT_EXIT_INPUT, "%s: %s is a %s: write --%s %s=VALUE", k == 0 ? "--set" : "--level",
                                        item->name, kind == 0 ? "parameter" : "level", kind == 0 ? "set" : "level", item->name);
            if (index == surface->count) {
                const bool swept = jlt_common_runs(&options->common, item->name);
                list_names(text, sizeof text, surface, k == 0 || swept ? 0 : surface->params,
                           k == 0 ? surface->params : surface->count, ", ");
                return jlt_command_fail(JLT_EXIT_INPUT, "%s: there is no %s '%s'; there are %s",
                                        k == 0 ? "--set" : swept ? "--sweep" : "--level",
                                        k == 0 ? "parameter" : swept ? "parameter or level" : "level", item->name,
                                        *text != '\0' ? text : "none");
            }
            values[index] = item->value;
        }
    for (unsigned i = 0; i < surface->count; i++) {
        if (isnan(values[i]) && jlt_assign_ends(ends, options->common.own_sweep, surface->names[i])) values[i] = ends[0];
        if (isnan(values[i]))
            return jlt_command_fail(JLT_EXIT_INPUT, "%s has no default: add --%s %s=VALUE", surface->names[i],
                                    i < surface->params ? "set" : "level", surface->names[i]);
    }
    return JLT_EXIT_DONE;
}

enum { ALONG = 3 }; /* points of a grid, from its lowest corner to its highest */

/* Choose the units of the problem from the points where orbits begin. Malformed starts are skipped, and reported later. */
static jlt_status count_from_starts(jlt_system *system, const jlt_motion_options *options)
{
    const jlt_chart *chart = system->flow.chart;
    size_t texts = 1, count = 0;
    jlt_units units;
    jlt_status st = JLT_OK;

    while (options->starts[texts - 1] != NULL) texts++;
    JLT_FREED double *points = jlt_memory_array(texts * ALONG, chart->dim * sizeof *points);
    if (points == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < texts; i++) {
        const char *text = options->starts[i] != NULL ? options->starts[i] : options->grid;
        double *const first = points + count * chart->dim, low, high;
        unsigned known = 0;
        char name[64];
        while (text != NULL && jlt_grid_ends(&text, name, sizeof name, &low, &high))
            for (unsigned k = 0; k < chart->dim; k++) {
                if (strcmp(name, chart->names[k]) != 0 || isnan(low)) continue;
                for (unsigned j = 0; j < ALONG; j++)
                    first[j * chart->dim + k] = isnan(high) ? low : low + (high - low) * j / (ALONG - 1);
                known++;
            }
        if (known == chart->dim) count += ALONG;
    }
    if (jlt_surface_units_at(&units, jlt_surface_chart(system), points, count)) st = jlt_surface_count_in(system, &units);
    return st;
}

jlt_exit jlt_motion_surface_system(jlt_system **system, const jlt_motion_options *options, const jlt_surface *surface)
{
    double values[JLT_CHART_VALUES_MAX];
    char text[512];

    if (options->mirror != NULL || options->solve != NULL || options->modulo != NULL) {
        list_names(text, sizeof text, surface, surface->params, surface->count, " and ");
        return jlt_command_fail(JLT_EXIT_USAGE,
                                "--%s goes with --section STATE=VALUE: the table says all there is to know of levels of %s",
                                options->mirror != NULL  ? "mirror"
                                : options->solve != NULL ? "solve"
                                                         : "modulo",
                                text);
    }
    JLT_PASS(read_values(values, options, surface));
    jlt_status st = jlt_surface_system(system, surface, values, &options->flow);
    if (st == JLT_OK) st = count_from_starts(*system, options);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_refuse(surface, values, st, NULL);
}

jlt_exit jlt_motion_surface(jlt_surface *surface, bool *has, const jlt_motion_options *options, const jlt_descriptor *asked)
{
    const bool is_plane = options->section != NULL && strchr(options->section, '=') != NULL;
    const jlt_common *common = &options->common;
    const jlt_claim *broken = NULL;
    jlt_way_tables others = { .count = 0 };

    *has = false;
    if (is_plane) return JLT_EXIT_DONE;
    if (common->model != NULL) /* smaller tables beside it may have one */
        JLT_PASS(jlt_table_others(&others, asked, common->model, "reduction", common->lanes));
    *has = jlt_surface_find(surface, &broken, asked, &others, options->section) == JLT_OK;
    if (*has) return broken != NULL ? refuse_broken(surface, broken, asked) : refuse_unwatched(surface, asked);
    if (surface->table != NULL) return refuse_large(surface);
    JLT_PASS(refuse_larger(asked, &others, options->section));
    if (options->section == NULL) return refuse_lost(asked, &others);
    return jlt_command_fail(JLT_EXIT_USAGE,
                            "--section: '%s' is no section (write STATE=VALUE); no table describes one of this name of %s",
                            options->section, asked->model);
}
