/** Doubles as decimal text that is as short as reads back bit for bit, with a point in any locale. */
#ifndef JLT_CORE_DIGITS_H
#define JLT_CORE_DIGITS_H

enum { JLT_DIGITS_SIZE = 32 };

/** Fifteen digits, sixteen or seventeen, as printf's %g writes them; so are NaN and infinities. Cost: twice that of seventeen
 *  by printf. text: shape (JLT_DIGITS_SIZE,). */
void jlt_digits_shortest(char *text, double value);

#endif
