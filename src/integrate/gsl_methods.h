/** GSL's steppers in the table. Their steps and error control are GSL's; polynomials and partial steps are DOP853's. */
#ifndef JLT_INTEGRATE_GSL_METHODS_H
#define JLT_INTEGRATE_GSL_METHODS_H

#include "integrate/method.h"

extern const jlt_method jlt_method_rk8pd, jlt_method_rkf45, jlt_method_msadams;

#endif
