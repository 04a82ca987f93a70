#include "shards/deal.h"

#include "base/random.h"

enum { ROUNDS = 4 };

/* A permutation of the numbers of 2 * half bits, another one for each `turn`: a Feistel network (Luby, Rackoff, SIAM J. Comput. 17,
 * 1988), which is invertible whatever its hash function. */
static uint64_t permuted(uint64_t x, unsigned half, uint64_t turn)
{
    const uint64_t mask = ((uint64_t)1 << half) - 1, key = ttc_random_mixed(turn);
    uint64_t left = x >> half, right = x & mask;

    for (uint64_t round = 1; round <= ROUNDS; round++) {
        const uint64_t next = left ^ (ttc_random_mixed(key + right + round * TTC_RANDOM_STEP) & mask);
        left = right;
        right = next;
    }
    return left << half | right;
}

/* The index, 0 .. shards - 1, of the piece that a shard gets in this turn, in which each shard gets one. */
static size_t drawn(size_t shard, size_t shards, size_t turn)
{
    unsigned half = 1;
    uint64_t x = shard;

    while ((uint64_t)1 << (2 * half) < shards) half++;
    /* Cycle walking: results >= shards are permuted again, which leaves a permutation of 0 .. shards - 1. */
    do x = permuted(x, half, turn);
    while (x >= shards);
    return (size_t)x;
}

size_t jlt_deal_count(size_t shard, size_t shards, size_t pieces)
{
    const size_t whole = pieces / shards;
    return whole + (drawn(shard, shards, whole) < pieces % shards);
}

size_t jlt_deal_piece(size_t place, size_t shard, size_t shards)
{
    return place * shards + drawn(shard, shards, place);
}
