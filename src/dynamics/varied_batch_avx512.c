/* Compiled with AVX-512; run only where the processor has it. */
#define JLT_LANES 8
#define JLT_VARIED_INSTANCE jlt_varied_batch_avx512
#include "dynamics/varied_batch.inc"
