/** The model that a command line names: one that is built in, or a table of the user's own. */
#ifndef JLT_CLI_TABLE_H
#define JLT_CLI_TABLE_H

#include "cli/command.h"
#include "kernel/way.h"

/** Whether this is the path of a table, with a slash or ending in .tt, and not the name of a model that is built in. */
bool jlt_table_is_file(const char *model);

/** Open a model: *descriptor is its general field. A table of the user's own is read, proved and compiled by ttc, unless its
 *  kernels are in the cache; lanes: also kernels on vectors, which take longer to compile. What is wrong with a table ttc prints.
 *  A process that has opened a table, and those that it forks, go on with what was read then, or refuse it with JLT_EXIT_IO where
 *  it was edited since. *has_said:
 *  ttc has compiled, and printed the claims that are not proved, so that the caller need not. */
jlt_exit jlt_table_open(const jlt_descriptor **descriptor, bool *has_said, const char *model, bool lanes);

/** Open the tables that the user's own table leads to by proved records, as `reduction` or `lift`, and that are not built in: they
 *  are read, proved and compiled as it is. of: that table's field; model, lanes: as for jlt_table_open. A model that is built in
 *  has none. kind: "reduction", only tables with fewer states; NULL: all.
 *  Out: *others. */
jlt_exit jlt_table_others(jlt_way_tables *others, const jlt_descriptor *of, const char *model, const char *kind, bool lanes);

/** Open a model for a scene, as jlt_scene_program.open. Errors: EMPTY, no model of this name is built in; IO, ARG, NOMEM, a table
 *  cannot be used, and why has been printed. */
jlt_status jlt_table_of(const jlt_descriptor **out, const char *model);

#endif
