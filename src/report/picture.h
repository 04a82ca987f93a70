/** Draws pictures by gnuplot. */
#ifndef JLT_REPORT_PICTURE_H
#define JLT_REPORT_PICTURE_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

/* True when the extension of the path is one that jlt_picture_draw knows: .svg, .png, .pdf. */
bool jlt_picture_known(const char *path);

/** A whole script: `script`, gnuplot commands without terminal and output, with data in `$NAME << EOD` blocks, behind the
 *  terminal that the extension of `path` asks for. For the caller to free(). Errors: ARG (another extension), NOMEM. */
JLT_CHECKED jlt_status jlt_picture_script(char **whole, size_t *length, const char *path, const char *script);

/** The picture that gnuplot draws by a whole script; for the caller to free().
 *  Errors: UNSUPPORTED (no gnuplot to be found), IO (gnuplot failed, and said why on standard error), NOMEM.
 *  Cost: a process, about 0.1 s. */
JLT_CHECKED jlt_status jlt_picture_draw(char **picture, size_t *size, const char *whole, size_t length);

#endif
