/** Whether tables have the relations that balanced.h relies on, by values of their kernels. */
#ifndef JLT_TOP_BALANCED_FORM_H
#define JLT_TOP_BALANCED_FORM_H

#include "top/balanced.h"

/** Whether E, G, F0, M and the rates of gamma3 and psi depend on the state as balanced.h says, at a few states: edited tables may
 *  prove other integrals of these names. Only if jlt_balanced_serves. */
bool jlt_balanced_form_holds(const jlt_top *top);

#endif
