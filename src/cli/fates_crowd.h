/** Follows the starts of systems, many at once whichever of them they belong to, and counts how their orbits end. */
#ifndef JLT_CLI_FATES_CROWD_H
#define JLT_CLI_FATES_CROWD_H

#include "cli/motion_many.h"
#include "cli/motion_map.h"
#include "cli/progress.h"
#include "dynamics/shares.h"

enum { JLT_FATES_CROWD_VALUES_MAX = 8 };

/** A system, and what became of its starts so far. */
typedef struct {
    jlt_system *system; /* NULL: no state is there, and there are no starts */
    double values[JLT_FATES_CROWD_VALUES_MAX]; /* as given */
    jlt_shares sum;
    size_t flow;        /* its number in the batch */
} jlt_fates_crowd_place;

/** The first members are to be set, the others zero. */
typedef struct {
    const jlt_motion_options *motion;
    size_t returns;
    FILE *rows;          /* gets a row for every start; NULL: they are only counted */
    jlt_motion_map *map; /* NULL: there is no picture */
    jlt_progress *progress;
    size_t whole;        /* how many systems there will be */
    /* Called when all starts of a system are counted, in the order of systems, which are destroyed then. NULL: there is one, which
     * is the caller's, and is counted when jlt_fates_crowd_finish returns. */
    void (*done)(void *context, const jlt_fates_crowd_place *place);
    void *context;

    /* private */
    jlt_fates_crowd_place *places; /* under way; the last one takes starts */
    size_t place_count, place_room;
    jlt_section_batch *batch;      /* of those that have starts in the block; NULL: none has */
    double *q;                     /* starts of the block, (count, dim) */
    size_t *place_of, *index, *flow_of; /* (count,): of these, and their number among those of their system */
    size_t count, room, each, followed; /* each: starts of the last system */
} jlt_fates_crowd;

/** The grid of starts, as typed or as the section has it; NULL: none. */
const char *jlt_fates_crowd_grid(const jlt_motion_options *motion, const jlt_system *system);

/** Add a system, of the same section as those before, with values (count,) to remember, and follow its starts, or keep them until
 *  more have come. Says what is wrong. */
jlt_exit jlt_fates_crowd_follow(jlt_fates_crowd *self, jlt_system *system, const double *values, size_t count);

/** Follow the starts that were kept. After an interrupt those of whole orbits are counted, and systems with others are not done. */
jlt_exit jlt_fates_crowd_finish(jlt_fates_crowd *self);

/** Of the last system. */
const jlt_shares *jlt_fates_crowd_sum(const jlt_fates_crowd *self);
void jlt_fates_crowd_close(jlt_fates_crowd *self);

#endif
