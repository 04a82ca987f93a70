/** What an extraction could take next, kept up to date change by change: candidates with equal keys form a group, and the
 *  groups that save operations are ranked by key. An index is zeroed before first use. */
#ifndef TTC_EXTRACT_INDEX_H
#define TTC_EXTRACT_INDEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TTC_NO_GROUP UINT32_MAX
#define TTC_NO_PLACE UINT32_MAX

/* Two terms, first before second, of the sum of a variable. */
typedef struct {
    uint32_t variable, first, second;
    int32_t gain;                     /* operations saved here, the new unit left out */
    uint32_t group;
    uint32_t next, before;            /* in the group */
    uint32_t term_next[2], term_before[2]; /* among the places of the first and of the second term: 2 * place + side */
} ttc_term_pair;

typedef struct {
    uint64_t key;
    uint32_t size;    /* members */
    int32_t cost;     /* operations of the new unit */
    int32_t gain;     /* as last ranked */
    uint32_t places;  /* the first; TTC_NO_PLACE in an index of counts alone */
    uint32_t next;    /* in the bucket, or among the free ones */
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
    uint32_t *buckets;                /* 1 + group */
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

/* The group of a key, made when there is none. TTC_NO_GROUP: memory is out. */
uint32_t ttc_extract_index_group(ttc_extract_index *index, uint64_t key, int32_t cost);

/* One member more, or less, of a group that counts alone. */
void ttc_extract_index_count(ttc_extract_index *index, uint64_t key, int by);

/** Add a place to its group and to the places of its terms. heads: by term, 1 + (2 * place + side), 0 for none. */
void ttc_extract_index_add(ttc_extract_index *index, uint32_t group, ttc_term_pair place, uint32_t *head_first,
                           uint32_t *head_second);

/** Remove all places of a term. head_of: the head of any term. */
typedef uint32_t *(*ttc_head_finder)(void *context, uint32_t variable, uint32_t term);
void ttc_extract_index_remove(ttc_extract_index *index, uint32_t *head, ttc_head_finder head_of, void *context);

/** The places of a group in the order of sums and terms; sorted shape (size of the group,). */
void ttc_extract_index_places(const ttc_extract_index *index, uint32_t group, ttc_term_pair *sorted);

/** Weigh what changed, and bring `ranked` up to date. */
void ttc_extract_index_rank(ttc_extract_index *index);

#endif
