/** What the commands about orbits on a section have in common: options, the system that they describe, headers, messages.
 *  Throughout, q, shape (dim,), are the coordinates of a point on the section, in the table's units, angles in radians, and dim is
 *  system->flow.chart->dim. */
#ifndef JLT_CLI_MOTION_H
#define JLT_CLI_MOTION_H

#include "cli/common.h"
#include "cli/grid.h"
#include "cli/plot.h"
#include "cli/stream.h"
#include "dynamics/failures.h"
#include "dynamics/surface.h"

typedef struct {
    jlt_common common;
    const jlt_descriptor *asked; /* the model, set by jlt_motion_system */
    jlt_accuracy accuracy; /* refers to flow */
    const char *section; /* STATE=VALUE, with which the next three go, or the name of a section that a table describes */
    const char *mirror;  /* STATE,...: the states whose signs the reversor changes */
    const char *solve;   /* STATE=GUESS,...: the states that are solved for on the levels of --level */
    const char *modulo;  /* STATE=PERIOD,...: the states that are angles */
    jlt_assign_list level;
    jlt_flow flow;
    const char *contact; /* ignore (default), report, end */
    size_t threads;      /* how many threads follow orbits; the functions of motion_many.h set the next four */
    bool project;        /* --project: orbits are put back onto the levels of their integrals */
    bool many;           /* orbits are to be followed in lanes of vectors, several at once */
    bool in_lanes;       /* lanes can follow them, by a method that --tol chooses */
    const char *alone;   /* why lanes cannot, in words; NULL: they can, or were not wanted */
    bool looks_at_integrals; /* the command also needs the integrals that hold only at these parameters */
    bool is_random;      /* the command draws random numbers, with `seed` */
    size_t seed;
    const jlt_grid_axis *swept; /* (swept_count,): parameters and levels that change from row to row; headers leave them out */
    size_t swept_count;
    const char **starts; /* --start, (start_count,), as typed, owned; a command of one start reads starts[0], NULL: none given */
    size_t start_count;
    char start[512];     /* the default start, which starts[0] may point to; start_count does not count it */
    const char *grid;    /* --grid as typed; NULL: not given */
    const char *other;   /* the default grid, without --start and --grid, on a section that tables describe; NULL: none */
} jlt_motion_options;

/* A child parser of these options and those of common.h; its input is a jlt_motion_options. */
extern const struct argp jlt_motion_argp, jlt_motion_certificate_argp; /* the latter without options of pictures */

/* A child parser of --contact, with the same input, for commands that look at the model's conditions. */
extern const struct argp jlt_contact_argp;

/** Set defaults and install the handler of Ctrl-C. Call it before ttc_options_parse, with the same argv, and _end last, with the
 *  options or a structure whose first member they are, as JLT_CLEARED does; they must not move in between. Ends the program where
 *  memory is out. */
void jlt_motion_begin(jlt_motion_options *options, int argc, char **argv);
void jlt_motion_end(void *place);

/** Make the system that the options describe: table, parameters, levels, section. Out: *system, for jlt_system_destroy. */
jlt_exit jlt_motion_system(jlt_system **system, jlt_motion_options *options);

/** Call it when all has been checked that can be without following an orbit, and before anything is written: if only the plan was
 *  asked for, prints it and returns JLT_EXIT_PLANNED. */
jlt_exit jlt_motion_plan(const jlt_system *system, const jlt_motion_options *options);

/** Have orbits of the system put back onto the levels of its integrals after every step. JLT_EXIT_INPUT, JLT_EXIT_USAGE: an
 *  integral is not proved, there is none, there are too many, or the method is a multistep method. */
jlt_exit jlt_motion_project(jlt_system *system);

/** Whether the range of this coordinate over the whole section is known: tables describe the section and bound it. */
bool jlt_motion_framed(const jlt_system *system, unsigned coordinate);

/** Choose which coordinates a picture shows. Out: shown, their indices: those of --axes, else the first two; on a section with one
 *  coordinate its index twice. */
jlt_exit jlt_motion_shown(unsigned shown[2], const jlt_motion_options *options, const jlt_system *system);

/** Write the axis 'x' or 'y' of a picture for values of a coordinate in `range`. An angle gets its whole period if the values fill
 *  more than half of it. JLT_MOTION_WHOLE means the whole section if its extent is known, else -1 to 1. Returns the range drawn:
 *  that of --xrange or --yrange if given. */
#define JLT_MOTION_WHOLE ((jlt_extent){ -INFINITY, INFINITY })
jlt_extent jlt_motion_axis(jlt_plot *plot, const jlt_system *system, char axis, unsigned coordinate, jlt_extent range);

/** The label of an axis along which a parameter or level of the model runs, as by jlt_plot_label. */
void jlt_motion_label(char *label, const jlt_system *system, const char *name);

/** Keep --start of a command that takes one start, while options are parsed. */
void jlt_motion_one_start(jlt_motion_options *options, const char *text);

/** If no start was given, take the one that the section's table has for this purpose. JLT_EXIT_USAGE: the table has none, and the
 *  message ends with `wanted`, such as "say near which orbit to begin". */
jlt_exit jlt_motion_default_start(jlt_motion_options *options, const jlt_system *system, jlt_surface_start purpose,
                                  const char *wanted);

/** The name of the method that follows orbits, for messages and headers; in lanes the tolerance chooses it. */
const char *jlt_motion_method(const jlt_motion_options *options);

/** The levels of integrals that the section lies on. Out: names, values, shape (JLT_INVARIANTS_MAX,). Returns how many are
 *  filled. */
unsigned jlt_motion_levels(const jlt_system *system, const char **names, double *values);

