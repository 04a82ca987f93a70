/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      spherical_top_balanced, SHA-256 24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33
 *  Command:    ttc generate --effort full --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(58);
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
    arb_mul(t + 13, t + 11, x + 1, prec);
    arb_sin(t + 16, x + 2, prec); /* S */
    arb_mul(t + 17, params + 5, t + 16, prec);
    arb_sub(t + 18, t + 13, t + 17, prec);
    arb_mul(t + 19, t + 4, t + 18, prec);
    arb_div(t + 20, t + 19, t + 10, prec);
    arb_mul(t + 22, params + 2, params + 3, prec);
    arb_mul(t + 23, t + 4, t + 4, prec);
    arb_mul(t + 24, params + 2, t + 23, prec);
    arb_mul(t + 25, t + 2, params + 3, prec);
    arb_add(t + 26, t + 24, t + 25, prec);
    arb_mul(t + 27, t + 9, t + 26, prec);
    arb_add(t + 28, t + 22, t + 27, prec); /* Theta */
    arb_mul(t + 29, t + 28, t + 28, prec);
    arb_mul(t + 31, t + 4, params + 4, prec);
    arb_add(t + 32, t + 9, params + 3, prec); /* J3 */
    arb_mul(t + 33, t + 31, t + 32, prec);
    arb_div(t + 34, t + 33, params + 1, prec);
    arb_mul(t + 35, params + 5, params + 3, prec);
    arb_mul(t + 36, x + 0, t + 35, prec);
    arb_cos(t + 37, x + 2, prec); /* C */
    arb_mul(t + 38, t + 36, t + 37, prec);
    arb_add(t + 39, t + 34, t + 38, prec);
    arb_mul(t + 40, params + 1, t + 39, prec);
    arb_mul(t + 41, params + 2, params + 5, prec);
    arb_mul(t + 42, t + 4, t + 41, prec);
    arb_mul(t + 43, t + 37, t + 42, prec);
    arb_mul(t + 44, x + 0, params + 4, prec);
    arb_mul(t + 45, t + 10, t + 44, prec);
    arb_div(t + 46, t + 45, params + 1, prec);
    arb_sub(t + 47, t + 43, t + 46, prec);
    arb_mul(t + 48, t + 40, t + 47, prec);
    arb_div(t + 49, t + 48, t + 29, prec);
    arb_mul(t + 50, params + 1, params + 3, prec);
    arb_mul(t + 51, params + 2, t + 29, prec);
    arb_mul(t + 52, t + 39, t + 50, prec);
    arb_mul(t + 53, t + 47, t + 52, prec);
    arb_div(t + 54, t + 53, t + 51, prec);
    arb_sub(t + 55, t + 49, t + 54, prec);
    arb_mul(t + 56, t + 4, t + 28, prec);
    arb_div(t + 57, t + 39, t + 56, prec);
    arb_set(out + 0, t + 20);
    arb_set(out + 1, t + 55);
    arb_set(out + 2, t + 57);
    _arb_vec_clear(t, 58);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(148);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 2, x + 0, x + 0, prec);
    arb_sub(t + 3, t + 0, t + 2, prec);
    arb_sqrt(t + 4, t + 3, prec); /* s */
    arb_set_si(t + 5, 0);
    arb_mul(t + 9, params + 1, params + 1, prec);
    arb_mul(t + 10, params + 0, t + 9, prec);
    arb_add(t + 11, params + 2, t + 10, prec); /* J1 */
    arb_mul(t + 12, t + 4, t + 11, prec);
    arb_mul(t + 13, params + 0, params + 1, prec);
    arb_mul(t + 15, t + 13, x + 1, prec);
    arb_sin(t + 18, x + 2, prec); /* S */
    arb_mul(t + 19, params + 5, t + 18, prec);
    arb_sub(t + 20, t + 15, t + 19, prec);
    arb_mul(t + 21, x + 0, t + 20, prec);
    arb_div(t + 22, t + 21, t + 12, prec);
    arb_neg(t + 23, t + 22);
    arb_mul(t + 24, t + 4, t + 13, prec);
    arb_div(t + 25, t + 24, t + 11, prec);
    arb_mul(t + 26, t + 4, params + 5, prec);
    arb_cos(t + 27, x + 2, prec); /* C */
    arb_mul(t + 28, t + 26, t + 27, prec);
    arb_div(t + 29, t + 28, t + 11, prec);
    arb_neg(t + 30, t + 29);
    arb_mul(t + 31, params + 1, t + 9, prec);
    arb_mul(t + 32, params + 0, t + 31, prec);
    arb_mul(t + 34, params + 2, params + 3, prec);
    arb_mul(t + 35, t + 4, t + 4, prec);
    arb_mul(t + 36, params + 2, t + 35, prec);
    arb_mul(t + 37, t + 2, params + 3, prec);
    arb_add(t + 38, t + 36, t + 37, prec);
    arb_mul(t + 39, t + 10, t + 38, prec);
    arb_add(t + 40, t + 34, t + 39, prec); /* Theta */
    arb_mul(t + 41, t + 40, t + 40, prec);
    arb_mul(t + 42, t + 40, t + 41, prec);
    arb_mul(t + 44, t + 4, params + 4, prec);
    arb_add(t + 45, t + 10, params + 3, prec); /* J3 */
    arb_mul(t + 46, t + 44, t + 45, prec);
    arb_div(t + 47, t + 46, params + 1, prec);
    arb_mul(t + 48, params + 5, params + 3, prec);
    arb_mul(t + 49, x + 0, t + 48, prec);
    arb_mul(t + 50, t + 27, t + 49, prec);
    arb_add(t + 51, t + 47, t + 50, prec);
    arb_mul(t + 52, t + 32, t + 51, prec);
    arb_mul(t + 53, params + 2, params + 5, prec);
    arb_mul(t + 54, t + 4, t + 53, prec);
    arb_mul(t + 55, t + 27, t + 54, prec);
    arb_mul(t + 56, x + 0, params + 4, prec);
    arb_mul(t + 57, t + 11, t + 56, prec);
    arb_div(t + 58, t + 57, params + 1, prec);
    arb_sub(t + 59, t + 55, t + 58, prec);
    arb_mul(t + 60, t + 52, t + 59, prec);
    arb_mul(t + 61, x + 0, params + 2, prec);
    arb_mul(t + 62, x + 0, params + 3, prec);
    arb_sub(t + 63, t + 61, t + 62, prec);
    arb_mul(t + 64, t + 60, t + 63, prec);
    arb_div(t + 65, t + 64, t + 42, prec);
    arb_set_si(t + 66, 4);
    arb_mul(t + 67, t + 65, t + 66, prec);
    arb_mul(t + 68, params + 1, t + 59, prec);
    arb_mul(t + 69, t + 4, params + 1, prec);
    arb_mul(t + 70, t + 45, t + 56, prec);
    arb_div(t + 71, t + 70, t + 69, prec);
    arb_mul(t + 72, t + 27, t + 48, prec);
    arb_sub(t + 73, t + 71, t + 72, prec);
    arb_mul(t + 74, t + 68, t + 73, prec);
    arb_div(t + 75, t + 74, t + 41, prec);
    arb_sub(t + 76, t + 67, t + 75, prec);
    arb_mul(t + 77, params + 1, t + 51, prec);
    arb_mul(t + 78, x + 0, t + 53, prec);
    arb_mul(t + 79, t + 27, t + 78, prec);
    arb_div(t + 80, t + 79, t + 4, prec);
    arb_mul(t + 81, t + 11, params + 4, prec);
    arb_div(t + 82, t + 81, params + 1, prec);
    arb_add(t + 83, t + 80, t + 82, prec);
    arb_mul(t + 84, t + 77, t + 83, prec);
    arb_div(t + 85, t + 84, t + 41, prec);
    arb_sub(t + 86, t + 76, t + 85, prec);
    arb_mul(t + 87, t + 32, params + 3, prec);
    arb_mul(t + 88, params + 2, t + 42, prec);
    arb_mul(t + 89, t + 51, t + 87, prec);
    arb_mul(t + 90, t + 59, t + 89, prec);
    arb_mul(t + 91, t + 63, t + 90, prec);
    arb_div(t + 92, t + 91, t + 88, prec);
    arb_mul(t + 93, t + 66, t + 92, prec);
    arb_sub(t + 94, t + 86, t + 93, prec);
    arb_mul(t + 95, params + 1, params + 3, prec);
    arb_mul(t + 96, params + 2, t + 41, prec);
    arb_mul(t + 97, t + 59, t + 95, prec);
    arb_mul(t + 98, t + 73, t + 97, prec);
    arb_div(t + 99, t + 98, t + 96, prec);
    arb_add(t + 100, t + 94, t + 99, prec);
    arb_mul(t + 101, t + 51, t + 95, prec);
    arb_mul(t + 102, t + 83, t + 101, prec);
    arb_div(t + 103, t + 102, t + 96, prec);
    arb_add(t + 104, t + 100, t + 103, prec);
    arb_mul(t + 105, params + 5, t + 95, prec);
    arb_mul(t + 106, x + 0, t + 105, prec);
    arb_mul(t + 107, t + 18, t + 106, prec);
    arb_mul(t + 108, t + 59, t + 107, prec);
    arb_div(t + 109, t + 108, t + 41, prec);
    arb_neg(t + 110, t + 109);
    arb_mul(t + 111, params + 2, params + 1, prec);
    arb_mul(t + 112, params + 5, t + 111, prec);
    arb_mul(t + 113, t + 4, t + 112, prec);
    arb_mul(t + 114, t + 18, t + 113, prec);
    arb_mul(t + 115, t + 51, t + 114, prec);
    arb_div(t + 116, t + 115, t + 41, prec);
    arb_sub(t + 117, t + 110, t + 116, prec);
    arb_mul(t + 118, params + 3, params + 3, prec);
    arb_mul(t + 119, params + 1, t + 118, prec);
    arb_mul(t + 120, params + 5, t + 119, prec);
    arb_mul(t + 121, x + 0, t + 120, prec);
    arb_mul(t + 122, t + 18, t + 121, prec);
    arb_mul(t + 123, t + 59, t + 122, prec);
    arb_div(t + 124, t + 123, t + 96, prec);
    arb_add(t + 125, t + 117, t + 124, prec);
    arb_mul(t + 126, t + 4, t + 105, prec);
    arb_mul(t + 127, t + 18, t + 126, prec);
    arb_mul(t + 128, t + 51, t + 127, prec);
    arb_div(t + 129, t + 128, t + 41, prec);
    arb_add(t + 130, t + 125, t + 129, prec);
    arb_mul(t + 131, t + 4, t + 35, prec);
    arb_mul(t + 132, t + 40, t + 131, prec);
    arb_mul(t + 133, x + 0, t + 51, prec);
    arb_div(t + 134, t + 133, t + 132, prec);
    arb_mul(t + 135, t + 4, t + 41, prec);
    arb_mul(t + 136, t + 10, t + 51, prec);
    arb_mul(t + 137, t + 63, t + 136, prec);
    arb_div(t + 138, t + 137, t + 135, prec);
    arb_set_si(t + 139, 2);
    arb_mul(t + 140, t + 138, t + 139, prec);
    arb_add(t + 141, t + 134, t + 140, prec);
    arb_mul(t + 142, t + 4, t + 40, prec);
    arb_div(t + 143, t + 73, t + 142, prec);
    arb_sub(t + 144, t + 141, t + 143, prec);
    arb_mul(t + 145, t + 18, t + 49, prec);
    arb_div(t + 146, t + 145, t + 142, prec);
    arb_neg(t + 147, t + 146);
    arb_set(out + 0, t + 23);
    arb_set(out + 1, t + 25);
    arb_set(out + 2, t + 30);
    arb_set(out + 3, t + 104);
    arb_set(out + 4, t + 5);
    arb_set(out + 5, t + 130);
    arb_set(out + 6, t + 144);
    arb_set(out + 7, t + 5);
    arb_set(out + 8, t + 147);
    _arb_vec_clear(t, 148);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(37);
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
    arb_mul(t + 14, t + 12, x + 1, prec);
    arb_sin(t + 17, x + 2, prec); /* S */
    arb_mul(t + 18, params + 5, t + 17, prec);
    arb_sub(t + 19, t + 14, t + 18, prec);
    arb_mul(t + 20, x + 0, t + 19, prec);
    arb_div(t + 21, t + 20, t + 11, prec);
    arb_neg(t + 22, t + 21);
    arb_mul(t + 24, params + 5, params + 3, prec);
    arb_mul(t + 25, x + 0, t + 24, prec);
    arb_mul(t + 26, t + 17, t + 25, prec);
    arb_mul(t + 27, params + 2, params + 3, prec);
    arb_mul(t + 28, t + 4, t + 4, prec);
    arb_mul(t + 29, params + 2, t + 28, prec);
    arb_mul(t + 30, t + 2, params + 3, prec);
    arb_add(t + 31, t + 29, t + 30, prec);
    arb_mul(t + 32, t + 9, t + 31, prec);
    arb_add(t + 33, t + 27, t + 32, prec); /* Theta */
    arb_mul(t + 34, t + 4, t + 33, prec);
    arb_div(t + 35, t + 26, t + 34, prec);
    arb_sub(t + 36, t + 22, t + 35, prec);
    arb_set(out + 0, t + 36);
    _arb_vec_clear(t, 37);
}

