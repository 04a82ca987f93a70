/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      spherical_top_plane, SHA-256 ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6
 *  Command:    ttc generate --effort full --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(57);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 2, x + 0, x + 0, prec);
    arb_sub(t + 3, t + 0, t + 2, prec);
    arb_sqrt(t + 4, t + 3, prec); /* s */
    arb_mul(t + 8, params + 1, params + 1, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    arb_add(t + 10, params + 2, t + 9, prec); /* J1 */
    arb_mul(t + 11, params + 0, params + 1, prec);
    arb_mul(t + 12, params + 2, params + 2, prec);
    arb_mul(t + 13, params + 0, t + 12, prec);
    arb_mul(t + 16, params + 2, params + 3, prec);
    arb_mul(t + 17, t + 4, t + 4, prec);
    arb_mul(t + 18, params + 2, t + 17, prec);
    arb_mul(t + 19, t + 2, params + 3, prec);
    arb_add(t + 20, t + 18, t + 19, prec);
    arb_mul(t + 21, t + 9, t + 20, prec);
    arb_add(t + 22, t + 16, t + 21, prec); /* Theta */
    arb_mul(t + 24, params + 2, params + 5, prec);
    arb_mul(t + 25, t + 4, t + 24, prec);
    arb_cos(t + 27, x + 1, prec); /* C */
    arb_mul(t + 28, t + 25, t + 27, prec);
    arb_mul(t + 30, x + 0, params + 4, prec);
    arb_mul(t + 31, t + 10, t + 30, prec);
    arb_div(t + 32, t + 31, params + 1, prec);
    arb_sub(t + 33, t + 28, t + 32, prec);
    arb_mul(t + 34, t + 33, t + 33, prec);
    arb_sub(t + 35, params + 2, params + 3, prec);
    arb_mul(t + 36, t + 34, t + 35, prec);
    arb_div(t + 37, t + 36, t + 22, prec);
    arb_sub(t + 38, params + 6, t + 37, prec);
    arb_div(t + 39, t + 38, t + 13, prec);
    arb_sqrt(t + 40, t + 39, prec); /* v_slip */
    arb_mul(t + 41, t + 11, t + 40, prec);
    arb_sin(t + 42, x + 1, prec); /* S */
    arb_mul(t + 43, params + 5, t + 42, prec);
    arb_sub(t + 44, t + 41, t + 43, prec);
    arb_mul(t + 45, t + 4, t + 44, prec);
    arb_div(t + 46, t + 45, t + 10, prec);
    arb_mul(t + 47, t + 4, t + 22, prec);
    arb_mul(t + 48, t + 4, params + 4, prec);
    arb_add(t + 49, t + 9, params + 3, prec); /* J3 */
    arb_mul(t + 50, t + 48, t + 49, prec);
    arb_div(t + 51, t + 50, params + 1, prec);
    arb_mul(t + 52, params + 3, params + 5, prec);
    arb_mul(t + 53, x + 0, t + 52, prec);
    arb_mul(t + 54, t + 27, t + 53, prec);
    arb_add(t + 55, t + 51, t + 54, prec);
    arb_div(t + 56, t + 55, t + 47, prec);
    arb_set(out + 0, t + 46);
    arb_set(out + 1, t + 56);
    _arb_vec_clear(t, 57);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(114);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 2, x + 0, x + 0, prec);
    arb_sub(t + 3, t + 0, t + 2, prec);
    arb_sqrt(t + 4, t + 3, prec); /* s */
    arb_mul(t + 8, params + 1, params + 1, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    arb_add(t + 10, params + 2, t + 9, prec); /* J1 */
    arb_mul(t + 11, t + 4, t + 10, prec);
    arb_mul(t + 12, params + 0, params + 1, prec);
    arb_mul(t + 13, params + 2, params + 2, prec);
    arb_mul(t + 14, params + 0, t + 13, prec);
    arb_mul(t + 17, params + 2, params + 3, prec);
    arb_mul(t + 18, t + 4, t + 4, prec);
    arb_mul(t + 19, params + 2, t + 18, prec);
    arb_mul(t + 20, t + 2, params + 3, prec);
    arb_add(t + 21, t + 19, t + 20, prec);
    arb_mul(t + 22, t + 9, t + 21, prec);
    arb_add(t + 23, t + 17, t + 22, prec); /* Theta */
    arb_mul(t + 25, params + 2, params + 5, prec);
    arb_mul(t + 26, t + 4, t + 25, prec);
    arb_cos(t + 28, x + 1, prec); /* C */
    arb_mul(t + 29, t + 26, t + 28, prec);
    arb_mul(t + 31, x + 0, params + 4, prec);
    arb_mul(t + 32, t + 10, t + 31, prec);
    arb_div(t + 33, t + 32, params + 1, prec);
    arb_sub(t + 34, t + 29, t + 33, prec);
    arb_mul(t + 35, t + 34, t + 34, prec);
    arb_sub(t + 36, params + 2, params + 3, prec);
    arb_mul(t + 37, t + 35, t + 36, prec);
    arb_div(t + 38, t + 37, t + 23, prec);
    arb_sub(t + 39, params + 6, t + 38, prec);
    arb_div(t + 40, t + 39, t + 14, prec);
    arb_sqrt(t + 41, t + 40, prec); /* v_slip */
    arb_mul(t + 42, t + 12, t + 41, prec);
    arb_sin(t + 43, x + 1, prec); /* S */
    arb_mul(t + 44, params + 5, t + 43, prec);
    arb_sub(t + 45, t + 42, t + 44, prec);
    arb_mul(t + 46, x + 0, t + 45, prec);
    arb_div(t + 47, t + 46, t + 11, prec);
    arb_neg(t + 48, t + 47);
    arb_mul(t + 49, t + 4, params + 1, prec);
    arb_mul(t + 50, t + 10, t + 13, prec);
    arb_mul(t + 51, t + 41, t + 50, prec);
    arb_mul(t + 52, t + 23, t + 23, prec);
    arb_mul(t + 53, t + 9, t + 35, prec);
    arb_mul(t + 54, t + 36, t + 53, prec);
    arb_mul(t + 55, x + 0, params + 2, prec);
    arb_mul(t + 56, x + 0, params + 3, prec);
    arb_sub(t + 57, t + 55, t + 56, prec);
    arb_mul(t + 58, t + 54, t + 57, prec);
    arb_div(t + 59, t + 58, t + 52, prec);
    arb_mul(t + 60, t + 34, t + 36, prec);
    arb_mul(t + 61, x + 0, t + 25, prec);
    arb_mul(t + 62, t + 28, t + 61, prec);
    arb_div(t + 63, t + 62, t + 4, prec);
    arb_mul(t + 64, t + 10, params + 4, prec);
    arb_div(t + 65, t + 64, params + 1, prec);
    arb_add(t + 66, t + 63, t + 65, prec);
    arb_mul(t + 67, t + 60, t + 66, prec);
    arb_div(t + 68, t + 67, t + 23, prec);
    arb_sub(t + 69, t + 59, t + 68, prec);
    arb_mul(t + 70, t + 49, t + 69, prec);
    arb_div(t + 71, t + 70, t + 51, prec);
    arb_sub(t + 72, t + 48, t + 71, prec);
    arb_mul(t + 73, params + 1, params + 5, prec);
    arb_mul(t + 74, t + 4, t + 73, prec);
    arb_mul(t + 75, t + 43, t + 74, prec);
    arb_mul(t + 76, params + 2, t + 23, prec);
    arb_mul(t + 77, t + 34, t + 75, prec);
    arb_mul(t + 78, t + 36, t + 77, prec);
    arb_mul(t + 79, t + 41, t + 76, prec);
    arb_div(t + 80, t + 78, t + 79, prec);
    arb_mul(t + 81, params + 5, t + 28, prec);
    arb_sub(t + 82, t + 80, t + 81, prec);
    arb_mul(t + 83, t + 4, t + 82, prec);
    arb_div(t + 84, t + 83, t + 10, prec);
    arb_mul(t + 85, t + 4, t + 18, prec);
    arb_mul(t + 86, t + 23, t + 85, prec);
    arb_mul(t + 87, t + 4, params + 4, prec);
    arb_add(t + 88, t + 9, params + 3, prec); /* J3 */
    arb_mul(t + 89, t + 87, t + 88, prec);
    arb_div(t + 90, t + 89, params + 1, prec);
    arb_mul(t + 91, params + 3, params + 5, prec);
    arb_mul(t + 92, x + 0, t + 91, prec);
    arb_mul(t + 93, t + 28, t + 92, prec);
    arb_add(t + 94, t + 90, t + 93, prec);
    arb_mul(t + 95, x + 0, t + 94, prec);
    arb_div(t + 96, t + 95, t + 86, prec);
    arb_mul(t + 97, t + 4, t + 52, prec);
    arb_mul(t + 98, t + 9, t + 94, prec);
    arb_mul(t + 99, t + 57, t + 98, prec);
    arb_div(t + 100, t + 99, t + 97, prec);
    arb_set_si(t + 101, 2);
    arb_mul(t + 102, t + 100, t + 101, prec);
    arb_add(t + 103, t + 96, t + 102, prec);
    arb_mul(t + 104, t + 4, t + 23, prec);
    arb_mul(t + 105, t + 31, t + 88, prec);
    arb_div(t + 106, t + 105, t + 49, prec);
    arb_mul(t + 107, t + 28, t + 91, prec);
    arb_sub(t + 108, t + 106, t + 107, prec);
    arb_div(t + 109, t + 108, t + 104, prec);
    arb_sub(t + 110, t + 103, t + 109, prec);
    arb_mul(t + 111, t + 43, t + 92, prec);
    arb_div(t + 112, t + 111, t + 104, prec);
    arb_neg(t + 113, t + 112);
    arb_set(out + 0, t + 72);
    arb_set(out + 1, t + 84);
    arb_set(out + 2, t + 110);
    arb_set(out + 3, t + 113);
    _arb_vec_clear(t, 114);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(79);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 2, x + 0, x + 0, prec);
    arb_sub(t + 3, t + 0, t + 2, prec);
    arb_sqrt(t + 4, t + 3, prec); /* s */
    arb_mul(t + 8, params + 1, params + 1, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    arb_add(t + 10, params + 2, t + 9, prec); /* J1 */
    arb_mul(t + 11, t + 4, t + 10, prec);
    arb_mul(t + 12, params + 0, params + 1, prec);
    arb_mul(t + 13, params + 2, params + 2, prec);
    arb_mul(t + 14, params + 0, t + 13, prec);
    arb_mul(t + 17, params + 2, params + 3, prec);
    arb_mul(t + 18, t + 4, t + 4, prec);
    arb_mul(t + 19, params + 2, t + 18, prec);
    arb_mul(t + 20, t + 2, params + 3, prec);
    arb_add(t + 21, t + 19, t + 20, prec);
    arb_mul(t + 22, t + 9, t + 21, prec);
    arb_add(t + 23, t + 17, t + 22, prec); /* Theta */
    arb_mul(t + 25, params + 2, params + 5, prec);
    arb_mul(t + 26, t + 4, t + 25, prec);
    arb_cos(t + 28, x + 1, prec); /* C */
    arb_mul(t + 29, t + 26, t + 28, prec);
    arb_mul(t + 31, x + 0, params + 4, prec);
    arb_mul(t + 32, t + 10, t + 31, prec);
    arb_div(t + 33, t + 32, params + 1, prec);
    arb_sub(t + 34, t + 29, t + 33, prec);
    arb_mul(t + 35, t + 34, t + 34, prec);
    arb_sub(t + 36, params + 2, params + 3, prec);
    arb_mul(t + 37, t + 35, t + 36, prec);
    arb_div(t + 38, t + 37, t + 23, prec);
    arb_sub(t + 39, params + 6, t + 38, prec);
    arb_div(t + 40, t + 39, t + 14, prec);
    arb_sqrt(t + 41, t + 40, prec); /* v_slip */
    arb_mul(t + 42, t + 12, t + 41, prec);
    arb_sin(t + 43, x + 1, prec); /* S */
    arb_mul(t + 44, params + 5, t + 43, prec);
    arb_sub(t + 45, t + 42, t + 44, prec);
    arb_mul(t + 46, x + 0, t + 45, prec);
    arb_div(t + 47, t + 46, t + 11, prec);
    arb_neg(t + 48, t + 47);
    arb_mul(t + 49, t + 4, params + 1, prec);
    arb_mul(t + 50, t + 10, t + 13, prec);
    arb_mul(t + 51, t + 41, t + 50, prec);
    arb_mul(t + 52, t + 23, t + 23, prec);
    arb_mul(t + 53, t + 9, t + 35, prec);
    arb_mul(t + 54, t + 36, t + 53, prec);
    arb_mul(t + 55, x + 0, params + 2, prec);
    arb_mul(t + 56, x + 0, params + 3, prec);
    arb_sub(t + 57, t + 55, t + 56, prec);
    arb_mul(t + 58, t + 54, t + 57, prec);
    arb_div(t + 59, t + 58, t + 52, prec);
    arb_mul(t + 60, t + 34, t + 36, prec);
    arb_mul(t + 61, x + 0, t + 25, prec);
    arb_mul(t + 62, t + 28, t + 61, prec);
    arb_div(t + 63, t + 62, t + 4, prec);
    arb_mul(t + 64, t + 10, params + 4, prec);
    arb_div(t + 65, t + 64, params + 1, prec);
    arb_add(t + 66, t + 63, t + 65, prec);
    arb_mul(t + 67, t + 60, t + 66, prec);
    arb_div(t + 68, t + 67, t + 23, prec);
    arb_sub(t + 69, t + 59, t + 68, prec);
    arb_mul(t + 70, t + 49, t + 69, prec);
    arb_div(t + 71, t + 70, t + 51, prec);
    arb_sub(t + 72, t + 48, t + 71, prec);
    arb_mul(t + 73, params + 3, params + 5, prec);
    arb_mul(t + 74, x + 0, t + 73, prec);
    arb_mul(t + 75, t + 43, t + 74, prec);
    arb_mul(t + 76, t + 4, t + 23, prec);
    arb_div(t + 77, t + 75, t + 76, prec);
    arb_sub(t + 78, t + 72, t + 77, prec);
    arb_set(out + 0, t + 78);
    _arb_vec_clear(t, 79);
}

