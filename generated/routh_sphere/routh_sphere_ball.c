/* Sphere with displaced centre of mass rolling without slipping, reduced system: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      routh_sphere, SHA-256 3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2
 *  Command:    ttc generate --effort full --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(93);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 0, prec);
    arb_sub(t + 4, t + 0, t + 3, prec);
    arb_sqrt(t + 5, t + 4, prec); /* s */
    arb_mul(t + 6, x + 1, t + 5, prec);
    arb_mul(t + 8, x + 0, params + 4, prec);
    arb_mul(t + 10, x + 2, x + 2, prec);
    arb_mul(t + 11, t + 8, t + 10, prec);
    arb_mul(t + 14, params + 1, params + 1, prec);
    arb_mul(t + 16, params + 3, params + 3, prec);
    arb_add(t + 17, t + 14, t + 16, prec);
    arb_mul(t + 18, params + 1, params + 3, prec);
    arb_mul(t + 19, x + 0, t + 18, prec);
    arb_set_si(t + 20, 2);
    arb_mul(t + 21, t + 19, t + 20, prec);
    arb_add(t + 22, t + 17, t + 21, prec);
    arb_mul(t + 23, params + 0, t + 22, prec);
    arb_add(t + 24, params + 4, t + 23, prec); /* K */
    arb_mul(t + 25, t + 5, t + 24, prec);
    arb_div(t + 26, t + 11, t + 25, prec);
    arb_neg(t + 27, t + 26);
    arb_mul(t + 29, x + 2, params + 5, prec);
    arb_mul(t + 31, t + 29, x + 3, prec);
    arb_div(t + 32, t + 31, t + 24, prec);
    arb_sub(t + 33, t + 27, t + 32, prec);
    arb_mul(t + 34, x + 2, params + 0, prec);
    arb_mul(t + 35, x + 0, params + 3, prec);
    arb_add(t + 36, params + 1, t + 35, prec); /* e */
    arb_mul(t + 37, t + 34, t + 36, prec);
    arb_mul(t + 38, x + 0, params + 1, prec);
    arb_add(t + 39, params + 3, t + 38, prec); /* b */
    arb_mul(t + 40, x + 2, t + 39, prec);
    arb_mul(t + 41, params + 1, x + 3, prec);
    arb_mul(t + 42, t + 5, t + 41, prec);
    arb_add(t + 43, t + 40, t + 42, prec); /* v_tau */
    arb_mul(t + 44, t + 37, t + 43, prec);
    arb_div(t + 45, t + 44, t + 25, prec);
    arb_sub(t + 46, t + 33, t + 45, prec);
    arb_mul(t + 47, params + 0, params + 1, prec);
    arb_mul(t + 48, params + 3, t + 47, prec);
    arb_mul(t + 49, x + 1, x + 1, prec);
    arb_mul(t + 50, t + 48, t + 49, prec);
    arb_mul(t + 51, t + 5, t + 50, prec);
    arb_div(t + 52, t + 51, t + 24, prec);
    arb_sub(t + 53, t + 46, t + 52, prec);
    arb_mul(t + 55, params + 0, params + 2, prec);
    arb_mul(t + 56, params + 3, t + 55, prec);
    arb_mul(t + 57, t + 5, t + 56, prec);
    arb_div(t + 58, t + 57, t + 24, prec);
    arb_sub(t + 59, t + 53, t + 58, prec);
    arb_mul(t + 60, x + 1, x + 0, prec);
    arb_mul(t + 61, x + 2, t + 60, prec);
    arb_div(t + 62, t + 61, t + 5, prec);
    arb_mul(t + 63, params + 5, t + 47, prec);
    arb_mul(t + 64, x + 1, t + 63, prec);
    arb_mul(t + 65, x + 3, t + 64, prec);
    arb_mul(t + 66, t + 36, t + 65, prec);
    arb_mul(t + 67, params + 4, params + 5, prec);
    arb_mul(t + 68, params + 0, t + 14, prec);
    arb_mul(t + 69, params + 4, t + 68, prec);
    arb_mul(t + 70, t + 5, t + 5, prec);
    arb_mul(t + 71, t + 69, t + 70, prec);
    arb_add(t + 72, t + 67, t + 71, prec);
    arb_mul(t + 73, params + 0, params + 5, prec);
    arb_mul(t + 74, t + 39, t + 39, prec);
    arb_mul(t + 75, t + 73, t + 74, prec);
    arb_add(t + 76, t + 72, t + 75, prec); /* Theta */
    arb_div(t + 77, t + 66, t + 76, prec);
    arb_add(t + 78, t + 62, t + 77, prec);
    arb_mul(t + 79, params + 5, params + 5, prec);
    arb_mul(t + 80, x + 1, t + 79, prec);
    arb_mul(t + 81, x + 3, t + 80, prec);
    arb_div(t + 82, t + 81, t + 76, prec);
    arb_add(t + 83, t + 78, t + 82, prec);
    arb_mul(t + 84, x + 1, t + 47, prec);
    arb_mul(t + 85, x + 3, t + 84, prec);
    arb_mul(t + 86, t + 5, t + 85, prec);
    arb_sub(t + 87, params + 4, params + 5, prec);
    arb_mul(t + 88, t + 38, t + 87, prec);
    arb_mul(t + 89, params + 3, params + 5, prec);
    arb_sub(t + 90, t + 88, t + 89, prec);
    arb_mul(t + 91, t + 86, t + 90, prec);
    arb_div(t + 92, t + 91, t + 76, prec);
    arb_set(out + 0, t + 6);
    arb_set(out + 1, t + 59);
    arb_set(out + 2, t + 83);
    arb_set(out + 3, t + 92);
    _arb_vec_clear(t, 93);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(227);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 1, prec);
    arb_mul(t + 4, x + 0, x + 0, prec);
    arb_sub(t + 5, t + 0, t + 4, prec);
    arb_sqrt(t + 6, t + 5, prec); /* s */
    arb_div(t + 7, t + 3, t + 6, prec);
    arb_neg(t + 8, t + 7);
    arb_set_si(t + 9, 0);
    arb_mul(t + 12, x + 2, x + 2, prec);
    arb_mul(t + 13, params + 4, t + 12, prec);
    arb_mul(t + 16, params + 1, params + 1, prec);
    arb_mul(t + 18, params + 3, params + 3, prec);
    arb_add(t + 19, t + 16, t + 18, prec);
    arb_mul(t + 20, params + 1, params + 3, prec);
    arb_mul(t + 21, x + 0, t + 20, prec);
    arb_set_si(t + 22, 2);
    arb_mul(t + 23, t + 21, t + 22, prec);
    arb_add(t + 24, t + 19, t + 23, prec);
    arb_mul(t + 25, params + 0, t + 24, prec);
    arb_add(t + 26, params + 4, t + 25, prec); /* K */
    arb_mul(t + 27, t + 6, t + 26, prec);
    arb_div(t + 28, t + 13, t + 27, prec);
    arb_neg(t + 29, t + 28);
    arb_mul(t + 30, t + 4, params + 4, prec);
    arb_mul(t + 31, t + 12, t + 30, prec);
    arb_mul(t + 32, t + 6, t + 6, prec);
    arb_mul(t + 33, t + 6, t + 32, prec);
    arb_mul(t + 34, t + 26, t + 33, prec);
    arb_div(t + 35, t + 31, t + 34, prec);
    arb_sub(t + 36, t + 29, t + 35, prec);
    arb_mul(t + 37, params + 0, params + 1, prec);
    arb_mul(t + 38, params + 3, t + 37, prec);
    arb_mul(t + 39, params + 4, t + 38, prec);
    arb_mul(t + 40, x + 0, t + 39, prec);
    arb_mul(t + 41, t + 12, t + 40, prec);
    arb_mul(t + 42, t + 26, t + 26, prec);
    arb_mul(t + 43, t + 6, t + 42, prec);
    arb_div(t + 44, t + 41, t + 43, prec);
    arb_mul(t + 45, t + 22, t + 44, prec);
    arb_add(t + 46, t + 36, t + 45, prec);
    arb_mul(t + 48, t + 38, params + 5, prec);
    arb_mul(t + 49, x + 2, t + 48, prec);
    arb_mul(t + 51, t + 49, x + 3, prec);
    arb_div(t + 52, t + 51, t + 42, prec);
    arb_mul(t + 53, t + 22, t + 52, prec);
    arb_add(t + 54, t + 46, t + 53, prec);
    arb_mul(t + 55, params + 0, params + 3, prec);
    arb_mul(t + 56, x + 2, t + 55, prec);
    arb_mul(t + 57, x + 0, params + 1, prec);
    arb_add(t + 58, params + 3, t + 57, prec); /* b */
    arb_mul(t + 59, x + 2, t + 58, prec);
    arb_mul(t + 60, params + 1, x + 3, prec);
    arb_mul(t + 61, t + 6, t + 60, prec);
    arb_add(t + 62, t + 59, t + 61, prec); /* v_tau */
    arb_mul(t + 63, t + 56, t + 62, prec);
    arb_div(t + 64, t + 63, t + 27, prec);
    arb_sub(t + 65, t + 54, t + 64, prec);
    arb_mul(t + 66, x + 2, params + 0, prec);
    arb_mul(t + 67, x + 0, params + 3, prec);
    arb_add(t + 68, params + 1, t + 67, prec); /* e */
    arb_mul(t + 69, t + 66, t + 68, prec);
    arb_mul(t + 70, x + 2, params + 1, prec);
    arb_mul(t + 71, x + 3, t + 57, prec);
    arb_div(t + 72, t + 71, t + 6, prec);
    arb_sub(t + 73, t + 70, t + 72, prec); /* d(v_tau)/d(gamma3) */
    arb_mul(t + 74, t + 69, t + 73, prec);
    arb_div(t + 75, t + 74, t + 27, prec);
    arb_sub(t + 76, t + 65, t + 75, prec);
    arb_mul(t + 77, x + 0, params + 0, prec);
    arb_mul(t + 78, x + 2, t + 77, prec);
    arb_mul(t + 79, t + 68, t + 78, prec);
    arb_mul(t + 80, t + 62, t + 79, prec);
    arb_div(t + 81, t + 80, t + 34, prec);
    arb_sub(t + 82, t + 76, t + 81, prec);
    arb_mul(t + 83, params + 0, params + 0, prec);
    arb_mul(t + 84, params + 1, t + 83, prec);
    arb_mul(t + 85, params + 3, t + 84, prec);
    arb_mul(t + 86, x + 2, t + 85, prec);
    arb_mul(t + 87, t + 68, t + 86, prec);
    arb_mul(t + 88, t + 62, t + 87, prec);
    arb_div(t + 89, t + 88, t + 43, prec);
    arb_mul(t + 90, t + 22, t + 89, prec);
    arb_add(t + 91, t + 82, t + 90, prec);
    arb_mul(t + 92, x + 0, t + 38, prec);
    arb_mul(t + 93, x + 1, x + 1, prec);
    arb_mul(t + 94, t + 92, t + 93, prec);
    arb_div(t + 95, t + 94, t + 27, prec);
    arb_add(t + 96, t + 91, t + 95, prec);
    arb_mul(t + 97, t + 16, t + 83, prec);
    arb_mul(t + 98, t + 18, t + 97, prec);
    arb_mul(t + 99, t + 93, t + 98, prec);
    arb_mul(t + 100, t + 6, t + 99, prec);
    arb_div(t + 101, t + 100, t + 42, prec);
    arb_mul(t + 102, t + 22, t + 101, prec);
    arb_add(t + 103, t + 96, t + 102, prec);
    arb_mul(t + 105, params + 0, params + 2, prec);
    arb_mul(t + 106, params + 3, t + 105, prec);
    arb_mul(t + 107, x + 0, t + 106, prec);
    arb_div(t + 108, t + 107, t + 27, prec);
    arb_add(t + 109, t + 103, t + 108, prec);
    arb_mul(t + 110, t + 84, params + 2, prec);
    arb_mul(t + 111, t + 18, t + 110, prec);
    arb_mul(t + 112, t + 6, t + 111, prec);
    arb_div(t + 113, t + 112, t + 42, prec);
    arb_mul(t + 114, t + 22, t + 113, prec);
    arb_add(t + 115, t + 109, t + 114, prec);
    arb_set_si(t + 116, -2);
    arb_mul(t + 117, params + 0, t + 116, prec);
    arb_mul(t + 118, params + 1, t + 117, prec);
    arb_mul(t + 119, params + 3, t + 118, prec);
    arb_mul(t + 120, x + 1, t + 119, prec);
    arb_mul(t + 121, t + 6, t + 120, prec);
    arb_div(t + 122, t + 121, t + 26, prec);
    arb_mul(t + 123, x + 0, params + 4, prec);
    arb_mul(t + 124, x + 2, t + 123, prec);
    arb_div(t + 125, t + 124, t + 27, prec);
    arb_mul(t + 126, t + 22, t + 125, prec);
    arb_neg(t + 127, t + 126);
    arb_mul(t + 128, params + 5, x + 3, prec);
    arb_div(t + 129, t + 128, t + 26, prec);
    arb_sub(t + 130, t + 127, t + 129, prec);
    arb_mul(t + 131, params + 0, t + 68, prec);
    arb_mul(t + 132, t + 62, t + 131, prec);
    arb_div(t + 133, t + 132, t + 27, prec);
    arb_sub(t + 134, t + 130, t + 133, prec);
    arb_mul(t + 135, t + 58, t + 66, prec);
    arb_mul(t + 136, t + 68, t + 135, prec);
    arb_div(t + 137, t + 136, t + 27, prec);
    arb_sub(t + 138, t + 134, t + 137, prec);
    arb_mul(t + 139, x + 2, params + 5, prec);
    arb_div(t + 140, t + 139, t + 26, prec);
    arb_neg(t + 141, t + 140);
    arb_mul(t + 142, x + 2, t + 37, prec);
    arb_mul(t + 143, t + 68, t + 142, prec);
    arb_div(t + 144, t + 143, t + 26, prec);
    arb_sub(t + 145, t + 141, t + 144, prec);
    arb_mul(t + 146, x + 1, x + 2, prec);
    arb_div(t + 147, t + 146, t + 6, prec);
    arb_mul(t + 148, x + 1, t + 4, prec);
    arb_mul(t + 149, x + 2, t + 148, prec);
    arb_div(t + 150, t + 149, t + 33, prec);
    arb_add(t + 151, t + 147, t + 150, prec);
    arb_mul(t + 152, x + 1, t + 48, prec);
    arb_mul(t + 153, x + 3, t + 152, prec);
    arb_mul(t + 154, params + 4, params + 5, prec);
    arb_mul(t + 155, params + 0, t + 16, prec);
    arb_mul(t + 156, params + 4, t + 155, prec);
    arb_mul(t + 157, t + 32, t + 156, prec);
    arb_add(t + 158, t + 154, t + 157, prec);
    arb_mul(t + 159, params + 0, params + 5, prec);
    arb_mul(t + 160, t + 58, t + 58, prec);
    arb_mul(t + 161, t + 159, t + 160, prec);
    arb_add(t + 162, t + 158, t + 161, prec); /* Theta */
    arb_div(t + 163, t + 153, t + 162, prec);
    arb_add(t + 164, t + 151, t + 163, prec);
    arb_mul(t + 165, t + 37, params + 5, prec);
    arb_mul(t + 166, x + 1, t + 165, prec);
    arb_mul(t + 167, x + 3, t + 166, prec);
    arb_mul(t + 168, t + 68, t + 167, prec);
    arb_mul(t + 169, t + 162, t + 162, prec);
    arb_mul(t + 170, x + 0, t + 156, prec);
    arb_mul(t + 171, t + 22, t + 170, prec);
    arb_mul(t + 172, t + 58, t + 165, prec);
    arb_mul(t + 173, t + 22, t + 172, prec);
    arb_sub(t + 174, t + 173, t + 171, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 175, t + 168, t + 174, prec);
    arb_div(t + 176, t + 175, t + 169, prec);
    arb_sub(t + 177, t + 164, t + 176, prec);
    arb_mul(t + 178, params + 5, params + 5, prec);
    arb_mul(t + 179, x + 1, t + 178, prec);
    arb_mul(t + 180, x + 3, t + 179, prec);
    arb_mul(t + 181, t + 174, t + 180, prec);
    arb_div(t + 182, t + 181, t + 169, prec);
    arb_sub(t + 183, t + 177, t + 182, prec);
    arb_mul(t + 184, x + 0, x + 2, prec);
    arb_div(t + 185, t + 184, t + 6, prec);
    arb_mul(t + 186, x + 3, t + 165, prec);
    arb_mul(t + 187, t + 68, t + 186, prec);
    arb_div(t + 188, t + 187, t + 162, prec);
    arb_add(t + 189, t + 185, t + 188, prec);
    arb_mul(t + 190, x + 3, t + 178, prec);
    arb_div(t + 191, t + 190, t + 162, prec);
    arb_add(t + 192, t + 189, t + 191, prec);
    arb_mul(t + 193, t + 68, t + 166, prec);
    arb_div(t + 194, t + 193, t + 162, prec);
    arb_div(t + 195, t + 179, t + 162, prec);
    arb_add(t + 196, t + 194, t + 195, prec);
    arb_mul(t + 197, x + 1, t + 37, prec);
    arb_mul(t + 198, x + 3, t + 197, prec);
    arb_mul(t + 199, t + 6, t + 198, prec);
    arb_sub(t + 200, params + 4, params + 5, prec);
    arb_mul(t + 201, t + 57, t + 200, prec);
    arb_mul(t + 202, params + 3, params + 5, prec);
    arb_sub(t + 203, t + 201, t + 202, prec);
    arb_mul(t + 204, t + 199, t + 203, prec);
    arb_mul(t + 205, t + 174, t + 204, prec);
    arb_div(t + 206, t + 205, t + 169, prec);
    arb_mul(t + 207, x + 1, t + 155, prec);
    arb_mul(t + 208, x + 3, t + 207, prec);
    arb_mul(t + 209, t + 6, t + 208, prec);
    arb_mul(t + 210, t + 200, t + 209, prec);
    arb_div(t + 211, t + 210, t + 162, prec);
    arb_sub(t + 212, t + 211, t + 206, prec);
    arb_mul(t + 213, x + 0, t + 37, prec);
    arb_mul(t + 214, x + 1, t + 213, prec);
    arb_mul(t + 215, x + 3, t + 214, prec);
    arb_mul(t + 216, t + 6, t + 162, prec);
    arb_mul(t + 217, t + 203, t + 215, prec);
    arb_div(t + 218, t + 217, t + 216, prec);
    arb_sub(t + 219, t + 212, t + 218, prec);
    arb_mul(t + 220, t + 37, x + 3, prec);
    arb_mul(t + 221, t + 6, t + 220, prec);
    arb_mul(t + 222, t + 203, t + 221, prec);
    arb_div(t + 223, t + 222, t + 162, prec);
    arb_mul(t + 224, t + 6, t + 197, prec);
    arb_mul(t + 225, t + 203, t + 224, prec);
    arb_div(t + 226, t + 225, t + 162, prec);
    arb_set(out + 0, t + 8);
    arb_set(out + 1, t + 6);
    arb_set(out + 2, t + 9);
    arb_set(out + 3, t + 9);
    arb_set(out + 4, t + 115);
    arb_set(out + 5, t + 122);
    arb_set(out + 6, t + 138);
    arb_set(out + 7, t + 145);
    arb_set(out + 8, t + 183);
    arb_set(out + 9, t + 192);
    arb_set(out + 10, t + 7);
    arb_set(out + 11, t + 196);
    arb_set(out + 12, t + 219);
    arb_set(out + 13, t + 223);
    arb_set(out + 14, t + 9);
    arb_set(out + 15, t + 226);
    _arb_vec_clear(t, 227);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(48);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 0, params + 1, prec);
    arb_mul(t + 5, t + 3, params + 3, prec);
    arb_mul(t + 7, t + 5, x + 1, prec);
    arb_mul(t + 9, x + 0, x + 0, prec);
    arb_sub(t + 10, t + 0, t + 9, prec);
    arb_sqrt(t + 11, t + 10, prec); /* s */
    arb_mul(t + 12, t + 7, t + 11, prec);
    arb_mul(t + 14, params + 1, params + 1, prec);
    arb_mul(t + 15, params + 3, params + 3, prec);
    arb_add(t + 16, t + 14, t + 15, prec);
    arb_mul(t + 17, params + 1, params + 3, prec);
    arb_mul(t + 18, x + 0, t + 17, prec);
    arb_set_si(t + 19, 2);
    arb_mul(t + 20, t + 18, t + 19, prec);
    arb_add(t + 21, t + 16, t + 20, prec);
    arb_mul(t + 22, params + 0, t + 21, prec);
    arb_add(t + 23, params + 4, t + 22, prec); /* K */
    arb_div(t + 24, t + 12, t + 23, prec);
    arb_mul(t + 25, t + 19, t + 24, prec);
    arb_mul(t + 26, t + 3, x + 1, prec);
    arb_mul(t + 27, t + 11, t + 26, prec);
    arb_mul(t + 29, params + 4, params + 5, prec);
    arb_mul(t + 30, params + 0, t + 14, prec);
    arb_mul(t + 31, params + 4, t + 30, prec);
    arb_mul(t + 32, t + 11, t + 11, prec);
    arb_mul(t + 33, t + 31, t + 32, prec);
    arb_add(t + 34, t + 29, t + 33, prec);
    arb_mul(t + 35, params + 0, params + 5, prec);
    arb_mul(t + 36, params + 1, x + 0, prec);
    arb_add(t + 37, params + 3, t + 36, prec); /* b */
    arb_mul(t + 38, t + 37, t + 37, prec);
    arb_mul(t + 39, t + 35, t + 38, prec);
    arb_add(t + 40, t + 34, t + 39, prec); /* Theta */
    arb_sub(t + 41, params + 4, params + 5, prec);
    arb_mul(t + 42, t + 36, t + 41, prec);
    arb_mul(t + 43, params + 3, params + 5, prec);
    arb_sub(t + 44, t + 42, t + 43, prec);
    arb_mul(t + 45, t + 27, t + 44, prec);
    arb_div(t + 46, t + 45, t + 40, prec);
    arb_sub(t + 47, t + 46, t + 25, prec);
    arb_set(out + 0, t + 47);
    _arb_vec_clear(t, 48);
}

