/** Keeps GSL from ending the program: errors are reported by return codes only. GSL's error handler is shared by all threads. */
#ifndef JLT_EXT_GSL_H
#define JLT_EXT_GSL_H

/** Switch GSL's error handler off for good. Call it before any other function of GSL, any number of times, from any thread. */
void jlt_gsl_quiet(void);

#endif
