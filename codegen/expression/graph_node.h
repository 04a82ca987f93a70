/* Inside of the graph, for graph.c (the store) and graph_build.c (sums and products). */
#ifndef TTC_GRAPH_NODE_H
#define TTC_GRAPH_NODE_H

#include "expression/graph.h"

typedef struct {
    ttc_kind kind;
    uint32_t symbol;
    uint32_t count;
    uint32_t hash;
    uint32_t depth; /* longest chain of parts below, this node counted */
    ttc_id next;    /* chain of equal hash bucket */
    fmpq_t coefficient;
    ttc_id *ids;
    int32_t *exponents; /* PRODUCT */
    fmpq *coefficients; /* SUM */
} ttc_node;

struct ttc_graph {
    ttc_node **nodes; /* each its own allocation, so that coefficients keep their address; nodes[0] is unused */
    size_t count, capacity;
    ttc_id *buckets;
    size_t bucket_count; /* a power of two */
    size_t bytes;        /* held by nodes, against TTC_MEMORY_LIMIT */
    ttc_graph_status error;
    fmpq_t one;
};

/* Keep the first error; always TTC_NONE. */
ttc_id ttc_graph_fail(ttc_graph *graph, ttc_graph_status error);

/* The node equal to `n`, made when there is none. Takes ownership of what `n` holds. */
ttc_id ttc_graph_intern(ttc_graph *graph, ttc_node *n);

void ttc_node_clear(ttc_node *n);

#endif
