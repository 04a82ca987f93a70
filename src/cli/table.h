/** Opens the model that a command line names: a built-in one, or the user's own table. */
#ifndef JLT_CLI_TABLE_H
#define JLT_CLI_TABLE_H

#include "cli/command.h"
#include "kernel/way.h"

/** Whether a path ends as that of a table, in .tt. */
bool jlt_table_is_named(const char *path);

/** Whether this is the path of a table, with a slash or ending in .tt, and not the name of a built-in model. */
bool jlt_table_is_file(const char *model);

/** Open a model: *descriptor is its general field. ttc reads, proves and compiles a user's own table, unless its kernels are in the
 *  cache, and prints what is wrong with it. lanes: also make kernels on vectors, which take longer to compile. *has_said: ttc wrote
 *  messages, among them the claims that are not proved, so that the caller need not. A process that has opened a table, and its
 *  children, keep using the text read then, or refuse with JLT_EXIT_IO if new kernels are needed and the file was edited. */
jlt_exit jlt_table_open(const jlt_descriptor **descriptor, bool *has_said, const char *model, bool lanes);

/** Open the tables to which the user's own table leads by proved records, unless they are built in: each is read, proved and
 *  compiled like that table, and which claims are not proved is printed. of: the table's field; model, lanes: as for
 *  jlt_table_open. kind: "reduction", by reductions, also by those `onto` a table without a condition; NULL: by ways,
 *  `reduction NAME : by` and `lift`. Out: *others, empty if `model` is built in. */
jlt_exit jlt_table_others(jlt_way_tables *others, const jlt_descriptor *of, const char *model, const char *kind, bool lanes);

/** Open a model for a scene, and those tables beside it that reductions lead to; serves as jlt_scene_program.open. Errors: EMPTY,
 *  there is no built-in model of this name; IO, ARG, NOMEM, a table cannot be used, and the reason has been printed. */
jlt_status jlt_table_of(const jlt_descriptor **out, jlt_way_tables *others, const char *model);

#endif
