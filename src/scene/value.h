/** Checks values of a scene file, and writes them as one would type them on a command line. */
#ifndef JLT_SCENE_VALUE_H
#define JLT_SCENE_VALUE_H

#include <libconfig.h>

#include "core/status.h"
#include "kernel/way.h"
#include "kernel_abi.h"
#include "scene/scene.h"
#include "scene/schema.h"

enum { JLT_VALUE_MAX = 4096 };

typedef struct {
    const char *file;
    char *message;               /* shape (JLT_SCENE_MESSAGE_MAX,) */
    const jlt_scene_program *program;
    const jlt_descriptor *model; /* gives the names of states and parameters, */
    jlt_way_tables others;       /* with the tables beside it, which may describe its section */
    const config_setting_t *section, *solve; /* the groups `section` and `solve` of the entry; section NULL: the section is one that
                                                tables describe, */
    const char *named;                       /* of this name; NULL: the first one */
} jlt_value_reader;

typedef struct {
    char text[JLT_VALUE_MAX];
    size_t used;
} jlt_value;

/** Write "FILE:LINE: error: ..." to the message, without LINE if line is 0. Always returns ARG. */
__attribute__((format(printf, 3, 4)))
jlt_status jlt_value_complain(const jlt_value_reader *r, int line, const char *format, ...);

/** The line of a setting in the file. */
int jlt_value_line(const config_setting_t *setting);

/** Append a setting's value in the form that the key's option takes. Errors: ARG, with the message. */
JLT_CHECKED jlt_status jlt_value_read(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v,
                                      const jlt_key *key);

#endif