static const char *const general_integral[] = { "E", "Jellett", "Routh" };

static void general_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(66);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 0, params + 2, prec);
    arb_mul(t + 5, t + 3, params + 3, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, x + 1, x + 1, prec);
    arb_mul(t + 11, params + 3, x + 0, prec);
    arb_add(t + 12, params + 1, t + 11, prec); /* e */
    arb_mul(t + 13, t + 12, t + 12, prec);
    arb_mul(t + 14, t + 9, t + 13, prec);
    arb_mul(t + 16, x + 0, params + 1, prec);
    arb_add(t + 17, params + 3, t + 16, prec); /* b */
    arb_mul(t + 18, x + 2, t + 17, prec);
    arb_mul(t + 20, params + 1, x + 3, prec);
    arb_mul(t + 21, x + 0, x + 0, prec);
    arb_sub(t + 22, t + 0, t + 21, prec);
    arb_sqrt(t + 23, t + 22, prec); /* s */
    arb_mul(t + 24, t + 20, t + 23, prec);
    arb_add(t + 25, t + 18, t + 24, prec); /* v_tau */
    arb_mul(t + 26, t + 25, t + 25, prec);
    arb_add(t + 27, t + 14, t + 26, prec);
    arb_mul(t + 28, params + 3, params + 3, prec);
    arb_mul(t + 29, t + 9, t + 28, prec);
    arb_mul(t + 30, t + 23, t + 23, prec);
    arb_mul(t + 31, t + 29, t + 30, prec);
    arb_add(t + 32, t + 27, t + 31, prec);
    arb_mul(t + 33, params + 0, t + 32, prec);
    jlt_ball_rational(t + 34, "1/2", prec);
    arb_mul(t + 35, t + 33, t + 34, prec);
    arb_add(t + 36, t + 7, t + 35, prec);
    arb_mul(t + 38, x + 2, x + 2, prec);
    arb_add(t + 39, t + 9, t + 38, prec);
    arb_mul(t + 40, params + 4, t + 39, prec);
    arb_mul(t + 41, t + 34, t + 40, prec);
    arb_add(t + 42, t + 36, t + 41, prec);
    arb_mul(t + 44, x + 3, x + 3, prec);
    arb_mul(t + 45, params + 5, t + 44, prec);
    arb_mul(t + 46, t + 34, t + 45, prec);
    arb_add(t + 47, t + 42, t + 46, prec);
    arb_mul(t + 48, params + 1, params + 4, prec);
    arb_mul(t + 49, x + 2, t + 48, prec);
    arb_mul(t + 50, t + 23, t + 49, prec);
    arb_mul(t + 51, x + 3, params + 5, prec);
    arb_mul(t + 52, t + 17, t + 51, prec);
    arb_sub(t + 53, t + 50, t + 52, prec);
    arb_mul(t + 54, params + 4, params + 5, prec);
    arb_mul(t + 55, params + 1, params + 1, prec);
    arb_mul(t + 56, params + 0, t + 55, prec);
    arb_mul(t + 57, params + 4, t + 56, prec);
    arb_mul(t + 58, t + 30, t + 57, prec);
    arb_add(t + 59, t + 54, t + 58, prec);
    arb_mul(t + 60, params + 0, params + 5, prec);
    arb_mul(t + 61, t + 17, t + 17, prec);
    arb_mul(t + 62, t + 60, t + 61, prec);
    arb_add(t + 63, t + 59, t + 62, prec); /* Theta */
    arb_sqrt(t + 64, t + 63, prec); /* h */
    arb_mul(t + 65, x + 3, t + 64, prec);
    arb_set(out + 0, t + 47);
    arb_set(out + 1, t + 53);
    arb_set(out + 2, t + 65);
    _arb_vec_clear(t, 66);
}

