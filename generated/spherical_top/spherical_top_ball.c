/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system: enclosures in ball arithmetic,
 * from the expressions as they stand, without the optimizer.
 *
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 */
#include "kernel_ball.h"

static void general_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(102);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 0, prec);
    arb_sub(t + 4, t + 0, t + 3, prec);
    arb_sqrt(t + 5, t + 4, prec); /* s */
    arb_mul(t + 6, x + 2, t + 5, prec);
    arb_mul(t + 8, x + 3, x + 3, prec);
    arb_mul(t + 11, x + 0, params + 1, prec);
    arb_add(t + 12, params + 3, t + 11, prec); /* b */
    arb_mul(t + 13, t + 8, t + 12, prec);
    arb_div(t + 14, t + 13, t + 5, prec);
    arb_mul(t + 15, x + 3, params + 1, prec);
    arb_mul(t + 17, t + 15, x + 4, prec);
    arb_add(t + 18, t + 14, t + 17, prec);
    arb_mul(t + 20, params + 3, params + 3, prec);
    arb_mul(t + 21, params + 0, t + 20, prec);
    arb_mul(t + 22, x + 0, t + 21, prec);
    arb_mul(t + 23, x + 2, x + 2, prec);
    arb_mul(t + 24, t + 22, t + 23, prec);
    arb_mul(t + 25, t + 5, t + 24, prec);
    arb_mul(t + 27, t + 5, t + 5, prec);
    arb_mul(t + 28, t + 21, t + 27, prec);
    arb_add(t + 29, params + 4, t + 28, prec); /* D */
    arb_div(t + 30, t + 25, t + 29, prec);
    arb_mul(t + 32, params + 0, params + 2, prec);
    arb_mul(t + 33, params + 3, t + 32, prec);
    arb_mul(t + 34, t + 5, t + 33, prec);
    arb_div(t + 35, t + 34, t + 29, prec);
    arb_sub(t + 36, t + 30, t + 35, prec);
    arb_mul(t + 37, x + 0, params + 4, prec);
    arb_mul(t + 38, t + 8, t + 37, prec);
    arb_mul(t + 39, t + 5, t + 29, prec);
    arb_div(t + 40, t + 38, t + 39, prec);
    arb_sub(t + 41, t + 36, t + 40, prec);
    arb_mul(t + 43, x + 3, params + 5, prec);
    arb_mul(t + 44, x + 4, t + 43, prec);
    arb_div(t + 45, t + 44, t + 29, prec);
    arb_sub(t + 46, t + 41, t + 45, prec);
    arb_mul(t + 47, x + 2, x + 0, prec);
    arb_mul(t + 48, x + 3, t + 47, prec);
    arb_div(t + 49, t + 48, t + 5, prec);
    arb_mul(t + 50, params + 0, params + 5, prec);
    arb_mul(t + 51, x + 3, t + 50, prec);
    arb_mul(t + 52, t + 12, t + 51, prec);
    arb_mul(t + 53, params + 4, params + 5, prec);
    arb_mul(t + 54, params + 1, params + 1, prec);
    arb_mul(t + 55, params + 0, t + 54, prec);
    arb_mul(t + 56, params + 4, t + 55, prec);
    arb_mul(t + 57, t + 27, t + 56, prec);
    arb_add(t + 58, t + 53, t + 57, prec);
    arb_mul(t + 59, t + 12, t + 12, prec);
    arb_mul(t + 60, t + 50, t + 59, prec);
    arb_add(t + 61, t + 58, t + 60, prec); /* Theta */
    arb_mul(t + 62, t + 5, t + 61, prec);
    arb_mul(t + 64, x + 0, params + 3, prec);
    arb_add(t + 65, params + 1, t + 64, prec); /* e */
    arb_mul(t + 66, x + 2, t + 65, prec);
    arb_add(t + 67, x + 1, t + 66, prec); /* V */
    arb_mul(t + 68, t + 52, t + 67, prec);
    arb_div(t + 69, t + 68, t + 62, prec);
    arb_sub(t + 70, t + 49, t + 69, prec);
    arb_mul(t + 71, params + 5, params + 5, prec);
    arb_mul(t + 72, x + 2, t + 71, prec);
    arb_mul(t + 73, x + 4, t + 72, prec);
    arb_div(t + 74, t + 73, t + 61, prec);
    arb_add(t + 75, t + 70, t + 74, prec);
    arb_mul(t + 76, params + 1, params + 0, prec);
    arb_mul(t + 77, params + 5, t + 76, prec);
    arb_mul(t + 78, x + 2, t + 77, prec);
    arb_mul(t + 79, x + 4, t + 78, prec);
    arb_mul(t + 80, t + 65, t + 79, prec);
    arb_div(t + 81, t + 80, t + 61, prec);
    arb_add(t + 82, t + 75, t + 81, prec);
    arb_mul(t + 83, params + 4, t + 76, prec);
    arb_mul(t + 84, x + 3, t + 83, prec);
    arb_mul(t + 85, t + 67, t + 84, prec);
    arb_div(t + 86, t + 85, t + 61, prec);
    arb_mul(t + 87, x + 0, t + 55, prec);
    arb_mul(t + 88, x + 2, t + 87, prec);
    arb_mul(t + 89, x + 4, t + 88, prec);
    arb_mul(t + 90, t + 5, t + 89, prec);
    arb_sub(t + 91, params + 4, params + 5, prec);
    arb_mul(t + 92, t + 90, t + 91, prec);
    arb_div(t + 93, t + 92, t + 61, prec);
    arb_sub(t + 94, t + 93, t + 86, prec);
    arb_mul(t + 95, params + 3, t + 76, prec);
    arb_mul(t + 96, params + 5, t + 95, prec);
    arb_mul(t + 97, x + 2, t + 96, prec);
    arb_mul(t + 98, x + 4, t + 97, prec);
    arb_mul(t + 99, t + 5, t + 98, prec);
    arb_div(t + 100, t + 99, t + 61, prec);
    arb_sub(t + 101, t + 94, t + 100, prec);
    arb_set(out + 0, t + 6);
    arb_set(out + 1, t + 18);
    arb_set(out + 2, t + 46);
    arb_set(out + 3, t + 82);
    arb_set(out + 4, t + 101);
    _arb_vec_clear(t, 102);
}

static void general_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(268);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 2, prec);
    arb_mul(t + 4, x + 0, x + 0, prec);
    arb_sub(t + 5, t + 0, t + 4, prec);
    arb_sqrt(t + 6, t + 5, prec); /* s */
    arb_div(t + 7, t + 3, t + 6, prec);
    arb_neg(t + 8, t + 7);
    arb_set_si(t + 9, 0);
    arb_mul(t + 12, x + 3, x + 3, prec);
    arb_mul(t + 13, params + 1, t + 12, prec);
    arb_div(t + 14, t + 13, t + 6, prec);
    arb_mul(t + 15, x + 0, t + 12, prec);
    arb_mul(t + 16, t + 6, t + 6, prec);
    arb_mul(t + 17, t + 6, t + 16, prec);
    arb_mul(t + 19, x + 0, params + 1, prec);
    arb_add(t + 20, params + 3, t + 19, prec); /* b */
    arb_mul(t + 21, t + 15, t + 20, prec);
    arb_div(t + 22, t + 21, t + 17, prec);
    arb_add(t + 23, t + 14, t + 22, prec);
    arb_mul(t + 25, params + 1, x + 4, prec);
    arb_mul(t + 26, x + 3, t + 20, prec);
    arb_div(t + 27, t + 26, t + 6, prec);
    arb_set_si(t + 28, 2);
    arb_mul(t + 29, t + 27, t + 28, prec);
    arb_add(t + 30, t + 25, t + 29, prec);
    arb_mul(t + 31, params + 1, x + 3, prec);
    arb_mul(t + 33, params + 3, params + 3, prec);
    arb_mul(t + 34, params + 0, t + 33, prec);
    arb_mul(t + 35, x + 2, x + 2, prec);
    arb_mul(t + 36, t + 34, t + 35, prec);
    arb_mul(t + 37, t + 6, t + 36, prec);
    arb_mul(t + 39, t + 16, t + 34, prec);
    arb_add(t + 40, params + 4, t + 39, prec); /* D */
    arb_div(t + 41, t + 37, t + 40, prec);
    arb_mul(t + 42, t + 4, t + 34, prec);
    arb_mul(t + 43, t + 35, t + 42, prec);
    arb_mul(t + 44, t + 6, t + 40, prec);
    arb_div(t + 45, t + 43, t + 44, prec);
    arb_sub(t + 46, t + 41, t + 45, prec);
    arb_mul(t + 47, params + 0, params + 0, prec);
    arb_mul(t + 48, t + 33, t + 33, prec);
    arb_mul(t + 49, t + 47, t + 48, prec);
    arb_mul(t + 50, t + 4, t + 49, prec);
    arb_mul(t + 51, t + 35, t + 50, prec);
    arb_mul(t + 52, t + 6, t + 51, prec);
    arb_mul(t + 53, t + 40, t + 40, prec);
    arb_div(t + 54, t + 52, t + 53, prec);
    arb_mul(t + 55, t + 28, t + 54, prec);
    arb_add(t + 56, t + 46, t + 55, prec);
    arb_mul(t + 58, params + 0, params + 2, prec);
    arb_mul(t + 59, params + 3, t + 58, prec);
    arb_mul(t + 60, x + 0, t + 59, prec);
    arb_div(t + 61, t + 60, t + 44, prec);
    arb_add(t + 62, t + 56, t + 61, prec);
    arb_mul(t + 63, t + 47, params + 2, prec);
    arb_mul(t + 64, params + 3, t + 33, prec);
    arb_mul(t + 65, t + 63, t + 64, prec);
    arb_mul(t + 66, x + 0, t + 65, prec);
    arb_mul(t + 67, t + 6, t + 66, prec);
    arb_div(t + 68, t + 67, t + 53, prec);
    arb_mul(t + 69, t + 28, t + 68, prec);
    arb_sub(t + 70, t + 62, t + 69, prec);
    arb_mul(t + 71, t + 12, params + 4, prec);
    arb_div(t + 72, t + 71, t + 44, prec);
    arb_sub(t + 73, t + 70, t + 72, prec);
    arb_mul(t + 74, t + 4, params + 4, prec);
    arb_mul(t + 75, t + 12, t + 74, prec);
    arb_mul(t + 76, t + 17, t + 40, prec);
    arb_div(t + 77, t + 75, t + 76, prec);
    arb_sub(t + 78, t + 73, t + 77, prec);
    arb_mul(t + 79, t + 34, params + 4, prec);
    arb_mul(t + 80, t + 4, t + 79, prec);
    arb_mul(t + 81, t + 12, t + 80, prec);
    arb_mul(t + 82, t + 6, t + 53, prec);
    arb_div(t + 83, t + 81, t + 82, prec);
    arb_mul(t + 84, t + 28, t + 83, prec);
    arb_sub(t + 85, t + 78, t + 84, prec);
    arb_mul(t + 87, t + 34, params + 5, prec);
    arb_mul(t + 88, x + 0, t + 87, prec);
    arb_mul(t + 89, x + 3, t + 88, prec);
    arb_mul(t + 90, x + 4, t + 89, prec);
    arb_div(t + 91, t + 90, t + 53, prec);
    arb_mul(t + 92, t + 28, t + 91, prec);
    arb_sub(t + 93, t + 85, t + 92, prec);
    arb_mul(t + 94, t + 28, params + 0, prec);
    arb_mul(t + 95, t + 33, t + 94, prec);
    arb_mul(t + 96, x + 0, t + 95, prec);
    arb_mul(t + 97, x + 2, t + 96, prec);
    arb_mul(t + 98, t + 6, t + 97, prec);
    arb_div(t + 99, t + 98, t + 40, prec);
    arb_mul(t + 100, x + 4, params + 5, prec);
    arb_div(t + 101, t + 100, t + 40, prec);
    arb_neg(t + 102, t + 101);
    arb_mul(t + 103, x + 0, params + 4, prec);
    arb_mul(t + 104, x + 3, t + 103, prec);
    arb_div(t + 105, t + 104, t + 44, prec);
    arb_mul(t + 106, t + 28, t + 105, prec);
    arb_sub(t + 107, t + 102, t + 106, prec);
    arb_mul(t + 108, x + 3, params + 5, prec);
    arb_div(t + 109, t + 108, t + 40, prec);
    arb_neg(t + 110, t + 109);
    arb_mul(t + 111, x + 2, x + 3, prec);
    arb_div(t + 112, t + 111, t + 6, prec);
    arb_mul(t + 113, x + 2, t + 4, prec);
    arb_mul(t + 114, x + 3, t + 113, prec);
    arb_div(t + 115, t + 114, t + 17, prec);
    arb_add(t + 116, t + 112, t + 115, prec);
    arb_mul(t + 117, params + 1, params + 0, prec);
    arb_mul(t + 118, params + 5, t + 117, prec);
    arb_mul(t + 119, x + 3, t + 118, prec);
    arb_mul(t + 120, params + 4, params + 5, prec);
    arb_mul(t + 121, params + 1, params + 1, prec);
    arb_mul(t + 122, params + 0, t + 121, prec);
    arb_mul(t + 123, params + 4, t + 122, prec);
    arb_mul(t + 124, t + 16, t + 123, prec);
    arb_add(t + 125, t + 120, t + 124, prec);
    arb_mul(t + 126, params + 0, params + 5, prec);
    arb_mul(t + 127, t + 20, t + 20, prec);
    arb_mul(t + 128, t + 126, t + 127, prec);
    arb_add(t + 129, t + 125, t + 128, prec); /* Theta */
    arb_mul(t + 130, t + 6, t + 129, prec);
    arb_mul(t + 132, x + 0, params + 3, prec);
    arb_add(t + 133, params + 1, t + 132, prec); /* e */
    arb_mul(t + 134, x + 2, t + 133, prec);
    arb_add(t + 135, x + 1, t + 134, prec); /* V */
    arb_mul(t + 136, t + 119, t + 135, prec);
    arb_div(t + 137, t + 136, t + 130, prec);
    arb_sub(t + 138, t + 116, t + 137, prec);
    arb_mul(t + 139, x + 3, t + 126, prec);
    arb_mul(t + 140, t + 20, t + 139, prec);
    arb_mul(t + 141, t + 129, t + 129, prec);
    arb_mul(t + 142, t + 6, t + 141, prec);
    arb_mul(t + 143, t + 135, t + 140, prec);
    arb_mul(t + 144, x + 0, t + 123, prec);
    arb_mul(t + 145, t + 28, t + 144, prec);
    arb_mul(t + 146, t + 20, t + 118, prec);
    arb_mul(t + 147, t + 28, t + 146, prec);
    arb_sub(t + 148, t + 147, t + 145, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 149, t + 143, t + 148, prec);
    arb_div(t + 150, t + 149, t + 142, prec);
    arb_add(t + 151, t + 138, t + 150, prec);
    arb_mul(t + 152, params + 3, params + 0, prec);
    arb_mul(t + 153, params + 5, t + 152, prec);
    arb_mul(t + 154, x + 2, t + 153, prec);
    arb_mul(t + 155, x + 3, t + 154, prec);
    arb_mul(t + 156, t + 20, t + 155, prec);
    arb_div(t + 157, t + 156, t + 130, prec);
    arb_sub(t + 158, t + 151, t + 157, prec);
    arb_mul(t + 159, x + 0, t + 126, prec);
    arb_mul(t + 160, x + 3, t + 159, prec);
    arb_mul(t + 161, t + 20, t + 160, prec);
    arb_mul(t + 162, t + 17, t + 129, prec);
    arb_mul(t + 163, t + 135, t + 161, prec);
    arb_div(t + 164, t + 163, t + 162, prec);
    arb_sub(t + 165, t + 158, t + 164, prec);
    arb_mul(t + 166, params + 5, params + 5, prec);
    arb_mul(t + 167, x + 2, t + 166, prec);
    arb_mul(t + 168, x + 4, t + 167, prec);
    arb_mul(t + 169, t + 148, t + 168, prec);
    arb_div(t + 170, t + 169, t + 141, prec);
    arb_sub(t + 171, t + 165, t + 170, prec);
    arb_mul(t + 172, params + 3, t + 117, prec);
    arb_mul(t + 173, params + 5, t + 172, prec);
    arb_mul(t + 174, x + 2, t + 173, prec);
    arb_mul(t + 175, x + 4, t + 174, prec);
    arb_div(t + 176, t + 175, t + 129, prec);
    arb_add(t + 177, t + 171, t + 176, prec);
    arb_mul(t + 178, x + 2, t + 118, prec);
    arb_mul(t + 179, x + 4, t + 178, prec);
    arb_mul(t + 180, t + 133, t + 179, prec);
    arb_mul(t + 181, t + 148, t + 180, prec);
    arb_div(t + 182, t + 181, t + 141, prec);
    arb_sub(t + 183, t + 177, t + 182, prec);
    arb_div(t + 184, t + 140, t + 130, prec);
    arb_neg(t + 185, t + 184);
    arb_mul(t + 186, x + 0, x + 3, prec);
    arb_div(t + 187, t + 186, t + 6, prec);
    arb_mul(t + 188, t + 133, t + 140, prec);
    arb_div(t + 189, t + 188, t + 130, prec);
    arb_sub(t + 190, t + 187, t + 189, prec);
    arb_mul(t + 191, x + 4, t + 166, prec);
    arb_div(t + 192, t + 191, t + 129, prec);
    arb_add(t + 193, t + 190, t + 192, prec);
    arb_mul(t + 194, x + 4, t + 118, prec);
    arb_mul(t + 195, t + 133, t + 194, prec);
    arb_div(t + 196, t + 195, t + 129, prec);
    arb_add(t + 197, t + 193, t + 196, prec);
    arb_mul(t + 198, t + 20, t + 126, prec);
    arb_mul(t + 199, t + 135, t + 198, prec);
    arb_div(t + 200, t + 199, t + 130, prec);
    arb_sub(t + 201, t + 7, t + 200, prec);
    arb_div(t + 202, t + 167, t + 129, prec);
    arb_mul(t + 203, t + 133, t + 178, prec);
    arb_div(t + 204, t + 203, t + 129, prec);
    arb_add(t + 205, t + 202, t + 204, prec);
    arb_mul(t + 206, params + 4, t + 117, prec);
    arb_mul(t + 207, x + 3, t + 206, prec);
    arb_mul(t + 208, t + 135, t + 207, prec);
    arb_mul(t + 209, t + 148, t + 208, prec);
    arb_div(t + 210, t + 209, t + 141, prec);
    arb_mul(t + 211, params + 4, t + 172, prec);
    arb_mul(t + 212, x + 2, t + 211, prec);
    arb_mul(t + 213, x + 3, t + 212, prec);
    arb_div(t + 214, t + 213, t + 129, prec);
    arb_sub(t + 215, t + 210, t + 214, prec);
    arb_mul(t + 216, x + 2, t + 122, prec);
    arb_mul(t + 217, x + 4, t + 216, prec);
    arb_mul(t + 218, t + 6, t + 217, prec);
    arb_sub(t + 219, params + 4, params + 5, prec);
    arb_mul(t + 220, t + 218, t + 219, prec);
    arb_div(t + 221, t + 220, t + 129, prec);
    arb_add(t + 222, t + 215, t + 221, prec);
    arb_mul(t + 223, x + 0, t + 122, prec);
    arb_mul(t + 224, x + 2, t + 223, prec);
    arb_mul(t + 225, x + 4, t + 224, prec);
    arb_mul(t + 226, t + 6, t + 225, prec);
    arb_mul(t + 227, t + 219, t + 226, prec);
    arb_mul(t + 228, t + 148, t + 227, prec);
    arb_div(t + 229, t + 228, t + 141, prec);
    arb_sub(t + 230, t + 222, t + 229, prec);
    arb_mul(t + 231, t + 4, t + 122, prec);
    arb_mul(t + 232, x + 2, t + 231, prec);
    arb_mul(t + 233, x + 4, t + 232, prec);
    arb_mul(t + 234, t + 219, t + 233, prec);
    arb_div(t + 235, t + 234, t + 130, prec);
    arb_sub(t + 236, t + 230, t + 235, prec);
    arb_mul(t + 237, t + 6, t + 175, prec);
    arb_mul(t + 238, t + 148, t + 237, prec);
    arb_div(t + 239, t + 238, t + 141, prec);
    arb_add(t + 240, t + 236, t + 239, prec);
    arb_mul(t + 241, x + 0, t + 173, prec);
    arb_mul(t + 242, x + 2, t + 241, prec);
    arb_mul(t + 243, x + 4, t + 242, prec);
    arb_div(t + 244, t + 243, t + 130, prec);
    arb_add(t + 245, t + 240, t + 244, prec);
    arb_div(t + 246, t + 207, t + 129, prec);
    arb_neg(t + 247, t + 246);
    arb_mul(t + 248, x + 4, t + 223, prec);
    arb_mul(t + 249, t + 6, t + 248, prec);
    arb_mul(t + 250, t + 219, t + 249, prec);
    arb_div(t + 251, t + 250, t + 129, prec);
    arb_mul(t + 252, t + 133, t + 207, prec);
    arb_div(t + 253, t + 252, t + 129, prec);
    arb_sub(t + 254, t + 251, t + 253, prec);
    arb_mul(t + 255, x + 4, t + 173, prec);
    arb_mul(t + 256, t + 6, t + 255, prec);
    arb_div(t + 257, t + 256, t + 129, prec);
    arb_sub(t + 258, t + 254, t + 257, prec);
    arb_mul(t + 259, t + 135, t + 206, prec);
    arb_div(t + 260, t + 259, t + 129, prec);
    arb_neg(t + 261, t + 260);
    arb_mul(t + 262, t + 6, t + 224, prec);
    arb_mul(t + 263, t + 219, t + 262, prec);
    arb_div(t + 264, t + 263, t + 129, prec);
    arb_mul(t + 265, t + 6, t + 174, prec);
    arb_div(t + 266, t + 265, t + 129, prec);
    arb_sub(t + 267, t + 264, t + 266, prec);
    arb_set(out + 0, t + 8);
    arb_set(out + 1, t + 9);
    arb_set(out + 2, t + 6);
    arb_set(out + 3, t + 9);
    arb_set(out + 4, t + 9);
    arb_set(out + 5, t + 23);
    arb_set(out + 6, t + 9);
    arb_set(out + 7, t + 9);
    arb_set(out + 8, t + 30);
    arb_set(out + 9, t + 31);
    arb_set(out + 10, t + 93);
    arb_set(out + 11, t + 9);
    arb_set(out + 12, t + 99);
    arb_set(out + 13, t + 107);
    arb_set(out + 14, t + 110);
    arb_set(out + 15, t + 183);
    arb_set(out + 16, t + 185);
    arb_set(out + 17, t + 197);
    arb_set(out + 18, t + 201);
    arb_set(out + 19, t + 205);
    arb_set(out + 20, t + 245);
    arb_set(out + 21, t + 247);
    arb_set(out + 22, t + 258);
    arb_set(out + 23, t + 261);
    arb_set(out + 24, t + 267);
    _arb_vec_clear(t, 268);
}

static void general_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(58);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 3, params + 3, prec);
    arb_mul(t + 4, params + 0, t + 3, prec);
    arb_mul(t + 6, t + 4, x + 0, prec);
    arb_mul(t + 8, t + 6, x + 2, prec);
    arb_mul(t + 9, x + 0, x + 0, prec);
    arb_sub(t + 10, t + 0, t + 9, prec);
    arb_sqrt(t + 11, t + 10, prec); /* s */
    arb_mul(t + 12, t + 8, t + 11, prec);
    arb_mul(t + 14, t + 11, t + 11, prec);
    arb_mul(t + 15, t + 4, t + 14, prec);
    arb_add(t + 16, params + 4, t + 15, prec); /* D */
    arb_div(t + 17, t + 12, t + 16, prec);
    arb_set_si(t + 18, 2);
    arb_mul(t + 19, t + 17, t + 18, prec);
    arb_mul(t + 21, params + 0, params + 5, prec);
    arb_mul(t + 23, x + 0, params + 1, prec);
    arb_add(t + 24, params + 3, t + 23, prec); /* b */
    arb_mul(t + 25, t + 21, t + 24, prec);
    arb_mul(t + 26, params + 4, params + 5, prec);
    arb_mul(t + 27, params + 1, params + 1, prec);
    arb_mul(t + 28, params + 0, t + 27, prec);
    arb_mul(t + 29, params + 4, t + 28, prec);
    arb_mul(t + 30, t + 14, t + 29, prec);
    arb_add(t + 31, t + 26, t + 30, prec);
    arb_mul(t + 32, t + 24, t + 24, prec);
    arb_mul(t + 33, t + 21, t + 32, prec);
    arb_add(t + 34, t + 31, t + 33, prec); /* Theta */
    arb_mul(t + 35, t + 11, t + 34, prec);
    arb_mul(t + 37, params + 3, x + 0, prec);
    arb_add(t + 38, params + 1, t + 37, prec); /* e */
    arb_mul(t + 39, x + 2, t + 38, prec);
    arb_add(t + 40, x + 1, t + 39, prec); /* V */
    arb_mul(t + 41, t + 25, t + 40, prec);
    arb_div(t + 42, t + 41, t + 35, prec);
    arb_sub(t + 43, t + 19, t + 42, prec);
    arb_mul(t + 44, x + 0, t + 28, prec);
    arb_mul(t + 45, x + 2, t + 44, prec);
    arb_mul(t + 46, t + 11, t + 45, prec);
    arb_sub(t + 47, params + 4, params + 5, prec);
    arb_mul(t + 48, t + 46, t + 47, prec);
    arb_div(t + 49, t + 48, t + 34, prec);
    arb_add(t + 50, t + 43, t + 49, prec);
    arb_mul(t + 51, params + 0, params + 1, prec);
    arb_mul(t + 52, params + 3, t + 51, prec);
    arb_mul(t + 53, params + 5, t + 52, prec);
    arb_mul(t + 54, x + 2, t + 53, prec);
    arb_mul(t + 55, t + 11, t + 54, prec);
    arb_div(t + 56, t + 55, t + 34, prec);
    arb_sub(t + 57, t + 50, t + 56, prec);
    arb_set(out + 0, t + 57);
    _arb_vec_clear(t, 58);
}

static const char *const general_integral[] = { "E", "G", "F0", "F_linear", "E1", "E2" };

static void general_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(79);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 0, params + 2, prec);
    arb_mul(t + 5, t + 3, params + 3, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, x + 1, x + 1, prec);
    arb_mul(t + 10, params + 0, t + 9, prec);
    jlt_ball_rational(t + 11, "1/2", prec);
    arb_mul(t + 12, t + 10, t + 11, prec);
    arb_add(t + 13, t + 7, t + 12, prec);
    arb_mul(t + 15, x + 2, x + 2, prec);
    arb_mul(t + 17, params + 3, params + 3, prec);
    arb_mul(t + 18, params + 0, t + 17, prec);
    arb_mul(t + 19, x + 0, x + 0, prec);
    arb_sub(t + 20, t + 0, t + 19, prec);
    arb_sqrt(t + 21, t + 20, prec); /* s */
    arb_mul(t + 22, t + 21, t + 21, prec);
    arb_mul(t + 23, t + 18, t + 22, prec);
    arb_add(t + 24, params + 4, t + 23, prec); /* D */
    arb_mul(t + 25, t + 15, t + 24, prec);
    arb_mul(t + 26, t + 11, t + 25, prec);
    arb_add(t + 27, t + 13, t + 26, prec);
    arb_mul(t + 29, x + 3, x + 3, prec);
    arb_mul(t + 30, params + 4, t + 29, prec);
    arb_mul(t + 31, t + 11, t + 30, prec);
    arb_add(t + 32, t + 27, t + 31, prec);
    arb_mul(t + 35, x + 4, x + 4, prec);
    arb_mul(t + 36, params + 5, t + 35, prec);
    arb_mul(t + 37, t + 11, t + 36, prec);
    arb_add(t + 38, t + 32, t + 37, prec);
    arb_mul(t + 40, x + 0, params + 1, prec);
    arb_add(t + 41, params + 3, t + 40, prec); /* b */
    arb_mul(t + 42, x + 3, t + 41, prec);
    arb_mul(t + 43, x + 4, params + 1, prec);
    arb_mul(t + 44, t + 21, t + 43, prec);
    arb_add(t + 45, t + 42, t + 44, prec); /* v_tau */
    arb_mul(t + 46, t + 45, t + 45, prec);
    arb_mul(t + 47, params + 0, t + 46, prec);
    arb_mul(t + 48, t + 11, t + 47, prec);
    arb_add(t + 49, t + 38, t + 48, prec); /* energy */
    arb_mul(t + 50, params + 4, params + 1, prec);
    arb_mul(t + 51, x + 3, t + 50, prec);
    arb_mul(t + 52, t + 21, t + 51, prec);
    arb_mul(t + 53, params + 5, x + 4, prec);
    arb_mul(t + 54, t + 41, t + 53, prec);
    arb_sub(t + 55, t + 52, t + 54, prec);
    arb_mul(t + 56, params + 4, params + 4, prec);
    arb_mul(t + 57, params + 0, t + 56, prec);
    arb_mul(t + 58, x + 2, params + 1, prec);
    arb_add(t + 59, x + 1, t + 58, prec);
    arb_mul(t + 60, t + 59, t + 59, prec);
    arb_mul(t + 61, t + 57, t + 60, prec);
    arb_mul(t + 62, params + 4, params + 5, prec);
    arb_mul(t + 63, params + 1, params + 1, prec);
    arb_mul(t + 64, params + 0, t + 63, prec);
    arb_mul(t + 65, params + 4, t + 64, prec);
    arb_mul(t + 66, t + 22, t + 65, prec);
    arb_add(t + 67, t + 62, t + 66, prec);
    arb_mul(t + 68, params + 0, params + 5, prec);
    arb_mul(t + 69, t + 41, t + 41, prec);
    arb_mul(t + 70, t + 68, t + 69, prec);
    arb_add(t + 71, t + 67, t + 70, prec); /* Theta */
    arb_mul(t + 72, t + 35, t + 71, prec);
    arb_sub(t + 73, params + 4, params + 5, prec);
    arb_mul(t + 74, t + 72, t + 73, prec);
    arb_add(t + 75, t + 61, t + 74, prec);
    arb_add(t + 76, t + 12, t + 48, prec);
    arb_add(t + 77, t + 7, t + 26, prec);
    arb_add(t + 78, t + 31, t + 77, prec);
    arb_set(out + 0, t + 49);
    arb_set(out + 1, t + 55);
    arb_set(out + 2, t + 75);
    arb_set(out + 3, t + 59);
    arb_set(out + 4, t + 76);
    arb_set(out + 5, t + 78);
    _arb_vec_clear(t, 79);
}

