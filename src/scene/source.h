/** Checks the text of a scene file before libconfig reads it, for what libconfig would silently read as something else. */
#ifndef JLT_SCENE_SOURCE_H
#define JLT_SCENE_SOURCE_H

#include "scene/value.h"

enum { JLT_SOURCE_MAX = 1 << 20 }; /* bytes of a scene */

/** The file r->file as one string, for the caller to free(). Whole numbers that the type they are read into cannot hold are
 *  refused, and @include, whose lines would be told as this file's.
 *  Errors: IO, ARG, both with the message; NOMEM. */
JLT_CHECKED jlt_status jlt_source_read(char **text, const jlt_value_reader *r);

#endif
