/** Finds operations of a program that may lose digits: additions of rounded numbers that can nearly cancel in the domain, and
 *  functions of rounded arguments. */
#ifndef TTC_PROGRAM_CANCEL_H
#define TTC_PROGRAM_CANCEL_H

#include "fields/prepared.h"
#include "optimize/program.h"

typedef enum {
    TTC_KEEPS_DIGITS,
    TTC_CANCELS,          /* an addition whose terms can nearly cancel */
    TTC_ROUNDED_ARGUMENT  /* a cosine, sine, exponential or logarithm of a rounded number */
} ttc_loss;

/* Where bounds keep |a| + |b| below this many times |a + b|, two bits are lost at most, which counts as none. */
enum { TTC_HARMLESS_CANCELLATION = 4 };

/** losses: shape (size of the program,). An addition keeps digits if both terms have one sign, from what is known of parameters,
 *  states and roots; if bounds keep the sum away from zero; or if both terms are exact: states, parameters, their products with
 *  powers of two. prepared: what the program's parameters are; NULL: raw parameters.
 *  Returns false when memory is out. */
bool ttc_program_losses(ttc_loss *losses, const ttc_program *program, ttc_field *field, const ttc_prepared *prepared);

/* Whether the value of an expression in parameters and states as it stands may be rounded. */
bool ttc_expression_is_rounded(ttc_field *field, ttc_id id);

/* Whether some sum in an expression as it stands, definitions included, can lose digits; true when memory is out. */
bool ttc_expression_cancels(ttc_field *field, ttc_id id);

#endif