static void general_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(95);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, params + 3, params + 3, prec);
    arb_mul(t + 5, params + 0, t + 4, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, x + 2, x + 2, prec);
    arb_mul(t + 10, t + 7, t + 9, prec);
    arb_mul(t + 12, params + 0, params + 2, prec);
    arb_mul(t + 13, params + 3, t + 12, prec);
    arb_sub(t + 14, t + 13, t + 10, prec);
    arb_mul(t + 17, x + 0, params + 1, prec);
    arb_add(t + 18, params + 3, t + 17, prec); /* b */
    arb_mul(t + 19, x + 3, t + 18, prec);
    arb_mul(t + 21, params + 1, x + 4, prec);
    arb_mul(t + 22, x + 0, x + 0, prec);
    arb_sub(t + 23, t + 1, t + 22, prec);
    arb_sqrt(t + 24, t + 23, prec); /* s */
    arb_mul(t + 25, t + 21, t + 24, prec);
    arb_add(t + 26, t + 19, t + 25, prec); /* v_tau */
    arb_mul(t + 27, params + 0, t + 26, prec);
    arb_mul(t + 28, x + 3, params + 1, prec);
    arb_mul(t + 29, t + 17, x + 4, prec);
    arb_div(t + 30, t + 29, t + 24, prec);
    arb_sub(t + 31, t + 28, t + 30, prec); /* d(v_tau)/d(gamma3) */
    arb_mul(t + 32, t + 27, t + 31, prec);
    arb_add(t + 33, t + 14, t + 32, prec); /* d(energy)/d(gamma3) */
    arb_mul(t + 35, params + 0, x + 1, prec);
    arb_mul(t + 37, t + 24, t + 24, prec);
    arb_mul(t + 38, t + 5, t + 37, prec);
    arb_add(t + 39, params + 4, t + 38, prec); /* D */
    arb_mul(t + 40, x + 2, t + 39, prec);
    arb_mul(t + 41, x + 3, params + 4, prec);
    arb_mul(t + 42, params + 0, t + 18, prec);
    arb_mul(t + 43, t + 26, t + 42, prec);
    arb_add(t + 44, t + 41, t + 43, prec); /* d(energy)/d(omega_n) */
    arb_mul(t + 46, x + 4, params + 5, prec);
    arb_mul(t + 47, params + 0, params + 1, prec);
    arb_mul(t + 48, t + 24, t + 47, prec);
    arb_mul(t + 49, t + 26, t + 48, prec);
    arb_add(t + 50, t + 46, t + 49, prec); /* d(energy)/d(omega3) */
    arb_mul(t + 51, params + 1, params + 4, prec);
    arb_mul(t + 52, x + 0, t + 51, prec);
    arb_mul(t + 53, x + 3, t + 52, prec);
    arb_div(t + 54, t + 53, t + 24, prec);
    arb_neg(t + 55, t + 54);
    arb_mul(t + 56, params + 1, params + 5, prec);
    arb_mul(t + 57, x + 4, t + 56, prec);
    arb_sub(t + 58, t + 55, t + 57, prec);
    arb_mul(t + 59, t + 24, t + 51, prec);
    arb_mul(t + 60, t + 18, params + 5, prec);
    arb_neg(t + 61, t + 60);
    arb_mul(t + 62, x + 4, x + 4, prec);
    arb_sub(t + 63, params + 4, params + 5, prec);
    arb_mul(t + 64, t + 62, t + 63, prec);
    arb_mul(t + 65, params + 1, params + 1, prec);
    arb_mul(t + 66, params + 0, t + 65, prec);
    arb_mul(t + 67, params + 4, t + 66, prec);
    arb_mul(t + 68, x + 0, t + 67, prec);
    arb_set_si(t + 69, 2);
    arb_mul(t + 70, t + 68, t + 69, prec);
    arb_mul(t + 71, params + 5, t + 47, prec);
    arb_mul(t + 72, t + 18, t + 71, prec);
    arb_mul(t + 73, t + 69, t + 72, prec);
    arb_sub(t + 74, t + 73, t + 70, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 75, t + 64, t + 74, prec);
    arb_mul(t + 76, params + 0, t + 69, prec);
    arb_mul(t + 77, params + 4, params + 4, prec);
    arb_mul(t + 78, t + 76, t + 77, prec);
    arb_mul(t + 79, x + 2, params + 1, prec);
    arb_add(t + 80, x + 1, t + 79, prec);
    arb_mul(t + 81, t + 78, t + 80, prec);
    arb_mul(t + 82, params + 1, t + 76, prec);
    arb_mul(t + 83, t + 77, t + 82, prec);
    arb_mul(t + 84, t + 80, t + 83, prec);
    arb_mul(t + 85, x + 4, t + 69, prec);
    arb_mul(t + 86, params + 4, params + 5, prec);
    arb_mul(t + 87, t + 37, t + 67, prec);
    arb_add(t + 88, t + 86, t + 87, prec);
    arb_mul(t + 89, params + 0, params + 5, prec);
    arb_mul(t + 90, t + 18, t + 18, prec);
    arb_mul(t + 91, t + 89, t + 90, prec);
    arb_add(t + 92, t + 88, t + 91, prec); /* Theta */
    arb_mul(t + 93, t + 85, t + 92, prec);
    arb_mul(t + 94, t + 63, t + 93, prec);
    arb_set(out + 0, t + 33);
    arb_set(out + 1, t + 35);
    arb_set(out + 2, t + 40);
    arb_set(out + 3, t + 44);
    arb_set(out + 4, t + 50);
    arb_set(out + 5, t + 58);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 0);
    arb_set(out + 8, t + 59);
    arb_set(out + 9, t + 61);
    arb_set(out + 10, t + 75);
    arb_set(out + 11, t + 81);
    arb_set(out + 12, t + 84);
    arb_set(out + 13, t + 0);
    arb_set(out + 14, t + 94);
    arb_set(out + 15, t + 0);
    arb_set(out + 16, t + 1);
    arb_set(out + 17, params + 1);
    arb_set(out + 18, t + 0);
    arb_set(out + 19, t + 0);
    arb_set(out + 20, t + 32);
    arb_set(out + 21, t + 35);
    arb_set(out + 22, t + 0);
    arb_set(out + 23, t + 43);
    arb_set(out + 24, t + 49);
    arb_set(out + 25, t + 14);
    arb_set(out + 26, t + 0);
    arb_set(out + 27, t + 40);
    arb_set(out + 28, t + 41);
    arb_set(out + 29, t + 0);
    _arb_vec_clear(t, 95);
}

extern const jlt_ball_table jlt_balls_spherical_top_general;
const jlt_ball_table jlt_balls_spherical_top_general = {
    .model = "spherical_top", .time = "", .elimination = "",
    .state_count = 5, .param_count = 6,
    .rhs = general_rhs,
    .jacobian = general_jacobian,
    .divergence = general_divergence,
    .integral_count = 6,
    .integral = general_integral,
    .integral_values = general_integral_values,
    .integral_gradients = general_integral_gradients,
};

static void general_on_level_omega_n_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(88);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 0, prec);
    arb_sub(t + 4, t + 0, t + 3, prec);
    arb_sqrt(t + 5, t + 4, prec); /* s */
    arb_mul(t + 6, x + 2, t + 5, prec);
    arb_mul(t + 9, params + 1, params + 4, prec);
    arb_mul(t + 10, t + 5, t + 9, prec);
    arb_mul(t + 14, params + 5, x + 3, prec);
    arb_mul(t + 16, x + 0, params + 1, prec);
    arb_add(t + 17, params + 3, t + 16, prec); /* b */
    arb_mul(t + 18, t + 14, t + 17, prec);
    arb_add(t + 19, params + 6, t + 18, prec);
    arb_div(t + 20, t + 19, t + 10, prec); /* omega_n */
    arb_mul(t + 21, t + 20, t + 20, prec);
    arb_mul(t + 22, t + 17, t + 21, prec);
    arb_div(t + 23, t + 22, t + 5, prec);
    arb_mul(t + 24, params + 1, t + 20, prec);
    arb_mul(t + 25, x + 3, t + 24, prec);
    arb_add(t + 26, t + 23, t + 25, prec);
    arb_mul(t + 28, params + 3, params + 3, prec);
    arb_mul(t + 29, params + 0, t + 28, prec);
    arb_mul(t + 30, x + 0, t + 29, prec);
    arb_mul(t + 31, x + 2, x + 2, prec);
    arb_mul(t + 32, t + 30, t + 31, prec);
    arb_mul(t + 33, t + 5, t + 32, prec);
    arb_mul(t + 34, t + 5, t + 5, prec);
    arb_mul(t + 35, t + 29, t + 34, prec);
    arb_add(t + 36, params + 4, t + 35, prec); /* D */
    arb_div(t + 37, t + 33, t + 36, prec);
    arb_mul(t + 39, params + 0, params + 2, prec);
    arb_mul(t + 40, params + 3, t + 39, prec);
    arb_mul(t + 41, t + 5, t + 40, prec);
    arb_div(t + 42, t + 41, t + 36, prec);
    arb_sub(t + 43, t + 37, t + 42, prec);
    arb_mul(t + 44, x + 0, params + 4, prec);
    arb_mul(t + 45, t + 21, t + 44, prec);
    arb_mul(t + 46, t + 5, t + 36, prec);
    arb_div(t + 47, t + 45, t + 46, prec);
    arb_sub(t + 48, t + 43, t + 47, prec);
    arb_mul(t + 49, params + 5, t + 20, prec);
    arb_mul(t + 50, x + 3, t + 49, prec);
    arb_div(t + 51, t + 50, t + 36, prec);
    arb_sub(t + 52, t + 48, t + 51, prec);
    arb_mul(t + 53, params + 1, params + 0, prec);
    arb_mul(t + 54, params + 4, t + 53, prec);
    arb_mul(t + 55, t + 20, t + 54, prec);
    arb_mul(t + 56, params + 4, params + 5, prec);
    arb_mul(t + 57, params + 1, params + 1, prec);
    arb_mul(t + 58, params + 0, t + 57, prec);
    arb_mul(t + 59, params + 4, t + 58, prec);
    arb_mul(t + 60, t + 34, t + 59, prec);
    arb_add(t + 61, t + 56, t + 60, prec);
    arb_mul(t + 62, params + 5, params + 0, prec);
    arb_mul(t + 63, t + 17, t + 17, prec);
    arb_mul(t + 64, t + 62, t + 63, prec);
    arb_add(t + 65, t + 61, t + 64, prec); /* Theta */
    arb_mul(t + 67, x + 0, params + 3, prec);
    arb_add(t + 68, params + 1, t + 67, prec); /* e */
    arb_mul(t + 69, x + 2, t + 68, prec);
    arb_add(t + 70, x + 1, t + 69, prec); /* V */
    arb_mul(t + 71, t + 55, t + 70, prec);
    arb_div(t + 72, t + 71, t + 65, prec);
    arb_mul(t + 73, x + 0, t + 58, prec);
    arb_mul(t + 74, x + 2, t + 73, prec);
    arb_mul(t + 75, x + 3, t + 74, prec);
    arb_mul(t + 76, t + 5, t + 75, prec);
    arb_sub(t + 77, params + 4, params + 5, prec);
    arb_mul(t + 78, t + 76, t + 77, prec);
    arb_div(t + 79, t + 78, t + 65, prec);
    arb_sub(t + 80, t + 79, t + 72, prec);
    arb_mul(t + 81, params + 3, t + 53, prec);
    arb_mul(t + 82, params + 5, t + 81, prec);
    arb_mul(t + 83, x + 2, t + 82, prec);
    arb_mul(t + 84, x + 3, t + 83, prec);
    arb_mul(t + 85, t + 5, t + 84, prec);
    arb_div(t + 86, t + 85, t + 65, prec);
    arb_sub(t + 87, t + 80, t + 86, prec);
    arb_set(out + 0, t + 6);
    arb_set(out + 1, t + 26);
    arb_set(out + 2, t + 52);
    arb_set(out + 3, t + 87);
    _arb_vec_clear(t, 88);
}

static void general_on_level_omega_n_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(243);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 2, prec);
    arb_mul(t + 4, x + 0, x + 0, prec);
    arb_sub(t + 5, t + 0, t + 4, prec);
    arb_sqrt(t + 6, t + 5, prec); /* s */
    arb_div(t + 7, t + 3, t + 6, prec);
    arb_neg(t + 8, t + 7);
    arb_set_si(t + 9, 0);
    arb_mul(t + 12, params + 1, params + 4, prec);
    arb_mul(t + 13, t + 6, t + 12, prec);
    arb_mul(t + 17, params + 5, x + 3, prec);
    arb_mul(t + 19, x + 0, params + 1, prec);
    arb_add(t + 20, params + 3, t + 19, prec); /* b */
    arb_mul(t + 21, t + 17, t + 20, prec);
    arb_add(t + 22, params + 6, t + 21, prec);
    arb_div(t + 23, t + 22, t + 13, prec); /* omega_n */
    arb_mul(t + 24, t + 23, t + 23, prec);
    arb_mul(t + 25, params + 1, t + 24, prec);
    arb_div(t + 26, t + 25, t + 6, prec);
    arb_mul(t + 27, x + 0, t + 24, prec);
    arb_mul(t + 28, t + 6, t + 6, prec);
    arb_mul(t + 29, t + 6, t + 28, prec);
    arb_mul(t + 30, t + 20, t + 27, prec);
    arb_div(t + 31, t + 30, t + 29, prec);
    arb_add(t + 32, t + 26, t + 31, prec);
    arb_mul(t + 33, t + 20, t + 23, prec);
    arb_mul(t + 34, t + 6, params + 4, prec);
    arb_div(t + 35, t + 17, t + 34, prec);
    arb_mul(t + 36, t + 12, t + 29, prec);
    arb_mul(t + 37, x + 0, t + 22, prec);
    arb_div(t + 38, t + 37, t + 36, prec);
    arb_add(t + 39, t + 35, t + 38, prec); /* d(omega_n)/d(gamma3) */
    arb_mul(t + 40, t + 33, t + 39, prec);
    arb_div(t + 41, t + 40, t + 6, prec);
    arb_set_si(t + 42, 2);
    arb_mul(t + 43, t + 41, t + 42, prec);
    arb_add(t + 44, t + 32, t + 43, prec);
    arb_mul(t + 45, params + 1, x + 3, prec);
    arb_mul(t + 46, t + 39, t + 45, prec);
    arb_add(t + 47, t + 44, t + 46, prec);
    arb_mul(t + 48, params + 1, t + 23, prec);
    arb_mul(t + 49, params + 5, t + 23, prec);
    arb_mul(t + 50, t + 12, t + 28, prec);
    arb_mul(t + 51, t + 20, t + 20, prec);
    arb_mul(t + 52, t + 49, t + 51, prec);
    arb_div(t + 53, t + 52, t + 50, prec);
    arb_mul(t + 54, t + 42, t + 53, prec);
    arb_add(t + 55, t + 48, t + 54, prec);
    arb_div(t + 56, t + 21, t + 34, prec);
    arb_add(t + 57, t + 55, t + 56, prec);
    arb_mul(t + 59, params + 3, params + 3, prec);
    arb_mul(t + 60, params + 0, t + 59, prec);
    arb_mul(t + 61, x + 2, x + 2, prec);
    arb_mul(t + 62, t + 60, t + 61, prec);
    arb_mul(t + 63, t + 6, t + 62, prec);
    arb_mul(t + 64, t + 28, t + 60, prec);
    arb_add(t + 65, params + 4, t + 64, prec); /* D */
    arb_div(t + 66, t + 63, t + 65, prec);
    arb_mul(t + 67, t + 4, t + 60, prec);
    arb_mul(t + 68, t + 61, t + 67, prec);
    arb_mul(t + 69, t + 6, t + 65, prec);
    arb_div(t + 70, t + 68, t + 69, prec);
    arb_sub(t + 71, t + 66, t + 70, prec);
    arb_mul(t + 72, params + 0, params + 0, prec);
    arb_mul(t + 73, t + 59, t + 59, prec);
    arb_mul(t + 74, t + 72, t + 73, prec);
    arb_mul(t + 75, t + 4, t + 74, prec);
    arb_mul(t + 76, t + 61, t + 75, prec);
    arb_mul(t + 77, t + 6, t + 76, prec);
    arb_mul(t + 78, t + 65, t + 65, prec);
    arb_div(t + 79, t + 77, t + 78, prec);
    arb_mul(t + 80, t + 42, t + 79, prec);
    arb_add(t + 81, t + 71, t + 80, prec);
    arb_mul(t + 83, params + 0, params + 2, prec);
    arb_mul(t + 84, params + 3, t + 83, prec);
    arb_mul(t + 85, x + 0, t + 84, prec);
    arb_div(t + 86, t + 85, t + 69, prec);
    arb_add(t + 87, t + 81, t + 86, prec);
    arb_mul(t + 88, t + 72, params + 2, prec);
    arb_mul(t + 89, params + 3, t + 59, prec);
    arb_mul(t + 90, t + 88, t + 89, prec);
    arb_mul(t + 91, x + 0, t + 90, prec);
    arb_mul(t + 92, t + 6, t + 91, prec);
    arb_div(t + 93, t + 92, t + 78, prec);
    arb_mul(t + 94, t + 42, t + 93, prec);
    arb_sub(t + 95, t + 87, t + 94, prec);
    arb_mul(t + 96, params + 4, t + 24, prec);
    arb_div(t + 97, t + 96, t + 69, prec);
    arb_sub(t + 98, t + 95, t + 97, prec);
    arb_mul(t + 99, t + 4, params + 4, prec);
    arb_mul(t + 100, t + 24, t + 99, prec);
    arb_mul(t + 101, t + 29, t + 65, prec);
    arb_div(t + 102, t + 100, t + 101, prec);
    arb_sub(t + 103, t + 98, t + 102, prec);
    arb_mul(t + 104, params + 4, t + 60, prec);
    arb_mul(t + 105, t + 4, t + 104, prec);
    arb_mul(t + 106, t + 24, t + 105, prec);
    arb_mul(t + 107, t + 6, t + 78, prec);
    arb_div(t + 108, t + 106, t + 107, prec);
    arb_mul(t + 109, t + 42, t + 108, prec);
    arb_sub(t + 110, t + 103, t + 109, prec);
    arb_mul(t + 111, params + 5, t + 60, prec);
    arb_mul(t + 112, x + 0, t + 111, prec);
    arb_mul(t + 113, t + 23, t + 112, prec);
    arb_mul(t + 114, x + 3, t + 113, prec);
    arb_div(t + 115, t + 114, t + 78, prec);
    arb_mul(t + 116, t + 42, t + 115, prec);
    arb_sub(t + 117, t + 110, t + 116, prec);
    arb_mul(t + 118, x + 0, params + 4, prec);
    arb_mul(t + 119, t + 23, t + 118, prec);
    arb_mul(t + 120, t + 39, t + 119, prec);
    arb_div(t + 121, t + 120, t + 69, prec);
    arb_mul(t + 122, t + 42, t + 121, prec);
    arb_sub(t + 123, t + 117, t + 122, prec);
    arb_mul(t + 124, t + 17, t + 39, prec);
    arb_div(t + 125, t + 124, t + 65, prec);
    arb_sub(t + 126, t + 123, t + 125, prec);
    arb_mul(t + 127, t + 42, params + 0, prec);
    arb_mul(t + 128, t + 59, t + 127, prec);
    arb_mul(t + 129, x + 0, t + 128, prec);
    arb_mul(t + 130, x + 2, t + 129, prec);
    arb_mul(t + 131, t + 6, t + 130, prec);
    arb_div(t + 132, t + 131, t + 65, prec);
    arb_div(t + 133, t + 49, t + 65, prec);
    arb_neg(t + 134, t + 133);
    arb_mul(t + 135, x + 0, params + 5, prec);
    arb_mul(t + 136, t + 23, t + 135, prec);
    arb_mul(t + 137, params + 1, t + 28, prec);
    arb_mul(t + 138, t + 20, t + 136, prec);
    arb_mul(t + 139, t + 65, t + 137, prec);
    arb_div(t + 140, t + 138, t + 139, prec);
    arb_mul(t + 141, t + 42, t + 140, prec);
    arb_sub(t + 142, t + 134, t + 141, prec);
    arb_mul(t + 143, params + 5, params + 5, prec);
    arb_mul(t + 144, x + 3, t + 143, prec);
    arb_mul(t + 145, t + 20, t + 144, prec);
    arb_mul(t + 146, t + 13, t + 65, prec);
    arb_div(t + 147, t + 145, t + 146, prec);
    arb_sub(t + 148, t + 142, t + 147, prec);
    arb_mul(t + 149, params + 1, params + 0, prec);
    arb_mul(t + 150, params + 3, t + 149, prec);
    arb_mul(t + 151, params + 4, t + 150, prec);
    arb_mul(t + 152, x + 2, t + 151, prec);
    arb_mul(t + 153, t + 23, t + 152, prec);
    arb_mul(t + 154, params + 4, params + 5, prec);
    arb_mul(t + 155, params + 1, params + 1, prec);
    arb_mul(t + 156, params + 0, t + 155, prec);
    arb_mul(t + 157, params + 4, t + 156, prec);
    arb_mul(t + 158, t + 28, t + 157, prec);
    arb_add(t + 159, t + 154, t + 158, prec);
    arb_mul(t + 160, params + 5, params + 0, prec);
    arb_mul(t + 161, t + 51, t + 160, prec);
    arb_add(t + 162, t + 159, t + 161, prec); /* Theta */
    arb_div(t + 163, t + 153, t + 162, prec);
    arb_mul(t + 164, x + 2, t + 156, prec);
    arb_mul(t + 165, x + 3, t + 164, prec);
    arb_mul(t + 166, t + 6, t + 165, prec);
    arb_sub(t + 167, params + 4, params + 5, prec);
    arb_mul(t + 168, t + 166, t + 167, prec);
    arb_div(t + 169, t + 168, t + 162, prec);
    arb_sub(t + 170, t + 169, t + 163, prec);
    arb_mul(t + 171, t + 4, t + 156, prec);
    arb_mul(t + 172, x + 2, t + 171, prec);
    arb_mul(t + 173, x + 3, t + 172, prec);
    arb_mul(t + 174, t + 6, t + 162, prec);
    arb_mul(t + 175, t + 167, t + 173, prec);
    arb_div(t + 176, t + 175, t + 174, prec);
    arb_sub(t + 177, t + 170, t + 176, prec);
    arb_mul(t + 178, params + 5, t + 150, prec);
    arb_mul(t + 179, x + 0, t + 178, prec);
    arb_mul(t + 180, x + 2, t + 179, prec);
    arb_mul(t + 181, x + 3, t + 180, prec);
    arb_div(t + 182, t + 181, t + 174, prec);
    arb_add(t + 183, t + 177, t + 182, prec);
    arb_mul(t + 184, params + 4, t + 149, prec);
    arb_mul(t + 186, x + 0, params + 3, prec);
    arb_add(t + 187, params + 1, t + 186, prec); /* e */
    arb_mul(t + 188, x + 2, t + 187, prec);
    arb_add(t + 189, x + 1, t + 188, prec); /* V */
    arb_mul(t + 190, t + 184, t + 189, prec);
    arb_mul(t + 191, t + 39, t + 190, prec);
    arb_div(t + 192, t + 191, t + 162, prec);
    arb_sub(t + 193, t + 183, t + 192, prec);
    arb_mul(t + 194, t + 23, t + 184, prec);
    arb_mul(t + 195, t + 162, t + 162, prec);
    arb_mul(t + 196, t + 189, t + 194, prec);
    arb_mul(t + 197, x + 0, t + 157, prec);
    arb_mul(t + 198, t + 42, t + 197, prec);
    arb_mul(t + 199, params + 5, t + 149, prec);
    arb_mul(t + 200, t + 20, t + 199, prec);
    arb_mul(t + 201, t + 42, t + 200, prec);
    arb_sub(t + 202, t + 201, t + 198, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 203, t + 196, t + 202, prec);
    arb_div(t + 204, t + 203, t + 195, prec);
    arb_add(t + 205, t + 193, t + 204, prec);
    arb_mul(t + 206, x + 0, t + 156, prec);
    arb_mul(t + 207, x + 2, t + 206, prec);
    arb_mul(t + 208, x + 3, t + 207, prec);
    arb_mul(t + 209, t + 6, t + 208, prec);
    arb_mul(t + 210, t + 167, t + 209, prec);
    arb_mul(t + 211, t + 202, t + 210, prec);
    arb_div(t + 212, t + 211, t + 195, prec);
    arb_sub(t + 213, t + 205, t + 212, prec);
    arb_mul(t + 214, x + 2, t + 178, prec);
    arb_mul(t + 215, x + 3, t + 214, prec);
    arb_mul(t + 216, t + 6, t + 215, prec);
    arb_mul(t + 217, t + 202, t + 216, prec);
    arb_div(t + 218, t + 217, t + 195, prec);
    arb_add(t + 219, t + 213, t + 218, prec);
    arb_div(t + 220, t + 194, t + 162, prec);
    arb_neg(t + 221, t + 220);
    arb_mul(t + 222, x + 3, t + 206, prec);
    arb_mul(t + 223, t + 6, t + 222, prec);
    arb_mul(t + 224, t + 167, t + 223, prec);
    arb_div(t + 225, t + 224, t + 162, prec);
    arb_mul(t + 226, t + 187, t + 194, prec);
    arb_div(t + 227, t + 226, t + 162, prec);
    arb_sub(t + 228, t + 225, t + 227, prec);
    arb_mul(t + 229, x + 3, t + 178, prec);
    arb_mul(t + 230, t + 6, t + 229, prec);
    arb_div(t + 231, t + 230, t + 162, prec);
    arb_sub(t + 232, t + 228, t + 231, prec);
    arb_mul(t + 233, t + 20, t + 160, prec);
    arb_mul(t + 234, t + 189, t + 233, prec);
    arb_div(t + 235, t + 234, t + 174, prec);
    arb_mul(t + 236, t + 6, t + 207, prec);
    arb_mul(t + 237, t + 167, t + 236, prec);
    arb_div(t + 238, t + 237, t + 162, prec);
    arb_sub(t + 239, t + 238, t + 235, prec);
    arb_mul(t + 240, t + 6, t + 214, prec);
    arb_div(t + 241, t + 240, t + 162, prec);
    arb_sub(t + 242, t + 239, t + 241, prec);
    arb_set(out + 0, t + 8);
    arb_set(out + 1, t + 9);
    arb_set(out + 2, t + 6);
    arb_set(out + 3, t + 9);
    arb_set(out + 4, t + 47);
    arb_set(out + 5, t + 9);
    arb_set(out + 6, t + 9);
    arb_set(out + 7, t + 57);
    arb_set(out + 8, t + 126);
    arb_set(out + 9, t + 9);
    arb_set(out + 10, t + 132);
    arb_set(out + 11, t + 148);
    arb_set(out + 12, t + 219);
    arb_set(out + 13, t + 221);
    arb_set(out + 14, t + 232);
    arb_set(out + 15, t + 242);
    _arb_vec_clear(t, 243);
}

