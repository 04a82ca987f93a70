/** What of a table a task has to show, and must not take for granted meanwhile: symbols under test (task->tested), a root or
 *  logarithm with those after it (task->tested_root), and what depends on them. */
#ifndef TTC_QUESTION_H
#define TTC_QUESTION_H

#include "prove/prove_task.h"

/* With a root or logarithm in question are those after it, which do not vouch for it. */
bool ttc_question_is_tested(const ttc_task *task, uint32_t symbol);

/* Whether an expression uses a symbol under test. */
bool ttc_question_depends(const ttc_task *task, ttc_id id);

/* A root or logarithm of what is under test, of which nothing was shown yet on this leaf: see ttc_task's `shown`. */
bool ttc_question_has(const ttc_task *task, uint32_t symbol);

/* The last such symbol that an expression uses, 0: none; and whether there is one: where that is real is not known yet. */
uint32_t ttc_question_last(const ttc_task *task, ttc_id id);
bool ttc_question_uses_root(const ttc_task *task, ttc_id id);

/* Functions of what is in question stay out of the bases, which would bring its roots in: for a field that is new. */
void ttc_question_withhold(ttc_task *task);

#endif
