/** Scene files: what a run asks for, in libconfig's syntax, checked to the last key.
 *
 *      title = "Poincare map of (5.1)";
 *      model = "./pendulum.tt";
 *      parameters = { g = 9.81; l = "1/3"; };
 *      accuracy = { tolerance = 1e-12; };
 *      compute = ( { what = "section"; section = { phase = 0; }; modulo = { phase = "2*pi"; };
 *                    grid = { angle = (-3, 3, 25); rate = (-0.9, 0.9, 19); };
 *                    returns = 300; output = "map.csv"; plot = "map.svg"; } );
 *
 *  A study, which `jellett sweep` deals out, has `over = { l = (1, 2, 11); };` as well: parameters and levels that run, and
 *  `piece`, how many points of its command's grid are computed at a stretch.
 *
 *  Each entry of `compute` asks for one command; its keys are the options of that command, under the same names but for
 *  parameters (--set), levels (--level) and tolerance (--tol). `parameters`, `levels` and `accuracy` of the whole file are
 *  shared by all entries that know them. Numbers are read exactly; those that decimal notation
 *  cannot give exactly ("1/3") are written as strings. Whatever is unknown, missing, twice given or of the wrong kind is an
 *  error with its line; nothing is ignored. */
#ifndef JLT_SCENE_SCENE_H
#define JLT_SCENE_SCENE_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

enum { JLT_SCENE_MESSAGE_MAX = 1024 };

typedef struct {
    char *name;     /* of the option, without dashes */
    char *value;    /* as it is typed on a command line; NULL for a flag */
    unsigned line;  /* where it stands in the file */
    bool is_file;   /* that the command writes */
} jlt_scene_option;

typedef struct {
    char *what;     /* name of the command */
    const struct argp *known; /* the options that the command has */
    char *model;    /* its operand MODEL; NULL when the scene names none */
    jlt_scene_option *options; /* (count,): those that are given */
    size_t count;
    unsigned line;  /* where the entry begins in the file */
} jlt_scene_job;

typedef struct {
    char *file, *title;
    char *over;     /* of a study, NAME=LOW:HIGH:COUNT,...; NULL: nothing runs beside the command's own grid */
    unsigned over_line;
    size_t piece;   /* points of the command's grid that are computed at a stretch; 0: not said */
    const struct jlt_descriptor *model; /* the general field of the scene's model */
    jlt_scene_job *jobs; /* (count,): entries of `compute` */
    size_t count;
} jlt_scene;

/** What a scene can ask for, and of what. */
typedef struct {
    /** Command number `index`, with the options that argp knows; NULL beyond the last. */
    const char *(*command)(const struct argp **options, size_t index);
    /** The general field of the model of this name. Errors: EMPTY, there is none; others have been told, and end the reading
     *  with an empty message. */
    jlt_status (*open)(const struct jlt_descriptor **out, const char *model);
} jlt_scene_program;

/** Read and check. message, shape (JLT_SCENE_MESSAGE_MAX,): on failure "FILE:LINE: error: ...", a whole line without the
 *  newline, or "" where `open` has told it. Errors: IO (a file that cannot be read), ARG (a bad scene), NOMEM. */
JLT_CHECKED jlt_status jlt_scene_read(jlt_scene **out, char *message, const char *path,
                                      const jlt_scene_program *program);
void jlt_scene_destroy(jlt_scene *scene); /* NULL is legal */

/** Give a parameter another value, as it is typed on a command line, in all jobs that the scene's parameters apply to.
 *  Errors: ARG, the scene's model has no such parameter, or no job takes any; NOMEM, the scene is then only to be destroyed. */
JLT_CHECKED jlt_status jlt_scene_set(jlt_scene *scene, const char *name, const char *value);

/** Value of an option of a job; NULL when it is not given. */
const char *jlt_scene_value(const jlt_scene_job *job, const char *name);

#endif
