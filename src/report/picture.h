/** Draws pictures by gnuplot. */
#ifndef JLT_REPORT_PICTURE_H
#define JLT_REPORT_PICTURE_H

#include "core/status.h"
#include "report/look.h"

/* True when the extension of the path is one that jlt_picture_draw knows: .svg, .png, .pdf. */
bool jlt_picture_known(const char *path);

/** Write the first lines of a script: the terminal that the look and the extension of `path`, which must be known, ask for. */
void jlt_picture_terminal(FILE *stream, const char *path, const jlt_look *look);

/** Draw a picture by gnuplot. In: whole, a script of `length` bytes, which sets no output. Out: *picture, `*size` bytes, for the
 *  caller to free(). Errors: UNSUPPORTED (no gnuplot to be found), EMPTY (nothing lies within the ranges of the axes, or
 *  there is nothing at all), IO (gnuplot failed, and said why on standard error), NOMEM.
 *  Cost: a process, about 0.1 s. */
JLT_CHECKED jlt_status jlt_picture_draw(char **picture, size_t *size, const char *whole, size_t length);

#endif
