/** Tells in what two studies differ, from their JSON. */
#ifndef JLT_SHARDS_MANIFEST_H
#define JLT_SHARDS_MANIFEST_H

#include <stdbool.h>
#include <stdio.h>

/** Write a line for each key whose value differs, "  KEY: there VALUE, here VALUE"; members of groups are called GROUP.KEY. Returns
 *  false where nothing differs. */
bool jlt_manifest_difference(FILE *stream, const char *there, const char *here);

#endif
