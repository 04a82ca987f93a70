/** Running the C compiler on generated files. */
#ifndef TTC_COMPILE_H
#define TTC_COMPILE_H

#include "base/text.h"

/** Path of the compiler that $CC names, else of cc, looked up in $PATH, for the caller to free. NULL: not found, or no memory. */
char *ttc_compiler_find(void);

/** Add the options that determine the object code, each followed by a blank. lanes: as below. */
void ttc_compiler_add_flags(ttc_text *text, unsigned lanes);

/** Compile the .c files of `folder` and of its subfolders, as many at once as there are processors, and link them to the shared
 *  object `target`. lanes: 2, 4 or 8 to include kernels on vectors of as many numbers, for the instruction set of that width; 0
 *  for none. The compiler's messages go to stderr; no shell interprets any name. Returns false if compiling or linking failed. */
bool ttc_compile_folder(const char *compiler, const char *folder, unsigned lanes, const char *target);

#endif
