/* Planar circular restricted three-body problem: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      restricted_three_body, SHA-256 be92c80fa5ae653bcafd1a9f9b49cfb47d443deafac9921503338276e0a9706f
 *  Command:    ttc generate --effort full --out DIR restricted_three_body.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(37);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 3, 2);
    arb_mul(t + 4, x + 3, t + 3, prec);
    arb_add(t + 5, x + 0, t + 4, prec);
    arb_set_si(t + 7, -1);
    arb_add(t + 8, params + 0, t + 7, prec);
    arb_add(t + 9, x + 0, t + 8, prec);
    arb_mul(t + 10, params + 0, t + 9, prec);
    arb_mul(t + 12, x + 1, x + 1, prec);
    arb_mul(t + 13, t + 9, t + 9, prec);
    arb_add(t + 14, t + 12, t + 13, prec);
    arb_sqrt(t + 15, t + 14, prec); /* r2 */
    arb_mul(t + 16, t + 15, t + 15, prec);
    arb_mul(t + 17, t + 15, t + 16, prec);
    arb_div(t + 18, t + 10, t + 17, prec);
    arb_sub(t + 19, t + 5, t + 18, prec);
    arb_add(t + 20, x + 0, params + 0, prec);
    arb_mul(t + 21, t + 20, t + 20, prec);
    arb_add(t + 22, t + 12, t + 21, prec);
    arb_sqrt(t + 23, t + 22, prec); /* r1 */
    arb_mul(t + 24, t + 23, t + 23, prec);
    arb_mul(t + 25, t + 23, t + 24, prec);
    arb_mul(t + 26, t + 8, t + 20, prec);
    arb_div(t + 27, t + 26, t + 25, prec);
    arb_add(t + 28, t + 19, t + 27, prec);
    arb_mul(t + 29, x + 2, t + 3, prec);
    arb_sub(t + 30, x + 1, t + 29, prec);
    arb_mul(t + 31, params + 0, x + 1, prec);
    arb_div(t + 32, t + 31, t + 17, prec);
    arb_sub(t + 33, t + 30, t + 32, prec);
    arb_mul(t + 34, t + 8, x + 1, prec);
    arb_div(t + 35, t + 34, t + 25, prec);
    arb_add(t + 36, t + 33, t + 35, prec);
    arb_set(out + 0, x + 2);
    arb_set(out + 1, x + 3);
    arb_set(out + 2, t + 28);
    arb_set(out + 3, t + 36);
    _arb_vec_clear(t, 37);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(57);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, x + 1, x + 1, prec);
    arb_set_si(t + 5, -1);
    arb_add(t + 6, params + 0, t + 5, prec);
    arb_add(t + 8, t + 6, x + 0, prec);
    arb_mul(t + 9, t + 8, t + 8, prec);
    arb_add(t + 10, t + 4, t + 9, prec);
    arb_sqrt(t + 11, t + 10, prec); /* r2 */
    arb_mul(t + 12, t + 11, t + 11, prec);
    arb_mul(t + 13, t + 11, t + 12, prec);
    arb_div(t + 14, params + 0, t + 13, prec);
    arb_sub(t + 15, t + 1, t + 14, prec);
    arb_mul(t + 16, params + 0, t + 9, prec);
    arb_mul(t + 17, t + 12, t + 12, prec);
    arb_mul(t + 18, t + 11, t + 17, prec);
    arb_div(t + 19, t + 16, t + 18, prec);
    arb_set_si(t + 20, 3);
    arb_mul(t + 21, t + 19, t + 20, prec);
    arb_add(t + 22, t + 15, t + 21, prec);
    arb_add(t + 23, params + 0, x + 0, prec);
    arb_mul(t + 24, t + 23, t + 23, prec);
    arb_add(t + 25, t + 4, t + 24, prec);
    arb_sqrt(t + 26, t + 25, prec); /* r1 */
    arb_mul(t + 27, t + 26, t + 26, prec);
    arb_mul(t + 28, t + 26, t + 27, prec);
    arb_div(t + 29, t + 6, t + 28, prec);
    arb_add(t + 30, t + 22, t + 29, prec);
    arb_mul(t + 31, t + 27, t + 27, prec);
    arb_mul(t + 32, t + 26, t + 31, prec);
    arb_mul(t + 33, t + 6, t + 24, prec);
    arb_div(t + 34, t + 33, t + 32, prec);
    arb_mul(t + 35, t + 20, t + 34, prec);
    arb_sub(t + 36, t + 30, t + 35, prec);
    arb_mul(t + 37, params + 0, x + 1, prec);
    arb_mul(t + 38, t + 8, t + 37, prec);
    arb_div(t + 39, t + 38, t + 18, prec);
    arb_mul(t + 40, t + 20, t + 39, prec);
    arb_mul(t + 41, x + 1, t + 23, prec);
    arb_mul(t + 42, t + 6, t + 41, prec);
    arb_div(t + 43, t + 42, t + 32, prec);
    arb_mul(t + 44, t + 20, t + 43, prec);
    arb_sub(t + 45, t + 40, t + 44, prec);
    arb_set_si(t + 46, 2);
    arb_add(t + 47, t + 15, t + 29, prec);
    arb_mul(t + 48, params + 0, t + 4, prec);
    arb_div(t + 49, t + 48, t + 18, prec);
    arb_mul(t + 50, t + 20, t + 49, prec);
    arb_add(t + 51, t + 47, t + 50, prec);
    arb_mul(t + 52, t + 4, t + 6, prec);
    arb_div(t + 53, t + 52, t + 32, prec);
    arb_mul(t + 54, t + 20, t + 53, prec);
    arb_sub(t + 55, t + 51, t + 54, prec);
    arb_set_si(t + 56, -2);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 0);
    arb_set(out + 2, t + 1);
    arb_set(out + 3, t + 0);
    arb_set(out + 4, t + 0);
    arb_set(out + 5, t + 0);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 1);
    arb_set(out + 8, t + 36);
    arb_set(out + 9, t + 45);
    arb_set(out + 10, t + 0);
    arb_set(out + 11, t + 46);
    arb_set(out + 12, t + 45);
    arb_set(out + 13, t + 55);
    arb_set(out + 14, t + 56);
    arb_set(out + 15, t + 0);
    _arb_vec_clear(t, 57);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(1);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set(out + 0, t + 0);
    _arb_vec_clear(t, 1);
}

