/** Letters that pictures cannot show. */
#ifndef JLT_REPORT_LETTERS_H
#define JLT_REPORT_LETTERS_H

#include <stdbool.h>
#include <stddef.h>

/** Whether this is valid UTF-8, of characters that XML allows, with no control characters other than newlines. */
bool jlt_letters_fit(const char *text);

/** Find the first character of a text in valid UTF-8 that no font of this machine has, by fontconfig's program fc-list.
 *  Out: *length, its bytes. Returns where it stands in the text; NULL: fonts have all, or there is no fc-list.
 *  Cost: a process, about 10 ms, for every different character beyond ASCII. */
const char *jlt_letters_missing(const char *text, size_t *length);

#endif
