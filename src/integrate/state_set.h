/** Sets and groups of states of a field, by their indices. */
#ifndef JLT_INTEGRATE_STATE_SET_H
#define JLT_INTEGRATE_STATE_SET_H

#include <stdbool.h>
#include <stdint.h>

enum { JLT_STATE_SET_WORDS = 4, JLT_STATE_SET_MAX = 64 * JLT_STATE_SET_WORDS };

/* Bit i % 64 of word i / 64 is state i < JLT_STATE_SET_MAX. Empty when zeroed. */
typedef struct {
    uint64_t words[JLT_STATE_SET_WORDS];
} jlt_state_set;

static inline bool jlt_state_set_has(const jlt_state_set *set, unsigned i)
{
    return i < JLT_STATE_SET_MAX && (set->words[i / 64] >> i % 64 & 1) != 0;
}

/* i < JLT_STATE_SET_MAX. */
static inline void jlt_state_set_add(jlt_state_set *set, unsigned i) { set->words[i / 64] |= (uint64_t)1 << i % 64; }

static inline void jlt_state_set_remove(jlt_state_set *set, unsigned i) { set->words[i / 64] &= ~((uint64_t)1 << i % 64); }

static inline void jlt_state_set_join(jlt_state_set *set, const jlt_state_set *with)
{
    for (unsigned k = 0; k < JLT_STATE_SET_WORDS; k++) set->words[k] |= with->words[k];
}

static inline unsigned jlt_state_set_count(const jlt_state_set *set)
{
    unsigned count = 0;

    for (unsigned i = 0; i < JLT_STATE_SET_MAX; i++) count += jlt_state_set_has(set, i);
    return count;
}

enum { JLT_STATE_GROUPS_MAX = 32, JLT_STATE_MEMBERS_MAX = 2 * JLT_STATE_SET_MAX };

/* Groups of states, which may share some: those of group g are member[first[g]] to member[first[g + 1] - 1]. */
typedef struct {
    unsigned count;
    unsigned first[JLT_STATE_GROUPS_MAX + 1];
    unsigned char member[JLT_STATE_MEMBERS_MAX];
    jlt_state_set any; /* the states that are in a group */
} jlt_state_groups;

#endif
