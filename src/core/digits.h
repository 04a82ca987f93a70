/** Writes a double as the shortest decimal text that reads back bit for bit, with a decimal point in any locale. */
#ifndef JLT_CORE_DIGITS_H
#define JLT_CORE_DIGITS_H

enum { JLT_DIGITS_SIZE = 32 };

/** Write `value` with 15, 16 or 17 digits, the fewest that read back, in the form of printf's %g; NaN and infinities as printf
 *  does.
 *  Out: text, shape (JLT_DIGITS_SIZE,), ends with a null byte. Cost: twice a printf of 17 digits. */
void jlt_digits_shortest(char *text, double value);

#endif