static void general_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(90);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, params + 0, params + 2, prec);
    arb_mul(t + 6, t + 4, params + 3, prec);
    arb_mul(t + 8, x + 1, x + 1, prec);
    arb_mul(t + 9, params + 3, t + 8, prec);
    arb_mul(t + 12, params + 3, x + 0, prec);
    arb_add(t + 13, params + 1, t + 12, prec); /* e */
    arb_mul(t + 14, t + 9, t + 13, prec);
    arb_mul(t + 16, params + 1, x + 0, prec);
    arb_add(t + 17, params + 3, t + 16, prec); /* b */
    arb_mul(t + 18, x + 2, t + 17, prec);
    arb_mul(t + 20, params + 1, x + 3, prec);
    arb_mul(t + 21, x + 0, x + 0, prec);
    arb_sub(t + 22, t + 1, t + 21, prec);
    arb_sqrt(t + 23, t + 22, prec); /* s */
    arb_mul(t + 24, t + 20, t + 23, prec);
    arb_add(t + 25, t + 18, t + 24, prec); /* v_tau */
    arb_mul(t + 26, params + 1, x + 2, prec);
    arb_mul(t + 27, t + 16, x + 3, prec);
    arb_div(t + 28, t + 27, t + 23, prec);
    arb_sub(t + 29, t + 26, t + 28, prec); /* d(v_tau)/d(gamma3) */
    arb_mul(t + 30, t + 25, t + 29, prec);
    arb_add(t + 31, t + 14, t + 30, prec);
    arb_mul(t + 32, params + 3, params + 3, prec);
    arb_mul(t + 33, x + 0, t + 32, prec);
    arb_mul(t + 34, t + 8, t + 33, prec);
    arb_sub(t + 35, t + 31, t + 34, prec);
    arb_mul(t + 36, params + 0, t + 35, prec);
    arb_add(t + 37, t + 6, t + 36, prec);
    arb_mul(t + 38, t + 13, t + 13, prec);
    arb_mul(t + 39, x + 1, t + 38, prec);
    arb_mul(t + 40, x + 1, t + 32, prec);
    arb_mul(t + 41, t + 23, t + 23, prec);
    arb_mul(t + 42, t + 40, t + 41, prec);
    arb_add(t + 43, t + 39, t + 42, prec);
    arb_mul(t + 44, params + 0, t + 43, prec);
    arb_mul(t + 46, x + 1, params + 4, prec);
    arb_add(t + 47, t + 44, t + 46, prec);
    arb_mul(t + 48, params + 0, t + 17, prec);
    arb_mul(t + 49, t + 25, t + 48, prec);
    arb_mul(t + 50, x + 2, params + 4, prec);
    arb_add(t + 51, t + 49, t + 50, prec);
    arb_mul(t + 53, x + 3, params + 5, prec);
    arb_mul(t + 54, params + 0, params + 1, prec);
    arb_mul(t + 55, t + 23, t + 54, prec);
    arb_mul(t + 56, t + 25, t + 55, prec);
    arb_add(t + 57, t + 53, t + 56, prec);
    arb_mul(t + 58, params + 1, params + 4, prec);
    arb_mul(t + 59, x + 0, t + 58, prec);
    arb_mul(t + 60, x + 2, t + 59, prec);
    arb_div(t + 61, t + 60, t + 23, prec);
    arb_neg(t + 62, t + 61);
    arb_mul(t + 63, params + 1, params + 5, prec);
    arb_mul(t + 64, x + 3, t + 63, prec);
    arb_sub(t + 65, t + 62, t + 64, prec);
    arb_mul(t + 66, t + 23, t + 58, prec);
    arb_mul(t + 67, t + 17, params + 5, prec);
    arb_neg(t + 68, t + 67);
    arb_set_si(t + 69, 2);
    arb_mul(t + 70, params + 4, params + 5, prec);
    arb_mul(t + 71, params + 1, params + 1, prec);
    arb_mul(t + 72, params + 0, t + 71, prec);
    arb_mul(t + 73, params + 4, t + 72, prec);
    arb_mul(t + 74, t + 41, t + 73, prec);
    arb_add(t + 75, t + 70, t + 74, prec);
    arb_mul(t + 76, params + 0, params + 5, prec);
    arb_mul(t + 77, t + 17, t + 17, prec);
    arb_mul(t + 78, t + 76, t + 77, prec);
    arb_add(t + 79, t + 75, t + 78, prec); /* Theta */
    arb_sqrt(t + 80, t + 79, prec); /* h */
    arb_mul(t + 81, t + 69, t + 80, prec);
    arb_mul(t + 82, x + 0, t + 73, prec);
    arb_mul(t + 83, t + 69, t + 82, prec);
    arb_mul(t + 84, params + 5, t + 54, prec);
    arb_mul(t + 85, t + 17, t + 84, prec);
    arb_mul(t + 86, t + 69, t + 85, prec);
    arb_sub(t + 87, t + 86, t + 83, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 88, x + 3, t + 87, prec);
    arb_div(t + 89, t + 88, t + 81, prec);
    arb_set(out + 0, t + 37);
    arb_set(out + 1, t + 47);
    arb_set(out + 2, t + 51);
    arb_set(out + 3, t + 57);
    arb_set(out + 4, t + 65);
    arb_set(out + 5, t + 0);
    arb_set(out + 6, t + 66);
    arb_set(out + 7, t + 68);
    arb_set(out + 8, t + 89);
    arb_set(out + 9, t + 0);
    arb_set(out + 10, t + 0);
    arb_set(out + 11, t + 80);
    _arb_vec_clear(t, 90);
}

