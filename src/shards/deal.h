/** Deals the pieces of a study out to its shards: evenly, and mixed by a hash, so that regions of costly rows are shared by all. */
#ifndef JLT_SHARDS_DEAL_H
#define JLT_SHARDS_DEAL_H

#include <stddef.h>

/** The piece at a position of the order in which pieces number 0 .. pieces - 1 are dealt, which depends on `pieces` alone. Shard I
 *  of N computes those at I, I + N, I + 2 N, ... of this order: as many as any other shard, or one less. position < pieces < 2^62.
 *  Cost: a few hashes, whatever the number of pieces. */
size_t jlt_deal_piece(size_t position, size_t pieces);

#endif