static const char *const general_integral[] = { "F0" };

static void general_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(40);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 2, params + 2, prec);
    arb_mul(t + 4, params + 0, t + 3, prec);
    arb_mul(t + 6, x + 1, x + 1, prec);
    arb_mul(t + 7, t + 4, t + 6, prec);
    arb_mul(t + 9, params + 2, params + 3, prec);
    arb_mul(t + 11, params + 1, params + 1, prec);
    arb_mul(t + 12, params + 0, t + 11, prec);
    arb_mul(t + 14, x + 0, x + 0, prec);
    arb_sub(t + 15, t + 0, t + 14, prec);
    arb_sqrt(t + 16, t + 15, prec); /* s */
    arb_mul(t + 17, t + 16, t + 16, prec);
    arb_mul(t + 18, params + 2, t + 17, prec);
    arb_mul(t + 19, params + 3, t + 14, prec);
    arb_add(t + 20, t + 18, t + 19, prec);
    arb_mul(t + 21, t + 12, t + 20, prec);
    arb_add(t + 22, t + 9, t + 21, prec); /* Theta */
    arb_mul(t + 24, params + 2, params + 5, prec);
    arb_mul(t + 25, t + 16, t + 24, prec);
    arb_cos(t + 27, x + 2, prec); /* C */
    arb_mul(t + 28, t + 25, t + 27, prec);
    arb_mul(t + 30, x + 0, params + 4, prec);
    arb_add(t + 31, params + 2, t + 12, prec); /* J1 */
    arb_mul(t + 32, t + 30, t + 31, prec);
    arb_div(t + 33, t + 32, params + 1, prec);
    arb_sub(t + 34, t + 28, t + 33, prec);
    arb_mul(t + 35, t + 34, t + 34, prec);
    arb_sub(t + 36, params + 2, params + 3, prec);
    arb_mul(t + 37, t + 35, t + 36, prec);
    arb_div(t + 38, t + 37, t + 22, prec);
    arb_add(t + 39, t + 7, t + 38, prec);
    arb_set(out + 0, t + 39);
    _arb_vec_clear(t, 40);
}

