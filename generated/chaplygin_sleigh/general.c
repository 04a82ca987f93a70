/* Chaplygin sleigh, reduced
 *
 *  Source:     S. A. Chaplygin, On the theory of motion of nonholonomic systems. The reducing-multiplier theorem, Mat. Sb. 28 (1911) 303-314; English translation: Regul. Chaotic Dyn. 13 (2008) 369-376
 *  Table:      chaplygin_sleigh, SHA-256 ec3ac26ab8d11f99820039e71c75f8fa4e5baadbfc9e16c62e3265d72db16166
 *  Command:    ttc generate --out DIR chaplygin_sleigh.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1    5    0    1    0    0      5    2   (10)
 *  jacobian            2    5    0    2    0    0      4    3   (16)
 *  rhs_jacobian        3    8    0    3    0    0      5    4   (26)
 *  divergence          1    2    0    1    0    0      4    2   (7)
 *  integral_values     1    6    0    0    0    0      4    3   (10)
 *  integral_gradients  0    2    0    0    0    0      1    1   (5)
 *
 *  Accuracy: no denominator or radicand of the field vanishes in the domain.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_chaplygin_sleigh[];
extern const jlt_descriptor jlt_kernels_chaplygin_sleigh_general;
extern const jlt_kernel_batch jlt_batch_chaplygin_sleigh_general_baseline;
extern const jlt_kernel_batch jlt_batch_chaplygin_sleigh_general_avx2;
extern const jlt_kernel_batch jlt_batch_chaplygin_sleigh_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    const double t0 = params[2]*params[2]; /* a*a */
    const double t1 = params[0]*t0; /* m*a*a */
    const double t2 = params[1] + t1; /* I + m*a*a */
    out[3] = t2;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* w*w */
    const double t1 = p[2]*t0; /* a*w*w */
    const double t2 = p[2]*p[0]; /* a*m */
    const double t3 = t2*x[0]; /* a*m*v */
    const double t4 = x[1]*t3; /* w*a*m*v */
    const double t5 = t4/p[3]; /* w*a*m*v/(I + m*a^2) */
    const double t6 = -t5; /* -w*a*m*v/(I + m*a^2) */
    out[0] = t1;
    out[1] = t6;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 2.0*p[2]; /* 2*a */
    const double t1 = t0*x[1]; /* 2*a*w */
    const double t2 = p[2]*p[0]; /* a*m */
    const double t3 = x[1]*t2; /* w*a*m */
    const double t4 = t3/p[3]; /* w*a*m/(I + m*a^2) */
    const double t5 = -t4; /* -w*a*m/(I + m*a^2) */
    const double t6 = t2*x[0]; /* a*m*v */
    const double t7 = t6/p[3]; /* a*m*v/(I + m*a^2) */
    const double t8 = -t7; /* -a*m*v/(I + m*a^2) */
    out[0] = 0.0;
    out[1] = t1;
    out[2] = t5;
    out[3] = t8;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* w*w */
    const double t1 = p[2]*t0; /* a*w*w */
    const double t2 = p[2]*p[0]; /* a*m */
    const double t3 = t2*x[0]; /* a*m*v */
    const double t4 = x[1]*t3; /* w*a*m*v */
    const double t5 = t4/p[3]; /* w*a*m*v/(I + m*a^2) */
    const double t6 = -t5; /* -w*a*m*v/(I + m*a^2) */
    const double t7 = p[2]*2.0; /* a*2 */
    const double t8 = x[1]*t7; /* w*a*2 */
    const double t9 = x[1]*t2; /* w*a*m */
    const double t10 = t9/p[3]; /* w*a*m/(I + m*a^2) */
    const double t11 = -t10; /* -w*a*m/(I + m*a^2) */
    const double t12 = t3/p[3]; /* a*m*v/(I + m*a^2) */
    const double t13 = -t12; /* -a*m*v/(I + m*a^2) */
    out[0] = t1;
    out[1] = t6;
    out[2] = 0.0;
    out[3] = t8;
    out[4] = t11;
    out[5] = t13;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[2]; /* m*a */
    const double t1 = t0*x[0]; /* m*a*v */
    const double t2 = t1/p[3]; /* m*a*v/(I + m*a^2) */
    const double t3 = -t2; /* -m*a*v/(I + m*a^2) */
    out[0] = t3;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* v*v */
    const double t1 = p[0]*t0; /* m*v*v */
    const double t2 = t1*(1.0 / 2.0); /* m*v*v*1/2 */
    const double t3 = x[1]*x[1]; /* w*w */
    const double t4 = t3*p[3]; /* w*w*(I + m*a^2) */
    const double t5 = (1.0 / 2.0)*t4; /* 1/2*w*w*(I + m*a^2) */
    const double t6 = t2 + t5; /* m*v*v*1/2 + 1/2*w*w*(I + m*a^2) */
    out[0] = t6;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[0]; /* m*v */
    const double t1 = x[1]*p[3]; /* w*(I + m*a^2) */
    out[0] = t0;
    out[1] = t1;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double v_a = params[2];
    const double complex v_w = x[1];
    out[0] = (v_a*v_w*v_w);
    const double v_m = params[0];
    const double complex v_v = x[0];
    const double v_I = params[1];
    out[1] = (-v_m*v_a*v_v*v_w/(v_I + v_m*v_a*v_a));
}

