/** Reads the text of a scene file, and refuses what libconfig would silently misread. */
#ifndef JLT_SCENE_SOURCE_H
#define JLT_SCENE_SOURCE_H

#include "scene/value.h"

enum { JLT_SOURCE_MAX = 1 << 20 }; /* bytes of a scene */

/** Read the file r->file into one string, for the caller to free(). Refuses integers that overflow libconfig's type, numbers in
 *  other bases than ten, and @include, for whose lines errors would name this file. Errors: IO, ARG, both with the message;
 *  NOMEM. */
JLT_CHECKED jlt_status jlt_source_read(char **text, const jlt_value_reader *r);

#endif
