/* Periodic Toda lattice of three particles: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      toda, SHA-256 79463385d67ae1dc70b05259d1ce33196f59471c740553d39ca06f4200dd41de
 *  Command:    ttc generate --effort full --out DIR toda.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(19);
    (void)x;
    (void)params;
    (void)prec;
    arb_sub(t + 6, x + 0, x + 1, prec);
    arb_exp(t + 7, t + 6, prec); /* s1 */
    arb_mul(t + 8, params + 0, t + 7, prec);
    arb_sub(t + 10, x + 2, x + 0, prec);
    arb_exp(t + 11, t + 10, prec); /* s3 */
    arb_mul(t + 12, params + 0, t + 11, prec);
    arb_sub(t + 13, t + 12, t + 8, prec);
    arb_sub(t + 14, x + 1, x + 2, prec);
    arb_exp(t + 15, t + 14, prec); /* s2 */
    arb_mul(t + 16, params + 0, t + 15, prec);
    arb_sub(t + 17, t + 8, t + 16, prec);
    arb_sub(t + 18, t + 16, t + 12, prec);
    arb_set(out + 0, x + 3);
    arb_set(out + 1, x + 4);
    arb_set(out + 2, x + 5);
    arb_set(out + 3, t + 13);
    arb_set(out + 4, t + 17);
    arb_set(out + 5, t + 18);
    _arb_vec_clear(t, 19);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(20);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_sub(t + 5, x + 0, x + 1, prec);
    arb_exp(t + 6, t + 5, prec); /* s1 */
    arb_mul(t + 7, params + 0, t + 6, prec);
    arb_neg(t + 8, t + 7);
    arb_sub(t + 10, x + 2, x + 0, prec);
    arb_exp(t + 11, t + 10, prec); /* s3 */
    arb_mul(t + 12, params + 0, t + 11, prec);
    arb_sub(t + 13, t + 8, t + 12, prec);
    arb_sub(t + 14, x + 1, x + 2, prec);
    arb_exp(t + 15, t + 14, prec); /* s2 */
    arb_mul(t + 16, params + 0, t + 15, prec);
    arb_sub(t + 17, t + 8, t + 16, prec);
    arb_neg(t + 18, t + 12);
    arb_sub(t + 19, t + 18, t + 16, prec);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 0);
    arb_set(out + 2, t + 0);
    arb_set(out + 3, t + 1);
    arb_set(out + 4, t + 0);
    arb_set(out + 5, t + 0);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 0);
    arb_set(out + 8, t + 0);
    arb_set(out + 9, t + 0);
    arb_set(out + 10, t + 1);
    arb_set(out + 11, t + 0);
    arb_set(out + 12, t + 0);
    arb_set(out + 13, t + 0);
    arb_set(out + 14, t + 0);
    arb_set(out + 15, t + 0);
    arb_set(out + 16, t + 0);
    arb_set(out + 17, t + 1);
    arb_set(out + 18, t + 13);
    arb_set(out + 19, t + 7);
    arb_set(out + 20, t + 12);
    arb_set(out + 21, t + 0);
    arb_set(out + 22, t + 0);
    arb_set(out + 23, t + 0);
    arb_set(out + 24, t + 7);
    arb_set(out + 25, t + 17);
    arb_set(out + 26, t + 16);
    arb_set(out + 27, t + 0);
    arb_set(out + 28, t + 0);
    arb_set(out + 29, t + 0);
    arb_set(out + 30, t + 12);
    arb_set(out + 31, t + 16);
    arb_set(out + 32, t + 19);
    arb_set(out + 33, t + 0);
    arb_set(out + 34, t + 0);
    arb_set(out + 35, t + 0);
    _arb_vec_clear(t, 20);
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

static const char *const general_integral[] = { "P", "H", "J" };