static const unsigned char family0_is_free[] = { 1, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 0.0;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*a */
    const double t1 = t0*x[0]; /* m*a*v */
    const double t2 = params[2]*params[2]; /* a*a */
    const double t3 = params[0]*t2; /* m*a*a */
    const double t4 = params[1] + t3; /* I + m*a*a */
    const double t5 = t1/t4; /* m*a*v/(I + m*a*a) */
    const double t6 = -t5; /* -m*a*v/(I + m*a*a) */
    out[0] = t6;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[2]*params[2]; /* a*a */
    const double t1 = params[0]*t0; /* m*a*a */
    const double t2 = params[1] + t1; /* I + m*a*a */
    const double t3 = params[0]*params[2]; /* m*a */
    const double t4 = t3*x[0]; /* m*a*v */
    out[0] = t2;
    out[1] = t4;
    out[2] = 0.0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*a */
    const double t1 = t0*x[0]; /* m*a*v */
    const double t2 = params[2]*params[2]; /* a*a */
    const double t3 = params[0]*t2; /* m*a*a */
    const double t4 = params[1] + t3; /* I + m*a*a */
    const double t5 = t1/t4; /* m*a*v/(I + m*a*a) */
    const double t6 = -t5; /* -m*a*v/(I + m*a*a) */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = t6;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*x[0]; /* m*v */
    out[0] = t0;
    out[1] = 0.0;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "straight", .condition = "",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .charpoly = family0_charpoly,
      .matrix = family0_matrix,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 1, .obstructs = 1 },
};

static const jlt_quantity states[] = {
    { "v", "m/s", "speed along the blade", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "w", "1/s", "angular velocity", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "I", "kg m^2", "moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "a", "m", "distance of the centre of mass from the blade", -INFINITY, INFINITY, JLT_ANY_SIGN, 1.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

const jlt_descriptor jlt_kernels_chaplygin_sleigh_general = {
    .model = "chaplygin_sleigh",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Chaplygin sleigh, reduced",
    .source = "S. A. Chaplygin, On the theory of motion of nonholonomic systems. The reducing-multiplier theorem, Mat. Sb. 28 (1911) 303-314; English translation: Regul. Chaotic Dyn. 13 (2008) 369-376",
    .sha256 = "ec3ac26ab8d11f99820039e71c75f8fa4e5baadbfc9e16c62e3265d72db16166",
    .generator = "ttc 0.1.0",
    .table = jlt_table_chaplygin_sleigh,
    .state_count = 2, .param_count = 3, .block_count = 4,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 2, { 1, 5, 0, 1, 0, 0, 5, 2 }, { 2, 7, 0, 1, 0, 0, 5, 3 },
        "" },
    .jacobian = { jacobian, 4, { 2, 5, 0, 2, 0, 0, 4, 3 }, { 4, 10, 0, 2, 0, 0, 5, 3 },
        "" },
    .rhs_jacobian = { rhs_jacobian, 6, { 3, 8, 0, 3, 0, 0, 5, 4 }, { 6, 17, 0, 3, 0, 0, 5, 3 },
        "" },
    .divergence = { divergence, 1, { 1, 2, 0, 1, 0, 0, 4, 2 }, { 2, 4, 0, 1, 0, 0, 5, 3 },
        "" },
    .integral_values = { integral_values, 1, { 1, 6, 0, 0, 0, 0, 4, 3 }, { 2, 8, 0, 0, 0, 0, 6, 4 },
        "" },
    .integral_gradients = { integral_gradients, 2, { 0, 2, 0, 0, 0, 0, 1, 1 }, { 1, 4, 0, 0, 0, 0, 4, 2 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_chaplygin_sleigh_general_baseline,
        &jlt_batch_chaplygin_sleigh_general_avx2,
        &jlt_batch_chaplygin_sleigh_general_avx512,
    },
};
