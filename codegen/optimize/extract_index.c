#include "optimize/extract_index.h"

#include <stdlib.h>
#include <string.h>

/* Make room for one more item; `failed` if memory is out. */
static bool reserve(ttc_extract_index *index, void *items, size_t size, size_t count, size_t *capacity)
{
    void *old = NULL, *grown = NULL;
    if (count < *capacity) return true;
    size_t wanted = *capacity == 0 ? 256 : 2 * *capacity;
    memcpy(&old, items, sizeof old);
    grown = realloc(old, wanted * size);
    if (grown == NULL) {
        index->failed = true;
        return false;
    }
    memcpy(items, &grown, sizeof grown);
    *capacity = wanted;
    return true;
}

void ttc_extract_index_clear(ttc_extract_index *index)
{
    free(index->groups);
    free(index->buckets);
    free(index->changed);
    free(index->ranked);
    free(index->spare);
    free(index->places);
    *index = (ttc_extract_index){ 0 };
}

static size_t bucket_of(const ttc_extract_index *index, uint64_t key)
{
    return (size_t)((key * UINT64_C(0x9E3779B97F4A7C15)) >> 32) & (index->bucket_count - 1);
}

static bool grow_buckets(ttc_extract_index *index)
{
    size_t count = index->bucket_count == 0 ? 1024 : 4 * index->bucket_count;
    uint32_t *buckets = calloc(count, sizeof *buckets), *old = index->buckets;
    size_t old_count = index->bucket_count;
    if (buckets == NULL) {
        index->failed = true;
        return false;
    }
    index->buckets = buckets;
    index->bucket_count = count;
    for (size_t b = 0; b < old_count; b++)
        for (uint32_t g = old[b], next = 0; g != 0; g = next) {
            next = index->groups[g - 1].next;
            size_t at = bucket_of(index, index->groups[g - 1].key);
            index->groups[g - 1].next = buckets[at];
            buckets[at] = g;
        }
    free(old);
    return true;
}

static void note_change(ttc_extract_index *index, uint32_t group)
{
    if (index->groups[group].is_changed) return;
    if (!reserve(index, &index->changed, sizeof *index->changed, index->changed_count, &index->changed_capacity)) return;
    index->groups[group].is_changed = true;
    index->changed[index->changed_count++] = group;
}

uint32_t ttc_extract_index_group(ttc_extract_index *index, uint64_t key, int32_t cost)
{
    if (index->count >= index->bucket_count && !grow_buckets(index)) return TTC_NO_GROUP;
    size_t at = bucket_of(index, key);
    for (uint32_t g = index->buckets[at]; g != 0; g = index->groups[g - 1].next)
        if (index->groups[g - 1].key == key) return g - 1;
    uint32_t group = index->unused;
    if (group != 0) {
        index->unused = index->groups[--group].next;
    } else {
        size_t capacity = index->capacity;
        if (!reserve(index, &index->groups, sizeof *index->groups, index->count, &capacity)) return TTC_NO_GROUP;
        index->capacity = (uint32_t)capacity;
        group = index->count++;
    }
    index->groups[group] = (ttc_group){ .key = key, .cost = cost, .places = TTC_NO_PLACE, .next = index->buckets[at] };
    index->buckets[at] = group + 1;
    return group;
}

void ttc_extract_index_count(ttc_extract_index *index, uint64_t key, int by)
{
    uint32_t group = ttc_extract_index_group(index, key, 1);
    if (group == TTC_NO_GROUP) return;
    index->groups[group].size += (uint32_t)by;
    index->members += (uint64_t)(int64_t)by;
    note_change(index, group);
}

static void link_term(ttc_extract_index *index, uint32_t place, unsigned side, uint32_t *head)
{
    ttc_term_pair *p = index->places + place;
    p->term_next[side] = *head;
    p->term_before[side] = 0;
    if (*head != 0) index->places[(*head - 1) / 2].term_before[(*head - 1) % 2] = 2 * place + side + 1;
    *head = 2 * place + side + 1;
}

static void unlink_term(ttc_extract_index *index, uint32_t place, unsigned side, uint32_t *head)
{
    const ttc_term_pair *p = index->places + place;
    uint32_t next = p->term_next[side], before = p->term_before[side];
    if (before == 0) *head = next;
    else index->places[(before - 1) / 2].term_next[(before - 1) % 2] = next;
    if (next != 0) index->places[(next - 1) / 2].term_before[(next - 1) % 2] = before;
}

void ttc_extract_index_add(ttc_extract_index *index, uint32_t group, ttc_term_pair place, uint32_t *head_first,
                           uint32_t *head_second)
{
    uint32_t number = index->unused_place;
    if (number != 0) {
        index->unused_place = index->places[--number].next;
    } else {
        size_t capacity = index->place_capacity;
        if (!reserve(index, &index->places, sizeof *index->places, index->place_count, &capacity)) return;
        index->place_capacity = (uint32_t)capacity;
        number = index->place_count++;
    }
    ttc_group *g = index->groups + group;
    place.group = group;
    place.next = g->places;
    place.before = TTC_NO_PLACE;
    if (g->places != TTC_NO_PLACE) index->places[g->places].before = number;
    g->places = number;
    g->size++;
    index->members++;
    index->places[number] = place;
    link_term(index, number, 0, head_first);
    link_term(index, number, 1, head_second);
    note_change(index, group);
}