static void general_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(37);
    (void)x;
    (void)params;
    (void)prec;
    arb_add(t + 2, x + 3, x + 4, prec);
    arb_add(t + 4, t + 2, x + 5, prec);
    arb_mul(t + 5, x + 3, x + 3, prec);
    jlt_ball_rational(t + 6, "1/2", prec);
    arb_mul(t + 7, t + 5, t + 6, prec);
    arb_mul(t + 8, x + 4, x + 4, prec);
    arb_mul(t + 9, t + 6, t + 8, prec);
    arb_add(t + 10, t + 7, t + 9, prec);
    arb_mul(t + 11, x + 5, x + 5, prec);
    arb_mul(t + 12, t + 6, t + 11, prec);
    arb_add(t + 13, t + 10, t + 12, prec);
    arb_sub(t + 17, x + 0, x + 1, prec);
    arb_exp(t + 18, t + 17, prec); /* s1 */
    arb_sub(t + 20, x + 1, x + 2, prec);
    arb_exp(t + 21, t + 20, prec); /* s2 */
    arb_add(t + 22, t + 18, t + 21, prec);
    arb_sub(t + 23, x + 2, x + 0, prec);
    arb_exp(t + 24, t + 23, prec); /* s3 */
    arb_add(t + 25, t + 22, t + 24, prec);
    arb_mul(t + 26, params + 0, t + 25, prec);
    arb_add(t + 27, t + 13, t + 26, prec);
    arb_mul(t + 28, x + 3, x + 4, prec);
    arb_mul(t + 29, x + 5, t + 28, prec);
    arb_mul(t + 30, x + 3, t + 21, prec);
    arb_mul(t + 31, x + 4, t + 24, prec);
    arb_add(t + 32, t + 30, t + 31, prec);
    arb_mul(t + 33, x + 5, t + 18, prec);
    arb_add(t + 34, t + 32, t + 33, prec);
    arb_mul(t + 35, params + 0, t + 34, prec);
    arb_sub(t + 36, t + 29, t + 35, prec);
    arb_set(out + 0, t + 4);
    arb_set(out + 1, t + 27);
    arb_set(out + 2, t + 36);
    _arb_vec_clear(t, 37);
}

static void general_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(42);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_sub(t + 5, x + 0, x + 1, prec);
    arb_exp(t + 6, t + 5, prec); /* s1 */
    arb_sub(t + 8, x + 2, x + 0, prec);
    arb_exp(t + 9, t + 8, prec); /* s3 */
    arb_sub(t + 10, t + 6, t + 9, prec);
    arb_mul(t + 11, params + 0, t + 10, prec);
    arb_sub(t + 12, x + 1, x + 2, prec);
    arb_exp(t + 13, t + 12, prec); /* s2 */
    arb_sub(t + 14, t + 6, t + 13, prec);
    arb_mul(t + 15, params + 0, t + 14, prec);
    arb_neg(t + 16, t + 15);
    arb_sub(t + 17, t + 13, t + 9, prec);
    arb_mul(t + 18, params + 0, t + 17, prec);
    arb_neg(t + 19, t + 18);
    arb_mul(t + 23, t + 9, x + 4, prec);
    arb_mul(t + 24, t + 6, x + 5, prec);
    arb_sub(t + 25, t + 23, t + 24, prec);
    arb_mul(t + 26, params + 0, t + 25, prec);
    arb_mul(t + 27, t + 13, x + 3, prec);
    arb_sub(t + 28, t + 27, t + 24, prec);
    arb_mul(t + 29, params + 0, t + 28, prec);
    arb_neg(t + 30, t + 29);
    arb_sub(t + 31, t + 27, t + 23, prec);
    arb_mul(t + 32, params + 0, t + 31, prec);
    arb_mul(t + 33, params + 0, t + 13, prec);
    arb_mul(t + 34, x + 4, x + 5, prec);
    arb_sub(t + 35, t + 34, t + 33, prec);
    arb_mul(t + 36, params + 0, t + 9, prec);
    arb_mul(t + 37, x + 3, x + 5, prec);
    arb_sub(t + 38, t + 37, t + 36, prec);
    arb_mul(t + 39, params + 0, t + 6, prec);
    arb_mul(t + 40, x + 3, x + 4, prec);
    arb_sub(t + 41, t + 40, t + 39, prec);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 0);
    arb_set(out + 2, t + 0);
    arb_set(out + 3, t + 1);
    arb_set(out + 4, t + 1);
    arb_set(out + 5, t + 1);
    arb_set(out + 6, t + 11);
    arb_set(out + 7, t + 16);
    arb_set(out + 8, t + 19);
    arb_set(out + 9, x + 3);
    arb_set(out + 10, x + 4);
    arb_set(out + 11, x + 5);
    arb_set(out + 12, t + 26);
    arb_set(out + 13, t + 30);
    arb_set(out + 14, t + 32);
    arb_set(out + 15, t + 35);
    arb_set(out + 16, t + 38);
    arb_set(out + 17, t + 41);
    _arb_vec_clear(t, 42);
}

extern const jlt_ball_table jlt_balls_toda_general;
const jlt_ball_table jlt_balls_toda_general = {
    .model = "toda", .time = "", .elimination = "",
    .state_count = 6, .param_count = 1,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
    .integral_count = 3,
    .integral = general_integral,
    .integral_values = general_integral_values,
    .integral_gradients = general_integral_gradients,
};

