/* Compiled with AVX2 and FMA; run only where the processor has it. */
#define JLT_LANES 4
#define JLT_VARIED_INSTANCE jlt_varied_batch_avx2
#include "dynamics/varied_batch.inc"
