#include "kernel/way.h"

#include <math.h>
#include <string.h>

#include "core/guard.h"
#include "kernel/descriptor.h"

const jlt_way *jlt_way_of(const jlt_descriptor *from, const jlt_claim *claim)
{
    for (unsigned i = 0; i < from->way_count; i++)
        if (&from->claims[from->ways[i].claim] == claim) return &from->ways[i];
    return NULL;
}

const jlt_descriptor *jlt_way_among(const jlt_way_tables *others, const char *sha256)
{
    for (unsigned i = 0; others != NULL && i < others->count; i++)
        if (strcmp(others->tables[i]->sha256, sha256) == 0) return others->tables[i];
    return NULL;
}

const jlt_descriptor *jlt_way_target(const jlt_way *way, const jlt_way_tables *others)
{
    const jlt_descriptor *loaded = jlt_way_among(others, way->sha256);

    if (loaded != NULL) return loaded;
    for (size_t i = 0; i < jlt_descriptor_count(); i++) {
        const jlt_descriptor *d = jlt_descriptor_at(i);
        if (d == d->family[0] && strcmp(d->sha256, way->sha256) == 0) return d;
    }
    return NULL;
}

/* Whether the larger table claims reductions onto `from`, and all of them are proved. Out: *broken, the first unproved one; NULL
 * if there are no reductions. */
static bool reduces(const jlt_claim **broken, const jlt_descriptor *larger, const jlt_descriptor *from)
{
    bool found = false;

    *broken = NULL;
    for (const jlt_claim *claim = larger->claims; claim->kind != NULL; claim++) {
        if (strcmp(claim->kind, "reduction") != 0 || claim->target == NULL || strcmp(claim->target, from->sha256) != 0) continue;
        found = true;
        *broken = claim;
        if (claim->verdict != JLT_PROVED) return false;
    }
    return found;
}

bool jlt_way_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_way *way, const jlt_descriptor *target)
{
    *broken = &from->claims[way->claim];
    if ((*broken)->verdict != JLT_PROVED) return false;
    return strcmp(way->kind, "lift") != 0 || reduces(broken, target, from);
}

static const double anywhere[JLT_WAY_VALUES_MAX];

const jlt_way_condition *jlt_way_broken(const jlt_way *way, const double *x, const double *params)
{
    double values[JLT_WAY_VALUES_MAX];

    if (way->condition_values == NULL) return NULL;
    if (way->condition_count > JLT_WAY_VALUES_MAX) return way->conditions;
    way->condition_values(x != NULL ? x : anywhere, params, values);
    for (unsigned i = 0; i < way->condition_count; i++) {
        const jlt_way_condition *condition = &way->conditions[i];
        if (condition->is_zero ? values[i] != 0 : x != NULL && !(values[i] > 0)) return condition;
    }
    return NULL;
}

const jlt_way *jlt_way_to(const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *table, const double *x,
                          const double *params)
{
    const jlt_claim *lacking;

    *broken = NULL;
    for (unsigned i = 0; i < from->way_count; i++) {
        const jlt_way *way = &from->ways[i];
        if (strcmp(way->sha256, table->sha256) != 0 || strcmp(way->time, table->time) != 0) continue;
        if (jlt_way_broken(way, x, params) != NULL) continue;
        if (jlt_way_holds(&lacking, from, way, table)) {
            *broken = NULL;
            return way;
        }
        if (*broken == NULL) *broken = lacking;
    }
    return NULL;
}

jlt_status jlt_way_follow(const jlt_way *way, double *y, double *other, const double *x, const double *params)
{
    double pairs[2 * JLT_WAY_VALUES_MAX];

    if (way->state_count > JLT_WAY_VALUES_MAX || way->param_count > JLT_WAY_VALUES_MAX) return JLT_ERR_UNSUPPORTED;
    way->coordinates(x, params, pairs);
    for (unsigned i = 0; i < way->coordinate_count; i++) {
        const double *pair = pairs + 2 * i;
        if (way->is_angle[i] && pair[0] == 0 && pair[1] == 0) return JLT_ERR_DOMAIN;
        y[i] = way->is_angle[i] ? atan2(pair[0], pair[1]) : pair[0];
        if (!isfinite(y[i])) return JLT_ERR_NONFINITE;
    }
    jlt_way_params(way, other, x, params);
    if (!jlt_guard_finite(other, way->param_count)) return JLT_ERR_NONFINITE;
    return JLT_OK;
}

void jlt_way_params(const jlt_way *way, double *other, const double *x, const double *params)
{
    way->params(x != NULL ? x : anywhere, params, other);
    for (unsigned i = 0; i < way->param_count; i++)
        if (way->is_root[i]) other[i] = sqrt(other[i]);
}
