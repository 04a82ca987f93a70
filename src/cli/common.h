/** Options that most commands share: the model and its parameters, accuracy, files for results, the picture. */
#ifndef JLT_CLI_COMMON_H
#define JLT_CLI_COMMON_H

#include <argp.h>

#include "cli/assign.h"
#include "cli/stream.h"
#include "integrate/method.h"
#include "report/look.h"

/* The option by which `jellett plan COMMAND ...` makes a command print its plan and do nothing else. */
#define JLT_COMMON_PLAN JLT_COMMAND_HIDDEN "plan"

typedef struct {
    const char *model; /* NULL: none was named, which means JLT_DEFAULT_MODEL */
    jlt_assign_list set; /* parameters, --set */
    const char *output, *plot, *keep;
    const char *axes;  /* of the picture, as typed; NULL: none were named */
    jlt_look look;     /* of the picture */
    bool lanes;        /* compile the user's own table with kernels on vectors as well */
    const char *sweep; /* --sweep as typed; NULL: not given, or the command does its sweep by itself */
    const char *own_sweep; /* as typed, of a command that does its sweep by itself; NULL: not given */
    bool at_point;     /* this process computes one point of the sweep: its values are set, and rows go to standard output, without
                          files or pictures */
    bool plan;         /* print which model answers, and do nothing else: jellett plan COMMAND ... */
    char *command;     /* the command line as typed; owned */
    char **argv;       /* its arguments, (argc,), in the order typed; the array is owned, the strings are not */
    int argc;

    /* set by jlt_common_write */
    jlt_stream table;  /* rows for --output go here */
    FILE *points;      /* data of the picture go here; NULL: no picture is asked for, or jlt_common_save has closed it */
    char *drawn;       /* the data written to `points`, valid after jlt_common_save; owned */
    size_t drawn_size;
} jlt_common;

/* Where --tol and --method store their values; the caller stores the defaults there first. */
typedef struct {
    double *tolerance;
    const jlt_method **method;
} jlt_accuracy;

/* Child parsers for commands: the first reads MODEL, --set, --output, --plot, --keep and the look of pictures into a jlt_common,
 * which is its input; the second, of a command that writes a certificate, does not know --plot, --keep and the look; the third
 * reads --tol and --method into a jlt_accuracy. */
extern const struct argp jlt_common_argp, jlt_common_certificate_argp, jlt_accuracy_argp;

/** Call it at ARGP_KEY_END of a command whose result is not a table but `what` ("a report"): it ends the program with status 2 if
 *  --output names a NumPy array, which can hold only a table. */
void jlt_common_no_table(const jlt_common *self, const struct argp_state *state, const char *what);

/** Call it at ARGP_KEY_END where the command line leaves out what the command cannot do without: it ends the program with `words`
 *  and status 2, or as jlt_common_model does if there is no such model. */
void jlt_common_incomplete(const jlt_common *self, const struct argp_state *state, const char *words);

/** Call it at ARGP_KEY_INIT: it passes the parser's own input to all children. That input is a structure whose first member, or the
 *  first member of that, is the jlt_common. Returns 0. */
error_t jlt_common_inputs(struct argp_state *state, const struct argp_child *children);

/** Set defaults, and keep the command line for headers of files. Call it before ttc_options_parse, with the same argv; call _end
 *  last. */
void jlt_common_begin(jlt_common *self, int argc, char **argv);
void jlt_common_end(jlt_common *self);

/** Open the model: *descriptor is its general field, which lives as long as the program. Prints claims that are not proved. */
jlt_exit jlt_common_model(const jlt_common *self, const jlt_descriptor **descriptor);

/** The same with parameters: *params, shape (param_count,), in the table's units, inside its domain; the caller frees them. */
jlt_exit jlt_common_open(const jlt_common *self, const jlt_descriptor **descriptor, double **params);

/** The exact values of the parameters, "p/q", as typed, else those of `defaults`, shape (param_count,), which an oracle has. The
 *  caller frees the array; its strings are those of self and of `defaults`. NULL: memory is out. */
const char **jlt_common_exact(const jlt_common *self, const jlt_descriptor *descriptor, char *const *defaults);

/** A copy of params, shape (param_count,), for the header of a table, with NaN for those that change from row to row in a sweep.
 *  The caller frees it. NULL: memory is out. */
double *jlt_common_steady(const jlt_common *self, const jlt_descriptor *descriptor, const double *params);

/** Whether this process computes a point of a sweep that changes the parameter or level of this name. */
bool jlt_common_runs(const jlt_common *self, const char *name);

/** Check that --project can put orbits of this field back onto levels of its integrals: it has some, at most JLT_INVARIANTS_MAX,
 *  and all are proved. */
jlt_exit jlt_common_project(const jlt_descriptor *field);

/** Check only that all integrals of the field are proved. */
jlt_exit jlt_common_proved(const jlt_descriptor *field);

/** Check that --project serves with this method; NULL: the default. */
jlt_exit jlt_common_one_step(const jlt_method *method);

/** Print that the kernels of a table do not serve this method; NULL: the default. Returns JLT_EXIT_INPUT. */
jlt_exit jlt_common_no_kernels(const jlt_descriptor *field, const jlt_method *method);

/** Open self->table for rows and, with --plot, self->points for data of the picture. */
jlt_exit jlt_common_write(jlt_common *self);

/** Close both: the table's file is renamed to its path, and the picture's data are in self->drawn. */
jlt_exit jlt_common_save(jlt_common *self);

/** Print the plan of a command that integrates nothing. Returns JLT_EXIT_PLANNED. */
jlt_exit jlt_common_still(void);

/** Check that none of these assignments, given by `option`, names what the sweep runs over; if one does, end with status 2. */
void jlt_common_not_swept(const jlt_common *self, const jlt_assign_list *list, const char *option);

/** Check, before anything is computed, that --output, --plot, --keep and one more option (path NULL: not given) name different
 *  files that can be written. Prints what is wrong and ends the program otherwise, as argp does. */
void jlt_common_check_files(const jlt_common *self, const char *option, const char *path);

/* Read the value of an option; if it cannot be used, print why and end the program, as argp does. _list adds assignments to the
 * list, _replace puts those of --sweep in place of the list's for the same names; _count reads a whole number from low to high,
 * _number any finite number, _positive one that is > 0. */
void jlt_common_list(jlt_assign_list *list, const char *text, const char *option);
void jlt_common_replace(jlt_assign_list *list, const char *text);
void jlt_common_count(size_t *value, const char *text, size_t low, size_t high, const char *option);
void jlt_common_number(double *value, const char *text, const char *option);
void jlt_common_positive(double *value, const char *text, const char *option);

/* The default number of threads: OMP_NUM_THREADS, else the number of processors that the program may use. For commands whose output
 * does not depend on the number of threads. */
size_t jlt_common_processors(void);

#endif
