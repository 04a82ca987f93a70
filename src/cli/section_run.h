/** A run of `jellett section`: what its options ask for, how its orbits are followed, and the table of their returns. */
#ifndef JLT_CLI_SECTION_RUN_H
#define JLT_CLI_SECTION_RUN_H

#include "cli/motion_many.h"
#include "cli/progress.h"
#include "cli/section_levels.h"
#include "cli/section_picture.h"
#include "cli/section_table.h"
#include "cli/writer.h"
#include "dynamics/saddle.h"

typedef struct {
    jlt_motion_options motion;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX]; /* of the grid */
    size_t returns, skip;
    int time_direction;
    bool check;
    bool project;
} jlt_section_run_options;

/* Counts for the closing messages. empty: points of the grid without a state; invalid, unknown: orbits on which a condition of the
 * model breaks, or has no value; beside: orbits that pass too near by a saddle, the first of them by its number and return. */
typedef struct {
    size_t orbits, empty, rows, invalid, unknown, beside, first_beside, from_return;
    jlt_failures failures;
    size_t lost[JLT_OBSERVED_CONDITIONS_MAX]; /* of the invalid orbits, by condition: those on which it has the least value */
} jlt_section_run_totals;

/* A batch that several runs share. */
typedef struct jlt_section_run_company jlt_section_run_company;

/** One run. `section` follows its orbits one at a time, or `batch` many at once. Before jlt_section_run_open the caller sets the
 *  first three members and zeroes the others. */
typedef struct {
    const jlt_section_run_options *o;
    jlt_system *system;
    jlt_section_picture *picture;

    /* private */
    jlt_section_run_totals sum;
    jlt_section_levels levels;
    jlt_section_table table;
    jlt_writer writer; /* of the table */
    jlt_section_row *row;
    jlt_map *map;      /* for derivatives at saddles; NULL: not needed yet */
    jlt_section *section;
    jlt_section_batch *batch; /* NULL: one at a time */
    jlt_section_batch_options batch_options;
    jlt_section_run_company *company; /* shares `batch`, which has followed the orbits already; NULL: the batch is the run's own */
    double *joined;           /* starts, (all starts, dim), of a run that may share a batch; NULL: it may not */
    size_t begins;            /* number of the run's first orbit in the batch */
    jlt_progress progress;
    size_t returns, all;      /* of each orbit, if it does not end; of all orbits, 0: too many for the progress line */
    size_t first;             /* number of the first return that is shown */
    size_t before;            /* returns of the blocks before */
    size_t block;             /* returns of the block that is being followed */
    bool cut;                 /* an interrupt came before the batch was done: rows are still written for half a second */
    double cut_at;
} jlt_section_run;

/** Whether a batch follows the orbits: if there are several starts; if --project is given on a section that tables describe, where
 *  only lanes can put orbits back onto levels; and in a sweep, where orbits of several points share a batch. */
bool jlt_section_run_is_of_many(const jlt_section_run_options *options);

/** Create what follows the orbits, and read the starts of a run that may share a batch. Says what is wrong. */
jlt_exit jlt_section_run_open(jlt_section_run *self);
void jlt_section_run_close(jlt_section_run *self); /* legal on a zeroed one */

/** For opened runs, shape (count,): whether they have enough orbits to fill lanes and threads; and follow the orbits of those that
 *  may share a batch. On failure _follow is silent: jlt_section_run_write follows these orbits again, and says why. */
bool jlt_section_run_are_enough(jlt_section_run *const *runs, size_t count);
void jlt_section_run_follow(jlt_section_run *const *runs, size_t count);

/** Write the table with its header to the stream of the options, and follow the orbits first unless that is done. Says what is
 *  wrong. */
jlt_exit jlt_section_run_write(jlt_section_run *self);

/** Print the closing messages, after the table was saved. Returns the exit status that its rows call for. */
jlt_exit jlt_section_run_verdict(const jlt_section_run *self);

#endif
