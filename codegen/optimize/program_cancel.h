/** Finds the operations of a program that may lose digits: additions whose operands carry rounding errors and can nearly cancel
 *  somewhere in the domain, and functions of rounded arguments. */
#ifndef TTC_PROGRAM_CANCEL_H
#define TTC_PROGRAM_CANCEL_H

#include "fields/prepared.h"
#include "optimize/program.h"

typedef enum {
    TTC_KEEPS_DIGITS,
    TTC_CANCELS,          /* an addition whose terms can nearly cancel */
    TTC_ROUNDED_ARGUMENT  /* a cosine, sine, exponential or logarithm of a rounded argument, such as a sine near its zeros */
} ttc_loss;

/* Where bounds keep |a| + |b| below this multiple of |a + b|, the sum loses two bits at most, which counts as no loss. */
enum { TTC_HARMLESS_CANCELLATION = 4 };

/** Set losses, shape (size of the program,). An addition keeps its digits if what is known of parameters, states and roots gives
 *  both terms one sign; if bounds keep the sum away from zero; or if both terms are exact (states, parameters, their products
 *  with powers of two). prepared: the expressions that the program's parameters stand for; NULL: they are the raw parameters.
 *  Returns false when memory is out. */
bool ttc_program_losses(ttc_loss *losses, const ttc_program *program, ttc_field *field, const ttc_prepared *prepared);

/* Returns true if some sum in an expression as it stands, or in the definitions that it uses, can lose digits; also when memory
 * is out. */
bool ttc_expression_cancels(ttc_field *field, ttc_id id);

#endif