extern const jlt_ball_table jlt_balls_spherical_top_plane_general;
const jlt_ball_table jlt_balls_spherical_top_plane_general = {
    .model = "spherical_top_plane", .time = "", .elimination = "",
    .state_count = 2, .param_count = 7,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
};

static void general_in_regular_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(58);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 1, x + 2, x + 2, prec);
    arb_mul(t + 5, params + 1, params + 1, prec);
    arb_mul(t + 6, params + 0, t + 5, prec);
    arb_add(t + 7, params + 2, t + 6, prec); /* J1 */
    arb_mul(t + 8, params + 0, params + 1, prec);
    arb_mul(t + 9, params + 2, params + 2, prec);
    arb_mul(t + 10, params + 0, t + 9, prec);
    arb_mul(t + 13, params + 2, params + 3, prec);
    arb_mul(t + 14, t + 1, params + 2, prec);
    arb_mul(t + 16, x + 0, x + 0, prec);
    arb_mul(t + 17, params + 3, t + 16, prec);
    arb_add(t + 18, t + 14, t + 17, prec);
    arb_mul(t + 19, t + 6, t + 18, prec);
    arb_add(t + 20, t + 13, t + 19, prec); /* Theta */
    arb_mul(t + 22, params + 2, params + 5, prec);
    arb_mul(t + 23, x + 2, t + 22, prec);
    arb_cos(t + 25, x + 1, prec); /* C */
    arb_mul(t + 26, t + 23, t + 25, prec);
    arb_mul(t + 28, x + 0, params + 4, prec);
    arb_mul(t + 29, t + 7, t + 28, prec);
    arb_div(t + 30, t + 29, params + 1, prec);
    arb_sub(t + 31, t + 26, t + 30, prec);
    arb_mul(t + 32, t + 31, t + 31, prec);
    arb_sub(t + 33, params + 2, params + 3, prec);
    arb_mul(t + 34, t + 32, t + 33, prec);
    arb_div(t + 35, t + 34, t + 20, prec);
    arb_sub(t + 36, params + 6, t + 35, prec);
    arb_div(t + 37, t + 36, t + 10, prec);
    arb_sqrt(t + 38, t + 37, prec); /* v_slip */
    arb_mul(t + 39, t + 8, t + 38, prec);
    arb_sin(t + 40, x + 1, prec); /* S */
    arb_mul(t + 41, params + 5, t + 40, prec);
    arb_sub(t + 42, t + 39, t + 41, prec);
    arb_mul(t + 43, t + 1, t + 42, prec);
    arb_div(t + 44, t + 43, t + 7, prec);
    arb_mul(t + 45, x + 2, params + 4, prec);
    arb_add(t + 46, t + 6, params + 3, prec); /* J3 */
    arb_mul(t + 47, t + 45, t + 46, prec);
    arb_div(t + 48, t + 47, params + 1, prec);
    arb_mul(t + 49, params + 3, params + 5, prec);
    arb_mul(t + 50, x + 0, t + 49, prec);
    arb_mul(t + 51, t + 25, t + 50, prec);
    arb_add(t + 52, t + 48, t + 51, prec);
    arb_div(t + 53, t + 52, t + 20, prec);
    arb_mul(t + 54, x + 2, x + 0, prec);
    arb_mul(t + 55, t + 42, t + 54, prec);
    arb_div(t + 56, t + 55, t + 7, prec);
    arb_neg(t + 57, t + 56);
    arb_set(out + 0, t + 44);
    arb_set(out + 1, t + 53);
    arb_set(out + 2, t + 57);
    _arb_vec_clear(t, 58);
}

