/** The command `jellett eigen`, shared by its files: what was asked, and one row of results. */
#ifndef JLT_CLI_EIGEN_H
#define JLT_CLI_EIGEN_H

#include "cli/common.h"
#include "cli/grid.h"
#include "spectrum/equilibrium.h"

enum { JLT_EIGEN_AXES_MAX = 8 };

/* What an axis of a sweep runs over. */
typedef struct {
    bool is_state;
    size_t index; /* of the state or parameter */
} jlt_eigen_target;

typedef struct {
    jlt_common common;
    bool json, csv;
    jlt_assign_list at;
    jlt_grid_axis axes[JLT_EIGEN_AXES_MAX];
    jlt_eigen_target targets[JLT_EIGEN_AXES_MAX]; /* of the axes */
    size_t axis_count, points; /* of the sweep */
    size_t processes;          /* of the sweep; 0: as many as processors */
    jlt_equilibrium_question question;
    double *params; /* shape (params,) */
    double x[JLT_LINEARIZATION_SIZE_MAX];
} jlt_eigen_request;

typedef struct {
    const jlt_descriptor *descriptor;
    double *params, *x; /* borrowed */
    jlt_equilibrium found;
} jlt_eigen_row;

/* Rows, one after another in memory. Rows of a table are cut off after their eigenvalues: it shows nothing behind. */
typedef struct {
    const char *first;
    size_t stride, count; /* stride: bytes from a row to the next */
} jlt_eigen_rows;

static inline const jlt_eigen_row *jlt_eigen_row_at(jlt_eigen_rows rows, size_t k)
{
    return (const void *)(rows.first + k * rows.stride);
}

/* Add the axes NAME=LOW:HIGH:COUNT,... of --sweep to the request; compute and write a row for each of their points. */
jlt_exit jlt_eigen_parse_sweep(jlt_eigen_request *request, const char *text);
jlt_exit jlt_eigen_sweep(const jlt_eigen_request *request);

/* Writers. */
enum { JLT_EIGEN_REASON_MAX = 256 };
void jlt_eigen_reason(char *text, const jlt_eigen_row *row); /* why a row was refused; text: shape (JLT_EIGEN_REASON_MAX,) */
void jlt_eigen_write_text(FILE *stream, const jlt_eigen_row *row);
JLT_CHECKED jlt_status jlt_eigen_write_json(FILE *stream, jlt_eigen_rows rows, bool array);
void jlt_eigen_write_csv(FILE *stream, const jlt_eigen_request *request, jlt_eigen_rows rows);
jlt_exit jlt_eigen_draw(const jlt_eigen_request *request, jlt_eigen_rows rows);

#endif
