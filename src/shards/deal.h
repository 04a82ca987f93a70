/** Deals the pieces of a study out to its N shards: of every N consecutive pieces each shard gets one, which a hash chooses.
 *  Neighbouring pieces cost about the same, so all shards share the costly parameters, and no shard gets the same part of every
 *  grid. */
#ifndef JLT_SHARDS_DEAL_H
#define JLT_SHARDS_DEAL_H

#include <stddef.h>

/** The number of pieces of a shard; those of any two shards differ by at most one. 0 <= shard < shards, all numbers < 2^62. */
size_t jlt_deal_count(size_t shard, size_t shards, size_t pieces);

/** The piece, 0 .. pieces - 1, that a shard computes as its number `place`, 0 <= place < jlt_deal_count. It depends on these
 *  numbers alone. Cost: a few hashes, whatever the number of pieces. */
size_t jlt_deal_piece(size_t place, size_t shard, size_t shards);

#endif
