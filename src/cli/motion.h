/** What the commands about orbits on a section have in common: options, the system that these describe, headers, messages.
 *  q: shape (dim,), coordinates of a point on the section, in the table's units, angles in radians; dim:
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
    jlt_accuracy accuracy; /* refers to flow */
    const char *section; /* STATE=VALUE, or the name of a section that a table describes; the next three go with STATE=VALUE: */
    const char *mirror;  /* STATE,...: whose signs the reversor changes */
    const char *solve;   /* STATE=GUESS,...: solved for on the levels of --level */
    const char *modulo;  /* STATE=PERIOD,...: angles */
    jlt_assign_list level;
    jlt_flow flow;
    const char *contact; /* ignore (default), report, end */
    size_t threads;      /* that follow orbits; the next four are set by motion_many.h */
    bool project;        /* --project: orbits are put back onto the levels of their integrals */
    bool many;           /* orbits are to be followed in lanes of vectors, several at once */
    bool in_lanes;       /* they are, by a method that --tol chooses */
    const char *alone;   /* why they are not, in words; NULL: they are, or it was not wanted */
    bool looks_at_integrals; /* the command also needs the integrals that hold only at these parameters */
    bool is_random;      /* points are drawn at random, from `seed` */
    size_t seed;
    const jlt_grid_axis *swept; /* (swept_count,): parameters and levels that change from row to row; headers leave them out */
    size_t swept_count;
    const char **starts; /* --start, (start_count,), as typed, owned; a command of one start reads starts[0], NULL: none given */
    size_t start_count;
    char start[512];     /* the default start, which starts[0] may point to; start_count does not count it */
    const char *grid;    /* --grid as typed; NULL: not given */
    const char *other;   /* the grid that is taken without --start and --grid where tables describe the section; NULL: none */
} jlt_motion_options;

/* The parser of these options and those of common.h, to be named as a child; its input is a jlt_motion_options. */
extern const struct argp jlt_motion_argp;

/* The parser of --contact, with the same input, for commands that look at the model's conditions. */
extern const struct argp jlt_contact_argp;

/** Set defaults and install the handler of Ctrl-C. Call it before argp_parse, with the same argv, and _end last; the options must
 *  not move in between. Ends the program where memory is out. */
void jlt_motion_begin(jlt_motion_options *options, int argc, char **argv);
void jlt_motion_end(jlt_motion_options *options);

/** Make the system that the options describe: table, parameters, levels, section. Out: *system, for jlt_system_destroy. Where only
 *  the plan was asked for, it is printed: JLT_EXIT_PLANNED. */
jlt_exit jlt_motion_system(jlt_system **system, jlt_motion_options *options);

/** Print, in the header behind the levels, which states they are solved for. */
void jlt_motion_plane_solved(FILE *stream, const jlt_system *system);

/** From now on put orbits of the system back onto the levels of its integrals after every step. JLT_EXIT_INPUT, JLT_EXIT_USAGE:
 *  they are not proved, there is none, or there are too many. */
jlt_exit jlt_motion_project(jlt_system *system);

/** Whether the range of this coordinate over the whole section is known: tables describe the section and bound it. */
bool jlt_motion_framed(const jlt_system *system, unsigned coordinate);

/** Choose which coordinates a picture shows, by number: those of --axes, else the first two; of a section of one coordinate this
 *  one twice. */
jlt_exit jlt_motion_shown(unsigned shown[2], const jlt_motion_options *options, const jlt_system *system);

/** Write the axis 'x' or 'y' of a picture for values of a coordinate in `range`. An angle gets its whole period where the values
 *  fill more than half of it. JLT_MOTION_WHOLE: the whole section, where its extent is known, else -1 to 1. Returns the range
 *  drawn, in which --xrange and --yrange win. */
#define JLT_MOTION_WHOLE ((jlt_extent){ -INFINITY, INFINITY })
jlt_extent jlt_motion_axis(jlt_plot *plot, const jlt_system *system, char axis, unsigned coordinate, jlt_extent range);

/** The label of an axis along which a parameter or level of the model runs, as by jlt_plot_label. */
void jlt_motion_label(char *label, const jlt_system *system, const char *name);

/** Keep --start of a command that takes one start, while options are parsed. */
void jlt_motion_one_start(jlt_motion_options *options, const char *text);

/** Where no start was given, take the one that the section's table has for this purpose. JLT_EXIT_USAGE: the table has none; the
 *  message ends with `wanted`: "say near which orbit to begin". */
jlt_exit jlt_motion_default_start(jlt_motion_options *options, const jlt_system *system, jlt_surface_start purpose,
                                  const char *wanted);

/** Name of the method that orbits are followed with, for messages and headers; in lanes the tolerance chooses it. */
const char *jlt_motion_method(const jlt_motion_options *options);

