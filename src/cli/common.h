/** What most commands share: the model with its parameters, accuracy, where results go; options, and the picture. */
#ifndef JLT_CLI_COMMON_H
#define JLT_CLI_COMMON_H

#include <argp.h>

#include "cli/assign.h"
#include "cli/stream.h"
#include "integrate/method.h"
#include "report/look.h"

/* The option by which a command says its plan alone. */
#define JLT_COMMON_PLAN JLT_COMMAND_HIDDEN "plan"

typedef struct {
    const char *model; /* NULL: none was named, which means JLT_DEFAULT_MODEL */
    jlt_assign_list set;
    const char *output, *plot, *keep;
    const char *axes;  /* of the picture, as typed; NULL: none were named */
    jlt_look look;     /* of the picture */
    bool lanes;        /* kernels on vectors are wanted */
    bool no_table;     /* results are never a table */
    const char *sweep; /* what runs, as typed; NULL: nothing does, or the command has a sweep of its own */
    bool at_point;     /* of it: parameters and levels have been set, and rows alone are wanted, on standard output */
    bool plan;         /* say which model answers, and do nothing more: jellett plan COMMAND ... */
    char *command;     /* as typed, owned */
    char **argv;       /* the same, (argc,), in its order; owned, but not the texts */
    int argc;

    /* after jlt_common_write */
    jlt_stream table;  /* --output */
    FILE *points;      /* to write data of the picture to; NULL: none is asked for, or all are there */
    char *drawn;       /* and what was written, after jlt_common_save; owned */
    size_t drawn_size;
} jlt_common;

/* What --tol and --method set; in begin, they have their defaults. */
typedef struct {
    double *tolerance;
    const jlt_method **method;
} jlt_accuracy;

/* Child parsers: MODEL, --set, --output, --plot, --keep, and the look of pictures with a jlt_common for input; --tol, --method with a jlt_accuracy. */
extern const struct argp jlt_common_argp, jlt_accuracy_argp;

/** At ARGP_KEY_END, where results are no table but `what`: refuse to write them as an array. */
void jlt_common_no_table(const jlt_common *self, const struct argp_state *state, const char *what);

/** At ARGP_KEY_INIT of options that begin with those of their children, which all begin with a jlt_common: 0. */
error_t jlt_common_inputs(struct argp_state *state, const struct argp_child *children);

/** To be called before argp_parse, with its argv. */
void jlt_common_begin(jlt_common *self, int argc, char **argv);
void jlt_common_end(jlt_common *self);

/** The model's general field. Says what is wrong, and what is not proved of it. */
jlt_exit jlt_common_model(const jlt_common *self, const jlt_descriptor **descriptor);

/** The model's general field and its parameters, checked; params for the caller to free(). Says what is wrong. */
jlt_exit jlt_common_open(const jlt_common *self, const jlt_descriptor **descriptor, double **params);

/** Parameters for a header: NaN where one runs. For the caller to free(); NULL: no memory. */
double *jlt_common_steady(const jlt_common *self, const jlt_descriptor *descriptor, const double *params);

/** Whether a parameter or level of this name runs. */
bool jlt_common_runs(const jlt_common *self, const char *name);

/** Whether --project can go back to the integrals of this field: that there are some, not too many, and all proved. Says what is wrong. */
jlt_exit jlt_common_project(const jlt_descriptor *field);

/** The last of these alone. */
jlt_exit jlt_common_proved(const jlt_descriptor *field);

/** Before rows are written: where they go, and data of a picture. Says what is wrong. */
jlt_exit jlt_common_write(jlt_common *self);

/** Rows and data are there. Says what is wrong. */
jlt_exit jlt_common_save(jlt_common *self);

/** The plan of a command that follows no motion. */
jlt_exit jlt_common_still(void);

/** Before anything is done: that --output, --plot, --keep and one more option, where it is given, name files of their own, which
 *  can be written. Ends the program otherwise, as argp does. */
void jlt_common_check_files(const jlt_common *self, const char *option, const char *path);

/* Values of options. Where they cannot be used, these say so and end the program, as argp does. */
void jlt_common_list(jlt_assign_list *list, const char *text, const char *option);
void jlt_common_replace(jlt_assign_list *list, const char *text, const char *option); /* of what the list has for the same names */
void jlt_common_count(size_t *value, const char *text, size_t low, size_t high, const char *option);
void jlt_common_number(double *value, const char *text, const char *option);
void jlt_common_positive(double *value, const char *text, const char *option);

/* Processors that the program may use, or as many as OMP_NUM_THREADS says: threads of commands whose output does not depend on how
 * many. */
size_t jlt_common_processors(void);

#endif
