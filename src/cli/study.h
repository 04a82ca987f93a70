/** A study: a scene with one command, whose rows are dealt out in pieces. A piece is a command line: the scene's, with values for
 *  what the study runs over, and a part of the command's own grid. */
#ifndef JLT_CLI_STUDY_H
#define JLT_CLI_STUDY_H

#include "cli/assign.h"
#include "cli/grid.h"
#include "cli/job.h"

enum { JLT_STUDY_OVER_MAX = 16, JLT_STUDY_PLACE_MAX = 512 };

typedef struct {
    jlt_scene *scene;
    const jlt_scene_job *job;
    const jlt_command *command;
    jlt_grid_axis over[JLT_STUDY_OVER_MAX]; /* what the study runs over, the last one fastest */
    size_t over_count;
    size_t outer, inner;  /* points of that, 1 where it is nothing; of the command's grid, 1 where it is not dealt out */
    size_t dealt;         /* which of the job's options has this grid; job->count: none */
    size_t piece, pieces; /* points of a piece; how many pieces */
    char *manifest;       /* all that decides what the rows are, in JSON */
} jlt_study;

/** Read a scene, and give parameters other values. Says what is wrong. *out is cleared after, whatever is returned. */
jlt_exit jlt_study_open(jlt_study *out, const char *path, const jlt_assign_list *set);
void jlt_study_clear(jlt_study *self);

/** The command line of a piece; for jlt_command_free. NULL: no memory. */
char **jlt_study_arguments(const jlt_study *self, size_t piece, int *argc);

/** Where it lies, for messages: "rho=24, points 64 to 127 of the grid". place: shape (JLT_STUDY_PLACE_MAX,). */
void jlt_study_place(char *place, const jlt_study *self, size_t piece);

/** Values of what a study runs over at one of its pieces, as text with commas between them and one behind each; shape
 *  (JLT_STUDY_PLACE_MAX,). axes: shape (count,). */
void jlt_study_values(char *text, const jlt_grid_axis *axes, size_t count, size_t point);

#endif