extern const jlt_ball_table jlt_balls_routh_sphere_general;
const jlt_ball_table jlt_balls_routh_sphere_general = {
    .model = "routh_sphere", .time = "", .elimination = "",
    .state_count = 4, .param_count = 6,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
    .integral_count = 3,
    .integral = general_integral,
    .integral_values = general_integral_values,
    .integral_gradients = general_integral_gradients,
};

static void general_in_regular_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(93);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, x + 4, x + 4, prec);
    arb_mul(t + 3, x + 1, t + 2, prec);
    arb_mul(t + 6, params + 4, x + 0, prec);
    arb_mul(t + 8, x + 2, x + 2, prec);
    arb_mul(t + 9, t + 6, t + 8, prec);
    arb_mul(t + 12, params + 1, params + 1, prec);
    arb_mul(t + 14, params + 3, params + 3, prec);
    arb_add(t + 15, t + 12, t + 14, prec);
    arb_mul(t + 16, params + 1, params + 3, prec);
    arb_mul(t + 17, x + 0, t + 16, prec);
    arb_set_si(t + 18, 2);
    arb_mul(t + 19, t + 17, t + 18, prec);
    arb_add(t + 20, t + 15, t + 19, prec);
    arb_mul(t + 21, params + 0, t + 20, prec);
    arb_add(t + 22, params + 4, t + 21, prec); /* K */
    arb_div(t + 23, t + 9, t + 22, prec);
    arb_neg(t + 24, t + 23);
    arb_mul(t + 26, x + 2, params + 5, prec);
    arb_mul(t + 28, t + 26, x + 3, prec);
    arb_mul(t + 29, x + 4, t + 28, prec);
    arb_div(t + 30, t + 29, t + 22, prec);
    arb_sub(t + 31, t + 24, t + 30, prec);
    arb_mul(t + 32, x + 2, params + 0, prec);
    arb_mul(t + 33, x + 0, params + 3, prec);
    arb_add(t + 34, params + 1, t + 33, prec); /* e */
    arb_mul(t + 35, t + 32, t + 34, prec);
    arb_mul(t + 36, x + 0, params + 1, prec);
    arb_add(t + 37, params + 3, t + 36, prec); /* b */
    arb_mul(t + 38, x + 2, t + 37, prec);
    arb_mul(t + 39, params + 1, x + 3, prec);
    arb_mul(t + 40, x + 4, t + 39, prec);
    arb_add(t + 41, t + 38, t + 40, prec); /* v_tau */
    arb_mul(t + 42, t + 35, t + 41, prec);
    arb_div(t + 43, t + 42, t + 22, prec);
    arb_sub(t + 44, t + 31, t + 43, prec);
    arb_mul(t + 45, params + 0, params + 1, prec);
    arb_mul(t + 46, params + 3, t + 45, prec);
    arb_mul(t + 47, x + 1, x + 1, prec);
    arb_mul(t + 48, t + 46, t + 47, prec);
    arb_mul(t + 49, t + 2, t + 48, prec);
    arb_div(t + 50, t + 49, t + 22, prec);
    arb_sub(t + 51, t + 44, t + 50, prec);
    arb_mul(t + 53, params + 0, params + 2, prec);
    arb_mul(t + 54, params + 3, t + 53, prec);
    arb_mul(t + 55, t + 2, t + 54, prec);
    arb_div(t + 56, t + 55, t + 22, prec);
    arb_sub(t + 57, t + 51, t + 56, prec);
    arb_mul(t + 58, x + 1, x + 0, prec);
    arb_mul(t + 59, x + 2, t + 58, prec);
    arb_mul(t + 60, params + 5, t + 45, prec);
    arb_mul(t + 61, x + 1, t + 60, prec);
    arb_mul(t + 62, x + 3, t + 61, prec);
    arb_mul(t + 63, x + 4, t + 62, prec);
    arb_mul(t + 64, t + 34, t + 63, prec);
    arb_mul(t + 65, params + 4, params + 5, prec);
    arb_mul(t + 66, params + 0, t + 12, prec);
    arb_mul(t + 67, params + 4, t + 66, prec);
    arb_mul(t + 68, t + 2, t + 67, prec);
    arb_add(t + 69, t + 65, t + 68, prec);
    arb_mul(t + 70, params + 0, params + 5, prec);
    arb_mul(t + 71, t + 37, t + 37, prec);
    arb_mul(t + 72, t + 70, t + 71, prec);
    arb_add(t + 73, t + 69, t + 72, prec); /* Theta */
    arb_div(t + 74, t + 64, t + 73, prec);
    arb_add(t + 75, t + 59, t + 74, prec);
    arb_mul(t + 76, params + 5, params + 5, prec);
    arb_mul(t + 77, x + 1, t + 76, prec);
    arb_mul(t + 78, x + 3, t + 77, prec);
    arb_mul(t + 79, x + 4, t + 78, prec);
    arb_div(t + 80, t + 79, t + 73, prec);
    arb_add(t + 81, t + 75, t + 80, prec);
    arb_mul(t + 82, x + 1, t + 45, prec);
    arb_mul(t + 83, x + 3, t + 82, prec);
    arb_mul(t + 84, t + 2, t + 83, prec);
    arb_sub(t + 85, params + 4, params + 5, prec);
    arb_mul(t + 86, t + 36, t + 85, prec);
    arb_mul(t + 87, params + 3, params + 5, prec);
    arb_sub(t + 88, t + 86, t + 87, prec);
    arb_mul(t + 89, t + 84, t + 88, prec);
    arb_div(t + 90, t + 89, t + 73, prec);
    arb_mul(t + 91, x + 4, t + 58, prec);
    arb_neg(t + 92, t + 91);
    arb_set(out + 0, t + 3);
    arb_set(out + 1, t + 57);
    arb_set(out + 2, t + 81);
    arb_set(out + 3, t + 90);
    arb_set(out + 4, t + 92);
    _arb_vec_clear(t, 93);
}