static void general_on_level_omega_n_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(61);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 2, prec);
    arb_mul(t + 4, x + 0, x + 0, prec);
    arb_sub(t + 5, t + 0, t + 4, prec);
    arb_sqrt(t + 6, t + 5, prec); /* s */
    arb_div(t + 7, t + 3, t + 6, prec);
    arb_mul(t + 10, params + 3, params + 3, prec);
    arb_mul(t + 11, params + 0, t + 10, prec);
    arb_mul(t + 12, x + 0, t + 11, prec);
    arb_mul(t + 13, x + 2, t + 12, prec);
    arb_mul(t + 14, t + 6, t + 13, prec);
    arb_mul(t + 16, t + 6, t + 6, prec);
    arb_mul(t + 17, t + 11, t + 16, prec);
    arb_add(t + 18, params + 4, t + 17, prec); /* D */
    arb_div(t + 19, t + 14, t + 18, prec);
    arb_set_si(t + 20, 2);
    arb_mul(t + 21, t + 19, t + 20, prec);
    arb_sub(t + 22, t + 21, t + 7, prec);
    arb_mul(t + 24, params + 0, params + 5, prec);
    arb_mul(t + 26, x + 0, params + 1, prec);
    arb_add(t + 27, params + 3, t + 26, prec); /* b */
    arb_mul(t + 28, t + 24, t + 27, prec);
    arb_mul(t + 29, params + 4, params + 5, prec);
    arb_mul(t + 30, params + 1, params + 1, prec);
    arb_mul(t + 31, params + 0, t + 30, prec);
    arb_mul(t + 32, params + 4, t + 31, prec);
    arb_mul(t + 33, t + 16, t + 32, prec);
    arb_add(t + 34, t + 29, t + 33, prec);
    arb_mul(t + 35, t + 27, t + 27, prec);
    arb_mul(t + 36, t + 24, t + 35, prec);
    arb_add(t + 37, t + 34, t + 36, prec); /* Theta */
    arb_mul(t + 38, t + 6, t + 37, prec);
    arb_mul(t + 40, x + 0, params + 3, prec);
    arb_add(t + 41, params + 1, t + 40, prec); /* e */
    arb_mul(t + 42, x + 2, t + 41, prec);
    arb_add(t + 43, x + 1, t + 42, prec); /* V */
    arb_mul(t + 44, t + 28, t + 43, prec);
    arb_div(t + 45, t + 44, t + 38, prec);
    arb_sub(t + 46, t + 22, t + 45, prec);
    arb_mul(t + 47, x + 0, t + 31, prec);
    arb_mul(t + 48, x + 2, t + 47, prec);
    arb_mul(t + 49, t + 6, t + 48, prec);
    arb_sub(t + 50, params + 4, params + 5, prec);
    arb_mul(t + 51, t + 49, t + 50, prec);
    arb_div(t + 52, t + 51, t + 37, prec);
    arb_add(t + 53, t + 46, t + 52, prec);
    arb_mul(t + 54, params + 0, params + 1, prec);
    arb_mul(t + 55, params + 3, t + 54, prec);
    arb_mul(t + 56, params + 5, t + 55, prec);
    arb_mul(t + 57, x + 2, t + 56, prec);
    arb_mul(t + 58, t + 6, t + 57, prec);
    arb_div(t + 59, t + 58, t + 37, prec);
    arb_sub(t + 60, t + 53, t + 59, prec);
    arb_set(out + 0, t + 60);
    _arb_vec_clear(t, 61);
}

static const char *const general_on_level_omega_n_integral[] = { "E", "F0", "F_linear", "E1", "E2" };

static void general_on_level_omega_n_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(79);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 0, params + 2, prec);
    arb_mul(t + 5, t + 3, params + 3, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, x + 1, x + 1, prec);
    arb_mul(t + 10, params + 0, t + 9, prec);
    jlt_ball_rational(t + 11, "1/2", prec);
    arb_mul(t + 12, t + 10, t + 11, prec);
    arb_add(t + 13, t + 7, t + 12, prec);
    arb_mul(t + 15, x + 2, x + 2, prec);
    arb_mul(t + 17, params + 3, params + 3, prec);
    arb_mul(t + 18, params + 0, t + 17, prec);
    arb_mul(t + 19, x + 0, x + 0, prec);
    arb_sub(t + 20, t + 0, t + 19, prec);
    arb_sqrt(t + 21, t + 20, prec); /* s */
    arb_mul(t + 22, t + 21, t + 21, prec);
    arb_mul(t + 23, t + 18, t + 22, prec);
    arb_add(t + 24, params + 4, t + 23, prec); /* D */
    arb_mul(t + 25, t + 15, t + 24, prec);
    arb_mul(t + 26, t + 11, t + 25, prec);
    arb_add(t + 27, t + 13, t + 26, prec);
    arb_mul(t + 29, params + 4, params + 1, prec);
    arb_mul(t + 30, t + 21, t + 29, prec);
    arb_mul(t + 34, params + 5, x + 3, prec);
    arb_mul(t + 35, x + 0, params + 1, prec);
    arb_add(t + 36, params + 3, t + 35, prec); /* b */
    arb_mul(t + 37, t + 34, t + 36, prec);
    arb_add(t + 38, params + 6, t + 37, prec);
    arb_div(t + 39, t + 38, t + 30, prec); /* omega_n */
    arb_mul(t + 40, t + 39, t + 39, prec);
    arb_mul(t + 41, params + 4, t + 40, prec);
    arb_mul(t + 42, t + 11, t + 41, prec);
    arb_add(t + 43, t + 27, t + 42, prec);
    arb_mul(t + 44, x + 3, x + 3, prec);
    arb_mul(t + 45, params + 5, t + 44, prec);
    arb_mul(t + 46, t + 11, t + 45, prec);
    arb_add(t + 47, t + 43, t + 46, prec);
    arb_mul(t + 48, t + 36, t + 39, prec);
    arb_mul(t + 49, params + 1, x + 3, prec);
    arb_mul(t + 50, t + 21, t + 49, prec);
    arb_add(t + 51, t + 48, t + 50, prec); /* v_tau */
    arb_mul(t + 52, t + 51, t + 51, prec);
    arb_mul(t + 53, params + 0, t + 52, prec);
    arb_mul(t + 54, t + 11, t + 53, prec);
    arb_add(t + 55, t + 47, t + 54, prec); /* energy */
    arb_mul(t + 56, params + 4, params + 4, prec);
    arb_mul(t + 57, params + 0, t + 56, prec);
    arb_mul(t + 58, x + 2, params + 1, prec);
    arb_add(t + 59, x + 1, t + 58, prec);
    arb_mul(t + 60, t + 59, t + 59, prec);
    arb_mul(t + 61, t + 57, t + 60, prec);
    arb_mul(t + 62, params + 4, params + 5, prec);
    arb_mul(t + 63, params + 1, params + 1, prec);
    arb_mul(t + 64, params + 0, t + 63, prec);
    arb_mul(t + 65, params + 4, t + 64, prec);
    arb_mul(t + 66, t + 22, t + 65, prec);
    arb_add(t + 67, t + 62, t + 66, prec);
    arb_mul(t + 68, params + 0, params + 5, prec);
    arb_mul(t + 69, t + 36, t + 36, prec);
    arb_mul(t + 70, t + 68, t + 69, prec);
    arb_add(t + 71, t + 67, t + 70, prec); /* Theta */
    arb_mul(t + 72, t + 44, t + 71, prec);
    arb_sub(t + 73, params + 4, params + 5, prec);
    arb_mul(t + 74, t + 72, t + 73, prec);
    arb_add(t + 75, t + 61, t + 74, prec);
    arb_add(t + 76, t + 12, t + 54, prec);
    arb_add(t + 77, t + 7, t + 26, prec);
    arb_add(t + 78, t + 42, t + 77, prec);
    arb_set(out + 0, t + 55);
    arb_set(out + 1, t + 75);
    arb_set(out + 2, t + 59);
    arb_set(out + 3, t + 76);
    arb_set(out + 4, t + 78);
    _arb_vec_clear(t, 79);
}

static void general_on_level_omega_n_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(104);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, params + 3, params + 3, prec);
    arb_mul(t + 5, params + 0, t + 4, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, x + 2, x + 2, prec);
    arb_mul(t + 10, t + 7, t + 9, prec);
    arb_mul(t + 12, params + 0, params + 2, prec);
    arb_mul(t + 13, params + 3, t + 12, prec);
    arb_sub(t + 14, t + 13, t + 10, prec);
    arb_mul(t + 17, params + 4, params + 1, prec);
    arb_mul(t + 18, x + 0, x + 0, prec);
    arb_sub(t + 19, t + 1, t + 18, prec);
    arb_sqrt(t + 20, t + 19, prec); /* s */
    arb_mul(t + 21, t + 17, t + 20, prec);
    arb_mul(t + 25, params + 5, x + 3, prec);
    arb_mul(t + 26, x + 0, params + 1, prec);
    arb_add(t + 27, params + 3, t + 26, prec); /* b */
    arb_mul(t + 28, t + 25, t + 27, prec);
    arb_add(t + 29, params + 6, t + 28, prec);
    arb_div(t + 30, t + 29, t + 21, prec); /* omega_n */
    arb_mul(t + 31, params + 4, t + 30, prec);
    arb_mul(t + 32, params + 4, t + 20, prec);
    arb_div(t + 33, t + 25, t + 32, prec);
    arb_mul(t + 34, t + 20, t + 20, prec);
    arb_mul(t + 35, t + 20, t + 34, prec);
    arb_mul(t + 36, t + 17, t + 35, prec);
    arb_mul(t + 37, x + 0, t + 29, prec);
    arb_div(t + 38, t + 37, t + 36, prec);
    arb_add(t + 39, t + 33, t + 38, prec); /* d(omega_n)/d(gamma3) */
    arb_mul(t + 40, t + 31, t + 39, prec);
    arb_add(t + 41, t + 14, t + 40, prec);
    arb_mul(t + 42, t + 27, t + 30, prec);
    arb_mul(t + 43, params + 1, x + 3, prec);
    arb_mul(t + 44, t + 20, t + 43, prec);
    arb_add(t + 45, t + 42, t + 44, prec); /* v_tau */
    arb_mul(t + 46, params + 0, t + 45, prec);
    arb_mul(t + 47, params + 1, t + 30, prec);
    arb_mul(t + 48, x + 3, t + 26, prec);
    arb_div(t + 49, t + 48, t + 20, prec);
    arb_sub(t + 50, t + 47, t + 49, prec);
    arb_mul(t + 51, t + 27, t + 39, prec);
    arb_add(t + 52, t + 50, t + 51, prec); /* d(v_tau)/d(gamma3) */
    arb_mul(t + 53, t + 46, t + 52, prec);
    arb_add(t + 54, t + 41, t + 53, prec); /* d(energy)/d(gamma3) */
    arb_mul(t + 56, params + 0, x + 1, prec);
    arb_mul(t + 57, t + 5, t + 34, prec);
    arb_add(t + 58, params + 4, t + 57, prec); /* D */
    arb_mul(t + 59, x + 2, t + 58, prec);
    arb_mul(t + 60, params + 5, t + 30, prec);
    arb_mul(t + 61, params + 1, t + 20, prec);
    arb_mul(t + 62, t + 27, t + 60, prec);
    arb_div(t + 63, t + 62, t + 61, prec);
    arb_add(t + 64, t + 25, t + 63, prec);
    arb_mul(t + 65, t + 27, t + 27, prec);
    arb_mul(t + 66, params + 5, t + 65, prec);
    arb_div(t + 67, t + 66, t + 21, prec);
    arb_add(t + 68, t + 61, t + 67, prec); /* d(v_tau)/d(omega3) */
    arb_mul(t + 69, t + 46, t + 68, prec);
    arb_add(t + 70, t + 64, t + 69, prec); /* d(energy)/d(omega3) */
    arb_mul(t + 71, x + 3, x + 3, prec);
    arb_sub(t + 72, params + 4, params + 5, prec);
    arb_mul(t + 73, t + 71, t + 72, prec);
    arb_mul(t + 74, params + 1, params + 1, prec);
    arb_mul(t + 75, params + 0, t + 74, prec);
    arb_mul(t + 76, params + 4, t + 75, prec);
    arb_mul(t + 77, x + 0, t + 76, prec);
    arb_set_si(t + 78, 2);
    arb_mul(t + 79, t + 77, t + 78, prec);
    arb_mul(t + 80, params + 0, params + 1, prec);
    arb_mul(t + 81, params + 5, t + 80, prec);
    arb_mul(t + 82, t + 27, t + 81, prec);
    arb_mul(t + 83, t + 78, t + 82, prec);
    arb_sub(t + 84, t + 83, t + 79, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 85, t + 73, t + 84, prec);
    arb_mul(t + 86, params + 0, t + 78, prec);
    arb_mul(t + 87, params + 4, params + 4, prec);
    arb_mul(t + 88, t + 86, t + 87, prec);
    arb_mul(t + 89, x + 2, params + 1, prec);
    arb_add(t + 90, x + 1, t + 89, prec);
    arb_mul(t + 91, t + 88, t + 90, prec);
    arb_mul(t + 92, params + 1, t + 86, prec);
    arb_mul(t + 93, t + 87, t + 92, prec);
    arb_mul(t + 94, t + 90, t + 93, prec);
    arb_mul(t + 95, x + 3, t + 78, prec);
    arb_mul(t + 96, params + 4, params + 5, prec);
    arb_mul(t + 97, t + 34, t + 76, prec);
    arb_add(t + 98, t + 96, t + 97, prec);
    arb_mul(t + 99, params + 0, params + 5, prec);
    arb_mul(t + 100, t + 65, t + 99, prec);
    arb_add(t + 101, t + 98, t + 100, prec); /* Theta */
    arb_mul(t + 102, t + 95, t + 101, prec);
    arb_mul(t + 103, t + 72, t + 102, prec);
    arb_set(out + 0, t + 54);
    arb_set(out + 1, t + 56);
    arb_set(out + 2, t + 59);
    arb_set(out + 3, t + 70);
    arb_set(out + 4, t + 85);
    arb_set(out + 5, t + 91);
    arb_set(out + 6, t + 94);
    arb_set(out + 7, t + 103);
    arb_set(out + 8, t + 0);
    arb_set(out + 9, t + 1);
    arb_set(out + 10, params + 1);
    arb_set(out + 11, t + 0);
    arb_set(out + 12, t + 53);
    arb_set(out + 13, t + 56);
    arb_set(out + 14, t + 0);
    arb_set(out + 15, t + 69);
    arb_set(out + 16, t + 41);
    arb_set(out + 17, t + 0);
    arb_set(out + 18, t + 59);
    arb_set(out + 19, t + 63);
    _arb_vec_clear(t, 104);
}

extern const jlt_ball_table jlt_balls_spherical_top_general_on_level_omega_n;
const jlt_ball_table jlt_balls_spherical_top_general_on_level_omega_n = {
    .model = "spherical_top", .time = "", .elimination = "level_omega_n",
    .state_count = 4, .param_count = 7,
    .rhs = general_on_level_omega_n_rhs,
    .jacobian = general_on_level_omega_n_jacobian,
    .divergence = general_on_level_omega_n_divergence,
    .integral_count = 5,
    .integral = general_on_level_omega_n_integral,
    .integral_values = general_on_level_omega_n_integral_values,
    .integral_gradients = general_on_level_omega_n_integral_gradients,
};

static void general_on_level_omega3_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(89);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 0, prec);
    arb_sub(t + 4, t + 0, t + 3, prec);
    arb_sqrt(t + 5, t + 4, prec); /* s */
    arb_mul(t + 6, x + 2, t + 5, prec);
    arb_mul(t + 8, x + 3, x + 3, prec);
    arb_mul(t + 11, x + 0, params + 1, prec);
    arb_add(t + 12, params + 3, t + 11, prec); /* b */
    arb_mul(t + 13, t + 8, t + 12, prec);
    arb_div(t + 14, t + 13, t + 5, prec);
    arb_mul(t + 15, x + 3, params + 1, prec);
    arb_mul(t + 17, t + 12, params + 5, prec);
    arb_mul(t + 20, params + 1, params + 4, prec);
    arb_mul(t + 21, x + 3, t + 20, prec);
    arb_mul(t + 22, t + 5, t + 21, prec);
    arb_sub(t + 23, t + 22, params + 6, prec);
    arb_div(t + 24, t + 23, t + 17, prec); /* omega3 */
    arb_mul(t + 25, t + 15, t + 24, prec);
    arb_add(t + 26, t + 14, t + 25, prec);
    arb_mul(t + 28, params + 3, params + 3, prec);
    arb_mul(t + 29, params + 0, t + 28, prec);
    arb_mul(t + 30, x + 0, t + 29, prec);
    arb_mul(t + 31, x + 2, x + 2, prec);
    arb_mul(t + 32, t + 30, t + 31, prec);
    arb_mul(t + 33, t + 5, t + 32, prec);
    arb_mul(t + 34, t + 5, t + 5, prec);
    arb_mul(t + 35, t + 29, t + 34, prec);
    arb_add(t + 36, params + 4, t + 35, prec); /* D */
    arb_div(t + 37, t + 33, t + 36, prec);
    arb_mul(t + 39, params + 0, params + 2, prec);
    arb_mul(t + 40, params + 3, t + 39, prec);
    arb_mul(t + 41, t + 5, t + 40, prec);
    arb_div(t + 42, t + 41, t + 36, prec);
    arb_sub(t + 43, t + 37, t + 42, prec);
    arb_mul(t + 44, x + 0, params + 4, prec);
    arb_mul(t + 45, t + 8, t + 44, prec);
    arb_mul(t + 46, t + 5, t + 36, prec);
    arb_div(t + 47, t + 45, t + 46, prec);
    arb_sub(t + 48, t + 43, t + 47, prec);
    arb_mul(t + 49, x + 3, params + 5, prec);
    arb_mul(t + 50, t + 24, t + 49, prec);
    arb_div(t + 51, t + 50, t + 36, prec);
    arb_sub(t + 52, t + 48, t + 51, prec);
    arb_mul(t + 53, x + 2, x + 0, prec);
    arb_mul(t + 54, x + 3, t + 53, prec);
    arb_div(t + 55, t + 54, t + 5, prec);
    arb_mul(t + 56, params + 5, params + 0, prec);
    arb_mul(t + 57, x + 3, t + 56, prec);
    arb_mul(t + 58, t + 12, t + 57, prec);
    arb_mul(t + 59, params + 5, params + 4, prec);
    arb_mul(t + 60, params + 1, params + 1, prec);
    arb_mul(t + 61, params + 0, t + 60, prec);
    arb_mul(t + 62, params + 4, t + 61, prec);
    arb_mul(t + 63, t + 34, t + 62, prec);
    arb_add(t + 64, t + 59, t + 63, prec);
    arb_mul(t + 65, t + 12, t + 12, prec);
    arb_mul(t + 66, t + 56, t + 65, prec);
    arb_add(t + 67, t + 64, t + 66, prec); /* Theta */
    arb_mul(t + 68, t + 5, t + 67, prec);
    arb_mul(t + 70, x + 0, params + 3, prec);
    arb_add(t + 71, params + 1, t + 70, prec); /* e */
    arb_mul(t + 72, x + 2, t + 71, prec);
    arb_add(t + 73, x + 1, t + 72, prec); /* V */
    arb_mul(t + 74, t + 58, t + 73, prec);
    arb_div(t + 75, t + 74, t + 68, prec);
    arb_sub(t + 76, t + 55, t + 75, prec);
    arb_mul(t + 77, params + 5, params + 5, prec);
    arb_mul(t + 78, x + 2, t + 77, prec);
    arb_mul(t + 79, t + 24, t + 78, prec);
    arb_div(t + 80, t + 79, t + 67, prec);
    arb_add(t + 81, t + 76, t + 80, prec);
    arb_mul(t + 82, params + 1, params + 0, prec);
    arb_mul(t + 83, params + 5, t + 82, prec);
    arb_mul(t + 84, x + 2, t + 83, prec);
    arb_mul(t + 85, t + 24, t + 84, prec);
    arb_mul(t + 86, t + 71, t + 85, prec);
    arb_div(t + 87, t + 86, t + 67, prec);
    arb_add(t + 88, t + 81, t + 87, prec);
    arb_set(out + 0, t + 6);
    arb_set(out + 1, t + 26);
    arb_set(out + 2, t + 52);
    arb_set(out + 3, t + 88);
    _arb_vec_clear(t, 89);
}

static void general_on_level_omega3_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(247);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, x + 0, x + 2, prec);
    arb_mul(t + 4, x + 0, x + 0, prec);
    arb_sub(t + 5, t + 0, t + 4, prec);
    arb_sqrt(t + 6, t + 5, prec); /* s */
    arb_div(t + 7, t + 3, t + 6, prec);
    arb_neg(t + 8, t + 7);
    arb_set_si(t + 9, 0);
    arb_mul(t + 12, x + 3, x + 3, prec);
    arb_mul(t + 13, params + 1, t + 12, prec);
    arb_div(t + 14, t + 13, t + 6, prec);
    arb_mul(t + 15, x + 0, t + 12, prec);
    arb_mul(t + 16, t + 6, t + 6, prec);
    arb_mul(t + 17, t + 6, t + 16, prec);
    arb_mul(t + 19, x + 0, params + 1, prec);
    arb_add(t + 20, params + 3, t + 19, prec); /* b */
    arb_mul(t + 21, t + 15, t + 20, prec);
    arb_div(t + 22, t + 21, t + 17, prec);
    arb_add(t + 23, t + 14, t + 22, prec);
    arb_mul(t + 24, params + 1, x + 3, prec);
    arb_mul(t + 26, t + 20, t + 20, prec);
    arb_mul(t + 27, params + 5, t + 26, prec);
    arb_mul(t + 30, params + 1, params + 4, prec);
    arb_mul(t + 31, x + 3, t + 30, prec);
    arb_mul(t + 32, t + 6, t + 31, prec);
    arb_sub(t + 33, params + 6, t + 32, prec);
    arb_mul(t + 34, params + 1, t + 33, prec);
    arb_div(t + 35, t + 34, t + 27, prec);
    arb_mul(t + 36, x + 0, t + 30, prec);
    arb_mul(t + 37, x + 3, t + 36, prec);
    arb_mul(t + 38, t + 6, params + 5, prec);
    arb_mul(t + 39, t + 20, t + 38, prec);
    arb_div(t + 40, t + 37, t + 39, prec);
    arb_sub(t + 41, t + 35, t + 40, prec); /* d(omega3)/d(gamma3) */
    arb_mul(t + 42, t + 24, t + 41, prec);
    arb_add(t + 43, t + 23, t + 42, prec);
    arb_mul(t + 44, t + 20, params + 5, prec);
    arb_sub(t + 45, t + 32, params + 6, prec);
    arb_div(t + 46, t + 45, t + 44, prec); /* omega3 */
    arb_mul(t + 47, params + 1, t + 46, prec);
    arb_mul(t + 48, x + 3, t + 20, prec);
    arb_div(t + 49, t + 48, t + 6, prec);
    arb_set_si(t + 50, 2);
    arb_mul(t + 51, t + 49, t + 50, prec);
    arb_add(t + 52, t + 47, t + 51, prec);
    arb_mul(t + 53, params + 1, params + 1, prec);
    arb_mul(t + 54, params + 4, t + 53, prec);
    arb_mul(t + 55, x + 3, t + 54, prec);
    arb_mul(t + 56, t + 6, t + 55, prec);
    arb_div(t + 57, t + 56, t + 44, prec);
    arb_add(t + 58, t + 52, t + 57, prec);
    arb_mul(t + 60, params + 3, params + 3, prec);
    arb_mul(t + 61, params + 0, t + 60, prec);
    arb_mul(t + 62, x + 2, x + 2, prec);
    arb_mul(t + 63, t + 61, t + 62, prec);
    arb_mul(t + 64, t + 6, t + 63, prec);
    arb_mul(t + 65, t + 16, t + 61, prec);
    arb_add(t + 66, params + 4, t + 65, prec); /* D */
    arb_div(t + 67, t + 64, t + 66, prec);
    arb_mul(t + 68, t + 4, t + 61, prec);
    arb_mul(t + 69, t + 62, t + 68, prec);
    arb_mul(t + 70, t + 6, t + 66, prec);
    arb_div(t + 71, t + 69, t + 70, prec);
    arb_sub(t + 72, t + 67, t + 71, prec);
    arb_mul(t + 73, params + 0, params + 0, prec);
    arb_mul(t + 74, t + 60, t + 60, prec);
    arb_mul(t + 75, t + 73, t + 74, prec);
    arb_mul(t + 76, t + 4, t + 75, prec);
    arb_mul(t + 77, t + 62, t + 76, prec);
    arb_mul(t + 78, t + 6, t + 77, prec);
    arb_mul(t + 79, t + 66, t + 66, prec);
    arb_div(t + 80, t + 78, t + 79, prec);
    arb_mul(t + 81, t + 50, t + 80, prec);
    arb_add(t + 82, t + 72, t + 81, prec);
    arb_mul(t + 84, params + 0, params + 2, prec);
    arb_mul(t + 85, params + 3, t + 84, prec);
    arb_mul(t + 86, x + 0, t + 85, prec);
    arb_div(t + 87, t + 86, t + 70, prec);
    arb_add(t + 88, t + 82, t + 87, prec);
    arb_mul(t + 89, t + 73, params + 2, prec);
    arb_mul(t + 90, params + 3, t + 60, prec);
    arb_mul(t + 91, t + 89, t + 90, prec);
    arb_mul(t + 92, x + 0, t + 91, prec);
    arb_mul(t + 93, t + 6, t + 92, prec);
    arb_div(t + 94, t + 93, t + 79, prec);
    arb_mul(t + 95, t + 50, t + 94, prec);
    arb_sub(t + 96, t + 88, t + 95, prec);
    arb_mul(t + 97, t + 12, params + 4, prec);
    arb_div(t + 98, t + 97, t + 70, prec);
    arb_sub(t + 99, t + 96, t + 98, prec);
    arb_mul(t + 100, t + 4, params + 4, prec);
    arb_mul(t + 101, t + 12, t + 100, prec);
    arb_mul(t + 102, t + 17, t + 66, prec);
    arb_div(t + 103, t + 101, t + 102, prec);
    arb_sub(t + 104, t + 99, t + 103, prec);
    arb_mul(t + 105, params + 4, t + 61, prec);
    arb_mul(t + 106, t + 4, t + 105, prec);
    arb_mul(t + 107, t + 12, t + 106, prec);
    arb_mul(t + 108, t + 6, t + 79, prec);
    arb_div(t + 109, t + 107, t + 108, prec);
    arb_mul(t + 110, t + 50, t + 109, prec);
    arb_sub(t + 111, t + 104, t + 110, prec);
    arb_mul(t + 112, params + 5, t + 61, prec);
    arb_mul(t + 113, x + 0, t + 112, prec);
    arb_mul(t + 114, x + 3, t + 113, prec);
    arb_mul(t + 115, t + 46, t + 114, prec);
    arb_div(t + 116, t + 115, t + 79, prec);
    arb_mul(t + 117, t + 50, t + 116, prec);
    arb_sub(t + 118, t + 111, t + 117, prec);
    arb_mul(t + 119, x + 3, params + 5, prec);
    arb_mul(t + 120, t + 41, t + 119, prec);
    arb_div(t + 121, t + 120, t + 66, prec);
    arb_sub(t + 122, t + 118, t + 121, prec);
    arb_mul(t + 123, t + 50, params + 0, prec);
    arb_mul(t + 124, t + 60, t + 123, prec);
    arb_mul(t + 125, x + 0, t + 124, prec);
    arb_mul(t + 126, x + 2, t + 125, prec);
    arb_mul(t + 127, t + 6, t + 126, prec);
    arb_div(t + 128, t + 127, t + 66, prec);
    arb_mul(t + 129, params + 5, t + 46, prec);
    arb_div(t + 130, t + 129, t + 66, prec);
    arb_neg(t + 131, t + 130);
    arb_mul(t + 132, x + 0, params + 4, prec);
    arb_mul(t + 133, x + 3, t + 132, prec);
    arb_div(t + 134, t + 133, t + 70, prec);
    arb_mul(t + 135, t + 50, t + 134, prec);
    arb_sub(t + 136, t + 131, t + 135, prec);
    arb_mul(t + 137, t + 20, t + 66, prec);
    arb_div(t + 138, t + 32, t + 137, prec);
    arb_sub(t + 139, t + 136, t + 138, prec);
    arb_mul(t + 140, x + 2, x + 3, prec);
    arb_div(t + 141, t + 140, t + 6, prec);
    arb_mul(t + 142, x + 2, t + 4, prec);
    arb_mul(t + 143, x + 3, t + 142, prec);
    arb_div(t + 144, t + 143, t + 17, prec);
    arb_add(t + 145, t + 141, t + 144, prec);
    arb_mul(t + 146, params + 1, params + 0, prec);
    arb_mul(t + 147, params + 5, t + 146, prec);
    arb_mul(t + 148, x + 3, t + 147, prec);
    arb_mul(t + 149, params + 5, params + 4, prec);
    arb_mul(t + 150, t + 53, params + 0, prec);
    arb_mul(t + 151, params + 4, t + 150, prec);
    arb_mul(t + 152, t + 16, t + 151, prec);
    arb_add(t + 153, t + 149, t + 152, prec);
    arb_mul(t + 154, params + 5, params + 0, prec);
    arb_mul(t + 155, t + 26, t + 154, prec);
    arb_add(t + 156, t + 153, t + 155, prec); /* Theta */
    arb_mul(t + 157, t + 6, t + 156, prec);
    arb_mul(t + 159, x + 0, params + 3, prec);
    arb_add(t + 160, params + 1, t + 159, prec); /* e */
    arb_mul(t + 161, x + 2, t + 160, prec);
    arb_add(t + 162, x + 1, t + 161, prec); /* V */
    arb_mul(t + 163, t + 148, t + 162, prec);
    arb_div(t + 164, t + 163, t + 157, prec);
    arb_sub(t + 165, t + 145, t + 164, prec);
    arb_mul(t + 166, params + 3, params + 0, prec);
    arb_mul(t + 167, params + 5, t + 166, prec);
    arb_mul(t + 168, x + 2, t + 167, prec);
    arb_mul(t + 169, x + 3, t + 168, prec);
    arb_mul(t + 170, t + 20, t + 169, prec);
    arb_div(t + 171, t + 170, t + 157, prec);
    arb_sub(t + 172, t + 165, t + 171, prec);
    arb_mul(t + 173, x + 0, t + 154, prec);
    arb_mul(t + 174, x + 3, t + 173, prec);
    arb_mul(t + 175, t + 20, t + 174, prec);
    arb_mul(t + 176, t + 17, t + 156, prec);
    arb_mul(t + 177, t + 162, t + 175, prec);
    arb_div(t + 178, t + 177, t + 176, prec);
    arb_sub(t + 179, t + 172, t + 178, prec);
    arb_mul(t + 180, params + 3, t + 146, prec);
    arb_mul(t + 181, params + 5, t + 180, prec);
    arb_mul(t + 182, x + 2, t + 181, prec);
    arb_mul(t + 183, t + 46, t + 182, prec);
    arb_div(t + 184, t + 183, t + 156, prec);
    arb_add(t + 185, t + 179, t + 184, prec);
    arb_mul(t + 186, x + 3, t + 154, prec);
    arb_mul(t + 187, t + 20, t + 186, prec);
    arb_mul(t + 188, t + 156, t + 156, prec);
    arb_mul(t + 189, t + 6, t + 188, prec);
    arb_mul(t + 190, t + 162, t + 187, prec);
    arb_mul(t + 191, x + 0, t + 151, prec);
    arb_mul(t + 192, t + 50, t + 191, prec);
    arb_mul(t + 193, t + 20, t + 147, prec);
    arb_mul(t + 194, t + 50, t + 193, prec);
    arb_sub(t + 195, t + 194, t + 192, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 196, t + 190, t + 195, prec);
    arb_div(t + 197, t + 196, t + 189, prec);
    arb_add(t + 198, t + 185, t + 197, prec);
    arb_mul(t + 199, params + 5, params + 5, prec);
    arb_mul(t + 200, x + 2, t + 199, prec);
    arb_mul(t + 201, t + 41, t + 200, prec);
    arb_div(t + 202, t + 201, t + 156, prec);
    arb_add(t + 203, t + 198, t + 202, prec);
    arb_mul(t + 204, t + 46, t + 200, prec);
    arb_mul(t + 205, t + 195, t + 204, prec);
    arb_div(t + 206, t + 205, t + 188, prec);
    arb_sub(t + 207, t + 203, t + 206, prec);
    arb_mul(t + 208, x + 2, t + 147, prec);
    arb_mul(t + 209, t + 160, t + 208, prec);
    arb_mul(t + 210, t + 41, t + 209, prec);
    arb_div(t + 211, t + 210, t + 156, prec);
    arb_add(t + 212, t + 207, t + 211, prec);
    arb_mul(t + 213, t + 46, t + 208, prec);
    arb_mul(t + 214, t + 160, t + 213, prec);
    arb_mul(t + 215, t + 195, t + 214, prec);
    arb_div(t + 216, t + 215, t + 188, prec);
    arb_sub(t + 217, t + 212, t + 216, prec);
    arb_div(t + 218, t + 187, t + 157, prec);
    arb_neg(t + 219, t + 218);
    arb_mul(t + 220, x + 0, x + 3, prec);
    arb_div(t + 221, t + 220, t + 6, prec);
    arb_mul(t + 222, t + 160, t + 187, prec);
    arb_div(t + 223, t + 222, t + 157, prec);
    arb_sub(t + 224, t + 221, t + 223, prec);
    arb_mul(t + 225, t + 46, t + 199, prec);
    arb_div(t + 226, t + 225, t + 156, prec);
    arb_add(t + 227, t + 224, t + 226, prec);
    arb_mul(t + 228, t + 46, t + 147, prec);
    arb_mul(t + 229, t + 160, t + 228, prec);
    arb_div(t + 230, t + 229, t + 156, prec);
    arb_add(t + 231, t + 227, t + 230, prec);
    arb_mul(t + 232, t + 20, t + 154, prec);
    arb_mul(t + 233, t + 162, t + 232, prec);
    arb_div(t + 234, t + 233, t + 157, prec);
    arb_sub(t + 235, t + 7, t + 234, prec);
    arb_mul(t + 236, params + 5, t + 30, prec);
    arb_mul(t + 237, x + 2, t + 236, prec);
    arb_mul(t + 238, t + 6, t + 237, prec);
    arb_mul(t + 239, t + 20, t + 156, prec);
    arb_div(t + 240, t + 238, t + 239, prec);
    arb_add(t + 241, t + 235, t + 240, prec);
    arb_mul(t + 242, x + 2, t + 151, prec);
    arb_mul(t + 243, t + 6, t + 242, prec);
    arb_mul(t + 244, t + 160, t + 243, prec);
    arb_div(t + 245, t + 244, t + 239, prec);
    arb_add(t + 246, t + 241, t + 245, prec);
    arb_set(out + 0, t + 8);
    arb_set(out + 1, t + 9);
    arb_set(out + 2, t + 6);
    arb_set(out + 3, t + 9);
    arb_set(out + 4, t + 43);
    arb_set(out + 5, t + 9);
    arb_set(out + 6, t + 9);
    arb_set(out + 7, t + 58);
    arb_set(out + 8, t + 122);
    arb_set(out + 9, t + 9);
    arb_set(out + 10, t + 128);
    arb_set(out + 11, t + 139);
    arb_set(out + 12, t + 217);
    arb_set(out + 13, t + 219);
    arb_set(out + 14, t + 231);
    arb_set(out + 15, t + 246);
    _arb_vec_clear(t, 247);
}

