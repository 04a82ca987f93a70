/** The model that a command line names: one that is built in, or a table of the user's own. */
#ifndef JLT_CLI_TABLE_H
#define JLT_CLI_TABLE_H

#include "cli/command.h"
#include "kernel/way.h"

/** Whether this names a table, by a slash or by ending in .tt, and not a model that is built in. */
bool jlt_table_is_file(const char *model);

/** The model's general field. A table is read, proved and compiled by ttc, unless its kernels are in the cache; lanes: with kernels on
 *  vectors, which take longer. Says what is wrong; ttc has said what is wrong with a table. *has_said: it has said also what is not
 *  proved, as it does when it compiles. */
jlt_exit jlt_table_open(const jlt_descriptor **descriptor, bool *has_said, const char *model, bool lanes);

/** Tables beside the user's own that proved ways lead to, and that are not built in: read, proved and compiled like it. model, lanes: as
 *  in jlt_table_open; none are looked for where the model is built in. kind: "reduction", those with fewer states alone; NULL: all.
 *  Out: *others. Says what is wrong. */
jlt_exit jlt_table_others(jlt_way_tables *others, const jlt_descriptor *of, const char *model, const char *kind, bool lanes);

/** As a scene opens its model. Errors: EMPTY, none of this name is built in; IO, ARG, NOMEM, a table that cannot be used, which has been told. */
jlt_status jlt_table_of(const jlt_descriptor **out, const char *model);

#endif
