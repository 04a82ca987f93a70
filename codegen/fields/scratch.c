#include "fields/scratch.h"

#include <stdlib.h>
#include <string.h>

enum { HEIGHT_LIMIT = 200, SIZE_LIMIT = TTC_NODE_LIMIT / 4 };

void ttc_scratch_destroy(ttc_scratch *scratch)
{
    if (scratch == NULL) return;
    ttc_graph_destroy(scratch->graph);
    free(scratch->images);
    free(scratch->forms);
    free(scratch->extents);
    free(scratch->heights);
    free(scratch);
}

ttc_scratch *ttc_scratch_of(ttc_field *field)
{
    ttc_scratch *s = field->scratch;
    if (s != NULL && ttc_graph_size(s->graph) < SIZE_LIMIT && !s->failed) return s;
    unsigned attempts = s == NULL ? 0 : s->attempts;
    ttc_scratch_destroy(s);
    field->scratch = s = calloc(1, sizeof *s);
    if (s == NULL) return NULL;
    s->field = field;
    s->attempts = attempts;
    s->graph = ttc_graph_create();
    if (s->graph != NULL) return s;
    ttc_scratch_destroy(s);
    field->scratch = NULL;
    return NULL;
}

ttc_id ttc_carry(ttc_graph *to, const ttc_graph *from, ttc_id id, ttc_id *images)
{
    ttc_kind kind = ttc_kind_of(from, id);
    size_t count = ttc_part_count(from, id);
    if (images[id] != TTC_NONE) return images[id];
    if (kind == TTC_NUMBER) return images[id] = ttc_number(to, ttc_coefficient(from, id));
    if (kind == TTC_SYMBOL) return images[id] = ttc_symbol(to, ttc_symbol_of(from, id));
    ttc_id *parts = malloc((count + 1) * sizeof *parts);
    long *exponents = malloc((count + 1) * sizeof *exponents);
    fmpq *weights = malloc((count + 1) * sizeof *weights); /* borrowed from `from`, not to be cleared */
    bool failed = parts == NULL || exponents == NULL || weights == NULL;
    for (size_t i = 0; i < count && !failed; i++) {
        ttc_part part = ttc_part_at(from, id, i);
        parts[i] = ttc_carry(to, from, part.id, images);
        exponents[i] = part.exponent;
        weights[i] = *part.coefficient;
        failed = parts[i] == TTC_NONE;
    }
    if (!failed && kind == TTC_PRODUCT)
        images[id] = ttc_scale(to, ttc_product(to, parts, exponents, count), ttc_coefficient(from, id));
    if (!failed && kind == TTC_SUM)
        images[id] = ttc_add(to, ttc_number(to, ttc_coefficient(from, id)), ttc_sum(to, parts, weights, count));
    free(parts);
    free(exponents);
    free(weights);
    return images[id];
}

static bool grow(void **array, size_t size, size_t used, size_t capacity)
{
    unsigned char *bytes = realloc(*array, capacity * size);
    if (bytes == NULL) return false;
    memset(bytes + used * size, 0, (capacity - used) * size);
    *array = bytes;
    return true;
}

ttc_id ttc_scratch_import(ttc_scratch *scratch, ttc_id id)
{
    size_t size = ttc_graph_size(scratch->field->graph) + 1, used = scratch->image_capacity;
    if (id == TTC_NONE) return TTC_NONE;
    if (size > used) {
        void *images = scratch->images, *forms = scratch->forms;
        bool ok = grow(&images, sizeof *scratch->images, used, 2 * size);
        scratch->images = images;
        ok = ok && grow(&forms, sizeof *scratch->forms, used, 2 * size);
        scratch->forms = forms;
        scratch->failed |= !ok;
        if (!ok) return TTC_NONE;
        scratch->image_capacity = 2 * size;
    }
    return ttc_carry(scratch->graph, scratch->field->graph, id, scratch->images);
}

