/* Batched kernels of nose_hoover for baseline. Written by ttc 0.1.0; do not edit. */
#define JLT_LANES 2
#define JLT_BATCH_ISA "baseline"
#define JLT_BATCH_NAME(name) name##_baseline

#include "kernel_abi.h"
#include "lanes.h"
#include "kernel_jet.h"

#include "general_lanes.inc"
