/* Compiled with AVX2 and FMA; run only where the processor has them. */
#define JLT_LANES 4
#define JLT_BATCH_INSTANCE jlt_batch_lanes_avx2
#include "integrate/batch_lanes.inc"
