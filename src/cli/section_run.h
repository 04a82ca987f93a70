/** A run of `jellett section`: what its options ask for, how its orbits are followed, and the table of their returns. */
#ifndef JLT_CLI_SECTION_RUN_H
#define JLT_CLI_SECTION_RUN_H

#include "cli/motion_many.h"
#include "cli/progress.h"
#include "cli/section_picture.h"
#include "cli/section_table.h"
#include "cli/writer.h"

typedef struct {
    jlt_motion_options motion;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX]; /* of the grid */
    size_t returns, skip;
    int time_direction;
    bool check;
    bool project;
} jlt_section_run_options;

/* Counts for the closing words. */
typedef struct {
    size_t orbits, empty, rows, invalid, unknown;
    jlt_failures failures;
    size_t lost[JLT_OBSERVED_CONDITIONS_MAX]; /* of the invalid: by condition, the one that is lost most */
} jlt_section_run_totals;

/* A batch that several runs have in common. */
typedef struct jlt_section_run_company jlt_section_run_company;

/** Orbits are followed by the section, or many at once by the batch. Zeroed, with options and system set, before
 *  jlt_section_run_open. */
typedef struct {
    const jlt_section_run_options *o;
    jlt_system *system;
    jlt_section_picture *picture;

    /* private */
    jlt_section_run_totals sum;
    jlt_section_table table;
    jlt_writer writer; /* of the table */
    jlt_section_row *row;
    jlt_map *map;      /* of --check */
    jlt_section *section;
    jlt_section_batch *batch; /* NULL: one at a time */
    jlt_section_batch_options batch_options;
    jlt_section_run_company *company; /* the batch is its, and has followed the orbits; NULL: it is the run's own */
    double *joined;           /* starts of a run that may go with others, (all starts, dim); NULL: it goes by itself */
    size_t begins;            /* number of the first orbit in the batch */
    jlt_progress progress;
    size_t returns, all;      /* of each orbit, if it does not end; of all orbits, 0: endless */
    size_t first;             /* number of the first return that is shown */
    size_t before;            /* returns of the blocks before */
    size_t block;             /* returns of the block that is being followed */
    bool cut;                 /* an interrupt came before the batch was done: its rows are written, for half a second */
    double cut_at;
} jlt_section_run;

/** Whether orbits are followed together: many, an orbit put back onto integrals of a section that tables describe as well, which
 *  lanes can, and one of a sweep, which the other points' go beside. */
bool jlt_section_run_is_of_many(const jlt_section_run_options *options);

/** Whatever orbits are followed with, and what lets them go with those of other runs. Says what is wrong. */
jlt_exit jlt_section_run_open(jlt_section_run *self);
void jlt_section_run_close(jlt_section_run *self); /* legal on a zeroed one */

/** Of runs that were opened, whether they have orbits enough to fill lanes and threads; and follow those of all that may go
 *  together. Where that fails, jlt_section_run_write follows them again, and says why. */
bool jlt_section_run_are_enough(jlt_section_run *const *runs, size_t count);
void jlt_section_run_follow(jlt_section_run *const *runs, size_t count);

/** Follow the orbits, unless that is done, and write the table to the stream of the options, with its header. Says what is
 *  wrong. */
jlt_exit jlt_section_run_write(jlt_section_run *self);

/** What is said when the table is saved, and the status that its rows call for. */
jlt_exit jlt_section_run_verdict(const jlt_section_run *self);

#endif
