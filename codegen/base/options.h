/** The options of a command, read so that none is overridden in silence. */
#ifndef TTC_OPTIONS_H
#define TTC_OPTIONS_H

#include <argp.h>

/** A flag of an argp_option that may be given more than once, each adding to those before. */
#define TTC_OPTIONS_REPEATED 0x10000

/** Parse as argp_parse does, with its defaults, once it is sure that no option with a value is given twice, but those marked
 *  TTC_OPTIONS_REPEATED. Otherwise prints which, with both values, and ends the program with argp_err_exit_status; so it does at an
 *  unknown option that resembles one. */
void ttc_options_parse(const struct argp *parser, int argc, char **argv, void *input);

#endif
