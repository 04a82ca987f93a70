/** Sets and pairs of states of a field, by their indices. */
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

typedef struct {
    unsigned char first, second;
} jlt_state_pair;

/* No state is in two of them. */
typedef struct {
    unsigned count;
    jlt_state_pair of[JLT_STATE_SET_MAX / 2];
} jlt_state_pairs;

/* i < JLT_STATE_SET_MAX. */
static inline void jlt_state_set_add(jlt_state_set *set, unsigned i) { set->words[i / 64] |= (uint64_t)1 << i % 64; }

#endif
