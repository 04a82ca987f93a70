/* Compiled with AVX2 and FMA; run only where the processor has it. */
#define JLT_LANES 4
#define JLT_GAUSS_INSTANCE jlt_gauss_batch_avx2
#include "integrate/gauss_batch.inc"