static void general_in_regular_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(259);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_mul(t + 2, x + 4, x + 4, prec);
    arb_set_si(t + 3, 2);
    arb_mul(t + 5, t + 3, x + 1, prec);
    arb_mul(t + 6, x + 4, t + 5, prec);
    arb_mul(t + 9, x + 2, x + 2, prec);
    arb_mul(t + 10, params + 4, t + 9, prec);
    arb_mul(t + 13, params + 1, params + 1, prec);
    arb_mul(t + 15, params + 3, params + 3, prec);
    arb_add(t + 16, t + 13, t + 15, prec);
    arb_mul(t + 17, params + 1, params + 3, prec);
    arb_mul(t + 19, t + 17, x + 0, prec);
    arb_mul(t + 20, t + 3, t + 19, prec);
    arb_add(t + 21, t + 16, t + 20, prec);
    arb_mul(t + 22, params + 0, t + 21, prec);
    arb_add(t + 23, params + 4, t + 22, prec); /* K */
    arb_div(t + 24, t + 10, t + 23, prec);
    arb_mul(t + 25, params + 0, params + 1, prec);
    arb_mul(t + 26, params + 3, t + 25, prec);
    arb_mul(t + 27, params + 4, t + 26, prec);
    arb_mul(t + 28, x + 0, t + 27, prec);
    arb_mul(t + 29, t + 9, t + 28, prec);
    arb_mul(t + 30, t + 23, t + 23, prec);
    arb_div(t + 31, t + 29, t + 30, prec);
    arb_mul(t + 32, t + 3, t + 31, prec);
    arb_sub(t + 33, t + 32, t + 24, prec);
    arb_mul(t + 35, t + 26, params + 5, prec);
    arb_mul(t + 36, x + 2, t + 35, prec);
    arb_mul(t + 38, t + 36, x + 3, prec);
    arb_mul(t + 39, x + 4, t + 38, prec);
    arb_div(t + 40, t + 39, t + 30, prec);
    arb_mul(t + 41, t + 3, t + 40, prec);
    arb_add(t + 42, t + 33, t + 41, prec);
    arb_mul(t + 43, params + 0, params + 3, prec);
    arb_mul(t + 44, x + 2, t + 43, prec);
    arb_mul(t + 45, params + 1, x + 0, prec);
    arb_add(t + 46, params + 3, t + 45, prec); /* b */
    arb_mul(t + 47, x + 2, t + 46, prec);
    arb_mul(t + 48, params + 1, x + 3, prec);
    arb_mul(t + 49, x + 4, t + 48, prec);
    arb_add(t + 50, t + 47, t + 49, prec); /* v_tau */
    arb_mul(t + 51, t + 44, t + 50, prec);
    arb_div(t + 52, t + 51, t + 23, prec);
    arb_sub(t + 53, t + 42, t + 52, prec);
    arb_mul(t + 54, t + 9, t + 25, prec);
    arb_mul(t + 55, params + 3, x + 0, prec);
    arb_add(t + 56, params + 1, t + 55, prec); /* e */
    arb_mul(t + 57, t + 54, t + 56, prec);
    arb_div(t + 58, t + 57, t + 23, prec);
    arb_sub(t + 59, t + 53, t + 58, prec);
    arb_mul(t + 60, params + 0, params + 0, prec);
    arb_mul(t + 61, params + 1, t + 60, prec);
    arb_mul(t + 62, params + 3, t + 61, prec);
    arb_mul(t + 63, x + 2, t + 62, prec);
    arb_mul(t + 64, t + 56, t + 63, prec);
    arb_mul(t + 65, t + 50, t + 64, prec);
    arb_div(t + 66, t + 65, t + 30, prec);
    arb_mul(t + 67, t + 3, t + 66, prec);
    arb_add(t + 68, t + 59, t + 67, prec);
    arb_mul(t + 69, t + 13, t + 60, prec);
    arb_mul(t + 70, t + 15, t + 69, prec);
    arb_mul(t + 71, x + 1, x + 1, prec);
    arb_mul(t + 72, t + 70, t + 71, prec);
    arb_mul(t + 73, t + 2, t + 72, prec);
    arb_div(t + 74, t + 73, t + 30, prec);
    arb_mul(t + 75, t + 3, t + 74, prec);
    arb_add(t + 76, t + 68, t + 75, prec);
    arb_mul(t + 78, t + 61, params + 2, prec);
    arb_mul(t + 79, t + 15, t + 78, prec);
    arb_mul(t + 80, t + 2, t + 79, prec);
    arb_div(t + 81, t + 80, t + 30, prec);
    arb_mul(t + 82, t + 3, t + 81, prec);
    arb_add(t + 83, t + 76, t + 82, prec);
    arb_set_si(t + 84, -2);
    arb_mul(t + 85, params + 0, t + 84, prec);
    arb_mul(t + 86, params + 1, t + 85, prec);
    arb_mul(t + 87, params + 3, t + 86, prec);
    arb_mul(t + 88, x + 1, t + 87, prec);
    arb_mul(t + 89, t + 2, t + 88, prec);
    arb_div(t + 90, t + 89, t + 23, prec);
    arb_mul(t + 91, params + 4, x + 0, prec);
    arb_mul(t + 92, x + 2, t + 91, prec);
    arb_div(t + 93, t + 92, t + 23, prec);
    arb_mul(t + 94, t + 3, t + 93, prec);
    arb_neg(t + 95, t + 94);
    arb_mul(t + 96, params + 5, x + 3, prec);
    arb_mul(t + 97, x + 4, t + 96, prec);
    arb_div(t + 98, t + 97, t + 23, prec);
    arb_sub(t + 99, t + 95, t + 98, prec);
    arb_mul(t + 100, params + 0, t + 56, prec);
    arb_mul(t + 101, t + 50, t + 100, prec);
    arb_div(t + 102, t + 101, t + 23, prec);
    arb_sub(t + 103, t + 99, t + 102, prec);
    arb_mul(t + 104, x + 2, params + 0, prec);
    arb_mul(t + 105, t + 46, t + 104, prec);
    arb_mul(t + 106, t + 56, t + 105, prec);
    arb_div(t + 107, t + 106, t + 23, prec);
    arb_sub(t + 108, t + 103, t + 107, prec);
    arb_mul(t + 109, x + 2, params + 5, prec);
    arb_mul(t + 110, x + 4, t + 109, prec);
    arb_div(t + 111, t + 110, t + 23, prec);
    arb_neg(t + 112, t + 111);
    arb_mul(t + 113, x + 2, t + 25, prec);
    arb_mul(t + 114, x + 4, t + 113, prec);
    arb_mul(t + 115, t + 56, t + 114, prec);
    arb_div(t + 116, t + 115, t + 23, prec);
    arb_sub(t + 117, t + 112, t + 116, prec);
    arb_mul(t + 118, x + 3, t + 109, prec);
    arb_div(t + 119, t + 118, t + 23, prec);
    arb_neg(t + 120, t + 119);
    arb_mul(t + 121, t + 26, t + 71, prec);
    arb_mul(t + 122, x + 4, t + 121, prec);
    arb_div(t + 123, t + 122, t + 23, prec);
    arb_mul(t + 124, t + 3, t + 123, prec);
    arb_sub(t + 125, t + 120, t + 124, prec);
    arb_mul(t + 126, params + 0, params + 2, prec);
    arb_mul(t + 127, params + 3, t + 126, prec);
    arb_mul(t + 128, x + 4, t + 127, prec);
    arb_div(t + 129, t + 128, t + 23, prec);
    arb_mul(t + 130, t + 3, t + 129, prec);
    arb_sub(t + 131, t + 125, t + 130, prec);
    arb_mul(t + 132, x + 3, t + 113, prec);
    arb_mul(t + 133, t + 56, t + 132, prec);
    arb_div(t + 134, t + 133, t + 23, prec);
    arb_sub(t + 135, t + 131, t + 134, prec);
    arb_mul(t + 136, x + 1, x + 2, prec);
    arb_mul(t + 137, x + 1, t + 35, prec);
    arb_mul(t + 138, x + 3, t + 137, prec);
    arb_mul(t + 139, x + 4, t + 138, prec);
    arb_mul(t + 140, params + 4, params + 5, prec);
    arb_mul(t + 141, params + 0, t + 13, prec);
    arb_mul(t + 142, params + 4, t + 141, prec);
    arb_mul(t + 143, t + 2, t + 142, prec);
    arb_add(t + 144, t + 140, t + 143, prec);
    arb_mul(t + 145, params + 0, params + 5, prec);
    arb_mul(t + 146, t + 46, t + 46, prec);
    arb_mul(t + 147, t + 145, t + 146, prec);
    arb_add(t + 148, t + 144, t + 147, prec); /* Theta */
    arb_div(t + 149, t + 139, t + 148, prec);
    arb_add(t + 150, t + 136, t + 149, prec);
    arb_mul(t + 151, params + 5, params + 5, prec);
    arb_mul(t + 152, t + 69, t + 151, prec);
    arb_mul(t + 153, x + 1, t + 152, prec);
    arb_mul(t + 154, x + 3, t + 153, prec);
    arb_mul(t + 155, x + 4, t + 154, prec);
    arb_mul(t + 156, t + 46, t + 155, prec);
    arb_mul(t + 157, t + 56, t + 156, prec);
    arb_mul(t + 158, t + 148, t + 148, prec);
    arb_div(t + 159, t + 157, t + 158, prec);
    arb_mul(t + 160, t + 3, t + 159, prec);
    arb_sub(t + 161, t + 150, t + 160, prec);
    arb_mul(t + 162, params + 5, t + 151, prec);
    arb_mul(t + 163, t + 25, t + 162, prec);
    arb_mul(t + 164, x + 1, t + 163, prec);
    arb_mul(t + 165, x + 3, t + 164, prec);
    arb_mul(t + 166, x + 4, t + 165, prec);
    arb_mul(t + 167, t + 46, t + 166, prec);
    arb_div(t + 168, t + 167, t + 158, prec);
    arb_mul(t + 169, t + 3, t + 168, prec);
    arb_sub(t + 170, t + 161, t + 169, prec);
    arb_mul(t + 171, x + 2, x + 0, prec);
    arb_mul(t + 172, t + 25, params + 5, prec);
    arb_mul(t + 173, x + 3, t + 172, prec);
    arb_mul(t + 174, x + 4, t + 173, prec);
    arb_mul(t + 175, t + 56, t + 174, prec);
    arb_div(t + 176, t + 175, t + 148, prec);
    arb_add(t + 177, t + 171, t + 176, prec);
    arb_mul(t + 178, x + 3, t + 151, prec);
    arb_mul(t + 179, x + 4, t + 178, prec);
    arb_div(t + 180, t + 179, t + 148, prec);
    arb_add(t + 181, t + 177, t + 180, prec);
    arb_mul(t + 182, x + 1, x + 0, prec);
    arb_mul(t + 183, x + 1, t + 172, prec);
    arb_mul(t + 184, x + 4, t + 183, prec);
    arb_mul(t + 185, t + 56, t + 184, prec);
    arb_div(t + 186, t + 185, t + 148, prec);
    arb_mul(t + 187, x + 1, t + 151, prec);
    arb_mul(t + 188, x + 4, t + 187, prec);
    arb_div(t + 189, t + 188, t + 148, prec);
    arb_add(t + 190, t + 186, t + 189, prec);
    arb_mul(t + 191, x + 3, t + 183, prec);
    arb_mul(t + 192, t + 56, t + 191, prec);
    arb_div(t + 193, t + 192, t + 148, prec);
    arb_mul(t + 194, x + 3, t + 187, prec);
    arb_div(t + 195, t + 194, t + 148, prec);
    arb_add(t + 196, t + 193, t + 195, prec);
    arb_mul(t + 197, params + 1, t + 13, prec);
    arb_mul(t + 198, t + 60, t + 197, prec);
    arb_mul(t + 199, params + 4, t + 198, prec);
    arb_mul(t + 200, params + 5, t + 199, prec);
    arb_mul(t + 201, x + 1, t + 200, prec);
    arb_mul(t + 202, x + 3, t + 201, prec);
    arb_mul(t + 203, t + 2, t + 202, prec);
    arb_mul(t + 204, t + 56, t + 203, prec);
    arb_div(t + 205, t + 204, t + 158, prec);
    arb_mul(t + 206, t + 3, t + 205, prec);
    arb_sub(t + 207, t + 196, t + 206, prec);
    arb_mul(t + 208, t + 142, t + 151, prec);
    arb_mul(t + 209, x + 1, t + 208, prec);
    arb_mul(t + 210, x + 3, t + 209, prec);
    arb_mul(t + 211, t + 2, t + 210, prec);
    arb_div(t + 212, t + 211, t + 158, prec);
    arb_mul(t + 213, t + 3, t + 212, prec);
    arb_sub(t + 214, t + 207, t + 213, prec);
    arb_mul(t + 215, x + 1, t + 141, prec);
    arb_mul(t + 216, x + 3, t + 215, prec);
    arb_mul(t + 217, t + 2, t + 216, prec);
    arb_sub(t + 218, params + 4, params + 5, prec);
    arb_mul(t + 219, t + 217, t + 218, prec);
    arb_div(t + 220, t + 219, t + 148, prec);
    arb_mul(t + 221, params + 5, t + 69, prec);
    arb_mul(t + 222, x + 1, t + 221, prec);
    arb_mul(t + 223, x + 3, t + 222, prec);
    arb_mul(t + 224, t + 2, t + 223, prec);
    arb_mul(t + 225, t + 46, t + 224, prec);
    arb_mul(t + 226, t + 45, t + 218, prec);
    arb_mul(t + 227, params + 3, params + 5, prec);
    arb_sub(t + 228, t + 226, t + 227, prec);
    arb_mul(t + 229, t + 225, t + 228, prec);
    arb_div(t + 230, t + 229, t + 158, prec);
    arb_mul(t + 231, t + 3, t + 230, prec);
    arb_sub(t + 232, t + 220, t + 231, prec);
    arb_mul(t + 233, t + 25, x + 3, prec);
    arb_mul(t + 234, t + 2, t + 233, prec);
    arb_mul(t + 235, t + 228, t + 234, prec);
    arb_div(t + 236, t + 235, t + 148, prec);
    arb_mul(t + 237, x + 1, t + 25, prec);
    arb_mul(t + 238, t + 2, t + 237, prec);
    arb_mul(t + 239, t + 228, t + 238, prec);
    arb_div(t + 240, t + 239, t + 148, prec);
    arb_mul(t + 241, x + 3, t + 237, prec);
    arb_mul(t + 242, x + 4, t + 241, prec);
    arb_mul(t + 243, t + 228, t + 242, prec);
    arb_div(t + 244, t + 243, t + 148, prec);
    arb_mul(t + 245, t + 3, t + 244, prec);
    arb_mul(t + 246, x + 1, t + 199, prec);
    arb_mul(t + 247, x + 3, t + 246, prec);
    arb_mul(t + 248, x + 4, t + 2, prec);
    arb_mul(t + 249, t + 247, t + 248, prec);
    arb_mul(t + 250, t + 228, t + 249, prec);
    arb_div(t + 251, t + 250, t + 158, prec);
    arb_mul(t + 252, t + 3, t + 251, prec);
    arb_sub(t + 253, t + 245, t + 252, prec);
    arb_mul(t + 254, x + 4, x + 1, prec);
    arb_neg(t + 255, t + 254);
    arb_mul(t + 256, x + 4, x + 0, prec);
    arb_neg(t + 257, t + 256);
    arb_neg(t + 258, t + 182);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 2);
    arb_set(out + 2, t + 0);
    arb_set(out + 3, t + 0);
    arb_set(out + 4, t + 6);
    arb_set(out + 5, t + 83);
    arb_set(out + 6, t + 90);
    arb_set(out + 7, t + 108);
    arb_set(out + 8, t + 117);
    arb_set(out + 9, t + 135);
    arb_set(out + 10, t + 170);
    arb_set(out + 11, t + 181);
    arb_set(out + 12, t + 182);
    arb_set(out + 13, t + 190);
    arb_set(out + 14, t + 214);
    arb_set(out + 15, t + 232);
    arb_set(out + 16, t + 236);
    arb_set(out + 17, t + 0);
    arb_set(out + 18, t + 240);
    arb_set(out + 19, t + 253);
    arb_set(out + 20, t + 255);
    arb_set(out + 21, t + 257);
    arb_set(out + 22, t + 0);
    arb_set(out + 23, t + 0);
    arb_set(out + 24, t + 258);
    _arb_vec_clear(t, 259);
}