static void general_in_regular_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(127);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 2, params + 2, prec);
    arb_mul(t + 4, x + 2, x + 2, prec);
    arb_mul(t + 5, params + 1, t + 4, prec);
    arb_mul(t + 7, params + 1, params + 1, prec);
    arb_mul(t + 8, params + 0, t + 7, prec);
    arb_add(t + 9, params + 2, t + 8, prec); /* J1 */
    arb_mul(t + 10, t + 2, t + 9, prec);
    arb_mul(t + 11, t + 2, params + 0, prec);
    arb_mul(t + 14, params + 2, params + 3, prec);
    arb_mul(t + 15, params + 2, t + 4, prec);
    arb_mul(t + 17, x + 0, x + 0, prec);
    arb_mul(t + 18, params + 3, t + 17, prec);
    arb_add(t + 19, t + 15, t + 18, prec);
    arb_mul(t + 20, t + 8, t + 19, prec);
    arb_add(t + 21, t + 14, t + 20, prec); /* Theta */
    arb_mul(t + 23, params + 2, params + 5, prec);
    arb_mul(t + 24, x + 2, t + 23, prec);
    arb_cos(t + 26, x + 1, prec); /* C */
    arb_mul(t + 27, t + 24, t + 26, prec);
    arb_mul(t + 29, x + 0, params + 4, prec);
    arb_mul(t + 30, t + 9, t + 29, prec);
    arb_div(t + 31, t + 30, params + 1, prec);
    arb_sub(t + 32, t + 27, t + 31, prec);
    arb_mul(t + 33, t + 32, t + 32, prec);
    arb_sub(t + 34, params + 2, params + 3, prec);
    arb_mul(t + 35, t + 33, t + 34, prec);
    arb_div(t + 36, t + 35, t + 21, prec);
    arb_sub(t + 37, params + 6, t + 36, prec);
    arb_div(t + 38, t + 37, t + 11, prec);
    arb_sqrt(t + 39, t + 38, prec); /* v_slip */
    arb_mul(t + 40, t + 10, t + 39, prec);
    arb_mul(t + 41, t + 8, params + 3, prec);
    arb_mul(t + 42, x + 0, t + 41, prec);
    arb_mul(t + 43, t + 21, t + 21, prec);
    arb_mul(t + 44, t + 33, t + 42, prec);
    arb_mul(t + 45, t + 34, t + 44, prec);
    arb_div(t + 46, t + 45, t + 43, prec);
    arb_mul(t + 47, t + 9, params + 4, prec);
    arb_mul(t + 48, params + 1, t + 21, prec);
    arb_mul(t + 49, t + 32, t + 47, prec);
    arb_mul(t + 50, t + 34, t + 49, prec);
    arb_div(t + 51, t + 50, t + 48, prec);
    arb_add(t + 52, t + 46, t + 51, prec);
    arb_mul(t + 53, t + 5, t + 52, prec);
    arb_div(t + 54, t + 53, t + 40, prec);
    arb_mul(t + 55, params + 1, params + 5, prec);
    arb_mul(t + 56, x + 2, t + 55, prec);
    arb_sin(t + 57, x + 1, prec); /* S */
    arb_mul(t + 58, t + 56, t + 57, prec);
    arb_mul(t + 59, params + 2, t + 21, prec);
    arb_mul(t + 60, t + 32, t + 58, prec);
    arb_mul(t + 61, t + 34, t + 60, prec);
    arb_mul(t + 62, t + 39, t + 59, prec);
    arb_div(t + 63, t + 61, t + 62, prec);
    arb_mul(t + 64, params + 5, t + 26, prec);
    arb_sub(t + 65, t + 63, t + 64, prec);
    arb_mul(t + 66, t + 4, t + 65, prec);
    arb_div(t + 67, t + 66, t + 9, prec);
    arb_mul(t + 68, params + 1, params + 0, prec);
    arb_mul(t + 69, t + 39, t + 68, prec);
    arb_mul(t + 70, params + 5, t + 57, prec);
    arb_sub(t + 71, t + 69, t + 70, prec);
    arb_mul(t + 72, x + 2, t + 71, prec);
    arb_div(t + 73, t + 72, t + 9, prec);
    arb_set_si(t + 74, 2);
    arb_mul(t + 75, t + 73, t + 74, prec);
    arb_mul(t + 76, t + 23, t + 26, prec);
    arb_mul(t + 77, t + 32, t + 76, prec);
    arb_mul(t + 78, t + 34, t + 77, prec);
    arb_div(t + 79, t + 78, t + 21, prec);
    arb_mul(t + 80, params + 2, t + 8, prec);
    arb_mul(t + 81, x + 2, t + 80, prec);
    arb_mul(t + 82, t + 33, t + 81, prec);
    arb_mul(t + 83, t + 34, t + 82, prec);
    arb_div(t + 84, t + 83, t + 43, prec);
    arb_sub(t + 85, t + 79, t + 84, prec);
    arb_mul(t + 86, t + 5, t + 85, prec);
    arb_div(t + 87, t + 86, t + 40, prec);
    arb_sub(t + 88, t + 75, t + 87, prec);
    arb_mul(t + 89, params + 3, params + 5, prec);
    arb_mul(t + 90, t + 26, t + 89, prec);
    arb_div(t + 91, t + 90, t + 21, prec);
    arb_mul(t + 92, x + 2, params + 4, prec);
    arb_add(t + 93, t + 8, params + 3, prec); /* J3 */
    arb_mul(t + 94, t + 92, t + 93, prec);
    arb_div(t + 95, t + 94, params + 1, prec);
    arb_mul(t + 96, x + 0, t + 89, prec);
    arb_mul(t + 97, t + 26, t + 96, prec);
    arb_add(t + 98, t + 95, t + 97, prec);
    arb_mul(t + 99, t + 42, t + 98, prec);
    arb_div(t + 100, t + 99, t + 43, prec);
    arb_mul(t + 101, t + 74, t + 100, prec);
    arb_sub(t + 102, t + 91, t + 101, prec);
    arb_mul(t + 103, t + 57, t + 96, prec);
    arb_div(t + 104, t + 103, t + 21, prec);
    arb_neg(t + 105, t + 104);
    arb_mul(t + 106, params + 4, t + 93, prec);
    arb_div(t + 107, t + 106, t + 48, prec);
    arb_mul(t + 108, t + 81, t + 98, prec);
    arb_div(t + 109, t + 108, t + 43, prec);
    arb_mul(t + 110, t + 74, t + 109, prec);
    arb_sub(t + 111, t + 107, t + 110, prec);
    arb_neg(t + 112, t + 73);
    arb_mul(t + 113, params + 1, x + 0, prec);
    arb_mul(t + 114, x + 2, t + 113, prec);
    arb_mul(t + 115, t + 52, t + 114, prec);
    arb_div(t + 116, t + 115, t + 40, prec);
    arb_sub(t + 117, t + 112, t + 116, prec);
    arb_mul(t + 118, x + 2, x + 0, prec);
    arb_mul(t + 119, t + 65, t + 118, prec);
    arb_div(t + 120, t + 119, t + 9, prec);
    arb_neg(t + 121, t + 120);
    arb_mul(t + 122, t + 85, t + 114, prec);
    arb_div(t + 123, t + 122, t + 40, prec);
    arb_mul(t + 124, x + 0, t + 71, prec);
    arb_div(t + 125, t + 124, t + 9, prec);
    arb_sub(t + 126, t + 123, t + 125, prec);
    arb_set(out + 0, t + 54);
    arb_set(out + 1, t + 67);
    arb_set(out + 2, t + 88);
    arb_set(out + 3, t + 102);
    arb_set(out + 4, t + 105);
    arb_set(out + 5, t + 111);
    arb_set(out + 6, t + 117);
    arb_set(out + 7, t + 121);
    arb_set(out + 8, t + 126);
    _arb_vec_clear(t, 127);
}

