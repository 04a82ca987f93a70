/** What two studies differ in, from their JSON. */
#ifndef JLT_SHARDS_MANIFEST_H
#define JLT_SHARDS_MANIFEST_H

#include <stdbool.h>
#include <stdio.h>

/** A line for each key whose value differs, members of groups by GROUP.KEY: "  KEY: there VALUE, here VALUE".
 *  False: there is none. */
bool jlt_manifest_difference(FILE *stream, const char *there, const char *here);

#endif
