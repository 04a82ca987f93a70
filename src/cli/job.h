/** Turns the entries of a scene into command lines, and runs them. */
#ifndef JLT_CLI_JOB_H
#define JLT_CLI_JOB_H

#include "cli/assign.h"
#include "scene/scene.h"

/** What scenes are checked against: the commands of this program that have a parser, and its models. */
extern const jlt_scene_program jlt_job_program;

/** Read a scene. Out: *scene, for jlt_scene_destroy. */
jlt_exit jlt_job_open(jlt_scene **scene, const char *path);

/** Give parameters of a scene's commands the values of `set`, from --set. */
jlt_exit jlt_job_set(jlt_scene *scene, const jlt_assign_list *set);

/** The command line of an entry, *argc arguments, for jlt_command_free: argv[0] is "jellett NAME"; `more`, unless NULL, is added as
 *  the last option. Returns NULL when memory is out. */
char **jlt_job_arguments(const jlt_scene_job *job, const char *more, int *argc);

/** Run a command line in a child process, so that a crash does not affect other entries. Out: *ending, the signal that asks this
 *  program to end, else 0. Returns the command's exit status, whose reason has been printed. */
jlt_exit jlt_job_run(int *ending, const jlt_command *command, char **argv, int argc);

#endif
