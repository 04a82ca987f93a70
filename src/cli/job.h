/** An entry of a scene as the command line that it stands for. */
#ifndef JLT_CLI_JOB_H
#define JLT_CLI_JOB_H

#include "cli/assign.h"
#include "scene/scene.h"

/** The commands of this program that have a parser, and models as commands open them. */
extern const jlt_scene_program jlt_job_program;

/** A scene of these. Says what is wrong. */
jlt_exit jlt_job_open(jlt_scene **scene, const char *path);

/** Give parameters of a scene's commands other values: --set. Says what is wrong. */
jlt_exit jlt_job_set(jlt_scene *scene, const jlt_assign_list *set);

/** As it would be typed, argv[0] for the command's name, with one more option behind where that is not NULL; for jlt_command_free. NULL: no
 *  memory. */
char **jlt_job_arguments(const jlt_scene_job *job, const char *more, int *argc);

/** Run it in a process of its own, so that whatever ends it leaves others alone. *ending: the signal that is to end this program, else 0.
 *  Returns the command's exit status. */
jlt_exit jlt_job_run(int *ending, const jlt_command *command, char **argv, int argc);

#endif
