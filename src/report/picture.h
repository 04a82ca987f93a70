/** Draws pictures by gnuplot. */
#ifndef JLT_REPORT_PICTURE_H
#define JLT_REPORT_PICTURE_H

#include "core/status.h"
#include "report/look.h"

/* Whether the path's ending is one of pictures, in capitals too; and whether jlt_picture_terminal knows it: .svg, .png, .pdf. */
bool jlt_picture_is_named(const char *path);
bool jlt_picture_known(const char *path);

/* Whether such a picture is drawn in fonts of this machine: not .svg, whose letters the viewer draws. */
bool jlt_picture_has_fonts(const char *path);

/** Write the first lines of a script: the terminal for this look and the extension of `path`, for which jlt_picture_known is
 *  true. */
void jlt_picture_terminal(FILE *stream, const char *path, const jlt_look *look);

/** Run gnuplot on a script. In: whole, `length` bytes, without `set output`. Out: *picture, `*size` bytes, for the caller to
 *  free(). Errors: UNSUPPORTED (gnuplot is not found), EMPTY (there are no data, or none within the ranges of the axes), IO
 *  (gnuplot failed: errno is 0 if what it said is passed on to standard error, else it says why), NOMEM. Cost: a process, about
 *  0.1 s. */
JLT_CHECKED jlt_status jlt_picture_draw(char **picture, size_t *size, const char *whole, size_t length);

#endif
