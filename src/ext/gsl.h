/** GSL reports by return codes: its error handler, which ends the program, is one for all threads. */
#ifndef JLT_EXT_GSL_H
#define JLT_EXT_GSL_H

/** Switch GSL's error handler off, the first time it is called, for good; thread-safe. Call it before any other of GSL. */
void jlt_gsl_quiet(void);

#endif
