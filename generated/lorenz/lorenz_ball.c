/* Lorenz's system: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      lorenz, SHA-256 2bab2d4fa634a7604b4f84d1f7fa912ed0fa8a5e4b51edfb0e1f1ce7cb60d449
 *  Command:    ttc generate --effort full --out DIR lorenz.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(16);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 0, x + 0, prec);
    arb_mul(t + 4, params + 0, x + 1, prec);
    arb_sub(t + 5, t + 4, t + 2, prec);
    arb_mul(t + 7, x + 0, params + 1, prec);
    arb_sub(t + 8, t + 7, x + 1, prec);
    arb_mul(t + 10, x + 0, x + 2, prec);
    arb_sub(t + 11, t + 8, t + 10, prec);
    arb_mul(t + 12, x + 0, x + 1, prec);
    arb_mul(t + 14, x + 2, params + 2, prec);
    arb_sub(t + 15, t + 12, t + 14, prec);
    arb_set(out + 0, t + 5);
    arb_set(out + 1, t + 11);
    arb_set(out + 2, t + 15);
    _arb_vec_clear(t, 16);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(12);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, -1);
    arb_neg(t + 2, params + 0);
    arb_set_si(t + 3, 0);
    arb_sub(t + 6, params + 1, x + 2, prec);
    arb_neg(t + 8, x + 0);
    arb_neg(t + 11, params + 2);
    arb_set(out + 0, t + 2);
    arb_set(out + 1, params + 0);
    arb_set(out + 2, t + 3);
    arb_set(out + 3, t + 6);
    arb_set(out + 4, t + 0);
    arb_set(out + 5, t + 8);
    arb_set(out + 6, x + 1);
    arb_set(out + 7, x + 0);
    arb_set(out + 8, t + 11);
    _arb_vec_clear(t, 12);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(5);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, -1);
    arb_sub(t + 2, t + 0, params + 0, prec);
    arb_sub(t + 4, t + 2, params + 2, prec);
    arb_set(out + 0, t + 4);
    _arb_vec_clear(t, 5);
}

extern const jlt_ball_table jlt_balls_lorenz_general;
const jlt_ball_table jlt_balls_lorenz_general = {
    .model = "lorenz", .time = "", .elimination = "",
    .state_count = 3, .param_count = 3,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
};