/** The levels of integrals that the section lies on. Out: names, values, shape (JLT_INVARIANTS_MAX,). Returns how many are
 *  filled. */
unsigned jlt_motion_levels(const jlt_system *system, const char **names, double *values);

/** Read one start, NAME=VALUE,... with a value for every coordinate of the section. Out: q, shape (dim,). */
jlt_exit jlt_motion_start(double *q, const jlt_system *system, const char *text);

/** Check, before anything is written, that an orbit can begin at each of these starts, shape (count,), as typed. */
jlt_exit jlt_motion_check_starts(const jlt_system *system, const char *const *starts, size_t count);

/** Read the axes of a grid over the section, shape (dim,), from `text`, the value of `option`. What it leaves out: an angle runs
 *  over its period, and a coordinate of a section that tables describe over the interval that the levels leave. On other sections
 *  every coordinate that is no angle has to be named. */
jlt_exit jlt_motion_axes(jlt_grid_axis *axes, const jlt_system *system, const char *text, const char *option);

/** The same for cells that cover these axes, low before high: all of an interval, where its ends are not typed. Refused: a part of
 *  a grid, an axis without width, and an angle that goes round more than once. */
jlt_exit jlt_motion_cells(jlt_grid_axis *axes, const jlt_system *system, const char *text, const char *option);

/** Point number `index` of the grid (the first coordinate runs fastest, unlike jlt_grid_point), and how many points there are. A
 *  grid of which a part was asked for, @FIRST:COUNT, counts the points of this part alone. */
void jlt_motion_grid_point(double *q, const jlt_grid_axis *axes, const jlt_system *system, size_t index);
size_t jlt_motion_grid_size(const jlt_grid_axis *axes, const jlt_system *system);

/** Refuses a grid none of whose points is on the levels. A part of a grid may be so. Cost: one lift for each until the first is. */
jlt_exit jlt_motion_check_grid(const jlt_grid_axis *axes, const jlt_system *system);

/** Start number `index` of all: first those of --start, then points of the grid. Out: q, shape (dim,). */
jlt_exit jlt_motion_any_start(double *q, const jlt_motion_options *options, const jlt_grid_axis *axes, const jlt_system *system,
                              size_t index);

/** Find the typical sizes of the section's coordinates (dynamics/scale.h), for commands that compare lengths on it: from one start
 *  q, shape (dim,), or from points all over a grid; axes: shape (dim,), NULL: q is given. */
jlt_exit jlt_motion_scale(jlt_system *system, const double *q, const jlt_grid_axis *axes);

/** Write the comment lines that a table begins with: command, kernels, parameters, levels, section, method, tolerance. */
void jlt_motion_header(FILE *stream, const jlt_motion_options *options, const jlt_system *system);

/* Write parameters and levels into the caption of a picture, without the one of the name `swept`; NULL: all. */
void jlt_motion_caption(jlt_plot *plot, const jlt_system *system, const char *swept);

/** Print "WHAT: reason". Returns the exit status that the library's status calls for. */
jlt_exit jlt_motion_fail(jlt_status status, const jlt_system *system, const char *what);

/** Find the section that tables describe and the options ask for, by its name or by none. Out: *surface, where *has is true; *has
 *  is false where --section STATE=VALUE asks for one of another kind, or tables describe none. Fails where a claim that the section
 *  rests on is not proved (any more) of the table asked. */
jlt_exit jlt_motion_surface(jlt_surface *surface, bool *has, const jlt_motion_options *options, const jlt_descriptor *asked);

/** Make the system on it, with the parameters and levels of the options. Out: *system, for jlt_system_destroy. */
jlt_exit jlt_motion_surface_system(jlt_system **system, const jlt_motion_options *options, const jlt_surface *surface);

/** Print that the start `what` lies at the end of a coordinate's interval or beyond, or that its orbit ends before it returns, with
 *  the intervals. Returns JLT_EXIT_INPUT. */
jlt_exit jlt_motion_refuse_point(const jlt_system *system, const char *what);

/** Print why jlt_surface_system returned `status` for these values of parameters and levels, shape (surface->count,). what: the
 *  option or point to name in front; NULL: none. Returns the exit status for it. */
jlt_exit jlt_motion_refuse(const jlt_surface *surface, const double *values, jlt_status status, const char *what);

/** Print that Newton's method found no periodic orbit from `start`, and what may help. Returns the exit status for `status`. */
jlt_exit jlt_motion_no_orbit(jlt_status status, const jlt_system *system, const char *start);

/** Print on how many of the orbits the method failed, and in how many of these a state grows without bound, unless there are none.
 *  Returns JLT_EXIT_NUMERICAL then, else JLT_EXIT_DONE. */
jlt_exit jlt_motion_failures(const jlt_system *system, const jlt_failures *failures, size_t orbits);

/** Whether a signal has asked the command to finish. */
bool jlt_motion_interrupted(const jlt_motion_options *options);

#endif
