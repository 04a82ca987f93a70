/** Writes the rows of `jellett fates`, which tell how orbits of a section end. */
#ifndef JLT_CLI_FATES_TABLE_H
#define JLT_CLI_FATES_TABLE_H

#include "cli/motion.h"
#include "dynamics/shares.h"

/** Write the names of the columns, and the row of the orbit that began at q (dim,): coordinates of its start, fate, t_end,
 *  quantities at its end, with --contact report the least of the model's conditions; angles lie within half a period of 0. */
void jlt_fates_table_names(FILE *file, const jlt_motion_options *options, const jlt_system *system);
void jlt_fates_table_row(FILE *file, const jlt_motion_options *options, const jlt_system *system, const double *q,
                         const jlt_fates_end *end);

/** Write the names of the columns of a sweep over `axes`, shape (count,), and the row of one of its points: values, shape (count,),
 *  numbers of starts by fate, and shares. points: takes a line of the picture's data, the first value, a share, its error, a second
 *  share; NULL: there is no picture. base: any system of the sweep. */
void jlt_fates_table_share_names(FILE *file, const jlt_system *base, const jlt_grid_axis *axes, size_t count);
void jlt_fates_table_shares(FILE *file, FILE *points, const jlt_system *base, const double *values, size_t count,
                            const jlt_shares *sum);

/** Write one line for readers: how many starts have each fate, and how many of them lose a condition of the model. */
void jlt_fates_table_summary(FILE *stream, const jlt_motion_options *options, const jlt_system *system, const jlt_shares *sum);

#endif
