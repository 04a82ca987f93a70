/* Batched kernels of toda for avx512. Written by ttc 0.1.0; do not edit. */
#define JLT_LANES 8
#define JLT_BATCH_ISA "avx512"
#define JLT_BATCH_NAME(name) name##_avx512

#include "kernel_abi.h"
#include "lanes.h"
#include "kernel_jet.h"

#include "general_lanes.inc"
