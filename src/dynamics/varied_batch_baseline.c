/* For any processor. */
#define JLT_LANES 2
#define JLT_VARIED_INSTANCE jlt_varied_batch_baseline
#include "dynamics/varied_batch.inc"
