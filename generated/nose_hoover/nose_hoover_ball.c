/* Nose-Hoover oscillator: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      nose_hoover, SHA-256 0e94aea4c9b2928c9741d0c1ca85c73ce0d4c8f4262b18320c66e53d04de6370
 *  Command:    ttc generate --effort full --out DIR nose_hoover.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(11);
    (void)x;
    (void)params;
    (void)prec;
    arb_neg(t + 2, x + 0);
    arb_mul(t + 4, x + 1, x + 2, prec);
    arb_sub(t + 5, t + 2, t + 4, prec);
    arb_mul(t + 8, x + 1, x + 1, prec);
    arb_sub(t + 9, t + 8, params + 0, prec);
    arb_div(t + 10, t + 9, params + 1, prec);
    arb_set(out + 0, x + 1);
    arb_set(out + 1, t + 5);
    arb_set(out + 2, t + 10);
    _arb_vec_clear(t, 11);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(11);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_set_si(t + 2, -1);
    arb_neg(t + 4, x + 2);
    arb_neg(t + 6, x + 1);
    arb_set_si(t + 7, 2);
    arb_mul(t + 9, x + 1, t + 7, prec);
    arb_div(t + 10, t + 9, params + 1, prec);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 1);
    arb_set(out + 2, t + 0);
    arb_set(out + 3, t + 2);
    arb_set(out + 4, t + 4);
    arb_set(out + 5, t + 6);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 10);
    arb_set(out + 8, t + 0);
    _arb_vec_clear(t, 11);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(2);
    (void)x;
    (void)params;
    (void)prec;
    arb_neg(t + 1, x + 2);
    arb_set(out + 0, t + 1);
    _arb_vec_clear(t, 2);
}

extern const jlt_ball_table jlt_balls_nose_hoover_general;
const jlt_ball_table jlt_balls_nose_hoover_general = {
    .model = "nose_hoover", .time = "", .elimination = "",
    .state_count = 3, .param_count = 2,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
};

