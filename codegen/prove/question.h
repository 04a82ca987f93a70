/** Symbols whose own conditions a task has to show, and must not assume. Under test are those of task->tested, and roots and
 *  logarithms from task->tested_root on; in question are roots and logarithms that depend on symbols under test. */
#ifndef TTC_QUESTION_H
#define TTC_QUESTION_H

#include "prove/prove_task.h"

/* Returns true if a symbol is under test. */
bool ttc_question_is_tested(const ttc_task *task, uint32_t symbol);

/* Returns true if an expression depends on a symbol under test. */
bool ttc_question_depends(const ttc_task *task, ttc_id id);

/* Returns true if a symbol is in question: a root or logarithm that depends on symbols under test, not before task->shown. */
bool ttc_question_has(const ttc_task *task, uint32_t symbol);

/* The last symbol in question that an expression uses, 0 if none; and true if there is one: the expression may then not be real. */
uint32_t ttc_question_last(const ttc_task *task, ttc_id id);
bool ttc_question_uses_root(const ttc_task *task, ttc_id id);

/* In a new field, withhold functions that use symbols in question from the bases, which would adjoin their roots. */
void ttc_question_withhold(ttc_task *task);

#endif
