/** The table of a sweep, the rows of all points under one header, each with the values of its point in front; and its picture. */
#ifndef JLT_CLI_SWEPT_ROWS_H
#define JLT_CLI_SWEPT_ROWS_H

#include "cli/common.h"
#include "cli/grid.h"

enum { JLT_SWEPT_AXES_MAX = 8 };

/* The caller sets the first six members. */
typedef struct {
    jlt_common *common; /* whose table is written to */
    const jlt_descriptor *model;
    const char *what;   /* the command's name, for messages */
    unsigned lead;      /* how many leading columns only number the rows; without --axes a picture shows the column after them */
    jlt_grid_axis axes[JLT_SWEPT_AXES_MAX];
    size_t count;

    /* private */
    char *header;      /* comment lines of the first point; from the second point on, those that both have */
    char *names;       /* column names of the first point, which become the table's; NULL: no point has had rows */
    char *held;        /* the first point's text, kept until the second point's has come */
    size_t held_point; /* number of that point */
    char *odd;         /* column names of the last point that had others than `names` */
    unsigned shown[2]; /* columns of the picture, x and y */
    bool has_numbers[2], has_points; /* whether a row so far has a number in these columns; in both */
    jlt_extent extent[2];            /* of the rows with numbers in both, if has_points */
} jlt_swept_rows;

/** Take what the command wrote at a point: comments, column names, rows; text without column names is ignored. Comments that are
 *  not in the header stay with the rows. Columns that the first point lacks are left out, and those that this point lacks are
 *  empty; a message says so. */
jlt_exit jlt_swept_rows_take(jlt_swept_rows *self, size_t point, const char *text);

/** Write what is still held, after all points. */
jlt_exit jlt_swept_rows_finish(jlt_swept_rows *self);

/** Draw one column over another, when the table is saved. */
jlt_exit jlt_swept_rows_draw(const jlt_swept_rows *self);

void jlt_swept_rows_clear(jlt_swept_rows *self);

#endif