static void general_on_level_omega3_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(56);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 3, params + 3, prec);
    arb_mul(t + 4, params + 0, t + 3, prec);
    arb_mul(t + 6, t + 4, x + 0, prec);
    arb_mul(t + 8, t + 6, x + 2, prec);
    arb_mul(t + 9, x + 0, x + 0, prec);
    arb_sub(t + 10, t + 0, t + 9, prec);
    arb_sqrt(t + 11, t + 10, prec); /* s */
    arb_mul(t + 12, t + 8, t + 11, prec);
    arb_mul(t + 14, t + 11, t + 11, prec);
    arb_mul(t + 15, t + 4, t + 14, prec);
    arb_add(t + 16, params + 4, t + 15, prec); /* D */
    arb_div(t + 17, t + 12, t + 16, prec);
    arb_set_si(t + 18, 2);
    arb_mul(t + 19, t + 17, t + 18, prec);
    arb_mul(t + 21, params + 0, params + 5, prec);
    arb_mul(t + 23, x + 0, params + 1, prec);
    arb_add(t + 24, params + 3, t + 23, prec); /* b */
    arb_mul(t + 25, t + 21, t + 24, prec);
    arb_mul(t + 26, params + 4, params + 5, prec);
    arb_mul(t + 27, params + 1, params + 1, prec);
    arb_mul(t + 28, params + 0, t + 27, prec);
    arb_mul(t + 29, params + 4, t + 28, prec);
    arb_mul(t + 30, t + 14, t + 29, prec);
    arb_add(t + 31, t + 26, t + 30, prec);
    arb_mul(t + 32, t + 24, t + 24, prec);
    arb_mul(t + 33, t + 21, t + 32, prec);
    arb_add(t + 34, t + 31, t + 33, prec); /* Theta */
    arb_mul(t + 35, t + 11, t + 34, prec);
    arb_mul(t + 37, params + 3, x + 0, prec);
    arb_add(t + 38, params + 1, t + 37, prec); /* e */
    arb_mul(t + 39, x + 2, t + 38, prec);
    arb_add(t + 40, x + 1, t + 39, prec); /* V */
    arb_mul(t + 41, t + 25, t + 40, prec);
    arb_div(t + 42, t + 41, t + 35, prec);
    arb_sub(t + 43, t + 19, t + 42, prec);
    arb_mul(t + 44, params + 4, params + 1, prec);
    arb_mul(t + 45, params + 5, t + 44, prec);
    arb_mul(t + 46, x + 2, t + 45, prec);
    arb_mul(t + 47, t + 11, t + 46, prec);
    arb_mul(t + 48, t + 24, t + 34, prec);
    arb_div(t + 49, t + 47, t + 48, prec);
    arb_add(t + 50, t + 43, t + 49, prec);
    arb_mul(t + 51, x + 2, t + 29, prec);
    arb_mul(t + 52, t + 11, t + 51, prec);
    arb_mul(t + 53, t + 38, t + 52, prec);
    arb_div(t + 54, t + 53, t + 48, prec);
    arb_add(t + 55, t + 50, t + 54, prec);
    arb_set(out + 0, t + 55);
    _arb_vec_clear(t, 56);
}

static const char *const general_on_level_omega3_integral[] = { "E", "F0", "F_linear", "E1", "E2" };

static void general_on_level_omega3_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(79);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 1);
    arb_mul(t + 3, params + 0, params + 2, prec);
    arb_mul(t + 5, t + 3, params + 3, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, x + 1, x + 1, prec);
    arb_mul(t + 10, params + 0, t + 9, prec);
    jlt_ball_rational(t + 11, "1/2", prec);
    arb_mul(t + 12, t + 10, t + 11, prec);
    arb_add(t + 13, t + 7, t + 12, prec);
    arb_mul(t + 15, x + 2, x + 2, prec);
    arb_mul(t + 17, params + 3, params + 3, prec);
    arb_mul(t + 18, params + 0, t + 17, prec);
    arb_mul(t + 19, x + 0, x + 0, prec);
    arb_sub(t + 20, t + 0, t + 19, prec);
    arb_sqrt(t + 21, t + 20, prec); /* s */
    arb_mul(t + 22, t + 21, t + 21, prec);
    arb_mul(t + 23, t + 18, t + 22, prec);
    arb_add(t + 24, params + 4, t + 23, prec); /* D */
    arb_mul(t + 25, t + 15, t + 24, prec);
    arb_mul(t + 26, t + 11, t + 25, prec);
    arb_add(t + 27, t + 13, t + 26, prec);
    arb_mul(t + 29, x + 3, x + 3, prec);
    arb_mul(t + 30, params + 4, t + 29, prec);
    arb_mul(t + 31, t + 11, t + 30, prec);
    arb_add(t + 32, t + 27, t + 31, prec);
    arb_mul(t + 35, x + 0, params + 1, prec);
    arb_add(t + 36, params + 3, t + 35, prec); /* b */
    arb_mul(t + 37, params + 5, t + 36, prec);
    arb_mul(t + 39, params + 4, params + 1, prec);
    arb_mul(t + 40, x + 3, t + 39, prec);
    arb_mul(t + 41, t + 21, t + 40, prec);
    arb_sub(t + 42, t + 41, params + 6, prec);
    arb_div(t + 43, t + 42, t + 37, prec); /* omega3 */
    arb_mul(t + 44, t + 43, t + 43, prec);
    arb_mul(t + 45, params + 5, t + 44, prec);
    arb_mul(t + 46, t + 11, t + 45, prec);
    arb_add(t + 47, t + 32, t + 46, prec);
    arb_mul(t + 48, x + 3, t + 36, prec);
    arb_mul(t + 49, params + 1, t + 43, prec);
    arb_mul(t + 50, t + 21, t + 49, prec);
    arb_add(t + 51, t + 48, t + 50, prec); /* v_tau */
    arb_mul(t + 52, t + 51, t + 51, prec);
    arb_mul(t + 53, params + 0, t + 52, prec);
    arb_mul(t + 54, t + 11, t + 53, prec);
    arb_add(t + 55, t + 47, t + 54, prec); /* energy */
    arb_mul(t + 56, params + 4, params + 4, prec);
    arb_mul(t + 57, params + 0, t + 56, prec);
    arb_mul(t + 58, x + 2, params + 1, prec);
    arb_add(t + 59, x + 1, t + 58, prec);
    arb_mul(t + 60, t + 59, t + 59, prec);
    arb_mul(t + 61, t + 57, t + 60, prec);
    arb_mul(t + 62, params + 4, params + 5, prec);
    arb_mul(t + 63, params + 1, params + 1, prec);
    arb_mul(t + 64, params + 0, t + 63, prec);
    arb_mul(t + 65, params + 4, t + 64, prec);
    arb_mul(t + 66, t + 22, t + 65, prec);
    arb_add(t + 67, t + 62, t + 66, prec);
    arb_mul(t + 68, params + 0, params + 5, prec);
    arb_mul(t + 69, t + 36, t + 36, prec);
    arb_mul(t + 70, t + 68, t + 69, prec);
    arb_add(t + 71, t + 67, t + 70, prec); /* Theta */
    arb_mul(t + 72, t + 44, t + 71, prec);
    arb_sub(t + 73, params + 4, params + 5, prec);
    arb_mul(t + 74, t + 72, t + 73, prec);
    arb_add(t + 75, t + 61, t + 74, prec);
    arb_add(t + 76, t + 12, t + 54, prec);
    arb_add(t + 77, t + 7, t + 26, prec);
    arb_add(t + 78, t + 31, t + 77, prec);
    arb_set(out + 0, t + 55);
    arb_set(out + 1, t + 75);
    arb_set(out + 2, t + 59);
    arb_set(out + 3, t + 76);
    arb_set(out + 4, t + 78);
    _arb_vec_clear(t, 79);
}

static void general_on_level_omega3_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(118);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, params + 3, params + 3, prec);
    arb_mul(t + 5, params + 0, t + 4, prec);
    arb_mul(t + 7, t + 5, x + 0, prec);
    arb_mul(t + 9, x + 2, x + 2, prec);
    arb_mul(t + 10, t + 7, t + 9, prec);
    arb_mul(t + 12, params + 0, params + 2, prec);
    arb_mul(t + 13, params + 3, t + 12, prec);
    arb_sub(t + 14, t + 13, t + 10, prec);
    arb_mul(t + 17, x + 0, params + 1, prec);
    arb_add(t + 18, params + 3, t + 17, prec); /* b */
    arb_mul(t + 19, params + 5, t + 18, prec);
    arb_mul(t + 22, params + 1, params + 4, prec);
    arb_mul(t + 24, t + 22, x + 3, prec);
    arb_mul(t + 25, x + 0, x + 0, prec);
    arb_sub(t + 26, t + 1, t + 25, prec);
    arb_sqrt(t + 27, t + 26, prec); /* s */
    arb_mul(t + 28, t + 24, t + 27, prec);
    arb_sub(t + 29, params + 6, t + 28, prec);
    arb_sub(t + 30, t + 28, params + 6, prec);
    arb_div(t + 31, t + 30, t + 19, prec); /* omega3 */
    arb_mul(t + 32, params + 5, t + 31, prec);
    arb_mul(t + 33, t + 18, t + 18, prec);
    arb_mul(t + 34, params + 5, t + 33, prec);
    arb_mul(t + 35, params + 1, t + 29, prec);
    arb_div(t + 36, t + 35, t + 34, prec);
    arb_mul(t + 37, x + 0, t + 22, prec);
    arb_mul(t + 38, x + 3, t + 37, prec);
    arb_mul(t + 39, params + 5, t + 27, prec);
    arb_mul(t + 40, t + 18, t + 39, prec);
    arb_div(t + 41, t + 38, t + 40, prec);
    arb_sub(t + 42, t + 36, t + 41, prec); /* d(omega3)/d(gamma3) */
    arb_mul(t + 43, t + 32, t + 42, prec);
    arb_add(t + 44, t + 14, t + 43, prec);
    arb_mul(t + 45, t + 18, x + 3, prec);
    arb_mul(t + 46, params + 1, t + 31, prec);
    arb_mul(t + 47, t + 27, t + 46, prec);
    arb_add(t + 48, t + 45, t + 47, prec); /* v_tau */
    arb_mul(t + 49, params + 0, t + 48, prec);
    arb_mul(t + 50, params + 1, x + 3, prec);
    arb_mul(t + 51, t + 17, t + 31, prec);
    arb_div(t + 52, t + 51, t + 27, prec);
    arb_sub(t + 53, t + 50, t + 52, prec);
    arb_mul(t + 54, params + 1, t + 27, prec);
    arb_mul(t + 55, t + 42, t + 54, prec);
    arb_add(t + 56, t + 53, t + 55, prec); /* d(v_tau)/d(gamma3) */
    arb_mul(t + 57, t + 49, t + 56, prec);
    arb_add(t + 58, t + 44, t + 57, prec); /* d(energy)/d(gamma3) */
    arb_mul(t + 60, params + 0, x + 1, prec);
    arb_mul(t + 61, t + 27, t + 27, prec);
    arb_mul(t + 62, t + 5, t + 61, prec);
    arb_add(t + 63, params + 4, t + 62, prec); /* D */
    arb_mul(t + 64, x + 2, t + 63, prec);
    arb_mul(t + 65, params + 4, x + 3, prec);
    arb_mul(t + 66, params + 1, params + 1, prec);
    arb_mul(t + 67, params + 4, t + 66, prec);
    arb_mul(t + 68, t + 61, t + 67, prec);
    arb_div(t + 69, t + 68, t + 19, prec);
    arb_add(t + 70, t + 18, t + 69, prec); /* d(v_tau)/d(omega_n) */
    arb_mul(t + 71, t + 49, t + 70, prec);
    arb_add(t + 72, t + 65, t + 71, prec);
    arb_mul(t + 73, t + 22, t + 31, prec);
    arb_mul(t + 74, t + 27, t + 73, prec);
    arb_div(t + 75, t + 74, t + 18, prec);
    arb_add(t + 76, t + 72, t + 75, prec); /* d(energy)/d(omega_n) */
    arb_mul(t + 77, t + 31, t + 31, prec);
    arb_sub(t + 78, params + 4, params + 5, prec);
    arb_mul(t + 79, t + 77, t + 78, prec);
    arb_mul(t + 80, params + 0, t + 66, prec);
    arb_mul(t + 81, params + 4, t + 80, prec);
    arb_mul(t + 82, x + 0, t + 81, prec);
    arb_set_si(t + 83, 2);
    arb_mul(t + 84, t + 82, t + 83, prec);
    arb_mul(t + 85, params + 0, params + 1, prec);
    arb_mul(t + 86, params + 5, t + 85, prec);
    arb_mul(t + 87, t + 18, t + 86, prec);
    arb_mul(t + 88, t + 83, t + 87, prec);
    arb_sub(t + 89, t + 88, t + 84, prec); /* d(Theta)/d(gamma3) */
    arb_mul(t + 90, t + 79, t + 89, prec);
    arb_mul(t + 91, params + 5, params + 4, prec);
    arb_mul(t + 92, t + 61, t + 81, prec);
    arb_add(t + 93, t + 91, t + 92, prec);
    arb_mul(t + 94, params + 0, params + 5, prec);
    arb_mul(t + 95, t + 33, t + 94, prec);
    arb_add(t + 96, t + 93, t + 95, prec); /* Theta */
    arb_mul(t + 97, t + 31, t + 96, prec);
    arb_mul(t + 98, t + 78, t + 97, prec);
    arb_mul(t + 99, t + 42, t + 98, prec);
    arb_mul(t + 100, t + 83, t + 99, prec);
    arb_add(t + 101, t + 90, t + 100, prec);
    arb_mul(t + 102, params + 0, t + 83, prec);
    arb_mul(t + 103, params + 4, params + 4, prec);
    arb_mul(t + 104, t + 102, t + 103, prec);
    arb_mul(t + 105, x + 2, params + 1, prec);
    arb_add(t + 106, x + 1, t + 105, prec);
    arb_mul(t + 107, t + 104, t + 106, prec);
    arb_mul(t + 108, params + 1, t + 102, prec);
    arb_mul(t + 109, t + 103, t + 108, prec);
    arb_mul(t + 110, t + 106, t + 109, prec);
    arb_mul(t + 111, params + 1, t + 83, prec);
    arb_mul(t + 112, params + 4, t + 111, prec);
    arb_mul(t + 113, t + 31, t + 112, prec);
    arb_mul(t + 114, t + 27, t + 113, prec);
    arb_mul(t + 115, t + 96, t + 114, prec);
    arb_mul(t + 116, t + 78, t + 115, prec);
    arb_div(t + 117, t + 116, t + 19, prec);
    arb_set(out + 0, t + 58);
    arb_set(out + 1, t + 60);
    arb_set(out + 2, t + 64);
    arb_set(out + 3, t + 76);
    arb_set(out + 4, t + 101);
    arb_set(out + 5, t + 107);
    arb_set(out + 6, t + 110);
    arb_set(out + 7, t + 117);
    arb_set(out + 8, t + 0);
    arb_set(out + 9, t + 1);
    arb_set(out + 10, params + 1);
    arb_set(out + 11, t + 0);
    arb_set(out + 12, t + 57);
    arb_set(out + 13, t + 60);
    arb_set(out + 14, t + 0);
    arb_set(out + 15, t + 71);
    arb_set(out + 16, t + 14);
    arb_set(out + 17, t + 0);
    arb_set(out + 18, t + 64);
    arb_set(out + 19, t + 65);
    _arb_vec_clear(t, 118);
}

extern const jlt_ball_table jlt_balls_spherical_top_general_on_level_omega3;
const jlt_ball_table jlt_balls_spherical_top_general_on_level_omega3 = {
    .model = "spherical_top", .time = "", .elimination = "level_omega3",
    .state_count = 4, .param_count = 7,
    .rhs = general_on_level_omega3_rhs,
    .jacobian = general_on_level_omega3_jacobian,
    .divergence = general_on_level_omega3_divergence,
    .integral_count = 5,
    .integral = general_on_level_omega3_integral,
    .integral_values = general_on_level_omega3_integral_values,
    .integral_gradients = general_on_level_omega3_integral_gradients,
};

static void general_in_regular_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(102);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, x + 5, x + 5, prec);
    arb_mul(t + 3, x + 2, t + 2, prec);
    arb_mul(t + 5, x + 3, x + 3, prec);
    arb_mul(t + 9, params + 1, x + 0, prec);
    arb_add(t + 10, params + 3, t + 9, prec); /* b */
    arb_mul(t + 11, t + 5, t + 10, prec);
    arb_mul(t + 12, x + 3, params + 1, prec);
    arb_mul(t + 14, t + 12, x + 4, prec);
    arb_mul(t + 15, x + 5, t + 14, prec);
    arb_add(t + 16, t + 11, t + 15, prec);
    arb_mul(t + 18, params + 3, params + 3, prec);
    arb_mul(t + 19, params + 0, t + 18, prec);
    arb_mul(t + 20, x + 0, t + 19, prec);
    arb_mul(t + 21, x + 2, x + 2, prec);
    arb_mul(t + 22, t + 20, t + 21, prec);
    arb_mul(t + 23, t + 2, t + 22, prec);
    arb_mul(t + 25, t + 2, t + 19, prec);
    arb_add(t + 26, params + 4, t + 25, prec); /* D */
    arb_div(t + 27, t + 23, t + 26, prec);
    arb_mul(t + 29, params + 0, params + 2, prec);
    arb_mul(t + 30, params + 3, t + 29, prec);
    arb_mul(t + 31, t + 2, t + 30, prec);
    arb_div(t + 32, t + 31, t + 26, prec);
    arb_sub(t + 33, t + 27, t + 32, prec);
    arb_mul(t + 34, x + 0, params + 4, prec);
    arb_mul(t + 35, t + 5, t + 34, prec);
    arb_div(t + 36, t + 35, t + 26, prec);
    arb_sub(t + 37, t + 33, t + 36, prec);
    arb_mul(t + 39, x + 3, params + 5, prec);
    arb_mul(t + 40, x + 4, t + 39, prec);
    arb_mul(t + 41, x + 5, t + 40, prec);
    arb_div(t + 42, t + 41, t + 26, prec);
    arb_sub(t + 43, t + 37, t + 42, prec);
    arb_mul(t + 44, x + 2, x + 0, prec);
    arb_mul(t + 45, x + 3, t + 44, prec);
    arb_mul(t + 46, params + 0, params + 5, prec);
    arb_mul(t + 47, x + 3, t + 46, prec);
    arb_mul(t + 48, t + 10, t + 47, prec);
    arb_mul(t + 49, params + 4, params + 5, prec);
    arb_mul(t + 50, params + 1, params + 1, prec);
    arb_mul(t + 51, params + 0, t + 50, prec);
    arb_mul(t + 52, params + 4, t + 51, prec);
    arb_mul(t + 53, t + 2, t + 52, prec);
    arb_add(t + 54, t + 49, t + 53, prec);
    arb_mul(t + 55, t + 10, t + 10, prec);
    arb_mul(t + 56, t + 46, t + 55, prec);
    arb_add(t + 57, t + 54, t + 56, prec); /* Theta */
    arb_mul(t + 59, params + 3, x + 0, prec);
    arb_add(t + 60, params + 1, t + 59, prec); /* e */
    arb_mul(t + 61, x + 2, t + 60, prec);
    arb_add(t + 62, x + 1, t + 61, prec); /* V */
    arb_mul(t + 63, t + 48, t + 62, prec);
    arb_div(t + 64, t + 63, t + 57, prec);
    arb_sub(t + 65, t + 45, t + 64, prec);
    arb_mul(t + 66, params + 5, params + 5, prec);
    arb_mul(t + 67, x + 2, t + 66, prec);
    arb_mul(t + 68, x + 4, t + 67, prec);
    arb_mul(t + 69, x + 5, t + 68, prec);
    arb_div(t + 70, t + 69, t + 57, prec);
    arb_add(t + 71, t + 65, t + 70, prec);
    arb_mul(t + 72, params + 1, params + 0, prec);
    arb_mul(t + 73, params + 5, t + 72, prec);
    arb_mul(t + 74, x + 2, t + 73, prec);
    arb_mul(t + 75, x + 4, t + 74, prec);
    arb_mul(t + 76, x + 5, t + 75, prec);
    arb_mul(t + 77, t + 60, t + 76, prec);
    arb_div(t + 78, t + 77, t + 57, prec);
    arb_add(t + 79, t + 71, t + 78, prec);
    arb_mul(t + 80, params + 4, t + 72, prec);
    arb_mul(t + 81, x + 3, t + 80, prec);
    arb_mul(t + 82, x + 5, t + 81, prec);
    arb_mul(t + 83, t + 62, t + 82, prec);
    arb_div(t + 84, t + 83, t + 57, prec);
    arb_mul(t + 85, x + 0, t + 51, prec);
    arb_mul(t + 86, x + 2, t + 85, prec);
    arb_mul(t + 87, x + 4, t + 86, prec);
    arb_mul(t + 88, t + 2, t + 87, prec);
    arb_sub(t + 89, params + 4, params + 5, prec);
    arb_mul(t + 90, t + 88, t + 89, prec);
    arb_div(t + 91, t + 90, t + 57, prec);
    arb_sub(t + 92, t + 91, t + 84, prec);
    arb_mul(t + 93, params + 3, t + 72, prec);
    arb_mul(t + 94, params + 5, t + 93, prec);
    arb_mul(t + 95, x + 2, t + 94, prec);
    arb_mul(t + 96, x + 4, t + 95, prec);
    arb_mul(t + 97, t + 2, t + 96, prec);
    arb_div(t + 98, t + 97, t + 57, prec);
    arb_sub(t + 99, t + 92, t + 98, prec);
    arb_mul(t + 100, x + 5, t + 44, prec);
    arb_neg(t + 101, t + 100);
    arb_set(out + 0, t + 3);
    arb_set(out + 1, t + 16);
    arb_set(out + 2, t + 43);
    arb_set(out + 3, t + 79);
    arb_set(out + 4, t + 99);
    arb_set(out + 5, t + 101);
    _arb_vec_clear(t, 102);
}

