/** Scene files: what a run computes, in libconfig's syntax; every key is checked.
 *
 *      title = "Poincare map of (5.1)";
 *      model = "./pendulum.tt";
 *      parameters = { g = 9.81; l = "1/3"; };
 *      accuracy = { tolerance = 1e-12; };
 *      compute = ( { what = "section"; section = { phase = 0; }; modulo = { phase = "2*pi"; };
 *                    grid = { angle = (-3, 3, 25); rate = (-0.9, 0.9, 19); };
 *                    returns = 300; output = "map.csv"; plot = "map.svg"; } );
 *
 *  A study, which `jellett sweep` deals out, may also have `over = { l = (1, 2, 11); };`, parameters and levels that run, and
 *  `piece`, how many points of its command's grid make a piece.
 *
 *  Each entry of `compute` asks for one command. Its keys are the options of that command, under the same names except parameters
 *  (--set), levels (--level) and tolerance (--tol). The file's own `parameters`, `levels` and `accuracy` apply to all entries that
 *  have these options. Numbers are read exactly; those without an exact decimal are written as strings ("1/3"). Whatever is
 *  unknown, missing, given twice or of the wrong kind is an error with its line; nothing is ignored. */
#ifndef JLT_SCENE_SCENE_H
#define JLT_SCENE_SCENE_H

#include "core/status.h"
#include "kernel/way.h"

#include <stdbool.h>
#include <stddef.h>

enum { JLT_SCENE_MESSAGE_MAX = 1024 };

typedef struct {
    char *name;     /* of the option, without dashes */
    char *value;    /* as typed on a command line; NULL for a flag */
    unsigned line;  /* its line in the file */
    bool is_file;   /* the value is a file that the command writes */
} jlt_scene_option;

typedef struct {
    char *what;     /* name of the command */
    const struct argp *known; /* the options that the command has */
    char *model;    /* its operand MODEL; NULL when the scene names none */
    jlt_scene_option *options; /* (count,): those that the scene gives */
    size_t count;
    unsigned line;  /* the first line of the entry in the file */
} jlt_scene_job;

typedef struct {
    char *file, *title;
    char *over;     /* of a study, NAME=LOW:HIGH:COUNT,...; NULL: nothing runs besides the command's own grid */
    unsigned over_line;
    size_t piece;   /* points of the command's grid in a piece; 0: not given */
    const struct jlt_descriptor *model; /* the general field of the scene's model */
    jlt_scene_job *jobs; /* (count,): entries of `compute` */
    size_t count;
} jlt_scene;

/** The commands and models that a scene can ask for. */
typedef struct {
    /** The name of command number `index`, and its options; NULL beyond the last command. */
    const char *(*command)(const struct argp **options, size_t index);
    /** The general field of the model of this name, and the tables beside it in which its section may be. Errors: EMPTY, there is
     *  no such model; any other error was printed by the callback, and ends the reading with an empty message. */
    jlt_status (*open)(const struct jlt_descriptor **out, jlt_way_tables *others, const char *model);
} jlt_scene_program;

/** Read and check a scene. Out: message, shape (JLT_SCENE_MESSAGE_MAX,), on failure one line "FILE:LINE: error: ..." without the
 *  newline, or "" if `open` has printed the error. Errors: IO (the file cannot be read), ARG (a bad scene), NOMEM, those of
 *  `open`. */
JLT_CHECKED jlt_status jlt_scene_read(jlt_scene **out, char *message, const char *path,
                                      const jlt_scene_program *program);
void jlt_scene_destroy(jlt_scene *scene); /* NULL is legal */

/** Set a parameter to another value, as typed on a command line, in all jobs whose commands take parameters.
 *  Errors: ARG, the scene's model has no such parameter, or no job takes parameters; NOMEM, after which the scene may only be
 *  destroyed. */
JLT_CHECKED jlt_status jlt_scene_set(jlt_scene *scene, const char *name, const char *value);

/** The value of an option of a job; NULL if it is not given, or is a flag. */
const char *jlt_scene_value(const jlt_scene_job *job, const char *name);

#endif
