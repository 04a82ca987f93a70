/** The command `jellett eigen`, shared by its files: what was asked, and one row of results. */
#ifndef JLT_CLI_EIGEN_H
#define JLT_CLI_EIGEN_H

#include "analysis/linearization.h"
#include "cli/common.h"
#include "cli/grid.h"
#include "cli/oracle.h"

enum { JLT_EIGEN_AXES_MAX = 8 };

/* What an axis of a sweep runs over. */
typedef struct {
    bool is_state;
    size_t index; /* of the state or parameter */
} jlt_eigen_target;

typedef struct {
    jlt_common common;
    bool json, csv, find;
    jlt_assign_list at;
    jlt_grid_axis axes[JLT_EIGEN_AXES_MAX];
    jlt_eigen_target targets[JLT_EIGEN_AXES_MAX]; /* of the axes */
    size_t axis_count;
    const jlt_descriptor *descriptor; /* general field */
    double *params;                   /* shape (params,) */
    double x[JLT_LINEARIZATION_SIZE_MAX];
    unsigned char given[JLT_LINEARIZATION_SIZE_MAX];
    size_t order[JLT_LINEARIZATION_SIZE_MAX], held; /* the states given, as typed */
    jlt_oracle *oracle;
} jlt_eigen_request;

typedef struct {
    const jlt_eigen_request *request;
    double *params, *x;                /* borrowed, or owned by a sweep */
    jlt_status status;                /* EMPTY: no equilibrium; then only the residual is there */
    char reason[160];                 /* "" when the status is JLT_OK */
    jlt_linearization result;
} jlt_eigen_row;

/* One point: completed, found when asked, checked, reported. `x` and `params` are changed in place. */
void jlt_eigen_compute(jlt_eigen_row *row, const jlt_eigen_request *request, double *params, double *x,
                       const unsigned char *given);

/* Put what ball arithmetic makes of the exact values into the row's report, which is untouched where it settles nothing. */
JLT_CHECKED jlt_status jlt_eigen_enclose(jlt_eigen_row *row);

/* NAME=LOW:HIGH:COUNT,... added to the request's axes. */
jlt_exit jlt_eigen_parse_sweep(jlt_eigen_request *request, const char *text);
jlt_exit jlt_eigen_sweep(const jlt_eigen_request *request);
void jlt_eigen_clear(jlt_eigen_request *request);

/* Writers. */
void jlt_eigen_write_text(FILE *stream, const jlt_eigen_row *row);
JLT_CHECKED jlt_status jlt_eigen_write_json(FILE *stream, const jlt_eigen_row *rows, size_t count, bool array);
void jlt_eigen_write_csv_header(FILE *stream, const jlt_eigen_request *request);
void jlt_eigen_write_csv_row(FILE *stream, const jlt_eigen_row *row);
jlt_exit jlt_eigen_draw(const jlt_eigen_request *request, const jlt_eigen_row *rows, size_t count);

#endif