static void general_in_regular_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(335);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_mul(t + 2, x + 5, x + 5, prec);
    arb_set_si(t + 3, 2);
    arb_mul(t + 5, t + 3, x + 2, prec);
    arb_mul(t + 6, x + 5, t + 5, prec);
    arb_mul(t + 9, x + 3, x + 3, prec);
    arb_mul(t + 10, params + 1, t + 9, prec);
    arb_mul(t + 13, params + 1, x + 0, prec);
    arb_add(t + 14, params + 3, t + 13, prec); /* b */
    arb_mul(t + 15, x + 3, t + 14, prec);
    arb_mul(t + 16, t + 3, t + 15, prec);
    arb_mul(t + 18, params + 1, x + 4, prec);
    arb_mul(t + 19, x + 5, t + 18, prec);
    arb_add(t + 20, t + 16, t + 19, prec);
    arb_mul(t + 21, params + 1, x + 3, prec);
    arb_mul(t + 22, x + 5, t + 21, prec);
    arb_mul(t + 23, x + 4, t + 21, prec);
    arb_mul(t + 25, params + 3, params + 3, prec);
    arb_mul(t + 26, params + 0, t + 25, prec);
    arb_mul(t + 27, x + 2, x + 2, prec);
    arb_mul(t + 28, t + 26, t + 27, prec);
    arb_mul(t + 29, t + 2, t + 28, prec);
    arb_mul(t + 31, t + 2, t + 26, prec);
    arb_add(t + 32, params + 4, t + 31, prec); /* D */
    arb_div(t + 33, t + 29, t + 32, prec);
    arb_mul(t + 34, t + 9, params + 4, prec);
    arb_div(t + 35, t + 34, t + 32, prec);
    arb_sub(t + 36, t + 33, t + 35, prec);
    arb_mul(t + 37, t + 3, params + 0, prec);
    arb_mul(t + 38, t + 25, t + 37, prec);
    arb_mul(t + 39, x + 0, t + 38, prec);
    arb_mul(t + 40, x + 2, t + 39, prec);
    arb_mul(t + 41, t + 2, t + 40, prec);
    arb_div(t + 42, t + 41, t + 32, prec);
    arb_mul(t + 43, x + 0, params + 4, prec);
    arb_mul(t + 44, x + 3, t + 43, prec);
    arb_div(t + 45, t + 44, t + 32, prec);
    arb_mul(t + 46, t + 3, t + 45, prec);
    arb_neg(t + 47, t + 46);
    arb_mul(t + 49, x + 4, params + 5, prec);
    arb_mul(t + 50, x + 5, t + 49, prec);
    arb_div(t + 51, t + 50, t + 32, prec);
    arb_sub(t + 52, t + 47, t + 51, prec);
    arb_mul(t + 53, x + 3, params + 5, prec);
    arb_mul(t + 54, x + 5, t + 53, prec);
    arb_div(t + 55, t + 54, t + 32, prec);
    arb_neg(t + 56, t + 55);
    arb_mul(t + 57, x + 0, t + 26, prec);
    arb_mul(t + 58, t + 27, t + 57, prec);
    arb_mul(t + 59, x + 5, t + 58, prec);
    arb_div(t + 60, t + 59, t + 32, prec);
    arb_mul(t + 61, t + 3, t + 60, prec);
    arb_mul(t + 63, params + 0, params + 2, prec);
    arb_mul(t + 64, params + 3, t + 63, prec);
    arb_mul(t + 65, x + 5, t + 64, prec);
    arb_div(t + 66, t + 65, t + 32, prec);
    arb_mul(t + 67, t + 3, t + 66, prec);
    arb_sub(t + 68, t + 61, t + 67, prec);
    arb_mul(t + 69, x + 4, t + 53, prec);
    arb_div(t + 70, t + 69, t + 32, prec);
    arb_sub(t + 71, t + 68, t + 70, prec);
    arb_mul(t + 72, params + 0, params + 0, prec);
    arb_mul(t + 73, t + 25, t + 25, prec);
    arb_mul(t + 74, t + 72, t + 73, prec);
    arb_mul(t + 75, x + 0, t + 74, prec);
    arb_mul(t + 76, t + 27, t + 75, prec);
    arb_mul(t + 77, x + 5, t + 2, prec);
    arb_mul(t + 78, t + 76, t + 77, prec);
    arb_mul(t + 79, t + 32, t + 32, prec);
    arb_div(t + 80, t + 78, t + 79, prec);
    arb_mul(t + 81, t + 3, t + 80, prec);
    arb_sub(t + 82, t + 71, t + 81, prec);
    arb_mul(t + 83, params + 2, t + 72, prec);
    arb_mul(t + 84, params + 3, t + 25, prec);
    arb_mul(t + 85, t + 83, t + 84, prec);
    arb_mul(t + 86, t + 77, t + 85, prec);
    arb_div(t + 87, t + 86, t + 79, prec);
    arb_mul(t + 88, t + 3, t + 87, prec);
    arb_add(t + 89, t + 82, t + 88, prec);
    arb_mul(t + 90, t + 26, params + 4, prec);
    arb_mul(t + 91, x + 0, t + 90, prec);
    arb_mul(t + 92, t + 9, t + 91, prec);
    arb_mul(t + 93, x + 5, t + 92, prec);
    arb_div(t + 94, t + 93, t + 79, prec);
    arb_mul(t + 95, t + 3, t + 94, prec);
    arb_add(t + 96, t + 89, t + 95, prec);
    arb_mul(t + 97, t + 26, params + 5, prec);
    arb_mul(t + 98, x + 3, t + 97, prec);
    arb_mul(t + 99, x + 4, t + 98, prec);
    arb_mul(t + 100, t + 2, t + 99, prec);
    arb_div(t + 101, t + 100, t + 79, prec);
    arb_mul(t + 102, t + 3, t + 101, prec);
    arb_add(t + 103, t + 96, t + 102, prec);
    arb_mul(t + 104, params + 1, params + 0, prec);
    arb_mul(t + 105, params + 3, t + 104, prec);
    arb_mul(t + 106, params + 5, t + 105, prec);
    arb_mul(t + 107, x + 2, t + 106, prec);
    arb_mul(t + 108, x + 4, t + 107, prec);
    arb_mul(t + 109, x + 5, t + 108, prec);
    arb_mul(t + 110, params + 4, params + 5, prec);
    arb_mul(t + 111, params + 1, params + 1, prec);
    arb_mul(t + 112, params + 0, t + 111, prec);
    arb_mul(t + 113, params + 4, t + 112, prec);
    arb_mul(t + 114, t + 2, t + 113, prec);
    arb_add(t + 115, t + 110, t + 114, prec);
    arb_mul(t + 116, params + 0, params + 5, prec);
    arb_mul(t + 117, t + 14, t + 14, prec);
    arb_mul(t + 118, t + 116, t + 117, prec);
    arb_add(t + 119, t + 115, t + 118, prec); /* Theta */
    arb_div(t + 120, t + 109, t + 119, prec);
    arb_mul(t + 121, x + 2, x + 3, prec);
    arb_add(t + 122, t + 120, t + 121, prec);
    arb_mul(t + 123, params + 5, t + 104, prec);
    arb_mul(t + 124, x + 3, t + 123, prec);
    arb_mul(t + 126, params + 3, x + 0, prec);
    arb_add(t + 127, params + 1, t + 126, prec); /* e */
    arb_mul(t + 128, x + 2, t + 127, prec);
    arb_add(t + 129, x + 1, t + 128, prec); /* V */
    arb_mul(t + 130, t + 124, t + 129, prec);
    arb_div(t + 131, t + 130, t + 119, prec);
    arb_sub(t + 132, t + 122, t + 131, prec);
    arb_mul(t + 133, params + 3, params + 0, prec);
    arb_mul(t + 134, params + 5, t + 133, prec);
    arb_mul(t + 135, x + 2, t + 134, prec);
    arb_mul(t + 136, x + 3, t + 135, prec);
    arb_mul(t + 137, t + 14, t + 136, prec);
    arb_div(t + 138, t + 137, t + 119, prec);
    arb_sub(t + 139, t + 132, t + 138, prec);
    arb_mul(t + 140, params + 1, t + 72, prec);
    arb_mul(t + 141, params + 5, params + 5, prec);
    arb_mul(t + 142, t + 140, t + 141, prec);
    arb_mul(t + 143, x + 3, t + 142, prec);
    arb_mul(t + 144, t + 117, t + 143, prec);
    arb_mul(t + 145, t + 119, t + 119, prec);
    arb_mul(t + 146, t + 129, t + 144, prec);
    arb_div(t + 147, t + 146, t + 145, prec);
    arb_mul(t + 148, t + 3, t + 147, prec);
    arb_add(t + 149, t + 139, t + 148, prec);
    arb_mul(t + 150, params + 5, t + 141, prec);
    arb_mul(t + 151, t + 104, t + 150, prec);
    arb_mul(t + 152, x + 2, t + 151, prec);
    arb_mul(t + 153, x + 4, t + 152, prec);
    arb_mul(t + 154, x + 5, t + 153, prec);
    arb_mul(t + 155, t + 14, t + 154, prec);
    arb_div(t + 156, t + 155, t + 145, prec);
    arb_mul(t + 157, t + 3, t + 156, prec);
    arb_sub(t + 158, t + 149, t + 157, prec);
    arb_mul(t + 159, t + 72, t + 111, prec);
    arb_mul(t + 160, t + 141, t + 159, prec);
    arb_mul(t + 161, x + 2, t + 160, prec);
    arb_mul(t + 162, x + 4, t + 161, prec);
    arb_mul(t + 163, x + 5, t + 162, prec);
    arb_mul(t + 164, t + 14, t + 163, prec);
    arb_mul(t + 165, t + 127, t + 164, prec);
    arb_div(t + 166, t + 165, t + 145, prec);
    arb_mul(t + 167, t + 3, t + 166, prec);
    arb_sub(t + 168, t + 158, t + 167, prec);
    arb_mul(t + 169, x + 3, t + 116, prec);
    arb_mul(t + 170, t + 14, t + 169, prec);
    arb_div(t + 171, t + 170, t + 119, prec);
    arb_neg(t + 172, t + 171);
    arb_mul(t + 173, x + 3, x + 0, prec);
    arb_mul(t + 174, t + 127, t + 170, prec);
    arb_div(t + 175, t + 174, t + 119, prec);
    arb_sub(t + 176, t + 173, t + 175, prec);
    arb_mul(t + 177, x + 4, t + 141, prec);
    arb_mul(t + 178, x + 5, t + 177, prec);
    arb_div(t + 179, t + 178, t + 119, prec);
    arb_add(t + 180, t + 176, t + 179, prec);
    arb_mul(t + 181, x + 4, t + 123, prec);
    arb_mul(t + 182, x + 5, t + 181, prec);
    arb_mul(t + 183, t + 127, t + 182, prec);
    arb_div(t + 184, t + 183, t + 119, prec);
    arb_add(t + 185, t + 180, t + 184, prec);
    arb_mul(t + 186, x + 2, x + 0, prec);
    arb_mul(t + 187, t + 14, t + 116, prec);
    arb_mul(t + 188, t + 129, t + 187, prec);
    arb_div(t + 189, t + 188, t + 119, prec);
    arb_sub(t + 190, t + 186, t + 189, prec);
    arb_mul(t + 191, x + 2, t + 141, prec);
    arb_mul(t + 192, x + 5, t + 191, prec);
    arb_div(t + 193, t + 192, t + 119, prec);
    arb_mul(t + 194, x + 2, t + 123, prec);
    arb_mul(t + 195, x + 5, t + 194, prec);
    arb_mul(t + 196, t + 127, t + 195, prec);
    arb_div(t + 197, t + 196, t + 119, prec);
    arb_add(t + 198, t + 193, t + 197, prec);
    arb_mul(t + 199, x + 4, t + 191, prec);
    arb_div(t + 200, t + 199, t + 119, prec);
    arb_mul(t + 201, x + 4, t + 194, prec);
    arb_mul(t + 202, t + 127, t + 201, prec);
    arb_div(t + 203, t + 202, t + 119, prec);
    arb_add(t + 204, t + 200, t + 203, prec);
    arb_mul(t + 205, params + 4, t + 159, prec);
    arb_mul(t + 206, params + 5, t + 205, prec);
    arb_mul(t + 207, x + 3, t + 206, prec);
    arb_mul(t + 208, x + 5, t + 207, prec);
    arb_mul(t + 209, t + 14, t + 208, prec);
    arb_mul(t + 210, t + 129, t + 209, prec);
    arb_div(t + 211, t + 210, t + 145, prec);
    arb_mul(t + 212, t + 3, t + 211, prec);
    arb_add(t + 213, t + 204, t + 212, prec);
    arb_mul(t + 214, t + 113, t + 141, prec);
    arb_mul(t + 215, x + 2, t + 214, prec);
    arb_mul(t + 216, x + 4, t + 215, prec);
    arb_mul(t + 217, t + 2, t + 216, prec);
    arb_div(t + 218, t + 217, t + 145, prec);
    arb_mul(t + 219, t + 3, t + 218, prec);
    arb_sub(t + 220, t + 213, t + 219, prec);
    arb_mul(t + 221, params + 1, t + 111, prec);
    arb_mul(t + 222, t + 72, t + 221, prec);
    arb_mul(t + 223, params + 4, t + 222, prec);
    arb_mul(t + 224, params + 5, t + 223, prec);
    arb_mul(t + 225, x + 2, t + 224, prec);
    arb_mul(t + 226, x + 4, t + 225, prec);
    arb_mul(t + 227, t + 2, t + 226, prec);
    arb_mul(t + 228, t + 127, t + 227, prec);
    arb_div(t + 229, t + 228, t + 145, prec);
    arb_mul(t + 230, t + 3, t + 229, prec);
    arb_sub(t + 231, t + 220, t + 230, prec);
    arb_mul(t + 232, params + 4, t + 105, prec);
    arb_mul(t + 233, x + 2, t + 232, prec);
    arb_mul(t + 234, x + 3, t + 233, prec);
    arb_mul(t + 235, x + 5, t + 234, prec);
    arb_div(t + 236, t + 235, t + 119, prec);
    arb_sub(t + 237, t + 212, t + 236, prec);
    arb_mul(t + 238, x + 2, t + 112, prec);
    arb_mul(t + 239, x + 4, t + 238, prec);
    arb_mul(t + 240, t + 2, t + 239, prec);
    arb_sub(t + 241, params + 4, params + 5, prec);
    arb_mul(t + 242, t + 240, t + 241, prec);
    arb_div(t + 243, t + 242, t + 119, prec);
    arb_add(t + 244, t + 237, t + 243, prec);
    arb_mul(t + 245, params + 5, t + 222, prec);
    arb_mul(t + 246, x + 0, t + 245, prec);
    arb_mul(t + 247, x + 2, t + 246, prec);
    arb_mul(t + 248, x + 4, t + 247, prec);
    arb_mul(t + 249, t + 2, t + 248, prec);
    arb_mul(t + 250, t + 14, t + 249, prec);
    arb_mul(t + 251, t + 241, t + 250, prec);
    arb_div(t + 252, t + 251, t + 145, prec);
    arb_mul(t + 253, t + 3, t + 252, prec);
    arb_sub(t + 254, t + 244, t + 253, prec);
    arb_mul(t + 255, params + 3, t + 159, prec);
    arb_mul(t + 256, t + 141, t + 255, prec);
    arb_mul(t + 257, x + 2, t + 256, prec);
    arb_mul(t + 258, x + 4, t + 257, prec);
    arb_mul(t + 259, t + 2, t + 258, prec);
    arb_mul(t + 260, t + 14, t + 259, prec);
    arb_div(t + 261, t + 260, t + 145, prec);
    arb_mul(t + 262, t + 3, t + 261, prec);
    arb_add(t + 263, t + 254, t + 262, prec);
    arb_mul(t + 264, params + 4, t + 104, prec);
    arb_mul(t + 265, x + 3, t + 264, prec);
    arb_mul(t + 266, x + 5, t + 265, prec);
    arb_div(t + 267, t + 266, t + 119, prec);
    arb_neg(t + 268, t + 267);
    arb_mul(t + 269, t + 127, t + 266, prec);
    arb_div(t + 270, t + 269, t + 119, prec);
    arb_mul(t + 271, x + 0, t + 112, prec);
    arb_mul(t + 272, x + 4, t + 271, prec);
    arb_mul(t + 273, t + 2, t + 272, prec);
    arb_mul(t + 274, t + 241, t + 273, prec);
    arb_div(t + 275, t + 274, t + 119, prec);
    arb_sub(t + 276, t + 275, t + 270, prec);
    arb_mul(t + 277, x + 4, t + 106, prec);
    arb_mul(t + 278, t + 2, t + 277, prec);
    arb_div(t + 279, t + 278, t + 119, prec);
    arb_sub(t + 280, t + 276, t + 279, prec);
    arb_mul(t + 281, x + 5, t + 264, prec);
    arb_mul(t + 282, t + 129, t + 281, prec);
    arb_div(t + 283, t + 282, t + 119, prec);
    arb_neg(t + 284, t + 283);
    arb_mul(t + 285, x + 2, t + 271, prec);
    arb_mul(t + 286, t + 2, t + 285, prec);
    arb_mul(t + 287, t + 241, t + 286, prec);
    arb_div(t + 288, t + 287, t + 119, prec);
    arb_mul(t + 289, t + 2, t + 107, prec);
    arb_div(t + 290, t + 289, t + 119, prec);
    arb_sub(t + 291, t + 288, t + 290, prec);
    arb_mul(t + 292, t + 129, t + 265, prec);
    arb_div(t + 293, t + 292, t + 119, prec);
    arb_mul(t + 294, x + 4, t + 285, prec);
    arb_mul(t + 295, x + 5, t + 294, prec);
    arb_mul(t + 296, t + 241, t + 295, prec);
    arb_div(t + 297, t + 296, t + 119, prec);
    arb_mul(t + 298, t + 3, t + 297, prec);
    arb_sub(t + 299, t + 298, t + 293, prec);
    arb_mul(t + 300, t + 3, t + 120, prec);
    arb_sub(t + 301, t + 299, t + 300, prec);
    arb_mul(t + 302, params + 4, params + 4, prec);
    arb_mul(t + 303, t + 222, t + 302, prec);
    arb_mul(t + 304, x + 3, t + 303, prec);
    arb_mul(t + 305, t + 2, t + 304, prec);
    arb_mul(t + 306, t + 129, t + 305, prec);
    arb_div(t + 307, t + 306, t + 145, prec);
    arb_mul(t + 308, t + 3, t + 307, prec);
    arb_add(t + 309, t + 301, t + 308, prec);
    arb_mul(t + 310, t + 111, t + 111, prec);
    arb_mul(t + 311, t + 72, t + 310, prec);
    arb_mul(t + 312, params + 4, t + 311, prec);
    arb_mul(t + 313, x + 0, t + 312, prec);
    arb_mul(t + 314, x + 2, t + 313, prec);
    arb_mul(t + 315, x + 4, t + 314, prec);
    arb_mul(t + 316, t + 77, t + 315, prec);
    arb_mul(t + 317, t + 241, t + 316, prec);
    arb_div(t + 318, t + 317, t + 145, prec);
    arb_mul(t + 319, t + 3, t + 318, prec);
    arb_sub(t + 320, t + 309, t + 319, prec);
    arb_mul(t + 321, params + 3, t + 222, prec);
    arb_mul(t + 322, params + 4, t + 321, prec);
    arb_mul(t + 323, params + 5, t + 322, prec);
    arb_mul(t + 324, x + 2, t + 323, prec);
    arb_mul(t + 325, x + 4, t + 324, prec);
    arb_mul(t + 326, t + 77, t + 325, prec);
    arb_div(t + 327, t + 326, t + 145, prec);
    arb_mul(t + 328, t + 3, t + 327, prec);
    arb_add(t + 329, t + 320, t + 328, prec);
    arb_mul(t + 330, x + 5, x + 2, prec);
    arb_neg(t + 331, t + 330);
    arb_mul(t + 332, x + 5, x + 0, prec);
    arb_neg(t + 333, t + 332);
    arb_neg(t + 334, t + 186);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 0);
    arb_set(out + 2, t + 2);
    arb_set(out + 3, t + 0);
    arb_set(out + 4, t + 0);
    arb_set(out + 5, t + 6);
    arb_set(out + 6, t + 10);
    arb_set(out + 7, t + 0);
    arb_set(out + 8, t + 0);
    arb_set(out + 9, t + 20);
    arb_set(out + 10, t + 22);
    arb_set(out + 11, t + 23);
    arb_set(out + 12, t + 36);
    arb_set(out + 13, t + 0);
    arb_set(out + 14, t + 42);
    arb_set(out + 15, t + 52);
    arb_set(out + 16, t + 56);
    arb_set(out + 17, t + 103);
    arb_set(out + 18, t + 168);
    arb_set(out + 19, t + 172);
    arb_set(out + 20, t + 185);
    arb_set(out + 21, t + 190);
    arb_set(out + 22, t + 198);
    arb_set(out + 23, t + 231);
    arb_set(out + 24, t + 263);
    arb_set(out + 25, t + 268);
    arb_set(out + 26, t + 280);
    arb_set(out + 27, t + 284);
    arb_set(out + 28, t + 291);
    arb_set(out + 29, t + 329);
    arb_set(out + 30, t + 331);
    arb_set(out + 31, t + 0);
    arb_set(out + 32, t + 333);
    arb_set(out + 33, t + 0);
    arb_set(out + 34, t + 0);
    arb_set(out + 35, t + 334);
    _arb_vec_clear(t, 335);
}

static void general_in_regular_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(54);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 3, params + 3, prec);
    arb_mul(t + 3, params + 0, t + 2, prec);
    arb_mul(t + 5, t + 3, x + 0, prec);
    arb_mul(t + 7, t + 5, x + 2, prec);
    arb_mul(t + 9, x + 5, x + 5, prec);
    arb_mul(t + 10, t + 7, t + 9, prec);
    arb_mul(t + 12, t + 3, t + 9, prec);
    arb_add(t + 13, params + 4, t + 12, prec); /* D */
    arb_div(t + 14, t + 10, t + 13, prec);
    arb_set_si(t + 15, 2);
    arb_mul(t + 16, t + 14, t + 15, prec);
    arb_mul(t + 18, params + 0, params + 5, prec);
    arb_mul(t + 20, x + 0, params + 1, prec);
    arb_add(t + 21, params + 3, t + 20, prec); /* b */
    arb_mul(t + 22, t + 18, t + 21, prec);
    arb_mul(t + 23, params + 4, params + 5, prec);
    arb_mul(t + 24, params + 1, params + 1, prec);
    arb_mul(t + 25, params + 0, t + 24, prec);
    arb_mul(t + 26, params + 4, t + 25, prec);
    arb_mul(t + 27, t + 9, t + 26, prec);
    arb_add(t + 28, t + 23, t + 27, prec);
    arb_mul(t + 29, t + 21, t + 21, prec);
    arb_mul(t + 30, t + 18, t + 29, prec);
    arb_add(t + 31, t + 28, t + 30, prec); /* Theta */
    arb_mul(t + 33, params + 3, x + 0, prec);
    arb_add(t + 34, params + 1, t + 33, prec); /* e */
    arb_mul(t + 35, x + 2, t + 34, prec);
    arb_add(t + 36, x + 1, t + 35, prec); /* V */
    arb_mul(t + 37, t + 22, t + 36, prec);
    arb_div(t + 38, t + 37, t + 31, prec);
    arb_sub(t + 39, t + 16, t + 38, prec);
    arb_mul(t + 40, x + 0, t + 25, prec);
    arb_mul(t + 41, x + 2, t + 40, prec);
    arb_mul(t + 42, t + 9, t + 41, prec);
    arb_sub(t + 43, params + 4, params + 5, prec);
    arb_mul(t + 44, t + 42, t + 43, prec);
    arb_div(t + 45, t + 44, t + 31, prec);
    arb_add(t + 46, t + 39, t + 45, prec);
    arb_mul(t + 47, params + 0, params + 1, prec);
    arb_mul(t + 48, params + 3, t + 47, prec);
    arb_mul(t + 49, params + 5, t + 48, prec);
    arb_mul(t + 50, x + 2, t + 49, prec);
    arb_mul(t + 51, t + 9, t + 50, prec);
    arb_div(t + 52, t + 51, t + 31, prec);
    arb_sub(t + 53, t + 46, t + 52, prec);
    arb_set(out + 0, t + 53);
    _arb_vec_clear(t, 54);
}

static const char *const general_in_regular_integral[] = { "E", "G", "F0", "F_linear", "E1", "E2" };

static void general_in_regular_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(76);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 0, params + 2, prec);
    arb_mul(t + 4, t + 2, params + 3, prec);
    arb_mul(t + 6, t + 4, x + 0, prec);
    arb_mul(t + 8, x + 1, x + 1, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    jlt_ball_rational(t + 10, "1/2", prec);
    arb_mul(t + 11, t + 9, t + 10, prec);
    arb_add(t + 12, t + 6, t + 11, prec);
    arb_mul(t + 14, x + 2, x + 2, prec);
    arb_mul(t + 16, params + 3, params + 3, prec);
    arb_mul(t + 17, params + 0, t + 16, prec);
    arb_mul(t + 19, x + 5, x + 5, prec);
    arb_mul(t + 20, t + 17, t + 19, prec);
    arb_add(t + 21, params + 4, t + 20, prec); /* D */
    arb_mul(t + 22, t + 14, t + 21, prec);
    arb_mul(t + 23, t + 10, t + 22, prec);
    arb_add(t + 24, t + 12, t + 23, prec);
    arb_mul(t + 26, x + 3, x + 3, prec);
    arb_mul(t + 27, params + 4, t + 26, prec);
    arb_mul(t + 28, t + 10, t + 27, prec);
    arb_add(t + 29, t + 24, t + 28, prec);
    arb_mul(t + 32, x + 4, x + 4, prec);
    arb_mul(t + 33, params + 5, t + 32, prec);
    arb_mul(t + 34, t + 10, t + 33, prec);
    arb_add(t + 35, t + 29, t + 34, prec);
    arb_mul(t + 37, x + 0, params + 1, prec);
    arb_add(t + 38, params + 3, t + 37, prec); /* b */
    arb_mul(t + 39, x + 3, t + 38, prec);
    arb_mul(t + 40, x + 4, params + 1, prec);
    arb_mul(t + 41, x + 5, t + 40, prec);
    arb_add(t + 42, t + 39, t + 41, prec); /* v_tau */
    arb_mul(t + 43, t + 42, t + 42, prec);
    arb_mul(t + 44, params + 0, t + 43, prec);
    arb_mul(t + 45, t + 10, t + 44, prec);
    arb_add(t + 46, t + 35, t + 45, prec); /* energy */
    arb_mul(t + 47, params + 4, params + 1, prec);
    arb_mul(t + 48, x + 3, t + 47, prec);
    arb_mul(t + 49, x + 5, t + 48, prec);
    arb_mul(t + 50, params + 5, x + 4, prec);
    arb_mul(t + 51, t + 38, t + 50, prec);
    arb_sub(t + 52, t + 49, t + 51, prec);
    arb_mul(t + 53, params + 4, params + 4, prec);
    arb_mul(t + 54, params + 0, t + 53, prec);
    arb_mul(t + 55, x + 2, params + 1, prec);
    arb_add(t + 56, x + 1, t + 55, prec);
    arb_mul(t + 57, t + 56, t + 56, prec);
    arb_mul(t + 58, t + 54, t + 57, prec);
    arb_mul(t + 59, params + 4, params + 5, prec);
    arb_mul(t + 60, params + 1, params + 1, prec);
    arb_mul(t + 61, params + 0, t + 60, prec);
    arb_mul(t + 62, params + 4, t + 61, prec);
    arb_mul(t + 63, t + 19, t + 62, prec);
    arb_add(t + 64, t + 59, t + 63, prec);
    arb_mul(t + 65, params + 0, params + 5, prec);
    arb_mul(t + 66, t + 38, t + 38, prec);
    arb_mul(t + 67, t + 65, t + 66, prec);
    arb_add(t + 68, t + 64, t + 67, prec); /* Theta */
    arb_mul(t + 69, t + 32, t + 68, prec);
    arb_sub(t + 70, params + 4, params + 5, prec);
    arb_mul(t + 71, t + 69, t + 70, prec);
    arb_add(t + 72, t + 58, t + 71, prec);
    arb_add(t + 73, t + 11, t + 45, prec);
    arb_add(t + 74, t + 6, t + 23, prec);
    arb_add(t + 75, t + 28, t + 74, prec);
    arb_set(out + 0, t + 46);
    arb_set(out + 1, t + 52);
    arb_set(out + 2, t + 72);
    arb_set(out + 3, t + 56);
    arb_set(out + 4, t + 73);
    arb_set(out + 5, t + 75);
    _arb_vec_clear(t, 76);
}