static const char *const general_integral[] = { "jacobi" };

static void general_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(31);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 1, x + 1, x + 1, prec);
    jlt_ball_rational(t + 2, "1/2", prec);
    arb_mul(t + 3, t + 1, t + 2, prec);
    arb_mul(t + 5, x + 2, x + 2, prec);
    arb_mul(t + 6, t + 2, t + 5, prec);
    arb_sub(t + 7, t + 6, t + 3, prec);
    arb_mul(t + 9, x + 3, x + 3, prec);
    arb_mul(t + 10, t + 2, t + 9, prec);
    arb_add(t + 11, t + 7, t + 10, prec);
    arb_mul(t + 13, x + 0, x + 0, prec);
    arb_mul(t + 14, t + 2, t + 13, prec);
    arb_sub(t + 15, t + 11, t + 14, prec);
    arb_set_si(t + 17, -1);
    arb_add(t + 18, params + 0, t + 17, prec);
    arb_add(t + 19, x + 0, t + 18, prec);
    arb_mul(t + 20, t + 19, t + 19, prec);
    arb_add(t + 21, t + 1, t + 20, prec);
    arb_sqrt(t + 22, t + 21, prec); /* r2 */
    arb_div(t + 23, params + 0, t + 22, prec);
    arb_sub(t + 24, t + 15, t + 23, prec);
    arb_add(t + 25, x + 0, params + 0, prec);
    arb_mul(t + 26, t + 25, t + 25, prec);
    arb_add(t + 27, t + 1, t + 26, prec);
    arb_sqrt(t + 28, t + 27, prec); /* r1 */
    arb_div(t + 29, t + 18, t + 28, prec);
    arb_add(t + 30, t + 24, t + 29, prec);
    arb_set(out + 0, t + 30);
    _arb_vec_clear(t, 31);
}

static void general_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(32);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 2, -1);
    arb_add(t + 3, params + 0, t + 2, prec);
    arb_add(t + 4, x + 0, t + 3, prec);
    arb_mul(t + 5, params + 0, t + 4, prec);
    arb_mul(t + 7, x + 1, x + 1, prec);
    arb_mul(t + 8, t + 4, t + 4, prec);
    arb_add(t + 9, t + 7, t + 8, prec);
    arb_sqrt(t + 10, t + 9, prec); /* r2 */
    arb_mul(t + 11, t + 10, t + 10, prec);
    arb_mul(t + 12, t + 10, t + 11, prec);
    arb_div(t + 13, t + 5, t + 12, prec);
    arb_sub(t + 14, t + 13, x + 0, prec);
    arb_add(t + 15, x + 0, params + 0, prec);
    arb_mul(t + 16, t + 15, t + 15, prec);
    arb_add(t + 17, t + 7, t + 16, prec);
    arb_sqrt(t + 18, t + 17, prec); /* r1 */
    arb_mul(t + 19, t + 18, t + 18, prec);
    arb_mul(t + 20, t + 18, t + 19, prec);
    arb_mul(t + 21, t + 3, t + 15, prec);
    arb_div(t + 22, t + 21, t + 20, prec);
    arb_sub(t + 23, t + 14, t + 22, prec);
    arb_mul(t + 24, params + 0, x + 1, prec);
    arb_div(t + 25, t + 24, t + 12, prec);
    arb_sub(t + 26, t + 25, x + 1, prec);
    arb_mul(t + 27, t + 3, x + 1, prec);
    arb_div(t + 28, t + 27, t + 20, prec);
    arb_sub(t + 29, t + 26, t + 28, prec);
    arb_set(out + 0, t + 23);
    arb_set(out + 1, t + 29);
    arb_set(out + 2, x + 2);
    arb_set(out + 3, x + 3);
    _arb_vec_clear(t, 32);
}

extern const jlt_ball_table jlt_balls_restricted_three_body_general;
const jlt_ball_table jlt_balls_restricted_three_body_general = {
    .model = "restricted_three_body", .time = "", .elimination = "",
    .state_count = 4, .param_count = 1,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
    .integral_count = 1,
    .integral = general_integral,
    .integral_values = general_integral_values,
    .integral_gradients = general_integral_gradients,
};

