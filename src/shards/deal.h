/** Deals the pieces of a study out to its shards. Of every N pieces that follow each other, each of N shards has one, and a hash
 *  says which: neighbours cost alike, so that costly parameters are shared by all, and no shard has the same part of each grid. */
#ifndef JLT_SHARDS_DEAL_H
#define JLT_SHARDS_DEAL_H

#include <stddef.h>

/** How many pieces a shard has: as many as any other, or one less or more. 0 <= shard < shards, all numbers < 2^62. */
size_t jlt_deal_count(size_t shard, size_t shards, size_t pieces);

/** The piece, 0 .. pieces - 1, that a shard computes at this place of its order, 0 <= place < jlt_deal_count. It depends on these
 *  numbers alone. Cost: a few hashes, whatever the number of pieces. */
size_t jlt_deal_piece(size_t place, size_t shard, size_t shards);

#endif
