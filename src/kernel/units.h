/** Units of mass, length and time in which the numbers of a problem are of the order of 1.
 *
 *  Integrators measure errors against max(|x|, 1), or less where an orbit starts far below 1, and choose first steps for rates of
 *  the order of 1; both make sense only in such units. The units are powers of two of kg, m and s, so conversion rounds nothing,
 *  and two problems that differ only by such units give the same bits. */
#ifndef JLT_KERNEL_UNITS_H
#define JLT_KERNEL_UNITS_H

#include "kernel_abi.h"

#include <stdbool.h>

/** The units are 2^mass kg, 2^length m and 2^time s. All zero: kg, m and s. */
typedef struct {
    int mass, length, time;
} jlt_units;

/** Whether these are the table's own units, in which nothing is scaled. */
bool jlt_units_is_table(const jlt_units *units);

/** The exponent e such that a compound unit formed from these units is 2^e times that from kg, m and s. `unit` reads "kg*m^2/s^2",
 *  "kg m^2", "1/(m*s^2)", "rad/s", "1" or "". Any other name, such as rad, counts as 1. */
int jlt_units_exponent(const jlt_units *units, const char *unit);

/** Whether the table counts time in s: a parameter or state has a unit in which s remains. */
bool jlt_units_has_time(const jlt_descriptor *d);

/** Convert values, shape (count,), whose units are in of[i].unit: jlt_units_count from the table's units to these,
 *  jlt_units_restore back. out and in may be the same array. Exact, unless a value over- or underflows. */
void jlt_units_count(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units);
void jlt_units_restore(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units);

/** Set the units of mass and length. The unit of mass makes the first parameter in kg that the table declares positive lie in [1,
 *  2), unless its power of two is more than 64 times that of the largest state in kg, since it may then have nothing to do with
 *  the extent of the motion: then, or if there is none, that state lies in [1, 2). It is kg if there is neither. The unit of length
 *  is set likewise from quantities in m. params, of: shape (count,); x, states: shape (n,), n may be 0; in the table's units. */
void jlt_units_of_sizes(jlt_units *units, const double *params, const jlt_quantity *of, unsigned count, const double *x,
                        const jlt_quantity *states, unsigned n);

/** The largest rate [1/s] that the sizes of the states suggest: a state whose unit contains s^p, p < 0, gives |x|^(-1/p) in these
 *  units of mass and length, so a velocity gives its size, an acceleration the square root of it. x, shape (count,), in the
 *  table's units; derivatives: how often x is differentiated by time, 1 for the field. Returns 0 if no state has such a unit. */
double jlt_units_rate(const jlt_units *units, const double *x, const jlt_quantity *of, unsigned count, int derivatives);

/** Set the unit of time so that half the square of this rate lies in [1, 4); does nothing if the rate is 0 or not finite. */
void jlt_units_of_rate(jlt_units *units, double rate);

#endif