static void general_in_regular_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(83);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 2, params + 2, prec);
    arb_mul(t + 4, x + 2, x + 2, prec);
    arb_mul(t + 5, params + 1, t + 4, prec);
    arb_mul(t + 7, params + 1, params + 1, prec);
    arb_mul(t + 8, params + 0, t + 7, prec);
    arb_add(t + 9, params + 2, t + 8, prec); /* J1 */
    arb_mul(t + 10, t + 2, t + 9, prec);
    arb_mul(t + 11, t + 2, params + 0, prec);
    arb_mul(t + 14, params + 2, params + 3, prec);
    arb_mul(t + 15, params + 2, t + 4, prec);
    arb_mul(t + 17, x + 0, x + 0, prec);
    arb_mul(t + 18, params + 3, t + 17, prec);
    arb_add(t + 19, t + 15, t + 18, prec);
    arb_mul(t + 20, t + 8, t + 19, prec);
    arb_add(t + 21, t + 14, t + 20, prec); /* Theta */
    arb_mul(t + 23, params + 2, params + 5, prec);
    arb_mul(t + 24, x + 2, t + 23, prec);
    arb_cos(t + 26, x + 1, prec); /* C */
    arb_mul(t + 27, t + 24, t + 26, prec);
    arb_mul(t + 29, x + 0, params + 4, prec);
    arb_mul(t + 30, t + 9, t + 29, prec);
    arb_div(t + 31, t + 30, params + 1, prec);
    arb_sub(t + 32, t + 27, t + 31, prec);
    arb_mul(t + 33, t + 32, t + 32, prec);
    arb_sub(t + 34, params + 2, params + 3, prec);
    arb_mul(t + 35, t + 33, t + 34, prec);
    arb_div(t + 36, t + 35, t + 21, prec);
    arb_sub(t + 37, params + 6, t + 36, prec);
    arb_div(t + 38, t + 37, t + 11, prec);
    arb_sqrt(t + 39, t + 38, prec); /* v_slip */
    arb_mul(t + 40, t + 10, t + 39, prec);
    arb_mul(t + 41, t + 8, params + 3, prec);
    arb_mul(t + 42, x + 0, t + 41, prec);
    arb_mul(t + 43, t + 21, t + 21, prec);
    arb_mul(t + 44, t + 33, t + 42, prec);
    arb_mul(t + 45, t + 34, t + 44, prec);
    arb_div(t + 46, t + 45, t + 43, prec);
    arb_mul(t + 47, t + 9, params + 4, prec);
    arb_mul(t + 48, params + 1, t + 21, prec);
    arb_mul(t + 49, t + 32, t + 47, prec);
    arb_mul(t + 50, t + 34, t + 49, prec);
    arb_div(t + 51, t + 50, t + 48, prec);
    arb_add(t + 52, t + 46, t + 51, prec);
    arb_mul(t + 53, t + 5, t + 52, prec);
    arb_div(t + 54, t + 53, t + 40, prec);
    arb_mul(t + 55, params + 3, params + 5, prec);
    arb_mul(t + 56, x + 0, t + 55, prec);
    arb_sin(t + 57, x + 1, prec); /* S */
    arb_mul(t + 58, t + 56, t + 57, prec);
    arb_div(t + 59, t + 58, t + 21, prec);
    arb_sub(t + 60, t + 54, t + 59, prec);
    arb_mul(t + 61, params + 1, x + 0, prec);
    arb_mul(t + 62, x + 2, t + 61, prec);
    arb_mul(t + 63, t + 23, t + 26, prec);
    arb_mul(t + 64, t + 32, t + 63, prec);
    arb_mul(t + 65, t + 34, t + 64, prec);
    arb_div(t + 66, t + 65, t + 21, prec);
    arb_mul(t + 67, params + 2, t + 8, prec);
    arb_mul(t + 68, x + 2, t + 67, prec);
    arb_mul(t + 69, t + 33, t + 68, prec);
    arb_mul(t + 70, t + 34, t + 69, prec);
    arb_div(t + 71, t + 70, t + 43, prec);
    arb_sub(t + 72, t + 66, t + 71, prec);
    arb_mul(t + 73, t + 62, t + 72, prec);
    arb_div(t + 74, t + 73, t + 40, prec);
    arb_add(t + 75, t + 60, t + 74, prec);
    arb_mul(t + 76, params + 1, params + 0, prec);
    arb_mul(t + 77, t + 39, t + 76, prec);
    arb_mul(t + 78, params + 5, t + 57, prec);
    arb_sub(t + 79, t + 77, t + 78, prec);
    arb_mul(t + 80, x + 0, t + 79, prec);
    arb_div(t + 81, t + 80, t + 9, prec);
    arb_sub(t + 82, t + 75, t + 81, prec);
    arb_set(out + 0, t + 82);
    _arb_vec_clear(t, 83);
}

extern const jlt_ball_table jlt_balls_spherical_top_plane_general_in_regular;
const jlt_ball_table jlt_balls_spherical_top_plane_general_in_regular = {
    .model = "spherical_top_plane", .time = "regular", .elimination = "",
    .state_count = 3, .param_count = 7,
    .rhs = general_in_regular_rhs,
    .jacobian = general_in_regular_jacobian,
    .divergence = general_in_regular_divergence,
};

