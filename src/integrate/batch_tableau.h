/** DOP853 as lists for the batched stages: which earlier slopes enter a stage, and with what weights. Zeros are left out. */
#ifndef JLT_INTEGRATE_BATCH_TABLEAU_H
#define JLT_INTEGRATE_BATCH_TABLEAU_H

#include "integrate/dop853_coefficients.h"

enum { JLT_BATCH_STAGES = 13 }; /* slopes k[0] .. k[11], and k[12] at the end of the step, which is the next step's k[0] */

typedef struct {
    unsigned count;
    unsigned char slope[12]; /* index of k */
    double weight[12];
} jlt_batch_sum;

/* Sum i gives the argument of slope i; the last one is the solution of order 8. */
static const jlt_batch_sum jlt_batch_stage[JLT_BATCH_STAGES] = {
    { 0, { 0 }, { 0 } },
    { 1, { 0 }, { DOP_A_2_1 } },
    { 2, { 0, 1 }, { DOP_A_3_1, DOP_A_3_2 } },
    { 2, { 0, 2 }, { DOP_A_4_1, DOP_A_4_3 } },
    { 3, { 0, 2, 3 }, { DOP_A_5_1, DOP_A_5_3, DOP_A_5_4 } },
    { 3, { 0, 3, 4 }, { DOP_A_6_1, DOP_A_6_4, DOP_A_6_5 } },
    { 4, { 0, 3, 4, 5 }, { DOP_A_7_1, DOP_A_7_4, DOP_A_7_5, DOP_A_7_6 } },
    { 5, { 0, 3, 4, 5, 6 }, { DOP_A_8_1, DOP_A_8_4, DOP_A_8_5, DOP_A_8_6, DOP_A_8_7 } },
    { 6, { 0, 3, 4, 5, 6, 7 }, { DOP_A_9_1, DOP_A_9_4, DOP_A_9_5, DOP_A_9_6, DOP_A_9_7, DOP_A_9_8 } },
    { 7,
      { 0, 3, 4, 5, 6, 7, 8 },
      { DOP_A_10_1, DOP_A_10_4, DOP_A_10_5, DOP_A_10_6, DOP_A_10_7, DOP_A_10_8, DOP_A_10_9 } },
    { 8,
      { 0, 3, 4, 5, 6, 7, 8, 9 },
      { DOP_A_11_1, DOP_A_11_4, DOP_A_11_5, DOP_A_11_6, DOP_A_11_7, DOP_A_11_8, DOP_A_11_9, DOP_A_11_10 } },
    { 9,
      { 0, 3, 4, 5, 6, 7, 8, 9, 10 },
      { DOP_A_12_1, DOP_A_12_4, DOP_A_12_5, DOP_A_12_6, DOP_A_12_7, DOP_A_12_8, DOP_A_12_9, DOP_A_12_10,
        DOP_A_12_11 } },
    { 8,
      { 0, 5, 6, 7, 8, 9, 10, 11 },
      { DOP_A_13_1, DOP_A_13_6, DOP_A_13_7, DOP_A_13_8, DOP_A_13_9, DOP_A_13_10, DOP_A_13_11, DOP_A_13_12 } },
};

/* Both error estimates are sums over the same slopes. */
static const jlt_batch_sum jlt_batch_error5 = {
    8,
    { 0, 5, 6, 7, 8, 9, 10, 11 },
    { DOP_E5_1, DOP_E5_6, DOP_E5_7, DOP_E5_8, DOP_E5_9, DOP_E5_10, DOP_E5_11, DOP_E5_12 },
};
static const double jlt_batch_error3[8] = { DOP_E3_1, DOP_E3_6,  DOP_E3_7,  DOP_E3_8,
                                            DOP_E3_9, DOP_E3_10, DOP_E3_11, DOP_E3_12 };

#endif