static void general_in_regular_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(45);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 0, params + 1, prec);
    arb_mul(t + 4, t + 2, params + 3, prec);
    arb_mul(t + 6, t + 4, x + 1, prec);
    arb_mul(t + 8, x + 4, x + 4, prec);
    arb_mul(t + 9, t + 6, t + 8, prec);
    arb_mul(t + 11, params + 1, params + 1, prec);
    arb_mul(t + 12, params + 3, params + 3, prec);
    arb_add(t + 13, t + 11, t + 12, prec);
    arb_mul(t + 14, params + 1, params + 3, prec);
    arb_mul(t + 16, t + 14, x + 0, prec);
    arb_set_si(t + 17, 2);
    arb_mul(t + 18, t + 16, t + 17, prec);
    arb_add(t + 19, t + 13, t + 18, prec);
    arb_mul(t + 20, params + 0, t + 19, prec);
    arb_add(t + 21, params + 4, t + 20, prec); /* K */
    arb_div(t + 22, t + 9, t + 21, prec);
    arb_mul(t + 23, t + 17, t + 22, prec);
    arb_mul(t + 24, t + 2, x + 1, prec);
    arb_mul(t + 25, t + 8, t + 24, prec);
    arb_mul(t + 27, params + 4, params + 5, prec);
    arb_mul(t + 28, params + 0, t + 11, prec);
    arb_mul(t + 29, params + 4, t + 28, prec);
    arb_mul(t + 30, t + 8, t + 29, prec);
    arb_add(t + 31, t + 27, t + 30, prec);
    arb_mul(t + 32, params + 0, params + 5, prec);
    arb_mul(t + 33, params + 1, x + 0, prec);
    arb_add(t + 34, params + 3, t + 33, prec); /* b */
    arb_mul(t + 35, t + 34, t + 34, prec);
    arb_mul(t + 36, t + 32, t + 35, prec);
    arb_add(t + 37, t + 31, t + 36, prec); /* Theta */
    arb_sub(t + 38, params + 4, params + 5, prec);
    arb_mul(t + 39, t + 33, t + 38, prec);
    arb_mul(t + 40, params + 3, params + 5, prec);
    arb_sub(t + 41, t + 39, t + 40, prec);
    arb_mul(t + 42, t + 25, t + 41, prec);
    arb_div(t + 43, t + 42, t + 37, prec);
    arb_sub(t + 44, t + 43, t + 23, prec);
    arb_set(out + 0, t + 44);
    _arb_vec_clear(t, 45);
}

