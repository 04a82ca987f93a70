/* Batched kernels of nose_hoover for avx2. Written by ttc 0.1.0; do not edit. */
#define JLT_LANES 4
#define JLT_BATCH_ISA "avx2"
#define JLT_BATCH_NAME(name) name##_avx2

#include "kernel_abi.h"
#include "lanes.h"
#include "kernel_jet.h"

#include "general_lanes.inc"
