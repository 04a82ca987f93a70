/** The table of a sweep, under one header: the rows of every point, each with the values of that point in front; and its
 *  picture. */
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
    unsigned lead;      /* columns that only number the rows; a picture shows the next one where --axes says nothing */
    jlt_grid_axis axes[JLT_SWEPT_AXES_MAX];
    size_t count;

    /* private */
    char *header;      /* comments of the first point, then those that the second has as well */
    char *names;       /* columns of the first point's rows, which are those of the table; NULL: no point has had rows */
    char *held;        /* what the first point wrote, while the second is not there */
    size_t held_point;
    char *odd;         /* column names of the last point whose names were others than these */
    unsigned shown[2]; /* columns of the picture, x and y */
    bool has_numbers[2], has_points; /* of those columns, in rows so far; rows in which both have */
    jlt_extent extent[2];            /* of the latter, where has_points */
} jlt_swept_rows;

/** What the command wrote at a point: comments, names of columns, rows; "" is nothing. Comments of this point alone stay with
 *  its rows. Columns that the first point had not are left out, and those that this one has not are empty; says so. */
jlt_exit jlt_swept_rows_take(jlt_swept_rows *self, size_t point, const char *text);

/** After all points. */
jlt_exit jlt_swept_rows_finish(jlt_swept_rows *self);

/** Draw one column over another, when the table is saved. */
jlt_exit jlt_swept_rows_draw(const jlt_swept_rows *self);

void jlt_swept_rows_clear(jlt_swept_rows *self);

#endif
