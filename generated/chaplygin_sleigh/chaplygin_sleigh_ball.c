/* Chaplygin sleigh, reduced: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      chaplygin_sleigh, SHA-256 ec3ac26ab8d11f99820039e71c75f8fa4e5baadbfc9e16c62e3265d72db16166
 *  Command:    ttc generate --effort full --out DIR chaplygin_sleigh.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(15);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, x + 1, x + 1, prec);
    arb_mul(t + 3, params + 2, t + 2, prec);
    arb_mul(t + 5, params + 2, params + 0, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 8, x + 1, t + 7, prec);
    arb_mul(t + 10, params + 2, params + 2, prec);
    arb_mul(t + 11, params + 0, t + 10, prec);
    arb_add(t + 12, params + 1, t + 11, prec);
    arb_div(t + 13, t + 8, t + 12, prec);
    arb_neg(t + 14, t + 13);
    arb_set(out + 0, t + 3);
    arb_set(out + 1, t + 14);
    _arb_vec_clear(t, 15);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(19);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 2);
    arb_mul(t + 3, t + 1, params + 2, prec);
    arb_mul(t + 5, t + 3, x + 1, prec);
    arb_mul(t + 7, params + 2, params + 0, prec);
    arb_mul(t + 8, x + 1, t + 7, prec);
    arb_mul(t + 10, params + 2, params + 2, prec);
    arb_mul(t + 11, params + 0, t + 10, prec);
    arb_add(t + 12, params + 1, t + 11, prec);
    arb_div(t + 13, t + 8, t + 12, prec);
    arb_neg(t + 14, t + 13);
    arb_mul(t + 16, t + 7, x + 0, prec);
    arb_div(t + 17, t + 16, t + 12, prec);
    arb_neg(t + 18, t + 17);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 5);
    arb_set(out + 2, t + 14);
    arb_set(out + 3, t + 18);
    _arb_vec_clear(t, 19);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(11);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 0, params + 2, prec);
    arb_mul(t + 4, t + 2, x + 0, prec);
    arb_mul(t + 6, params + 2, params + 2, prec);
    arb_mul(t + 7, params + 0, t + 6, prec);
    arb_add(t + 8, params + 1, t + 7, prec);
    arb_div(t + 9, t + 4, t + 8, prec);
    arb_neg(t + 10, t + 9);
    arb_set(out + 0, t + 10);
    _arb_vec_clear(t, 11);
}

static const char *const general_integral[] = { "E", "speed", "turning" };

static void general_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(16);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, x + 0, x + 0, prec);
    arb_mul(t + 3, params + 0, t + 2, prec);
    jlt_ball_rational(t + 4, "1/2", prec);
    arb_mul(t + 5, t + 3, t + 4, prec);
    arb_mul(t + 7, x + 1, x + 1, prec);
    arb_mul(t + 10, params + 2, params + 2, prec);
    arb_mul(t + 11, params + 0, t + 10, prec);
    arb_add(t + 12, params + 1, t + 11, prec);
    arb_mul(t + 13, t + 7, t + 12, prec);
    arb_mul(t + 14, t + 4, t + 13, prec);
    arb_add(t + 15, t + 5, t + 14, prec);
    arb_set(out + 0, t + 15);
    arb_set(out + 1, x + 0);
    arb_set(out + 2, x + 1);
    _arb_vec_clear(t, 16);
}

static void general_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(12);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 0, x + 0, prec);
    arb_set_si(t + 5, 0);
    arb_mul(t + 8, params + 2, params + 2, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    arb_add(t + 10, params + 1, t + 9, prec);
    arb_mul(t + 11, x + 1, t + 10, prec);
    arb_set(out + 0, t + 3);
    arb_set(out + 1, t + 11);
    arb_set(out + 2, t + 0);
    arb_set(out + 3, t + 5);
    arb_set(out + 4, t + 5);
    arb_set(out + 5, t + 0);
    _arb_vec_clear(t, 12);
}

extern const jlt_ball_table jlt_balls_chaplygin_sleigh_general;
const jlt_ball_table jlt_balls_chaplygin_sleigh_general = {
    .model = "chaplygin_sleigh", .time = "", .elimination = "",
    .state_count = 2, .param_count = 3,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
    .integral_count = 3,
    .integral = general_integral,
    .integral_values = general_integral_values,
    .integral_gradients = general_integral_gradients,
};

