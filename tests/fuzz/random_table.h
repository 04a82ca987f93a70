/** Grammatical tables with random claims, about half of them true or false by construction. */
#ifndef RANDOM_TABLE_H
#define RANDOM_TABLE_H

#include <stddef.h>
#include <stdint.h>

enum { TABLE_CLAIMS = 64 };

/* What a verdict may not be. A claim that is true may be left unsettled; what has no point must be. */
typedef enum { CLAIM_OPEN, CLAIM_TRUE, CLAIM_FALSE, CLAIM_SILENT } claim_truth;

typedef struct {
    char kind[16], name[16];
    claim_truth truth;
} made_claim;

typedef struct {
    char *text;   /* of the table, for free() */
    char *target; /* of the table beside it, target.tt, for free() */
    made_claim claims[TABLE_CLAIMS];
    size_t count;
} made_table;

/* A pure function of the seed. text is NULL when memory is out. */
made_table table_make(uint64_t seed);

#endif
