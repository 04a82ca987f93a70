#include "cli/planned.h"

#include <stdlib.h>
#include <string.h>

#include "cli/motion_many.h"
#include "cli/table.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "scene/course_more.h"

static void kernel_name(char *out, size_t size, const jlt_descriptor *d)
{
    if (d == NULL) snprintf(out, size, "-");
    else
        snprintf(out, size, "%s%s%s%s%s%s%s", d->model, d->variant[0] != '\0' ? " " : "", d->variant,
                 d->time[0] != '\0' ? " in " : "", d->time, d->elimination[0] != '\0' ? " on " : "", d->elimination);
}

static void show_candidate(const jlt_plan *plan, unsigned index, const char *why)
{
    const jlt_candidate *c = &plan->candidates[index];
    char kernel[128], counts[64] = "", refusal[1024];
    const bool taken = index == plan->chosen && c->refusal[0] == '\0';

    kernel_name(kernel, sizeof kernel, c->descriptor);
    if (c->descriptor != NULL) {
        const jlt_operation_count *n = &c->descriptor->rhs.optimized;
        snprintf(counts, sizeof counts, "%u+ %ux %ufma %u/ %uroot %uelem", n->add, n->multiply, n->fma, n->divide, n->root,
                 n->elementary);
    }
    printf("  %c %-14s %3u  %-52s %-36s ", taken ? '*' : ' ', c->tier.name, c->tier.dimension, kernel, counts);
    if (taken)
        printf("taken: %s\n", why != NULL        ? why
                              : plan->forced     ? "asked for by name"
                              : plan->count == 1 ? "the model's own field"
                                                 : "the smallest that answers");
    else if (c->refusal[0] != '\0') {
        jlt_plan_refusal(refusal, sizeof refusal, c);
        printf("no: %s\n", refusal);
    }
    else if (c->tier.by_name) puts("would answer: a comparison, by name only");
    else puts(index > plan->chosen ? "would answer, but is no smaller" : "would answer, and is smaller");
}

void jlt_planned_show(const jlt_plan *plan, const char *why)
{
    for (unsigned k = 0; k < plan->count; k++) show_candidate(plan, k, why);
}

void jlt_planned_chosen(const jlt_plan *plan) { show_candidate(plan, plan->chosen, NULL); }

/* Print whether the level is an integral of the table asked for, and proved, or a parameter. */
static void show_proof(const jlt_descriptor *asked, const char *level)
{
    static const char *const words[] = { [JLT_PROVED] = "proved", [JLT_REFUTED] = "refuted", [JLT_UNSETTLED] = "not settled" };
    const jlt_claim *claim = jlt_descriptor_claim(asked, "integral", level);

    if (claim != NULL) printf(" (an integral, %s)", words[claim->verdict]);
    else if (jlt_descriptor_param(asked, level, &(size_t){ 0 })) fputs(" (a parameter of this table)", stdout);
}

enum { LOOKED_AT = 1 << 20 }; /* the most points of a grid to lift */

/* Print where orbits begin, and how many points of a grid are on the section. */
static jlt_exit show_starts(const jlt_system *system, const jlt_motion_options *options)
{
    const size_t starts = options->start_count;
    const char *other = starts == 0 && system->surface != NULL ? options->other : NULL;
    const char *grid = options->grid != NULL ? options->grid : other;
    const jlt_chart *chart = system->flow.chart;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    size_t points = 0, there = 0;
    jlt_exit code = jlt_motion_check_starts(system, options->starts, starts);

    if (code == JLT_EXIT_DONE && grid != NULL) code = jlt_motion_axes(axes, system, grid, "--grid");
    if (code != JLT_EXIT_DONE || (starts == 0 && grid == NULL)) return code;
    if (grid != NULL) points = jlt_motion_grid_size(axes, system);
    for (size_t i = 0; i < points && points <= LOOKED_AT; i++) {
        double q[JLT_CHART_DIM_MAX], x[JLT_CHART_STATES_MAX];
        jlt_motion_grid_point(q, axes, system, i);
        there += chart->lift(chart, x, NULL, q) == JLT_OK;
    }
    fputs("  starts", stdout);
    if (starts > 0) printf(" %zu of --start%s", starts, grid != NULL ? "," : "");
    if (grid != NULL) printf(" %zu of a grid", points);
    if (grid != NULL && points <= LOOKED_AT) printf(", of which %zu are on the section", there);
    puts("");
    return JLT_EXIT_DONE;
}

