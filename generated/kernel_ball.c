/* Edited in codegen/runtime/; ttc writes copies. */
#include "kernel_ball.h"

void jlt_ball_rational(arb_t out, const char *digits, slong prec)
{
    fmpq_t q;
    fmpq_init(q);
    if (fmpq_set_str(q, digits, 10) == 0) arb_set_fmpq(out, q, prec);
    else arb_indeterminate(out);
    fmpq_clear(q);
}
