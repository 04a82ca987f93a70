/* Compiled with AVX-512; run only where the processor has it. */
#define JLT_LANES 8
#define JLT_GAUSS_INSTANCE jlt_gauss_batch_avx512
#include "integrate/gauss_batch.inc"
