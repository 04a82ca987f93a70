/** QEPCAD B, which decides questions about real polynomials by cylindrical algebraic decomposition (C. W. Brown, QEPCAD B: a
 *  program for computing with semi-algebraic sets using CADs, SIGSAM Bulletin 37, 2003): a second witness for what Z3 says. It is a
 *  program of its own, found in PATH; no text of a table reaches it. */
#ifndef TTC_QEPCAD_H
#define TTC_QEPCAD_H

#include <z3.h>

#include "algebra/ratio.h"

/** Returns true if QEPCAD finds that no real point meets all `count` conditions: sums of products of numbers and variables
 *  compared with numbers, combined by `not` and `or`. Variables are integer symbols, their numbers in the ring. If the ring has
 *  roots, and one order of elimination fails, a second one is tried; each takes `seconds` of processor time at most. Returns false
 *  if there is a point, if QEPCAD does not know in time, or if it is not installed. */
bool ttc_qepcad_finds_none(Z3_context z3, const ttc_ring *ring, const Z3_ast *conditions, size_t count, unsigned seconds);

/** Returns true if PATH leads to QEPCAD. */
bool ttc_qepcad_is_there(void);

#endif
