#include "kernel/link.h"

#include <string.h>

#include "kernel/descriptor.h"

enum { TABLES_MAX = 64 };

static bool has_source(const jlt_way *way, jlt_source source)
{
    for (unsigned i = 0; i < way->param_count; i++)
        if (way->sources[i] == source) return true;
    return false;
}

const char *jlt_link_renames(const jlt_descriptor *from, const jlt_claim *claim, const jlt_descriptor *to)
{
    const jlt_way *way = jlt_way_of(from, claim);

    for (unsigned i = 0; way != NULL && i < way->param_count; i++)
        if (way->sources[i] == JLT_SOURCE_OTHER_LEVEL) return to->params[i].name;
    return claim->renames;
}

const char *jlt_link_widens(const jlt_descriptor *from, const jlt_claim *claim)
{
    return jlt_way_of(from, claim) != NULL ? NULL : claim->widens;
}

/* The reduction of one table onto the other: the first that is proved and can be followed (*serves is then true), else the
 * first of all, or NULL. Reductions under a condition on parameters are ignored, since they do not hold in general. */
static const jlt_claim *leads(bool *serves, const jlt_descriptor *from, const jlt_descriptor *to)
{
    const jlt_claim *first = NULL;

    *serves = false;
    for (const jlt_claim *claim = from->claims; claim->kind != NULL && !*serves; claim++) {
        if (claim->target == NULL || strcmp(claim->target, to->sha256) != 0 || strcmp(claim->kind, "reduction") != 0
            || claim->condition[0] != '\0')
            continue;
        *serves = claim->verdict == JLT_PROVED && jlt_link_renames(from, claim, to) == NULL
                  && jlt_link_widens(from, claim) == NULL;
        if (*serves || first == NULL) first = claim;
    }
    return first;
}

/* List the general fields of `first`, then of `others`, then of those built-in tables that are not among these. */
static size_t list_tables(const jlt_descriptor *tables[TABLES_MAX], const jlt_descriptor *first, const jlt_way_tables *others)
{
    size_t count = 0;

    tables[count++] = first;
    for (unsigned i = 0; others != NULL && i < others->count; i++) tables[count++] = others->tables[i];
    for (size_t i = 0; i < jlt_descriptor_count() && count < TABLES_MAX; i++) {
        const jlt_descriptor *d = jlt_descriptor_at(i);
        if (d == d->family[0] && strcmp(d->sha256, first->sha256) != 0 && jlt_way_among(others, d->sha256) == NULL)
            tables[count++] = d;
    }
    return count;
}

/* Whether some parameter of step->to is the level of an integral of step->from. */
static bool has_levels(const jlt_link_step *step)
{
    size_t index;

    if (step->way != NULL) return has_source(step->way, JLT_SOURCE_LEVEL);
    for (unsigned i = 0; i < step->to->param_count; i++)
        if (!jlt_descriptor_param(step->from, step->to->params[i].name, &index)) return true;
    return false;
}

/* Extend `link` by the step from one table to the other, into *out. Returns false if that is impossible: also when the step
 * computes parameters while an earlier step takes some from levels, since the values of levels are not known here. */
static bool append(jlt_link *out, const jlt_link *link, const jlt_descriptor *from, const jlt_descriptor *to)
{
    bool serves, levels = false;
    const jlt_claim *claim = leads(&serves, from, to);

    if (!serves || link->count == JLT_LINK_STEPS_MAX || to->param_count > JLT_WAY_VALUES_MAX) return false;
    const jlt_way *way = jlt_way_of(from, claim);
    for (unsigned i = 0; i < link->count; i++) levels |= has_levels(&link->steps[i]);
    if (levels && way != NULL && has_source(way, JLT_SOURCE_PARAMS)) return false;
    *out = *link;
    out->steps[out->count++] = (jlt_link_step){ from, to, claim, way };
    return true;
}

bool jlt_link_find(jlt_link *link, const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *to,
                   const jlt_way_tables *others)
{
    const jlt_descriptor *tables[TABLES_MAX];
    jlt_link links[TABLES_MAX];
    bool serves, reached[TABLES_MAX] = { true };
    const size_t count = list_tables(tables, from->family[0], others);

    *broken = NULL;
    link->count = 0;
    links[0].count = 0;
    for (unsigned length = 0; length <= JLT_LINK_STEPS_MAX; length++)
        for (size_t i = 0; i < count; i++) {
            if (!reached[i] || links[i].count != length) continue;
            if (strcmp(tables[i]->sha256, to->sha256) == 0) {
                *link = links[i];
                return true;
            }
            for (size_t k = 1; k < count; k++) reached[k] = reached[k] || append(&links[k], &links[i], tables[i], tables[k]);
        }
    *broken = leads(&serves, from, to);
    return false;
}

jlt_source jlt_link_source(const jlt_link *link, const char *name)
{
    jlt_source source = JLT_SOURCE_OWN;
    size_t here, there;

    for (unsigned i = link->count; i-- > 0 && source == JLT_SOURCE_OWN;) {
        const jlt_link_step *step = &link->steps[i];
        const bool has = jlt_descriptor_param(step->from, name, &here);
        if (!jlt_descriptor_param(step->to, name, &there)) return JLT_SOURCE_LEVEL;
        source = step->way != NULL ? (jlt_source)step->way->sources[there] : has ? JLT_SOURCE_OWN : JLT_SOURCE_LEVEL;
    }
    return source;
}

bool jlt_link_computes(const jlt_link *link)
{
    for (unsigned i = 0; i < link->count; i++)
        if (link->steps[i].way != NULL && has_source(link->steps[i].way, JLT_SOURCE_PARAMS)) return true;
    return false;
}

/* The parameters of one step without a way: each from the parameter of the same name, else its default. */
static void take_names(const jlt_link_step *step, double *out, const double *params)
{
    size_t index;

    for (unsigned i = 0; i < step->to->param_count; i++)
        out[i] = jlt_descriptor_param(step->from, step->to->params[i].name, &index) ? params[index] : step->to->params[i].value;
}

void jlt_link_params(const jlt_link *link, double *out, const double *params)
{
    double now[JLT_WAY_VALUES_MAX], next[JLT_WAY_VALUES_MAX];
    const jlt_descriptor *last = NULL;

    if (link->count > 0) memcpy(now, params, link->steps[0].from->param_count * sizeof *now);
    for (unsigned i = 0; i < link->count; i++) {
        const jlt_link_step *step = &link->steps[i];
        if (step->way != NULL) jlt_way_params(step->way, next, NULL, now);
        else take_names(step, next, now);
        last = step->to;
        memcpy(now, next, last->param_count * sizeof *now);
    }
    if (last != NULL) memcpy(out, now, last->param_count * sizeof *out);
}
