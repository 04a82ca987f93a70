/** Where a program's additions may lose digits: their operands carry rounding errors, and can be nearly opposite numbers
 *  somewhere in the domain. */
#ifndef TTC_PROGRAM_CANCEL_H
#define TTC_PROGRAM_CANCEL_H

#include "fields/prepared.h"
#include "optimize/program.h"

typedef enum {
    TTC_KEEPS_DIGITS,
    TTC_CANCELS,          /* an addition whose terms can nearly cancel */
    TTC_ROUNDED_ARGUMENT  /* a cosine or sine whose argument is rounded: digits are lost near its zeros */
} ttc_loss;

/* Terms of opposite signs whose bounds keep |a| + |b| below this many times |a + b| lose two bits at most: no loss. */
enum { TTC_HARMLESS_CANCELLATION = 4 };

/** losses, shape (size of the program,). An addition keeps digits where its terms have one sign, from what is known of
 *  parameters, states and roots; where bounds keep the sum away from zero; and where both are exact: states, parameters,
 *  their products with powers of two. prepared: what parameters after the raw ones stand for; NULL: there are none.
 *  False when memory is out. */
bool ttc_program_losses(ttc_loss *losses, const ttc_program *program, ttc_field *field, const ttc_prepared *prepared);

/* The same for an expression as it stands: true when some sum in it, definitions included, can lose digits. */
bool ttc_expression_cancels(ttc_field *field, ttc_id id);

#endif
