#include "scene/tier.h"

#include <stdio.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "top/rod.h"

typedef struct {
    jlt_tier *tiers;
    unsigned count;
} list;

static jlt_tier *add(list *l, const jlt_tier *like)
{
    if (l->count == JLT_TIERS_MAX) return NULL;
    l->tiers[l->count] = *like;
    return &l->tiers[l->count++];
}

/* The time in which a table's roots are states; NULL when it has none. */
static const char *lifting_time(const jlt_descriptor *table)
{
    for (const jlt_descriptor *const *d = table->family; *d != NULL; d++)
        if ((*d)->lifted != NULL && (*d)->variant[0] == '\0' && (*d)->elimination[0] == '\0') return (*d)->time;
    return NULL;
}

static const char *name_of(const jlt_tier *tier, const char *time)
{
    if (tier->table->tier != NULL) return tier->table->tier;
    return tier->way_count == 0 && time == NULL ? "model" : tier->table->model;
}

/* A table in the time in which its roots are states, and in t. */
static void add_forms(list *l, const jlt_tier *of)
{
    const jlt_descriptor *table = of->table;
    const char *time = lifting_time(table);
    jlt_tier *tier = add(l, of);

    if (tier == NULL) return;
    tier->time = time != NULL ? time : "";
    snprintf(tier->name, sizeof tier->name, "%s", name_of(of, time));
    snprintf(tier->meaning, sizeof tier->meaning, "%s",
             table->tier != NULL ? table->tier_meaning : of->way_count == 0 ? "the model's own field" : table->title);
    if (time == NULL || of->is_larger) return;
    tier = add(l, of);
    if (tier == NULL) return;
    tier->by_name = true;
    snprintf(tier->name, sizeof tier->name, "%s_plain", name_of(of, time));
    snprintf(tier->meaning, sizeof tier->meaning, "the same in t%s", table->pole_count > 0 ? ": steps collapse at the poles" : "");
}

static void add_eliminations(list *l, const jlt_tier *of)
{
    for (const jlt_descriptor *const *d = of->asked->family; *d != NULL; d++) {
        if ((*d)->elimination[0] == '\0' || (*d)->time[0] != '\0' || (*d)->variant[0] != '\0') continue;
        jlt_tier *tier = add(l, of);
        if (tier == NULL) return;
        tier->by_name = true;
        tier->elimination = (*d)->elimination;
        tier->dimension = (*d)->state_count;
        snprintf(tier->name, sizeof tier->name, "%s", (*d)->elimination);
        snprintf(tier->meaning, sizeof tier->meaning, "a level of %s with %s eliminated: loses digits where %s hardly depends on it",
                 of->asked->integrals[(*d)->level_integral].name, of->asked->states[(*d)->eliminated_state].name,
                 of->asked->integrals[(*d)->level_integral].name);
    }
}

static bool is_reached(const jlt_tier *reached, unsigned count, const jlt_descriptor *table)
{
    for (unsigned i = 0; i < count; i++)
        if (strcmp(reached[i].table->sha256, table->sha256) == 0) return true;
    return false;
}

/* Where one more way leads from a table that was reached; false: nowhere, or nowhere new. */
static bool go_on(jlt_tier *out, const jlt_tier *at, const jlt_way *way, const jlt_tier *reached, unsigned count,
                  const jlt_way_tables *others)
{
    const jlt_descriptor *target = jlt_way_target(way, others);
    const bool is_lift = strcmp(way->kind, "lift") == 0;

    if (target == NULL || at->way_count == JLT_TIER_WAYS_MAX || is_reached(reached, count, target)) return false;
    if (at->is_larger || (is_lift && at->way_count > 0)) return false;
    *out = *at;
    out->table = target;
    out->dimension = target->state_count;
    out->is_larger = is_lift;
    out->from[at->way_count] = at->table;
    out->ways[out->way_count++] = way;
    return true;
}

unsigned jlt_tier_list(jlt_tier *tiers, const jlt_descriptor *asked, const jlt_way_tables *others)
{
    jlt_tier reached[JLT_TIERS_MAX];
    list l = { .tiers = tiers };
    unsigned count = 1;

    reached[0] = (jlt_tier){ .asked = asked, .table = asked, .dimension = asked->state_count, .time = "", .elimination = "" };
    for (unsigned i = 0; i < count; i++)
        for (unsigned k = 0; k < reached[i].table->way_count && count < JLT_TIERS_MAX; k++)
            count += go_on(&reached[count], &reached[i], &reached[i].table->ways[k], reached, count, others);
    if (jlt_rod_is_known(asked)) {
        jlt_tier *tier = add(&l, &(jlt_tier){ .name = "quadrature", .asked = asked, .time = "", .elimination = "" });
        snprintf(tier->meaning, sizeof tier->meaning, "%s", jlt_rod_meaning);
    }
    for (unsigned i = 0; i < count; i++) add_forms(&l, &reached[i]);
    add_eliminations(&l, &reached[0]);
    for (unsigned i = 1; i < l.count; i++) { /* few: by insertion, which keeps the order of equals */
        const jlt_tier moved = tiers[i];
        unsigned k = i;
        for (; k > 0 && tiers[k - 1].dimension > moved.dimension; k--) tiers[k] = tiers[k - 1];
        tiers[k] = moved;
    }
    return l.count;
}

bool jlt_tier_find(jlt_tier *out, const jlt_descriptor *asked, const jlt_way_tables *others, const char *name)
{
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned count = jlt_tier_list(tiers, asked, others);
    const bool own = strcmp(name, "model") == 0;

    for (unsigned i = 0; i < count; i++)
        if (own ? tiers[i].table == asked && *tiers[i].time == '\0' && *tiers[i].elimination == '\0' : strcmp(tiers[i].name, name) == 0) {
            *out = tiers[i];
            if (own) snprintf(out->name, sizeof out->name, "%s", name);
            return true;
        }
    return false;
}

void jlt_tier_whole(jlt_tier *out, const jlt_descriptor *asked)
{
    jlt_tier tiers[JLT_TIERS_MAX];
    unsigned i = 0;

    jlt_tier_list(tiers, asked, NULL);
    while (tiers[i].table != asked || tiers[i].by_name) i++;
    *out = tiers[i];
}
