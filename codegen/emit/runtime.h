/** The files that emitted code includes, the same for all models. The build embeds those in codegen/runtime/, byte for byte, in
 *  the table below (tools/cmake/Embed.cmake), so that ttc is one file that needs no others. */
#ifndef TTC_RUNTIME_H
#define TTC_RUNTIME_H

#include <stddef.h>

typedef struct {
    const char *name; /* of the file, without a folder */
    const char *text;
} ttc_runtime_file;

extern const ttc_runtime_file ttc_runtime_files[]; /* in the order of names */
extern const size_t ttc_runtime_file_count;

#endif
