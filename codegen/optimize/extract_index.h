/** An index of candidates for extraction, updated change by change: candidates with equal keys form a group; groups that save
 *  operations are listed by key. Zeroed before first use. */
#ifndef TTC_EXTRACT_INDEX_H
#define TTC_EXTRACT_INDEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TTC_NO_GROUP UINT32_MAX
#define TTC_NO_PLACE UINT32_MAX

/* A place: two terms, first before second, of a variable's sum. */
typedef struct {
    uint32_t variable, first, second;
    int32_t gain;                     /* operations saved here, not counting the new unit */
    uint32_t group;
    uint32_t next, before;            /* neighbours in the list of the group */
    uint32_t term_next[2], term_before[2]; /* neighbours in the lists of the two terms */
} ttc_term_pair;

typedef struct {
    uint64_t key;
    uint32_t size;    /* members */
    int32_t cost;     /* operations of the new unit */
    int32_t gain;     /* as last ranked */
    uint32_t places;  /* the first; TTC_NO_PLACE if the index only counts */
    uint32_t next;    /* 1 + next group of the bucket, or free group */
    bool is_changed;  /* since the last ranking */
} ttc_group;

typedef struct {
    uint64_t key;
    uint32_t group;
    int32_t gain;
} ttc_ranked;

typedef struct {
    ttc_group *groups;
    uint32_t count, capacity, unused; /* unused: 1 + the first free group */
    uint32_t *buckets;                /* 1 + first group of each; 0: none */
    size_t bucket_count;
    uint32_t *changed;
    size_t changed_count, changed_capacity;
    ttc_ranked *ranked, *spare; /* groups of positive gain, keys ascending */
    size_t ranked_count, ranked_capacity;
    ttc_term_pair *places;
    uint32_t place_count, place_capacity, unused_place; /* unused_place: 1 + the first free place */
    uint64_t members; /* of all groups */
    bool failed;      /* memory is out */
} ttc_extract_index;

void ttc_extract_index_clear(ttc_extract_index *index);

/* Find or make the group of a key. Returns TTC_NO_GROUP when memory is out. */
uint32_t ttc_extract_index_group(ttc_extract_index *index, uint64_t key, int32_t cost);

/* In an index that only counts, add `by`, 1 or -1, to a group's size. */
void ttc_extract_index_count(ttc_extract_index *index, uint64_t key, int by);

/** Add a place to a group and to the lists of its two terms. Heads of such lists, and links, are 1 + (2 * place + side), side 0
 *  for a first term and 1 for a second; 0: none. */
void ttc_extract_index_add(ttc_extract_index *index, uint32_t group, ttc_term_pair place, uint32_t *head_first,
                           uint32_t *head_second);

/** Remove all places of the term whose list begins at *head. head_of gives the head of any term's list. */
typedef uint32_t *(*ttc_head_finder)(void *context, uint32_t variable, uint32_t term);
void ttc_extract_index_remove(ttc_extract_index *index, uint32_t *head, ttc_head_finder head_of, void *context);

/** Copy the places of a group, sorted by variable and terms; sorted: shape (size of the group,). */
void ttc_extract_index_places(const ttc_extract_index *index, uint32_t group, ttc_term_pair *sorted);

/** Compute the gains of changed groups, and update `ranked`. */
void ttc_extract_index_rank(ttc_extract_index *index);

#endif