static void general_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(67);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 1, params + 1, prec);
    arb_mul(t + 4, params + 0, t + 3, prec);
    arb_mul(t + 7, params + 2, params + 3, prec);
    arb_mul(t + 9, x + 0, x + 0, prec);
    arb_sub(t + 10, t + 0, t + 9, prec);
    arb_sqrt(t + 11, t + 10, prec); /* s */
    arb_mul(t + 12, t + 11, t + 11, prec);
    arb_mul(t + 13, params + 2, t + 12, prec);
    arb_mul(t + 14, params + 3, t + 9, prec);
    arb_add(t + 15, t + 13, t + 14, prec);
    arb_mul(t + 16, t + 4, t + 15, prec);
    arb_add(t + 17, t + 7, t + 16, prec); /* Theta */
    arb_mul(t + 18, t + 17, t + 17, prec);
    arb_mul(t + 20, params + 2, params + 5, prec);
    arb_mul(t + 21, t + 11, t + 20, prec);
    arb_cos(t + 23, x + 2, prec); /* C */
    arb_mul(t + 24, t + 21, t + 23, prec);
    arb_mul(t + 26, x + 0, params + 4, prec);
    arb_add(t + 27, t + 4, params + 2, prec); /* J1 */
    arb_mul(t + 28, t + 26, t + 27, prec);
    arb_div(t + 29, t + 28, params + 1, prec);
    arb_sub(t + 30, t + 24, t + 29, prec);
    arb_mul(t + 31, t + 30, t + 30, prec);
    arb_mul(t + 32, t + 4, t + 31, prec);
    arb_sub(t + 33, params + 2, params + 3, prec);
    arb_mul(t + 34, t + 32, t + 33, prec);
    arb_mul(t + 35, params + 2, x + 0, prec);
    arb_mul(t + 36, params + 3, x + 0, prec);
    arb_sub(t + 37, t + 35, t + 36, prec);
    arb_mul(t + 38, t + 34, t + 37, prec);
    arb_div(t + 39, t + 38, t + 18, prec);
    arb_set_si(t + 40, 2);
    arb_mul(t + 41, t + 39, t + 40, prec);
    arb_mul(t + 42, t + 30, t + 33, prec);
    arb_mul(t + 43, x + 0, t + 20, prec);
    arb_mul(t + 44, t + 23, t + 43, prec);
    arb_div(t + 45, t + 44, t + 11, prec);
    arb_mul(t + 46, params + 4, t + 27, prec);
    arb_div(t + 47, t + 46, params + 1, prec);
    arb_add(t + 48, t + 45, t + 47, prec);
    arb_mul(t + 49, t + 42, t + 48, prec);
    arb_div(t + 50, t + 49, t + 17, prec);
    arb_mul(t + 51, t + 40, t + 50, prec);
    arb_sub(t + 52, t + 41, t + 51, prec);
    arb_mul(t + 53, params + 0, t + 40, prec);
    arb_mul(t + 54, params + 2, params + 2, prec);
    arb_mul(t + 55, t + 53, t + 54, prec);
    arb_mul(t + 57, t + 55, x + 1, prec);
    arb_set_si(t + 58, -2);
    arb_mul(t + 59, params + 2, t + 58, prec);
    arb_mul(t + 60, params + 5, t + 59, prec);
    arb_mul(t + 61, t + 11, t + 60, prec);
    arb_sin(t + 62, x + 2, prec); /* S */
    arb_mul(t + 63, t + 61, t + 62, prec);
    arb_mul(t + 64, t + 30, t + 63, prec);
    arb_mul(t + 65, t + 33, t + 64, prec);
    arb_div(t + 66, t + 65, t + 17, prec);
    arb_set(out + 0, t + 52);
    arb_set(out + 1, t + 57);
    arb_set(out + 2, t + 66);
    _arb_vec_clear(t, 67);
}