/* Whether every step to the section's table is one to a tier: a reduction `onto` a table, which tells no way there, is none. */
static bool leads_by_tiers(const jlt_link *link)
{
    for (unsigned i = 0; i < link->count; i++)
        if (link->steps[i].way == NULL) return false;
    return true;
}

jlt_exit jlt_planned_motion(const jlt_system *system, const jlt_motion_options *options)
{
    static const char *const directions[] = { "downwards", "in both directions", "upwards" };
    const jlt_descriptor *asked = options->asked;
    const jlt_chart *chart = system->flow.chart;
    const char *names[JLT_INVARIANTS_MAX];
    double levels[JLT_INVARIANTS_MAX], *params = NULL;
    const unsigned count = jlt_motion_levels(system, names, levels);
    jlt_way_tables others = { .count = 0 };
    jlt_exit code = jlt_assign_params(&params, asked, &options->common.set, options->common.own_sweep);

    if (code == JLT_EXIT_DONE && options->common.model != NULL)
        code = jlt_table_others(&others, asked, options->common.model, "reduction", options->common.lanes);
    if (code == JLT_EXIT_DONE) {
        jlt_plan plan = { .count = 1,
                          .candidates = { { .tier = { .name = "model", .dimension = system->instance->descriptor->state_count },
                                            .descriptor = system->instance->descriptor } } };
        jlt_tier whole;
        jlt_tier_whole(&whole, asked); /* drifts of integrals are measured in the whole model */
        const jlt_question question = { .model = asked,
                                        .others = &others,
                                        .params = params,
                                        .section = !options->looks_at_integrals,
                                        .tier = options->looks_at_integrals ? whole.name : NULL };
        const bool in_tiers = system->surface != NULL && leads_by_tiers(&system->surface->link);
        const jlt_status st = in_tiers ? jlt_plan_make(&plan, &question) : JLT_OK;
        if (st == JLT_OK)
            jlt_planned_show(&plan, system->surface != NULL && !in_tiers                ? "its table describes the section"
                                    : options->looks_at_integrals && plan.count > 1 ? "integrals are watched in all states"
                                                                                    : NULL);
        code = st == JLT_OK                ? JLT_EXIT_PLANNED
               : st == JLT_ERR_UNSUPPORTED ? jlt_planned_refuse(&plan, &question, st, true)
                                           : jlt_motion_fail(st, system, asked->model);
    }
    free(params);
    if (code != JLT_EXIT_PLANNED) return code;
    printf("  section %s=", system->instance->descriptor->states[chart->column].name);
    jlt_csv_value(stdout, ldexp(chart->level, system->flow.units.state[chart->column]));
    printf(" crossed %s", directions[options->flow.direction + 1]);
    for (unsigned k = 0; k < count; k++) {
        printf("%s %s=", k == 0 ? ", on levels" : ",", names[k]);
        jlt_csv_value(stdout, levels[k]);
        show_proof(asked, names[k]);
    }
    puts("");
    const jlt_exit refused = show_starts(system, options);
    if (refused != JLT_EXIT_DONE) return refused;
    printf("  method %s, tolerance %.3g%s\n", jlt_motion_method(options), options->flow.tolerance,
           options->in_lanes ? "" : ", one orbit at a time");
    jlt_motion_many_line(stdout, " ", options, system);
    return code;
}

/* The first claim, from `from` on, by which another table would serve but which is not proved; NULL: none. */
static const jlt_claim *broken_claim(const jlt_claim *from)
{
    for (const jlt_claim *c = from; c->kind != NULL; c++)
        if (c->verdict != JLT_PROVED && (strcmp(c->kind, "reduction") == 0 || strcmp(c->kind, "lift") == 0)) return c;
    return NULL;
}

/* The unproved claim because of which the planner does not look for a table of this name, or for the target of the record of this
 * name; NULL: none. */
static const jlt_claim *broken_way(const jlt_descriptor *asked, const char *name)
{
    for (unsigned i = 0; i < asked->way_count; i++) {
        const jlt_way *way = &asked->ways[i];
        if (strcmp(way->name, name) != 0 && strcmp(way->model, name) != 0) continue;
        if (asked->claims[way->claim].verdict != JLT_PROVED) return &asked->claims[way->claim];
    }
    for (const jlt_claim *c = broken_claim(asked->claims); c != NULL; c = broken_claim(c + 1))
        if (strcmp(c->name, name) == 0) return c;
    return NULL;
}

