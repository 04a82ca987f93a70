/** A study: a scene with one command, whose work is cut into pieces. A piece is the scene's command line for one point of the grid
 *  `over`, and for a part of the command's own grid. */
#ifndef JLT_CLI_STUDY_H
#define JLT_CLI_STUDY_H

#include "cli/assign.h"
#include "cli/grid.h"
#include "cli/job.h"

enum { JLT_STUDY_OVER_MAX = 16 };

typedef struct {
    jlt_scene *scene;
    const jlt_scene_job *job;
    const jlt_command *command;
    jlt_grid_axis over[JLT_STUDY_OVER_MAX]; /* what the study runs over, the last one fastest */
    size_t over_count;
    size_t outer;         /* how many points `over` has; 1 where the study runs over nothing */
    size_t inner;         /* how many points the command's grid has; 1 if it is not cut into parts */
    size_t dealt;         /* index of the job's option that gives this grid; job->count: none */
    size_t piece, pieces; /* points of the command's grid in a piece; number of pieces */
    char *manifest;       /* JSON of everything that determines the rows; it is the same in all shards of a study */
} jlt_study;

/** Read a scene, and set parameters to the values of `set`. Call jlt_study_clear in the end, whatever is returned. */
jlt_exit jlt_study_open(jlt_study *out, const char *path, const jlt_assign_list *set);
/** The same of a scene that is read, which jlt_study_clear then destroys. */
jlt_exit jlt_study_make(jlt_study *out, jlt_scene *scene, const jlt_assign_list *set);
void jlt_study_clear(jlt_study *self);

/** Add to a command line, of *argc arguments, the options that give it point number `point` of what a study runs over; over: shape
 *  (count,). Returns false if memory is out; *argc counts what was added before. */
bool jlt_study_give(char ***argv, int *argc, const jlt_grid_axis *over, size_t count, size_t point, const jlt_descriptor *model);

/** The command line of piece number `piece`, *argc arguments, for jlt_command_free. NULL: memory is out. */
char **jlt_study_arguments(const jlt_study *self, size_t piece, int *argc);

/** Say in words where a piece lies, for messages: "rho=24, points 64 to 127 of the grid". place: shape (JLT_GRID_PLACE_MAX,). */
void jlt_study_place(char *place, const jlt_study *self, size_t piece);

#endif
