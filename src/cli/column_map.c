#include "cli/column_map.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "report/table.h"

unsigned jlt_column_map_cut(char *fields[JLT_COLUMN_MAP_MAX], char *line)
{
    const size_t count = jlt_table_cut(fields, JLT_COLUMN_MAP_MAX, line);

    return (unsigned)(count < JLT_COLUMN_MAP_MAX ? count : JLT_COLUMN_MAP_MAX);
}

/* Print which of the names are not among `others`. */
static void tell_missing(const char *where, char *const *names, unsigned count, char *const *others, unsigned other_count,
                         const char *ending)
{
    unsigned missing = 0;

    for (unsigned i = 0; i < count; i++) {
        unsigned k = 0;
        while (k < other_count && strcmp(names[i], others[k]) != 0) k++;
        if (k < other_count) continue;
        if (missing++ == 0) fprintf(stderr, "jellett: at %s:", where);
        fprintf(stderr, "%s %s", missing > 1 ? "," : "", names[i]);
    }
    if (missing > 0) fprintf(stderr, ": %s\n", ending);
}

bool jlt_column_map_make(jlt_column_map *map, char **odd, const char *where, const char *whole, const char *own)
{
    char *owned[JLT_COLUMN_MAP_MAX], *all[JLT_COLUMN_MAP_MAX];
    JLT_FREED char *own_text = strdup(own), *whole_text = strdup(whole);

    if (own_text == NULL || whole_text == NULL) return false;
    const unsigned count = map->own = jlt_column_map_cut(owned, own_text);
    map->count = jlt_column_map_cut(all, whole_text);
    for (unsigned i = 0; i < map->count; i++) {
        unsigned k = 0;
        while (k < count && strcmp(owned[k], all[i]) != 0) k++;
        map->from[i] = k < count ? k : JLT_COLUMN_MAP_MAX;
    }
    map->same = strcmp(own, whole) == 0;
    if (map->same || (*odd != NULL && strcmp(*odd, own) == 0)) return true;
    tell_missing(where, all, map->count, owned, count, "no columns here, and left empty");
    tell_missing(where, owned, count, all, map->count, "columns that the first point has not, and left out");
    free(*odd);
    *odd = strdup(own);
    return *odd != NULL;
}
