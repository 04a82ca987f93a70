/** Signals that end the program reach its main thread. */
#ifndef JLT_CLI_SIGNALS_H
#define JLT_CLI_SIGNALS_H

/** Have INT, TERM and HUP handled by the main thread. The libraries below start threads of their own (OpenBLAS does at load
 *  time); a signal that the main thread holds back while it replaces a file would otherwise be delivered to one of
 *  those, and end the program at once. Call it once, from the main thread. */
void jlt_signals_to_main(void);

#endif
