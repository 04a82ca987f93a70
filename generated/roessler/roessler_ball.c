/* Roessler's system: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      roessler, SHA-256 7d2f97bb2c6d3f82c3ce5d0578ec3d5df1852a1298f7e68780337a2d6518941e
 *  Command:    ttc generate --effort full --out DIR roessler.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(14);
    (void)x;
    (void)params;
    (void)prec;
    arb_neg(t + 1, x + 1);
    arb_sub(t + 3, t + 1, x + 2, prec);
    arb_mul(t + 6, x + 1, params + 0, prec);
    arb_add(t + 7, x + 0, t + 6, prec);
    arb_mul(t + 9, x + 2, x + 0, prec);
    arb_add(t + 10, params + 1, t + 9, prec);
    arb_mul(t + 12, x + 2, params + 2, prec);
    arb_sub(t + 13, t + 10, t + 12, prec);
    arb_set(out + 0, t + 3);
    arb_set(out + 1, t + 7);
    arb_set(out + 2, t + 13);
    _arb_vec_clear(t, 14);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(8);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, -1);
    arb_set_si(t + 2, 1);
    arb_sub(t + 7, x + 0, params + 2, prec);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 1);
    arb_set(out + 2, t + 1);
    arb_set(out + 3, t + 2);
    arb_set(out + 4, params + 0);
    arb_set(out + 5, t + 0);
    arb_set(out + 6, x + 2);
    arb_set(out + 7, t + 0);
    arb_set(out + 8, t + 7);
    _arb_vec_clear(t, 8);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(5);
    (void)x;
    (void)params;
    (void)prec;
    arb_sub(t + 2, params + 0, params + 2, prec);
    arb_add(t + 4, t + 2, x + 0, prec);
    arb_set(out + 0, t + 4);
    _arb_vec_clear(t, 5);
}

extern const jlt_ball_table jlt_balls_roessler_general;
const jlt_ball_table jlt_balls_roessler_general = {
    .model = "roessler", .time = "", .elimination = "",
    .state_count = 3, .param_count = 3,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
};