extern const jlt_ball_table jlt_balls_spherical_top_balanced_general;
const jlt_ball_table jlt_balls_spherical_top_balanced_general = {
    .model = "spherical_top_balanced", .time = "", .elimination = "",
    .state_count = 3, .param_count = 6,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
    .integral_count = 1,
    .integral = general_integral,
    .integral_values = general_integral_values,
    .integral_gradients = general_integral_gradients,
};

static void general_in_regular_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(61);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 1, x + 3, x + 3, prec);
    arb_mul(t + 5, params + 1, params + 1, prec);
    arb_mul(t + 6, params + 0, t + 5, prec);
    arb_add(t + 7, params + 2, t + 6, prec); /* J1 */
    arb_mul(t + 8, params + 0, params + 1, prec);
    arb_mul(t + 10, t + 8, x + 1, prec);
    arb_sin(t + 13, x + 2, prec); /* S */
    arb_mul(t + 14, params + 5, t + 13, prec);
    arb_sub(t + 15, t + 10, t + 14, prec);
    arb_mul(t + 16, t + 1, t + 15, prec);
    arb_div(t + 17, t + 16, t + 7, prec);
    arb_mul(t + 18, x + 3, params + 1, prec);
    arb_mul(t + 20, params + 2, params + 3, prec);
    arb_mul(t + 21, t + 1, params + 2, prec);
    arb_mul(t + 23, x + 0, x + 0, prec);
    arb_mul(t + 24, params + 3, t + 23, prec);
    arb_add(t + 25, t + 21, t + 24, prec);
    arb_mul(t + 26, t + 6, t + 25, prec);
    arb_add(t + 27, t + 20, t + 26, prec); /* Theta */
    arb_mul(t + 28, t + 27, t + 27, prec);
    arb_mul(t + 30, x + 3, params + 4, prec);
    arb_add(t + 31, t + 6, params + 3, prec); /* J3 */
    arb_mul(t + 32, t + 30, t + 31, prec);
    arb_div(t + 33, t + 32, params + 1, prec);
    arb_mul(t + 34, params + 5, params + 3, prec);
    arb_mul(t + 35, x + 0, t + 34, prec);
    arb_cos(t + 36, x + 2, prec); /* C */
    arb_mul(t + 37, t + 35, t + 36, prec);
    arb_add(t + 38, t + 33, t + 37, prec);
    arb_mul(t + 39, t + 18, t + 38, prec);
    arb_mul(t + 40, params + 2, params + 5, prec);
    arb_mul(t + 41, x + 3, t + 40, prec);
    arb_mul(t + 42, t + 36, t + 41, prec);
    arb_mul(t + 43, x + 0, params + 4, prec);
    arb_mul(t + 44, t + 7, t + 43, prec);
    arb_div(t + 45, t + 44, params + 1, prec);
    arb_sub(t + 46, t + 42, t + 45, prec);
    arb_mul(t + 47, t + 39, t + 46, prec);
    arb_div(t + 48, t + 47, t + 28, prec);
    arb_mul(t + 49, params + 1, params + 3, prec);
    arb_mul(t + 50, x + 3, t + 49, prec);
    arb_mul(t + 51, params + 2, t + 28, prec);
    arb_mul(t + 52, t + 38, t + 50, prec);
    arb_mul(t + 53, t + 46, t + 52, prec);
    arb_div(t + 54, t + 53, t + 51, prec);
    arb_sub(t + 55, t + 48, t + 54, prec);
    arb_div(t + 56, t + 38, t + 27, prec);
    arb_mul(t + 57, x + 3, x + 0, prec);
    arb_mul(t + 58, t + 15, t + 57, prec);
    arb_div(t + 59, t + 58, t + 7, prec);
    arb_neg(t + 60, t + 59);
    arb_set(out + 0, t + 17);
    arb_set(out + 1, t + 55);
    arb_set(out + 2, t + 56);
    arb_set(out + 3, t + 60);
    _arb_vec_clear(t, 61);
}

