/** The C compiler, run on generated files. */
#ifndef TTC_COMPILE_H
#define TTC_COMPILE_H

#include "base/text.h"

/** The compiler that $CC names, else cc, looked up in $PATH; for the caller to free. NULL: there is none, or memory is out. */
char *ttc_compiler_find(void);

/** The options that decide on what is compiled, each followed by a blank. lanes: as below. */
void ttc_compiler_add_flags(ttc_text *text, unsigned lanes);

/** Compile the .c files of `folder` and of its subfolders, as many at once as there are processors, and link them to the shared
 *  object `target`. lanes: 2, 4 or 8: kernels on vectors of so many numbers as well, for the instruction set that has them; 0:
 *  none. The compiler's words go to stderr; no shell sees any name. False: it failed, and they say why. */
bool ttc_compile_folder(const char *compiler, const char *folder, unsigned lanes, const char *target);

#endif
