/** What the commands about motion on a section have in common: options, the system they name, headers, messages. */
#ifndef JLT_CLI_MOTION_H
#define JLT_CLI_MOTION_H

#include "cli/common.h"
#include "cli/grid.h"
#include "cli/plot.h"
#include "cli/stream.h"
#include "dynamics/surface.h"

typedef struct {
    jlt_common common;
    jlt_accuracy accuracy; /* refers to flow */
    const char *section; /* STATE=VALUE, or the name of one that a table says; with the former: */
    const char *mirror;  /* states whose sign the reversor changes */
    const char *solve;   /* STATE=GUESS,... of levels */
    const char *modulo;  /* STATE=PERIOD,... of angles */
    jlt_assign_list level;
    jlt_flow flow;
    const char *contact; /* ignore (default), report, end */
    size_t threads;      /* of many orbits; these as in motion_many.h */
    bool project;        /* orbits are put back onto their integrals */
    bool many;           /* lanes are wanted for orbits */
    bool in_lanes;       /* many orbits go at once, by a method that --tol chooses */
    const char *alone;   /* why they do not; NULL: that was not asked for, or they do */
    bool looks_at_integrals; /* the command asks for those that hold at these parameters alone as well */
    bool is_random;      /* points are drawn, from: */
    size_t seed;
    const jlt_grid_axis *swept; /* parameters and levels that run over the rows, of which headers say nothing */
    size_t swept_count;
    const char **starts; /* where orbits begin: (start_count,), as typed, owned; of a command of one, NULL first: none given */
    size_t start_count;
    char start[512];     /* the one by default, which is then the first, and not counted */
    const char *grid;    /* as typed; NULL: */
    const char *other;   /* where there are no starts either and tables describe the section; NULL: none */
} jlt_motion_options;

/* Child parser, the options of common.h with it; its input is a jlt_motion_options. */
extern const struct argp jlt_motion_argp;

/* Beside it, with the same input, where a command looks at contact. */
extern const struct argp jlt_contact_argp;

/** To be called before argp_parse, with its argv; the options must not move after that. Installs the
 *  handler of Ctrl-C. Ends the program where memory is out. */
void jlt_motion_begin(jlt_motion_options *options, int argc, char **argv);
void jlt_motion_end(jlt_motion_options *options);

/** The system that the options describe. Says what is wrong. Where only its plan is asked for, that is shown: JLT_EXIT_PLANNED. */
jlt_exit jlt_motion_system(jlt_system **system, jlt_motion_options *options);

/** What its levels are solved for, behind them in the header. */
void jlt_motion_plane_solved(FILE *stream, const jlt_system *system);

/** Project orbits on a section of any table back onto its integrals after every step. Says what stands against it. */
jlt_exit jlt_motion_project(jlt_system *system);

/** Whether tables describe the section, and say where all of it lies in this coordinate. */
bool jlt_motion_framed(const jlt_system *system, unsigned coordinate);

/** The coordinates that a picture shows: those of --axes, else the first two; of a section of one, that one twice. */
jlt_exit jlt_motion_shown(unsigned shown[2], const jlt_motion_options *options, const jlt_system *system);

/** An axis of a picture, 'x' or 'y', for this range of a coordinate: of an angle the whole period where it is more than half of it.
 *  WHOLE: the section, or where that is not known, and nothing is to be seen, some range. Returns what it is, after --xrange and
 *  --yrange. */
#define JLT_MOTION_WHOLE ((jlt_extent){ -INFINITY, INFINITY })
jlt_extent jlt_motion_axis(jlt_plot *plot, const jlt_system *system, char axis, unsigned coordinate, jlt_extent range);

/** While options are parsed: the one start of a command that takes no more. */
void jlt_motion_one_start(jlt_motion_options *options, const char *text);

/** The start that the section's table has for the purpose, where none was given. Says that one is wanted: "say near which orbit to
 *  begin". */
jlt_exit jlt_motion_default_start(jlt_motion_options *options, const jlt_system *system, jlt_surface_start purpose,
                                  const char *wanted);

/** Name of the method that orbits are followed with: in lanes it is chosen by the tolerance; "each" where all are asked. */
const char *jlt_motion_method(const jlt_motion_options *options);

/** Names and values of the levels that the section lies on, shape (JLT_INVARIANTS_MAX,). Returns how many. */
unsigned jlt_motion_levels(const jlt_system *system, const char **names, double *values);

/** One start, NAME=VALUE,... for all coordinates of the section. */
jlt_exit jlt_motion_start(double *q, const jlt_system *system, const char *text);

/** Whether an orbit can begin at each of these starts, before anything is written. Says what is wrong. */
jlt_exit jlt_motion_check_starts(const jlt_system *system, const char *const *starts, size_t count);

/** Axes of a grid over the section: as in `text`, by default angles over their period, and bounded coordinates of a section that
 *  tables describe over the interval of its levels. Of other sections every coordinate has to be named, or be an angle where only
 *  counts are typed. */
jlt_exit jlt_motion_axes(jlt_grid_axis *axes, const jlt_system *system, const char *text, const char *option);

/** Point number `index` of those of the grid that are meant (the first coordinate runs fastest), or their number. */
void jlt_motion_grid_point(double *q, const jlt_grid_axis *axes, const jlt_system *system, size_t index);
size_t jlt_motion_grid_size(const jlt_grid_axis *axes, const jlt_system *system);

/** Number `index` of all starts: those as typed, then those of a grid. */
jlt_exit jlt_motion_any_start(double *q, const jlt_motion_options *options, const jlt_grid_axis *axes, const jlt_system *system,
                              size_t index);

/** Comment lines: command, kernels, parameters, levels, section, method, tolerance. */
void jlt_motion_header(FILE *stream, const jlt_motion_options *options, const jlt_system *system);

/* For captions: parameters and levels, but for the one that is swept, if any. */
void jlt_motion_caption(jlt_plot *plot, const jlt_system *system, const char *swept);

/** "WHAT: reason", with the exit status that the library's status calls for. */
jlt_exit jlt_motion_fail(jlt_status status, const jlt_system *system, const char *what);

/** The section that tables describe, and that the options ask for; *has: there is one. Says why it is not one of this table any
 *  more. */
jlt_exit jlt_motion_surface(jlt_surface *surface, bool *has, const jlt_motion_options *options, const jlt_descriptor *asked);

/** Its system, with the parameters and levels of the options. Says what is wrong. */
jlt_exit jlt_motion_surface_system(jlt_system **system, const jlt_motion_options *options, const jlt_surface *surface);

/** A start that lies at the end of a coordinate's interval or beyond, or whose orbit ends before it returns. */
jlt_exit jlt_motion_refuse_point(const jlt_system *system, const char *what);

/** Why none could be made from these values, shape (surface->count,); what: NULL for what speaks for itself. */
jlt_exit jlt_motion_refuse(const jlt_surface *surface, const double *values, jlt_status status, const char *what);

/** The same for Newton's method, which finds no periodic orbit from `start`. */
jlt_exit jlt_motion_no_orbit(jlt_status status, const jlt_system *system, const char *start);

/** Says that the method failed on so many of the orbits, whose rows tell how; the status of that. */
jlt_exit jlt_motion_failures(size_t failed, size_t orbits);

bool jlt_motion_interrupted(const jlt_motion_options *options);

#endif