static jlt_exit refuse_name(const jlt_question *question)
{
    const jlt_descriptor *tables[JLT_WAY_TABLES_MAX + 1] = { question->model };
    const char *const tier = question->tier;
    const jlt_claim *broken = NULL;
    unsigned count = 1, i;

    for (; question->others != NULL && count <= question->others->count; count++)
        tables[count] = question->others->tables[count - 1];
    for (i = 0; broken == NULL && i < count; i++) broken = broken_way(tables[i], tier);
    if (broken != NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "the tier %s cannot answer: the %s %s is not proved of %s: %s", tier, broken->kind,
                                broken->name, i == 1 ? "this table" : tables[i - 1]->model, broken->reason);
    for (i = 0; broken == NULL && i < count; i++) broken = broken_claim(tables[i]->claims);
    if (broken == NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "there is no tier '%s' of %s; jellett plan lists them", tier, tables[0]->model);
    return jlt_command_fail(JLT_EXIT_INPUT,
                            "there is no tier '%s' of %s; jellett plan lists them; a table that has one may not serve: the %s %s "
                            "is not proved of %s: %s",
                            tier, tables[0]->model, broken->kind, broken->name, i == 1 ? "this table" : tables[i - 1]->model,
                            broken->reason);
}

/* Refuse with the reason of the last of the table's own tiers, which is meant to answer when the others cannot. */
static jlt_exit refuse_all(const jlt_plan *plan, const jlt_descriptor *asked)
{
    const jlt_candidate *own = NULL;
    char refusal[1024];

    for (unsigned i = 0; i < plan->count; i++) {
        const jlt_candidate *c = &plan->candidates[i];
        if (c->tier.way_count == 0 && !c->tier.by_name && c->refusal[0] != '\0') own = c;
    }
    if (own == NULL) return jlt_command_fail(JLT_EXIT_INPUT, "no tier of %s can answer", asked->model);
    jlt_plan_refusal(refusal, sizeof refusal, own);
    return jlt_command_fail(JLT_EXIT_INPUT,
                            "no tier of %s can answer; its own, %s: %s: rescale the units, or change --set or --start",
                            asked->model, own->tier.name, refusal);
}

/* Refuse --track. If a larger table that observes more is proved only of another table, such as a copy or an earlier text of this
 * one, name it. */
static jlt_exit refuse_more(const jlt_plan *plan, const jlt_descriptor *asked)
{
    for (unsigned i = 0; i < plan->count; i++) {
        const jlt_candidate *c = &plan->candidates[i];
        const bool is_lift = c->tier.way_count == 1 && strcmp(c->tier.ways[0]->kind, "lift") == 0;
        if (!is_lift || c->refusal[0] == '\0' || c->broken != NULL || c->may_serve_elsewhere) continue;
        if (!jlt_course_more_is_told(c->tier.table, asked)) continue;
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "--track: %s observes more than this table: %s; a record 'reduction NAME : onto FILE with ...' "
                                "there, FILE the file of this table, says that it serves for %s",
                                c->tier.table->model, c->refusal, asked->model);
    }
    return jlt_command_fail(
        JLT_EXIT_INPUT, "--track: no table that observes more than this one serves for %s (jellett plan simulate ... says why)",
        asked->model);
}

jlt_exit jlt_planned_refuse(const jlt_plan *plan, const jlt_question *question, jlt_status status, bool show)
{
    const jlt_descriptor *asked = question->model;
    char refusal[1024];

    if (status == JLT_ERR_ARG) return refuse_name(question);
    if (show) jlt_planned_show(plan, NULL);
    if (question->tier == NULL && question->more) return refuse_more(plan, asked);
    if (question->tier == NULL) return refuse_all(plan, asked);
    jlt_plan_refusal(refusal, sizeof refusal, &plan->candidates[plan->chosen]);
    return jlt_command_fail(JLT_EXIT_INPUT, "the tier %s cannot answer: %s: leave this tier out%s", question->tier, refusal,
                            plan->candidates[plan->chosen].may_serve_elsewhere ? ", or change --set or --start" : "");
}