static void general_in_regular_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(89);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, params + 0, params + 2, prec);
    arb_mul(t + 6, t + 4, params + 3, prec);
    arb_mul(t + 8, params + 0, params + 1, prec);
    arb_mul(t + 10, t + 8, x + 3, prec);
    arb_mul(t + 12, params + 1, x + 0, prec);
    arb_add(t + 13, params + 3, t + 12, prec); /* b */
    arb_mul(t + 14, x + 3, t + 13, prec);
    arb_mul(t + 16, params + 1, x + 4, prec);
    arb_mul(t + 18, t + 16, x + 5, prec);
    arb_add(t + 19, t + 14, t + 18, prec); /* v_tau */
    arb_mul(t + 20, t + 10, t + 19, prec);
    arb_add(t + 21, t + 6, t + 20, prec); /* d(energy)/d(gamma3) */
    arb_mul(t + 23, params + 0, x + 1, prec);
    arb_mul(t + 26, params + 3, params + 3, prec);
    arb_mul(t + 27, params + 0, t + 26, prec);
    arb_mul(t + 28, x + 5, x + 5, prec);
    arb_mul(t + 29, t + 27, t + 28, prec);
    arb_add(t + 30, params + 4, t + 29, prec); /* D */
    arb_mul(t + 31, x + 2, t + 30, prec);
    arb_mul(t + 32, x + 3, params + 4, prec);
    arb_mul(t + 33, params + 0, t + 13, prec);
    arb_mul(t + 34, t + 19, t + 33, prec);
    arb_add(t + 35, t + 32, t + 34, prec); /* d(energy)/d(omega_n) */
    arb_mul(t + 37, x + 4, params + 5, prec);
    arb_mul(t + 38, t + 8, x + 5, prec);
    arb_mul(t + 39, t + 19, t + 38, prec);
    arb_add(t + 40, t + 37, t + 39, prec); /* d(energy)/d(omega3) */
    arb_mul(t + 41, x + 2, x + 2, prec);
    arb_mul(t + 42, t + 27, t + 41, prec);
    arb_mul(t + 43, x + 5, t + 42, prec);
    arb_mul(t + 44, t + 8, x + 4, prec);
    arb_mul(t + 45, t + 19, t + 44, prec);
    arb_add(t + 46, t + 43, t + 45, prec); /* d(energy)/d(s) */
    arb_mul(t + 47, params + 1, params + 5, prec);
    arb_mul(t + 48, x + 4, t + 47, prec);
    arb_neg(t + 49, t + 48);
    arb_mul(t + 50, params + 1, params + 4, prec);
    arb_mul(t + 51, x + 5, t + 50, prec);
    arb_mul(t + 52, t + 13, params + 5, prec);
    arb_neg(t + 53, t + 52);
    arb_mul(t + 54, x + 3, t + 50, prec);
    arb_set_si(t + 55, 2);
    arb_mul(t + 56, params + 0, t + 55, prec);
    arb_mul(t + 57, params + 1, t + 56, prec);
    arb_mul(t + 58, params + 5, t + 57, prec);
    arb_mul(t + 59, x + 4, x + 4, prec);
    arb_mul(t + 60, t + 58, t + 59, prec);
    arb_mul(t + 61, t + 13, t + 60, prec);
    arb_sub(t + 62, params + 4, params + 5, prec);
    arb_mul(t + 63, t + 61, t + 62, prec);
    arb_mul(t + 64, params + 4, params + 4, prec);
    arb_mul(t + 65, t + 56, t + 64, prec);
    arb_mul(t + 66, params + 1, x + 2, prec);
    arb_add(t + 67, x + 1, t + 66, prec);
    arb_mul(t + 68, t + 65, t + 67, prec);
    arb_mul(t + 69, t + 57, t + 64, prec);
    arb_mul(t + 70, t + 67, t + 69, prec);
    arb_mul(t + 71, x + 4, t + 55, prec);
    arb_mul(t + 72, params + 4, params + 5, prec);
    arb_mul(t + 73, params + 1, params + 1, prec);
    arb_mul(t + 74, params + 0, t + 73, prec);
    arb_mul(t + 75, params + 4, t + 74, prec);
    arb_mul(t + 76, t + 28, t + 75, prec);
    arb_add(t + 77, t + 72, t + 76, prec);
    arb_mul(t + 78, params + 0, params + 5, prec);
    arb_mul(t + 79, t + 13, t + 13, prec);
    arb_mul(t + 80, t + 78, t + 79, prec);
    arb_add(t + 81, t + 77, t + 80, prec); /* Theta */
    arb_mul(t + 82, t + 71, t + 81, prec);
    arb_mul(t + 83, t + 62, t + 82, prec);
    arb_mul(t + 84, t + 56, t + 73, prec);
    arb_mul(t + 85, params + 4, t + 84, prec);
    arb_mul(t + 86, t + 59, t + 85, prec);
    arb_mul(t + 87, x + 5, t + 86, prec);
    arb_mul(t + 88, t + 62, t + 87, prec);
    arb_set(out + 0, t + 21);
    arb_set(out + 1, t + 23);
    arb_set(out + 2, t + 31);
    arb_set(out + 3, t + 35);
    arb_set(out + 4, t + 40);
    arb_set(out + 5, t + 46);
    arb_set(out + 6, t + 49);
    arb_set(out + 7, t + 0);
    arb_set(out + 8, t + 0);
    arb_set(out + 9, t + 51);
    arb_set(out + 10, t + 53);
    arb_set(out + 11, t + 54);
    arb_set(out + 12, t + 63);
    arb_set(out + 13, t + 68);
    arb_set(out + 14, t + 70);
    arb_set(out + 15, t + 0);
    arb_set(out + 16, t + 83);
    arb_set(out + 17, t + 88);
    arb_set(out + 18, t + 0);
    arb_set(out + 19, t + 1);
    arb_set(out + 20, params + 1);
    arb_set(out + 21, t + 0);
    arb_set(out + 22, t + 0);
    arb_set(out + 23, t + 0);
    arb_set(out + 24, t + 20);
    arb_set(out + 25, t + 23);
    arb_set(out + 26, t + 0);
    arb_set(out + 27, t + 34);
    arb_set(out + 28, t + 39);
    arb_set(out + 29, t + 45);
    arb_set(out + 30, t + 6);
    arb_set(out + 31, t + 0);
    arb_set(out + 32, t + 31);
    arb_set(out + 33, t + 32);
    arb_set(out + 34, t + 0);
    arb_set(out + 35, t + 43);
    _arb_vec_clear(t, 89);
}

extern const jlt_ball_table jlt_balls_spherical_top_general_in_regular;
const jlt_ball_table jlt_balls_spherical_top_general_in_regular = {
    .model = "spherical_top", .time = "regular", .elimination = "",
    .state_count = 6, .param_count = 6,
    .rhs = general_in_regular_rhs,
    .jacobian = general_in_regular_jacobian,
    .divergence = general_in_regular_divergence,
    .integral_count = 6,
    .integral = general_in_regular_integral,
    .integral_values = general_in_regular_integral_values,
    .integral_gradients = general_in_regular_integral_gradients,
};

static void general_in_regular_on_level_omega_n_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(89);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, x + 4, x + 4, prec);
    arb_mul(t + 3, x + 2, t + 2, prec);
    arb_mul(t + 6, params + 1, params + 4, prec);
    arb_mul(t + 7, x + 4, t + 6, prec);
    arb_mul(t + 11, params + 5, x + 3, prec);
    arb_mul(t + 14, params + 1, x + 0, prec);
    arb_add(t + 15, params + 3, t + 14, prec); /* b */
    arb_mul(t + 16, t + 11, t + 15, prec);
    arb_add(t + 17, params + 6, t + 16, prec);
    arb_div(t + 18, t + 17, t + 7, prec); /* omega_n */
    arb_mul(t + 19, t + 18, t + 18, prec);
    arb_mul(t + 20, t + 15, t + 19, prec);
    arb_mul(t + 21, params + 1, t + 18, prec);
    arb_mul(t + 22, x + 3, t + 21, prec);
    arb_mul(t + 23, x + 4, t + 22, prec);
    arb_add(t + 24, t + 20, t + 23, prec);
    arb_mul(t + 26, params + 3, params + 3, prec);
    arb_mul(t + 27, params + 0, t + 26, prec);
    arb_mul(t + 28, x + 0, t + 27, prec);
    arb_mul(t + 29, x + 2, x + 2, prec);
    arb_mul(t + 30, t + 28, t + 29, prec);
    arb_mul(t + 31, t + 2, t + 30, prec);
    arb_mul(t + 32, t + 2, t + 27, prec);
    arb_add(t + 33, params + 4, t + 32, prec); /* D */
    arb_div(t + 34, t + 31, t + 33, prec);
    arb_mul(t + 36, params + 0, params + 2, prec);
    arb_mul(t + 37, params + 3, t + 36, prec);
    arb_mul(t + 38, t + 2, t + 37, prec);
    arb_div(t + 39, t + 38, t + 33, prec);
    arb_sub(t + 40, t + 34, t + 39, prec);
    arb_mul(t + 41, params + 4, x + 0, prec);
    arb_mul(t + 42, t + 19, t + 41, prec);
    arb_div(t + 43, t + 42, t + 33, prec);
    arb_sub(t + 44, t + 40, t + 43, prec);
    arb_mul(t + 45, params + 5, t + 18, prec);
    arb_mul(t + 46, x + 3, t + 45, prec);
    arb_mul(t + 47, x + 4, t + 46, prec);
    arb_div(t + 48, t + 47, t + 33, prec);
    arb_sub(t + 49, t + 44, t + 48, prec);
    arb_mul(t + 50, params + 1, params + 0, prec);
    arb_mul(t + 51, params + 4, t + 50, prec);
    arb_mul(t + 52, t + 18, t + 51, prec);
    arb_mul(t + 53, x + 4, t + 52, prec);
    arb_mul(t + 54, params + 4, params + 5, prec);
    arb_mul(t + 55, params + 1, params + 1, prec);
    arb_mul(t + 56, params + 0, t + 55, prec);
    arb_mul(t + 57, params + 4, t + 56, prec);
    arb_mul(t + 58, t + 2, t + 57, prec);
    arb_add(t + 59, t + 54, t + 58, prec);
    arb_mul(t + 60, params + 5, params + 0, prec);
    arb_mul(t + 61, t + 15, t + 15, prec);
    arb_mul(t + 62, t + 60, t + 61, prec);
    arb_add(t + 63, t + 59, t + 62, prec); /* Theta */
    arb_mul(t + 65, params + 3, x + 0, prec);
    arb_add(t + 66, params + 1, t + 65, prec); /* e */
    arb_mul(t + 67, x + 2, t + 66, prec);
    arb_add(t + 68, x + 1, t + 67, prec); /* V */
    arb_mul(t + 69, t + 53, t + 68, prec);
    arb_div(t + 70, t + 69, t + 63, prec);
    arb_mul(t + 71, x + 0, t + 56, prec);
    arb_mul(t + 72, x + 2, t + 71, prec);
    arb_mul(t + 73, x + 3, t + 72, prec);
    arb_mul(t + 74, t + 2, t + 73, prec);
    arb_sub(t + 75, params + 4, params + 5, prec);
    arb_mul(t + 76, t + 74, t + 75, prec);
    arb_div(t + 77, t + 76, t + 63, prec);
    arb_sub(t + 78, t + 77, t + 70, prec);
    arb_mul(t + 79, params + 3, t + 50, prec);
    arb_mul(t + 80, params + 5, t + 79, prec);
    arb_mul(t + 81, x + 2, t + 80, prec);
    arb_mul(t + 82, x + 3, t + 81, prec);
    arb_mul(t + 83, t + 2, t + 82, prec);
    arb_div(t + 84, t + 83, t + 63, prec);
    arb_sub(t + 85, t + 78, t + 84, prec);
    arb_mul(t + 86, x + 2, x + 0, prec);
    arb_mul(t + 87, x + 4, t + 86, prec);
    arb_neg(t + 88, t + 87);
    arb_set(out + 0, t + 3);
    arb_set(out + 1, t + 24);
    arb_set(out + 2, t + 49);
    arb_set(out + 3, t + 85);
    arb_set(out + 4, t + 88);
    _arb_vec_clear(t, 89);
}

static void general_in_regular_on_level_omega_n_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(303);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_mul(t + 2, x + 4, x + 4, prec);
    arb_set_si(t + 3, 2);
    arb_mul(t + 5, t + 3, x + 2, prec);
    arb_mul(t + 6, x + 4, t + 5, prec);
    arb_mul(t + 9, params + 1, params + 4, prec);
    arb_mul(t + 10, x + 4, t + 9, prec);
    arb_mul(t + 14, params + 5, x + 3, prec);
    arb_mul(t + 17, params + 1, x + 0, prec);
    arb_add(t + 18, params + 3, t + 17, prec); /* b */
    arb_mul(t + 19, t + 14, t + 18, prec);
    arb_add(t + 20, params + 6, t + 19, prec);
    arb_div(t + 21, t + 20, t + 10, prec); /* omega_n */
    arb_mul(t + 22, t + 21, t + 21, prec);
    arb_mul(t + 23, params + 1, t + 22, prec);
    arb_mul(t + 24, params + 5, t + 21, prec);
    arb_mul(t + 25, x + 3, t + 24, prec);
    arb_mul(t + 26, x + 4, params + 4, prec);
    arb_mul(t + 27, t + 18, t + 25, prec);
    arb_div(t + 28, t + 27, t + 26, prec);
    arb_mul(t + 29, t + 3, t + 28, prec);
    arb_add(t + 30, t + 23, t + 29, prec);
    arb_mul(t + 31, params + 1, params + 5, prec);
    arb_mul(t + 32, x + 3, x + 3, prec);
    arb_mul(t + 33, t + 31, t + 32, prec);
    arb_div(t + 34, t + 33, params + 4, prec);
    arb_add(t + 35, t + 30, t + 34, prec);
    arb_mul(t + 36, params + 1, t + 21, prec);
    arb_mul(t + 37, x + 4, t + 36, prec);
    arb_mul(t + 38, t + 18, t + 18, prec);
    arb_mul(t + 39, t + 24, t + 38, prec);
    arb_div(t + 40, t + 39, t + 10, prec);
    arb_mul(t + 41, t + 3, t + 40, prec);
    arb_add(t + 42, t + 37, t + 41, prec);
    arb_div(t + 43, t + 19, params + 4, prec);
    arb_add(t + 44, t + 42, t + 43, prec);
    arb_mul(t + 45, x + 3, t + 36, prec);
    arb_mul(t + 46, t + 2, t + 9, prec);
    arb_mul(t + 47, t + 18, t + 21, prec);
    arb_mul(t + 48, t + 20, t + 47, prec);
    arb_div(t + 49, t + 48, t + 46, prec);
    arb_mul(t + 50, t + 3, t + 49, prec);
    arb_sub(t + 51, t + 45, t + 50, prec);
    arb_mul(t + 52, x + 3, t + 20, prec);
    arb_div(t + 53, t + 52, t + 26, prec);
    arb_sub(t + 54, t + 51, t + 53, prec);
    arb_mul(t + 56, params + 3, params + 3, prec);
    arb_mul(t + 57, params + 0, t + 56, prec);
    arb_mul(t + 58, x + 2, x + 2, prec);
    arb_mul(t + 59, t + 57, t + 58, prec);
    arb_mul(t + 60, t + 2, t + 59, prec);
    arb_mul(t + 61, t + 2, t + 57, prec);
    arb_add(t + 62, params + 4, t + 61, prec); /* D */
    arb_div(t + 63, t + 60, t + 62, prec);
    arb_mul(t + 64, params + 4, t + 22, prec);
    arb_div(t + 65, t + 64, t + 62, prec);
    arb_sub(t + 66, t + 63, t + 65, prec);
    arb_mul(t + 67, params + 5, x + 0, prec);
    arb_mul(t + 68, t + 21, t + 67, prec);
    arb_mul(t + 69, x + 3, t + 68, prec);
    arb_mul(t + 70, x + 4, t + 62, prec);
    arb_div(t + 71, t + 69, t + 70, prec);
    arb_mul(t + 72, t + 3, t + 71, prec);
    arb_sub(t + 73, t + 66, t + 72, prec);
    arb_mul(t + 74, params + 5, params + 5, prec);
    arb_mul(t + 75, t + 32, t + 74, prec);
    arb_mul(t + 76, params + 4, t + 62, prec);
    arb_div(t + 77, t + 75, t + 76, prec);
    arb_sub(t + 78, t + 73, t + 77, prec);
    arb_mul(t + 79, t + 3, params + 0, prec);
    arb_mul(t + 80, t + 56, t + 79, prec);
    arb_mul(t + 81, x + 0, t + 80, prec);
    arb_mul(t + 82, x + 2, t + 81, prec);
    arb_mul(t + 83, t + 2, t + 82, prec);
    arb_div(t + 84, t + 83, t + 62, prec);
    arb_mul(t + 85, x + 4, t + 24, prec);
    arb_div(t + 86, t + 85, t + 62, prec);
    arb_neg(t + 87, t + 86);
    arb_mul(t + 88, x + 4, params + 1, prec);
    arb_mul(t + 89, t + 18, t + 68, prec);
    arb_mul(t + 90, t + 62, t + 88, prec);
    arb_div(t + 91, t + 89, t + 90, prec);
    arb_mul(t + 92, t + 3, t + 91, prec);
    arb_sub(t + 93, t + 87, t + 92, prec);
    arb_mul(t + 94, x + 3, t + 74, prec);
    arb_mul(t + 95, t + 18, t + 94, prec);
    arb_mul(t + 96, t + 9, t + 62, prec);
    arb_div(t + 97, t + 95, t + 96, prec);
    arb_sub(t + 98, t + 93, t + 97, prec);
    arb_mul(t + 99, x + 0, t + 57, prec);
    arb_mul(t + 100, t + 58, t + 99, prec);
    arb_mul(t + 101, x + 4, t + 100, prec);
    arb_div(t + 102, t + 101, t + 62, prec);
    arb_mul(t + 103, t + 3, t + 102, prec);
    arb_mul(t + 105, params + 0, params + 2, prec);
    arb_mul(t + 106, params + 3, t + 105, prec);
    arb_mul(t + 107, x + 4, t + 106, prec);
    arb_div(t + 108, t + 107, t + 62, prec);
    arb_mul(t + 109, t + 3, t + 108, prec);
    arb_sub(t + 110, t + 103, t + 109, prec);
    arb_div(t + 111, t + 25, t + 62, prec);
    arb_sub(t + 112, t + 110, t + 111, prec);
    arb_mul(t + 113, params + 0, params + 0, prec);
    arb_mul(t + 114, t + 56, t + 56, prec);
    arb_mul(t + 115, t + 113, t + 114, prec);
    arb_mul(t + 116, x + 0, t + 115, prec);
    arb_mul(t + 117, t + 58, t + 116, prec);
    arb_mul(t + 118, x + 4, t + 2, prec);
    arb_mul(t + 119, t + 117, t + 118, prec);
    arb_mul(t + 120, t + 62, t + 62, prec);
    arb_div(t + 121, t + 119, t + 120, prec);
    arb_mul(t + 122, t + 3, t + 121, prec);
    arb_sub(t + 123, t + 112, t + 122, prec);
    arb_mul(t + 124, params + 2, t + 113, prec);
    arb_mul(t + 125, params + 3, t + 56, prec);
    arb_mul(t + 126, t + 124, t + 125, prec);
    arb_mul(t + 127, t + 118, t + 126, prec);
    arb_div(t + 128, t + 127, t + 120, prec);
    arb_mul(t + 129, t + 3, t + 128, prec);
    arb_add(t + 130, t + 123, t + 129, prec);
    arb_mul(t + 131, params + 4, t + 57, prec);
    arb_mul(t + 132, x + 0, t + 131, prec);
    arb_mul(t + 133, t + 22, t + 132, prec);
    arb_mul(t + 134, x + 4, t + 133, prec);
    arb_div(t + 135, t + 134, t + 120, prec);
    arb_mul(t + 136, t + 3, t + 135, prec);
    arb_add(t + 137, t + 130, t + 136, prec);
    arb_mul(t + 138, params + 5, t + 57, prec);
    arb_mul(t + 139, t + 21, t + 138, prec);
    arb_mul(t + 140, x + 3, t + 139, prec);
    arb_mul(t + 141, t + 2, t + 140, prec);
    arb_div(t + 142, t + 141, t + 120, prec);
    arb_mul(t + 143, t + 3, t + 142, prec);
    arb_add(t + 144, t + 137, t + 143, prec);
    arb_mul(t + 145, x + 0, t + 21, prec);
    arb_mul(t + 146, t + 2, params + 1, prec);
    arb_mul(t + 147, t + 62, t + 146, prec);
    arb_mul(t + 148, t + 20, t + 145, prec);
    arb_div(t + 149, t + 148, t + 147, prec);
    arb_mul(t + 150, t + 3, t + 149, prec);
    arb_add(t + 151, t + 144, t + 150, prec);
    arb_mul(t + 152, t + 10, t + 62, prec);
    arb_mul(t + 153, t + 14, t + 20, prec);
    arb_div(t + 154, t + 153, t + 152, prec);
    arb_add(t + 155, t + 151, t + 154, prec);
    arb_mul(t + 156, params + 1, params + 1, prec);
    arb_mul(t + 157, t + 113, t + 156, prec);
    arb_mul(t + 158, params + 4, t + 157, prec);
    arb_mul(t + 159, params + 5, t + 158, prec);
    arb_mul(t + 160, t + 21, t + 159, prec);
    arb_mul(t + 161, x + 4, t + 160, prec);
    arb_mul(t + 162, t + 18, t + 161, prec);
    arb_mul(t + 163, params + 4, params + 5, prec);
    arb_mul(t + 164, params + 0, t + 156, prec);
    arb_mul(t + 165, params + 4, t + 164, prec);
    arb_mul(t + 166, t + 2, t + 165, prec);
    arb_add(t + 167, t + 163, t + 166, prec);
    arb_mul(t + 168, params + 5, params + 0, prec);
    arb_mul(t + 169, t + 38, t + 168, prec);
    arb_add(t + 170, t + 167, t + 169, prec); /* Theta */
    arb_mul(t + 171, t + 170, t + 170, prec);
    arb_mul(t + 173, params + 3, x + 0, prec);
    arb_add(t + 174, params + 1, t + 173, prec); /* e */
    arb_mul(t + 175, x + 2, t + 174, prec);
    arb_add(t + 176, x + 1, t + 175, prec); /* V */
    arb_mul(t + 177, t + 162, t + 176, prec);
    arb_div(t + 178, t + 177, t + 171, prec);
    arb_mul(t + 179, t + 3, t + 178, prec);
    arb_mul(t + 180, params + 1, params + 0, prec);
    arb_mul(t + 181, params + 3, t + 180, prec);
    arb_mul(t + 182, params + 4, t + 181, prec);
    arb_mul(t + 183, x + 2, t + 182, prec);
    arb_mul(t + 184, t + 21, t + 183, prec);
    arb_mul(t + 185, x + 4, t + 184, prec);
    arb_div(t + 186, t + 185, t + 170, prec);
    arb_sub(t + 187, t + 179, t + 186, prec);
    arb_mul(t + 188, x + 2, t + 164, prec);
    arb_mul(t + 189, x + 3, t + 188, prec);
    arb_mul(t + 190, t + 2, t + 189, prec);
    arb_sub(t + 191, params + 4, params + 5, prec);
    arb_mul(t + 192, t + 190, t + 191, prec);
    arb_div(t + 193, t + 192, t + 170, prec);
    arb_add(t + 194, t + 187, t + 193, prec);
    arb_mul(t + 195, params + 1, t + 156, prec);
    arb_mul(t + 196, t + 113, t + 195, prec);
    arb_mul(t + 197, params + 5, t + 196, prec);
    arb_mul(t + 198, x + 0, t + 197, prec);
    arb_mul(t + 199, x + 2, t + 198, prec);
    arb_mul(t + 200, x + 3, t + 199, prec);
    arb_mul(t + 201, t + 2, t + 200, prec);
    arb_mul(t + 202, t + 18, t + 201, prec);
    arb_mul(t + 203, t + 191, t + 202, prec);
    arb_div(t + 204, t + 203, t + 171, prec);
    arb_mul(t + 205, t + 3, t + 204, prec);
    arb_sub(t + 206, t + 194, t + 205, prec);
    arb_mul(t + 207, params + 3, t + 157, prec);
    arb_mul(t + 208, t + 74, t + 207, prec);
    arb_mul(t + 209, x + 2, t + 208, prec);
    arb_mul(t + 210, x + 3, t + 209, prec);
    arb_mul(t + 211, t + 2, t + 210, prec);
    arb_mul(t + 212, t + 18, t + 211, prec);
    arb_div(t + 213, t + 212, t + 171, prec);
    arb_mul(t + 214, t + 3, t + 213, prec);
    arb_add(t + 215, t + 206, t + 214, prec);
    arb_mul(t + 216, params + 5, t + 180, prec);
    arb_mul(t + 217, x + 3, t + 216, prec);
    arb_mul(t + 218, t + 176, t + 217, prec);
    arb_div(t + 219, t + 218, t + 170, prec);
    arb_sub(t + 220, t + 215, t + 219, prec);
    arb_mul(t + 221, params + 4, t + 180, prec);
    arb_mul(t + 222, t + 21, t + 221, prec);
    arb_mul(t + 223, x + 4, t + 222, prec);
    arb_div(t + 224, t + 223, t + 170, prec);
    arb_neg(t + 225, t + 224);
    arb_mul(t + 226, t + 174, t + 223, prec);
    arb_div(t + 227, t + 226, t + 170, prec);
    arb_mul(t + 228, x + 0, t + 164, prec);
    arb_mul(t + 229, x + 3, t + 228, prec);
    arb_mul(t + 230, t + 2, t + 229, prec);
    arb_mul(t + 231, t + 191, t + 230, prec);
    arb_div(t + 232, t + 231, t + 170, prec);
    arb_sub(t + 233, t + 232, t + 227, prec);
    arb_mul(t + 234, params + 5, t + 181, prec);
    arb_mul(t + 235, x + 3, t + 234, prec);
    arb_mul(t + 236, t + 2, t + 235, prec);
    arb_div(t + 237, t + 236, t + 170, prec);
    arb_sub(t + 238, t + 233, t + 237, prec);
    arb_mul(t + 239, t + 18, t + 168, prec);
    arb_mul(t + 240, t + 176, t + 239, prec);
    arb_div(t + 241, t + 240, t + 170, prec);
    arb_mul(t + 242, x + 2, t + 228, prec);
    arb_mul(t + 243, t + 2, t + 242, prec);
    arb_mul(t + 244, t + 191, t + 243, prec);
    arb_div(t + 245, t + 244, t + 170, prec);
    arb_sub(t + 246, t + 245, t + 241, prec);
    arb_mul(t + 247, x + 2, t + 234, prec);
    arb_mul(t + 248, t + 2, t + 247, prec);
    arb_div(t + 249, t + 248, t + 170, prec);
    arb_sub(t + 250, t + 246, t + 249, prec);
    arb_mul(t + 251, t + 176, t + 222, prec);
    arb_div(t + 252, t + 251, t + 170, prec);
    arb_mul(t + 253, x + 3, t + 242, prec);
    arb_mul(t + 254, x + 4, t + 253, prec);
    arb_mul(t + 255, t + 191, t + 254, prec);
    arb_div(t + 256, t + 255, t + 170, prec);
    arb_mul(t + 257, t + 3, t + 256, prec);
    arb_sub(t + 258, t + 257, t + 252, prec);
    arb_mul(t + 259, x + 3, t + 247, prec);
    arb_mul(t + 260, x + 4, t + 259, prec);
    arb_div(t + 261, t + 260, t + 170, prec);
    arb_mul(t + 262, t + 3, t + 261, prec);
    arb_sub(t + 263, t + 258, t + 262, prec);
    arb_mul(t + 264, params + 4, params + 4, prec);
    arb_mul(t + 265, t + 196, t + 264, prec);
    arb_mul(t + 266, t + 21, t + 265, prec);
    arb_mul(t + 267, t + 2, t + 266, prec);
    arb_mul(t + 268, t + 176, t + 267, prec);
    arb_div(t + 269, t + 268, t + 171, prec);
    arb_mul(t + 270, t + 3, t + 269, prec);
    arb_add(t + 271, t + 263, t + 270, prec);
    arb_mul(t + 272, t + 156, t + 156, prec);
    arb_mul(t + 273, t + 113, t + 272, prec);
    arb_mul(t + 274, params + 4, t + 273, prec);
    arb_mul(t + 275, x + 0, t + 274, prec);
    arb_mul(t + 276, x + 2, t + 275, prec);
    arb_mul(t + 277, x + 3, t + 276, prec);
    arb_mul(t + 278, t + 118, t + 277, prec);
    arb_mul(t + 279, t + 191, t + 278, prec);
    arb_div(t + 280, t + 279, t + 171, prec);
    arb_mul(t + 281, t + 3, t + 280, prec);
    arb_sub(t + 282, t + 271, t + 281, prec);
    arb_mul(t + 283, params + 3, t + 196, prec);
    arb_mul(t + 284, params + 4, t + 283, prec);
    arb_mul(t + 285, params + 5, t + 284, prec);
    arb_mul(t + 286, x + 2, t + 285, prec);
    arb_mul(t + 287, x + 3, t + 286, prec);
    arb_mul(t + 288, t + 118, t + 287, prec);
    arb_div(t + 289, t + 288, t + 171, prec);
    arb_mul(t + 290, t + 3, t + 289, prec);
    arb_add(t + 291, t + 282, t + 290, prec);
    arb_mul(t + 292, x + 4, t + 170, prec);
    arb_mul(t + 293, params + 0, t + 176, prec);
    arb_mul(t + 294, t + 20, t + 293, prec);
    arb_div(t + 295, t + 294, t + 292, prec);
    arb_add(t + 296, t + 291, t + 295, prec);
    arb_mul(t + 297, x + 4, x + 2, prec);
    arb_neg(t + 298, t + 297);
    arb_mul(t + 299, x + 4, x + 0, prec);
    arb_neg(t + 300, t + 299);
    arb_mul(t + 301, x + 2, x + 0, prec);
    arb_neg(t + 302, t + 301);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 0);
    arb_set(out + 2, t + 2);
    arb_set(out + 3, t + 0);
    arb_set(out + 4, t + 6);
    arb_set(out + 5, t + 35);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 0);
    arb_set(out + 8, t + 44);
    arb_set(out + 9, t + 54);
    arb_set(out + 10, t + 78);
    arb_set(out + 11, t + 0);
    arb_set(out + 12, t + 84);
    arb_set(out + 13, t + 98);
    arb_set(out + 14, t + 155);
    arb_set(out + 15, t + 220);
    arb_set(out + 16, t + 225);
    arb_set(out + 17, t + 238);
    arb_set(out + 18, t + 250);
    arb_set(out + 19, t + 296);
    arb_set(out + 20, t + 298);
    arb_set(out + 21, t + 0);
    arb_set(out + 22, t + 300);
    arb_set(out + 23, t + 0);
    arb_set(out + 24, t + 302);
    _arb_vec_clear(t, 303);
}