static void general_in_regular_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(193);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_mul(t + 3, params + 0, params + 1, prec);
    arb_mul(t + 5, x + 3, x + 3, prec);
    arb_mul(t + 6, t + 3, t + 5, prec);
    arb_mul(t + 8, params + 1, params + 1, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    arb_add(t + 10, params + 2, t + 9, prec); /* J1 */
    arb_div(t + 11, t + 6, t + 10, prec);
    arb_mul(t + 13, t + 5, params + 5, prec);
    arb_cos(t + 15, x + 2, prec); /* C */
    arb_mul(t + 16, t + 13, t + 15, prec);
    arb_div(t + 17, t + 16, t + 10, prec);
    arb_neg(t + 18, t + 17);
    arb_set_si(t + 19, 2);
    arb_mul(t + 20, x + 3, t + 19, prec);
    arb_mul(t + 22, t + 3, x + 1, prec);
    arb_sin(t + 23, x + 2, prec); /* S */
    arb_mul(t + 24, params + 5, t + 23, prec);
    arb_sub(t + 25, t + 22, t + 24, prec);
    arb_mul(t + 26, t + 20, t + 25, prec);
    arb_div(t + 27, t + 26, t + 10, prec);
    arb_mul(t + 29, params + 1, params + 3, prec);
    arb_mul(t + 30, params + 5, t + 29, prec);
    arb_mul(t + 31, x + 3, t + 30, prec);
    arb_mul(t + 32, t + 15, t + 31, prec);
    arb_mul(t + 33, params + 2, params + 3, prec);
    arb_mul(t + 34, t + 5, params + 2, prec);
    arb_mul(t + 36, x + 0, x + 0, prec);
    arb_mul(t + 37, params + 3, t + 36, prec);
    arb_add(t + 38, t + 34, t + 37, prec);
    arb_mul(t + 39, t + 9, t + 38, prec);
    arb_add(t + 40, t + 33, t + 39, prec); /* Theta */
    arb_mul(t + 41, t + 40, t + 40, prec);
    arb_mul(t + 42, params + 2, params + 5, prec);
    arb_mul(t + 43, x + 3, t + 42, prec);
    arb_mul(t + 44, t + 15, t + 43, prec);
    arb_mul(t + 46, x + 0, params + 4, prec);
    arb_mul(t + 47, t + 10, t + 46, prec);
    arb_div(t + 48, t + 47, params + 1, prec);
    arb_sub(t + 49, t + 44, t + 48, prec);
    arb_mul(t + 50, t + 32, t + 49, prec);
    arb_div(t + 51, t + 50, t + 41, prec);
    arb_mul(t + 52, params + 1, t + 8, prec);
    arb_mul(t + 53, params + 0, t + 52, prec);
    arb_mul(t + 54, params + 3, t + 53, prec);
    arb_mul(t + 55, x + 0, t + 54, prec);
    arb_mul(t + 56, x + 3, t + 55, prec);
    arb_mul(t + 57, t + 40, t + 41, prec);
    arb_mul(t + 58, x + 3, params + 4, prec);
    arb_add(t + 59, t + 9, params + 3, prec); /* J3 */
    arb_mul(t + 60, t + 58, t + 59, prec);
    arb_div(t + 61, t + 60, params + 1, prec);
    arb_mul(t + 62, params + 5, params + 3, prec);
    arb_mul(t + 63, x + 0, t + 62, prec);
    arb_mul(t + 64, t + 15, t + 63, prec);
    arb_add(t + 65, t + 61, t + 64, prec);
    arb_mul(t + 66, t + 56, t + 65, prec);
    arb_mul(t + 67, t + 49, t + 66, prec);
    arb_div(t + 68, t + 67, t + 57, prec);
    arb_set_si(t + 69, 4);
    arb_mul(t + 70, t + 68, t + 69, prec);
    arb_sub(t + 71, t + 51, t + 70, prec);
    arb_mul(t + 72, t + 10, t + 58, prec);
    arb_mul(t + 73, t + 65, t + 72, prec);
    arb_div(t + 74, t + 73, t + 41, prec);
    arb_sub(t + 75, t + 71, t + 74, prec);
    arb_mul(t + 76, params + 3, params + 3, prec);
    arb_mul(t + 77, params + 1, t + 76, prec);
    arb_mul(t + 78, params + 5, t + 77, prec);
    arb_mul(t + 79, x + 3, t + 78, prec);
    arb_mul(t + 80, t + 15, t + 79, prec);
    arb_mul(t + 81, params + 2, t + 41, prec);
    arb_mul(t + 82, t + 49, t + 80, prec);
    arb_div(t + 83, t + 82, t + 81, prec);
    arb_sub(t + 84, t + 75, t + 83, prec);
    arb_mul(t + 85, t + 53, t + 76, prec);
    arb_mul(t + 86, x + 0, t + 85, prec);
    arb_mul(t + 87, x + 3, t + 86, prec);
    arb_mul(t + 88, params + 2, t + 57, prec);
    arb_mul(t + 89, t + 65, t + 87, prec);
    arb_mul(t + 90, t + 49, t + 89, prec);
    arb_div(t + 91, t + 90, t + 88, prec);
    arb_mul(t + 92, t + 69, t + 91, prec);
    arb_add(t + 93, t + 84, t + 92, prec);
    arb_mul(t + 94, params + 3, params + 4, prec);
    arb_mul(t + 95, x + 3, t + 94, prec);
    arb_mul(t + 96, t + 10, t + 95, prec);
    arb_mul(t + 97, t + 65, t + 96, prec);
    arb_div(t + 98, t + 97, t + 81, prec);
    arb_add(t + 99, t + 93, t + 98, prec);
    arb_mul(t + 100, t + 30, x + 0, prec);
    arb_mul(t + 101, x + 3, t + 100, prec);
    arb_mul(t + 102, t + 23, t + 101, prec);
    arb_mul(t + 103, t + 49, t + 102, prec);
    arb_div(t + 104, t + 103, t + 41, prec);
    arb_neg(t + 105, t + 104);
    arb_mul(t + 106, params + 1, params + 2, prec);
    arb_mul(t + 107, params + 5, t + 106, prec);
    arb_mul(t + 108, t + 5, t + 107, prec);
    arb_mul(t + 109, t + 23, t + 108, prec);
    arb_mul(t + 110, t + 65, t + 109, prec);
    arb_div(t + 111, t + 110, t + 41, prec);
    arb_sub(t + 112, t + 105, t + 111, prec);
    arb_mul(t + 113, x + 0, t + 78, prec);
    arb_mul(t + 114, x + 3, t + 113, prec);
    arb_mul(t + 115, t + 23, t + 114, prec);
    arb_mul(t + 116, t + 49, t + 115, prec);
    arb_div(t + 117, t + 116, t + 81, prec);
    arb_add(t + 118, t + 112, t + 117, prec);
    arb_mul(t + 119, t + 5, t + 30, prec);
    arb_mul(t + 120, t + 23, t + 119, prec);
    arb_mul(t + 121, t + 65, t + 120, prec);
    arb_div(t + 122, t + 121, t + 41, prec);
    arb_add(t + 123, t + 118, t + 122, prec);
    arb_mul(t + 124, params + 1, t + 65, prec);
    arb_mul(t + 125, t + 49, t + 124, prec);
    arb_div(t + 126, t + 125, t + 41, prec);
    arb_mul(t + 127, t + 29, t + 65, prec);
    arb_mul(t + 128, t + 49, t + 127, prec);
    arb_div(t + 129, t + 128, t + 81, prec);
    arb_sub(t + 130, t + 126, t + 129, prec);
    arb_mul(t + 131, t + 49, t + 60, prec);
    arb_div(t + 132, t + 131, t + 41, prec);
    arb_add(t + 133, t + 130, t + 132, prec);
    arb_mul(t + 134, x + 3, t + 107, prec);
    arb_mul(t + 135, t + 15, t + 134, prec);
    arb_mul(t + 136, t + 65, t + 135, prec);
    arb_div(t + 137, t + 136, t + 41, prec);
    arb_add(t + 138, t + 133, t + 137, prec);
    arb_mul(t + 139, params + 2, t + 53, prec);
    arb_mul(t + 140, t + 5, t + 139, prec);
    arb_mul(t + 141, t + 65, t + 140, prec);
    arb_mul(t + 142, t + 49, t + 141, prec);
    arb_div(t + 143, t + 142, t + 57, prec);
    arb_mul(t + 144, t + 69, t + 143, prec);
    arb_sub(t + 145, t + 138, t + 144, prec);
    arb_mul(t + 146, t + 59, t + 95, prec);
    arb_mul(t + 147, t + 49, t + 146, prec);
    arb_div(t + 148, t + 147, t + 81, prec);
    arb_sub(t + 149, t + 145, t + 148, prec);
    arb_mul(t + 150, t + 32, t + 65, prec);
    arb_div(t + 151, t + 150, t + 41, prec);
    arb_sub(t + 152, t + 149, t + 151, prec);
    arb_mul(t + 153, t + 5, t + 54, prec);
    arb_mul(t + 154, t + 65, t + 153, prec);
    arb_mul(t + 155, t + 49, t + 154, prec);
    arb_div(t + 156, t + 155, t + 57, prec);
    arb_mul(t + 157, t + 69, t + 156, prec);
    arb_add(t + 158, t + 152, t + 157, prec);
    arb_mul(t + 159, t + 15, t + 62, prec);
    arb_div(t + 160, t + 159, t + 40, prec);
    arb_mul(t + 161, t + 9, params + 3, prec);
    arb_mul(t + 162, x + 0, t + 161, prec);
    arb_mul(t + 163, t + 65, t + 162, prec);
    arb_div(t + 164, t + 163, t + 41, prec);
    arb_mul(t + 165, t + 19, t + 164, prec);
    arb_sub(t + 166, t + 160, t + 165, prec);
    arb_mul(t + 167, t + 23, t + 63, prec);
    arb_div(t + 168, t + 167, t + 40, prec);
    arb_neg(t + 169, t + 168);
    arb_mul(t + 170, params + 4, t + 59, prec);
    arb_mul(t + 171, params + 1, t + 40, prec);
    arb_div(t + 172, t + 170, t + 171, prec);
    arb_mul(t + 173, params + 2, t + 9, prec);
    arb_mul(t + 174, x + 3, t + 173, prec);
    arb_mul(t + 175, t + 65, t + 174, prec);
    arb_div(t + 176, t + 175, t + 41, prec);
    arb_mul(t + 177, t + 19, t + 176, prec);
    arb_sub(t + 178, t + 172, t + 177, prec);
    arb_mul(t + 179, x + 3, t + 25, prec);
    arb_div(t + 180, t + 179, t + 10, prec);
    arb_neg(t + 181, t + 180);
    arb_mul(t + 182, t + 3, x + 0, prec);
    arb_mul(t + 183, x + 3, t + 182, prec);
    arb_div(t + 184, t + 183, t + 10, prec);
    arb_neg(t + 185, t + 184);
    arb_mul(t + 186, params + 5, x + 0, prec);
    arb_mul(t + 187, x + 3, t + 186, prec);
    arb_mul(t + 188, t + 15, t + 187, prec);
    arb_div(t + 189, t + 188, t + 10, prec);
    arb_mul(t + 190, t + 25, x + 0, prec);
    arb_div(t + 191, t + 190, t + 10, prec);
    arb_neg(t + 192, t + 191);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 11);
    arb_set(out + 2, t + 18);
    arb_set(out + 3, t + 27);
    arb_set(out + 4, t + 99);
    arb_set(out + 5, t + 0);
    arb_set(out + 6, t + 123);
    arb_set(out + 7, t + 158);
    arb_set(out + 8, t + 166);
    arb_set(out + 9, t + 0);
    arb_set(out + 10, t + 169);
    arb_set(out + 11, t + 178);
    arb_set(out + 12, t + 181);
    arb_set(out + 13, t + 185);
    arb_set(out + 14, t + 189);
    arb_set(out + 15, t + 192);
    _arb_vec_clear(t, 193);
}

