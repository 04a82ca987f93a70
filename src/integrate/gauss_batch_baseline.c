/* For any processor. */
#define JLT_LANES 2
#define JLT_GAUSS_INSTANCE jlt_gauss_batch_baseline
#include "integrate/gauss_batch.inc"
