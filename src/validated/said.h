/** What a certificate says in numbers, against what was proved, and against its own words.
 *
 *  Its words repeat its numbers. So they are true where each number says no more than what was proved, and all that they conclude
 *  from a number follows from it as it is written, not from the tighter one that it stands for. */
#ifndef JLT_VALIDATED_SAID_H
#define JLT_VALIDATED_SAID_H

#include <jansson.h>
#include <stdbool.h>

/** Whether `given` and what certificates of this kind have in it have no members but those that are read. */
bool jlt_said_is_form(const char *kind, const json_t *given);

/** Whether `said` follows from `proved`, both as "shown" of certificates: they have the same form, each ball of `said` contains
 *  that of `proved`, all else is the same. */
bool jlt_said_follows(const json_t *said, const json_t *proved);

/** Which words of a certificate of this kind its numbers do not bear out, as a sentence; NULL: they bear out all. In: given, and
 *  shown, which has the form of what was proved. */
const char *jlt_said_problem(const char *kind, const json_t *given, const json_t *shown);

#endif
