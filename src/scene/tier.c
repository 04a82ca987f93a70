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

/* The proved time in which exactly one root of the table is a state, so that integrators can see it vanish; NULL: there is none. */
static const char *lifting_time(const jlt_descriptor *table)
{
    for (const jlt_descriptor *const *d = table->family; *d != NULL; d++)
        if ((*d)->lifted_count == 1 && (*d)->variant[0] == '\0' && (*d)->elimination[0] == '\0'
            && jlt_descriptor_doubted_field(*d) == NULL)
            return (*d)->time;
    return NULL;
}

static const char *name_of(const jlt_tier *tier, const char *time)
{
    if (tier->table->tier != NULL) return tier->table->tier;
    return tier->way_count == 0 && time == NULL ? "model" : tier->table->model;
}

static void name_tier(jlt_tier *tier, const jlt_tier *of, const char *time, const char *suffix)
{
    const char *name = name_of(of, time);

    if (suffix == NULL) snprintf(tier->name, sizeof tier->name, "%s", name);
    else snprintf(tier->name, sizeof tier->name, "%s_%s", name, suffix);
}

/* Add the tiers of a table: in the time in which its root is a state, and in t; one of them by name only. With poles, where the
 * root vanishes, the planner takes the first, in which the root keeps its digits there; else it takes t, since a root that is a
 * state drifts from the square root of its radicand by rounding errors, which are relatively large where it is small. */
static void add_forms(list *l, const jlt_tier *of)
{
    const jlt_descriptor *table = of->table;
    const char *time = lifting_time(table);
    const bool lifts = time != NULL && jlt_descriptor_has_poles(table);
    jlt_tier *tier = add(l, of);

    if (tier == NULL) return;
    tier->time = lifts ? time : "";
    name_tier(tier, of, time, NULL);
    snprintf(tier->meaning, sizeof tier->meaning, "%s",
             table->tier != NULL ? table->tier_meaning : of->way_count == 0 ? "the model's own field" : table->title);
    if (time == NULL || of->is_larger) return;
    tier = add(l, of);
    if (tier == NULL) return;
    tier->by_name = true;
    tier->time = lifts ? "" : time;
    name_tier(tier, of, time, lifts ? "plain" : time);
    snprintf(tier->meaning, sizeof tier->meaning, "%s",
             lifts ? "the same in t: steps collapse at the poles"
                   : "the same in another time: loses digits where its root is small");
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
        snprintf(tier->meaning, sizeof tier->meaning,
                 "a level of %s with %s eliminated: loses digits where %s hardly depends on it",
                 of->asked->integrals[(*d)->level_integral].name, of->asked->states[(*d)->eliminated_state].name,
                 of->asked->integrals[(*d)->level_integral].name);
    }
}

static bool is_same(const jlt_descriptor *a, const jlt_descriptor *b)
{
    return strcmp(a->sha256, b->sha256) == 0;
}

/* Whether the ways of `at` pass through this table, or end at it. */
static bool has_passed(const jlt_tier *at, const jlt_descriptor *table)
{
    for (unsigned i = 0; i < at->way_count; i++)
        if (is_same(at->from[i], table)) return true;
    return is_same(at->table, table);
}

/* Extend `at` by one more way. Returns false if the way's target is not known or was passed already, or the way may not follow: a
 * lift must come first and alone. */
static bool go_on(jlt_tier *out, const jlt_tier *at, const jlt_way *way, const jlt_way_tables *others)
{
    const jlt_descriptor *target = jlt_way_target(way, others);
    const bool is_lift = strcmp(way->kind, "lift") == 0;

    if (target == NULL || at->way_count == JLT_TIER_WAYS_MAX || has_passed(at, target)) return false;
    if (at->is_larger || (is_lift && at->way_count > 0)) return false;
    *out = *at;
    out->table = target;
    out->dimension = target->state_count;
    out->is_larger = is_lift;
    out->from[at->way_count] = at->table;
    out->ways[out->way_count++] = way;
    return true;
}

enum { REACHED_MAX = 4 * JLT_TIERS_MAX };

