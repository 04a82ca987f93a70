/** Random tables that follow the grammar, with random claims, of which about half are true or false by construction. */
#ifndef RANDOM_TABLE_H
#define RANDOM_TABLE_H

#include <stddef.h>
#include <stdint.h>

enum { TABLE_CLAIMS = 64 };

/* What is known of a claim. OPEN: nothing; TRUE: it must not be refuted; FALSE: it must not be proved; SILENT: no point meets its
 * conditions, so it must be left unsettled. */
typedef enum { CLAIM_OPEN, CLAIM_TRUE, CLAIM_FALSE, CLAIM_SILENT } claim_truth;

typedef struct {
    char kind[16], name[16];
    claim_truth truth;
} made_claim;

typedef struct {
    char *text;   /* of the table, for the caller to free() */
    char *target; /* of the table target.tt that lies beside it, for the caller to free() */
    made_claim claims[TABLE_CLAIMS];
    size_t count;
} made_table;

/* Make a table; it depends on the seed alone. text is NULL when memory is out. */
made_table table_make(uint64_t seed);

#endif
