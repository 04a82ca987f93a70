/** Pictures by gnuplot. */
#ifndef JLT_REPORT_PICTURE_H
#define JLT_REPORT_PICTURE_H

#include "core/status.h"

#include <stdbool.h>

/* True when the extension of the path is one that jlt_picture_draw knows: .svg, .png, .pdf. */
bool jlt_picture_known(const char *path);

/** Draw a picture; its format follows the extension of `path`.
 *  In: script, gnuplot commands without terminal and output, data in `$NAME << EOD` blocks; keep, a path under which the
 *      whole script is kept as well (with the terminal), or NULL.
 *  The file is written whole or not at all, as by jlt_file_write.
 *  Out: refused, on IO the file that cannot be written, with errno; NULL when gnuplot failed, and said why on standard error.
 *  Errors: ARG (another extension), UNSUPPORTED (no gnuplot to be found), IO, NOMEM.
 *  Cost: a process, about 0.1 s. */
JLT_CHECKED jlt_status jlt_picture_draw(const char *path, const char *script, const char *keep,
                                        const char **refused);

#endif