static void general_in_regular_on_level_omega_n_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(56);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 3, params + 3, prec);
    arb_mul(t + 3, params + 0, t + 2, prec);
    arb_mul(t + 5, t + 3, x + 0, prec);
    arb_mul(t + 7, t + 5, x + 2, prec);
    arb_mul(t + 9, x + 4, x + 4, prec);
    arb_mul(t + 10, t + 7, t + 9, prec);
    arb_mul(t + 12, t + 3, t + 9, prec);
    arb_add(t + 13, params + 4, t + 12, prec); /* D */
    arb_div(t + 14, t + 10, t + 13, prec);
    arb_set_si(t + 15, 2);
    arb_mul(t + 16, t + 14, t + 15, prec);
    arb_mul(t + 17, x + 0, x + 2, prec);
    arb_sub(t + 18, t + 16, t + 17, prec);
    arb_mul(t + 20, params + 0, params + 5, prec);
    arb_mul(t + 22, x + 0, params + 1, prec);
    arb_add(t + 23, params + 3, t + 22, prec); /* b */
    arb_mul(t + 24, t + 20, t + 23, prec);
    arb_mul(t + 25, params + 4, params + 5, prec);
    arb_mul(t + 26, params + 1, params + 1, prec);
    arb_mul(t + 27, params + 0, t + 26, prec);
    arb_mul(t + 28, params + 4, t + 27, prec);
    arb_mul(t + 29, t + 9, t + 28, prec);
    arb_add(t + 30, t + 25, t + 29, prec);
    arb_mul(t + 31, t + 23, t + 23, prec);
    arb_mul(t + 32, t + 20, t + 31, prec);
    arb_add(t + 33, t + 30, t + 32, prec); /* Theta */
    arb_mul(t + 35, params + 3, x + 0, prec);
    arb_add(t + 36, params + 1, t + 35, prec); /* e */
    arb_mul(t + 37, x + 2, t + 36, prec);
    arb_add(t + 38, x + 1, t + 37, prec); /* V */
    arb_mul(t + 39, t + 24, t + 38, prec);
    arb_div(t + 40, t + 39, t + 33, prec);
    arb_sub(t + 41, t + 18, t + 40, prec);
    arb_mul(t + 42, x + 0, t + 27, prec);
    arb_mul(t + 43, x + 2, t + 42, prec);
    arb_mul(t + 44, t + 9, t + 43, prec);
    arb_sub(t + 45, params + 4, params + 5, prec);
    arb_mul(t + 46, t + 44, t + 45, prec);
    arb_div(t + 47, t + 46, t + 33, prec);
    arb_add(t + 48, t + 41, t + 47, prec);
    arb_mul(t + 49, params + 0, params + 1, prec);
    arb_mul(t + 50, params + 3, t + 49, prec);
    arb_mul(t + 51, params + 5, t + 50, prec);
    arb_mul(t + 52, x + 2, t + 51, prec);
    arb_mul(t + 53, t + 9, t + 52, prec);
    arb_div(t + 54, t + 53, t + 33, prec);
    arb_sub(t + 55, t + 48, t + 54, prec);
    arb_set(out + 0, t + 55);
    _arb_vec_clear(t, 56);
}

static const char *const general_in_regular_on_level_omega_n_integral[] = { "E", "F0", "F_linear", "E1", "E2" };

static void general_in_regular_on_level_omega_n_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(76);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 0, params + 2, prec);
    arb_mul(t + 4, t + 2, params + 3, prec);
    arb_mul(t + 6, t + 4, x + 0, prec);
    arb_mul(t + 8, x + 1, x + 1, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    jlt_ball_rational(t + 10, "1/2", prec);
    arb_mul(t + 11, t + 9, t + 10, prec);
    arb_add(t + 12, t + 6, t + 11, prec);
    arb_mul(t + 14, x + 2, x + 2, prec);
    arb_mul(t + 16, params + 3, params + 3, prec);
    arb_mul(t + 17, params + 0, t + 16, prec);
    arb_mul(t + 19, x + 4, x + 4, prec);
    arb_mul(t + 20, t + 17, t + 19, prec);
    arb_add(t + 21, params + 4, t + 20, prec); /* D */
    arb_mul(t + 22, t + 14, t + 21, prec);
    arb_mul(t + 23, t + 10, t + 22, prec);
    arb_add(t + 24, t + 12, t + 23, prec);
    arb_mul(t + 26, params + 4, params + 1, prec);
    arb_mul(t + 27, x + 4, t + 26, prec);
    arb_mul(t + 31, params + 5, x + 3, prec);
    arb_mul(t + 32, x + 0, params + 1, prec);
    arb_add(t + 33, params + 3, t + 32, prec); /* b */
    arb_mul(t + 34, t + 31, t + 33, prec);
    arb_add(t + 35, params + 6, t + 34, prec);
    arb_div(t + 36, t + 35, t + 27, prec); /* omega_n */
    arb_mul(t + 37, t + 36, t + 36, prec);
    arb_mul(t + 38, params + 4, t + 37, prec);
    arb_mul(t + 39, t + 10, t + 38, prec);
    arb_add(t + 40, t + 24, t + 39, prec);
    arb_mul(t + 41, x + 3, x + 3, prec);
    arb_mul(t + 42, params + 5, t + 41, prec);
    arb_mul(t + 43, t + 10, t + 42, prec);
    arb_add(t + 44, t + 40, t + 43, prec);
    arb_mul(t + 45, t + 33, t + 36, prec);
    arb_mul(t + 46, params + 1, x + 3, prec);
    arb_mul(t + 47, x + 4, t + 46, prec);
    arb_add(t + 48, t + 45, t + 47, prec); /* v_tau */
    arb_mul(t + 49, t + 48, t + 48, prec);
    arb_mul(t + 50, params + 0, t + 49, prec);
    arb_mul(t + 51, t + 10, t + 50, prec);
    arb_add(t + 52, t + 44, t + 51, prec); /* energy */
    arb_mul(t + 53, params + 4, params + 4, prec);
    arb_mul(t + 54, params + 0, t + 53, prec);
    arb_mul(t + 55, x + 2, params + 1, prec);
    arb_add(t + 56, x + 1, t + 55, prec);
    arb_mul(t + 57, t + 56, t + 56, prec);
    arb_mul(t + 58, t + 54, t + 57, prec);
    arb_mul(t + 59, params + 4, params + 5, prec);
    arb_mul(t + 60, params + 1, params + 1, prec);
    arb_mul(t + 61, params + 0, t + 60, prec);
    arb_mul(t + 62, params + 4, t + 61, prec);
    arb_mul(t + 63, t + 19, t + 62, prec);
    arb_add(t + 64, t + 59, t + 63, prec);
    arb_mul(t + 65, params + 0, params + 5, prec);
    arb_mul(t + 66, t + 33, t + 33, prec);
    arb_mul(t + 67, t + 65, t + 66, prec);
    arb_add(t + 68, t + 64, t + 67, prec); /* Theta */
    arb_mul(t + 69, t + 41, t + 68, prec);
    arb_sub(t + 70, params + 4, params + 5, prec);
    arb_mul(t + 71, t + 69, t + 70, prec);
    arb_add(t + 72, t + 58, t + 71, prec);
    arb_add(t + 73, t + 11, t + 51, prec);
    arb_add(t + 74, t + 6, t + 23, prec);
    arb_add(t + 75, t + 39, t + 74, prec);
    arb_set(out + 0, t + 52);
    arb_set(out + 1, t + 72);
    arb_set(out + 2, t + 56);
    arb_set(out + 3, t + 73);
    arb_set(out + 4, t + 75);
    _arb_vec_clear(t, 76);
}

static void general_in_regular_on_level_omega_n_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(103);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, params + 0, params + 2, prec);
    arb_mul(t + 6, t + 4, params + 3, prec);
    arb_mul(t + 9, params + 1, params + 4, prec);
    arb_mul(t + 11, t + 9, x + 4, prec);
    arb_mul(t + 15, params + 5, x + 3, prec);
    arb_mul(t + 17, params + 1, x + 0, prec);
    arb_add(t + 18, params + 3, t + 17, prec); /* b */
    arb_mul(t + 19, t + 15, t + 18, prec);
    arb_add(t + 20, params + 6, t + 19, prec);
    arb_div(t + 21, t + 20, t + 11, prec); /* omega_n */
    arb_mul(t + 22, t + 18, t + 21, prec);
    arb_mul(t + 23, params + 1, x + 3, prec);
    arb_mul(t + 24, x + 4, t + 23, prec);
    arb_add(t + 25, t + 22, t + 24, prec); /* v_tau */
    arb_mul(t + 26, params + 0, t + 25, prec);
    arb_mul(t + 27, params + 1, t + 21, prec);
    arb_mul(t + 28, params + 4, x + 4, prec);
    arb_div(t + 29, t + 19, t + 28, prec);
    arb_add(t + 30, t + 27, t + 29, prec); /* d(v_tau)/d(gamma3) */
    arb_mul(t + 31, t + 26, t + 30, prec);
    arb_add(t + 32, t + 6, t + 31, prec);
    arb_mul(t + 33, params + 5, t + 21, prec);
    arb_mul(t + 34, x + 3, t + 33, prec);
    arb_div(t + 35, t + 34, x + 4, prec);
    arb_add(t + 36, t + 32, t + 35, prec); /* d(energy)/d(gamma3) */
    arb_mul(t + 38, params + 0, x + 1, prec);
    arb_mul(t + 40, params + 3, params + 3, prec);
    arb_mul(t + 41, params + 0, t + 40, prec);
    arb_mul(t + 42, x + 4, x + 4, prec);
    arb_mul(t + 43, t + 41, t + 42, prec);
    arb_add(t + 44, params + 4, t + 43, prec); /* D */
    arb_mul(t + 45, x + 2, t + 44, prec);
    arb_mul(t + 46, params + 1, x + 4, prec);
    arb_mul(t + 47, t + 18, t + 33, prec);
    arb_div(t + 48, t + 47, t + 46, prec);
    arb_add(t + 49, t + 15, t + 48, prec);
    arb_mul(t + 50, t + 18, t + 18, prec);
    arb_mul(t + 51, params + 5, t + 50, prec);
    arb_div(t + 52, t + 51, t + 11, prec);
    arb_add(t + 53, t + 46, t + 52, prec); /* d(v_tau)/d(omega3) */
    arb_mul(t + 54, t + 26, t + 53, prec);
    arb_add(t + 55, t + 49, t + 54, prec); /* d(energy)/d(omega3) */
    arb_mul(t + 56, x + 2, x + 2, prec);
    arb_mul(t + 57, t + 41, t + 56, prec);
    arb_mul(t + 58, x + 4, t + 57, prec);
    arb_mul(t + 59, params + 1, t + 42, prec);
    arb_mul(t + 60, t + 20, t + 21, prec);
    arb_div(t + 61, t + 60, t + 59, prec);
    arb_sub(t + 62, t + 58, t + 61, prec);
    arb_mul(t + 63, t + 9, t + 42, prec);
    arb_mul(t + 64, t + 18, t + 20, prec);
    arb_div(t + 65, t + 64, t + 63, prec);
    arb_sub(t + 66, t + 23, t + 65, prec); /* d(v_tau)/d(s) */
    arb_mul(t + 67, t + 26, t + 66, prec);
    arb_add(t + 68, t + 62, t + 67, prec); /* d(energy)/d(s) */
    arb_set_si(t + 69, 2);
    arb_mul(t + 70, params + 0, t + 69, prec);
    arb_mul(t + 71, params + 1, t + 70, prec);
    arb_mul(t + 72, params + 5, t + 71, prec);
    arb_mul(t + 73, x + 3, x + 3, prec);
    arb_mul(t + 74, t + 72, t + 73, prec);
    arb_mul(t + 75, t + 18, t + 74, prec);
    arb_sub(t + 76, params + 4, params + 5, prec);
    arb_mul(t + 77, t + 75, t + 76, prec);
    arb_mul(t + 78, params + 4, params + 4, prec);
    arb_mul(t + 79, t + 70, t + 78, prec);
    arb_mul(t + 80, params + 1, x + 2, prec);
    arb_add(t + 81, x + 1, t + 80, prec);
    arb_mul(t + 82, t + 79, t + 81, prec);
    arb_mul(t + 83, t + 71, t + 78, prec);
    arb_mul(t + 84, t + 81, t + 83, prec);
    arb_mul(t + 85, x + 3, t + 69, prec);
    arb_mul(t + 86, params + 4, params + 5, prec);
    arb_mul(t + 87, params + 1, params + 1, prec);
    arb_mul(t + 88, params + 0, t + 87, prec);
    arb_mul(t + 89, params + 4, t + 88, prec);
    arb_mul(t + 90, t + 42, t + 89, prec);
    arb_add(t + 91, t + 86, t + 90, prec);
    arb_mul(t + 92, params + 0, params + 5, prec);
    arb_mul(t + 93, t + 50, t + 92, prec);
    arb_add(t + 94, t + 91, t + 93, prec); /* Theta */
    arb_mul(t + 95, t + 85, t + 94, prec);
    arb_mul(t + 96, t + 76, t + 95, prec);
    arb_mul(t + 97, t + 70, t + 87, prec);
    arb_mul(t + 98, params + 4, t + 97, prec);
    arb_mul(t + 99, t + 73, t + 98, prec);
    arb_mul(t + 100, x + 4, t + 99, prec);
    arb_mul(t + 101, t + 76, t + 100, prec);
    arb_add(t + 102, t + 6, t + 35, prec);
    arb_set(out + 0, t + 36);
    arb_set(out + 1, t + 38);
    arb_set(out + 2, t + 45);
    arb_set(out + 3, t + 55);
    arb_set(out + 4, t + 68);
    arb_set(out + 5, t + 77);
    arb_set(out + 6, t + 82);
    arb_set(out + 7, t + 84);
    arb_set(out + 8, t + 96);
    arb_set(out + 9, t + 101);
    arb_set(out + 10, t + 0);
    arb_set(out + 11, t + 1);
    arb_set(out + 12, params + 1);
    arb_set(out + 13, t + 0);
    arb_set(out + 14, t + 0);
    arb_set(out + 15, t + 31);
    arb_set(out + 16, t + 38);
    arb_set(out + 17, t + 0);
    arb_set(out + 18, t + 54);
    arb_set(out + 19, t + 67);
    arb_set(out + 20, t + 102);
    arb_set(out + 21, t + 0);
    arb_set(out + 22, t + 45);
    arb_set(out + 23, t + 48);
    arb_set(out + 24, t + 62);
    _arb_vec_clear(t, 103);
}

extern const jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega_n;
const jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega_n = {
    .model = "spherical_top", .time = "regular", .elimination = "level_omega_n",
    .state_count = 5, .param_count = 7,
    .rhs = general_in_regular_on_level_omega_n_rhs,
    .jacobian = general_in_regular_on_level_omega_n_jacobian,
    .divergence = general_in_regular_on_level_omega_n_divergence,
    .integral_count = 5,
    .integral = general_in_regular_on_level_omega_n_integral,
    .integral_values = general_in_regular_on_level_omega_n_integral_values,
    .integral_gradients = general_in_regular_on_level_omega_n_integral_gradients,
};

static void general_in_regular_on_level_omega3_rhs(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(88);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, x + 4, x + 4, prec);
    arb_mul(t + 3, x + 2, t + 2, prec);
    arb_mul(t + 5, x + 3, x + 3, prec);
    arb_mul(t + 9, params + 1, x + 0, prec);
    arb_add(t + 10, params + 3, t + 9, prec); /* b */
    arb_mul(t + 11, t + 5, t + 10, prec);
    arb_mul(t + 12, x + 3, params + 1, prec);
    arb_mul(t + 14, t + 10, params + 5, prec);
    arb_mul(t + 17, params + 1, params + 4, prec);
    arb_mul(t + 18, x + 3, t + 17, prec);
    arb_mul(t + 19, x + 4, t + 18, prec);
    arb_sub(t + 20, t + 19, params + 6, prec);
    arb_div(t + 21, t + 20, t + 14, prec); /* omega3 */
    arb_mul(t + 22, t + 12, t + 21, prec);
    arb_mul(t + 23, x + 4, t + 22, prec);
    arb_add(t + 24, t + 11, t + 23, prec);
    arb_mul(t + 26, params + 3, params + 3, prec);
    arb_mul(t + 27, params + 0, t + 26, prec);
    arb_mul(t + 28, x + 0, t + 27, prec);
    arb_mul(t + 29, x + 2, x + 2, prec);
    arb_mul(t + 30, t + 28, t + 29, prec);
    arb_mul(t + 31, t + 2, t + 30, prec);
    arb_mul(t + 32, t + 2, t + 27, prec);
    arb_add(t + 33, params + 4, t + 32, prec); /* D */
    arb_div(t + 34, t + 31, t + 33, prec);
    arb_mul(t + 36, params + 0, params + 2, prec);
    arb_mul(t + 37, params + 3, t + 36, prec);
    arb_mul(t + 38, t + 2, t + 37, prec);
    arb_div(t + 39, t + 38, t + 33, prec);
    arb_sub(t + 40, t + 34, t + 39, prec);
    arb_mul(t + 41, x + 0, params + 4, prec);
    arb_mul(t + 42, t + 5, t + 41, prec);
    arb_div(t + 43, t + 42, t + 33, prec);
    arb_sub(t + 44, t + 40, t + 43, prec);
    arb_mul(t + 45, x + 3, params + 5, prec);
    arb_mul(t + 46, t + 21, t + 45, prec);
    arb_mul(t + 47, x + 4, t + 46, prec);
    arb_div(t + 48, t + 47, t + 33, prec);
    arb_sub(t + 49, t + 44, t + 48, prec);
    arb_mul(t + 50, x + 2, x + 0, prec);
    arb_mul(t + 51, x + 3, t + 50, prec);
    arb_mul(t + 52, params + 5, params + 0, prec);
    arb_mul(t + 53, x + 3, t + 52, prec);
    arb_mul(t + 54, t + 10, t + 53, prec);
    arb_mul(t + 55, params + 5, params + 4, prec);
    arb_mul(t + 56, params + 1, params + 1, prec);
    arb_mul(t + 57, params + 0, t + 56, prec);
    arb_mul(t + 58, params + 4, t + 57, prec);
    arb_mul(t + 59, t + 2, t + 58, prec);
    arb_add(t + 60, t + 55, t + 59, prec);
    arb_mul(t + 61, t + 10, t + 10, prec);
    arb_mul(t + 62, t + 52, t + 61, prec);
    arb_add(t + 63, t + 60, t + 62, prec); /* Theta */
    arb_mul(t + 65, params + 3, x + 0, prec);
    arb_add(t + 66, params + 1, t + 65, prec); /* e */
    arb_mul(t + 67, x + 2, t + 66, prec);
    arb_add(t + 68, x + 1, t + 67, prec); /* V */
    arb_mul(t + 69, t + 54, t + 68, prec);
    arb_div(t + 70, t + 69, t + 63, prec);
    arb_sub(t + 71, t + 51, t + 70, prec);
    arb_mul(t + 72, params + 5, params + 5, prec);
    arb_mul(t + 73, x + 2, t + 72, prec);
    arb_mul(t + 74, t + 21, t + 73, prec);
    arb_mul(t + 75, x + 4, t + 74, prec);
    arb_div(t + 76, t + 75, t + 63, prec);
    arb_add(t + 77, t + 71, t + 76, prec);
    arb_mul(t + 78, params + 1, params + 0, prec);
    arb_mul(t + 79, params + 5, t + 78, prec);
    arb_mul(t + 80, x + 2, t + 79, prec);
    arb_mul(t + 81, t + 21, t + 80, prec);
    arb_mul(t + 82, x + 4, t + 81, prec);
    arb_mul(t + 83, t + 66, t + 82, prec);
    arb_div(t + 84, t + 83, t + 63, prec);
    arb_add(t + 85, t + 77, t + 84, prec);
    arb_mul(t + 86, x + 4, t + 50, prec);
    arb_neg(t + 87, t + 86);
    arb_set(out + 0, t + 3);
    arb_set(out + 1, t + 24);
    arb_set(out + 2, t + 49);
    arb_set(out + 3, t + 85);
    arb_set(out + 4, t + 87);
    _arb_vec_clear(t, 88);
}

