/** The C compiler, run on generated files. */
#ifndef TTC_COMPILE_H
#define TTC_COMPILE_H

#include "base/text.h"

/** The compiler that $CC names, else cc, looked up in $PATH; for the caller to free. NULL: there is none, or memory is out. */
char *ttc_compiler_find(void);

/** The options that decide on what is compiled, each followed by a blank. */
void ttc_compiler_add_flags(ttc_text *text, bool lanes);

/** Compile the .c files of `folder` and of its subfolders, as many at once as there are processors, and link them to the shared
 *  object `target`. lanes: kernels on vectors as well, for each instruction set. The compiler's words go to stderr; no shell sees any name. False: it failed, and they say why. */
bool ttc_compile_folder(const char *compiler, const char *folder, bool lanes, const char *target);

#endif
