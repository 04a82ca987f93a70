/** Units of measurement in which a problem's numbers are of the order of 1.
 *
 *  Errors are controlled against max(|x|, 1), and steps begin at lengths that suit rates of the order of 1: both mean what they say
 *  when mass, length and time are counted in units of the problem. These are powers of two, so that changing over to them and back
 *  rounds nothing, and kernels, whose terms have one dimension each, give the same bits for problems that differ by such units. */
#ifndef JLT_KERNEL_UNITS_H
#define JLT_KERNEL_UNITS_H

#include "kernel_abi.h"

/** Binary exponents of the units, in kg, m and s. Zero means those themselves. */
typedef struct {
    int mass, length, time;
} jlt_units;

/** Binary exponent of a compound unit, written as in tables: "kg*m^2/s^2", "kg m^2", "rad/s", "1", "". Names other than kg, m and s
 *  are numbers. */
int jlt_units_exponent(const jlt_units *units, const char *unit);

/** Values (count,) of quantities, from those of the table to numbers of these units, and back. out may be in. */
void jlt_units_count(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units);
void jlt_units_restore(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units);

#endif