static const char *const general_in_regular_integral[] = { "E", "Jellett", "Routh" };

static void general_in_regular_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(63);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 0, params + 2, prec);
    arb_mul(t + 4, t + 2, params + 3, prec);
    arb_mul(t + 6, t + 4, x + 0, prec);
    arb_mul(t + 8, x + 1, x + 1, prec);
    arb_mul(t + 10, params + 3, x + 0, prec);
    arb_add(t + 11, params + 1, t + 10, prec); /* e */
    arb_mul(t + 12, t + 11, t + 11, prec);
    arb_mul(t + 13, t + 8, t + 12, prec);
    arb_mul(t + 15, x + 0, params + 1, prec);
    arb_add(t + 16, params + 3, t + 15, prec); /* b */
    arb_mul(t + 17, x + 2, t + 16, prec);
    arb_mul(t + 19, params + 1, x + 3, prec);
    arb_mul(t + 21, t + 19, x + 4, prec);
    arb_add(t + 22, t + 17, t + 21, prec); /* v_tau */
    arb_mul(t + 23, t + 22, t + 22, prec);
    arb_add(t + 24, t + 13, t + 23, prec);
    arb_mul(t + 25, params + 3, params + 3, prec);
    arb_mul(t + 26, t + 8, t + 25, prec);
    arb_mul(t + 27, x + 4, x + 4, prec);
    arb_mul(t + 28, t + 26, t + 27, prec);
    arb_add(t + 29, t + 24, t + 28, prec);
    arb_mul(t + 30, params + 0, t + 29, prec);
    jlt_ball_rational(t + 31, "1/2", prec);
    arb_mul(t + 32, t + 30, t + 31, prec);
    arb_add(t + 33, t + 6, t + 32, prec);
    arb_mul(t + 35, x + 2, x + 2, prec);
    arb_add(t + 36, t + 8, t + 35, prec);
    arb_mul(t + 37, params + 4, t + 36, prec);
    arb_mul(t + 38, t + 31, t + 37, prec);
    arb_add(t + 39, t + 33, t + 38, prec);
    arb_mul(t + 41, x + 3, x + 3, prec);
    arb_mul(t + 42, params + 5, t + 41, prec);
    arb_mul(t + 43, t + 31, t + 42, prec);
    arb_add(t + 44, t + 39, t + 43, prec);
    arb_mul(t + 45, params + 1, params + 4, prec);
    arb_mul(t + 46, x + 2, t + 45, prec);
    arb_mul(t + 47, x + 4, t + 46, prec);
    arb_mul(t + 48, x + 3, params + 5, prec);
    arb_mul(t + 49, t + 16, t + 48, prec);
    arb_sub(t + 50, t + 47, t + 49, prec);
    arb_mul(t + 51, params + 4, params + 5, prec);
    arb_mul(t + 52, params + 1, params + 1, prec);
    arb_mul(t + 53, params + 0, t + 52, prec);
    arb_mul(t + 54, params + 4, t + 53, prec);
    arb_mul(t + 55, t + 27, t + 54, prec);
    arb_add(t + 56, t + 51, t + 55, prec);
    arb_mul(t + 57, params + 0, params + 5, prec);
    arb_mul(t + 58, t + 16, t + 16, prec);
    arb_mul(t + 59, t + 57, t + 58, prec);
    arb_add(t + 60, t + 56, t + 59, prec); /* Theta */
    arb_sqrt(t + 61, t + 60, prec); /* h */
    arb_mul(t + 62, x + 3, t + 61, prec);
    arb_set(out + 0, t + 44);
    arb_set(out + 1, t + 50);
    arb_set(out + 2, t + 62);
    _arb_vec_clear(t, 63);
}

