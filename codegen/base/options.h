/** The options of a command, read so that none is overridden in silence. */
#ifndef TTC_OPTIONS_H
#define TTC_OPTIONS_H

#include <argp.h>

/** A flag of an argp_option that may be given more than once, each adding to those before. */
#define TTC_OPTIONS_REPEATED 0x10000

/** Parse as argp_parse does, with its defaults. Before that, two errors are reported and end the program with
 *  argp_err_exit_status: an option with a value that is given twice, unless it is marked TTC_OPTIONS_REPEATED; and an unknown
 *  option whose name resembles a known one. */
void ttc_options_parse(const struct argp *parser, int argc, char **argv, void *input);

#endif
