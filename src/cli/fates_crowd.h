/** Follows orbits of several systems on the same section together in one batch, and counts for each system how its orbits end. */
#ifndef JLT_CLI_FATES_CROWD_H
#define JLT_CLI_FATES_CROWD_H

#include "cli/motion_many.h"
#include "cli/motion_map.h"
#include "cli/progress.h"
#include "cli/section_levels.h"
#include "dynamics/shares.h"

enum { JLT_FATES_CROWD_VALUES_MAX = 8 };

/** A system, and the counts of its starts so far. */
typedef struct {
    jlt_system *system; /* NULL: the levels have no state, so there are no starts */
    double values[JLT_FATES_CROWD_VALUES_MAX]; /* those given to jlt_fates_crowd_follow */
    jlt_shares sum;
    size_t flow;        /* the number of its flow in the batch */
    jlt_section_levels levels;
} jlt_fates_crowd_place;

/** The caller sets the members before the private ones, and zeroes those. */
typedef struct {
    const jlt_motion_options *motion;
    size_t returns;
    FILE *rows;          /* gets a row for every start; NULL: starts are only counted */
    jlt_motion_map *map; /* NULL: there is no picture */
    jlt_progress *progress;
    size_t whole;        /* how many systems there will be */
    /* Called for each system, in order, when all its starts are counted; the system is destroyed after the call. NULL: there is
     * only one system, which stays the caller's; its counts are complete when jlt_fates_crowd_finish returns. */
    void (*done)(void *context, const jlt_fates_crowd_place *place);
    void *context;

    /* private */
    size_t strayed;      /* orbits on which an integral changes by more than errors of returns explain */
    char farthest[512];  /* the one on which it changes most, in words; with `done` one of them */
    jlt_fates_crowd_place *places; /* systems under way; starts are being added for the last one */
    size_t place_count, place_room;
    jlt_section_batch *batch;      /* of the systems that have starts in the block; NULL: none has */
    double *q;                     /* starts of the block, (count, dim) */
    size_t *place_of, *index, *flow_of; /* (count,), of each start: its place, its number in its system, its flow */
    size_t count, room, each, followed; /* starts in the block and at most; of the last system; followed so far */
} jlt_fates_crowd;

/** The grid of starts: --grid as typed, or, without --grid and --start, the default grid where tables describe the section, or
 *  NULL. */
const char *jlt_fates_crowd_grid(const jlt_motion_options *motion, const jlt_system *system);

/** Add a system with the same section as those before, or NULL where the levels have no state, and values (count,) for `done`. Its
 *  starts are followed whenever a block is full. With `done`, the crowd owns the system. Prints errors. */
jlt_exit jlt_fates_crowd_follow(jlt_fates_crowd *self, jlt_system *system, const double *values, size_t count);

/** Follow the starts that are still waiting. After an interrupt only orbits that were followed to their end are counted, and `done`
 *  is not called again. */
jlt_exit jlt_fates_crowd_finish(jlt_fates_crowd *self);

/** The counts of the last system. */
const jlt_shares *jlt_fates_crowd_sum(const jlt_fates_crowd *self);

/** If orbits, of `starts` in all, change an integral by more than errors of returns explain, say so. Legal after close. */
void jlt_fates_crowd_tell(const jlt_fates_crowd *self, size_t starts);
void jlt_fates_crowd_close(jlt_fates_crowd *self);

#endif