static void general_in_regular_on_level_omega3_jacobian(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(295);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_mul(t + 2, x + 4, x + 4, prec);
    arb_set_si(t + 3, 2);
    arb_mul(t + 5, t + 3, x + 2, prec);
    arb_mul(t + 6, x + 4, t + 5, prec);
    arb_mul(t + 9, x + 3, x + 3, prec);
    arb_mul(t + 10, params + 1, t + 9, prec);
    arb_mul(t + 11, params + 1, params + 1, prec);
    arb_mul(t + 13, x + 3, t + 11, prec);
    arb_mul(t + 14, x + 4, t + 13, prec);
    arb_mul(t + 17, params + 1, x + 0, prec);
    arb_add(t + 18, params + 3, t + 17, prec); /* b */
    arb_mul(t + 19, t + 18, t + 18, prec);
    arb_mul(t + 20, params + 5, t + 19, prec);
    arb_mul(t + 23, params + 1, params + 4, prec);
    arb_mul(t + 24, x + 3, t + 23, prec);
    arb_mul(t + 25, x + 4, t + 24, prec);
    arb_sub(t + 26, params + 6, t + 25, prec);
    arb_mul(t + 27, t + 14, t + 26, prec);
    arb_div(t + 28, t + 27, t + 20, prec);
    arb_add(t + 29, t + 10, t + 28, prec);
    arb_mul(t + 30, x + 3, t + 18, prec);
    arb_mul(t + 31, t + 3, t + 30, prec);
    arb_mul(t + 32, params + 5, t + 18, prec);
    arb_sub(t + 33, t + 25, params + 6, prec);
    arb_div(t + 34, t + 33, t + 32, prec); /* omega3 */
    arb_mul(t + 35, params + 1, t + 34, prec);
    arb_mul(t + 36, x + 4, t + 35, prec);
    arb_add(t + 37, t + 31, t + 36, prec);
    arb_mul(t + 38, t + 11, params + 4, prec);
    arb_mul(t + 39, x + 3, t + 38, prec);
    arb_mul(t + 40, t + 2, t + 39, prec);
    arb_div(t + 41, t + 40, t + 32, prec);
    arb_add(t + 42, t + 37, t + 41, prec);
    arb_mul(t + 43, params + 1, x + 3, prec);
    arb_mul(t + 44, t + 34, t + 43, prec);
    arb_mul(t + 45, t + 9, t + 38, prec);
    arb_mul(t + 46, x + 4, t + 45, prec);
    arb_div(t + 47, t + 46, t + 32, prec);
    arb_add(t + 48, t + 44, t + 47, prec);
    arb_mul(t + 50, params + 3, params + 3, prec);
    arb_mul(t + 51, params + 0, t + 50, prec);
    arb_mul(t + 52, x + 2, x + 2, prec);
    arb_mul(t + 53, t + 51, t + 52, prec);
    arb_mul(t + 54, t + 2, t + 53, prec);
    arb_mul(t + 55, t + 2, t + 51, prec);
    arb_add(t + 56, params + 4, t + 55, prec); /* D */
    arb_div(t + 57, t + 54, t + 56, prec);
    arb_mul(t + 58, t + 9, params + 4, prec);
    arb_div(t + 59, t + 58, t + 56, prec);
    arb_sub(t + 60, t + 57, t + 59, prec);
    arb_mul(t + 61, x + 4, t + 43, prec);
    arb_mul(t + 62, t + 19, t + 56, prec);
    arb_mul(t + 63, t + 26, t + 61, prec);
    arb_div(t + 64, t + 63, t + 62, prec);
    arb_sub(t + 65, t + 60, t + 64, prec);
    arb_mul(t + 66, t + 3, params + 0, prec);
    arb_mul(t + 67, t + 50, t + 66, prec);
    arb_mul(t + 68, x + 0, t + 67, prec);
    arb_mul(t + 69, x + 2, t + 68, prec);
    arb_mul(t + 70, t + 2, t + 69, prec);
    arb_div(t + 71, t + 70, t + 56, prec);
    arb_mul(t + 72, x + 0, params + 4, prec);
    arb_mul(t + 73, x + 3, t + 72, prec);
    arb_div(t + 74, t + 73, t + 56, prec);
    arb_mul(t + 75, t + 3, t + 74, prec);
    arb_neg(t + 76, t + 75);
    arb_mul(t + 77, params + 5, t + 34, prec);
    arb_mul(t + 78, x + 4, t + 77, prec);
    arb_div(t + 79, t + 78, t + 56, prec);
    arb_sub(t + 80, t + 76, t + 79, prec);
    arb_mul(t + 81, t + 2, t + 24, prec);
    arb_mul(t + 82, t + 18, t + 56, prec);
    arb_div(t + 83, t + 81, t + 82, prec);
    arb_sub(t + 84, t + 80, t + 83, prec);
    arb_mul(t + 85, x + 0, t + 51, prec);
    arb_mul(t + 86, t + 52, t + 85, prec);
    arb_mul(t + 87, x + 4, t + 86, prec);
    arb_div(t + 88, t + 87, t + 56, prec);
    arb_mul(t + 89, t + 3, t + 88, prec);
    arb_mul(t + 91, params + 0, params + 2, prec);
    arb_mul(t + 92, params + 3, t + 91, prec);
    arb_mul(t + 93, x + 4, t + 92, prec);
    arb_div(t + 94, t + 93, t + 56, prec);
    arb_mul(t + 95, t + 3, t + 94, prec);
    arb_sub(t + 96, t + 89, t + 95, prec);
    arb_mul(t + 97, x + 3, params + 5, prec);
    arb_mul(t + 98, t + 34, t + 97, prec);
    arb_div(t + 99, t + 98, t + 56, prec);
    arb_sub(t + 100, t + 96, t + 99, prec);
    arb_mul(t + 101, params + 0, params + 0, prec);
    arb_mul(t + 102, t + 50, t + 50, prec);
    arb_mul(t + 103, t + 101, t + 102, prec);
    arb_mul(t + 104, x + 0, t + 103, prec);
    arb_mul(t + 105, t + 52, t + 104, prec);
    arb_mul(t + 106, x + 4, t + 2, prec);
    arb_mul(t + 107, t + 105, t + 106, prec);
    arb_mul(t + 108, t + 56, t + 56, prec);
    arb_div(t + 109, t + 107, t + 108, prec);
    arb_mul(t + 110, t + 3, t + 109, prec);
    arb_sub(t + 111, t + 100, t + 110, prec);
    arb_mul(t + 112, params + 2, t + 101, prec);
    arb_mul(t + 113, params + 3, t + 50, prec);
    arb_mul(t + 114, t + 112, t + 113, prec);
    arb_mul(t + 115, t + 106, t + 114, prec);
    arb_div(t + 116, t + 115, t + 108, prec);
    arb_mul(t + 117, t + 3, t + 116, prec);
    arb_add(t + 118, t + 111, t + 117, prec);
    arb_mul(t + 119, params + 4, t + 51, prec);
    arb_mul(t + 120, x + 0, t + 119, prec);
    arb_mul(t + 121, t + 9, t + 120, prec);
    arb_mul(t + 122, x + 4, t + 121, prec);
    arb_div(t + 123, t + 122, t + 108, prec);
    arb_mul(t + 124, t + 3, t + 123, prec);
    arb_add(t + 125, t + 118, t + 124, prec);
    arb_mul(t + 126, params + 5, t + 51, prec);
    arb_mul(t + 127, x + 3, t + 126, prec);
    arb_mul(t + 128, t + 34, t + 127, prec);
    arb_mul(t + 129, t + 2, t + 128, prec);
    arb_div(t + 130, t + 129, t + 108, prec);
    arb_mul(t + 131, t + 3, t + 130, prec);
    arb_add(t + 132, t + 125, t + 131, prec);
    arb_mul(t + 133, t + 9, t + 23, prec);
    arb_mul(t + 134, x + 4, t + 133, prec);
    arb_div(t + 135, t + 134, t + 82, prec);
    arb_sub(t + 136, t + 132, t + 135, prec);
    arb_mul(t + 137, params + 1, params + 0, prec);
    arb_mul(t + 138, params + 3, t + 137, prec);
    arb_mul(t + 139, params + 5, t + 138, prec);
    arb_mul(t + 140, x + 2, t + 139, prec);
    arb_mul(t + 141, t + 34, t + 140, prec);
    arb_mul(t + 142, x + 4, t + 141, prec);
    arb_mul(t + 143, params + 5, params + 4, prec);
    arb_mul(t + 144, t + 11, params + 0, prec);
    arb_mul(t + 145, params + 4, t + 144, prec);
    arb_mul(t + 146, t + 2, t + 145, prec);
    arb_add(t + 147, t + 143, t + 146, prec);
    arb_mul(t + 148, params + 5, params + 0, prec);
    arb_mul(t + 149, t + 19, t + 148, prec);
    arb_add(t + 150, t + 147, t + 149, prec); /* Theta */
    arb_div(t + 151, t + 142, t + 150, prec);
    arb_mul(t + 152, x + 2, x + 3, prec);
    arb_add(t + 153, t + 151, t + 152, prec);
    arb_mul(t + 154, params + 5, t + 137, prec);
    arb_mul(t + 155, x + 3, t + 154, prec);
    arb_mul(t + 157, params + 3, x + 0, prec);
    arb_add(t + 158, params + 1, t + 157, prec); /* e */
    arb_mul(t + 159, x + 2, t + 158, prec);
    arb_add(t + 160, x + 1, t + 159, prec); /* V */
    arb_mul(t + 161, t + 155, t + 160, prec);
    arb_div(t + 162, t + 161, t + 150, prec);
    arb_sub(t + 163, t + 153, t + 162, prec);
    arb_mul(t + 164, params + 3, params + 0, prec);
    arb_mul(t + 165, params + 5, t + 164, prec);
    arb_mul(t + 166, x + 2, t + 165, prec);
    arb_mul(t + 167, x + 3, t + 166, prec);
    arb_mul(t + 168, t + 18, t + 167, prec);
    arb_div(t + 169, t + 168, t + 150, prec);
    arb_sub(t + 170, t + 163, t + 169, prec);
    arb_mul(t + 171, params + 1, t + 101, prec);
    arb_mul(t + 172, params + 5, params + 5, prec);
    arb_mul(t + 173, t + 171, t + 172, prec);
    arb_mul(t + 174, x + 3, t + 173, prec);
    arb_mul(t + 175, t + 19, t + 174, prec);
    arb_mul(t + 176, t + 150, t + 150, prec);
    arb_mul(t + 177, t + 160, t + 175, prec);
    arb_div(t + 178, t + 177, t + 176, prec);
    arb_mul(t + 179, t + 3, t + 178, prec);
    arb_add(t + 180, t + 170, t + 179, prec);
    arb_mul(t + 181, params + 5, t + 172, prec);
    arb_mul(t + 182, t + 137, t + 181, prec);
    arb_mul(t + 183, x + 2, t + 182, prec);
    arb_mul(t + 184, t + 34, t + 183, prec);
    arb_mul(t + 185, x + 4, t + 184, prec);
    arb_mul(t + 186, t + 18, t + 185, prec);
    arb_div(t + 187, t + 186, t + 176, prec);
    arb_mul(t + 188, t + 3, t + 187, prec);
    arb_sub(t + 189, t + 180, t + 188, prec);
    arb_mul(t + 190, t + 11, t + 101, prec);
    arb_mul(t + 191, t + 172, t + 190, prec);
    arb_mul(t + 192, x + 2, t + 191, prec);
    arb_mul(t + 193, t + 34, t + 192, prec);
    arb_mul(t + 194, x + 4, t + 193, prec);
    arb_mul(t + 195, t + 18, t + 194, prec);
    arb_mul(t + 196, t + 158, t + 195, prec);
    arb_div(t + 197, t + 196, t + 176, prec);
    arb_mul(t + 198, t + 3, t + 197, prec);
    arb_sub(t + 199, t + 189, t + 198, prec);
    arb_mul(t + 200, params + 1, params + 5, prec);
    arb_mul(t + 201, x + 2, t + 200, prec);
    arb_mul(t + 202, x + 4, t + 201, prec);
    arb_mul(t + 203, t + 19, t + 150, prec);
    arb_mul(t + 204, t + 26, t + 202, prec);
    arb_div(t + 205, t + 204, t + 203, prec);
    arb_add(t + 206, t + 199, t + 205, prec);
    arb_mul(t + 207, x + 2, t + 144, prec);
    arb_mul(t + 208, x + 4, t + 207, prec);
    arb_mul(t + 209, t + 158, t + 208, prec);
    arb_mul(t + 210, t + 26, t + 209, prec);
    arb_div(t + 211, t + 210, t + 203, prec);
    arb_add(t + 212, t + 206, t + 211, prec);
    arb_mul(t + 213, x + 3, t + 148, prec);
    arb_mul(t + 214, t + 18, t + 213, prec);
    arb_div(t + 215, t + 214, t + 150, prec);
    arb_neg(t + 216, t + 215);
    arb_mul(t + 217, x + 3, x + 0, prec);
    arb_mul(t + 218, t + 158, t + 214, prec);
    arb_div(t + 219, t + 218, t + 150, prec);
    arb_sub(t + 220, t + 217, t + 219, prec);
    arb_mul(t + 221, t + 34, t + 172, prec);
    arb_mul(t + 222, x + 4, t + 221, prec);
    arb_div(t + 223, t + 222, t + 150, prec);
    arb_add(t + 224, t + 220, t + 223, prec);
    arb_mul(t + 225, t + 34, t + 154, prec);
    arb_mul(t + 226, x + 4, t + 225, prec);
    arb_mul(t + 227, t + 158, t + 226, prec);
    arb_div(t + 228, t + 227, t + 150, prec);
    arb_add(t + 229, t + 224, t + 228, prec);
    arb_mul(t + 230, x + 2, x + 0, prec);
    arb_mul(t + 231, t + 18, t + 148, prec);
    arb_mul(t + 232, t + 160, t + 231, prec);
    arb_div(t + 233, t + 232, t + 150, prec);
    arb_sub(t + 234, t + 230, t + 233, prec);
    arb_mul(t + 235, params + 5, t + 23, prec);
    arb_mul(t + 236, x + 2, t + 235, prec);
    arb_mul(t + 237, t + 2, t + 236, prec);
    arb_mul(t + 238, t + 18, t + 150, prec);
    arb_div(t + 239, t + 237, t + 238, prec);
    arb_add(t + 240, t + 234, t + 239, prec);
    arb_mul(t + 241, x + 2, t + 145, prec);
    arb_mul(t + 242, t + 2, t + 241, prec);
    arb_mul(t + 243, t + 158, t + 242, prec);
    arb_div(t + 244, t + 243, t + 238, prec);
    arb_add(t + 245, t + 240, t + 244, prec);
    arb_mul(t + 246, x + 2, t + 172, prec);
    arb_mul(t + 247, t + 34, t + 246, prec);
    arb_div(t + 248, t + 247, t + 150, prec);
    arb_mul(t + 249, x + 2, t + 154, prec);
    arb_mul(t + 250, t + 34, t + 249, prec);
    arb_mul(t + 251, t + 158, t + 250, prec);
    arb_div(t + 252, t + 251, t + 150, prec);
    arb_add(t + 253, t + 248, t + 252, prec);
    arb_mul(t + 254, params + 4, t + 190, prec);
    arb_mul(t + 255, params + 5, t + 254, prec);
    arb_mul(t + 256, x + 3, t + 255, prec);
    arb_mul(t + 257, x + 4, t + 256, prec);
    arb_mul(t + 258, t + 18, t + 257, prec);
    arb_mul(t + 259, t + 160, t + 258, prec);
    arb_div(t + 260, t + 259, t + 176, prec);
    arb_mul(t + 261, t + 3, t + 260, prec);
    arb_add(t + 262, t + 253, t + 261, prec);
    arb_mul(t + 263, t + 145, t + 172, prec);
    arb_mul(t + 264, x + 2, t + 263, prec);
    arb_mul(t + 265, t + 34, t + 264, prec);
    arb_mul(t + 266, t + 2, t + 265, prec);
    arb_div(t + 267, t + 266, t + 176, prec);
    arb_mul(t + 268, t + 3, t + 267, prec);
    arb_sub(t + 269, t + 262, t + 268, prec);
    arb_mul(t + 270, params + 1, t + 11, prec);
    arb_mul(t + 271, t + 101, t + 270, prec);
    arb_mul(t + 272, params + 4, t + 271, prec);
    arb_mul(t + 273, params + 5, t + 272, prec);
    arb_mul(t + 274, x + 2, t + 273, prec);
    arb_mul(t + 275, t + 34, t + 274, prec);
    arb_mul(t + 276, t + 2, t + 275, prec);
    arb_mul(t + 277, t + 158, t + 276, prec);
    arb_div(t + 278, t + 277, t + 176, prec);
    arb_mul(t + 279, t + 3, t + 278, prec);
    arb_sub(t + 280, t + 269, t + 279, prec);
    arb_mul(t + 281, x + 3, t + 236, prec);
    arb_mul(t + 282, x + 4, t + 281, prec);
    arb_div(t + 283, t + 282, t + 238, prec);
    arb_add(t + 284, t + 280, t + 283, prec);
    arb_mul(t + 285, x + 3, t + 241, prec);
    arb_mul(t + 286, x + 4, t + 285, prec);
    arb_mul(t + 287, t + 158, t + 286, prec);
    arb_div(t + 288, t + 287, t + 238, prec);
    arb_add(t + 289, t + 284, t + 288, prec);
    arb_mul(t + 290, x + 4, x + 2, prec);
    arb_neg(t + 291, t + 290);
    arb_mul(t + 292, x + 4, x + 0, prec);
    arb_neg(t + 293, t + 292);
    arb_neg(t + 294, t + 230);
    arb_set(out + 0, t + 0);
    arb_set(out + 1, t + 0);
    arb_set(out + 2, t + 2);
    arb_set(out + 3, t + 0);
    arb_set(out + 4, t + 6);
    arb_set(out + 5, t + 29);
    arb_set(out + 6, t + 0);
    arb_set(out + 7, t + 0);
    arb_set(out + 8, t + 42);
    arb_set(out + 9, t + 48);
    arb_set(out + 10, t + 65);
    arb_set(out + 11, t + 0);
    arb_set(out + 12, t + 71);
    arb_set(out + 13, t + 84);
    arb_set(out + 14, t + 136);
    arb_set(out + 15, t + 212);
    arb_set(out + 16, t + 216);
    arb_set(out + 17, t + 229);
    arb_set(out + 18, t + 245);
    arb_set(out + 19, t + 289);
    arb_set(out + 20, t + 291);
    arb_set(out + 21, t + 0);
    arb_set(out + 22, t + 293);
    arb_set(out + 23, t + 0);
    arb_set(out + 24, t + 294);
    _arb_vec_clear(t, 295);
}

static void general_in_regular_on_level_omega3_divergence(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(52);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 3, params + 3, prec);
    arb_mul(t + 3, params + 0, t + 2, prec);
    arb_mul(t + 5, t + 3, x + 0, prec);
    arb_mul(t + 7, t + 5, x + 2, prec);
    arb_mul(t + 9, x + 4, x + 4, prec);
    arb_mul(t + 10, t + 7, t + 9, prec);
    arb_mul(t + 12, t + 3, t + 9, prec);
    arb_add(t + 13, params + 4, t + 12, prec); /* D */
    arb_div(t + 14, t + 10, t + 13, prec);
    arb_set_si(t + 15, 2);
    arb_mul(t + 16, t + 14, t + 15, prec);
    arb_mul(t + 18, params + 0, params + 5, prec);
    arb_mul(t + 20, x + 0, params + 1, prec);
    arb_add(t + 21, params + 3, t + 20, prec); /* b */
    arb_mul(t + 22, t + 18, t + 21, prec);
    arb_mul(t + 23, params + 4, params + 5, prec);
    arb_mul(t + 24, params + 1, params + 1, prec);
    arb_mul(t + 25, params + 0, t + 24, prec);
    arb_mul(t + 26, params + 4, t + 25, prec);
    arb_mul(t + 27, t + 9, t + 26, prec);
    arb_add(t + 28, t + 23, t + 27, prec);
    arb_mul(t + 29, t + 21, t + 21, prec);
    arb_mul(t + 30, t + 18, t + 29, prec);
    arb_add(t + 31, t + 28, t + 30, prec); /* Theta */
    arb_mul(t + 33, params + 3, x + 0, prec);
    arb_add(t + 34, params + 1, t + 33, prec); /* e */
    arb_mul(t + 35, x + 2, t + 34, prec);
    arb_add(t + 36, x + 1, t + 35, prec); /* V */
    arb_mul(t + 37, t + 22, t + 36, prec);
    arb_div(t + 38, t + 37, t + 31, prec);
    arb_sub(t + 39, t + 16, t + 38, prec);
    arb_mul(t + 40, params + 4, params + 1, prec);
    arb_mul(t + 41, params + 5, t + 40, prec);
    arb_mul(t + 42, x + 2, t + 41, prec);
    arb_mul(t + 43, t + 9, t + 42, prec);
    arb_mul(t + 44, t + 21, t + 31, prec);
    arb_div(t + 45, t + 43, t + 44, prec);
    arb_add(t + 46, t + 39, t + 45, prec);
    arb_mul(t + 47, x + 2, t + 26, prec);
    arb_mul(t + 48, t + 9, t + 47, prec);
    arb_mul(t + 49, t + 34, t + 48, prec);
    arb_div(t + 50, t + 49, t + 44, prec);
    arb_add(t + 51, t + 46, t + 50, prec);
    arb_set(out + 0, t + 51);
    _arb_vec_clear(t, 52);
}

static const char *const general_in_regular_on_level_omega3_integral[] = { "E", "F0", "F_linear", "E1", "E2" };

static void general_in_regular_on_level_omega3_integral_values(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(76);
    (void)x;
    (void)params;
    (void)prec;
    arb_mul(t + 2, params + 0, params + 2, prec);
    arb_mul(t + 4, t + 2, params + 3, prec);
    arb_mul(t + 6, t + 4, x + 0, prec);
    arb_mul(t + 8, x + 1, x + 1, prec);
    arb_mul(t + 9, params + 0, t + 8, prec);
    jlt_ball_rational(t + 10, "1/2", prec);
    arb_mul(t + 11, t + 9, t + 10, prec);
    arb_add(t + 12, t + 6, t + 11, prec);
    arb_mul(t + 14, x + 2, x + 2, prec);
    arb_mul(t + 16, params + 3, params + 3, prec);
    arb_mul(t + 17, params + 0, t + 16, prec);
    arb_mul(t + 19, x + 4, x + 4, prec);
    arb_mul(t + 20, t + 17, t + 19, prec);
    arb_add(t + 21, params + 4, t + 20, prec); /* D */
    arb_mul(t + 22, t + 14, t + 21, prec);
    arb_mul(t + 23, t + 10, t + 22, prec);
    arb_add(t + 24, t + 12, t + 23, prec);
    arb_mul(t + 26, x + 3, x + 3, prec);
    arb_mul(t + 27, params + 4, t + 26, prec);
    arb_mul(t + 28, t + 10, t + 27, prec);
    arb_add(t + 29, t + 24, t + 28, prec);
    arb_mul(t + 32, x + 0, params + 1, prec);
    arb_add(t + 33, params + 3, t + 32, prec); /* b */
    arb_mul(t + 34, params + 5, t + 33, prec);
    arb_mul(t + 36, params + 4, params + 1, prec);
    arb_mul(t + 37, x + 3, t + 36, prec);
    arb_mul(t + 38, x + 4, t + 37, prec);
    arb_sub(t + 39, t + 38, params + 6, prec);
    arb_div(t + 40, t + 39, t + 34, prec); /* omega3 */
    arb_mul(t + 41, t + 40, t + 40, prec);
    arb_mul(t + 42, params + 5, t + 41, prec);
    arb_mul(t + 43, t + 10, t + 42, prec);
    arb_add(t + 44, t + 29, t + 43, prec);
    arb_mul(t + 45, x + 3, t + 33, prec);
    arb_mul(t + 46, params + 1, t + 40, prec);
    arb_mul(t + 47, x + 4, t + 46, prec);
    arb_add(t + 48, t + 45, t + 47, prec); /* v_tau */
    arb_mul(t + 49, t + 48, t + 48, prec);
    arb_mul(t + 50, params + 0, t + 49, prec);
    arb_mul(t + 51, t + 10, t + 50, prec);
    arb_add(t + 52, t + 44, t + 51, prec); /* energy */
    arb_mul(t + 53, params + 4, params + 4, prec);
    arb_mul(t + 54, params + 0, t + 53, prec);
    arb_mul(t + 55, x + 2, params + 1, prec);
    arb_add(t + 56, x + 1, t + 55, prec);
    arb_mul(t + 57, t + 56, t + 56, prec);
    arb_mul(t + 58, t + 54, t + 57, prec);
    arb_mul(t + 59, params + 4, params + 5, prec);
    arb_mul(t + 60, params + 1, params + 1, prec);
    arb_mul(t + 61, params + 0, t + 60, prec);
    arb_mul(t + 62, params + 4, t + 61, prec);
    arb_mul(t + 63, t + 19, t + 62, prec);
    arb_add(t + 64, t + 59, t + 63, prec);
    arb_mul(t + 65, params + 0, params + 5, prec);
    arb_mul(t + 66, t + 33, t + 33, prec);
    arb_mul(t + 67, t + 65, t + 66, prec);
    arb_add(t + 68, t + 64, t + 67, prec); /* Theta */
    arb_mul(t + 69, t + 41, t + 68, prec);
    arb_sub(t + 70, params + 4, params + 5, prec);
    arb_mul(t + 71, t + 69, t + 70, prec);
    arb_add(t + 72, t + 58, t + 71, prec);
    arb_add(t + 73, t + 11, t + 51, prec);
    arb_add(t + 74, t + 6, t + 23, prec);
    arb_add(t + 75, t + 28, t + 74, prec);
    arb_set(out + 0, t + 52);
    arb_set(out + 1, t + 72);
    arb_set(out + 2, t + 56);
    arb_set(out + 3, t + 73);
    arb_set(out + 4, t + 75);
    _arb_vec_clear(t, 76);
}

static void general_in_regular_on_level_omega3_integral_gradients(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec)
{
    arb_ptr t = _arb_vec_init(121);
    (void)x;
    (void)params;
    (void)prec;
    arb_set_si(t + 0, 0);
    arb_set_si(t + 1, 1);
    arb_mul(t + 4, params + 0, params + 2, prec);
    arb_mul(t + 6, t + 4, params + 3, prec);
    arb_mul(t + 10, params + 1, x + 0, prec);
    arb_add(t + 11, params + 3, t + 10, prec); /* b */
    arb_mul(t + 12, x + 3, t + 11, prec);
    arb_mul(t + 14, t + 11, params + 5, prec);
    arb_mul(t + 17, params + 1, params + 4, prec);
    arb_mul(t + 18, x + 3, t + 17, prec);
    arb_mul(t + 20, t + 18, x + 4, prec);
    arb_sub(t + 21, params + 6, t + 20, prec);
    arb_sub(t + 22, t + 20, params + 6, prec);
    arb_div(t + 23, t + 22, t + 14, prec); /* omega3 */
    arb_mul(t + 24, params + 1, t + 23, prec);
    arb_mul(t + 25, x + 4, t + 24, prec);
    arb_add(t + 26, t + 12, t + 25, prec); /* v_tau */
    arb_mul(t + 27, params + 0, t + 26, prec);
    arb_mul(t + 28, x + 3, params + 1, prec);
    arb_mul(t + 29, params + 1, params + 1, prec);
    arb_mul(t + 30, x + 4, t + 29, prec);
    arb_mul(t + 31, t + 11, t + 11, prec);
    arb_mul(t + 32, params + 5, t + 31, prec);
    arb_mul(t + 33, t + 21, t + 30, prec);
    arb_div(t + 34, t + 33, t + 32, prec);
    arb_add(t + 35, t + 28, t + 34, prec); /* d(v_tau)/d(gamma3) */
    arb_mul(t + 36, t + 27, t + 35, prec);
    arb_add(t + 37, t + 6, t + 36, prec);
    arb_mul(t + 38, t + 21, t + 24, prec);
    arb_div(t + 39, t + 38, t + 31, prec);
    arb_add(t + 40, t + 37, t + 39, prec); /* d(energy)/d(gamma3) */
    arb_mul(t + 42, params + 0, x + 1, prec);
    arb_mul(t + 44, params + 3, params + 3, prec);
    arb_mul(t + 45, params + 0, t + 44, prec);
    arb_mul(t + 46, x + 4, x + 4, prec);
    arb_mul(t + 47, t + 45, t + 46, prec);
    arb_add(t + 48, params + 4, t + 47, prec); /* D */
    arb_mul(t + 49, x + 2, t + 48, prec);
    arb_mul(t + 50, x + 3, params + 4, prec);
    arb_mul(t + 51, params + 4, t + 29, prec);
    arb_mul(t + 52, t + 46, t + 51, prec);
    arb_div(t + 53, t + 52, t + 14, prec);
    arb_add(t + 54, t + 11, t + 53, prec); /* d(v_tau)/d(omega_n) */
    arb_mul(t + 55, t + 27, t + 54, prec);
    arb_add(t + 56, t + 50, t + 55, prec);
    arb_mul(t + 57, t + 17, t + 23, prec);
    arb_mul(t + 58, x + 4, t + 57, prec);
    arb_div(t + 59, t + 58, t + 11, prec);
    arb_add(t + 60, t + 56, t + 59, prec); /* d(energy)/d(omega_n) */
    arb_mul(t + 61, x + 2, x + 2, prec);
    arb_mul(t + 62, t + 45, t + 61, prec);
    arb_mul(t + 63, x + 4, t + 62, prec);
    arb_mul(t + 64, x + 3, t + 51, prec);
    arb_mul(t + 65, x + 4, t + 64, prec);
    arb_div(t + 66, t + 65, t + 14, prec);
    arb_add(t + 67, t + 24, t + 66, prec); /* d(v_tau)/d(s) */
    arb_mul(t + 68, t + 27, t + 67, prec);
    arb_add(t + 69, t + 63, t + 68, prec);
    arb_mul(t + 70, t + 18, t + 23, prec);
    arb_div(t + 71, t + 70, t + 11, prec);
    arb_add(t + 72, t + 69, t + 71, prec); /* d(energy)/d(s) */
    arb_mul(t + 73, params + 0, params + 1, prec);
    arb_mul(t + 74, params + 5, t + 73, prec);
    arb_mul(t + 75, t + 23, t + 23, prec);
    arb_mul(t + 76, t + 74, t + 75, prec);
    arb_mul(t + 77, t + 11, t + 76, prec);
    arb_sub(t + 78, params + 4, params + 5, prec);
    arb_mul(t + 79, t + 77, t + 78, prec);
    arb_set_si(t + 80, 2);
    arb_mul(t + 81, t + 79, t + 80, prec);
    arb_mul(t + 82, params + 5, params + 4, prec);
    arb_mul(t + 83, params + 0, t + 29, prec);
    arb_mul(t + 84, params + 4, t + 83, prec);
    arb_mul(t + 85, t + 46, t + 84, prec);
    arb_add(t + 86, t + 82, t + 85, prec);
    arb_mul(t + 87, params + 0, params + 5, prec);
    arb_mul(t + 88, t + 31, t + 87, prec);
    arb_add(t + 89, t + 86, t + 88, prec); /* Theta */
    arb_mul(t + 90, t + 24, t + 89, prec);
    arb_mul(t + 91, t + 78, t + 90, prec);
    arb_mul(t + 92, t + 21, t + 91, prec);
    arb_div(t + 93, t + 92, t + 32, prec);
    arb_mul(t + 94, t + 80, t + 93, prec);
    arb_add(t + 95, t + 81, t + 94, prec);
    arb_mul(t + 96, params + 0, t + 80, prec);
    arb_mul(t + 97, params + 4, params + 4, prec);
    arb_mul(t + 98, t + 96, t + 97, prec);
    arb_mul(t + 99, params + 1, x + 2, prec);
    arb_add(t + 100, x + 1, t + 99, prec);
    arb_mul(t + 101, t + 98, t + 100, prec);
    arb_mul(t + 102, params + 1, t + 96, prec);
    arb_mul(t + 103, t + 97, t + 102, prec);
    arb_mul(t + 104, t + 100, t + 103, prec);
    arb_mul(t + 105, params + 1, t + 80, prec);
    arb_mul(t + 106, params + 4, t + 105, prec);
    arb_mul(t + 107, t + 23, t + 106, prec);
    arb_mul(t + 108, x + 4, t + 107, prec);
    arb_mul(t + 109, t + 89, t + 108, prec);
    arb_mul(t + 110, t + 78, t + 109, prec);
    arb_div(t + 111, t + 110, t + 14, prec);
    arb_mul(t + 112, t + 75, t + 84, prec);
    arb_mul(t + 113, x + 4, t + 112, prec);
    arb_mul(t + 114, t + 78, t + 113, prec);
    arb_mul(t + 115, t + 80, t + 114, prec);
    arb_mul(t + 116, t + 70, t + 89, prec);
    arb_mul(t + 117, t + 78, t + 116, prec);
    arb_div(t + 118, t + 117, t + 14, prec);
    arb_mul(t + 119, t + 80, t + 118, prec);
    arb_add(t + 120, t + 115, t + 119, prec);
    arb_set(out + 0, t + 40);
    arb_set(out + 1, t + 42);
    arb_set(out + 2, t + 49);
    arb_set(out + 3, t + 60);
    arb_set(out + 4, t + 72);
    arb_set(out + 5, t + 95);
    arb_set(out + 6, t + 101);
    arb_set(out + 7, t + 104);
    arb_set(out + 8, t + 111);
    arb_set(out + 9, t + 120);
    arb_set(out + 10, t + 0);
    arb_set(out + 11, t + 1);
    arb_set(out + 12, params + 1);
    arb_set(out + 13, t + 0);
    arb_set(out + 14, t + 0);
    arb_set(out + 15, t + 36);
    arb_set(out + 16, t + 42);
    arb_set(out + 17, t + 0);
    arb_set(out + 18, t + 55);
    arb_set(out + 19, t + 68);
    arb_set(out + 20, t + 6);
    arb_set(out + 21, t + 0);
    arb_set(out + 22, t + 49);
    arb_set(out + 23, t + 50);
    arb_set(out + 24, t + 63);
    _arb_vec_clear(t, 121);
}

extern const jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega3;
const jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega3 = {
    .model = "spherical_top", .time = "regular", .elimination = "level_omega3",
    .state_count = 5, .param_count = 7,
    .rhs = general_in_regular_on_level_omega3_rhs,
    .jacobian = general_in_regular_on_level_omega3_jacobian,
    .divergence = general_in_regular_on_level_omega3_divergence,
    .integral_count = 5,
    .integral = general_in_regular_on_level_omega3_integral,
    .integral_values = general_in_regular_on_level_omega3_integral_values,
    .integral_gradients = general_in_regular_on_level_omega3_integral_gradients,
};

