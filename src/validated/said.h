/** Compares what a certificate says in numbers with what was proved, and its words with its numbers.
 *
 *  The words of a certificate repeat its numbers. They are true if each number says no more than what was proved, and everything
 *  that they conclude from a number follows from the number as it is written, not only from the tighter enclosure behind it. */
#ifndef JLT_VALIDATED_SAID_H
#define JLT_VALIDATED_SAID_H

#include <jansson.h>
#include <stdbool.h>

/** Whether `given`, and its parts that are read for certificates of this kind, have no other members than those that are read. */
bool jlt_said_is_form(const char *kind, const json_t *given);

/** Whether `said` follows from `proved`, both members "shown" of certificates: they have the same form, each ball of `said`
 *  contains that of `proved`, no lower bound of a condition is above that of `proved`, and everything else is equal. */
bool jlt_said_follows(const json_t *said, const json_t *proved);

/** A sentence that names the words of a certificate of this kind that its numbers do not support; NULL: all are supported. In:
 *  given, and shown, which has the form of what was proved. */
const char *jlt_said_problem(const char *kind, const json_t *given, const json_t *shown);

#endif