/* Find all tables that ways reach from the asked one, once for each sequence of ways, the shortest first. Returns their number. */
static unsigned reach(jlt_tier reached[REACHED_MAX], const jlt_descriptor *asked, const jlt_way_tables *others)
{
    unsigned count = 1;

    reached[0] = (jlt_tier){ .asked = asked, .table = asked, .dimension = asked->state_count, .time = "", .elimination = "" };
    for (unsigned i = 0; i < count; i++)
        for (unsigned k = 0; k < reached[i].table->way_count && count < REACHED_MAX; k++)
            count += go_on(&reached[count], &reached[i], &reached[i].table->ways[k], others);
    return count;
}

static bool is_first(const jlt_tier *reached, unsigned index)
{
    for (unsigned i = 0; i < index; i++)
        if (is_same(reached[i].table, reached[index].table)) return false;
    return true;
}

/* Rename tiers of the same name to MODEL.NAME, and if that is not enough to MODEL.NAME~K. */
static void tell_apart(list *l)
{
    char names[JLT_TIERS_MAX][JLT_TIER_NAME_MAX];

    for (unsigned i = 0; i < l->count; i++) snprintf(names[i], sizeof names[i], "%s", l->tiers[i].name);
    for (unsigned i = 0; i < l->count; i++) {
        unsigned alike = 0, before = 0;
        for (unsigned k = 0; k < l->count; k++) {
            if (k == i || strcmp(names[k], names[i]) != 0) continue;
            alike++;
            before += k < i && l->tiers[k].table != NULL && l->tiers[i].table != NULL
                      && strcmp(l->tiers[k].table->model, l->tiers[i].table->model) == 0;
        }
        if (alike == 0 || l->tiers[i].table == NULL) continue;
        if (before == 0) snprintf(l->tiers[i].name, JLT_TIER_NAME_MAX, "%.63s.%.72s", l->tiers[i].table->model, names[i]);
        else snprintf(l->tiers[i].name, JLT_TIER_NAME_MAX, "%.63s.%.72s~%u", l->tiers[i].table->model, names[i], before + 1);
    }
}

unsigned jlt_tier_list(jlt_tier *tiers, const jlt_descriptor *asked, const jlt_way_tables *others)
{
    jlt_tier reached[REACHED_MAX];
    list l = { .tiers = tiers };
    const unsigned count = reach(reached, asked, others);

    if (jlt_rod_is_known(asked)) {
        jlt_tier *tier = add(&l, &(jlt_tier){ .name = "quadrature", .asked = asked, .time = "", .elimination = "" });
        snprintf(tier->meaning, sizeof tier->meaning, "%s", jlt_rod_meaning);
    }
    for (unsigned i = 0; i < count; i++)
        if (is_first(reached, i)) add_forms(&l, &reached[i]);
    add_eliminations(&l, &reached[0]);
    tell_apart(&l);
    for (unsigned i = 1; i < l.count; i++) { /* a stable insertion sort by dimension: there are few */
        const jlt_tier moved = tiers[i];
        unsigned k = i;
        for (; k > 0 && tiers[k - 1].dimension > moved.dimension; k--) tiers[k] = tiers[k - 1];
        tiers[k] = moved;
    }
    return l.count;
}

bool jlt_tier_by_way(jlt_tier *out, const jlt_tier *tier, unsigned number, const jlt_way_tables *others)
{
    jlt_tier reached[REACHED_MAX];
    const unsigned count = tier->table != NULL ? reach(reached, tier->asked, others) : 0;

    for (unsigned i = 0; i < count; i++) {
        if (!is_same(reached[i].table, tier->table) || number-- > 0) continue;
        *out = *tier;
        out->is_larger = reached[i].is_larger;
        out->way_count = reached[i].way_count;
        memcpy(out->ways, reached[i].ways, sizeof out->ways);
        memcpy(out->from, reached[i].from, sizeof out->from);
        return true;
    }
    return false;
}

bool jlt_tier_find(jlt_tier *out, const jlt_descriptor *asked, const jlt_way_tables *others, const char *name)
{
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned count = jlt_tier_list(tiers, asked, others);
    const bool own = strcmp(name, "model") == 0;

    for (unsigned i = 0; i < count; i++)
        if (own ? tiers[i].table == asked && *tiers[i].time == '\0' && *tiers[i].elimination == '\0'
                : strcmp(tiers[i].name, name) == 0) {
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