static void general_in_regular_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(33);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 3, params + 5, prec);
    arb_mul(t + 4, t + 2, x + 0, prec);
    arb_sin(t + 6, x + 2, prec); /* S */
    arb_mul(t + 7, t + 4, t + 6, prec);
    arb_mul(t + 9, params + 3, params + 2, prec);
    arb_mul(t + 12, params + 1, params + 1, prec);
    arb_mul(t + 13, params + 0, t + 12, prec);
    arb_mul(t + 15, x + 3, x + 3, prec);
    arb_mul(t + 16, params + 2, t + 15, prec);
    arb_mul(t + 17, x + 0, x + 0, prec);
    arb_mul(t + 18, params + 3, t + 17, prec);
    arb_add(t + 19, t + 16, t + 18, prec);
    arb_mul(t + 20, t + 13, t + 19, prec);
    arb_add(t + 21, t + 9, t + 20, prec); /* Theta */
    arb_div(t + 22, t + 7, t + 21, prec);
    arb_neg(t + 23, t + 22);
    arb_add(t + 24, params + 2, t + 13, prec); /* J1 */
    arb_mul(t + 25, params + 0, params + 1, prec);
    arb_mul(t + 27, t + 25, x + 1, prec);
    arb_mul(t + 28, params + 5, t + 6, prec);
    arb_sub(t + 29, t + 27, t + 28, prec);
    arb_mul(t + 30, x + 0, t + 29, prec);
    arb_div(t + 31, t + 30, t + 24, prec);
    arb_sub(t + 32, t + 23, t + 31, prec);
    arb_set(out + 0, t + 32);
    _arb_vec_clear(t, 33);
}

