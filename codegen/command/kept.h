/** The files of an earlier run of ttc generate, which need not be written again where their table has not changed. */
#ifndef TTC_KEPT_H
#define TTC_KEPT_H

#include "read/model.h"

/* The lists of a folder; NULL: there is none, or it cannot be read. */
typedef struct {
    char *manifest, *counts;
} ttc_kept;

void ttc_kept_read(ttc_kept *kept, const char *folder); /* for ttc_kept_clear */
void ttc_kept_clear(ttc_kept *kept);

/** Returns true if all files of the model are in the folder, and by its manifest, and by the digests in them, neither the table nor
 *  one that its claims lead to has changed since they were written; and if no claim is open there because the system ended its
 *  proof, which may come to an end now. */
bool ttc_kept_has(const ttc_kept *kept, const char *folder, const ttc_model *model);

#endif
