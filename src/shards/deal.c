#include "shards/deal.h"

#include <stdint.h>

enum { ROUNDS = 4 };

/* The finalizer of splitmix64: Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014. */
static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* A permutation of the numbers of 2 * half bits: a Feistel network (Luby, Rackoff, SIAM J. Comput. 17, 1988), which needs no
 * inverse of its hash. */
static uint64_t permuted(uint64_t x, unsigned half)
{
    const uint64_t mask = ((uint64_t)1 << half) - 1;
    uint64_t left = x >> half, right = x & mask;

    for (uint64_t round = 1; round <= ROUNDS; round++) {
        const uint64_t next = left ^ (mix(right + round * 0x9e3779b97f4a7c15u) & mask);
        left = right;
        right = next;
    }
    return left << half | right;
}

size_t jlt_deal_piece(size_t position, size_t pieces)
{
    unsigned half = 1;
    uint64_t x = position;

    while ((uint64_t)1 << (2 * half) < pieces) half++;
    /* Numbers beyond the last piece are passed over: what is left of a permutation's cycles is one of the pieces. */
    do x = permuted(x, half);
    while (x >= pieces);
    return (size_t)x;
}