ttc_id ttc_scratch_export(ttc_scratch *scratch, ttc_id id)
{
    if (id == TTC_NONE) return TTC_NONE;
    ttc_id *images = calloc((size_t)id + 1, sizeof *images), result = TTC_NONE;
    scratch->failed |= images == NULL;
    if (images != NULL) result = ttc_carry(scratch->field->graph, scratch->graph, id, images);
    free(images);
    return result;
}

ttc_id ttc_scratch_definition(ttc_scratch *scratch, ttc_id symbol, ttc_role role)
{
    if (ttc_kind_of(scratch->graph, symbol) != TTC_SYMBOL) return TTC_NONE;
    const ttc_field_symbol *s = scratch->field->symbols + ttc_symbol_of(scratch->graph, symbol);
    return s->role == role ? ttc_scratch_import(scratch, s->definition) : TTC_NONE;
}

/* Grow `extents` and `heights` to the number of nodes of the graph. */
static bool make_room(ttc_scratch *scratch)
{
    size_t size = ttc_graph_size(scratch->graph) + 1, used = scratch->capacity;
    void *extents = scratch->extents, *heights = scratch->heights;
    if (size <= used) return true;
    bool ok = grow(&extents, sizeof *scratch->extents, used, 2 * size);
    scratch->extents = extents;
    ok = ok && grow(&heights, sizeof *scratch->heights, used, 2 * size);
    scratch->heights = heights;
    scratch->failed |= !ok;
    if (ok) scratch->capacity = 2 * size;
    return ok;
}

ttc_extent ttc_scratch_extent(ttc_scratch *scratch, ttc_id id)
{
    const ttc_graph *graph = scratch->graph;
    if (!make_room(scratch)) return ttc_extent_any;
    if (scratch->extents[id].signs != 0) return scratch->extents[id];
    ttc_extent result = ttc_extent_any;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL)
        result = ttc_field_extent(scratch->field, ttc_symbol(scratch->field->graph, ttc_symbol_of(graph, id)));
    else result = ttc_extent_of_number(ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        ttc_extent extent = ttc_scratch_extent(scratch, part.id);
        if (ttc_kind_of(graph, id) == TTC_PRODUCT)
            result = ttc_extent_multiply(result, ttc_extent_power(extent, part.exponent));
        else result = ttc_extent_add(result, ttc_extent_multiply(extent, ttc_extent_of_number(part.coefficient)));
    }
    scratch->extents[id] = result;
    return result;
}

/* Definitions are imported before `heights` grows, as importing adds nodes. */
unsigned ttc_scratch_height(ttc_scratch *scratch, ttc_id id)
{
    ttc_id unit = ttc_scratch_definition(scratch, id, TTC_ROLE_UNIT), root = ttc_scratch_definition(scratch, id, TTC_ROLE_ROOT);
    if (!make_room(scratch)) return 0;
    if (scratch->heights[id] != 0) return scratch->heights[id] - 1u;
    unsigned height = 0;
    if (unit != TTC_NONE) height = 1 + ttc_scratch_height_inside(scratch, unit);
    else if (root != TTC_NONE) height = ttc_scratch_height_inside(scratch, root);
    else if (ttc_kind_of(scratch->graph, id) != TTC_SYMBOL)
        height = ttc_scratch_height_inside(scratch, id) + (ttc_kind_of(scratch->graph, id) == TTC_SUM);
    if (height > HEIGHT_LIMIT) height = HEIGHT_LIMIT;
    if (make_room(scratch)) scratch->heights[id] = (unsigned char)(height + 1);
    return height;
}

unsigned ttc_scratch_height_inside(ttc_scratch *scratch, ttc_id id)
{
    unsigned greatest = 0;
    if (ttc_kind_of(scratch->graph, id) == TTC_SYMBOL) return ttc_scratch_height(scratch, id);
    for (size_t i = 0; i < ttc_part_count(scratch->graph, id); i++) {
        unsigned height = ttc_scratch_height(scratch, ttc_part_at(scratch->graph, id, i).id);
        if (height > greatest) greatest = height;
    }
    return greatest;
}