/** Refuse the name, shape (length,), in `option`, and print those of the section's coordinates. Returns JLT_EXIT_INPUT. */
jlt_exit jlt_motion_no_coordinate(const jlt_chart *chart, const char *option, const char *name, size_t length);

/** Read one start: NAME=VALUE,... with a value for every coordinate of the section, or the name of a start in its tables. Out: q,
 *  shape (dim,). */
jlt_exit jlt_motion_start(double *q, const jlt_system *system, const char *text);

/** Check, before anything is written, that an orbit can begin at each of these starts, shape (count,), as typed. */
jlt_exit jlt_motion_check_starts(const jlt_system *system, const char *const *starts, size_t count);

/** Exit with what is wrong in the text of a grid, whatever the section's coordinates are: before any table is compiled. */
void jlt_motion_typed(const char *grid, const char *option);

/** Read the axes of a grid over the section, shape (dim,), from `text`, the value of `option`. A COUNTxCOUNT grid covers, in each
 *  coordinate, the period of an angle, or the interval that the levels leave on a section that tables describe; on other sections
 *  coordinates that are not angles need NAME=LOW:HIGH:COUNT. A grid of NAME=... must name all coordinates. text NULL: all
 *  counts are 1. */
jlt_exit jlt_motion_axes(jlt_grid_axis *axes, const jlt_system *system, const char *text, const char *option);

/** jlt_motion_axes for cells that cover the axes, with low < high: the whole interval if its ends are not typed. Refuses a part of
 *  a grid, an axis without width, and an angle whose range is longer than its period. */
jlt_exit jlt_motion_cells(jlt_grid_axis *axes, const jlt_system *system, const char *text, const char *option);

/** Point number `index` of the grid (the first coordinate runs fastest, unlike jlt_grid_point); the number of points. If only a
 *  part of the grid was asked for, @FIRST:COUNT, both count the points of that part. */
void jlt_motion_grid_point(double *q, const jlt_grid_axis *axes, const jlt_system *system, size_t index);
size_t jlt_motion_grid_size(const jlt_grid_axis *axes, const jlt_system *system);

/** Refuse a grid none of whose points has a state on the levels; a part of a grid may be like that. Cost: one lift for each point
 *  up to the first that has a state. */
jlt_exit jlt_motion_check_grid(const jlt_grid_axis *axes, const jlt_system *system);

/** Start number `index` of all: first those of --start, then points of the grid. Out: q, shape (dim,). */
jlt_exit jlt_motion_any_start(double *q, const jlt_motion_options *options, const jlt_grid_axis *axes, const jlt_system *system,
                              size_t index);

/** Find the typical sizes of the section's coordinates (dynamics/scale.h), for commands that compare lengths on it: from the start
 *  q, shape (dim,), if axes is NULL, else from points spread over the grid of axes, shape (dim,). */
jlt_exit jlt_motion_scale(jlt_system *system, const double *q, const jlt_grid_axis *axes);

/** Write the comment lines that a table begins with: command, kernels, parameters, levels, section, method, tolerance. */
void jlt_motion_header(FILE *stream, const jlt_motion_options *options, const jlt_system *system);

/* Write parameters and levels into the caption of a picture, without the one named `swept`; NULL: all of them. */
void jlt_motion_caption(jlt_plot *plot, const jlt_system *system, const char *swept);

/** Print "WHAT: reason". Returns the exit status that the library's status calls for. */
jlt_exit jlt_motion_fail(jlt_status status, const jlt_system *system, const char *what);

/** The same where no system was made of a section STATE=VALUE. EMPTY: its levels do not determine what is solved for. */
jlt_exit jlt_motion_no_plane(jlt_status status, const char *what);

/** Find the section described by tables that the options ask for, by its name or by default. Out: *surface, if *has is true; *has
 *  is false if --section STATE=VALUE asks for a plane section, or tables describe none. Fails if the section rests on a claim that
 *  is not proved of the table asked for. */
jlt_exit jlt_motion_surface(jlt_surface *surface, bool *has, const jlt_motion_options *options, const jlt_descriptor *asked);

/** Make the system on that section, with the parameters and levels of the options. Out: *system, for jlt_system_destroy. */
jlt_exit jlt_motion_surface_system(jlt_system **system, const jlt_motion_options *options, const jlt_surface *surface);

/** Refuse the start `text`, q (coordinates,), if it lies at or beyond the end of a coordinate's interval. */
jlt_exit jlt_motion_refuse_point(const jlt_surface *surface, const double *q, const char *text);

/** Print why jlt_surface_system returned `status` for these values of parameters and levels, shape (surface->count,). what: the
 *  option or point to name in front; NULL: none. Returns the exit status for it. */
jlt_exit jlt_motion_refuse(const jlt_surface *surface, const double *values, jlt_status status, const char *what);

/** Print that Newton's method found no periodic orbit from `start`, and what may help. Returns the exit status for `status`. */
jlt_exit jlt_motion_no_orbit(jlt_status status, const jlt_system *system, const char *start);

/** Print "WHAT", which names what only a section with a reversor has, and what may help. Returns JLT_EXIT_INPUT. */
jlt_exit jlt_motion_no_reversor(const jlt_system *system, const char *what);

/** Print how many of the orbits ended by budget. If the method failed on some, print on how many, and in how many of these a state
 *  grows without bound, and return JLT_EXIT_NUMERICAL; else return JLT_EXIT_DONE. */
jlt_exit jlt_motion_failures(const jlt_system *system, const jlt_failures *failures, size_t orbits);

/** Whether a signal has asked the command to finish. */
bool jlt_motion_interrupted(const jlt_motion_options *options);

#endif
