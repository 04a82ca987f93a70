/* Compiled with AVX-512; run only where the processor has it. */
#define JLT_LANES 8
#define JLT_BATCH_INSTANCE jlt_batch_lanes_avx512
#include "integrate/batch_lanes.inc"
