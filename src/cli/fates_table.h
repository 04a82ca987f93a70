/** Writes the rows of `jellett fates`, which tell how orbits of a section end. */
#ifndef JLT_CLI_FATES_TABLE_H
#define JLT_CLI_FATES_TABLE_H

#include "cli/motion.h"
#include "dynamics/shares.h"

/** A row for every orbit: the coordinates of its start, fate, t_end, quantities at the end, with --contact report the least
 *  value of the model's conditions. Angles are within half a period of 0. */
void jlt_fates_table_names(FILE *file, const jlt_motion_options *options, const jlt_system *system);
void jlt_fates_table_row(FILE *file, const jlt_motion_options *options, const jlt_system *system, const double *q, const jlt_fates_end *end);

/** A row for every point of a sweep over `axes` (count,): the values, numbers of starts by fate, and shares. A point of a
 *  picture beside it: the first value, a share, its error, and a second share; NULL: none. base: any system of the sweep. */
void jlt_fates_table_share_names(FILE *file, const jlt_system *base, const jlt_grid_axis *axes, size_t count);
void jlt_fates_table_shares(FILE *file, FILE *points, const jlt_system *base, const double *values, size_t count,
                            const jlt_shares *sum);

/** One line of numbers by fate, and what else is to be known of them. */
void jlt_fates_table_summary(FILE *stream, const jlt_motion_options *options, const jlt_system *system, const jlt_shares *sum);

#endif
