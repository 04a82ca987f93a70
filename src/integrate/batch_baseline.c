/* For any processor. */
#define JLT_LANES 2
#define JLT_BATCH_INSTANCE jlt_batch_lanes_baseline
#include "integrate/batch_lanes.inc"
