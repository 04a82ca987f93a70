/* Planar circular restricted three-body problem: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      restricted_three_body, SHA-256 017960417ce52ac6d13353d2df86ff7087a859bc4561af33819612295b6a3ea7
 *  Command:    ttc generate --out DIR restricted_three_body.tt (ttc 0.1.0); do not edit
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
    arb_ptr t = _arb_vec_init(75);
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
    arb_mul(t + 16, params + 0, t + 8, prec);
    arb_mul(t + 17, t + 12, t + 12, prec);
    arb_div(t + 18, params + 0, t + 11, prec);
    arb_div(t + 19, t + 1, t + 11, prec);
    arb_sub(t + 20, t + 18, t + 19, prec);
    arb_div(t + 21, x + 0, t + 11, prec);
    arb_add(t + 22, t + 20, t + 21, prec);
    arb_mul(t + 23, t + 16, t + 22, prec);
    arb_div(t + 24, t + 23, t + 17, prec);
    arb_set_si(t + 25, 3);
    arb_mul(t + 26, t + 24, t + 25, prec);
    arb_add(t + 27, t + 15, t + 26, prec);
    arb_add(t + 28, params + 0, x + 0, prec);
    arb_mul(t + 29, t + 28, t + 28, prec);
    arb_add(t + 30, t + 4, t + 29, prec);
    arb_sqrt(t + 31, t + 30, prec); /* r1 */
    arb_mul(t + 32, t + 31, t + 31, prec);
    arb_mul(t + 33, t + 31, t + 32, prec);
    arb_div(t + 34, t + 6, t + 33, prec);
    arb_add(t + 35, t + 27, t + 34, prec);
    arb_mul(t + 36, t + 32, t + 32, prec);
    arb_mul(t + 37, t + 6, t + 28, prec);
    arb_div(t + 38, params + 0, t + 31, prec);
    arb_div(t + 39, x + 0, t + 31, prec);
    arb_add(t + 40, t + 38, t + 39, prec);
    arb_mul(t + 41, t + 37, t + 40, prec);
    arb_div(t + 42, t + 41, t + 36, prec);
    arb_mul(t + 43, t + 25, t + 42, prec);
    arb_sub(t + 44, t + 35, t + 43, prec);
    arb_mul(t + 45, params + 0, x + 1, prec);
    arb_mul(t + 46, t + 8, t + 45, prec);
    arb_mul(t + 47, t + 11, t + 17, prec);
    arb_div(t + 48, t + 46, t + 47, prec);
    arb_mul(t + 49, t + 25, t + 48, prec);
    arb_mul(t + 50, x + 1, t + 28, prec);
    arb_mul(t + 51, t + 31, t + 36, prec);
    arb_mul(t + 52, t + 6, t + 50, prec);
    arb_div(t + 53, t + 52, t + 51, prec);
    arb_mul(t + 54, t + 25, t + 53, prec);
    arb_sub(t + 55, t + 49, t + 54, prec);
    arb_set_si(t + 56, 2);
    arb_mul(t + 57, t + 22, t + 45, prec);
    arb_div(t + 58, t + 57, t + 17, prec);
    arb_mul(t + 59, t + 25, t + 58, prec);
    arb_mul(t + 60, x + 1, t + 6, prec);
    arb_mul(t + 61, t + 40, t + 60, prec);
    arb_div(t + 62, t + 61, t + 36, prec);
    arb_mul(t + 63, t + 25, t + 62, prec);
    arb_sub(t + 64, t + 59, t + 63, prec);
    arb_add(t + 65, t + 15, t + 34, prec);
    arb_mul(t + 66, params + 0, t + 4, prec);
    arb_div(t + 67, t + 66, t + 47, prec);
    arb_mul(t + 68, t + 25, t + 67, prec);
    arb_add(t + 69, t + 65, t + 68, prec);
    arb_mul(t + 70, t + 4, t + 6, prec);
    arb_div(t + 71, t + 70, t + 51, prec);
    arb_mul(t + 72, t + 25, t + 71, prec);
    arb_sub(t + 73, t + 69, t + 72, prec);
    arb_set_si(t + 74, -2);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 0);
    arb_set(out + 2, t + 1);
    arb_set(out + 3, t + 0);
    arb_set(out + 4, t + 0);
    arb_set(out + 5, t + 0);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 1);
    arb_set(out + 8, t + 44);
    arb_set(out + 9, t + 55);
    arb_set(out + 10, t + 0);
    arb_set(out + 11, t + 56);
    arb_set(out + 12, t + 64);
    arb_set(out + 13, t + 73);
    arb_set(out + 14, t + 74);
    arb_set(out + 15, t + 0);
    _arb_vec_clear(t, 75);
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
    arb_ptr t = _arb_vec_init(41);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, x + 1, x + 1, prec);
    arb_set_si(t + 5, -1);
    arb_add(t + 6, params + 0, t + 5, prec);
    arb_add(t + 7, x + 0, t + 6, prec);
    arb_mul(t + 8, t + 7, t + 7, prec);
    arb_add(t + 9, t + 4, t + 8, prec);
    arb_sqrt(t + 10, t + 9, prec); /* r2 */
    arb_mul(t + 11, t + 10, t + 10, prec);
    arb_div(t + 12, params + 0, t + 10, prec);
    arb_div(t + 13, t + 1, t + 10, prec);
    arb_sub(t + 14, t + 12, t + 13, prec);
    arb_div(t + 15, x + 0, t + 10, prec);
    arb_add(t + 16, t + 14, t + 15, prec);
    arb_mul(t + 17, params + 0, t + 16, prec);
    arb_div(t + 18, t + 17, t + 11, prec);
    arb_sub(t + 19, t + 18, x + 0, prec);
    arb_add(t + 20, x + 0, params + 0, prec);
    arb_mul(t + 21, t + 20, t + 20, prec);
    arb_add(t + 22, t + 4, t + 21, prec);
    arb_sqrt(t + 23, t + 22, prec); /* r1 */
    arb_mul(t + 24, t + 23, t + 23, prec);
    arb_div(t + 25, params + 0, t + 23, prec);
    arb_div(t + 26, x + 0, t + 23, prec);
    arb_add(t + 27, t + 25, t + 26, prec);
    arb_mul(t + 28, t + 6, t + 27, prec);
    arb_div(t + 29, t + 28, t + 24, prec);
    arb_sub(t + 30, t + 19, t + 29, prec);
    arb_mul(t + 31, params + 0, x + 1, prec);
    arb_mul(t + 32, t + 10, t + 11, prec);
    arb_div(t + 33, t + 31, t + 32, prec);
    arb_sub(t + 34, t + 33, x + 1, prec);
    arb_mul(t + 35, t + 23, t + 24, prec);
    arb_mul(t + 36, x + 1, t + 6, prec);
    arb_div(t + 37, t + 36, t + 35, prec);
    arb_sub(t + 38, t + 34, t + 37, prec);
    arb_set(out + 0, t + 30);
    arb_set(out + 1, t + 38);
    arb_set(out + 2, x + 2);
    arb_set(out + 3, x + 3);
    _arb_vec_clear(t, 41);
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