static void general_in_regular_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(80);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_mul(t + 3, params + 0, params + 2, prec);
    arb_mul(t + 5, t + 3, params + 3, prec);
    arb_mul(t + 7, x + 1, x + 1, prec);
    arb_mul(t + 8, params + 3, t + 7, prec);
    arb_mul(t + 11, params + 3, x + 0, prec);
    arb_add(t + 12, params + 1, t + 11, prec); /* e */
    arb_mul(t + 13, t + 8, t + 12, prec);
    arb_mul(t + 15, params + 1, x + 2, prec);
    arb_mul(t + 16, params + 1, x + 0, prec);
    arb_add(t + 17, params + 3, t + 16, prec); /* b */
    arb_mul(t + 18, x + 2, t + 17, prec);
    arb_mul(t + 20, params + 1, x + 3, prec);
    arb_mul(t + 22, t + 20, x + 4, prec);
    arb_add(t + 23, t + 18, t + 22, prec); /* v_tau */
    arb_mul(t + 24, t + 15, t + 23, prec);
    arb_add(t + 25, t + 13, t + 24, prec);
    arb_mul(t + 26, params + 0, t + 25, prec);
    arb_add(t + 27, t + 5, t + 26, prec);
    arb_mul(t + 28, t + 12, t + 12, prec);
    arb_mul(t + 29, x + 1, t + 28, prec);
    arb_mul(t + 30, params + 3, params + 3, prec);
    arb_mul(t + 31, x + 1, t + 30, prec);
    arb_mul(t + 32, x + 4, x + 4, prec);
    arb_mul(t + 33, t + 31, t + 32, prec);
    arb_add(t + 34, t + 29, t + 33, prec);
    arb_mul(t + 35, params + 0, t + 34, prec);
    arb_mul(t + 37, x + 1, params + 4, prec);
    arb_add(t + 38, t + 35, t + 37, prec);
    arb_mul(t + 39, params + 0, t + 17, prec);
    arb_mul(t + 40, t + 23, t + 39, prec);
    arb_mul(t + 41, x + 2, params + 4, prec);
    arb_add(t + 42, t + 40, t + 41, prec);
    arb_mul(t + 44, x + 3, params + 5, prec);
    arb_mul(t + 45, params + 0, params + 1, prec);
    arb_mul(t + 46, x + 4, t + 45, prec);
    arb_mul(t + 47, t + 23, t + 46, prec);
    arb_add(t + 48, t + 44, t + 47, prec);
    arb_mul(t + 49, t + 7, t + 30, prec);
    arb_mul(t + 50, x + 4, t + 49, prec);
    arb_mul(t + 51, t + 20, t + 23, prec);
    arb_add(t + 52, t + 50, t + 51, prec);
    arb_mul(t + 53, params + 0, t + 52, prec);
    arb_mul(t + 54, params + 1, params + 5, prec);
    arb_mul(t + 55, x + 3, t + 54, prec);
    arb_neg(t + 56, t + 55);
    arb_mul(t + 57, params + 1, params + 4, prec);
    arb_mul(t + 58, x + 4, t + 57, prec);
    arb_mul(t + 59, t + 17, params + 5, prec);
    arb_neg(t + 60, t + 59);
    arb_mul(t + 61, x + 2, t + 57, prec);
    arb_mul(t + 62, params + 5, t + 45, prec);
    arb_mul(t + 63, x + 3, t + 62, prec);
    arb_mul(t + 64, t + 17, t + 63, prec);
    arb_mul(t + 65, params + 4, params + 5, prec);
    arb_mul(t + 66, params + 1, params + 1, prec);
    arb_mul(t + 67, params + 0, t + 66, prec);
    arb_mul(t + 68, params + 4, t + 67, prec);
    arb_mul(t + 69, t + 32, t + 68, prec);
    arb_add(t + 70, t + 65, t + 69, prec);
    arb_mul(t + 71, params + 0, params + 5, prec);
    arb_mul(t + 72, t + 17, t + 17, prec);
    arb_mul(t + 73, t + 71, t + 72, prec);
    arb_add(t + 74, t + 70, t + 73, prec); /* Theta */
    arb_sqrt(t + 75, t + 74, prec); /* h */
    arb_div(t + 76, t + 64, t + 75, prec);
    arb_mul(t + 77, x + 3, t + 68, prec);
    arb_mul(t + 78, x + 4, t + 77, prec);
    arb_div(t + 79, t + 78, t + 75, prec);
    arb_set(out + 0, t + 27);
    arb_set(out + 1, t + 38);
    arb_set(out + 2, t + 42);
    arb_set(out + 3, t + 48);
    arb_set(out + 4, t + 53);
    arb_set(out + 5, t + 56);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 58);
    arb_set(out + 8, t + 60);
    arb_set(out + 9, t + 61);
    arb_set(out + 10, t + 76);
    arb_set(out + 11, t + 0);
    arb_set(out + 12, t + 0);
    arb_set(out + 13, t + 75);
    arb_set(out + 14, t + 79);
    _arb_vec_clear(t, 80);
}

extern const jlt_ball_table jlt_balls_routh_sphere_general_in_regular;
const jlt_ball_table jlt_balls_routh_sphere_general_in_regular = {
    .model = "routh_sphere", .time = "regular", .elimination = "",
    .state_count = 5, .param_count = 6,
    .rhs = general_in_regular_rhs,
    .jacobian = general_in_regular_jacobian,
    .divergence = general_in_regular_divergence,
    .integral_count = 3,
    .integral = general_in_regular_integral,
    .integral_values = general_in_regular_integral_values,
    .integral_gradients = general_in_regular_integral_gradients,
};

