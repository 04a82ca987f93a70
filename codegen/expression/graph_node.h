/* The representation of the graph, for graph.c (the store), graph_build.c (sums and products) and walk.c. */
#ifndef TTC_GRAPH_NODE_H
#define TTC_GRAPH_NODE_H

#include "expression/graph.h"

typedef struct {
    ttc_kind kind;
    uint32_t symbol;
    uint32_t count;
    uint32_t hash;
    uint32_t depth; /* number of nodes in the longest chain of parts, this node included */
    ttc_id next;    /* next node of the same hash bucket */
    fmpq_t coefficient;
    ttc_id *ids;
    int32_t *exponents; /* PRODUCT */
    fmpq *coefficients; /* SUM */
} ttc_node;

struct ttc_graph {
    ttc_node **nodes; /* each allocated by itself, so that coefficients keep their address; nodes[0] is unused */
    size_t count, capacity;
    ttc_id *buckets;
    size_t bucket_count; /* a power of two */
    size_t bytes;        /* held by all nodes, at most TTC_MEMORY_LIMIT */
    ttc_graph_status error;
    fmpq_t one;
};

/* Record an error unless there is one already. Always returns TTC_NONE. */
ttc_id ttc_graph_fail(ttc_graph *graph, ttc_graph_status error);

/* The node equal to `n`, created if the graph has none; TTC_NONE beyond a limit. Takes ownership of what `n` holds. */
ttc_id ttc_graph_intern(ttc_graph *graph, ttc_node *n);

void ttc_node_clear(ttc_node *n);

#endif