void ttc_extract_index_remove(ttc_extract_index *index, uint32_t *head, ttc_head_finder head_of, void *context)
{
    while (*head != 0 && !index->failed) {
        uint32_t number = (*head - 1) / 2;
        ttc_term_pair *p = index->places + number;
        ttc_group *g = index->groups + p->group;
        unlink_term(index, number, 0, head_of(context, p->variable, p->first));
        unlink_term(index, number, 1, head_of(context, p->variable, p->second));
        if (p->before == TTC_NO_PLACE) g->places = p->next;
        else index->places[p->before].next = p->next;
        if (p->next != TTC_NO_PLACE) index->places[p->next].before = p->before;
        g->size--;
        index->members--;
        note_change(index, p->group);
        p->next = index->unused_place;
        index->unused_place = number + 1;
    }
}

static int compare_places(const void *left, const void *right)
{
    const ttc_term_pair *a = left, *b = right;
    if (a->variable != b->variable) return a->variable < b->variable ? -1 : 1;
    if (a->first != b->first) return a->first < b->first ? -1 : 1;
    return a->second < b->second ? -1 : a->second > b->second;
}

void ttc_extract_index_places(const ttc_extract_index *index, uint32_t group, ttc_term_pair *sorted)
{
    size_t count = 0;
    for (uint32_t p = index->groups[group].places; p != TTC_NO_PLACE; p = index->places[p].next)
        sorted[count++] = index->places[p];
    if (count > 1) qsort(sorted, count, sizeof *sorted, compare_places);
}

/* The total gain of sorted places; one that shares a term with an earlier place of its sum does not count. */
static int32_t gain_of_places(const ttc_term_pair *places, size_t count)
{
    int32_t gain = 0;
    for (size_t i = 0; i < count; i++) {
        bool free_terms = true;
        for (size_t j = i; j-- > 0 && free_terms && places[j].variable == places[i].variable;)
            free_terms = places[j].first != places[i].first && places[j].first != places[i].second
                         && places[j].second != places[i].first && places[j].second != places[i].second;
        if (free_terms) gain += places[i].gain;
    }
    return gain;
}

static void weigh(ttc_extract_index *index, uint32_t group)
{
    ttc_group *g = index->groups + group;
    ttc_term_pair few[8], *sorted = few;
    if (g->size == 0) g->gain = 0;
    else if (g->places == TTC_NO_PLACE) g->gain = (int32_t)g->size - g->cost;
    else if (g->size == 1) g->gain = index->places[g->places].gain - g->cost;
    else {
        if (g->size > sizeof few / sizeof *few) sorted = malloc(g->size * sizeof *sorted);
        index->failed |= sorted == NULL;
        if (sorted == NULL) return;
        ttc_extract_index_places(index, group, sorted);
        g->gain = gain_of_places(sorted, g->size) - g->cost;
        if (sorted != few) free(sorted);
    }
}

static void discard(ttc_extract_index *index, uint32_t group)
{
    uint32_t *at = index->buckets + bucket_of(index, index->groups[group].key);
    while (*at != group + 1) at = &index->groups[*at - 1].next;
    *at = index->groups[group].next;
    index->groups[group].next = index->unused;
    index->unused = group + 1;
}

static int compare_ranked(const void *left, const void *right)
{
    const ttc_ranked *a = left, *b = right;
    return a->key < b->key ? -1 : a->key > b->key;
}

static void sort_ranked(ttc_ranked *items, size_t count)
{
    if (count > 32) {
        qsort(items, count, sizeof *items, compare_ranked);
        return;
    }
    for (size_t i = 1; i < count; i++) {
        ttc_ranked item = items[i];
        size_t at = i;
        for (; at > 0 && items[at - 1].key > item.key; at--) items[at] = items[at - 1];
        items[at] = item;
    }
}

/* Merge the changed groups, sorted, into the ranking in place of their old entries. */
static void merge(ttc_extract_index *index, const ttc_ranked *changed, size_t changed_count)
{
    size_t i = 0, j = 0, count = 0;
    while (i < index->ranked_count || j < changed_count) {
        bool is_old = j == changed_count || (i < index->ranked_count && index->ranked[i].key < changed[j].key);
        if (is_old) {
            index->spare[count++] = index->ranked[i++];
            continue;
        }
        if (i < index->ranked_count && index->ranked[i].key == changed[j].key) i++;
        if (changed[j].gain > 0) index->spare[count++] = changed[j];
        j++;
    }
    ttc_ranked *swap = index->ranked;
    index->ranked = index->spare;
    index->spare = swap;
    index->ranked_count = count;
}

void ttc_extract_index_rank(ttc_extract_index *index)
{
    size_t count = index->changed_count, room = index->ranked_count + count;
    if (count == 0 || index->failed) return;
    ttc_ranked *changed = malloc(count * sizeof *changed);
    if (room > index->ranked_capacity) {
        ttc_ranked *ranked = realloc(index->ranked, 2 * room * sizeof *ranked);
        if (ranked != NULL) index->ranked = ranked;
        ttc_ranked *spare = realloc(index->spare, 2 * room * sizeof *spare);
        if (spare != NULL) index->spare = spare;
        index->failed |= ranked == NULL || spare == NULL;
        if (!index->failed) index->ranked_capacity = 2 * room;
    }
    index->failed |= changed == NULL;
    for (size_t i = 0; i < count && !index->failed; i++) {
        uint32_t group = index->changed[i];
        weigh(index, group);
        index->groups[group].is_changed = false;
        changed[i] = (ttc_ranked){ index->groups[group].key, group, index->groups[group].gain };
        if (index->groups[group].size == 0) discard(index, group);
    }
    if (!index->failed) {
        sort_ranked(changed, count);
        merge(index, changed, count);
        index->changed_count = 0;
    }
    free(changed);
}