static const char *const general_in_regular_integral[] = { "F0" };

static void general_in_regular_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(38);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 2, params + 2, prec);
    arb_mul(t + 3, params + 0, t + 2, prec);
    arb_mul(t + 5, x + 1, x + 1, prec);
    arb_mul(t + 6, t + 3, t + 5, prec);
    arb_mul(t + 8, params + 2, params + 3, prec);
    arb_mul(t + 10, params + 1, params + 1, prec);
    arb_mul(t + 11, params + 0, t + 10, prec);
    arb_mul(t + 13, x + 3, x + 3, prec);
    arb_mul(t + 14, params + 2, t + 13, prec);
    arb_mul(t + 16, x + 0, x + 0, prec);
    arb_mul(t + 17, params + 3, t + 16, prec);
    arb_add(t + 18, t + 14, t + 17, prec);
    arb_mul(t + 19, t + 11, t + 18, prec);
    arb_add(t + 20, t + 8, t + 19, prec); /* Theta */
    arb_mul(t + 22, params + 2, params + 5, prec);
    arb_mul(t + 23, x + 3, t + 22, prec);
    arb_cos(t + 25, x + 2, prec); /* C */
    arb_mul(t + 26, t + 23, t + 25, prec);
    arb_mul(t + 28, x + 0, params + 4, prec);
    arb_add(t + 29, params + 2, t + 11, prec); /* J1 */
    arb_mul(t + 30, t + 28, t + 29, prec);
    arb_div(t + 31, t + 30, params + 1, prec);
    arb_sub(t + 32, t + 26, t + 31, prec);
    arb_mul(t + 33, t + 32, t + 32, prec);
    arb_sub(t + 34, params + 2, params + 3, prec);
    arb_mul(t + 35, t + 33, t + 34, prec);
    arb_div(t + 36, t + 35, t + 20, prec);
    arb_add(t + 37, t + 6, t + 36, prec);
    arb_set(out + 0, t + 37);
    _arb_vec_clear(t, 38);
}

