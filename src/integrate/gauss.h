/** Gauss-Legendre collocation of order 16, its eight nodes evaluated at once by batched kernels. */
#ifndef JLT_INTEGRATE_GAUSS_H
#define JLT_INTEGRATE_GAUSS_H

#include "integrate/method.h"

extern const jlt_method jlt_method_gauss;

#endif
