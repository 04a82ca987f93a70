/* Reading the text of a table, bounded in size, and checking its bytes before the lexer sees them. */
#ifndef TTC_SOURCE_H
#define TTC_SOURCE_H

#include "base/diagnostic.h"

enum { TTC_SOURCE_LIMIT = 1 << 20 }; /* bytes of a table */

/* Read a file into a NUL-terminated string for the caller to free. Reading stops one byte past TTC_SOURCE_LIMIT, so that
 * ttc_source_check can refuse larger files. Returns NULL after reporting an error. */
char *ttc_source_read(const char *path, size_t *length, ttc_diagnostics *diagnostics);

/* Returns true if the text is UTF-8 without a byte order mark, has no control characters but tab and line feed, and is no longer
 * than TTC_SOURCE_LIMIT. Otherwise reports the first fault and returns false. */
bool ttc_source_check(const char *text, size_t length, ttc_diagnostics *diagnostics);

#endif