static void general_in_regular_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(72);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 1, params + 1, prec);
    arb_mul(t + 3, params + 0, t + 2, prec);
    arb_mul(t + 5, t + 3, params + 3, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, params + 3, params + 2, prec);
    arb_mul(t + 11, x + 3, x + 3, prec);
    arb_mul(t + 12, params + 2, t + 11, prec);
    arb_mul(t + 13, x + 0, x + 0, prec);
    arb_mul(t + 14, params + 3, t + 13, prec);
    arb_add(t + 15, t + 12, t + 14, prec);
    arb_mul(t + 16, t + 3, t + 15, prec);
    arb_add(t + 17, t + 9, t + 16, prec); /* Theta */
    arb_mul(t + 18, t + 17, t + 17, prec);
    arb_mul(t + 20, params + 2, params + 5, prec);
    arb_mul(t + 21, x + 3, t + 20, prec);
    arb_cos(t + 23, x + 2, prec); /* C */
    arb_mul(t + 24, t + 21, t + 23, prec);
    arb_mul(t + 26, x + 0, params + 4, prec);
    arb_add(t + 27, t + 3, params + 2, prec); /* J1 */
    arb_mul(t + 28, t + 26, t + 27, prec);
    arb_div(t + 29, t + 28, params + 1, prec);
    arb_sub(t + 30, t + 24, t + 29, prec);
    arb_mul(t + 31, t + 30, t + 30, prec);
    arb_mul(t + 32, t + 7, t + 31, prec);
    arb_sub(t + 33, params + 2, params + 3, prec);
    arb_mul(t + 34, t + 32, t + 33, prec);
    arb_div(t + 35, t + 34, t + 18, prec);
    arb_set_si(t + 36, 2);
    arb_mul(t + 37, t + 35, t + 36, prec);
    arb_neg(t + 38, t + 37);
    arb_mul(t + 39, params + 4, t + 27, prec);
    arb_mul(t + 40, params + 1, t + 17, prec);
    arb_mul(t + 41, t + 30, t + 39, prec);
    arb_mul(t + 42, t + 33, t + 41, prec);
    arb_div(t + 43, t + 42, t + 40, prec);
    arb_mul(t + 44, t + 36, t + 43, prec);
    arb_sub(t + 45, t + 38, t + 44, prec);
    arb_mul(t + 46, params + 0, t + 36, prec);
    arb_mul(t + 47, params + 2, params + 2, prec);
    arb_mul(t + 48, t + 46, t + 47, prec);
    arb_mul(t + 50, t + 48, x + 1, prec);
    arb_set_si(t + 51, -2);
    arb_mul(t + 52, params + 2, t + 51, prec);
    arb_mul(t + 53, params + 5, t + 52, prec);
    arb_mul(t + 54, x + 3, t + 53, prec);
    arb_sin(t + 55, x + 2, prec); /* S */
    arb_mul(t + 56, t + 54, t + 55, prec);
    arb_mul(t + 57, t + 30, t + 56, prec);
    arb_mul(t + 58, t + 33, t + 57, prec);
    arb_div(t + 59, t + 58, t + 17, prec);
    arb_mul(t + 60, t + 20, t + 23, prec);
    arb_mul(t + 61, t + 30, t + 60, prec);
    arb_mul(t + 62, t + 33, t + 61, prec);
    arb_div(t + 63, t + 62, t + 17, prec);
    arb_mul(t + 64, t + 36, t + 63, prec);
    arb_mul(t + 65, t + 3, params + 2, prec);
    arb_mul(t + 66, x + 3, t + 65, prec);
    arb_mul(t + 67, t + 31, t + 66, prec);
    arb_mul(t + 68, t + 33, t + 67, prec);
    arb_div(t + 69, t + 68, t + 18, prec);
    arb_mul(t + 70, t + 36, t + 69, prec);
    arb_sub(t + 71, t + 64, t + 70, prec);
    arb_set(out + 0, t + 45);
    arb_set(out + 1, t + 50);
    arb_set(out + 2, t + 59);
    arb_set(out + 3, t + 71);
    _arb_vec_clear(t, 72);
}

extern const jlt_ball_table jlt_balls_spherical_top_balanced_general_in_regular;
const jlt_ball_table jlt_balls_spherical_top_balanced_general_in_regular = {
    .model = "spherical_top_balanced", .time = "regular", .elimination = "",
    .state_count = 4, .param_count = 6,
    .rhs = general_in_regular_rhs,
    .jacobian = general_in_regular_jacobian,
    .divergence = general_in_regular_divergence,
    .integral_count = 1,
    .integral = general_in_regular_integral,
    .integral_values = general_in_regular_integral_values,
    .integral_gradients = general_in_regular_integral_gradients,
};

