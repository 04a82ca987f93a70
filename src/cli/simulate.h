/** The command `jellett simulate`, shared by its files: what was asked for, and its picture. */
#ifndef JLT_CLI_SIMULATE_H
#define JLT_CLI_SIMULATE_H

#include "cli/session.h"
#include "cli/simulate_times.h"

enum { JLT_SIMULATE_COURSES_MAX = 9 };

typedef struct {
    jlt_session session;
    const char *times_text, *until_text, *every_text, *tier, *compare; /* options as typed; NULL: not given */
    double until, every; /* times, in the table's unit; NaN: not given */
    bool track, project;

    jlt_simulate_times times;
    size_t rows;
    jlt_plan plans[JLT_SIMULATE_COURSES_MAX]; /* the orbit's own first, then those of --compare */
    jlt_course *courses[JLT_SIMULATE_COURSES_MAX];
    jlt_status broken[JLT_SIMULATE_COURSES_MAX]; /* why a course of --compare stopped; OK: it goes on */
    size_t course_count;
    jlt_course_row last;

    jlt_extent *extents;         /* of the picture's columns */
    double *points;              /* rows of the picture, shape (held, columns); owned, as `extents` is */
    size_t held, spacing;        /* of the table's rows the picture has number 0, spacing, 2 spacing, ..., and the orbit's end */
    unsigned shown[2];           /* the columns that --axes names */
} jlt_simulate_request;

/** Read --axes into `shown`; without them, check that the panels of the states have room. */
jlt_exit jlt_simulate_axes(jlt_simulate_request *request);

/* Add a row, number `rows`, to the picture's data. ends: there are no more. */
void jlt_simulate_point(jlt_simulate_request *request, const jlt_course_row *row, bool ends);

/** Draw what was collected. */
jlt_exit jlt_simulate_draw(const jlt_simulate_request *request);

/** Say on standard error how the orbit ended, where its tier changed, which conditions broke, which integrals have no column. */
void jlt_simulate_closing_words(const jlt_simulate_request *request);

#endif
