#include "kernel/link.h"

#include <string.h>

#include "kernel/descriptor.h"

enum { TABLES_MAX = 64 };

/* The claim by which motions of one table are motions of the other; NULL when it makes none. A lift says where to begin there, and
 * nothing of motion; what holds under a condition on parameters leads nowhere in general. */
static const jlt_claim *leads(const jlt_descriptor *from, const jlt_descriptor *to)
{
    for (const jlt_claim *claim = from->claims; claim->kind != NULL; claim++)
        if (claim->target != NULL && strcmp(claim->target, to->sha256) == 0 && strcmp(claim->kind, "lift") != 0
            && claim->condition[0] == '\0')
            return claim;
    return NULL;
}

static bool linked(const jlt_descriptor *from, const jlt_descriptor *to)
{
    const jlt_claim *there = leads(from, to);

    return there != NULL && there->verdict == JLT_PROVED;
}

/* The general fields of all tables that are built in or among others, and of `first`. */
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

bool jlt_link_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *to, const jlt_way_tables *others)
{
    const jlt_descriptor *tables[TABLES_MAX];
    bool reached[TABLES_MAX] = { true }, grown = true;
    const size_t count = list_tables(tables, from, others);
    const jlt_claim *there = leads(from, to);

    *broken = NULL;
    if (strcmp(from->sha256, to->sha256) == 0) return true;
    while (grown) {
        grown = false;
        for (size_t i = 0; i < count; i++)
            for (size_t k = 1; reached[i] && k < count; k++)
                if (!reached[k] && linked(tables[i], tables[k])) reached[k] = grown = true;
    }
    for (size_t k = 0; k < count; k++)
        if (reached[k] && strcmp(tables[k]->sha256, to->sha256) == 0) return true;
    *broken = there;
    return false;
}
