/* Lotka-Volterra equations: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      lotka_volterra, SHA-256 74bd0797ba37376d0028cd3ec35e564e70e4bcb97d50e051e73f40b6925219f8
 *  Command:    ttc generate --effort full --out DIR lotka_volterra.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(12);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 4, params + 1, x + 1, prec);
    arb_sub(t + 5, params + 0, t + 4, prec); /* g */
    arb_mul(t + 6, x + 0, t + 5, prec);
    arb_mul(t + 9, x + 0, params + 3, prec);
    arb_sub(t + 10, t + 9, params + 2, prec); /* h */
    arb_mul(t + 11, x + 1, t + 10, prec);
    arb_set(out + 0, t + 6);
    arb_set(out + 1, t + 11);
    _arb_vec_clear(t, 12);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(13);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 3, params + 1, x + 1, prec);
    arb_sub(t + 4, params + 0, t + 3, prec); /* g */
    arb_mul(t + 6, params + 1, x + 0, prec);
    arb_neg(t + 7, t + 6);
    arb_mul(t + 9, x + 1, params + 3, prec);
    arb_mul(t + 11, x + 0, params + 3, prec);
    arb_sub(t + 12, t + 11, params + 2, prec); /* h */
    arb_set(out + 0, t + 4);
    arb_set(out + 1, t + 7);
    arb_set(out + 2, t + 9);
    arb_set(out + 3, t + 12);
    _arb_vec_clear(t, 13);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(11);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 3, params + 1, x + 1, prec);
    arb_sub(t + 4, params + 0, t + 3, prec); /* g */
    arb_mul(t + 8, params + 3, x + 0, prec);
    arb_sub(t + 9, t + 8, params + 2, prec); /* h */
    arb_add(t + 10, t + 4, t + 9, prec);
    arb_set(out + 0, t + 10);
    _arb_vec_clear(t, 11);
}

static const char *const general_integral[] = { "H" };

static void general_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(15);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 1, x + 1, prec);
    arb_mul(t + 5, params + 3, x + 0, prec);
    arb_add(t + 6, t + 2, t + 5, prec);
    arb_log(t + 8, x + 0, prec); /* u */
    arb_mul(t + 9, params + 2, t + 8, prec);
    arb_sub(t + 10, t + 6, t + 9, prec);
    arb_log(t + 12, x + 1, prec); /* v */
    arb_mul(t + 13, params + 0, t + 12, prec);
    arb_sub(t + 14, t + 10, t + 13, prec);
    arb_set(out + 0, t + 14);
    _arb_vec_clear(t, 15);
}

static void general_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(10);
    (void)x;
    (void)params;
    (void)prec;
    arb_div(t + 3, params + 2, x + 0, prec);
    arb_sub(t + 4, params + 3, t + 3, prec);
    arb_div(t + 8, params + 0, x + 1, prec);
    arb_sub(t + 9, params + 1, t + 8, prec);
    arb_set(out + 0, t + 4);
    arb_set(out + 1, t + 9);
    _arb_vec_clear(t, 10);
}

extern const jlt_ball_table jlt_balls_lotka_volterra_general;
const jlt_ball_table jlt_balls_lotka_volterra_general = {
    .model = "lotka_volterra", .time = "", .elimination = "",
    .state_count = 2, .param_count = 4,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
    .integral_count = 1,
    .integral = general_integral,
    .integral_values = general_integral_values,
    .integral_gradients = general_integral_gradients,
};

